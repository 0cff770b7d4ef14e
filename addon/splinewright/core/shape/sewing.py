"""Patches that came of others share the points that those shared."""

from dataclasses import replace

import numpy as np

from . import definition as definitions

#: Points that lie so near to each other, as a part of how far they lie from the origin, differ by rounding.
_ROUNDING = 1e-13


def patches_of(definition):
    """The patches of a definition, as a list."""
    patch_set = definitions.to_patch_set(definition)
    return [patch_set[i] for i in range(len(patch_set))]


def sewn(before, patches, parents, joined=()):
    """The definition of patches, each of which came of the piece of `before` whose number is in `parents`.

    A patch that is as it was keeps its rows of the pool, but for those that it is to share. On the borders of others equal points are one row where both
    came of one piece, or of two that shared a row; within one patch, where its border had points in one row.
    joined: pairs of numbers of patches that share their points from now on.
    """
    if before.form == 'patch' and len(patches) == 1:
        return definitions.from_value(patches[0])
    pools, pieces, count, were = [before.pool], [], len(before.pool), patches_of(before)
    for patch, parent in zip(patches, parents):
        piece = before.pieces[parent]
        if patch != were[parent]:
            own = definitions.from_value(patch)
            piece = replace(own.pieces[0], indices=own.pieces[0].indices + count)
            pools.append(own.pool)
            count += len(own.pool)
        pieces.append(piece)
    pool = np.concatenate(pools)
    row_of = _rows(pool, len(before.pool), pieces, _Links(before.pieces, parents, joined))
    pieces = [replace(piece, indices=row_of[piece.indices]) for piece in pieces]
    used, indices = np.unique(np.concatenate([piece.indices.ravel() for piece in pieces]), return_inverse=True)
    return replace(before, form='patch_set', pool=pool[used], pieces=_renumbered(pieces, indices))


def _renumbered(pieces, indices):
    parts = np.split(indices.astype(np.int32), np.cumsum([piece.indices.size for piece in pieces])[:-1])
    return tuple(replace(piece, indices=part.reshape(piece.indices.shape)) for piece, part in zip(pieces, parts))


class _Links:
    """Which patches may share points, by their numbers."""

    def __init__(self, pieces, parents, joined):
        self._rows = [frozenset(piece.indices.ravel().tolist()) for piece in pieces]
        self._are_folded = [len(np.unique(border)) < len(border) for border in map(_border, pieces)]
        self._parents = parents
        self._joined = {pair for a, b in joined for pair in ((a, b), (b, a))}

    def are_joined(self, a, b):
        return (a, b) in self._joined

    def __call__(self, a, b):
        parent, other = self._parents[a], self._parents[b]
        if a == b:
            return self._are_folded[parent]
        return parent == other or self.are_joined(a, b) or not self._rows[parent].isdisjoint(self._rows[other])


def _rows(pool, kept, pieces, are_linked):
    """For each row of the pool its replacement. The first `kept` rows stay, unless patches are joined that have them."""
    rows = [np.unique(_border(piece)) for piece in pieces]
    owners = np.repeat(np.arange(len(pieces)), list(map(len, rows)))
    rows = np.concatenate(rows)
    row_of = np.arange(len(pool))
    for cluster in _clusters(_scaled(pool)[rows]):
        known = []
        for row, owner in sorted(zip(rows[cluster].tolist(), owners[cluster].tolist())):
            are_one = are_linked if row >= kept else are_linked.are_joined
            same = (other for other, its in known if are_one(owner, its))
            row_of[row] = row_of[next(iter(same), row)]
            known.append((row, owner))
    return row_of


def _border(piece):
    """The rows of all nets around a patch."""
    grids = piece.indices.reshape(-1, *piece.indices.shape[-2:])
    is_border = np.ones(grids.shape[1:], bool)
    is_border[1:-1, 1:-1] = False
    return grids[:, is_border].ravel()


def _scaled(pool):
    """The pool in units of how far most of its points lie from the origin, and of its weights."""
    size, weight = (np.median(np.abs(part[part != 0])) if part.any() else 1.0 for part in (pool[:, :3], pool[:, 3]))
    return pool / (size, size, size, weight)


def _clusters(points):
    """Arrays of the numbers of points that lie within rounding of each other; none of a single point."""
    allowed = _ROUNDING * np.maximum(1.0, np.abs(points).max(axis=1))
    along = points @ (0.6180339887, 0.3819660113, 0.7548776662, 0.5698402910)
    order = np.argsort(along, kind='stable')
    for group in np.split(order, np.flatnonzero(np.diff(along[order]) > 4 * allowed[order][1:]) + 1):
        while len(group) > 1:
            is_near = (np.abs(points[group] - points[group[0]]) <= allowed[group[0]]).all(axis=1)
            if is_near.sum() > 1:
                yield group[is_near]
            group = group[~is_near]
