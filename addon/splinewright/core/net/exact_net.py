"""The control net of a definition: vertices to be moved one by one, and the way back.

A vertex is a point of the pool; the head of a handle, which stands for a tangent, a twist or a
direction at infinity; or the foot of such a direction's arrow. Blender holds it in float32. What it
does not move keeps the digits of the definition: exact() compares with what was handed out.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..shape import definition as definitions
from ..shape.definition import Definition
from . import snapped

_EPSILON = float(np.finfo(np.float32).eps)


@dataclass(frozen=True, eq=False)
class Spline:
    """What a piece of a curve is in Blender: 'BEZIER' has three vertices to a point, 'POLY' one."""

    kind: str
    count: int                          # of points
    closed: bool = False
    smooth: tuple = ()                  # of each point of 'BEZIER': whether its handles are in line
    piece: int = -1                     # the number of the piece


@dataclass(frozen=True, eq=False)
class Net:
    """n vertices. A handle stands for factor⁻¹ (position - origin), origin = a + b - c of three vertices."""

    source: Definition
    definition: Definition              # the source, where handles that differ have rows of their own
    positions: np.ndarray               # (n, 3) float64
    weights: np.ndarray                 # (n,) float64; 1 for what has none
    rows: np.ndarray                    # (n,) of the pool; -1 for a foot
    origins: np.ndarray                 # (n, 3) vertices a, b, c of a handle; -1 for a point
    factors: np.ndarray                 # (n,)
    splines: tuple = ()                 # of curves
    faces: tuple = ()                   # of patches: vertices of each
    lines: tuple = ()                   # of patches: pairs of vertices along u, along v
    arrows: tuple = ()                  # pairs of foot and head
    first: int = 0                      # the number that the first of the points carries in Blender

    @cached_property
    def single(self):
        """The positions as they were handed out."""
        with np.errstate(over='ignore'):
            return self.positions.astype(np.float32)

    @cached_property
    def order(self):
        """Of the positions as they were handed out."""
        return snapped.Order(self.single.astype(np.float64))

    @cached_property
    def single_weights(self):
        with np.errstate(over='ignore'):
            return self.weights.astype(np.float32)

    @cached_property
    def slack(self):
        """How far Blender itself moves a vertex: it realigns the handles of smooth joints."""
        slack = np.zeros(len(self.positions))
        for first, spline in self.chains:
            for point in np.flatnonzero(spline.smooth):
                triple = slice(first + 3 * point, first + 3 * point + 3)
                slack[triple] = 4 * _EPSILON * np.abs(self.positions[triple]).max()
            slack[first + 1:first + 3 * spline.count:3] = 0.0
        return slack[:, None]

    @cached_property
    def chains(self):
        """(its first vertex, itself) of each spline of 'BEZIER'."""
        found, first = [], 0
        for spline in self.splines:
            found += [(first, spline)] if spline.kind == 'BEZIER' else []
            first += spline.count * (3 if spline.kind == 'BEZIER' else 1)
        return tuple(found)

    @cached_property
    def rounding(self):
        """(n, 1): how far Blender moves the handles of chains that it computes again from where they are."""
        found = np.zeros((len(self.positions), 1))
        for first, spline in self.chains:
            last = first + 3 * spline.count
            found[first:last] = 16 * _EPSILON * np.abs(self.positions[first:last]).max()
        return found

    @cached_property
    def are_points(self):
        return (self.rows >= 0) & (self.origins[:, 0] < 0)

    @cached_property
    def weighted(self):
        """(n,) bool: points that may have a weight, which those of Hermite pieces and plain cubics have not."""
        plain = [piece.indices.ravel() for piece in self.definition.pieces if piece.kind == 'hermite']
        weighted = self.are_points & ~np.isin(self.rows, np.concatenate([np.empty(0, np.int32), *plain]))
        first = 0
        for spline in self.splines:
            last = first + spline.count * (3 if spline.kind == 'BEZIER' else 1)
            weighted[first:last] &= spline.kind != 'BEZIER'
            first = last
        return weighted

    @property
    def point_count(self):
        """How many points have a number in Blender: handles of Bezier points have none."""
        return len(self.spline_points[0]) if self.definition.has_curves else len(self.rows)

    @cached_property
    def spline_points(self):
        """Of curves: (the first vertex of each point, whether it is a Bezier point, which has three)."""
        counts = [spline.count for spline in self.splines]
        are_bezier = np.repeat([spline.kind == 'BEZIER' for spline in self.splines], counts).astype(bool)
        steps = np.where(are_bezier, 3, 1)
        return np.cumsum(steps) - steps, are_bezier

    @cached_property
    def neighbors(self):
        """(k, 2): pairs of vertices that are connected, a closed curve's last and first left out: the edge that is drawn from
        there is connected to both. Handles of Bezier points count as beside those of the next."""
        pairs = [np.asarray(some, dtype=np.int64).reshape(-1, 2) for some in (*self.lines, self.arrows)]
        first = 0
        for spline in self.splines:
            step = 3 if spline.kind == 'BEZIER' else 1
            before = np.arange(first, first + step * (spline.count - 1))
            pairs.append(np.stack([before, before + step], -1))
            first += step * spline.count
        return np.concatenate(pairs)

    @cached_property
    def handles(self):
        """Vertices of handles."""
        return np.flatnonzero((self.rows >= 0) & (self.origins[:, 0] >= 0))


@dataclass(frozen=True, eq=False)
class Exact:
    """Positions and weights of the vertices in float64, and which are those of the net as it was made."""

    positions: np.ndarray
    weights: np.ndarray
    kept: np.ndarray
    kept_weights: np.ndarray


def exact(net, positions, weights, typed=()):
    """The digits behind float32 positions (n, 3) and weights (n,): those of the net where nothing moved, and of a point onto
    which another was put.

    typed: rows (vertex, x, y, z, w) of float64 numbers, which a vertex that has their float32 value takes.
    """
    kept = in_rows(np.abs(positions - net.single) <= net.slack)
    kept_weights = weights == net.single_weights
    now = np.where(kept[:, None], net.positions, positions)
    moved = np.flatnonzero(net.are_points & ~kept)
    if len(moved):
        for point, onto in snapped.targets(net.single, positions.astype(np.float64), moved, net.order):
            now[point] = now[onto]
    now_weights = np.where(kept_weights, net.weights, weights)
    for number, *position, weight in typed:
        vertex = int(number)
        if (np.array(position, np.float32) == positions[vertex]).all():
            now[vertex] = position
            kept[vertex] = (now[vertex] == net.positions[vertex]).all()
        if np.float32(weight) == weights[vertex]:
            now_weights[vertex] = weight
            kept_weights[vertex] = weight == net.weights[vertex]
    return Exact(now, now_weights, kept, kept_weights)


def in_rows(flags):
    """Of (n, 3) flags where all three of a row are set: (n,), much faster than NumPy's all()."""
    return flags[:, 0] & flags[:, 1] & flags[:, 2]


def read(net, state):
    """The definition of an Exact state: the net's source if nothing moved."""
    if state.kept.all() and state.kept_weights.all():
        return net.source
    pool = net.definition.pool.copy()
    points = np.flatnonzero(net.are_points & ~(state.kept & state.kept_weights))
    pool[net.rows[points], :3] = state.positions[points]
    pool[net.rows[points], 3] = state.weights[points]
    _read_handles(net, state.positions, state.kept, pool)
    return _joined(net, replace(net.definition, pool=pool))


def _read_handles(net, now, kept, pool):
    """What stands where it stood, seen from its origin, keeps its digits: Blender carries handles along."""
    handles = net.handles
    if not len(handles):
        return
    a, b, c = net.origins[handles].T
    reach = now[handles] - (now[a] + now[b] - now[c])
    before = net.positions[handles] - (net.positions[a] + net.positions[b] - net.positions[c])
    rounding = 4 * _EPSILON * np.abs(now[handles]).max(1, initial=0.0)
    moved = ~(kept[handles] & kept[a] & kept[b] & kept[c]) & (np.abs(reach - before).max(1, initial=0.0) > rounding)
    pool[net.rows[handles[moved]], :3] = reach[moved] / net.factors[handles[moved], None]


def _joined(net, definition):
    """Curves: tangents that are equal, but for Blender's rounding, at a joint that was smooth are one again."""
    if not definition.has_curves or all(piece.kind != 'hermite' for piece in definition.pieces):
        return definition
    for before, piece in zip(net.source.pieces, definition.pieces):
        if piece.kind == 'hermite':
            _join_tangents(definition.pool, before, piece)
    return definitions.from_value(definitions.to_value(definition))


def _join_tangents(pool, before, piece):
    steps = np.diff(piece.knots[0]) / 3.0
    for i in np.flatnonzero(before.indices[1] == before.indices[2]):
        point, incoming, outgoing = piece.indices[:, i]
        beside = steps[max(i - 1, 0):i + 1]
        size = np.abs(pool[point, :3]).max() + np.abs(pool[[incoming, outgoing], :3]).max() * beside.max()
        if np.abs(pool[incoming] - pool[outgoing]).max() <= 8 * _EPSILON * size / beside.min():
            pool[incoming] = pool[outgoing]
