"""Joints of curves that are made smooth again whenever a side of theirs has moved (lecture rows S18, S21).

Of each side the joint is the first of at most three rows of the pool, whose weights stay.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Where a piece has a joint: at its ends, or a number, a knot inside it at which only its points meet.
ENDS = ('start', 'end')
#: What lies so near, as a part of the size, is in one place.
_SAME = 1e-9
SMOOTHNESS = ('C0', 'G1', 'C1', 'G2', 'C2')


class _Side(NamedTuple):
    """A curve as it leaves a joint, as if the parameter grew that way."""

    rows: np.ndarray                    # of the pool
    degree: int
    spans: tuple                        # to the first knot beyond the joint, and to the one after it


def side_at(piece, place, outwards):
    """The _Side of a piece at an end, or at a knot, there outwards or before it. Raises Refusal where there is none."""
    if piece.kind == 'hermite':
        raise Refusal("joints of Hermite curves do not hold: make them NURBS curves first")
    if any(piece.periodic):
        raise Refusal("joints of periodic curves do not hold: make them clamped first")
    count = len(piece.indices)
    degree = piece.degree[0] if piece.kind == 'nurbs' else count - 1
    knots = piece.knots[0] if piece.kind == 'nurbs' else np.repeat([0.0, 1.0], count)
    first = _first_of(knots, count, degree, place)
    if place == 'end' or place not in ENDS and not outwards:
        return _Side(piece.indices[first::-1][:3], degree, tuple(knots[first + 1] - knots[[first, max(first - 1, 0)]]))
    beyond = np.minimum([first + degree + 1, first + degree + 2], len(knots) - 1)
    return _Side(piece.indices[first:][:3], degree, tuple(knots[beyond] - knots[first + 1]))


def _first_of(knots, count, degree, place):
    """The number of the point that the curve has at a place. Raises Refusal where it goes through none."""
    if place in ENDS:
        first = 0 if place == 'start' else count - 1
    else:
        first = int(np.searchsorted(knots, place)) - 1
        if not 0 < first < count - 1 or knots[first + 1] != place:
            raise Refusal("the curve has no knot {place:.6g} inside any more", place=place)
        if first + degree + 1 < len(knots) and knots[first + degree + 1] == place:
            raise Refusal("the curve has a gap at the knot {place:.6g}", place=place)
    if knots[first + 1] != knots[first + degree]:
        raise Refusal("the curve does not go through a control point at that joint")
    return first


def sides_of(definition, held):
    """Both _Sides of a joint. Raises Refusal where it is none."""
    (piece, place), (other, other_place) = held.first, held.second
    return (side_at(definition.pieces[piece], place, False), side_at(definition.pieces[other], other_place, True))


def require_possible(definition, held):
    """Raises Refusal where a joint cannot be as smooth as it is to be."""
    order = int(held.smoothness[1])
    for name, side in zip(('first', 'second'), sides_of(definition, held)):
        if definition.pool[side.rows[0], 3] == 0:
            raise Refusal("the joint lies at infinity")
        if held.moves in (name, 'both') and side.degree < order:
            raise Refusal("a curve of degree {degree} cannot be made {smoothness}: raise its degree first",
                          degree=side.degree, smoothness=held.smoothness)


def meet(definition, held):
    """Whether a joint is one: both sides begin in one place, but for rounding."""
    try:
        rows = [side.rows[0] for side in sides_of(definition, held)]
    except Refusal:
        return False
    points = definition.pool[rows]
    return bool(points[:, 3].all()) and bool(np.abs(points[0, :3] - points[1, :3]).max() <= _SAME * definition.size)


def same_knots(before, known, definition, number):
    """The knots inside piece `number` of a definition at which that goes through the point that piece and knot, `known`, are at in
    another, with the same side in front."""
    try:
        was = [side_at(before.pieces[known[0]], known[1], outwards) for outwards in (False, True)]
    except Refusal:
        return []
    found, piece = [], definition.pieces[number]
    if piece.kind != 'nurbs' or any(piece.periodic):
        return []
    slack = _SAME * max(before.size, definition.size)
    for knot in np.unique(piece.knots[0]).tolist():
        try:
            now = [side_at(piece, knot, outwards) for outwards in (False, True)]
        except Refusal:
            continue
        at, there = before.pool[was[0].rows[0], :3], definition.pool[now[0].rows[0], :3]
        leads = [_way(before.pool, was), _way(definition.pool, now)]
        if np.abs(at - there).max() <= slack and leads[0] @ leads[1] >= 0:
            found.append(knot)
    return found


def _way(pool, sides):
    """(3,): from the point before a joint to the one after it."""
    before, after = (pool[side.rows[1], :3] for side in sides)
    return _unit(after - before)


def made_to_hold(definition, pool, held, led):
    """(m,) rows of the pool beside a joint, and (m, 4) what they are when it holds.

    led: rows that a hand moves: where they are the end of one side, the other follows it, whichever gives way.
    """
    require_possible(definition, held)
    first, second = sides_of(definition, held)
    moved = [[row in led for row in side.rows.tolist()] for side in (first, second)]
    made = sc.build.joint_points(pool[first.rows], first.degree, first.spans, pool[second.rows], second.degree, second.spans,
                                 held.smoothness, held.moves, first_moved=moved[0], second_moved=moved[1])
    return np.concatenate([first.rows, second.rows]), np.concatenate(made)


def _unit(vector):
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.zeros(3)
