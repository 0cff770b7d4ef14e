"""Polylines into a Curve: POLY splines, so that bevel, Follow Path and the Curve modifier work."""

import numpy as np

from . import curve_layers


def write(data, polylines):
    """Give the Curve exactly these polylines: pairs of points (n, 3) and closed. A 2D curve that is flat stays 2D.

    What a user put on the splines stays with each of the same number, at the same part of its length in spans.
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
    kept = curve_layers.kept(data)
    data.splines.clear()
    # One more than there were is a further arm, say, of the last.
    kept = [kept[min(i, len(kept) - 1)] for i in range(len(polylines))] if kept else []
    for points, _ in polylines:
        data.splines.new('POLY').points.add(len(points) - 1)
    for spline, layers, (points, closed) in zip(data.splines, kept, polylines):
        curve_layers.write(spline, layers, layers.there(curve_layers.fractions(len(points), closed)))
    if kept:
        curve_layers.remember(data, kept)
