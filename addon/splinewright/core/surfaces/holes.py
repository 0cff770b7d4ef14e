"""Holes: curves and sides of patches that go around."""

import math
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..verbs import patch_curves
from . import sections

_FEWEST, _MOST = 3, 8
#: A closed side that turns by more, in radians, has a corner there.
_CORNER = 0.02


class Side(NamedTuple):
    """One of those that a hole may have."""

    owner: int                          # the number of the shape it is of, from 0
    curve: object
    asked: object                       # as splinecore.build.fill takes it


def sides_of(shapes, continuity):
    """The Sides that shapes offer: lists of a curve, or of patches."""
    found = []
    for owner, pieces in enumerate(shapes):
        for piece in pieces:
            if not hasattr(piece, 'isocurve'):
                found.append(Side(owner, piece, piece))
                continue
            for name in patch_curves.SIDES:
                curve, reason = patch_curves.side_of(piece, name)
                if not reason:
                    found.append(Side(owner, curve, (piece, name, continuity)))
    return found


def around(sides, count, tolerance):
    """The Sides of the hole, in the order in which they go around: three to eight, one at least of each of `count` shapes; of
    several such holes the one with the fewest sides, then the shortest. Raises Refusal."""
    ends = _corners(sides, tolerance)
    free = _without_seams(sides, ends, tolerance)
    if all(side.asked is side.curve for side in sides):
        return _loop_of_curves(sides, tolerance)
    found = [cycle for start in free for cycle in _cycles(free, ends, start)
             if {sides[i].owner for i in cycle} == set(range(count))]
    if not found:
        raise Refusal("they do not surround a hole of three to eight sides within {tolerance:.2g}: their sides do not meet",
                      tolerance=tolerance)
    lengths = [side.curve.length(tolerance=1e-3) for side in sides]
    return [sides[i] for i in min(found, key=lambda cycle: (len(cycle), sum(lengths[i] for i in cycle)))]


def of_one(pieces, continuity, is_other):
    """The Sides of a hole that one shape has: a closed curve, or the shorter of the closed sides of a patch, the longer one if
    is_other; cut at its corners, or else in four. Raises Refusal where there is none."""
    whole = [side for side in sides_of([pieces], continuity) if sections.is_closed(side.curve.to_nurbs())]
    if not whole:
        raise Refusal("it is not a closed curve and has no closed side: select everything around the hole")
    side = sorted(whole, key=lambda side: side.curve.length(tolerance=1e-6))[-1 if is_other else 0]
    return [Side(0, curve, asked) for curve, asked in _cut(side)]


def _cut(side):
    """Pairs of a curve and what splinecore.build.fill takes, one for each side of a hole that one closed side goes around."""
    is_curve = side.asked is side.curve
    if is_curve:
        whole = _opened(side.curve.to_nurbs())
        return [(part, part) for part in _parts(whole, _cuts(whole))]
    patch, name, continuity = side.asked
    axis = 'v' if name.startswith('u') else 'u'
    patch = patch.to_nurbs()
    patch = patch.clamped(axis) if patch.periodic['uv'.index(axis)] else patch
    whole = patch_curves.side_of(patch, name)[0].to_nurbs()
    found = []
    for at in [*_cuts(whole), None]:
        part, *rest = patch.split(axis, at) if at is not None else [patch]
        found.append((patch_curves.side_of(part, name)[0], (part, name, continuity)))
        patch = rest[0] if rest else patch
    return found


def _opened(curve):
    """A closed curve that begins at a corner if it has any."""
    curve = curve.clamped() if curve.periodic else curve
    corners = _corners_of(curve)
    if not corners or _turn(curve, None) > _CORNER:
        return curve
    head, tail = curve.split(corners[0])
    return sc.build.join_curves([tail, head], 1e-9 * sections.size_of([curve]))[0]


def _parts(curve, cuts):
    for at in cuts:
        part, curve = curve.split(at)
        yield part
    yield curve


def _cuts(curve):
    """The parameters at which a closed curve is cut into three to eight sides. Raises Refusal."""
    cuts = _corners_of(curve)
    if len(cuts) >= _MOST:
        raise Refusal("it has {count} corners: a hole has eight at most", count=len(cuts) + 1)
    least = 3 if not cuts else 2
    while len(cuts) < least:
        start, end = curve.domain
        places = [start, *cuts, end]
        gaps = [curve.length(a, b, tolerance=1e-6) for a, b in zip(places, places[1:])]
        widest = int(np.argmax(gaps))
        before = curve.length(start, places[widest], tolerance=1e-6) if widest else 0.0
        cuts = sorted([*cuts, float(curve.parameter_at_length(before + 0.5 * gaps[widest]))])
    return cuts


def _corners_of(curve):
    return [float(knot) for knot in np.unique(curve.knots) if curve.domain[0] < knot < curve.domain[1]
            and _turn(curve, knot) > _CORNER]


def _turn(curve, at):
    """The angle by which a curve turns at a knot, or where it is closed for None."""
    start, end = curve.domain
    after = curve.derivatives(start if at is None else at, 1, side='right')[1]
    before = curve.derivatives(end if at is None else at, 1, side='left')[1]
    return math.atan2(np.linalg.norm(np.cross(before, after)), before @ after)


def _loop_of_curves(sides, tolerance):
    curves = sections.loop([side.curve for side in sides], tolerance)
    return [next(side for side in sides if side.curve is curve) for curve in curves]


def _corners(sides, tolerance):
    """For each side the numbers of the two places where it ends; ends that meet have one."""
    places, ends = [], []
    for side in sides:
        pair = []
        for point in sections.ends(side.curve):
            near = next((i for i, place in enumerate(places) if np.linalg.norm(place - point) <= tolerance), None)
            if near is None:
                near = len(places)
                places.append(point)
            pair.append(near)
        ends.append(tuple(pair))
    return ends


def _without_seams(sides, ends, tolerance):
    """The numbers of the sides that are open, and are not one with another."""
    middles = [sections.samples(side.curve)[16] for side in sides]
    def is_free(i):
        is_one = any(set(ends[i]) == set(ends[j]) and np.linalg.norm(middles[i] - middles[j]) <= 10.0 * tolerance
                     for j in range(len(sides)) if j != i)
        return ends[i][0] != ends[i][1] and not is_one
    return [i for i in range(len(sides)) if is_free(i)]


def _cycles(free, ends, start):
    """Lists of numbers of sides that go around through corners of which no one comes twice, from a side on; each round once."""
    first, at = ends[start]
    waiting = [((start,), at, {at})]
    while waiting:
        path, at, seen = waiting.pop()
        if at == first and len(path) >= _FEWEST:
            yield path
            continue
        if len(path) == _MOST or at == first:
            continue
        for i in free:
            if i > start and i not in path and at in ends[i]:
                to = ends[i][1] if ends[i][0] == at else ends[i][0]
                if to == first or to not in seen:
                    waiting.append(((*path, i), to, seen | {to}))
