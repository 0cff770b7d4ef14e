"""Edit the net of a shape, and leave it."""

import bpy

from ...bridge.cage import net_object
from ...bridge.shape import shape
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from .. import active_shape, editing, messages, progress, texts
from . import polls, reports


class SPLINEWRIGHT_OT_edit_net(bpy.types.Operator):
    bl_idname = "splinewright.edit_net"
    bl_label = "Edit Control Points"
    bl_description = "Edit the control net of the active shape, and of selected ones of its kind, in Edit Mode"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        reason = editing.why_not(active_shape.shape_of(context.object))
        if reason:
            cls.poll_message_set(say(reason))
        return not reason

    def execute(self, context):
        try:
            with progress.shown(context, len(context.selected_objects)) as step:
                editing.enter(context, active_shape.shape_of(context.object), step)
        except FAILURES as error:
            return reports.failed(self, error)
        return {'FINISHED'}


class _OnNets:
    """Works on the nets in Edit Mode."""

    bl_options = {'REGISTER', 'UNDO'}
    works_on_nets = True

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set(say("No net is being edited"))
            return False
        return True


class SPLINEWRIGHT_OT_leave_net(_OnNets, bpy.types.Operator):
    bl_idname = "splinewright.leave_net"
    bl_label = "Finish Editing"
    bl_description = "Close the control net; the shape keeps every digit"

    def invoke(self, context, event):
        """What would be lost is asked for; scripts are not asked."""
        self._lost = editing.unread(editing.nets_in_edit_mode(context))
        if not self._lost:
            return self.execute(context)
        return context.window_manager.invoke_props_dialog(self, width=460, **_names("Finish Editing", "Leave"))

    def draw(self, context):
        texts.draw_problem(self.layout, phrase("The net cannot be read: {lost}", lost=self._lost), width=70)
        self.layout.label(text="Leave without the last changes?")

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        with progress.shown(context, len(nets)) as step:
            lost = editing.leave(context, step)
        messages.refresh()
        is_news = lost and not getattr(self, '_lost', "")
        warnings = (phrase("The last state of the net was not taken: {lost}", lost=lost),) if is_news else ()
        return reports.finished(self, reports.Report(warnings=warnings))


def _names(title, button):
    """For a dialog, where Blender takes names for it; 3.4 has those of the operator."""
    known = bpy.types.WindowManager.bl_rna.functions['invoke_props_dialog'].parameters.keys()
    return {name: text for name, text in (('title', title), ('confirm_text', button)) if name in known}


class SPLINEWRIGHT_OT_renew_net(_OnNets, bpy.types.Operator):
    bl_idname = "splinewright.renew_net"
    bl_label = "Reload Control Points"
    bl_description = "Rebuild the net from the shape as it is: points that were lost come back, others go"

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        try:
            for owner in filter(None, map(net_object.shape_of, nets)):
                shape.require_untouched(owner.data)
        except FAILURES as error:
            return reports.failed(self, error)
        warnings = tuple(editing.anew(context, nets))
        messages.refresh()
        return reports.finished(self, reports.Report(warnings=warnings))


CLASSES = (SPLINEWRIGHT_OT_edit_net, SPLINEWRIGHT_OT_leave_net, SPLINEWRIGHT_OT_renew_net)
