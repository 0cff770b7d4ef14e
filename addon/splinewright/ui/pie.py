"""The most common commands for nets, around the mouse."""

import bpy

from ..core.base.words import say
from . import active_shape, editing, menu_table, offered


class SPLINEWRIGHT_MT_pie(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_pie"
    bl_label = "NURBS"

    def draw(self, context):
        pie = self.layout.menu_pie()
        pie.operator_context = 'INVOKE_REGION_WIN'
        for entry in menu_table.PIE_OF_CURVES if isinstance(context.object.data, bpy.types.Curve) else menu_table.PIE_OF_PATCHES:
            row = pie.row()
            row.enabled = not offered.is_gray(entry, active_shape.shapes(context))
            row.operator(f"splinewright.{entry.operator}", text=say(offered.text_of(entry.operator)), icon=entry.icon)


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
