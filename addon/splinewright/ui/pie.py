"""The most common commands for nets, around the mouse."""

import bpy

from ..core.base.words import say
from . import active_shape, editing, menu_table, offered

#: Of curves and of patches: left, right, below, above, and the corners from the upper left one on.
_CURVE = ("insert_here", "weight_here", "leave_net", "radius_here", "tilt_here", "make_periodic", "point_to_infinity",
          "set_knots")
_PATCH = ("insert_here", "weight_here", "leave_net", "raise_degree", "split", "make_periodic", "point_to_infinity", "set_knots")
_ICONS = {'leave_net': 'CHECKMARK'}


class SPLINEWRIGHT_MT_pie(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_pie"
    bl_label = "NURBS"

    def draw(self, context):
        pie = self.layout.menu_pie()
        pie.operator_context = 'INVOKE_REGION_WIN'
        names = _CURVE if isinstance(context.object.data, bpy.types.Curve) else _PATCH
        for name in names:
            row = pie.row()
            row.enabled = not offered.is_gray(menu_table.entry_of(name), active_shape.shapes(context))
            row.operator(f"splinewright.{name}", text=say(offered.text_of(name)), icon=_ICONS.get(name, 'NONE'))


class SPLINEWRIGHT_OT_pie(bpy.types.Operator):
    bl_idname = "splinewright.pie"
    bl_label = "Net Pie"
    bl_description = "The most common commands for nets, around the mouse"
    bl_options = {'INTERNAL'}

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set(say("Edit the net of a Splinewright shape first"))
            return False
        return True

    def invoke(self, context, event):
        bpy.ops.wm.call_menu_pie('INVOKE_DEFAULT', name=SPLINEWRIGHT_MT_pie.bl_idname)
        return {'FINISHED'}


CLASSES = (SPLINEWRIGHT_MT_pie, SPLINEWRIGHT_OT_pie)
