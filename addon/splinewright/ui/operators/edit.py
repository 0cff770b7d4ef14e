"""Edit the net of a shape, and leave it."""

import bpy

from ...core.failures import FAILURES
from .. import editing, progress
from . import polls, reports


class SPLINEWRIGHT_OT_edit_net(bpy.types.Operator):
    bl_idname = "splinewright.edit_net"
    bl_label = "Edit Net"
    bl_description = "Edit the control net of the active shape, and of selected ones of its kind, in Edit Mode"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        reason = editing.why_not(context.object)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    def execute(self, context):
        try:
            with progress.shown(context, len(context.selected_objects)) as step:
                editing.enter(context, context.object, step)
        except FAILURES as error:
            return reports.failed(self, error)
        return {'FINISHED'}


class SPLINEWRIGHT_OT_leave_net(bpy.types.Operator):
    bl_idname = "splinewright.leave_net"
    bl_label = "Leave Net"
    bl_description = "Put the control net away; the shape keeps every digit"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set("No net is being edited")
            return False
        return True

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        with progress.shown(context, len(nets)) as step:
            problem = editing.leave(context, step)
        lost = (f"The last state of the net was not taken: {problem}",) if problem else ()
        return reports.finished(self, reports.Said(warnings=lost))


CLASSES = (SPLINEWRIGHT_OT_edit_net, SPLINEWRIGHT_OT_leave_net)
