"""What verbs of curves and of patches have in common: a curve has one direction, u; a patch has two, and a verb is done along one
of them or along both, one after the other.
"""

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ...bridge.edit import replace_pieces
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.shape import parameters
from ...core.verbs import patch_verbs, verbs
from .. import active_shape
from . import pieces
from .pieces import parameter_property
from .selected import OnSelected

_AXES = {'U': 'u', 'V': 'v', 'BOTH': 'uv'}


def direction_property(u="Along u", v="Along v", both="Along u, then along v"):
    return EnumProperty(name="Direction", items=(('U', "U", u), ('V', "V", v), ('BOTH', "Both", both)))


class OnCurves(pieces.OnPieces):
    """Does verb() with pieces of every selected curve shape."""

    needs = "Select a curve shape"
    fits = staticmethod(replace_pieces.is_curve_shape)


class OnPatches(pieces.OnPieces):
    """Does verb() with pieces of every selected patch shape."""

    needs, expanded = "Select a patch shape", ('direction',)
    fits = staticmethod(replace_pieces.is_patch_shape)


class OnShapes(pieces.OnPieces):
    """Does verb_on() with pieces of every selected shape."""

    needs = "Select a curve or surface shape"
    fits = staticmethod(shape.has_shape)
    #: Of its settings, those that count for curves alone, and for patches alone.
    of_curves, of_patches = (), ()
    #: What settings are called where there are curves alone.
    on_curves_called = {'parameter_u': "Parameter", 'count_u': "Points", 'degree_u': "Degree"}

    def verb_on(self, is_curve):
        """The verb of core.verbs.verbs for curves, or for whole patches."""
        raise NotImplementedError

    def verb_of(self, ob):
        return self.verb_on(replace_pieces.is_curve_shape(ob))

    def kinds(self):
        """Which kinds of shapes are selected: whether they are curves."""
        return set(map(replace_pieces.is_curve_shape, self.chosen(bpy.context)))

    def settings(self):
        kinds = self.kinds()
        left_out = {*(() if True in kinds else self.of_curves), *(() if False in kinds else self.of_patches)}
        return [name for name in self.all_settings() if name not in left_out]

    def all_settings(self):
        """settings() for curves and patches together."""
        return super().settings()

    def labels(self):
        return self.on_curves_called if self.kinds() == {True} else {}


class AlongShapes(OnShapes):
    """Does verb_along() with curves, and with patches along each chosen axis."""

    expanded, of_patches = ('direction',), ('direction',)

    direction: direction_property()

    @property
    def axes(self):
        return _AXES[self.direction]

    def verb_along(self, axis, carry, spent):
        """The verb of core.verbs.verbs for an axis, of which `spent` is the error made along the one before.

        carry: takes parameters along an axis of the piece to those of the one that it is done with.
        """
        raise NotImplementedError

    def verb_on(self, is_curve):
        if is_curve:
            return self.verb_along('u', _as_it_is, 0.0)
        return patch_verbs.along(self.axes, lambda axis, spent: self.verb_along(axis, _as_it_is, spent))

    def all_settings(self):
        return ['direction', *super().all_settings()]


class WithNeighbors(AlongShapes):
    """What it does to one patch it does to those that share borders with it, too, so that none comes open."""

    of_patches = ('direction', 'neighbors')

    neighbors: BoolProperty(name="With Neighbors", default=True, description="Do it to the patches that share a border with the "
                            "piece, too, row after row: none comes open")

    def all_settings(self):
        return [*super().all_settings(), 'neighbors']

    def work(self, context, ob):
        if replace_pieces.is_curve_shape(ob) or not self.piece or not self.neighbors or active_shape.count_of(ob.data) < 2:
            return super().work(context, ob)
        outcome = replace_pieces.do_each(ob.data, self._verbs, self.already)
        self._note(ob, outcome[1])
        return outcome

    def _verbs(self, definition):
        verbs.require_piece(definition.pieces, self.piece)
        return patch_verbs.with_neighbors(definition, self.piece - 1, self.axes, self.verb_along)


def at_exactly(*values):
    """Settings of AtParameters for parameters u and v, or for u of a curve, with every digit."""
    rounded = zip(('parameter_u', 'parameter_v'), map(decimals.single, values))
    return {**dict(rounded), 'exact': " ".join(repr(float(value)) for value in values)}


def _as_it_is(parameter):
    """Of the piece that it is done with itself."""
    return parameter


class AtParameters(pieces.FromActive):
    """Begins with the parameters that fit the active curve or patch."""

    asked = ('parameter_u', 'parameter_v')
    first_parameter = staticmethod(parameters.middle)

    parameter_u: parameter_property("U", "Parameter u")
    parameter_v: parameter_property("V", "Parameter v")
    #: Both, or that of a curve, with every digit: at_exactly() makes it.
    exact: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    def first_values(self, piece):
        return patch_verbs.first_parameters(piece, self.first_parameter)

    def parameter(self, axis):
        """With every digit where another command gave it so, as it does those of a click; until it is changed in the redo panel."""
        texts = dict(zip('uv', self.exact.split()))
        return parameters.given(getattr(self, f"parameter_{axis}"), texts.get(axis, ""))

    def parameters(self):
        """Names of the properties that are asked for."""
        return [f"parameter_{axis}" for axis in _AXES[self.direction]]


class AtShapeParameters(AtParameters):
    """Of a curve, the parameter u counts."""

    def parameters(self):
        kinds = self.kinds()
        axes = {*('u' if True in kinds else ()), *(_AXES[self.direction] if False in kinds else ())}
        return [f"parameter_{axis}" for axis in sorted(axes)]


class WithinTolerance(pieces.WithinTolerance):
    """What the first axis has left of the tolerance is the second one's."""

    def left(self, spent):
        return None if self.allowed is None else max(self.allowed - spent, 0.0)


def plain(base, name, label, description, done, already, options=OnSelected.bl_options, **verb):
    """The operator of a verb without additional settings. verb: the method of the base that gives it."""
    members = {'bl_idname': f"splinewright.{name}", 'bl_label': label, 'bl_description': description, 'bl_options': options,
               'done': done, 'already': already, '__annotations__': {}, **verb}
    return type(f"SPLINEWRIGHT_OT_{name}", (base, bpy.types.Operator), members)


def along(name, *words, verb):
    """plain() of a verb of core.verbs.verbs along each chosen direction."""
    return plain(AlongShapes, name, *words, options=AlongShapes.bl_options, verb_along=lambda self, axis, carry, spent: verb())
