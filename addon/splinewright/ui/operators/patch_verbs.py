"""Verbs of patch shapes: knots, degree, parts, parameters, ends and kinds, in Object Mode.

They are those of curves, done along u, along v, or along both, one after the other.
"""

from functools import partial

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty

from ...bridge import replacing, settings
from ...core import parameters, patch_verbs, verbs
from .. import hand
from . import pieces
from .pieces import parameter_property, scene_tolerance_property, times_property, tolerance_property

_AXES = {'U': 'u', 'V': 'v', 'BOTH': 'uv'}


def direction_property(u="Along u", v="Along v", both="Along u, then along v"):
    return EnumProperty(name="Direction", items=(('U', "U", u), ('V', "V", v), ('BOTH', "Both", both)))


class OnPatches(pieces.OnPieces):
    """Does verb() with pieces of every selected patch shape."""

    needs, expanded = "Select a patch shape", ('direction',)
    fits = staticmethod(replacing.is_patch_shape)


class _Along(OnPatches):
    """Does verb_along() along each chosen axis."""

    direction: direction_property()

    @property
    def axes(self):
        return _AXES[self.direction]

    def verb_along(self, axis, spent):
        """The verb of core.verbs for an axis, of which `spent` is the error made along the one before."""
        raise NotImplementedError

    def verb(self):
        return patch_verbs.along(self.axes, self.verb_along)

    def settings(self):
        return ['direction', *super().settings()]


class _WithNeighbors(_Along):
    """What it does to one patch it does to those that share borders with it, too, so that none comes open."""

    neighbors: BoolProperty(name="With Neighbors", default=True,
                            description="Do it to the patches that share a border with the piece, too, row after row: none comes open")

    def verb_carried(self, axis, carry, spent):
        """verb_along() of a neighbor; carry takes parameters along an axis of the piece to those of the neighbor."""
        raise NotImplementedError

    def settings(self):
        return [*super().settings(), 'neighbors']

    def work(self, context, ob):
        if not self.piece or not self.neighbors or hand.count_of(ob.data) < 2:
            return super().work(context, ob)
        outcome = replacing.do_each(ob.data, self._verbs, self.already)
        self._note(ob, outcome[1])
        return outcome

    def _verbs(self, definition):
        verbs.require_piece(definition.pieces, self.piece)
        return patch_verbs.with_neighbors(definition, self.piece - 1, self.axes, self.verb_carried)


class AtParameters(pieces.FromActive):
    """Begins with the parameters that fit the active patch."""

    asked = ('parameter_u', 'parameter_v')
    first_parameter = staticmethod(parameters.middle)

    parameter_u: parameter_property("U", "Parameter u on the patch")
    parameter_v: parameter_property("V", "Parameter v on the patch")

    def first_values(self, patch):
        return patch_verbs.first_parameters(patch, self.first_parameter)

    def parameter(self, axis):
        return getattr(self, f"parameter_{axis}")

    def parameters(self):
        """Names of the properties that are asked for."""
        return [f"parameter_{axis}" for axis in _AXES[self.direction]]


class _WithinTolerance(pieces.WithinTolerance):
    """What the first axis has left of the tolerance is the second one's."""

    def left(self, spent):
        return None if self.allowed is None else max(self.allowed - spent, 0.0)


class SPLINEWRIGHT_OT_patch_insert_knot(AtParameters, _WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.patch_insert_knot"
    bl_label = "Insert Knot"
    bl_description = "Add a knot, and with it a row of control points; the patch stays the same"
    done = "Inserted knots into {}"

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('SPANS', "In Every Span", "In the middle of every span")))
    times: times_property("How many copies of the knot are added")

    first_parameter = staticmethod(parameters.middle_of_widest_span)

    def settings(self):
        return ['direction', 'where', *(self.parameters() if self.where == 'PARAMETER' else []), 'times',
                'neighbors']

    def verb_along(self, axis, spent):
        return self.verb_carried(axis, float, spent)

    def verb_carried(self, axis, carry, spent):
        if self.where == 'SPANS':
            return verbs.insert_span_middles(self.times)
        return verbs.insert_knot(carry(self.parameter(axis)), self.times)


class SPLINEWRIGHT_OT_patch_remove_knot(_WithinTolerance, AtParameters, _Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_remove_knot"
    bl_label = "Remove Knot"
    bl_description = ("Remove copies of an inner knot with the least change of the control points, and report how far the "
                      "patch moved")
    done = "Removed a knot of {}"

    nearest: BoolProperty(name="Nearest", description="Take the inner knot that is nearest to the parameter; "
                          "otherwise there must be one at it", default=True)
    times: times_property("How many copies of the knot are taken away")

    def settings(self):
        return ['direction', *self.parameters(), 'nearest', 'times', *self.limits()]

    def verb_along(self, axis, spent):
        return verbs.remove_knot(self.parameter(axis), self.nearest, self.times, self.left(spent))


class SPLINEWRIGHT_OT_patch_remove_knots(_Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_remove_knots"
    bl_label = "Remove Knots"
    bl_description = ("Remove every inner knot whose removal moves the patch by no more than a tolerance; "
                      "a Hermite patch becomes NURBS")
    done, already = "Removed knots of {}", "no knot can go within the tolerance"

    tolerance: tolerance_property("Largest distance that is allowed", 1e-6)

    def verb_along(self, axis, spent):
        return verbs.remove_knots(max(self.length - spent, 0.0))


class SPLINEWRIGHT_OT_patch_raise_degree(_WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.patch_raise_degree"
    bl_label = "Raise Degree"
    bl_description = "Give the patch a higher degree and more control points; it stays the same"
    done = "Raised the degree of {}"

    times: times_property("By how much the degree is raised")

    def verb_along(self, axis, spent):
        return verbs.raise_degree(self.times)

    def verb_carried(self, axis, carry, spent):
        return verbs.raise_degree(self.times)


class SPLINEWRIGHT_OT_patch_lower_degree(_WithinTolerance, _Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_lower_degree"
    bl_label = "Lower Degree"
    bl_description = "Replace the patch by the nearest one of a lower degree, and report how far that lies from it"
    done = "Lowered the degree of {}"

    times: times_property("By how much the degree is lowered")

    def settings(self):
        return ['direction', 'times', *self.limits()]

    def verb_along(self, axis, spent):
        return verbs.lower_degree(self.times, self.left(spent))


class SPLINEWRIGHT_OT_patch_rebuild(pieces.LongOnPieces, OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.patch_rebuild"
    bl_label = "Rebuild"
    bl_description = ("Replace the patch by the nearest one with so many points on even knots, and report how far that lies "
                      "from it; corners stay, and degree + 1 points make one span")
    done, already = "Rebuilt {}", "its points and knots are these already"

    count_u: IntProperty(name="Points U", description="How many control points each patch gets along u", default=8, min=2,
                         soft_max=100)
    count_v: IntProperty(name="V", description="How many control points each patch gets along v", default=8, min=2,
                         soft_max=100)
    degree_u: IntProperty(name="Degree U", description="Of the new patch along u", default=3, min=1, soft_max=9)
    degree_v: IntProperty(name="V", description="Of the new patch along v", default=3, min=1, soft_max=9)

    def verb_with(self):
        return partial(patch_verbs.rebuild, (self.count_u, self.count_v), (self.degree_u, self.degree_v))


class SPLINEWRIGHT_OT_patch_fair(pieces.LongOnPieces, OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.patch_fair"
    bl_label = "Fair"
    bl_description = ("Move inner control points so that the patch bends as little as a tolerance allows; "
                      "borders, knots and weights stay")
    done, already = "Faired {}", "no other patch within the tolerance bends less"

    tolerance: tolerance_property("How far the patch may move", 0.01, least=1e-12)
    keep_tangents: BoolProperty(name="Keep Border Tangents", description="Patches go on as smoothly across their borders: "
                                "the derivatives there stay")

    def verb_with(self):
        return partial(patch_verbs.fair, self.length, 'tangents' if self.keep_tangents else 'points')


class SPLINEWRIGHT_OT_patch_split(AtParameters, _WithNeighbors, bpy.types.Operator):
    bl_idname = "splinewright.patch_split"
    bl_label = "Split"
    bl_description = ("Cut patches into more pieces of the same shape, which share the points of the cut; "
                      "a periodic patch is opened")
    done, already = "Split {}", "there is no inner knot to split at"

    where: EnumProperty(name="Where", items=(
        ('PARAMETER', "At Parameter", "At one parameter"),
        ('KNOTS', "At Every Knot", "At every inner knot; a periodic patch also at its seam")))

    def settings(self):
        return ['direction', 'where', *(self.parameters() if self.where == 'PARAMETER' else []), 'neighbors']

    def verb_along(self, axis, spent):
        return self.verb_carried(axis, float, spent)

    def verb_carried(self, axis, carry, spent):
        return verbs.split_at_knots() if self.where == 'KNOTS' else verbs.split(carry(self.parameter(axis)))


class SPLINEWRIGHT_OT_patch_reverse(_Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_reverse"
    bl_label = "Reverse"
    bl_description = ("Reverse patches along u, v or both; their domain stays. Along one of them this flips their normals, "
                      "along both it does not")
    done, already = "Reversed {}", "it is the same in both directions"

    def verb_along(self, axis, spent):
        return verbs.reverse()


class SPLINEWRIGHT_OT_patch_swap(OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.patch_swap"
    bl_label = "Swap U and V"
    bl_description = "Exchange both directions of patches, which turns their normals; the shape stays the same"
    bl_options = {'REGISTER', 'UNDO'}
    done, already = "Swapped u and v of {}", "u and v are the same"

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


class SPLINEWRIGHT_OT_patch_reparametrise(pieces.Reparametrises, _Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_reparametrise"
    bl_label = "Reparametrise"
    bl_description = "Give the patch another domain, or another speed across it; it stays the same"
    done, already = "Reparametrised {}", "the parameters are these already"

    def settings(self):
        return ['direction', *self.how_settings()]

    def verb_along(self, axis, spent):
        return self.change()


class SPLINEWRIGHT_OT_patch_clamp(_Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_clamp"
    bl_label = "Clamp"
    bl_description = ("Make the patch begin and end at its outer control points; it stays the same. "
                      "A periodic one is cut at its seam")
    done, already = "Clamped {}", "it begins and ends in its outer points already"

    def verb_along(self, axis, spent):
        return verbs.clamp()


class SPLINEWRIGHT_OT_patch_unclamp(_Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_unclamp"
    bl_label = "Unclamp"
    bl_description = ("Spread the knots at the ends, so that the patch touches no outer point; it stays the same, "
                      "and shares no points with its neighbours any more. A periodic one is opened")
    done, already = "Unclamped {}", "its knots go on outside the domain already"

    def verb_along(self, axis, spent):
        return verbs.unclamp()


class SPLINEWRIGHT_OT_patch_make_periodic(_Along, bpy.types.Operator):
    bl_idname = "splinewright.patch_make_periodic"
    bl_label = "Make Periodic"
    bl_description = ("Make a closed patch periodic, as smooth at its seam as it is; "
                      "a gap within the tolerance is closed")
    done, already = "Made {} periodic", "it is periodic already"
    has_scene_tolerance = True

    tolerance: scene_tolerance_property("How far the ends may lie apart, and the patch move")

    def verb_along(self, axis, spent):
        return verbs.make_periodic(max(self.length - spent, 0.0))


_PLAIN = tuple(pieces.plain(OnPatches, *row) for row in (
    ('patch_to_bezier', "Convert To Bezier Patches",
     "Convert every span to a Bezier patch of its own; the shape stays the same, and neighbors share their points",
     "Made {} Bezier patches", "its pieces are Bezier patches already", patch_verbs.to_bezier),
    ('patch_to_hermite', "Convert To Hermite",
     "Make patches of degree 3 or less without weights Hermite patches; they stay the same",
     "Made {} Hermite", "it is Hermite already", patch_verbs.to_hermite),
    ('patch_to_nurbs', "Convert To NURBS", "Convert Bezier and Hermite patches to NURBS patches; they stay the same",
     "Made {} NURBS", "it is NURBS already", patch_verbs.to_nurbs)))

CLASSES = (SPLINEWRIGHT_OT_patch_insert_knot, SPLINEWRIGHT_OT_patch_remove_knot, SPLINEWRIGHT_OT_patch_remove_knots,
           SPLINEWRIGHT_OT_patch_raise_degree, SPLINEWRIGHT_OT_patch_lower_degree, SPLINEWRIGHT_OT_patch_rebuild,
           SPLINEWRIGHT_OT_patch_fair, SPLINEWRIGHT_OT_patch_split,
           SPLINEWRIGHT_OT_patch_reverse, SPLINEWRIGHT_OT_patch_swap, SPLINEWRIGHT_OT_patch_reparametrise,
           SPLINEWRIGHT_OT_patch_clamp, SPLINEWRIGHT_OT_patch_unclamp, SPLINEWRIGHT_OT_patch_make_periodic, *_PLAIN)
