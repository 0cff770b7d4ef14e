"""Surfaces that cross each other, or end on each other, cut back along lines of u or v, so that they meet in an edge."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Parameters along a curve, as a part of the domain, that differ by less are one.
_SAME = 1e-6
#: How finely they are met, as a part of the size.
_FINE = 1e-8
_PLACES = np.linspace(0.0, 1.0, 17)[1:-1]
#: What is refused of each of two surfaces.
_ACROSS = {'first': "the surfaces cross, but not along a line of u or v of the first one, which would have to be trimmed",
           'second': "the surfaces cross, but not along a line of u or v of the second one, which would have to be trimmed"}
_PARTLY = {'first': "the surfaces cross along a part of a line of the first one, not from side to side: it would have to be trimmed",
           'second': "the surfaces cross along a part of a line of the second one, not from side to side: it would have to be trimmed"}
_CLOSED = {'first': "the first surface is closed across where they cross: cut it open there first",
           'second': "the second surface is closed across where they cross: cut it open there first"}
_CUT = {'first': "the first surface is cut across {axis}: its side is {axis} start or {axis} end",
        'second': "the second surface is cut across {axis}: its side is {axis} start or {axis} end"}


class Cut(NamedTuple):
    """The rest of two patches, and the sides at which they meet."""

    first: object
    first_side: str
    second: object
    second_side: str


def cut_back(first, second, first_side, second_side, cancel=None):
    """The Cut of two patches that meet in one curve. Sides: where the rest of each has it, 'nearest' for the larger part.
    Raises Refusal where they do not, or where it runs along neither u nor v of either from side to side."""
    size = max(np.ptp(np.asarray(patch.to_nurbs().points).reshape(-1, 3), axis=0).max() for patch in (first, second))
    found = first.sections(second, tolerance=_FINE * size, cancel=cancel)
    if len(found.curves) == 0:
        raise Refusal("the surfaces have no edge in common, and do not cross")
    if len(found.curves) > 1:
        raise Refusal("the surfaces meet in {count} curves: one is expected", count=len(found.curves))
    curve = found.curves[0]
    start, end = curve.domain
    points = curve.evaluate(start + _PLACES * (end - start))
    if bool(found.closed[0]) and not (any(first.to_nurbs().periodic) and any(second.to_nurbs().periodic)):
        raise Refusal("the surfaces cross in a closed curve inside one of them, and would have to be trimmed")
    ends = curve.evaluate(np.array([start, end]))
    kept = [_kept(patch.to_nurbs(), points, ends, side, name)
            for patch, side, name in ((first, first_side, 'first'), (second, second_side, 'second'))]
    return Cut(*kept[0], *kept[1])


def _kept(patch, points, ends, side, name):
    """(the part of a patch that is kept, its side on which points lie). Raises Refusal."""
    parameters = patch.nearest(points).parameters
    domain = np.array(patch.domain)
    lengths = domain[:, 1] - domain[:, 0]
    spread = np.ptp(parameters, axis=0) / lengths
    level = int(np.argmin(spread))
    if not spread[level] <= _SAME:
        raise Refusal(_ACROSS[name])
    reached = np.sort(patch.nearest(ends).parameters[:, 1 - level])
    if not patch.periodic[1 - level] and np.abs(reached - domain[1 - level]).max() > _SAME * lengths[1 - level]:
        raise Refusal(_PARTLY[name])
    axis, at = 'uv'[level], float(np.median(parameters[:, level]))
    for end, limit in zip(('start', 'end'), domain[level]):
        if abs(at - limit) <= _SAME * lengths[level] and not patch.periodic[level]:
            return patch, f"{axis}_{end}"
    if patch.periodic[level]:
        raise Refusal(_CLOSED[name])
    before, behind = patch.split(axis, at)
    parts = {f"{axis}_end": before, f"{axis}_start": behind}
    if side != 'nearest' and side not in parts:
        raise Refusal(_CUT[name], axis=axis)
    chosen = side if side != 'nearest' else max(parts, key=lambda one: _size(parts[one]))
    return parts[chosen], chosen


def _size(patch):
    """An area to a few digits: which part is larger."""
    try:
        return patch.area(tolerance=1e-3)
    except sc.Error:
        return float(np.ptp(np.asarray(patch.points).reshape(-1, 3), axis=0).max())
