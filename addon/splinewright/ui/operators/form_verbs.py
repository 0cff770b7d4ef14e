"""Verbs that give curves and patches another form: fewer or other points, another kind, other weights."""

from functools import partial

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatVectorProperty, IntProperty

from ...bridge.edit import replace_pieces
from ...core.verbs import patch_verbs, verbs
from . import pieces
from .on_shapes import OnCurves, OnShapes, plain
from .pieces import scene_tolerance_property, tolerance_property


class _Fitted(pieces.LongOnPieces, OnShapes):
    """What of ends and borders stays."""

    keep_tangents: BoolProperty(name="Keep End Tangents", description="Keep the first derivatives at the ends of open curves, "
                                "and across the borders of patches")

    @property
    def ends(self):
        return 'tangents' if self.keep_tangents else 'points'


class SPLINEWRIGHT_OT_rebuild(_Fitted, bpy.types.Operator):
    bl_idname = "splinewright.rebuild"
    bl_label = "Rebuild"
    bl_description = "Replace the shape by the nearest one with a given number of points on even knots, and report the distance"
    done, already = "Rebuilt {what}", "its points and knots are these already"
    expanded = ('by',)
    of_curves, of_patches = ('by', 'tolerance', 'keep_tangents'), ('count_v', 'degree_v')

    by: EnumProperty(name="By", items=(
        ('COUNT', "Points", "With a given number of control points"),
        ('TOLERANCE', "Tolerance", "Curves, with as few control points as lie within the tolerance")))
    count_u: IntProperty(name="Points U", description="How many control points along u; degree + 1 make one span", default=10,
                         min=2, soft_max=200)
    count_v: IntProperty(name="V", description="How many control points along v", default=10, min=2, soft_max=200)
    tolerance: tolerance_property("How far the curve may lie from the present one", 0.001, least=1e-12)
    degree_u: IntProperty(name="Degree U", description="Degree of the new shape along u", default=3, min=1, soft_max=9)
    degree_v: IntProperty(name="V", description="Degree of the new shape along v", default=3, min=1, soft_max=9)

    def all_settings(self):
        by_tolerance = self.by == 'TOLERANCE' and False not in self.kinds()
        return ['by', *(['tolerance'] if by_tolerance else ['count_u', 'count_v']), 'degree_u', 'degree_v', 'keep_tangents']

    def verb_with(self, ob):
        if not replace_pieces.is_curve_shape(ob):
            return partial(patch_verbs.rebuild, (self.count_u, self.count_v), (self.degree_u, self.degree_v))
        if self.by == 'COUNT':
            return partial(verbs.rebuild, self.count_u, self.degree_u, self.ends)
        return partial(verbs.rebuild_within, self.length, self.degree_u, self.ends)


class SPLINEWRIGHT_OT_fair(_Fitted, bpy.types.Operator):
    bl_idname = "splinewright.fair"
    bl_label = "Smooth (Fair)"
    bl_description = ("Move control points so that the shape bends as little as a tolerance allows; borders, knots and "
                      "weights stay")
    done, already = "Smoothed {what}", "no other shape within the tolerance bends less"

    tolerance: tolerance_property("How far the shape may move", 0.01, least=1e-12)

    def all_settings(self):
        return ['tolerance', 'keep_tangents']

    def verb_with(self, ob):
        verb = verbs.fair if replace_pieces.is_curve_shape(ob) else patch_verbs.fair
        return partial(verb, self.length, self.ends)


class SPLINEWRIGHT_OT_to_hermite(OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.to_hermite"
    bl_label = "Convert to Hermite"
    bl_description = "Make shapes of degree 3 or less Hermite: exactly without weights, conics within a tolerance"
    bl_options = {'REGISTER', 'UNDO'}
    done, already = "Made {what} Hermite", "it is Hermite already"
    has_scene_tolerance, of_curves = True, ('tolerance',)

    tolerance: scene_tolerance_property("How far cubics may lie from a conic")

    def verb_on(self, is_curve):
        return verbs.to_hermite(self.length) if is_curve else patch_verbs.to_hermite()


class SPLINEWRIGHT_OT_project_curve(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.project_curve"
    bl_label = "Project in Perspective"
    bl_description = "Project curves exactly from a point, or the active camera, onto their object's plane z = 0"
    bl_options = {'REGISTER', 'UNDO'}
    done = "Projected {what}"

    eye: FloatVectorProperty(name="Eye", description="Where it is seen from, in the active object's space",
                             default=(0.0, 0.0, 10.0), subtype='XYZ', unit='LENGTH', options={'SKIP_SAVE'})

    def work(self, context, ob):
        """The eye is that of the active object, which others see from their own space."""
        eye = self.eye
        if ob != context.object:
            eye = ob.matrix_world.inverted_safe() @ context.object.matrix_world @ eye
        return self.do(ob, verbs.project(eye))

    def invoke(self, context, event):
        camera, ob = context.scene.camera, context.object
        if camera and ob and not self.properties.is_property_set('eye'):
            self.eye = ob.matrix_world.inverted_safe() @ camera.matrix_world.translation
        return super().invoke(context, event)


_PLAIN = (
    plain(OnShapes, 'to_bezier', "Convert to Bezier",
          "Make every span a Bezier curve or patch, a piece of the same shape; neighbors share their points",
          "Made {what} Bezier", "its pieces are Bezier already",
          verb_on=lambda self, is_curve: verbs.to_bezier_chain() if is_curve else patch_verbs.to_bezier()),
    plain(OnShapes, 'to_nurbs', "Convert to NURBS", "Make Bezier and Hermite shapes NURBS; they stay the same",
          "Made {what} NURBS", "it is NURBS already",
          verb_on=lambda self, is_curve: verbs.to_nurbs() if is_curve else patch_verbs.to_nurbs()),
    plain(OnCurves, 'standard_form', "Normalize Weights",
          "Change the parameter so that both end weights are 1 (standard form); the curve stays the same",
          "Normalized the weights of {what}", "the end weights are 1 already", verb=lambda self: verbs.standard_form()))

CLASSES = (SPLINEWRIGHT_OT_rebuild, SPLINEWRIGHT_OT_fair, SPLINEWRIGHT_OT_to_hermite, SPLINEWRIGHT_OT_project_curve, *_PLAIN)
