"""What the Overlays popover shows, as entries of a menu: found by F3, also by words of other programs."""

from typing import NamedTuple

import bpy
from bpy.props import EnumProperty

from ...bridge.data.settings import overlays_of
from ...bridge.edit import replace_pieces
from ...core.base.words import say
from .. import active_shape
from . import reports


class _Sight(NamedTuple):
    """An entry: its words, what it shows, its switch, and the kind that goes with that."""

    label: str
    description: str
    switch: str
    kind: tuple = ()


_CONTINUITY = 'CONTINUITY'
SIGHTS = {
    'ZEBRA': _Sight("Zebra Stripes", "Rings of light, as the surface would reflect them", "stripes", ("stripe_kind", 'ZEBRA')),
    'REFLECTION': _Sight("Reflection Lines", "Long lamps, as the surface would reflect them", "stripes", ("stripe_kind", 'REFLECTION')),
    'HIGHLIGHT': _Sight("Highlight Lines", "Lines along which normals have one angle with an axis", "stripes", ("stripe_kind", 'HIGHLIGHT')),
    _CONTINUITY: _Sight("Continuity of Seams", "Seams of patches in colors of their continuity", ""),
    'COMB': _Sight("Curvature Comb", "Teeth on curves, as long as the curvature is large", "comb"),
    'CURVATURE': _Sight("Curvature Colors", "Surfaces in colors of their curvature", "curvature"),
    'DISTANCES': _Sight("Distance Colors", "Shapes in colors of their distance from another object", "deviation"),
    'CIRCLE': _Sight("Osculating Circle", "The circle that touches a curve best at a place, and the frame there", "frame"),
    'HODOGRAPH': _Sight("Hodograph", "The first derivative of curves", "hodograph"),
    'NORMALS': _Sight("Surface Normals", "Normals of surfaces", "normals"),
    'ISOCURVES': _Sight("Isocurves", "Lines on surfaces along which u or v stays the same", "isocurves"),
    'KNOTS': _Sight("Knots", "Where spans meet on curves and surfaces", "knots"),
    'STRIP': _Sight("Knot Strip", "The knots of the active shape on a bar", "strip"),
    'LABELS': _Sight("Labels", "Names of control points, weights, knots and functions", "labels"),
    'AXES': _Sight("Axes and Grid", "Axes with numbers through the origin of a shape, and a grid", "axes"),
    'NET': _Sight("Control Net", "Control polygons and control nets in Object Mode", "polygon"),
}


class SPLINEWRIGHT_OT_show_sight(bpy.types.Operator):
    bl_idname = "splinewright.show_sight"
    bl_label = "Show Overlay"
    bl_description = "Show or hide this for the selected shapes; the Overlays popover has its settings"
    bl_options = {'REGISTER', 'UNDO'}
    works_on_nets = True

    sight: EnumProperty(name="Overlay", items=[(name, sight.label, sight.description) for name, sight in SIGHTS.items()],
                        options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def description(cls, context, properties):
        return say(SIGHTS[properties.sight].description)

    @classmethod
    def poll(cls, context):
        if active_shape.shape_of(context.object) is None and not active_shape.shapes(context):
            cls.poll_message_set(say("Select a shape"))
            return False
        return True

    def execute(self, context):
        sight = SIGHTS[self.sight]
        if self.sight == _CONTINUITY:
            return self._continuity(context)
        chosen, (name, kind) = overlays_of(context.scene), sight.kind or ("", "")
        is_shown = getattr(chosen, sight.switch) and (not name or getattr(chosen, name) == kind)
        if name:
            setattr(chosen, name, kind)
        setattr(chosen, sight.switch, not is_shown)
        return {'FINISHED'}

    def _continuity(self, context):
        obs = [ob for ob in {*active_shape.shapes(context), active_shape.shape_of(context.object)} if ob is not None and replace_pieces.is_patch_shape(ob)]
        if not obs:
            return reports.cancelled(self, "Select a surface: the panel Continuity lists the joints of curves")
        blocks = {ob.data for ob in obs}
        is_shown = all(data.splinewright.show_seams for data in blocks)
        for data in blocks:
            data.splinewright.show_seams = not is_shown
        return reports.finished(self, reports.Report("" if is_shown else "Seams are colored: the panel Continuity in the sidebar lists them"))


CLASSES = (SPLINEWRIGHT_OT_show_sight,)
