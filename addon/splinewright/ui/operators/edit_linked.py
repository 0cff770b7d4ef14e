"""Tab on a shape that is linked from another file, or overrides one there: why it has no net, and what helps."""

import bpy

from ...bridge.shape import shape
from ...core.base.words import phrase, say
from . import polls, reports


class SPLINEWRIGHT_OT_edit_linked(bpy.types.Operator):
    bl_idname = "splinewright.edit_linked"
    bl_label = "Edit Linked Shape"
    bl_description = "Show from which file the active shape is linked, and offer to make it local for editing"
    bl_options = {'REGISTER'}

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not shape.has_shape(context.object) or not shape.file_of(context.object):
            cls.poll_message_set(say("Select a shape that is linked from another file"))
            return False
        return True

    def invoke(self, context, event):
        context.window_manager.popup_menu(_draw, title=say(told(context.object)), icon='LIBRARY_DATA_DIRECT')
        return {'CANCELLED'}

    def execute(self, context):
        return reports.cancelled(self, told(context.object))


def told(ob):
    return phrase("{name} is linked from {file}: make it local to edit it here", name=ob.name, file=shape.file_of(ob))


def _draw(self, context):
    draw_button(self.layout)


def draw_button(layout):
    """Makes the selected objects local with what they show."""
    layout.operator_context = 'EXEC_DEFAULT'
    layout.operator("object.make_local", text="Make Local").type = 'SELECT_OBDATA'


CLASSES = (SPLINEWRIGHT_OT_edit_linked,)
