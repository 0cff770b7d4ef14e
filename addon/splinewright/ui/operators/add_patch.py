"""Add Bezier, Hermite and NURBS patches, and Newell's teapot."""

import bpy

from ...core.shape import starters
from . import new_shapes
from .adding import AddShape, count_property, degree_property, enough_points, knots_property, resolution_property


def draw_pairs(operator, layout, *names):
    """Each name with its U above its V."""
    for name in names:
        column = layout.column(align=True)
        column.prop(operator, f"{name}_u")
        column.prop(operator, f"{name}_v", text="V")


class SPLINEWRIGHT_OT_add_bezier_patch(new_shapes.Faces, AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_bezier_patch"
    bl_label = "Add Bezier Patch"
    button = "Bezier Patch"
    bl_description = "Add one Bezier patch of any degrees"
    shape_name = "Bezier Patch"

    degree_u: degree_property("U")
    degree_v: degree_property("V")
    resolution_u: resolution_property("U", default=24)
    resolution_v: resolution_property("V", default=24)

    def value(self):
        return starters.bezier_patch(self.degree_u, self.degree_v)

    def draw_shape(self, layout):
        draw_pairs(self, layout, "degree")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_add_hermite_patch(new_shapes.Faces, AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_hermite_patch"
    bl_label = "Add Hermite Patch"
    button = "Hermite Patch"
    bl_description = "Add a bicubic Ferguson patch: corners, tangents, and twists of zero"
    shape_name = "Hermite Patch"

    count_u: count_property("U", default=3)
    count_v: count_property("V", default=3)
    resolution_u: resolution_property("U")
    resolution_v: resolution_property("V")

    def value(self):
        return starters.hermite_patch(self.count_u, self.count_v)

    def draw_shape(self, layout):
        draw_pairs(self, layout, "count")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_add_nurbs_patch(new_shapes.Faces, AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_nurbs_patch"
    bl_label = "Add NURBS Patch"
    button = "NURBS Patch"
    bl_description = "Add a NURBS patch: a sheet, a tube where one direction is periodic, a torus where both are"
    shape_name = "NURBS Patch"

    degree_u: degree_property("U")
    degree_v: degree_property("V")
    count_u: count_property("U", default=6)
    count_v: count_property("V", default=6)
    knots_u: knots_property("U")
    knots_v: knots_property("V")
    resolution_u: resolution_property("U", default=8)
    resolution_v: resolution_property("V", default=8)

    def value(self):
        self.count_u = enough_points(self.count_u, self.degree_u, self.knots_u)
        self.count_v = enough_points(self.count_v, self.degree_v, self.knots_v)
        return starters.nurbs_patch((self.degree_u, self.degree_v), (self.count_u, self.count_v),
                                    (self.knots_u, self.knots_v))

    def draw_shape(self, layout):
        draw_pairs(self, layout, "degree", "count", "knots")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_add_teapot(new_shapes.Faces, AddShape, bpy.types.Operator):
    bl_idname = "splinewright.add_teapot"
    bl_label = "Add Newell's Teapot"
    button = "Newell's Teapot"
    bl_description = "Add the Utah teapot: 32 Bezier patches on one pool of points"
    shape_name = "Teapot"

    resolution_u: resolution_property("U", default=10)
    resolution_v: resolution_property("V", default=10)

    def value(self):
        return starters.teapot()

    def draw_shape(self, layout):
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_add_bezier_patch, SPLINEWRIGHT_OT_add_hermite_patch,
           SPLINEWRIGHT_OT_add_nurbs_patch, SPLINEWRIGHT_OT_add_teapot)
