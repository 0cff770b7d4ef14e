"""Polylines into a Curve: POLY splines, so that bevel, Follow Path and the Curve modifier work."""

from typing import NamedTuple

import numpy as np


class Dress(NamedTuple):
    """What a user may have given a spline beside its points."""

    material_index: int = 0
    use_smooth: bool = True
    radius: float = 1.0
    tilt: float = 0.0


def write(data, polylines):
    """Give the Curve exactly these polylines: pairs of points (n, 3) and closed. A 2D curve that is flat stays 2D.

    Material, shading, and the radius and tilt of its first point stay with each spline while their number stays.
    """
    if not len(data.splines) or any(points[:, 2].any() for points, _ in polylines):
        data.dimensions = '3D'          # a 2D curve is filled, and flat
    if not _same_splines(data, polylines):
        _make_splines(data, polylines)
    for spline, (points, closed) in zip(data.splines, polylines):
        rows = np.ones((len(points), 4), np.float32)
        rows[:, :3] = points
        spline.points.foreach_set('co', rows.ravel())
        spline.use_cyclic_u = closed
    # Blender 3.4 does not notice foreach_set on points.
    data.update_tag()


def _same_splines(data, polylines):
    return len(data.splines) == len(polylines) and all(
        spline.type == 'POLY' and len(spline.points) == len(points)
        for spline, (points, _) in zip(data.splines, polylines))


def _make_splines(data, polylines):
    worn = dresses(data)
    data.splines.clear()
    for points, _ in polylines:
        data.splines.new('POLY').points.add(len(points) - 1)
    put_on(data, worn if len(worn) == len(polylines) else [Dress()] * len(polylines))


def dresses(data):
    """The Dress of each spline."""
    return [_dress_of(spline) for spline in data.splines]


def put_on(data, worn):
    """Give each spline a Dress."""
    for spline, dress in zip(data.splines, worn):
        spline.material_index, spline.use_smooth = dress.material_index, dress.use_smooth
        for name in ('radius', 'tilt'):
            spline.points.foreach_set(name, np.full(len(spline.points), getattr(dress, name), np.float32))


def _dress_of(spline):
    points = spline.bezier_points or spline.points
    first = points[0] if len(points) else None
    return Dress(spline.material_index, spline.use_smooth, getattr(first, 'radius', 1.0), getattr(first, 'tilt', 0.0))
