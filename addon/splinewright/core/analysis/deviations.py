"""How far places of a shape lie from something else: measured at all of them, or at enough that the others lie between."""

from dataclasses import dataclass

import numpy as np

from ..base.library import sc
from ..shape import parameters
from ..verbs.patch_verbs import Along
from .measuring import Plan

#: Points that are measured of a patch, at least.
_LEAST = 9


@dataclass(eq=False)
class Deviation:
    """Distances, and their largest and mean over the whole shape; nan where there are none."""

    values: np.ndarray
    largest: float
    mean: float
    extent: float = 0.0                 # the area or the length of all that has distances


def distances_to(pieces, points):
    """(n,): how far points (n, 3) lie from the nearest of curves, or of patches; nan where that cannot be told."""
    try:
        return sc.nearest(pieces, points).distances
    except sc.InvalidShape:
        if len(points) == 1:
            return np.full(1, np.nan)
        middle = len(points) // 2
        return np.concatenate([distances_to(pieces, points[:middle]), distances_to(pieces, points[middle:])])


def extent(points):
    """(the middle of points (n, 3), how far the farthest coordinate is from it): of those that are finite."""
    finite = points[np.isfinite(points).all(1)]
    if not len(finite):
        return np.zeros(3), 1.0
    low, high = finite.min(0), finite.max(0)
    middle = low + (high - low) / 2
    return middle, float(np.abs(finite - middle).max()) or 1.0


def at_places(patch_set, places, most):
    """The core.analysis.measuring.Plan of core.analysis.faces.Places of patches: about a limited number of points."""
    most = max(most // len(patch_set), _LEAST)
    order = np.argsort(places.patches, kind='stable')
    numbers, starts = np.unique(places.patches[order], return_index=True)
    rows = np.split(order, starts[1:])
    plans = [_plan(patch_set[int(number)], places.parts[here], most) for number, here in zip(numbers, rows)]
    ends = np.cumsum([len(points) for points, _ in plans])

    def spread(measured):
        found = np.empty(len(order))
        for here, (_, spread_one), values in zip(rows, plans, np.split(measured, ends[:-1])):
            found[here] = spread_one(values)
        return found
    return Plan(np.concatenate([points for points, _ in plans]), spread)


def along_lines(pairs, most):
    """The Plan of the ends (n, 2) of lines (n, 2, 3) that continue one another: at most a given number of points."""
    if not len(pairs):
        return Plan(np.empty((0, 3)), lambda measured: np.empty((0, 2)))
    is_first = np.append(True, (pairs[1:, 0] != pairs[:-1, 1]).any(1))
    step = -(-2 * len(pairs) // most)
    chosen = np.unique(np.concatenate([np.flatnonzero(is_first), np.flatnonzero(np.append(is_first[1:], True)),
                                       np.arange(0, len(pairs), step)]))
    starts = np.flatnonzero(is_first)

    def spread(measured):
        ends = np.interp(np.arange(len(pairs)), chosen, measured[:len(chosen)])
        before = np.append(np.nan, ends[:-1])
        before[starts] = measured[len(chosen):]
        return np.stack([before, ends], -1)
    return Plan(np.concatenate([pairs[chosen, 1], pairs[starts, 0]]), spread)


def areas(positions, triangles):
    """(of triangles (t, 3) between positions (n, 3) the areas, their unit)."""
    middle, size = extent(positions)
    x, y, z = ((positions - middle) / size).T[:, triangles]
    (ax, ay, az), (bx, by, bz) = ([each[:, i] - each[:, 0] for each in (x, y, z)] for i in (1, 2))
    return np.sqrt((ay * bz - az * by) ** 2 + (az * bx - ax * bz) ** 2 + (ax * by - ay * bx) ** 2) / 2, size * size


def over_faces(values, triangles, sizes, unit):
    """The Deviation of values (n,) of the corners of triangles (t, 3) with areas() of a unit."""
    return _summed(values, values[triangles], sizes, unit)


def over_all(several):
    """(the largest, the mean) of Deviations of things that are all surfaces, or all lines."""
    extents = np.array([each.extent for each in several])
    shares = extents / extents.max() if 0.0 < extents.max() < np.inf else np.ones(len(extents))
    largest = max(each.largest for each in several)
    means = np.array([each.mean for each in several]) / (largest or 1.0)
    return largest, float((means * shares).sum() / shares.sum()) * largest


def over_lines(values, pairs):
    """The Deviation of values (n, 2) at the ends of lines (n, 2, 3)."""
    if not len(pairs):
        return Deviation(values, np.nan, np.nan)
    middle, size = extent(pairs.reshape(-1, 3))
    return _summed(values, values, np.linalg.norm((pairs[:, 1] - pairs[:, 0]) / size, axis=1), size)


def _summed(values, at_corners, sizes, unit):
    """Means are of parts of the largest, so that no sum runs out of range."""
    is_known = np.isfinite(at_corners).all(1) & np.isfinite(sizes)
    known = values[np.isfinite(values)]
    if not len(known):
        return Deviation(values, np.nan, np.nan)
    largest = float(known.max())
    total = sizes[is_known].sum()
    if largest == 0.0 or not total > 0.0:
        return Deviation(values, largest, float(known.mean()) if largest else 0.0, float(total) * unit)
    parts = (at_corners[is_known] / largest).mean(1)
    return Deviation(values, largest, float((parts * sizes[is_known]).sum() / total) * largest,
                     float(total) * unit)


def _plan(patch, parts, most):
    """(points of a patch that are to be measured, what gives of their distances those at parts (n, 2) of its domain)."""
    alike, number = np.unique(np.ascontiguousarray(parts).view(np.uint64).ravel(), return_inverse=True)
    alike = alike.view(np.float32).reshape(-1, 2).astype(np.float64)
    (start_u, end_u), (start_v, end_v) = patch.domain
    u, v = start_u + alike[:, 0] * (end_u - start_u), start_v + alike[:, 1] * (end_v - start_v)
    if len(u) <= most:
        return patch.evaluate(u, v, at_infinity='nan'), lambda values: values[number]
    lines = [_lines(patch, axis, most) for axis in (0, 1)]
    points = patch.evaluate_grid(*lines, at_infinity='nan')
    return points.reshape(-1, 3), lambda values: _between(lines, values.reshape(points.shape[:2]), u, v)[number]


def _lines(patch, axis, most):
    """Parameters of a grid of about this number of points; knots are among them where there is room."""
    start, end = patch.domain[axis]
    count = max(int(np.sqrt(most)), 3)
    evenly = np.linspace(start, end, count)
    knots = parameters.inner_knots(Along(patch, 'uv'[axis]))
    if len(knots) > count // 2:
        return evenly
    return np.unique(np.concatenate([np.linspace(start, end, count - len(knots)), knots]))


def _between(lines, grid, u, v):
    """Values of a grid at places between its lines."""
    (i, s), (j, t) = (_place(line, at) for line, at in zip(lines, (u, v)))
    low = grid[i, j] + s * (grid[i + 1, j] - grid[i, j])
    high = grid[i, j + 1] + s * (grid[i + 1, j + 1] - grid[i, j + 1])
    return low + t * (high - low)


def _place(line, at):
    i = (np.searchsorted(line, at, 'right') - 1).clip(0, len(line) - 2)
    return i, (at - line[i]) / (line[i + 1] - line[i])
