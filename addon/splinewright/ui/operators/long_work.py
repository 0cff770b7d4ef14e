"""Work of the library that may take long: it is done beside Blender, which shows that it works and listens to Esc."""

import threading
import time

import bpy

from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from . import reports
from .gesture import Gesture

#: Seconds that a call waits for the work before it is shown to take long, and between two looks whether it is done.
_SHORT, _LOOK = 0.5, 0.05


class Work:
    """Tasks, functions of a `cancel` as the library takes it, by their keys, done one after the other on another thread."""

    def __init__(self, tasks):
        self.results, self._stopped = {}, threading.Event()
        self._tasks = tasks
        self._thread = threading.Thread(target=self._run, name="Splinewright")
        self._thread.start()

    def _run(self):
        for key, task in self._tasks.items():
            if self._stopped.is_set():
                return
            try:
                self.results[key] = task(self._stopped.is_set)
            except Exception as error:
                self.results[key] = error

    def is_done(self, seconds=0.0):
        """Whether all is done, within a given number of seconds."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def stop(self):
        """The library ends its call soon; its result is lost."""
        self._stopped.set()


class AtWork(Gesture):
    """A modal operator that works until it is done, which work_on() tells, or stopped by Esc."""

    cursor, called_off_by = 'WAIT', ('ESC',)
    #: Seconds between two calls of work_on().
    look = _LOOK

    def work_on(self, context):
        """What modal() returns now and again."""
        raise NotImplementedError("work_on: each operator says what it does")

    def lets_pass(self, event):
        return False

    def begin_modal(self, context):
        self._timer = context.window_manager.event_timer_add(self.look, window=context.window)
        return super().begin_modal(context)

    def step(self, context, event):
        return self.work_on(context) if event.type == 'TIMER' else {'RUNNING_MODAL'}

    def end_modal(self, context):
        context.window_manager.event_timer_remove(self._timer)
        super().end_modal(context)


class LongWork(AtWork):
    """Does what execute() takes by result_of() beforehand, when a user calls it. What execute() changes is one undo step."""

    _work = None

    def tasks(self, context):
        """The tasks of Work, with what they need read already: they run on another thread, where Blender's data is not to be
        touched. Raises FAILURES."""
        raise NotImplementedError("tasks: each operator says what takes long")

    def result_of(self, key, task):
        """The result of a task that tasks() has under this key, done before or now. Raises what the task raised."""
        results = self._work.results if self._work else {}
        result = results[key] if key in results else task(None)
        if isinstance(result, Exception):
            raise result
        return result

    def invoke(self, context, event):
        return self.called(context)

    def called(self, context):
        """What invoke() returns."""
        if bpy.app.background or context.window is None:
            return self.execute(context)
        try:
            self._work = Work(self.tasks(context))
        except FAILURES:
            return self.execute(context)            # which says it
        if self._work.is_done(_SHORT):
            return self._finished_work(context)
        self._began, self._said = time.monotonic() - _SHORT, None
        self._tell(context)
        return self.begin_modal(context)

    def work_on(self, context):
        if self._work.is_done():
            self.end_modal(context)
            return self._finished_work(context)
        self._tell(context)
        return {'RUNNING_MODAL'}

    def put_back(self):
        self._work.stop()

    def called_off(self):
        return reports.stopped(self, phrase("{label} was stopped: nothing has changed", label=phrase(self.bl_label)))

    def _finished_work(self, context):
        try:
            return self.execute(context)
        finally:
            self._work = None           # the panel of the last operator asks for other things

    def _tell(self, context):
        seconds = int(time.monotonic() - self._began)
        if seconds != self._said:
            self._said = seconds
            context.workspace.status_text_set(say(phrase("{label}: at work for {seconds} s   |   Esc: stop, nothing changes",
                                                     label=phrase(self.bl_label), seconds=seconds)))
