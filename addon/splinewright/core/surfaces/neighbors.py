"""Surfaces beside a network: on which of their sides its curves lie, and how smoothly it continues them."""

import numpy as np

from ..base.failures import AboutInputs
from ..verbs import patch_curves
from . import sections

#: Places so near the ends of a border are left out: there may be no normal.
_INSIDE = slice(1, -1)


def beside(shapes, curves, tolerance, numbers):
    """[((patch, side, 'G1'), the number of its shape)] of each side of the shapes, lists of patches of these numbers among the
    inputs, on which one of the curves lies. Raises AboutInputs for a shape that has none."""
    found = []
    for number, pieces in zip(numbers, shapes):
        own = [(piece, name, 'G1') for piece in pieces for name in patch_curves.SIDES
               if _has_curve(piece, name, curves, tolerance)]
        if not own:
            raise AboutInputs("{} has no side on which a curve lies within {tolerance:.2g}", number, tolerance=tolerance)
        found += [(side, number) for side in own]
    return found


def _has_curve(patch, name, curves, tolerance):
    side, reason = patch_curves.side_of(patch, name)
    return not reason and any(_lies_on(curve, side, tolerance) for curve in curves)


def _lies_on(curve, other, tolerance):
    return other.nearest(sections.samples(curve)).distances.max() <= tolerance


def angle_to(patch, neighbors, tolerance):
    """The largest angle, in radians, between tangent planes of a patch and of its neighbors along its sides."""
    angles = [0.0]
    for name in patch_curves.SIDES:
        side, reason = patch_curves.side_of(patch, name)
        for other, other_name, _ in neighbors if not reason else ():
            if _lies_on(side, patch_curves.side_of(other, other_name)[0], tolerance):
                angles.append(_angle_along(side, patch, other))
    return max(angles)


def _angle_along(side, patch, other):
    points = sections.samples(side)[_INSIDE]
    a, b = (_normals(one, points) for one in (patch, other))
    return float(np.arcsin(np.clip(np.linalg.norm(np.cross(a, b), axis=1), 0.0, 1.0)).max())


def _normals(patch, points):
    jets = patch.derivatives(*patch.nearest(points).parameters.T, 1)
    normals = np.cross(jets[:, 1, 0], jets[:, 0, 1])
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)
