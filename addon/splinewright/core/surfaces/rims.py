"""Plane rims: what fills closed curves in a plane is exact, plane and does not fold."""

import numpy as np

from ..base.library import sc
from . import sections

#: Heights above a plane, as a part of the size, that are rounding.
_FLAT = 1e-9
#: Places in every span at which normals are looked at.
_PLACES = np.array([0.001, *np.linspace(0.0, 1.0, 12)[1:-1], 0.999])


def normal_of(curves):
    """(3,): the unit normal of the plane in which closed curves lie; None if they lie in none."""
    if not all(np.all(np.asarray(curve.to_nurbs().weights) > 0.0) for curve in curves):
        return None
    points = np.concatenate([curve.to_nurbs().points for curve in curves])
    places = points - points.mean(axis=0)
    _, spread, axes = np.linalg.svd(places, full_matrices=True)
    is_flat = np.abs(places @ axes[2]).max() <= _FLAT * spread[0]
    return axes[2] if is_flat and spread[1] > _FLAT * spread[0] else None


def is_good(patches, gap, curves, normal):
    """Whether patches fill plane curves: with no gap, in their plane, with all normals on one side."""
    size = sections.size_of(curves)
    origin = curves[0].to_nurbs().points[0, :3]
    heights = np.concatenate([(patch.to_nurbs().points[..., :3] - origin).reshape(-1, 3) @ normal for patch in patches])
    return gap <= 1e-12 * size and np.abs(heights).max() <= _FLAT * size and _face_one_way(patches, normal)


def _face_one_way(patches, normal):
    sides = []
    for patch in map(lambda patch: patch.to_nurbs(), patches):
        at = [_places(knots, domain) for knots, domain in zip(patch.knots, patch.domain)]
        sides.append((patch.evaluate_grid_with_normals(*at)[1].reshape(-1, 3) @ normal))
    sides = np.concatenate(sides)
    return bool((sides > 0.5).all() or (sides < -0.5).all())


def _places(knots, domain):
    ends = np.unique(np.clip(knots, *domain))
    return (ends[:-1, None] + np.diff(ends)[:, None] * _PLACES).ravel()


def filled(curves, cancel=None):
    """(patches, how far the curves are from a plane) as splinecore.build.fill_rim gives them."""
    return sc.build.fill_rim([curve.to_nurbs() for curve in curves], cancel=cancel)
