"""The verbs of patch shapes in a menu and in the sidebar."""

import bpy

from ..bridge import replacing
from . import hand, tools
from .sub_panel import SubPanel

_GROUPS = (
    ("Knots", ('patch_insert_knot', 'patch_remove_knot', 'patch_remove_knots')),
    ("Degree", ('patch_raise_degree', 'patch_lower_degree')),
    ("Fit", ('patch_rebuild', 'patch_fair')),
    ("Pieces", ('patch_split', 'join_patches')),
    ("Direction", ('patch_reverse', 'patch_swap')),
    ("Speed", ('patch_reparametrise',)),
    ("Ends", ('patch_clamp', 'patch_unclamp', 'patch_make_periodic')),
    ("Kind", ('patch_to_bezier', 'patch_to_hermite', 'patch_to_nurbs')),
    ("Curves", ('extract_isocurve', 'extract_boundary')),
)
#: On what is at the mouse.
BY_MOUSE = ('insert_here', 'pull_here', 'split_here', 'join_here', 'extract_here', 'extract_side_here', 'round_here')


class SPLINEWRIGHT_MT_patch(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_patch"
    bl_label = "Patch"

    def draw(self, context):
        tools.draw_menu(self.layout, _GROUPS, list(filter(replacing.is_patch_shape, hand.shapes(context))))


def draw_verbs(layout, context):
    """Those that work while a net is edited."""
    groups = [(label, [name for name in names if tools.works_on_nets(name)]) for label, names in _GROUPS]
    tools.draw_menu(layout, groups, hand.shapes(context))


class SPLINEWRIGHT_PT_patch_tools(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_patch_tools"
    bl_label = "Patch Tools"

    @classmethod
    def poll(cls, context):
        return replacing.is_patch_shape(hand.shape_of(context.object))

    def draw(self, context):
        tools.draw_verbs(self.layout, _GROUPS, context, replacing.is_patch_shape, BY_MOUSE)


CLASSES = (SPLINEWRIGHT_MT_patch, SPLINEWRIGHT_PT_patch_tools)
