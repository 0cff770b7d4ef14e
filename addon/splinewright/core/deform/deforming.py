"""Exact circles, ellipses, cylinders, spheres, tori and surfaces of revolution become ones to be sculpted: cubic around, smooth
everywhere, without the weights of circles, and within a tolerance of what they were."""

import math
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..verbs import verbs
from . import deformable, turning

_NOTHING = "no circle, ellipse or surface of revolution that is exact is in it: nothing would change"


class Deformed(NamedTuple):
    """What became of a definition."""

    changed: verbs.Changed
    count: int                          # of pieces that are others now
    rational: int                       # of these, how many still have weights, along what does not turn


def deformed(definition, tolerance):
    """The Deformed definition, in which all pieces that turn are deformable. Raises Refusal."""
    before = [piece.to_nurbs() for piece in verbs.pieces_of(definition)]
    found = [_turnings(piece) for piece in before]
    count = sum(map(bool, found))
    if not count:
        raise Refusal(_NOTHING)
    within = _within(tolerance, found)
    made = [_made(piece, of_piece, within) if of_piece else (piece, 0.0) for piece, of_piece in zip(before, found)]
    own = verbs.pieces_of(definition)
    after = [new if of_piece else old for (new, _), of_piece, old in zip(made, found, own)]
    error = max(error for _, error in made)
    rational = sum(bool(of_piece) and bool((new.weights != 1).any()) for (new, _), of_piece in zip(made, found))
    return Deformed(_changed(definition, after, error), count, rational)


def patches(exact, tolerance):
    """(patches to be sculpted, how far they lie from exact ones). Raises Refusal."""
    found = [_turnings(patch) for patch in exact]
    within = _within(tolerance, found)
    made = [_made(patch, of_patch, within) for patch, of_patch in zip(exact, found)]
    return [patch for patch, _ in made], max(error for _, error in made)


def _within(tolerance, found):
    """The largest error of a circle of radius 1, one for all pieces: edges that they share get the same points."""
    largest = max(one.radius for of_piece in found for one in of_piece.values())
    share = tolerance / (max(map(len, found)) * largest)
    return share / (1.0 + share)        # what was made in one direction may be as much larger in the other


def _turnings(piece):
    """{0 for u, 1 for v: turning.Turning} of a curve or patch in NURBS form."""
    found = {axis: turning.turning(*_along(piece, axis)) for axis in range(_axes_of(piece))}
    return {axis: one for axis, one in found.items() if one is not None and math.isfinite(one.radius) and one.radius > 0}


def _axes_of(piece):
    return 1 if isinstance(piece, sc.NurbsCurve) else 2


def _homogeneous(piece):
    """(n, m, 4): control points times their weights; those at infinity as they are."""
    points, weights = piece.points, piece.weights
    rows = np.concatenate([points * np.where(weights != 0, weights, 1.0)[..., None], weights[..., None]], -1)
    return rows if rows.ndim == 3 else rows[:, None]


def _along(piece, axis):
    rows = _homogeneous(piece)
    if _axes_of(piece) == 1:
        return piece.degree, piece.knots, piece.periodic, rows
    return piece.degree[axis], piece.knots[axis], piece.periodic[axis], rows if axis == 0 else rows.swapaxes(0, 1)


def _made(piece, found, within):
    """(the piece with these directions deformable, how far it lies from what it was). within: the largest error of a circle of
    radius 1."""
    error = 0.0
    for axis, one in found.items():
        if axis == 1 and 0 in found:
            one = turning.turning(*_along(piece, 1))
        around = deformable.around(one.start, one.sweep, within, keeps_ends=one.sweep is not None)
        error += around.error * one.radius
        piece = _with(piece, axis, around, one.at(around.points))
    return piece, error


def _with(piece, axis, around, rows):
    """A curve or patch with other knots and control points along an axis, over its domain."""
    domain = piece.domain if _axes_of(piece) == 1 else piece.domain[axis]
    start, end = around.knots[[0, -1]]
    knots = domain[0] + (around.knots - start) * ((domain[1] - domain[0]) / (end - start))
    if axis == 1:
        rows = rows.swapaxes(0, 1)
    weights = rows[..., 3]
    points = rows[..., :3] / np.where(weights != 0, weights, 1.0)[..., None]
    if _axes_of(piece) == 1:
        return sc.NurbsCurve(deformable.DEGREE, knots, points[:, 0], weights[:, 0], periodic=around.periodic)
    degree, all_knots, periodic = list(piece.degree), list(piece.knots), list(piece.periodic)
    degree[axis], all_knots[axis], periodic[axis] = deformable.DEGREE, knots, around.periodic
    return sc.NurbsPatch(tuple(degree), tuple(all_knots), points, weights, tuple(periodic))


def _changed(definition, after, error):
    """The verbs.Changed of pieces one for one. Raises Refusal where patches would part."""
    found = verbs.one_for_one(definition, after, error)
    if not definition.has_curves:
        kept, left = _meetings(definition), _meetings(found.definition)
        parted = next((pair for pair in kept if pair not in left), None)
        if parted:
            raise Refusal("patches {first} and {second} would come apart: their edge is no circle for both of them",
                          first=parted[0] + 1, second=parted[1] + 1)
    return found


def _meetings(definition):
    """Pairs of patches that share an edge: two control points or more."""
    rows = [np.unique(piece.indices) for piece in definition.pieces]
    return {(i, k) for i in range(len(rows)) for k in range(i + 1, len(rows)) if len(np.intersect1d(rows[i], rows[k])) > 1}
