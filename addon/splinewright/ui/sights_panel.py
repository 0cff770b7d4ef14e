"""The part of the Overlays popover that is ours: switches, and the settings of what they show in a popover of its own."""

import bpy

from ..bridge import deviations, shape, sights
from ..bridge.net import net_object
from . import kinds, sights_overlay, texts

#: Characters that fit a line of the popover.
_WIDTH = 44
_CURVES, _PATCHES = {'curve'}, {'patch'}
#: Switches, of what they show something, and the settings that belong to them.
_SWITCHES = (
    ("polygon", kinds.SHAPES, ()), ("points_behind", kinds.SHAPES, ()), ("curve", _CURVES, ()), ("knots", kinds.SHAPES, ()),
    ("weights", kinds.SHAPES, ()), ("strip", kinds.SHAPES, ("strip_tolerance",)), ("isocurves", _PATCHES, ("isocurve_count",)),
    ("comb", _CURVES, ("comb_scale", "comb_density")), ("frame", _CURVES, ("frame_length", "place")),
    ("hodograph", _CURVES, ("hodograph_scale", "place")), ("normals", _PATCHES, ("normal_length", "normal_count")),
    ("stripes", _PATCHES, ("stripe_kind", "stripe_count", "stripe_axis")), ("curvature", _PATCHES, ("curvature_kind", "curvature_range")),
    ("deviation", kinds.SHAPES, ("deviation_object", "deviation_range")))
#: It is shown beside its switch, too: without it there is nothing to see.
_BESIDE = "deviation_object"


class _OnSights:
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'HEADER'

    @classmethod
    def poll(cls, context):
        ob = context.object
        return shape.has_shape(ob) or net_object.is_net(ob)


class SPLINEWRIGHT_PT_sights(_OnSights, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_sights"
    bl_label = "NURBS"
    bl_parent_id = "VIEW3D_PT_overlay"

    def draw_header(self, context):
        self.layout.label(text=self.bl_label)
        self.layout.popover(SPLINEWRIGHT_PT_sight_settings.bl_idname, text="Sizes and Counts")

    def draw(self, context):
        """Few rows, as Blender's own leave no more room on a usual screen."""
        chosen = sights.of(context.scene)
        space = context.space_data
        column = self.layout.column()
        column.active = space is None or space.overlay.show_overlays
        grid = column.grid_flow(row_major=True, columns=2, even_columns=True)
        for switch, _ in _concerned(context):
            grid.prop(chosen, switch)
        if chosen.deviation:
            column.prop(chosen, _BESIDE, text="To")
            said = deviations.problem(context.scene, sights_overlay.shapes_in_hand(context))
            if said:
                texts.draw_problem(column, said, _WIDTH)


class SPLINEWRIGHT_PT_sight_settings(_OnSights, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_sight_settings"
    bl_label = "Sizes and Counts of Overlays"
    bl_options = {'INSTANCED'}
    bl_ui_units_x = 16

    def draw(self, context):
        chosen = sights.of(context.scene)
        layout = self.layout
        layout.use_property_split = True
        users = {}                      # of each setting the switches that it belongs to
        for switch, settings in _concerned(context):
            for name in settings:
                users.setdefault(name, []).append(switch)
        for name, switches in users.items():
            row = layout.row()
            row.active = any(getattr(chosen, switch) for switch in switches)
            row.prop(chosen, name)


def _concerned(context):
    """Switches that show something of the shapes in hand, or all where there are none, with their settings."""
    found = {kinds.of(ob) for ob in sights_overlay.shapes_in_hand(context)} & kinds.SHAPES or kinds.SHAPES
    return [(switch, settings) for switch, concerned, settings in _SWITCHES if concerned & found]


CLASSES = (SPLINEWRIGHT_PT_sights, SPLINEWRIGHT_PT_sight_settings)
