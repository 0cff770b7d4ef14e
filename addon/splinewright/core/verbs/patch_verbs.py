"""Verbs of patches: those of curves, done along an axis, and those that take a patch as a whole.

What a verb is says core.verbs.verbs. An axis is 'u' or 'v'; axes are 'u', 'v' or 'uv'.
"""

from functools import partial

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import parameters, places, shared_knots
from ..shape.definition import CURVES
from . import verbs

_PAIRS = ('degree', 'domain', 'knots', 'periodic')


class Along:
    """A patch as the verbs of curves see it: as a curve along one of its axes.

    stretches: of core.shape.places, where it lies along that axis on the patch that a verb was asked to change.
    """

    def __init__(self, patch, axis, stretches=places.WHOLE):
        self.patch, self.axis, self.stretches = patch, axis, stretches

    def __getattr__(self, name):
        if name in _PAIRS:
            return getattr(self.patch, name)['uv'.index(self.axis)]
        method = getattr(self.patch, name)
        return lambda *arguments: self._of(method(self.axis, *arguments))

    def __eq__(self, other):
        return self.axis == other.axis and self.patch == other.patch

    def to_nurbs(self):
        return self._of(self.patch.to_nurbs())

    def reversed(self):
        return Along(self.patch.reversed(self.axis), self.axis, places.reversed_(self.stretches))

    def moebius(self, rho):
        return Along(self.patch.to_nurbs().moebius(self.axis, rho), self.axis, places.sped(self.stretches, rho))

    def split(self, at):
        parts, (start, end) = self.patch.split(self.axis, at), self.domain
        fraction = (at - start) / (end - start)
        if len(parts) == 1:
            return [Along(parts[0], self.axis, places.opened(self.stretches, fraction))]
        return [Along(part, self.axis, places.cut(self.stretches, *ends))
                for part, ends in zip(parts, ((0.0, fraction), (fraction, 1.0)))]

    def _of(self, result):
        if isinstance(result, sc.Approximation):
            return verbs.Near(self._of(result.value), result.error)
        if isinstance(result, sc.NurbsPatch) and min(result.points.shape[:2]) < 2:
            raise Refusal("within that tolerance nothing of it would be left")
        return Along(result, self.axis, self.stretches)


def along(axes, make):
    """make(axis, spent): the verb of core.verbs.verbs for an axis; `spent` is the error that was made along the one before.

    Raises what that raises, naming the axis where there are two.
    """
    def verb(patch):
        parts, errors = [verbs.Part(patch, places.Place())], []
        for axis in axes:
            try:
                parts, error = _along_one(parts, axis, make(axis, sum(errors)))
            except (Refusal, sc.Error) as error:
                if len(axes) == 1:
                    raise
                raise type(error)(phrase("along {axis}: {error}", axis=axis, error=error)) from error
            errors.append(error)
        return parts if len(parts) > 1 else verbs.Near(parts[0], _total(errors, patch, parts[0].value))
    return verb


def with_neighbors(definition, number, axes, make):
    """{number of a patch from 0: verb}: along() of a patch, and of all that are to be cut with it so that borders that were shared
    are shared.

    make(axis, carry, spent): the verb of core.verbs.verbs; carry takes parameters of the patch to those of the current one.
    """
    own, made = definition.pieces[number], {}
    for axis in axes:
        for along_one in shared_knots.together(definition, number, 'uv'.index(axis), has_cuts=True):
            piece = definition.pieces[along_one.piece]
            knots = shared_knots.knots_of(own, 'uv'.index(axis)), shared_knots.knots_of(piece, along_one.axis)
            carry = partial(_carried, *knots, along_one.is_turned)
            made.setdefault(along_one.piece, {})['uv'[along_one.axis]] = partial(make, axis, carry)
    return {i: along(''.join(sorted(of_axes)), lambda axis, spent, of_axes=of_axes: of_axes[axis](spent))
            for i, of_axes in made.items()}


def _carried(old, others, is_turned, parameter):
    return parameters.Exact(shared_knots.carried(parameters.snapped(parameter, old), old, others, is_turned))


def _along_one(parts, axis, verb):
    """(the verbs.Part that stand for these, the largest error)."""
    after, worst = [], 0.0
    for part in parts:
        result = verb(Along(part.value, axis))
        if isinstance(result, verbs.Near):
            result, worst = result.value, max(worst, result.error)
        after += [verbs.Part(along.patch, part.place._replace(**{axis: along.stretches}))
                  for along in (result if isinstance(result, list) else [result])]
    return after, worst


def _total(errors, before, after):
    """The distance of two patches, which those along both axes bound together."""
    if len([error for error in errors if error > 0]) < 2:
        return sum(errors)
    return min(sum(errors), before.to_nurbs().largest_distance(after.to_nurbs()))


def first_parameters(piece, first):
    """(u, v), or (u,) of a curve: what a function of core.shape.parameters finds along each axis."""
    if isinstance(piece, CURVES):
        return (first(piece),)
    return tuple(first(Along(piece, axis)) for axis in 'uv')


# The whole patch -----------------------------------------------------------------------------------


def swap():
    return lambda patch: [verbs.Part(patch.swapped(), places.Place(is_swapped=True))]


def rebuild(counts, degrees, cancel=None):
    """Numbers of control points and degrees along u and v. cancel: as the library takes it."""
    def verb(patch):
        made = patch.to_nurbs().rebuild(counts, degrees, cancel=cancel)
        return verbs.Near(verbs.Part(made.value, places.Place()), made.error)
    return verb


def fair(tolerance, ends, cancel=None):
    """ends: 'points', borders stay, or 'tangents', the derivatives across them, too. cancel: as the library takes it."""
    def verb(patch):
        given = patch.to_nurbs()
        made = given.fair(tolerance, ends=ends, cancel=cancel)
        if made.value == given:
            return patch
        return verbs.Near(verbs.Part(made.value, places.Place()), made.error)
    return verb


def to_bezier():
    """In rows along v."""
    def verb(patch):
        spans_u, spans_v = ([places.cut(places.WHOLE, *ends) for ends in parameters.spans_of(Along(patch, axis))]
                            for axis in 'uv')
        return [verbs.Part(part, places.Place(u, v)) for row, u in zip(patch.to_bezier(), spans_u)
                for part, v in zip(row, spans_v)]
    return verb


def to_hermite():
    return lambda patch: patch if isinstance(patch, sc.HermitePatch) else patch.to_hermite()


def to_nurbs():
    return lambda patch: patch.to_nurbs()
