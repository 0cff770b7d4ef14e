"""What other threads leave to the main one.

Blender renders from the window in a separate thread, which calls the handlers of frames while the main thread draws
from the same data-blocks. So geometry is written in the main thread alone, and the render waits meanwhile.
"""

import threading
import traceback

import bpy

from .ui_state import ui_state

#: Seconds that a thread waits. The main one takes as long only where it waits for that very thread.
_PATIENCE = 10.0
#: Seconds until errands are looked for again: usually, and while there are some.
_SELDOM, _OFTEN = 0.2, 0.01
#: Looks in a row that found none, after which an export is over.
_QUIET_LOOKS = 50


class Errand:
    """A function that one thread wants done in another."""

    def __init__(self, function):
        self._function, self._lock, self._done = function, threading.Lock(), threading.Event()
        self._is_dropped = False

    def run(self):
        with self._lock:
            if self._is_dropped:
                return
            try:
                self._function()
            except Exception:           # it must neither end the timer nor hold up the other thread
                traceback.print_exc()
            self._done.set()

    def wait(self, seconds):
        """Whether it was done in time; if not it never will be."""
        self._done.wait(seconds)
        with self._lock:
            self._is_dropped = True
            return self._done.is_set()


def is_main_thread():
    return threading.get_ident() == threading.main_thread().ident


def in_main_thread(function, scene):
    """Do it for the frame of a scene where nothing else is done with geometry meanwhile. Where the interface is locked that
    may be any thread, though panels that are drawn may forbid it to write."""
    frame = scene.frame_current, scene.frame_subframe
    if is_main_thread():
        ui_state.looks_left = min(ui_state.looks_left, 1)
        function()
    elif _is_hopeless(frame):
        return
    elif _is_done_in_main_thread(function):
        ui_state.served = frame
    elif scene.render.use_lock_interface:
        function()
    elif not scene.frame_subframe:
        ui_state.missed += 1


def _is_hopeless(frame):
    """EEVEE keeps the main thread from drawing while it looks at what lies between frames, for motion blur. That comes
    between two looks at the frame itself, the first of which finds the main thread free."""
    return ui_state.is_deaf and (frame[1] != 0.0 or frame == ui_state.served)


def _is_done_in_main_thread(function):
    errand = Errand(function)
    ui_state.errands.append(errand)
    is_done = errand.wait(_PATIENCE)
    ui_state.is_deaf |= not is_done
    return is_done


def serve(come_back):
    """Do what was left to the main thread; the seconds until this is to be called again.

    come_back: is called when renders and exports are over, after which shapes are as the last frame wanted them.
    """
    is_rendering = bpy.app.is_job_running('RENDER')
    if ui_state.errands or ui_state.is_deaf and is_rendering:
        ui_state.looks_left = _QUIET_LOOKS
    elif ui_state.looks_left and not is_rendering:
        ui_state.looks_left -= 1
        if not ui_state.looks_left:
            ui_state.is_deaf, ui_state.served = False, None
            come_back()
    while ui_state.errands:
        ui_state.errands.pop(0).run()
    return _OFTEN if is_rendering or ui_state.looks_left else _SELDOM


def is_away():
    """Whether shapes are as a render or an export wants them, not as the views do."""
    return ui_state.looks_left > 0
