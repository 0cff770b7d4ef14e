"""Analysis, in the sidebar: the switches of overlays by what they tell, each with its settings; and the same switches in the
Overlays popover, where there is little room."""

import bpy

from ..bridge.analysis import deviations
from ..bridge.cage import net_object
from ..bridge.data.settings import overlays_of
from ..bridge.shape import shape
from ..core.base.words import say
from . import analysis_overlay, fields, object_kinds, texts
from .sub_panel import ClosedPanel

#: Characters that fit a line of the popover.
_WIDTH = 44
#: By how much settings are set in, in pixels of an interface that is not scaled.
_SET_IN = 20
_CURVES, _PATCHES = {'curve'}, {'patch'}
#: Switches by groups, of what they show something, and the settings that belong to them.
_GROUPS = (
    ("Structure", (
        ("polygon", object_kinds.SHAPES, ()), ("labels", object_kinds.SHAPES, ()), ("axes", object_kinds.SHAPES, ()), ("points_behind", object_kinds.SHAPES, ()), ("curve", _CURVES, ()), ("knots", object_kinds.SHAPES, ()),
        ("weights", object_kinds.SHAPES, ()), ("strip", object_kinds.SHAPES, ("strip_tolerance",)), ("isocurves", _PATCHES, ("isocurve_count",)),
        ("normals", _PATCHES, ("normal_length", "normal_count")))),
    ("Curvature", (
        ("comb", _CURVES, ("comb_scale", "comb_density")), ("frame", _CURVES, ("frame_length", "place")),
        ("hodograph", _CURVES, ("hodograph_scale", "place")), ("stripes", _PATCHES, ("stripe_kind", "stripe_count", "stripe_axis")),
        ("curvature", _PATCHES, ("curvature_kind", "curvature_range")))),
    ("Deviation", (("deviation", object_kinds.SHAPES, ("deviation_object", "deviation_range")),)))
#: It is shown beside its switch, too: without it there is nothing to see.
_BESIDE = "deviation_object"


class SPLINEWRIGHT_PT_analysis(ClosedPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_analysis"
    bl_label = "Analysis"
    bl_order = 7

    @classmethod
    def poll(cls, context):
        return _has_sights(context.object)

    def draw(self, context):
        chosen, space = overlays_of(context.scene), context.space_data
        if space is not None and not space.overlay.show_overlays:
            texts.draw_note(self.layout, "The overlays of this view are off")
        drawn = set()                   # one setting may belong to several switches
        for label, switches in _concerned(context):
            column = self.layout.column(align=True)
            column.label(text=say(label))
            for switch, settings in switches:
                column.prop(chosen, switch)
                if getattr(chosen, switch):
                    _draw_settings(column, chosen, [name for name in settings if name not in drawn])
                    drawn.update(settings)
        _draw_problem(self.layout, context)


def _has_sights(ob):
    return shape.has_shape(ob) or net_object.is_net(ob)


def _draw_settings(column, chosen, names):
    """Below their switch, set in."""
    row = column.row()
    row.separator(factor=2.0)
    below = row.column(align=True)
    for name in names:
        known = chosen.bl_rna.properties[name]
        if known.type == 'ENUM':
            below.prop(chosen, name, text="")       # its value tells what it is
        elif known.type == 'POINTER':
            fields.choice(below, chosen, name, beside=_SET_IN)
        elif known.is_array:
            below.prop(chosen, name)
        else:
            fields.number(below, chosen, name, beside=_SET_IN)
    if names:
        column.separator()


def _draw_problem(layout, context, width=None):
    said = deviations.problem(context.scene, analysis_overlay.active_shapes(context)) if overlays_of(context.scene).deviation else ""
    if said:
        texts.draw_problem(layout, said, width)


class SPLINEWRIGHT_PT_sights(bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_sights"
    bl_label = "NURBS"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'HEADER'
    bl_parent_id = "VIEW3D_PT_overlay"

    @classmethod
    def poll(cls, context):
        return _has_sights(context.object)

    def draw(self, context):
        """Few rows, as Blender's own leave no more room on a usual screen: the settings are in the sidebar."""
        chosen, space = overlays_of(context.scene), context.space_data
        column = self.layout.column()
        column.active = space is None or space.overlay.show_overlays
        grid = column.grid_flow(row_major=True, columns=2, even_columns=True)
        for _, switches in _concerned(context):
            for switch, _ in switches:
                grid.prop(chosen, switch)
        if chosen.deviation:
            column.prop(chosen, _BESIDE, text="To")
        _draw_problem(column, context, _WIDTH)
        column.label(text="Settings: in the sidebar")


def _concerned(context):
    """[(label, switches that show something of the active shapes with their settings)]; all switches where there are none."""
    found = {object_kinds.of(ob) for ob in analysis_overlay.active_shapes(context)} & object_kinds.SHAPES or object_kinds.SHAPES
    groups = [(label, [(switch, settings) for switch, concerned, settings in switches if concerned & found])
              for label, switches in _GROUPS]
    return [(label, switches) for label, switches in groups if switches]


CLASSES = (SPLINEWRIGHT_PT_analysis, SPLINEWRIGHT_PT_sights)
