"""Distances and volumes of what is drawn."""

import numpy as np


def farthest(points, line):
    """The largest distance of a point from a polyline."""
    starts, steps = line[:-1], np.diff(line, axis=0)
    squares = np.maximum((steps ** 2).sum(1), 1e-300)
    worst = 0.0
    for point in points:
        along = np.clip(((point - starts) * steps).sum(1) / squares, 0, 1)
        worst = np.maximum(worst, np.linalg.norm(starts + along[:, None] * steps - point, axis=1).min())
    return worst


def dense(curve, count=2000):
    """Polyline of a curve, with as many points in each span."""
    joints = np.unique(np.clip(curve.knots, *curve.domain)) if hasattr(curve, 'knots') else np.array(
        getattr(curve, 'parameters', curve.domain))
    at = np.interp(np.linspace(0, len(joints) - 1, count * (len(joints) - 1) + 1), np.arange(len(joints)), joints)
    return curve.evaluate(at)


def mesh_points(mesh):
    flat = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', flat)
    return flat.reshape(-1, 3).astype(float)


def signed_volume(mesh, apex=(0.1, 0.2, -3.0)):
    """Of the cone over the faces from a point: its sign says which way they look."""
    mesh.calc_loop_triangles()
    corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get('vertices', corners)
    return np.linalg.det((mesh_points(mesh) - apex)[corners.reshape(-1, 3)]).sum() / 6
