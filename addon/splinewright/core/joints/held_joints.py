"""Joints of curves that are made smooth again whenever a side of theirs has moved (lecture rows S18, S21).

Of each side the joint is the first of at most three rows of the pool, whose weights stay: the rest is what they make of the
first two derivatives there. (Piegl and Tiller, The NURBS Book, formulas 3.9 and 4.8.)
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal

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
            raise Refusal(f"the curve has no knot {place:.6g} inside any more")
        if first + degree + 1 < len(knots) and knots[first + degree + 1] == place:
            raise Refusal(f"the curve has a gap at the knot {place:.6g}")
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
            raise Refusal(f"a curve of degree {side.degree} cannot be made {held.smoothness}: raise its degree first")


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
    moves = held.moves
    joint = _joint(pool, first.rows[0], second.rows[0], moves, led)
    scale = _scale(pool, joint, (first, second))
    order = int(held.smoothness[1])
    leaving = [_Leaving(pool, side, joint, scale, led, order) for side in (first, second)]
    if order:
        if held.smoothness[0] == 'C':
            _parametric(*leaving, second.spans[0] / first.spans[0], moves, order)
        else:
            _geometric(*leaving, moves, order)
    rows = np.concatenate([side.rows for side in (first, second)])
    return rows, np.concatenate([side.points(joint, scale) for side in leaving])


def _joint(pool, a, b, moves, led):
    """(3,): where both sides are to begin."""
    if (a in led) != (b in led):
        return pool[a if a in led else b, :3].copy()
    return {'second': pool[a, :3].copy(), 'first': pool[b, :3].copy(), 'both': pool[a, :3] / 2 + pool[b, :3] / 2}[moves]


def _scale(pool, joint, sides):
    """What lengths are divided by, so that none of them overflows or vanishes."""
    rows = pool[np.concatenate([side.rows for side in sides])]
    away = np.abs(rows[:, :3] - np.where(rows[:, 3:] != 0, joint, 0.0)).max()
    return float(away) if away > 0 else 1.0


class _Leaving:
    """The first two derivatives of a side, its first span taken for 1, from homogeneous points about the joint."""

    def __init__(self, pool, side, joint, scale, led, order):
        rows = pool[side.rows]
        self.weights, self.degree = rows[:, 3], side.degree
        self.count = min(len(rows), side.degree + 1)
        self.second_span = side.spans[1] / side.spans[0]
        start = rows[0, :3]
        follows = np.array([i <= order and row not in led for i, row in enumerate(side.rows)]) & (self.weights != 0)
        places = rows[:, :3] + np.where(follows[:, None], joint - start, 0.0)
        finite = self.weights[:, None] != 0
        self.places = np.where(finite, (places - joint) * self.weights[:, None], rows[:, :3]) / scale
        self.places[0] = 0.0
        self._before, self._rows = self.places.copy(), np.column_stack([places, self.weights])
        self._rows[0, :3] = joint
        self.read()

    def read(self):
        """The derivatives of what the points are."""
        p, w = self.degree, self.weights
        points = np.column_stack([self.places, w])
        one = p * (points[1] - points[0])
        two = np.zeros(4)
        if self.count > 2:
            two = p * (p - 1) * ((points[2] - points[1]) / self.second_span - (points[1] - points[0]))
        self.slope, self.bend = one[3], two[3]
        self.velocity = one[:3] / w[0]
        self.acceleration = (two[:3] - 2 * self.slope * self.velocity) / w[0]

    def set(self, velocity, acceleration=None):
        """Give the points these derivatives; where no second is given, those after the first stay."""
        p, w = self.degree, self.weights
        one = w[0] * velocity
        self.places[1] = one / p
        if acceleration is not None:
            two = w[0] * acceleration + 2 * self.slope * velocity
            self.places[2] = self.places[1] + self.second_span * (two / (p * (p - 1)) + self.places[1])
        self.read()

    def points(self, joint, scale):
        """(k, 4) rows of the pool; to the last digit as they were where nothing moved them."""
        rows = self._rows.copy()
        for i in range(1, len(rows)):
            if (self.places[i] != self._before[i]).any():
                place = self.places[i] * scale
                rows[i, :3] = joint + place / self.weights[i] if self.weights[i] else place
        return rows


def _parametric(first, second, ratio, moves, order):
    """C1 and C2. ratio: the first span of the second side by that of the first."""
    velocities = -first.velocity * ratio, second.velocity
    accelerations = first.acceleration * ratio**2, second.acceleration
    velocity, acceleration = (_agreed(pair, moves) for pair in (velocities, accelerations))
    bends = order == 2
    if moves != 'second':
        first.set(-velocity / ratio, acceleration / ratio**2 if bends else None)
    if moves != 'first':
        second.set(velocity, acceleration if bends else None)


def _agreed(pair, moves):
    return {'second': pair[0], 'first': pair[1], 'both': (pair[0] + pair[1]) / 2}[moves]


def _geometric(first, second, moves, order):
    """G1 and G2: each side keeps its speed, and how the speed changes."""
    tangents = -_unit(first.velocity), _unit(second.velocity)
    if not all(tangent.any() for tangent in tangents):
        return                          # a side without a direction has none to share
    tangent = _unit(_agreed(tangents, moves))
    if not tangent.any():               # they go back the way they came: neither is nearer
        tangent = tangents[0]
    curvature = _agreed([_curvature(first), _curvature(second)], moves) if order == 2 else None
    for side, own, name in ((first, -tangent, 'first'), (second, tangent, 'second')):
        if moves in (name, 'both'):
            _bend(side, own, curvature)


def _bend(side, tangent, curvature):
    speed = np.linalg.norm(side.velocity)
    along = side.acceleration @ _unit(side.velocity)
    if curvature is None:
        side.set(speed * tangent)
        return
    across = curvature - (curvature @ tangent) * tangent
    side.set(speed * tangent, speed**2 * across + along * tangent)


def _curvature(side):
    """(3,): the vector from the joint towards the middle of curvature, one over the radius long."""
    tangent, speed = _unit(side.velocity), np.linalg.norm(side.velocity)
    return (side.acceleration - (side.acceleration @ tangent) * tangent) / speed**2


def _unit(vector):
    length = np.linalg.norm(vector)
    return vector / length if length > 0 else np.zeros(3)
