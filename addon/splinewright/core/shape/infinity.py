"""Control points at infinity (lecture row S11): a direction in at of a point, and back."""

from dataclasses import replace

import numpy as np

from ..base.failures import Refusal


def sent(definition, rows):
    """The definition with points of the pool sent off to infinity, each straight away from its neighbors.

    Raises Refusal where a row is no point with a weight, or lies on all its neighbors.
    """
    pool = definition.pool.copy()
    for row in rows:
        _require_free(definition, row)
        if pool[row, 3] == 0:
            raise Refusal("it lies at infinity already")
        direction = definition.pool[row, :3] - _foot(definition, row)
        if not direction.any():
            raise Refusal("a point that lies amid its neighbors has no direction to go")
        pool[row] = *direction, 0.0
    if not pool[:, 3].any():
        raise Refusal("one point must stay")
    return replace(definition, pool=pool)


def brought_back(definition, rows):
    """The definition with directions of the pool as points of weight 1, at the heads of their arrows."""
    pool = definition.pool.copy()
    for row in rows:
        _require_free(definition, row)
        if pool[row, 3] != 0:
            raise Refusal("it does not lie at infinity")
        pool[row] = *(definition.pool[row, :3] + _foot(definition, row)), 1.0
    return replace(definition, pool=pool)


def _require_free(definition, row):
    if any(piece.kind == 'hermite' and row in piece.indices for piece in definition.pieces):
        raise Refusal("points and tangents of Hermite pieces have no weights")


def _foot(definition, row):
    piece = next(piece for piece in definition.pieces if row in piece.indices)
    return foot_of(definition.pool, piece.indices, np.argwhere(piece.indices == row)[0], piece.periodic)


def foot_of(pool, net, at, periodic):
    """Where the arrow of the direction at a position in a row or net of points begins: in the middle of the finite
    points beside it; the origin where there are none."""
    beside = list(_beside_in_row(pool, net, at[0]) if net.ndim == 1 else
                  (row for row in _beside_in_net(net, at, periodic or (False, False)) if pool[row, 3] != 0))
    return pool[beside, :3].mean(0) if beside else np.zeros(3)


def _beside_in_row(pool, row, i):
    """The nearest finite points on either side."""
    finite = np.flatnonzero(pool[row, 3])
    return row[np.concatenate([finite[finite < i][-1:], finite[finite > i][:1]])]


def _beside_in_net(net, at, periodic):
    for axis in (0, 1):
        for step in (-1, 1):
            other = at.copy()
            other[axis] += step
            if periodic[axis]:
                other[axis] %= net.shape[axis]
            if 0 <= other[axis] < net.shape[axis]:
                yield net[tuple(other)]
