"""Strips of planes along their sides, with lines across at right angles to these: on them a ball touches a plane at the parameter
at which it touches the surface on the other side, whatever the patches of the plane are."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: How wide strips are by the radius, in the order in which they are tried.
WIDTHS = (1.02, 1.05, 1.1, 1.5, 4.0, 12.0)
_SAMPLES = 9
#: Lines across that are off a right angle by less, in radians, run at right angles.
_SQUARE = 1e-6
#: Parts of control polygons that are shorter, as a part of it, have no direction.
_SHORT = 1e-9


def runs_square(cell, name):
    """Whether lines of a cell across a side of it run at right angles to it."""
    axis = 'uv'.index(name[0])
    along = np.linspace(*cell.domain[1 - axis], _SAMPLES)
    at = np.full_like(along, cell.domain[axis][0 if name.endswith('start') else 1])
    jets = cell.derivatives(*((at, along) if axis == 0 else (along, at)), 1)
    ways = jets[:, 1, 0], jets[:, 0, 1]
    lengths = np.prod([np.linalg.norm(way, axis=1) for way in ways], axis=0)
    return bool((np.abs(np.einsum('ij,ij->i', *ways)) <= _SQUARE * lengths).all())


def strip_of(curve, normal, width, ends=(None, None)):
    """A NurbsPatch whose v_start is a curve in a plane, and which lies to its left, seen from where the normal points to. ends:
    the directions in which its ends run, None for right angles. Of segments and arcs its lines across are at right angles. Raises
    Refusal."""
    inner = _beside(np.asarray(curve.points), normal, width, bool(curve.periodic), ends)
    made = sc.build.ruled(curve, curve.with_points(inner))
    if _is_folded(made):
        raise Refusal("the radius is too large for the bends of the edge in a plane beside it")
    return made


def _is_folded(strip):
    """Whether its other side runs against the curve somewhere."""
    u = np.linspace(*strip.domain[0], 4 * _SAMPLES)
    ways = [strip.derivatives(u, np.full_like(u, v), 1)[:, 1, 0] for v in strip.domain[1]]
    return bool((np.einsum('ij,ij->i', *ways) < 0.0).any())


def _beside(points, normal, width, is_periodic, ends):
    """A control polygon whose parts lie beside those of another one (Tiller and Hanson)."""
    legs = np.diff(points, axis=0, append=points[:1])
    if not is_periodic:
        legs = legs[:-1]
    lengths = np.linalg.norm(legs, axis=1)
    is_long = lengths > _SHORT * lengths.sum()
    lefts = np.cross(normal, legs / np.where(is_long, lengths, 1.0)[:, None])
    count, found = len(points), []
    for i in range(count):
        before = _near(lefts, is_long, i - 1, -1, is_periodic)
        behind = _near(lefts, is_long, i, 1, is_periodic)
        if before is None or behind is None:
            left, end = (behind, ends[0]) if before is None else (before, ends[1])
            way = left if end is None else _slide(end, left)
        else:
            way = (before + behind) / max(1.0 + before @ behind, 0.1)
        found.append(points[i] + width * way)
    return np.array(found)


def _slide(end, left):
    """Along a direction, as far to the left as a unit."""
    if not end @ left > _SHORT * np.linalg.norm(end):
        raise Refusal("a side is tangent to the edge: it would have to be trimmed")
    return end / (end @ left)


def _near(lefts, is_long, i, step, is_periodic):
    """The next left of a part with a direction, from one on."""
    for _ in range(len(lefts)):
        if is_periodic:
            i %= len(lefts)
        elif not 0 <= i < len(lefts):
            return None
        if is_long[i]:
            return lefts[i]
        i += step
    return None
