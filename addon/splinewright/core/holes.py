"""Holes: curves and sides of patches that go round."""

from typing import NamedTuple

import numpy as np

from . import patch_curves, sections
from .failures import Refusal

_FEWEST, _MOST = 3, 8


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
    """The Sides of the hole, in the order in which they go round: three to eight, one at least of each of `count` shapes; of
    several such holes the one with the fewest sides, then the shortest. Raises Refusal."""
    ends = _corners(sides, tolerance)
    free = _without_seams(sides, ends, tolerance)
    if all(side.asked is side.curve for side in sides):
        return _loop_of_curves(sides, tolerance)
    found = [cycle for start in free for cycle in _cycles(free, ends, start)
             if {sides[i].owner for i in cycle} == set(range(count))]
    if not found:
        raise Refusal(f"no hole of three to eight sides goes round all of them within {tolerance:.2g}: their sides do not meet")
    lengths = [side.curve.length(tolerance=1e-3) for side in sides]
    return [sides[i] for i in min(found, key=lambda cycle: (len(cycle), sum(lengths[i] for i in cycle)))]


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
    """Lists of numbers of sides that go round through corners of which no one comes twice, from a side on; each round once."""
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
