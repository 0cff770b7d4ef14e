"""Shapes whose inputs changed and that wait are made again: when they are asked for, or the mouse rests."""

import bpy

from ...bridge.data import problems
from ...bridge.data.file_state import key
from ...bridge.follow import follow, updating
from ...bridge.recipes import late
from ...bridge.shape import shape
from ...core.base.failures import Refusal
from ...core.base.words import phrase, say
from .. import hints, main_thread
from ..finishing import Finishing, has_esc, redraw, timed
from ..ui_state import ui_state
from . import reports
from .long_work import AtWork, LongWork
from .selected import OnSelected

#: Seconds that Blender waits for what is quick, and that it gives it between two redraws.
_MOMENT, _TURN = 0.1, 0.03


class SPLINEWRIGHT_OT_update_now(LongWork, OnSelected, bpy.types.Operator):
    bl_idname = "splinewright.update_now"
    bl_label = "Update Now"
    bl_description = "Make the selected shapes again from their inputs as they are now"
    needs = "Select a shape whose inputs changed since it was updated"
    done = "Updated {what}"

    @staticmethod
    def fits(ob):
        return shape.has_shape(ob) and late.is_late(ob.data)

    def tasks(self, context):
        graph = context.evaluated_depsgraph_get()
        found = {key(ob.data): updating.task_of(ob.data, graph) for ob in self.chosen(context)}
        self._made_of = {name: task[0] for name, task in found.items() if task}
        return {name: timed(task[1]) for name, task in found.items() if task}

    def work(self, context, ob):
        results = self._work.results if self._work else {}
        made = {name: updating.Made(self._made_of[name], *results[name]) for name in results}
        follow.finish([ob.data], context.evaluated_depsgraph_get(), made=made)
        problem = problems.of(ob.data, problems.FOLLOWING)
        if problem:
            raise Refusal(problem)


class SPLINEWRIGHT_OT_update_late(AtWork, bpy.types.Operator):
    bl_idname = "splinewright.update_late"
    bl_label = "Update Shapes That Wait"
    bl_description = "Make shapes again whose inputs changed while there was no time for them"
    bl_options = {'INTERNAL'}
    cursor = None

    def execute(self, context):
        follow.finish(late.waiting(), context.evaluated_depsgraph_get())
        return {'FINISHED'}

    def invoke(self, context, event):
        if ui_state.finishing is not None:
            return {'CANCELLED'}
        self._finishing, self._said = Finishing(), None
        if self._finishing.go_on(_MOMENT):
            redraw()
            return {'FINISHED'}
        ui_state.finishing = self._finishing
        return self.begin_modal(context)

    def lets_pass(self, event):
        """During a drag it is made later. Esc belongs to the drag, and stops only work that the status bar shows."""
        return event.type != 'TIMER' and not (event.type == 'ESC' and self._said and has_esc())

    def work_on(self, context):
        if not main_thread.is_away():       # a render is at another frame
            if self._finishing.go_on(_TURN):
                self.end_modal(context)
                return {'FINISHED'}
            self._tell(context)
        return {'RUNNING_MODAL', 'PASS_THROUGH'}

    def _tell(self, context):
        said = None
        if self._finishing.takes_long():
            said = self._finishing.sentence() + ("   |   Esc: stop" if has_esc() else "")
        if said != self._said:
            self._said = said
            context.workspace.status_text_set(say(said))

    def put_back(self):
        self._finishing.drop()

    def called_off(self):
        names = self._finishing.stop()
        hints.say_stopped()
        return reports.stopped(self, phrase("The update of {names} was stopped: Update Now makes it", names=reports.listed(names)))

    def end_modal(self, context):
        ui_state.finishing = None
        super().end_modal(context)
        redraw()


CLASSES = (SPLINEWRIGHT_OT_update_now, SPLINEWRIGHT_OT_update_late)
