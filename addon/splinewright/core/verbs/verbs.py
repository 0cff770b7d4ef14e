"""Verbs, on the pieces of a definition; those of curves, which core.verbs.patch_verbs does along an axis of a patch, too.

A verb takes a core.shape.traced.Traced curve or a patch and gives one, a list of those that stand for it, or Near; a patch
that lies elsewhere than its parent is a Part.
Each of the functions below gives a verb. What a kind of curve cannot do, its NURBS form does. A tolerance is a length.
"""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..shape import parameters, places, sewing
from ..shape.traced import Near, Traced, bare


class Part(NamedTuple):
    """A curve or patch that stands for another or a part of it, and its core.shape.places.Place there."""

    value: object
    place: object


class Changed(NamedTuple):
    """What became of a definition."""

    definition: definitions.Definition
    parents: tuple              # for each piece, the number of the piece it came from, counted from 0
    error: float                # how far the shape is from what it was, at most; 0 where nothing but rounding was lost
    places: tuple = ()          # for each patch, its core.shape.places.Place on the one it came from
    origins: tuple = ()         # for each curve, the core.shape.places.Origins of what it consists of


def changed(definition, number, verb, already="nothing changes"):
    """The Changed definition, after a verb was done with one piece, counted from 1, or with all where `number` is 0.

    Raises Refusal or an error of the library, naming the piece where there are several, if one refuses; ValueError
    with the sentence `already` if every piece came out as it went in.
    """
    count = len(definition.pieces)
    require_piece(definition.pieces, number, least=0)
    return each_changed(definition, {i: verb for i in range(count) if number in (0, i + 1)}, already)


def each_changed(definition, verbs, already="nothing changes"):
    """changed() with verbs by the numbers of pieces, counted from 0."""
    before = pieces_of(definition)
    parts, parents, error = [], [], 0.0
    for i, value in enumerate(before):
        values, piece_error = _done(verbs[i], value, i, len(before)) if i in verbs else ([value], 0.0)
        parts += map(_part, values)
        parents += [i] * len(values)
        error = max(error, piece_error)
    after = [part.value for part in parts]
    if after == before:
        raise Refusal(already)
    return _as_changed(definition, after, parents, error, parts)


def one_for_one(definition, after, error):
    """The Changed definition in which each piece is another one."""
    return _as_changed(definition, after, list(range(len(after))), error, list(map(_part, after)))


def _as_changed(definition, after, parents, error, parts):
    lie = tuple(part.place for part in parts)
    if not definition.has_curves:
        return Changed(sewing.sewn(definition, after, parents), tuple(parents), error, lie)
    origins = tuple((places.Origin(parent, place.u),) for parent, place in zip(parents, lie))
    return Changed(_of_curves(definition, after), tuple(parents), error, origins=origins)


def kept(definition, numbers):
    """The Changed definition of these pieces alone, counted from 0, on their points to the last digit. Raises Refusal for none."""
    if not numbers:
        raise Refusal("that is all of it: delete the object")
    pieces = [definition.pieces[i] for i in numbers]
    used, where = np.unique(np.concatenate([piece.indices.ravel() for piece in pieces]), return_inverse=True)
    starts = np.cumsum([0, *(piece.indices.size for piece in pieces)])
    own = tuple(replace(piece, indices=where[start:start + piece.indices.size].reshape(piece.indices.shape).astype(np.int32))
                for piece, start in zip(pieces, starts))
    found = replace(definition, pool=definition.pool[used], pieces=own)
    if not definition.has_curves:
        return Changed(found, tuple(numbers), 0.0, (places.Place(),) * len(numbers))
    return Changed(found, tuple(numbers), 0.0, origins=tuple((places.Origin(number),) for number in numbers))


def _part(value):
    if isinstance(value, Traced):
        return Part(value.curve, places.Place(value.stretches))
    return value if isinstance(value, Part) else Part(value, places.Place())


def _of_curves(before, curves):
    return definitions.from_value(curves[0] if before.form == 'curve' and len(curves) == 1 else curves)


def pieces_of(definition):
    """The curves or the patches of a definition, as a list."""
    return curves_of(definition) if definition.has_curves else sewing.patches_of(definition)


def curves_of(definition):
    """The curves of a definition, as a list."""
    value = definitions.to_value(definition)
    return value if isinstance(value, list) else [value]


def require_piece(pieces, number, least=1):
    """Raises Refusal unless there is a piece of this number, counted from 1."""
    count = len(pieces)
    if not least <= number <= count:
        raise Refusal("the shape has {count} pieces, there is none of number {number}",
                      "the shape has {count} piece, there is none of number {number}", count=count, number=number)


def _done(verb, value, i, count):
    """(what stands for a curve or patch, the error)."""
    try:
        result = verb(Traced(value) if isinstance(value, definitions.CURVES) else value)
    except (Refusal, sc.Error) as error:
        if count == 1:
            raise
        raise type(error)(phrase("piece {i}: {error}", i=i + 1, error=error)) from error
    if isinstance(result, Near):
        return [result.value], result.error
    return (result, 0.0) if isinstance(result, list) else ([result], 0.0)


def _capable(curve, name):
    """The curve, or its NURBS form if that alone has the method."""
    return curve if hasattr(curve, name) else curve.to_nurbs()


# Knots ---------------------------------------------------------------------------------------------


def insert_knot(parameter, times):
    def verb(curve):
        return curve.to_nurbs().insert_knot(parameters.snapped(parameter, parameters.knots_of(curve)), times)
    return verb


def insert_span_middles(times):
    return lambda curve: curve.to_nurbs().refine(np.repeat(parameters.span_middles(curve), times))


def remove_knot(parameter, is_nearest, times, tolerance):
    """is_nearest: the inner knot nearest to the parameter is meant. tolerance: or None."""
    def verb(curve):
        knot = parameters.snapped(parameter, parameters.knots_of(curve))
        if is_nearest:
            knot = _nearest_removable(curve, knot)
        return curve.to_nurbs().remove_knot(knot, times, tolerance)
    return verb


def _nearest_removable(curve, parameter):
    knots = parameters.inner_knots(curve)
    if not len(knots):
        raise Refusal("there is no inner knot")
    return float(knots[np.abs(knots - parameter).argmin()])


def remove_knots(tolerance):
    """Of Bezier curves, which have none, nothing; other curves stay as they are where no knot can go."""
    def verb(curve):
        nurbs = curve.to_nurbs()
        result = nurbs.remove_knots(tolerance)
        return curve if result.value == nurbs else result
    return verb


# Degree --------------------------------------------------------------------------------------------


def raise_degree(times):
    return lambda curve: _capable(curve, 'elevate').elevate(times)


def lower_degree(times, tolerance):
    """tolerance: or None."""
    def verb(curve):
        result = _capable(curve, 'reduce').reduce(times)
        if isinstance(bare(curve), sc.BezierCurve):
            # Its own error adds up those of all steps.
            result = Near(result.value, curve.to_nurbs().largest_distance(result.value.to_nurbs()))
        if tolerance is not None and result.error > tolerance:
            raise Refusal("the degree cannot be lowered within {tolerance}: the error would be {error}",
                          tolerance=decimals.text_of(tolerance), error=decimals.text_of(result.error))
        return result
    return verb


# Fit -----------------------------------------------------------------------------------------------


def rebuild(count, degree, ends, cancel=None):
    """With a given number of control points. ends: 'points' of an open curve stay, or 'tangents' also. cancel: as in the library."""
    return lambda curve: curve.to_nurbs().rebuild(count, degree, ends=ends, cancel=cancel)


def rebuild_within(tolerance, degree, ends, cancel=None):
    """With as few control points as come within the tolerance."""
    return lambda curve: curve.to_nurbs().rebuild(None, degree, tolerance=tolerance, ends=ends, cancel=cancel)


def fair(tolerance, ends, cancel=None):
    return lambda curve: curve.to_nurbs().fair(tolerance, ends=ends, cancel=cancel)


# Parts ---------------------------------------------------------------------------------------------


def split(parameter):
    """A periodic curve is opened there."""
    return lambda curve: list(curve.split(parameters.snapped(parameter, parameters.knots_of(curve))))


def split_at_knots():
    """A periodic curve is opened at its seam first."""
    def verb(curve):
        opened = curve.clamped() if getattr(curve, 'periodic', False) else curve
        return _split_at(opened, parameters.inner_knots(opened))
    return verb


def split_until_flat(tolerance):
    """Halved until every part lies within the tolerance of its chord (S6)."""
    def verb(curve):
        parts = [part.to_bezier()[0] for bezier in curve.to_bezier()
                 for part in _split_at(bezier.to_nurbs(), bezier.flatten(tolerance)[0][1:-1])]
        return [curve] if len(parts) == 1 else parts
    return verb


def _split_at(curve, knots):
    """By halves: to cut off one part after the other would copy the rest each time."""
    if not len(knots):
        return [curve]
    middle = len(knots) // 2
    before, after = curve.split(knots[middle])
    return _split_at(before, knots[:middle]) + _split_at(after, knots[middle + 1:])


def reverse():
    return lambda curve: curve.reversed()


# Parameters ----------------------------------------------------------------------------------------


def set_domain(start, end):
    def verb(curve):
        domain = decimals.typed(start), decimals.typed(end)
        return curve if curve.domain == domain else curve.to_nurbs().with_domain(domain)
    return verb


def moebius(rho):
    return lambda curve: _capable(curve, 'moebius').moebius(decimals.typed(rho))


def standard_form():
    return lambda curve: curve.standard_form() if curve.is_rational else curve


# Ends ----------------------------------------------------------------------------------------------


def clamp():
    """Bezier curves and Hermite chains begin and end in their outer points already."""
    return lambda curve: curve.clamped() if _is_nurbs(curve) else curve


def unclamp():
    return lambda curve: curve if _is_unclamped(curve) else curve.to_nurbs().unclamped()


def _is_nurbs(curve):
    return hasattr(curve, 'knots')


def _is_unclamped(curve):
    if not _is_nurbs(curve) or curve.periodic:
        return False
    outer = np.diff(curve.knots)[[*range(curve.degree), *range(-curve.degree, 0)]]
    return bool((outer > 0).all())


def make_periodic(tolerance):
    def verb(curve):
        is_periodic = getattr(curve, 'periodic', False)
        return curve if is_periodic else curve.to_nurbs().to_periodic(tolerance)
    return verb


# Place ---------------------------------------------------------------------------------------------


def project(eye):
    """The image on the plane z = 0, seen from a point: new weights are what the perspective does (S9).

    They are above 0 where the curve lies on one side of the eye, above or below the plane.
    """
    x, y, z = map(decimals.typed, eye)
    matrix = math.copysign(1.0, z) * np.array([[z, 0, -x, 0], [0, z, -y, 0], [0, 0, 0, 0], [0, 0, -1, z]])

    def verb(curve):
        if z == 0.0:
            raise Refusal("the eye lies in the plane of the image, z = 0")
        image = curve.to_nurbs().transformed(matrix)
        return curve.to_nurbs().transformed(-matrix) if image.weights.max() <= 0.0 else image
    return verb


# Kinds ---------------------------------------------------------------------------------------------


def to_bezier_chain():
    return lambda curve: curve.to_bezier()


def to_hermite(tolerance):
    """Of a conic with weights, which no Hermite chain is, cubics within the tolerance."""
    def verb(curve):
        if isinstance(bare(curve), sc.HermiteCurve):
            return curve
        return _conic_as_hermite(bare(curve), tolerance) if _is_conic(curve) else curve.to_hermite()
    return verb


def _is_conic(curve):
    return curve.degree == 2 and bool((curve.weights != curve.weights[0]).any())


def _conic_as_hermite(curve, tolerance):
    try:
        found = sc.conics.as_hermite(curve, tolerance)
        return Near(found.value, found.error)
    except sc.InvalidShape as error:
        raise Refusal("it runs to infinity or has a gap: a Hermite chain is finite and connected") from error


def to_nurbs():
    return lambda curve: curve.to_nurbs()
