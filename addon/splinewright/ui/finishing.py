"""Late followers are made when the mouse rests: beside Blender, one after the other, each after what it follows.

Inputs may change meanwhile: then the library ends its call, and the follower waits for the next rest.
"""

import functools
import math
from contextlib import contextmanager

import bpy

from ..bridge.data import versions
from ..bridge.data.file_state import block_of, ended_operators, key, state
from ..bridge.follow import follow, updating
from ..bridge.recipes import late
from ..core.base.words import phrase
from .operators.long_work import Work
from .ui_state import ui_state

#: The operator that listens to Esc meanwhile.
_OPERATOR = 'SPLINEWRIGHT_OT_update_late'


def is_released():
    """Whether nothing is dragged any more, as far as Blender tells."""
    if versions.knows_modal_operators:
        return not any(map(has_operators, bpy.context.window_manager.windows))
    return ended_operators() != state.put_off_by


def has_esc():
    """Whether Esc is no drag's, as far as Blender tells."""
    return is_released() or not versions.knows_modal_operators and late.rests_long()


def has_operators(window):
    """Whether other operators than the one that listens to Esc are under way in a window."""
    return any(operator.bl_idname != _OPERATOR for operator in window.modal_operators)


def redraw():
    """Views, with their sidebars, and properties."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in ('VIEW_3D', 'PROPERTIES'):
                area.tag_redraw()


@contextmanager
def unawaited():
    """Blender is asked to look for changes meanwhile, and nobody waits for the results."""
    before, ui_state.is_unawaited = ui_state.is_unawaited, True
    try:
        yield
    finally:
        ui_state.is_unawaited = before


class Finishing:
    """One go of making all that is late and due."""

    def __init__(self):
        self._work, self._queue, self._began = None, [], late.clock()

    def go_on(self, seconds):
        """Whether nothing is left to do now, after a number of seconds at most and what cannot be stopped. Results are shown."""
        with unawaited():
            return self._go_on(late.clock() + seconds)

    def _go_on(self, end):
        while self._work or self._begin_next():
            if not self._work.is_done(max(0.0, end - late.clock())):
                return False
            self._show()
            if late.clock() > end:
                break
        return not self._work and not self._due()

    def drop(self):
        """End the current work: it stays due."""
        if self._work:
            self._work.stop()

    def stop(self):
        """A user stops it: due shapes wait until somebody asks for them. Returns the names of those objects."""
        due = self._due()
        for data in due:
            late.stop(data, self._seconds() if self._work and key(data) == self._name else 0.0)
        self.drop()
        return [_called(key(data)) for data in due]

    def takes_long(self):
        """Whether the current work takes longer than a user waits without a word."""
        return self._work is not None and max(self._seconds(), self._expected()) > late.SLOW

    def sentence(self):
        """The current work in words."""
        expected = self._expected()
        about = phrase(" of about {expected:.0f} s", expected=expected) if expected > max(1.0, self._seconds()) else " s"
        more = len(self._due()) - 1
        return phrase("Updating {name}: {seconds:.0f}{about}",
                      name=_called(self._name), seconds=self._seconds(), about=about) + (phrase(", {more} more to come",
                                                                                         more=more) if more > 0 else "")

    def _seconds(self):
        return late.clock() - self._began

    def _expected(self):
        """The seconds that the work took before; 0 where that is not known."""
        data = block_of(self._name)
        expected = late.expected(data) if data is not None else 0.0
        return expected if expected < math.inf else 0.0

    @staticmethod
    def _due():
        due = late.waiting(is_released())
        if None in due:                 # one was renamed, or removed
            follow.finish(due, bpy.context.evaluated_depsgraph_get(), late.Budget())
            due = late.waiting(is_released())
        return follow.in_order(due)

    def _begin_next(self):
        """Whether work on a follower is under way; those of which nothing is to be made are done with."""
        self._queue = self._queue or [(key(data), state.late[key(data)]) for data in self._due()]
        while self._queue:
            name, delay = self._queue.pop(0)
            data = block_of(name)
            if data is not None and _is_wanted(name, delay) and self._begin(data, delay):
                return True
        return False

    def _begin(self, data, delay):
        graph = bpy.context.evaluated_depsgraph_get()
        try:
            task = updating.task_of(data, graph)
        except Exception:
            task = None                 # what is wrong is told where it is brought up to date
        if task is None:
            follow.finish([data], graph, late.Budget())
            return False
        self._made_of, make = task
        self._name, self._delay, self._began = key(data), delay, late.clock()
        work, is_wanted = timed(make), functools.partial(_is_wanted, self._name, delay)
        self._work = Work({self._name: lambda cancel: work(lambda: cancel() or not is_wanted())})
        return True

    def _show(self):
        work, self._work = self._work, None
        data = block_of(self._name)
        if data is not None and _is_wanted(self._name, self._delay):
            result, seconds = work.results[self._name]
            made = {self._name: updating.Made(self._made_of, result, seconds)}
            follow.finish([data], bpy.context.evaluated_depsgraph_get(), late.Budget(), made)


def _is_wanted(name, delay):
    """Whether the inputs of a late follower are still those of which work on it began."""
    return state.late.get(name) is delay


def timed(make):
    """make() that gives (what was made, or the exception that was raised; the seconds that it took)."""
    def measured(cancel):
        began = late.clock()
        try:
            result = make(cancel)
        except Exception as error:
            result = error
        return result, late.clock() - began
    return measured


def _called(name):
    """The name of the object that shows the data-block of a key."""
    owner = state.owners.get(name)
    return owner[1] if owner else name[1]
