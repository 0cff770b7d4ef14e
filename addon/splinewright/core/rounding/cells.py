"""Patches cut where they have creases, so that every edge is a side."""

import math

import numpy as np

from ..base.library import sc
from ..joints.joints import SMOOTH
from ..verbs import patch_curves

#: Points that lie so near to a plane, as a part of the size, lie in it.
FLAT = 1e-9
#: Directions and tangent planes that differ by less, in radians, are one.
SMOOTH_TURN = 1e-5


def cells_of(patches):
    """[(NurbsPatch, the number of the patch of which it is all or a part)]: cut at creases, and at corners of sides."""
    return [(cell, i) for i, patch in enumerate(patches) for cell in _cells(patch.to_nurbs())]


def _cells(patch):
    cells = [patch]
    for axis in 'uv':
        knots = [knot for knot in _full_knots(patch, axis) if _is_crease(patch, axis, knot) or _has_corner(patch, axis, knot)]
        cells = [part for cell in cells for part in parts_of(cell, axis, knots)]
    return cells


def _full_knots(patch, axis):
    """Knots inside, and of a periodic axis the first one, that are as often there as the degree says."""
    number = 'uv'.index(axis)
    knots, degree = patch.knots[number], patch.degree[number]
    start, end = patch.domain[number]
    inner = knots[:-1] if patch.periodic[number] else knots[(knots > start) & (knots < end)]
    values, times = np.unique(inner, return_counts=True)
    return values[times >= degree].tolist()


def _is_crease(patch, axis, knot):
    try:
        parts = patch.split(axis, knot)
        found = sc.seam_continuity(parts[0], f"{axis}_end", parts[-1], f"{axis}_start", tolerance=SMOOTH, reversed=False)
    except (sc.InvalidShape, sc.PointAtInfinity):
        return True
    return found.g < 1


def _has_corner(patch, axis, knot):
    """Whether a side along an axis turns at a knot."""
    for name in (f"{'vu'['uv'.index(axis)]}_{end}" for end in ('start', 'end')):
        curve, reason = patch_curves.side_of(patch, name)
        if reason:
            continue
        before = knot if knot > curve.domain[0] else curve.domain[1]
        ways = [curve.derivatives([at], 1, side=side)[0, 1] for at, side in ((before, 'left'), (knot, 'right'))]
        turn = math.atan2(np.linalg.norm(np.cross(*ways)), np.dot(*ways))
        if turn > SMOOTH_TURN:
            return True
    return False


def parts_of(patch, axis, knots):
    parts = [patch]
    for knot in knots:
        parts += parts.pop().split(axis, knot)
    return parts


def plane_of(patch):
    """(a point, the unit normal as u and v turn) of the plane in which all points of a patch lie; None where there is none."""
    points = np.asarray(patch.points).reshape(-1, 3)
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle, full_matrices=False)
    if spread[2] > FLAT * spread[0] or not spread[1] > FLAT * spread[0]:
        return None
    normal = axes[2] / np.linalg.norm(axes[2])
    return middle, normal if _turn(patch, normal) > 0.0 else -normal


def _turn(patch, normal):
    """Twice the area within the sides of a flat patch, seen against a normal."""
    u, v = (np.linspace(*domain, 9) for domain in patch.domain)
    ring = np.concatenate([patch.evaluate_grid(u, v[:1])[:, 0], patch.evaluate_grid(u[-1:], v)[0],
                           patch.evaluate_grid(u[::-1], v[-1:])[:, 0], patch.evaluate_grid(u[:1], v[::-1])[0]])
    ring = ring - ring.mean(axis=0)
    return float(np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0) @ normal)
