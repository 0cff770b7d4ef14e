"""Verbs of curve shapes: knots, degree, parts, parameters, ends and kinds, in Object Mode."""

from functools import partial

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatVectorProperty, IntProperty

from ...bridge import replacing
from ...core import parameters, verbs
from . import pieces
from .pieces import parameter_property, scene_tolerance_property, times_property, tolerance_property


class OnCurves(pieces.OnPieces):
    """Does verb() with pieces of every selected curve shape."""

    needs = "Select a curve shape"
    fits = staticmethod(replacing.is_curve_shape)


class _AtParameter(pieces.FromActive, OnCurves):
    """Begins with the parameter that fits the active curve."""

    asked = ('parameter',)

    @staticmethod
    def first_parameter(curve):
        return parameters.middle(curve)

    def first_values(self, curve):
        return (self.first_parameter(curve),)


class SPLINEWRIGHT_OT_insert_knot(_AtParameter, bpy.types.Operator):
    bl_idname = "splinewright.insert_knot"
    bl_label = "Insert Knot"
    bl_description = "Add a knot, and with it a control point; the curve stays the same"
    done = "Inserted knots into {}"

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('SPANS', "In Every Span", "In the middle of every span")))
    parameter: parameter_property("Parameter", "Parameter u on the curve")
    times: times_property("How many copies of the knot are added")

    first_parameter = staticmethod(parameters.middle_of_widest_span)

    def settings(self):
        return ['where', 'parameter', 'times'] if self.where == 'PARAMETER' else ['where', 'times']

    def verb(self):
        if self.where == 'SPANS':
            return verbs.insert_span_middles(self.times)
        return verbs.insert_knot(self.parameter, self.times)


class SPLINEWRIGHT_OT_remove_knot(pieces.WithinTolerance, _AtParameter, bpy.types.Operator):
    bl_idname = "splinewright.remove_knot"
    bl_label = "Remove Knot"
    bl_description = ("Remove copies of an inner knot with the least change of the control points, and report how far the "
                      "curve moved")
    done = "Removed a knot of {}"

    parameter: parameter_property("Parameter", "Parameter u on the curve")
    nearest: BoolProperty(name="Nearest", description="Take the inner knot that is nearest to the parameter; "
                          "otherwise there must be one at it", default=True)
    times: times_property("How many copies of the knot are taken away")

    def settings(self):
        return ['parameter', 'nearest', 'times', *self.limits()]

    def verb(self):
        return verbs.remove_knot(self.parameter, self.nearest, self.times, self.allowed)


class SPLINEWRIGHT_OT_remove_knots(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.remove_knots"
    bl_label = "Remove Knots"
    bl_description = ("Remove every inner knot whose removal moves the curve by no more than a tolerance; "
                      "a Hermite chain becomes NURBS")
    done, already = "Removed knots of {}", "no knot can go within the tolerance"

    tolerance: tolerance_property("Largest distance that is allowed", 1e-6)

    def verb(self):
        return verbs.remove_knots(self.length)


class SPLINEWRIGHT_OT_raise_degree(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.raise_degree"
    bl_label = "Raise Degree"
    bl_description = "Give the curve a higher degree and more control points; it stays the same"
    done = "Raised the degree of {}"

    times: times_property("By how much the degree is raised")

    def verb(self):
        return verbs.raise_degree(self.times)


class SPLINEWRIGHT_OT_lower_degree(pieces.WithinTolerance, OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.lower_degree"
    bl_label = "Lower Degree"
    bl_description = "Replace the curve by the nearest one of a lower degree, and report how far that lies from it"
    done = "Lowered the degree of {}"

    times: times_property("By how much the degree is lowered")

    def settings(self):
        return ['times', *self.limits()]

    def verb(self):
        return verbs.lower_degree(self.times, self.allowed)


class _Fitted(pieces.LongOnPieces, OnCurves):
    """What of the ends stays."""

    keep_tangents: BoolProperty(name="Keep End Tangents", description="Open curves keep their first derivatives at the ends")

    @property
    def ends(self):
        return 'tangents' if self.keep_tangents else 'points'


class SPLINEWRIGHT_OT_rebuild(_Fitted, bpy.types.Operator):
    bl_idname = "splinewright.rebuild"
    bl_label = "Rebuild"
    bl_description = ("Replace the curve by the nearest one with so many points on even knots, and report how far that lies "
                      "from it; degree + 1 points make one Bezier piece")
    done, already = "Rebuilt {}", "its points and knots are these already"

    by: EnumProperty(name="By", items=(
        ('COUNT', "Points", "With so many control points"),
        ('TOLERANCE', "Tolerance", "With as few control points as lie within the tolerance")))
    count: IntProperty(name="Points", description="How many control points each curve gets", default=10, min=2,
                       soft_max=200)
    tolerance: tolerance_property("How far the curve may lie from the present one", 0.001, least=1e-12)
    degree: IntProperty(name="Degree", description="Of the new curve", default=3, min=1, soft_max=9)

    expanded = ('by',)

    def settings(self):
        return ['by', 'count' if self.by == 'COUNT' else 'tolerance', 'degree', 'keep_tangents']

    def verb_with(self):
        if self.by == 'COUNT':
            return partial(verbs.rebuild, self.count, self.degree, self.ends)
        return partial(verbs.rebuild_within, self.length, self.degree, self.ends)


class SPLINEWRIGHT_OT_fair(_Fitted, bpy.types.Operator):
    bl_idname = "splinewright.fair"
    bl_label = "Fair"
    bl_description = ("Move control points so that the curve bends as little as a tolerance allows; knots and weights stay")
    done, already = "Faired {}", "no other curve within the tolerance bends less"

    tolerance: tolerance_property("How far the curve may move", 0.01, least=1e-12)

    def settings(self):
        return ['tolerance', 'keep_tangents']

    def verb_with(self):
        return partial(verbs.fair, self.length, self.ends)


class SPLINEWRIGHT_OT_split_curve(_AtParameter, bpy.types.Operator):
    bl_idname = "splinewright.split_curve"
    bl_label = "Split"
    bl_description = "Cut curves into more pieces of the same shape; a periodic curve is opened"
    done = "Split {}"

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('KNOTS', "At Every Knot", "At every inner knot; a periodic curve also at its seam"),
        ('FLAT', "Until Flat", "By halves, into Bezier curves that lie within the tolerance of their chords")))
    parameter: parameter_property("Parameter", "Parameter u on the curve")
    tolerance: tolerance_property("How far a part may lie from its chord", 0.01, least=1e-9)

    @property
    def already(self):
        return "it is flat already" if self.where == 'FLAT' else "there is no inner knot to split at"

    def settings(self):
        return ['where', *{'PARAMETER': ['parameter'], 'KNOTS': [], 'FLAT': ['tolerance']}[self.where]]

    def verb(self):
        if self.where == 'FLAT':
            return verbs.split_until_flat(self.length)
        return verbs.split_at_knots() if self.where == 'KNOTS' else verbs.split(self.parameter)


class SPLINEWRIGHT_OT_reparametrise(pieces.Reparametrises, OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.reparametrise"
    bl_label = "Reparametrise"
    bl_description = "Give the curve another domain, or another speed along it; it stays the same"
    done, already = "Reparametrised {}", "the parameters are these already"

    def settings(self):
        return self.how_settings()

    def verb(self):
        return self.change()


class SPLINEWRIGHT_OT_make_periodic(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.make_periodic"
    bl_label = "Make Periodic"
    bl_description = ("Make a closed curve periodic, as smooth at its seam as it is; "
                      "a gap within the tolerance is closed")
    done, already = "Made {} periodic", "it is periodic already"
    bl_options = {'REGISTER', 'UNDO'}
    has_scene_tolerance = True

    tolerance: scene_tolerance_property("How far the ends may lie apart, and the curve move")

    def verb(self):
        return verbs.make_periodic(self.length)


class SPLINEWRIGHT_OT_project_curve(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.project_curve"
    bl_label = "Take Perspective Image"
    bl_description = ("Project curves from a point onto their object's plane z = 0: a rational curve with other weights, "
                      "exact. Called from a menu, the point is the active camera")
    bl_options = {'REGISTER', 'UNDO'}
    done = "Projected {}"

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


class SPLINEWRIGHT_OT_to_hermite(OnCurves, bpy.types.Operator):
    bl_idname = "splinewright.to_hermite"
    bl_label = "Convert To Hermite"
    bl_description = ("Make curves of degree 3 or less Hermite chains: exactly where they have no weights, "
                      "conics within a tolerance, and report how far they moved")
    done, already = "Made {} Hermite", "it is Hermite already"
    bl_options = {'REGISTER', 'UNDO'}
    has_scene_tolerance = True

    tolerance: scene_tolerance_property("How far cubics may lie from a conic")

    def verb(self):
        return verbs.to_hermite(self.length)


_PLAIN = tuple(pieces.plain(OnCurves, *row) for row in (
    ('reverse', "Reverse", "Reverse the direction of curves; their domain stays",
     "Reversed {}", "it is the same in both directions", verbs.reverse),
    ('standard_form', "Bring To Standard Form",
     "Change the parameter so that both end weights are 1; the curve stays the same",
     "Brought {} to standard form", "the end weights are 1 already", verbs.standard_form),
    ('clamp', "Clamp", "Make the curve begin and end at its first and last control points; it stays the same. "
     "A periodic one is cut at its seam",
     "Clamped {}", "it begins and ends in its outer points already", verbs.clamp),
    ('unclamp', "Unclamp", "Spread the knots at the ends, so that the curve touches no end point; it stays the same. "
     "A periodic one is opened",
     "Unclamped {}", "its knots go on outside the domain already", verbs.unclamp),
    ('to_bezier_chain', "Convert To Bezier Chain",
     "Convert every span to a Bezier curve of its own; the shape stays the same",
     "Made {} Bezier curves", "its pieces are Bezier curves already", verbs.to_bezier_chain),
    ('to_nurbs', "Convert To NURBS", "Convert Bezier curves and Hermite chains to NURBS curves; they stay the same",
     "Made {} NURBS", "it is NURBS already", verbs.to_nurbs)))

CLASSES = (SPLINEWRIGHT_OT_insert_knot, SPLINEWRIGHT_OT_remove_knot, SPLINEWRIGHT_OT_remove_knots,
           SPLINEWRIGHT_OT_raise_degree, SPLINEWRIGHT_OT_lower_degree, SPLINEWRIGHT_OT_rebuild,
           SPLINEWRIGHT_OT_fair, SPLINEWRIGHT_OT_split_curve,
           SPLINEWRIGHT_OT_reparametrise, SPLINEWRIGHT_OT_make_periodic, SPLINEWRIGHT_OT_project_curve,
           SPLINEWRIGHT_OT_to_hermite, *_PLAIN)
