"""The pieces of a shape that are meant by operators that ask for pieces, where there are several, in the sidebar."""

import bpy

from . import active_shape
from .sub_panel import SubPanel


class SPLINEWRIGHT_PT_pieces(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_pieces"
    bl_label = "Pieces"

    @classmethod
    def poll(cls, context):
        ob = active_shape.shape_of(context.object)
        return ob is not None and active_shape.count_of(ob.data) > 1

    def draw(self, context):
        chosen = active_shape.shape_of(context.object).data.splinewright
        self.layout.prop(chosen, "show_numbers")
        column = self.layout.column(align=True)
        for name, is_other in (("piece", False), ("other_piece", True)):
            row = column.row(align=True)
            row.prop(chosen, name)
            row.operator("splinewright.pick_piece", text="", icon='EYEDROPPER').other = is_other


CLASSES = (SPLINEWRIGHT_PT_pieces,)
