"""The part of the Overlays popover that is ours."""

import bpy

from ..bridge import deviations, shape, sights
from ..bridge.net import net_object
from . import sights_overlay, texts

#: Characters that fit a line of the popover.
_WIDTH = 44


class SPLINEWRIGHT_PT_sights(bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_sights"
    bl_label = "NURBS"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'HEADER'
    bl_parent_id = "VIEW3D_PT_overlay"

    @classmethod
    def poll(cls, context):
        ob = context.object
        return shape.has_shape(ob) or net_object.is_net(ob)

    def draw(self, context):
        chosen = sights.of(context.scene)
        space = context.space_data
        column = self.layout.column()
        column.active = space is None or space.overlay.show_overlays
        row = column.row()
        row.prop(chosen, "polygon")
        row.prop(chosen, "points_behind")
        row = column.row()
        row.prop(chosen, "curve")
        row.prop(chosen, "knots")
        column.prop(chosen, "weights")
        _draw_switch(column, chosen, "strip", "strip_tolerance")
        _draw_switch(column, chosen, "isocurves", "isocurve_count")
        _draw_switch(column, chosen, "comb", "comb_scale", "comb_density")
        _draw_switch(column, chosen, "frame", "frame_length")
        _draw_switch(column, chosen, "hodograph", "hodograph_scale")
        if chosen.frame or chosen.hodograph:
            row = column.split(factor=0.5)
            row.label()
            row.prop(chosen, "place", slider=True)
        _draw_switch(column, chosen, "normals", "normal_length", "normal_count")
        _draw_switch(column, chosen, "stripes", "stripe_kind")
        if chosen.stripes:
            row = column.split(factor=0.5)
            row.prop(chosen, "stripe_count")
            row.row().prop(chosen, "stripe_axis", text="")
        _draw_switch(column, chosen, "curvature", "curvature_kind")
        if chosen.curvature:
            row = column.split(factor=0.5)
            row.label()
            row.prop(chosen, "curvature_range")
        _draw_switch(column, chosen, "deviation", "deviation_object")
        if chosen.deviation:
            row = column.split(factor=0.5)
            row.label()
            row.prop(chosen, "deviation_range")
            said = deviations.problem(context.scene, sights_overlay.shapes_in_hand(context))
            if said:
                texts.draw_problem(column, said, _WIDTH)


def _draw_switch(layout, chosen, switch, *numbers):
    """A switch and what belongs to it, which is dim while it is off."""
    row = layout.split(factor=0.5)
    row.prop(chosen, switch)
    field = row.row(align=True)
    field.active = getattr(chosen, switch)
    for number in numbers:
        field.prop(chosen, number, text="")


CLASSES = (SPLINEWRIGHT_PT_sights,)
