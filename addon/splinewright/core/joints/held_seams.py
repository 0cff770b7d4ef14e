"""Seams of patches that are made smooth again whenever a side of theirs has moved (lecture row S21)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc


def meet(definition, held):
    """Whether the two sides of a seam are one edge of two patches: the same rows of the pool."""
    if held.first[0] == held.second[0]:
        return False
    sides = [_border(definition.pieces[patch], side) for patch, side in (held.first, held.second)]
    return any(np.array_equal(sides[0], other) for other in (sides[1], sides[1][::-1]))


def _border(piece, side):
    axis, end = side.split('_')
    net = piece.indices[0] if piece.kind == 'hermite' else piece.indices
    return np.take(net, 0 if end == 'start' else -1, 'uv'.index(axis))


def made_to_hold(definition, pool, held, _led):
    """(m,) rows of the pool of both patches, and (m, 4) what they are when the seam holds. Raises Refusal where it takes other
    knots."""
    if not meet(definition, held):
        raise Refusal("a seam that is to hold is none any more: release it")
    pieces = [definition.pieces[patch] for patch, _ in (held.first, held.second)]
    patches = [_patch(piece, pool) for piece in pieces]
    joined = sc.build.join_patches(patches[0], held.first[1], patches[1], held.second[1], held.smoothness, held.moves)
    rows, values = [], []
    for piece, before, after in zip(pieces, patches, (joined.first, joined.second)):
        if after.points.shape != before.points.shape or not all(map(np.array_equal, after.knots, before.knots)):
            raise Refusal("the patches at a locked seam have other knots or degrees now: unlock it, and lock it again")
        rows.append(piece.indices.ravel())
        values.append(np.dstack([after.points, after.weights]).reshape(-1, 4))
    return np.concatenate(rows), np.concatenate(values)


def _patch(piece, pool):
    """The NurbsPatch of a piece with its points from a pool."""
    rows = pool[piece.indices]
    if piece.kind == 'bezier':
        return sc.BezierPatch(rows[..., :3], rows[..., 3]).to_nurbs()
    if piece.kind != 'nurbs':
        raise Refusal("seams of Hermite patches do not hold: make them NURBS patches first")
    return sc.NurbsPatch(piece.degree, piece.knots, rows[..., :3], rows[..., 3], piece.periodic)
