"""Polylines into a Curve: POLY splines, so that bevel, Follow Path and the Curve modifier work."""

import numpy as np


def write(data, polylines):
    """Give the Curve exactly these polylines: pairs of points (n, 3) and closed."""
    data.dimensions = '3D'      # a 2D curve would be filled and flattened
    if not _same_splines(data, polylines):
        data.splines.clear()
        for points, _ in polylines:
            spline = data.splines.new('POLY')
            spline.points.add(len(points) - 1)
    for spline, (points, closed) in zip(data.splines, polylines):
        rows = np.ones((len(points), 4), np.float32)
        rows[:, :3] = points
        spline.points.foreach_set('co', rows.ravel())
        spline.use_cyclic_u = closed
        spline.use_smooth = True
    # Blender 3.4 does not notice foreach_set on points.
    data.update_tag()


def _same_splines(data, polylines):
    return len(data.splines) == len(polylines) and all(
        spline.type == 'POLY' and len(spline.points) == len(points)
        for spline, (points, _) in zip(data.splines, polylines))
