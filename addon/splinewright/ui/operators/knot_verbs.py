"""Verbs of curves, done along directions of patches, too: knots, degree, parts, parameters and ends."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ...bridge.data import settings
from ...core.base.failures import Refusal
from ...core.shape import parameters
from ...core.verbs import patch_verbs, verbs
from . import pieces
from .on_shapes import AlongShapes, AtShapeParameters, OnPatches, WithNeighbors, WithinTolerance, along
from .pieces import scene_tolerance_property, times_property, tolerance_property


class SPLINEWRIGHT_OT_insert_knot(AtShapeParameters, WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.insert_knot"
    bl_label = "Insert Knot"
    bl_description = "Add a knot, and with it control points; the shape stays the same"
    done = "Inserted knots into {what}"

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('SPANS', "In Every Span", "In the middle of every span")))
    times: times_property("How many copies of the knot are added")

    first_parameter = staticmethod(parameters.middle_of_widest_span)

    def all_settings(self):
        return ['direction', 'where', *(self.parameters() if self.where == 'PARAMETER' else []), 'times', 'neighbors']

    def verb_along(self, axis, carry, spent):
        if self.where == 'SPANS':
            return verbs.insert_span_middles(self.times)
        return verbs.insert_knot(carry(self.parameter(axis)), self.times)


class SPLINEWRIGHT_OT_remove_knot(WithinTolerance, AtShapeParameters, AlongShapes, bpy.types.Operator):
    bl_idname = "splinewright.remove_knot"
    bl_label = "Remove Knot"
    bl_description = "Remove an inner knot, move the control points as little as possible, and report how far the shape moved"
    done = "Removed a knot of {what}"

    nearest: BoolProperty(name="Nearest", description="Take the inner knot that is nearest to the parameter; "
                          "otherwise there must be one at it", default=True)
    times: times_property("How many copies of the knot are removed")

    def all_settings(self):
        return ['direction', *self.parameters(), 'nearest', 'times', *self.limits()]

    def verb_along(self, axis, carry, spent):
        return verbs.remove_knot(self.parameter(axis), self.nearest, self.times, self.left(spent))


class SPLINEWRIGHT_OT_remove_knots(AlongShapes, bpy.types.Operator):
    bl_idname = "splinewright.remove_knots"
    bl_label = "Remove Redundant Knots"
    bl_description = "Remove every inner knot that can go within a tolerance; Hermite shapes become NURBS"
    done, already = "Removed knots of {what}", "no knot can go within the tolerance"

    tolerance: tolerance_property("Largest distance that is allowed", 1e-6)

    def verb_along(self, axis, carry, spent):
        return verbs.remove_knots(max(self.length - spent, 0.0))


class SPLINEWRIGHT_OT_raise_degree(WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.raise_degree"
    bl_label = "Elevate Degree"
    bl_description = "Give the shape a higher degree and more control points; it stays the same"
    done = "Elevated the degree of {what}"

    times: times_property("By how much the degree is elevated")

    def verb_along(self, axis, carry, spent):
        return verbs.raise_degree(self.times)


class SPLINEWRIGHT_OT_lower_degree(WithinTolerance, AlongShapes, bpy.types.Operator):
    bl_idname = "splinewright.lower_degree"
    bl_label = "Reduce Degree"
    bl_description = "Find the nearest shape of a lower degree, and report how far it lies from the present one"
    done = "Reduced the degree of {what}"

    times: times_property("By how much the degree is reduced")

    def all_settings(self):
        return ['direction', 'times', *self.limits()]

    def verb_along(self, axis, carry, spent):
        return verbs.lower_degree(self.times, self.left(spent))


class SPLINEWRIGHT_OT_split(AtShapeParameters, WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.split"
    bl_label = "Split"
    bl_description = "Cut curves or patches into pieces of the same shape; a periodic one is opened"
    done = "Split {what}"
    of_curves = ('tolerance',)

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('KNOTS', "At Every Knot", "At every inner knot, and at the seam of a periodic shape"),
        ('FLAT', "Until Flat", "Curves, by halves, into Bezier curves that lie within the tolerance of their chords")))
    tolerance: tolerance_property("How far a part may lie from its chord", 0.01, least=1e-9)

    @property
    def already(self):
        return "it is flat already" if self.where == 'FLAT' else "there is no inner knot to split at"

    def all_settings(self):
        return ['direction', 'where', *{'PARAMETER': self.parameters(), 'KNOTS': [], 'FLAT': ['tolerance']}[self.where],
                'neighbors']

    def verb_on(self, is_curve):
        if self.where != 'FLAT':
            return super().verb_on(is_curve)
        if not is_curve:
            raise Refusal("patches are split at parameters or knots, not until they are flat")
        return verbs.split_until_flat(self.length)

    def verb_along(self, axis, carry, spent):
        return verbs.split_at_knots() if self.where == 'KNOTS' else verbs.split(carry(self.parameter(axis)))


class SPLINEWRIGHT_OT_reparameterize(pieces.Reparameterizes, AlongShapes, bpy.types.Operator):
    bl_idname = "splinewright.reparameterize"
    bl_label = "Reparameterize"
    bl_description = "Change the domain of a shape, or its speed along it; the shape stays the same"
    done, already = "Reparameterized {what}", "the parameters are these already"

    def all_settings(self):
        return ['direction', *self.how_settings()]

    def verb_along(self, axis, carry, spent):
        return self.change()


class SPLINEWRIGHT_OT_make_periodic(AlongShapes, bpy.types.Operator):
    bl_idname = "splinewright.make_periodic"
    bl_label = "Make Periodic"
    bl_description = "Make a closed shape periodic, as smooth at its seam as it is; a gap within the tolerance is closed"
    done, already = "Made {what} periodic", "it is periodic already"
    has_scene_tolerance = True

    tolerance: scene_tolerance_property("How far the ends may lie apart, and the shape move")

    def verb_along(self, axis, carry, spent):
        return verbs.make_periodic(max(self.length - spent, 0.0))


class SPLINEWRIGHT_OT_swap_uv(OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.swap_uv"
    bl_label = "Swap U and V"
    bl_description = "Exchange both directions of patches, which flips their normals; the shape stays the same"
    bl_options = {'REGISTER', 'UNDO'}
    done, already = "Swapped u and v of {what}", "u and v are the same"

    def verb(self):
        return patch_verbs.swap()

    def work(self, context, ob):
        """The resolutions are exchanged with the directions, where all are."""
        outcome, chosen = super().work(context, ob), settings.of(ob.data)
        if self.piece == 0 or len(outcome[0].pieces) == 1:
            if chosen.mode == settings.COUNT:
                settings.set_resolution(ob.data, chosen.resolution_v, chosen.resolution_u)
            else:
                settings.exchange_resolutions(ob.data)
        return outcome


_ALONG = (
    along('reverse', "Switch Direction", "Let curves or patches run the other way; in one direction of patches this flips their normals",
          "Switched the direction of {what}", "it is the same in both directions", verb=verbs.reverse),
    along('clamp', "Clamp Ends", "Let the shape begin and end in its outer control points; a periodic one is cut at its seam",
          "Clamped {what}", "it begins and ends in its outer points already", verb=verbs.clamp),
    along('unclamp', "Unclamp Ends", "Spread the knots at the ends, so that the shape touches no outer point; a periodic one is opened",
          "Unclamped {what}", "its knots continue outside the domain already", verb=verbs.unclamp))

CLASSES = (SPLINEWRIGHT_OT_insert_knot, SPLINEWRIGHT_OT_remove_knot, SPLINEWRIGHT_OT_remove_knots,
           SPLINEWRIGHT_OT_raise_degree, SPLINEWRIGHT_OT_lower_degree, SPLINEWRIGHT_OT_split,
           SPLINEWRIGHT_OT_reparameterize, SPLINEWRIGHT_OT_make_periodic, SPLINEWRIGHT_OT_swap_uv, *_ALONG)
