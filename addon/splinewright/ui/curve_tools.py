"""The verbs of curve shapes in a menu and in the sidebar."""

import bpy

from ..bridge import replacing
from .sub_panel import SubPanel

#: Names of operators, group by group.
_GROUPS = (
    ("Knots", ('insert_knot', 'remove_knot', 'remove_knots')),
    ("Degree", ('raise_degree', 'lower_degree')),
    ("Pieces", ('split_curve', 'join_ends', 'join_pieces', 'reverse')),
    ("Speed", ('reparametrise', 'standard_form')),
    ("Ends", ('clamp', 'unclamp', 'make_periodic')),
    ("Place", ('project_curve',)),
    ("Kind", ('to_bezier_chain', 'to_hermite', 'to_nurbs')),
)


class SPLINEWRIGHT_MT_curve(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_curve"
    bl_label = "Curve"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        for i, (_, names) in enumerate(_GROUPS):
            if i:
                layout.separator()
            for name in names:
                layout.operator(f"splinewright.{name}")


class SPLINEWRIGHT_PT_curve_tools(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_curve_tools"
    bl_label = "Curve Tools"

    @classmethod
    def poll(cls, context):
        return replacing.is_curve_shape(context.object)

    def draw(self, context):
        for label, names in _GROUPS:
            row = self.layout.split(factor=0.3)
            row.label(text=label)
            column = row.column(align=True)
            for name in names:
                column.operator(f"splinewright.{name}")


CLASSES = (SPLINEWRIGHT_MT_curve, SPLINEWRIGHT_PT_curve_tools)
