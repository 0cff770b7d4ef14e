"""Lines in the parameters of patches: the sides of faces, and which of them lie on which."""

import itertools
from typing import NamedTuple

import numpy as np
from mathutils.kdtree import KDTree

from . import mesh_layers

#: Parameters that differ by less are one; they are float32, from 0 to 1.
_NEAR = 1e-5
#: So many lines that begin before a point of a side may lie there over one another.
_DEEP = 4


class Lines(NamedTuple):
    """Straight lines, each on one patch."""

    rows: np.ndarray                    # (n, 5): the patch, u and v of the one end, and of the other

    def of(self, chosen):
        return Lines(self.rows[chosen])

    @property
    def steps(self):
        """(n, 2): how far each reaches along u and v."""
        return self.rows[:, 3:] - self.rows[:, 1:3]

    @property
    def middles(self):
        return (self.rows[:, 3:] + self.rows[:, 1:3]) / 2


class Sides(NamedTuple):
    """The sides of all faces of a mesh: the line and the edge of each."""

    lines: Lines
    edges: np.ndarray
    edge_count: int


def together(parts):
    return Lines(np.concatenate([part.rows for part in parts]))


def sides_of(mesh, corners):
    """The Sides of a mesh whose corners have these parameters, (c, 3): u, v, patch."""
    starts = mesh_layers.read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    following = np.arange(1, len(corners) + 1)
    following[np.append(starts[1:], len(corners)) - 1] = starts
    patches, ends = np.rint(corners[:, 2]), np.stack([corners[:, :2], corners[following, :2]], 1).astype(np.float64)
    vertices = mesh_layers.corner_vertices(mesh)
    for axis in (0, 1):
        is_pole = _is_pole(vertices, patches, corners[:, axis])
        _straighten(ends, axis, is_pole[np.stack([np.arange(len(corners)), following], 1)])
    return Sides(Lines(np.column_stack([patches, ends.reshape(-1, 4)])), mesh_layers.corner_edges(mesh), len(mesh.edges))


def _is_pole(vertices, patches, along):
    """(c,) whether the vertex of a corner is a whole side of its patch: corners there lie at several parameters along an
    axis, and not at both ends of it alone."""
    order = np.lexsort((vertices, patches))
    keys = np.stack([vertices[order], patches[order]])
    starts = np.flatnonzero(np.append(True, (np.diff(keys) != 0).any(axis=0)))
    sorted_along = along[order]
    is_inside = (sorted_along > _NEAR) & (sorted_along < 1 - _NEAR)
    spread = np.maximum.reduceat(sorted_along, starts) - np.minimum.reduceat(sorted_along, starts)
    is_pole = (spread > _NEAR) & np.logical_or.reduceat(is_inside, starts)
    found = np.empty(len(vertices), bool)
    found[order] = np.repeat(is_pole, np.diff(np.append(starts, len(vertices))))
    return found


def _straighten(ends, axis, is_pole):
    """Lines from a pole run along the other axis. ends: (n, 2, 2), is_pole: (n, 2)."""
    for end in (0, 1):
        to_other = is_pole[:, end] & ~is_pole[:, 1 - end]
        ends[to_other, end, axis] = ends[to_other, 1 - end, axis]


def under(lines, others):
    """(n,) for each line the number of one of the other Lines on which its middle lies and along which it runs, or -1."""
    found = np.full(len(lines.rows), -1)
    if not len(lines.rows) or not len(others.rows):
        return found
    for axis in (0, 1):
        _under_along(axis, lines, others, found)
    _under_slanted(lines, others, found)
    return found


def _runs_along(lines, axis):
    steps = np.abs(lines.steps)
    return (steps[:, 1 - axis] <= _NEAR) & (steps[:, axis] > _NEAR)


def _under_along(axis, lines, others, found):
    mine, theirs = np.flatnonzero(_runs_along(lines, axis)), np.flatnonzero(_runs_along(others, axis))
    if not len(mine) or not len(theirs):
        return
    rails, of_theirs = _rails(_heights(others, axis)[theirs])
    low = np.minimum(others.rows[theirs, 1 + axis], others.rows[theirs, 3 + axis])
    high = np.maximum(others.rows[theirs, 1 + axis], others.rows[theirs, 3 + axis])
    order = np.lexsort((low, of_theirs))
    heights = _heights(lines, axis)[mine]
    rail = np.clip(np.searchsorted(rails, heights - _NEAR), 0, len(rails) - 1)
    middles = lines.middles[mine, axis]
    at = np.searchsorted(_along_all(of_theirs, low)[order], _along_all(rail, middles + _NEAR), side='right') - 1
    for back in range(_DEEP):
        other = order[np.maximum(at - back, 0)]
        fits = (at >= back) & (of_theirs[other] == rail) & (np.abs(rails[rail] - heights) <= 2 * _NEAR)
        fits &= (high[other] >= middles - _NEAR) & (found[mine] < 0)
        found[mine[fits]] = theirs[other[fits]]


def _heights(lines, axis):
    """Where lines along an axis lie across it, those of each patch apart from those of others."""
    return 4 * lines.rows[:, 0] + lines.middles[:, 1 - axis]


def _rails(heights):
    """(the heights that are there, growing; for each which of them it is)."""
    order = np.argsort(heights, kind='stable')
    is_new = np.append(True, np.diff(heights[order]) > _NEAR)
    numbers = np.empty(len(heights), int)
    numbers[order] = np.cumsum(is_new) - 1
    return heights[order][is_new], numbers


def _along_all(rails, at):
    """Places on all rails, one rail after the other."""
    return 4.0 * rails + at


def _under_slanted(lines, others, found):
    """A line that runs along no axis lies on one that is just the same."""
    mine, theirs = (np.flatnonzero(~_runs_along(each, 0) & ~_runs_along(each, 1)) for each in (lines, others))
    mine = mine[np.isin(lines.rows[mine, 0], others.rows[theirs, 0])]
    if not len(mine) or not len(theirs):
        return
    tree, middles = KDTree(len(theirs)), _apart(others, theirs)
    for i, middle in enumerate(middles.tolist()):
        tree.insert(middle, i)
    tree.balance()
    for line, middle in zip(mine.tolist(), _apart(lines, mine).tolist()):
        for _, i, _ in tree.find_range(middle, 2 * _NEAR):
            if _same_ends(lines.rows[line], others.rows[theirs[i]]):
                found[line] = theirs[i]


def _apart(lines, chosen):
    return np.column_stack([lines.middles[chosen], 4 * lines.rows[chosen, 0]])


def _same_ends(a, b):
    turned = b[[3, 4, 1, 2]]
    return min(np.abs(a[1:] - b[1:]).max(), np.abs(a[1:] - turned).max()) <= 2 * _NEAR


def moved(lines, parents, places):
    """(Lines on patches each of which came of one of `parents` and lies there in a core.shape.places.Place, (m,) of which of the
    former they are parts). What lies on a cut lies on both sides of it."""
    rows, numbers = [np.empty((0, 5))], [np.empty(0, int)]
    for number, (parent, place) in enumerate(zip(parents, places)):
        for u, v in itertools.product(place.u, place.v):
            chosen, ends = _clipped(lines, parent, (u, v))
            there = np.stack([u.of(ends[..., 0]), v.of(ends[..., 1])], -1)
            there = there[..., ::-1] if place.is_swapped else there
            rows.append(np.column_stack([np.full(len(chosen), number), there.reshape(-1, 4)]))
            numbers.append(chosen)
    return Lines(np.concatenate(rows)), np.concatenate(numbers)


def _clipped(lines, parent, stretches):
    """(numbers of the lines of a patch that cross a part of it, (m, 2, 2) their ends there)."""
    chosen = np.flatnonzero(lines.rows[:, 0] == parent)
    ends = lines.rows[chosen, 1:].reshape(-1, 2, 2)
    low, high = np.zeros(len(chosen)), np.ones(len(chosen))
    is_in = np.ones(len(chosen), bool)
    for axis, stretch in enumerate(stretches):
        first, step = ends[:, 0, axis], ends[:, 1, axis] - ends[:, 0, axis]
        runs = np.abs(step) > _NEAR
        is_in &= runs | (first >= stretch.start - _NEAR) & (first <= stretch.end + _NEAR)
        steps = np.where(runs, step, 1.0)
        cuts = np.sort(np.stack([(stretch.start - first) / steps, (stretch.end - first) / steps]), axis=0)
        low, high = np.where(runs, np.maximum(low, cuts[0]), low), np.where(runs, np.minimum(high, cuts[1]), high)
    is_in &= (high - low)[:] * np.abs(ends[:, 1] - ends[:, 0]).max(axis=1, initial=0.0) > _NEAR
    ends, low, high = ends[is_in], low[is_in, None], high[is_in, None]
    step = ends[:, 1] - ends[:, 0]
    parts = np.stack([ends[:, 0] + low * step, ends[:, 0] + high * step], 1)
    limits = np.array([[stretch.start, stretch.end] for stretch in stretches])
    return chosen[is_in], np.clip(parts, limits[:, 0], limits[:, 1])
