"""Drawings over shapes, as switches of the scene: each off until it is wanted, and kept with the file."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, PointerProperty

from ..bridge.analysis import deviation_targets
from ..bridge.cage import net_object
from ..bridge.data.file_state import state
from . import editing


def _switch(name, description, **more):
    return BoolProperty(name=name, description=description, default=False, options=set(), **more)


def _points_behind_changed(self, _context):
    for held in editing.nets():
        held.show_in_front = self.points_behind


def _deviation_changed(self, _context):
    if not self.deviation:
        state.targets.clear()


def _may_be_measured_to(_self, ob):
    return ob.type in deviation_targets.TYPES and not net_object.is_net(ob)


class SplinewrightSights(bpy.types.PropertyGroup):
    """Of selected shapes, and of those whose nets are out."""

    curve: _switch("Curve", "Draw the curve itself above its control polygon, finer than its resolution")
    polygon: _switch("Control Net", "Draw control polygons of curves and control nets of surfaces in Object Mode")
    labels: _switch("Labels", "Write the names of control points, weights, knots and functions beside them")
    axes: _switch("Axes and Grid", "Draw axes with numbers through the origin of shapes, and a grid around them")
    points_behind: _switch("X-Ray Control Points", "Show the points and lines of nets that lie behind the shape, too",
                           update=_points_behind_changed)
    weights: _switch("Weight Dial", "Show a dial around selected points of nets; drag it to change their weights")
    knots: _switch("Knots", "Mark the knots of curves, and draw the lines on surfaces where their spans meet")
    strip: _switch(
        "Knot Strip", "Show the knots of the active shape on a bar: drag them, double-click to insert, Delete or X to remove")
    strip_tolerance: FloatProperty(
        name="Removal Tolerance", description="How far the shape may move where a knot is removed from the strip, in "
        "units of the object", default=1e-3, min=0.0, max=1e6, soft_max=1.0, precision=6, step=0.01, options=set())
    isocurves: _switch("Isocurves", "Draw lines on surfaces along which u or v stays the same")
    isocurve_count: IntProperty(
        name="Isocurves per Span", description="How many lines there are in every span, each way",
        default=3, min=1, max=64, soft_max=16, options=set())
    comb: _switch(
        "Curvature Comb", "Draw teeth on curves, away from the middle of curvature, as long as it is large")
    comb_scale: FloatProperty(
        name="Comb Scale", description="How long a tooth is where the curvature is 1, in units of the object",
        default=0.5, min=1e-6, max=1e6, soft_min=0.01, soft_max=100.0, options=set())
    comb_density: IntProperty(
        name="Teeth per Span", description="How many teeth there are in every span of a curve",
        default=24, min=1, max=1000, soft_max=100, options=set())
    frame: _switch(
        "Osculating Circle", "Draw osculating circle and frame at a parameter: tangent in red, normal in green, binormal in "
                             "blue")
    place: FloatProperty(
        name="Position", description="Where on the curve, as a part of its domain",
        default=0.5, min=0.0, max=1.0, subtype='FACTOR', options=set())
    frame_length: FloatProperty(
        name="Frame Length", description="How long its axes are, in units of the object",
        default=0.5, min=1e-6, max=1e6, soft_min=0.01, soft_max=100.0, options=set())
    hodograph: _switch(
        "Hodograph", "Draw the first derivative of curves as a curve around the origin, and as an arrow")
    hodograph_scale: FloatProperty(
        name="Hodograph Scale", description="How large it is drawn",
        default=0.25, min=1e-6, max=1e6, soft_min=0.01, soft_max=100.0, options=set())
    normals: _switch("Surface Normals", "Draw normals of surfaces")
    normal_length: FloatProperty(
        name="Normal Length", description="How long they are, in units of the object",
        default=0.2, min=1e-6, max=1e6, soft_min=0.01, soft_max=100.0, options=set())
    normal_count: IntProperty(
        name="Normals per Span", description="How many there are in every span, each way",
        default=4, min=1, max=64, soft_max=16, options=set())
    stripes: _switch(
        "Stripes", "Paint surfaces with stripes by their exact normals: where they break, the surface does")
    stripe_kind: EnumProperty(
        name="Stripe Type", description="What the stripes are",
        items=(('ZEBRA', "Zebra", "Rings of light around the axis, as the surface would reflect them"),
               ('REFLECTION', "Reflection Lines", "Long lamps along the axis, as the surface would reflect them"),
               ('HIGHLIGHT', "Highlight Lines", "Where normals have the same angle with the axis, from any side")),
        default='ZEBRA', options=set())
    stripe_count: IntProperty(
        name="Stripe Count", description="How many light stripes there are over half a turn",
        default=16, min=1, max=1000, soft_max=64, options=set())
    stripe_axis: FloatVectorProperty(
        name="Stripe Axis", description="The direction in the world around which stripes lie",
        subtype='DIRECTION', default=(0.0, 0.0, 1.0), options=set())
    curvature: _switch(
        "Curvature Colors", "Paint surfaces with colors of their curvature and draw a legend; in place of stripes")
    curvature_kind: EnumProperty(
        name="Curvature Type", description="Which curvature the colors tell",
        items=(('GAUSS', "Gauss", "The product of both principal curvatures: 0 where the surface unrolls into a plane"),
               ('MEAN', "Mean", "The mean of both principal curvatures, above 0 where it bends towards its normals"),
               ('LARGEST', "Largest Principal", "The larger one of both principal curvatures"),
               ('SMALLEST', "Smallest Principal", "The smaller one of both principal curvatures")),
        default='GAUSS', options=set())
    curvature_range: FloatProperty(
        name="Curvature Range",
        description="The curvature from which on colors stay the same; 0: so that nine tenths of the surface differ",
        default=0.0, min=0.0, max=1e12, soft_max=100.0, precision=4, options=set())
    deviation: _switch(
        "Distance Colors", "Color surfaces and curves by their distance from another object and draw a legend; in place "
        "of curvature and stripes", update=_deviation_changed)
    deviation_object: PointerProperty(
        name="Deviation From", description="Object to which distances are measured: exactly to shapes without modifiers, "
                                           "otherwise to faces, edges or points",
        type=bpy.types.Object, poll=_may_be_measured_to, options=set())
    deviation_range: FloatProperty(
        name="Distance Range", description="The distance from which on colors stay the same; 0: the largest one that there is",
        default=0.0, min=0.0, max=1e12, soft_max=100.0, precision=4, subtype='DISTANCE', options=set())


CLASSES = (SplinewrightSights,)


def register():
    bpy.types.Scene.splinewright_sights = PointerProperty(type=SplinewrightSights)


def unregister():
    del bpy.types.Scene.splinewright_sights
