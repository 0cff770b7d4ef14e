"""What a curve data-block has beside its geometry, carried over when its splines are written anew."""

from typing import NamedTuple

import numpy as np


class Dress(NamedTuple):
    """How the splines of a Curve look. `looks` is for each kept piece: material index and smooth shading."""

    looks: list
    radius: float
    tilt: float
    is_flat: bool                   # a 2D curve, which may be filled


def of(data, indices):
    """The Dress of the splines with these indices, and what of it cannot be kept, as nouns."""
    splines = [data.splines[i] for i in indices]
    points = [point for spline in splines for point in spline.bezier_points or spline.points]
    lost = []
    radius = _common([point.radius for point in points], 1.0, "the radius of single points", lost)
    tilt = _common([point.tilt for point in points], 0.0, "the tilt of single points", lost)
    is_flat = data.dimensions == '2D' and all(point.co[2] == 0 for point in points)
    if data.dimensions == '2D' and not is_flat:
        lost.append("the fill of a curve that is not flat")
    looks = [(spline.material_index, spline.use_smooth) for spline in splines]
    return Dress(looks, radius, tilt, is_flat), lost


def plain(count):
    """The Dress of so many pieces of which nothing is known."""
    return Dress([(0, True)] * count, 1.0, 0.0, False)


def _common(values, default, noun, lost):
    """The value of all, or the default and a noun more in `lost`."""
    if min(values) == max(values):
        return values[0]
    lost.append(noun)
    return default


def put_on(data, dress, counts):
    """Dress the splines of a data-block, of which so many belong to each piece."""
    numbers = np.repeat(np.arange(len(counts)), counts)
    for number, spline in zip(numbers, data.splines):
        spline.material_index, spline.use_smooth = dress.looks[number]
        points = spline.bezier_points or spline.points
        for name, value in (('radius', dress.radius), ('tilt', dress.tilt)):
            points.foreach_set(name, np.full(len(points), value, np.float32))
    if dress.is_flat:
        data.dimensions = '2D'
    data.update_tag()
