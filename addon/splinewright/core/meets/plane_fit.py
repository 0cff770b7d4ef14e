"""The plane that curves lie in."""

import numpy as np

#: What is wider than this part of the length of curves is no line.
_NARROW = 1e-9


def normal_of(curves):
    """(3,): of the plane nearest to the control points of curves, a unit vector whose largest part is above 0. Of a line it is z,
    or where that is along it y, as far as it is at right angles."""
    points = np.concatenate([finite_points(curve) for curve in curves])
    _, sizes, axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=True)
    if len(sizes) < 2 or not sizes[1] > _NARROW * sizes[0]:
        along = axes[0]
        up = np.array([0.0, 0.0, 1.0]) if abs(along[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
        normal = up - (up @ along) * along
        normal /= np.linalg.norm(normal)
    else:
        normal = axes[2]
    return normal if normal[np.abs(normal).argmax()] > 0 else -normal


def finite_points(curve):
    """(n, 3): the control points that are not at infinity."""
    nurbs = curve.to_nurbs()
    return nurbs.points[nurbs.weights != 0]
