"""Add lines, Bezier, Hermite and NURBS curves."""

import bpy
from bpy.props import BoolProperty

from ...core.shape import starters
from . import new_shapes
from .adding import AddShape, count_property, degree_property, enough_points, knots_property, resolution_property


class SPLINEWRIGHT_OT_add_line(AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_line"
    bl_label = "Add Line"
    button = "Line"
    bl_description = "Add a straight segment, or a polyline of more points"
    shape_name = "Line"

    count: count_property(default=2)
    resolution_u: resolution_property(default=1)

    def value(self):
        return starters.line(self.count)

    def draw_shape(self, layout):
        layout.prop(self, "count")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_add_bezier_curve(AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_bezier_curve"
    bl_label = "Add Bezier Curve"
    button = "Bezier Curve"
    bl_description = "Add one Bezier segment of any degree"
    shape_name = "Bezier Curve"

    degree: degree_property(default=3)
    resolution_u: resolution_property(default=32)

    def value(self):
        return starters.bezier_curve(self.degree)

    def draw_shape(self, layout):
        layout.prop(self, "degree")
        new_shapes.draw(self, layout)


class _AddChain(AddShape):
    """`chain` of core.shape.starters makes it."""

    chain = None

    count: count_property(default=4)
    closed: BoolProperty(name="Closed", description="End where the chain began")
    resolution_u: resolution_property()

    def value(self):
        if self.closed:
            self.count = max(self.count, 3)
        return self.chain(self.count, self.closed)

    def draw_shape(self, layout):
        layout.prop(self, "count")
        layout.prop(self, "closed")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_add_bezier_chain(_AddChain, bpy.types.Operator):
    bl_idname = "splinewright.add_bezier_chain"
    bl_label = "Add Bezier Chain"
    button = "Bezier Chain"
    bl_description = "Add a smooth chain of cubics, each point with two handles, as in Blender"
    shape_name = "Bezier Chain"
    chain = staticmethod(starters.bezier_chain)


class SPLINEWRIGHT_OT_add_hermite_curve(_AddChain, bpy.types.Operator):
    bl_idname = "splinewright.add_hermite_curve"
    bl_label = "Add Hermite Chain"
    button = "Hermite Chain"
    bl_description = "Add a chain of cubics through points with given tangents"
    shape_name = "Hermite Chain"
    chain = staticmethod(starters.hermite_chain)


class SPLINEWRIGHT_OT_add_nurbs_curve(AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_nurbs_curve"
    bl_label = "Add NURBS Curve"
    button = "NURBS Curve"
    bl_description = "Add a NURBS curve of any degree on clamped, unclamped or periodic knots"
    shape_name = "NURBS Curve"

    degree: degree_property(default=3)
    count: count_property(default=6)
    knots: knots_property()
    resolution_u: resolution_property()

    def value(self):
        self.count = enough_points(self.count, self.degree, self.knots)
        return starters.nurbs_curve(self.degree, self.count, self.knots)

    def draw_shape(self, layout):
        layout.prop(self, "degree")
        layout.prop(self, "count")
        layout.prop(self, "knots")
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_add_line, SPLINEWRIGHT_OT_add_bezier_curve, SPLINEWRIGHT_OT_add_bezier_chain,
           SPLINEWRIGHT_OT_add_hermite_curve, SPLINEWRIGHT_OT_add_nurbs_curve)
