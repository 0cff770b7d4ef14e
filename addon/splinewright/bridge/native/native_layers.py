"""What a curve data-block has beside its geometry, carried over when it becomes exact, or Blender's own again."""

import numpy as np

from ...core.native import native_along
from ..curve import curve_layers
from ..curve.curve_layers import Layers
from ..data.shading import Look

_NOUNS = ("the radius", "the tilt", "the soft body weight")
#: What stays nearer to what it was, as a part of how much it changes, is as it was.
_NEAR = 0.01


def fill_of(data, indices):
    """(whether these splines are a flat 2D curve, which may be filled; what of it cannot be kept, as nouns)."""
    points = [point for i in indices for point in data.splines[i].bezier_points or data.splines[i].points]
    is_flat = data.dimensions == '2D' and all(point.co[2] == 0 for point in points)
    return is_flat, ["the fill of a curve that is not flat"] if data.dimensions == '2D' and not is_flat else []


def along(spline, numbers):
    """A function that gives the Layers of one of Blender's splines at parts of it, (m,). numbers: its NativeSpline."""
    look = Look(spline.material_index, spline.use_smooth)
    points = spline.bezier_points or spline.points
    values = np.array([[getattr(point, name) for name in curve_layers.NAMES] for point in points])
    ways = curve_layers.of(spline).ways

    def at(fractions):
        if (values == values[0]).all():
            return Layers(look, fractions, np.tile(values[0].astype(np.float32), (len(fractions), 1)), ways)
        found = native_along.values_at(numbers, values, fractions, (*ways, 'LINEAR'))
        return Layers(look, fractions, np.where(np.isnan(found), curve_layers.PLAIN, found).astype(np.float32), ways)
    return at


def give(data, planned, domains, pieces):
    """Give the splines that a write_native.Plan made what lay along the pieces that they came of.

    pieces: what curve_pieces.of() gave. domains: those of the pieces. Returns what cannot be kept, as nouns."""
    lost = set()
    for spline, form, number in zip(data.splines, planned.forms, planned.numbers):
        if pieces[number]:
            lost |= _give_one(spline, form, domains[number], pieces[number])
    data.update_tag()
    return [noun for noun in _NOUNS if noun in lost]


def _give_one(spline, form, domain, layers):
    """give() of one spline; the nouns."""
    at = native_along.parts(form.spline)
    mine = min(layers, key=lambda each: each.distance(_in_piece(form, domain, at[len(at) // 2:][:1])[0]))
    if (mine.values == mine.values[0]).all():
        curve_layers.write(spline, mine, np.tile(mine.values[0], (len(at), 1)))
        return set()
    parts = form.parts_at(domain[0] + mine.at * (domain[1] - domain[0]))
    wanted = mine.there(_in_piece(form, domain, parts)).astype(np.float64)
    first = mine.there(_in_piece(form, domain, at)).astype(np.float64)
    ways = (*mine.ways, 'LINEAR')
    values = native_along.fitted(form.spline, first, parts, wanted, ways)
    values[:, 0] = np.maximum(values[:, 0], 0.0)
    curve_layers.write(spline, mine, values)
    off = np.abs(native_along.values_at(form.spline, values, parts, ways) - wanted).max(axis=0)
    allowed = _NEAR * np.maximum(np.ptp(wanted, axis=0), 1e-6)
    return {noun for noun, is_off in zip(_NOUNS, off > allowed) if is_off}


def _in_piece(form, domain, fractions):
    """Which parts of a piece parts of the spline are that shows it, or some of it."""
    start, end = domain
    return (form.at_parts(fractions) - start) / (end - start)
