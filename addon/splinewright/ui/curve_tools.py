"""The verbs of curve shapes in a menu and in the sidebar."""

import bpy

from ..bridge import replacing
from . import hand, tools
from .sub_panel import SubPanel

_GROUPS = (
    ("Knots", ('insert_knot', 'remove_knot', 'remove_knots')),
    ("Degree", ('raise_degree', 'lower_degree')),
    ("Fit", ('rebuild', 'fair')),
    ("Pieces", ('split_curve', 'join_ends', 'join_pieces', 'join_curves', 'reverse')),
    ("Corners", ('fillet_corners', 'chamfer_corners', 'fillet_curves', 'chamfer_curves')),
    ("Meet", ('trim_curve', 'extend_curve', 'split_where_met')),
    ("Speed", ('reparametrise', 'standard_form')),
    ("Ends", ('clamp', 'unclamp', 'make_periodic')),
    ("Place", ('project_curve',)),
    ("Kind", ('to_bezier_chain', 'to_hermite', 'to_nurbs')),
)
#: In the sidebar alone: among menus it stands with what cuts and meets.
_BESIDE = ("Beside", ('add_offset',))
#: On what is at the mouse.
BY_MOUSE = ('insert_here', 'pull_here', 'split_here', 'trim_here', 'extend_here', 'fillet_here', 'chamfer_here')


class SPLINEWRIGHT_MT_curve(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_curve"
    bl_label = "Curve"

    def draw(self, context):
        tools.draw_menu(self.layout, _GROUPS, list(filter(replacing.is_curve_shape, hand.shapes(context))))


def draw_verbs(layout, context):
    """Those that work while a net is edited."""
    groups = [(label, [name for name in names if tools.works_on_nets(name)]) for label, names in _GROUPS]
    tools.draw_menu(layout, groups, hand.shapes(context))


class SPLINEWRIGHT_PT_curve_tools(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_curve_tools"
    bl_label = "Curve Tools"

    @classmethod
    def poll(cls, context):
        return replacing.is_curve_shape(hand.shape_of(context.object))

    def draw(self, context):
        tools.draw_verbs(self.layout, (*_GROUPS, _BESIDE), context, replacing.is_curve_shape, BY_MOUSE)


CLASSES = (SPLINEWRIGHT_MT_curve, SPLINEWRIGHT_PT_curve_tools)
