"""Affine maps of definitions."""

from dataclasses import replace

import numpy as np

from ..base.failures import Refusal


def transformed(definition, matrix):
    """The definition under a (4, 4) affine matrix. Directions (w = 0) are not moved by its translation.

    A mirroring exchanges u and v of patches, so that normals stay outside.
    Raises Refusal if the matrix flattens space or is not finite.
    """
    matrix = np.asarray(matrix, dtype=np.float64)
    linear, offset = matrix[:3, :3], matrix[:3, 3]
    determinant = np.linalg.det(linear)
    if not np.isfinite(matrix).all() or determinant == 0:
        raise Refusal("the transform has a scale of 0, which would flatten the shape for ever")
    pool = definition.pool.copy()
    pool[:, :3] = pool[:, :3] @ linear.T + np.where(pool[:, 3:] != 0, offset, 0.0)
    pieces = definition.pieces
    if determinant < 0 and not definition.has_curves:
        pieces = tuple(flipped(piece) for piece in pieces)
    return replace(definition, pool=pool, pieces=pieces)


def flipped(piece):
    """The patch with u and v exchanged."""
    if piece.kind == 'hermite':
        indices = piece.indices[[0, 2, 1, 3]].transpose(0, 2, 1)
    else:
        indices = piece.indices.T
    return replace(piece, indices=np.ascontiguousarray(indices), degree=piece.degree[::-1],
                   periodic=piece.periodic[::-1], knots=piece.knots[::-1])


def joined(definitions):
    """One definition of all the pieces of several; all of curves, or all of patches.

    Pools stay apart: points of different definitions are never shared.
    """
    pools, pieces, count = [], [], 0
    for definition in definitions:
        pools.append(definition.pool)
        pieces += [replace(piece, indices=(piece.indices + count).astype(np.int32)) for piece in definition.pieces]
        count += len(definition.pool)
    form = 'curves' if definitions[0].has_curves else 'patch_set'
    return replace(definitions[0], form=form, pool=np.concatenate(pools), pieces=tuple(pieces))


def affine_between(before, after):
    """The (4, 4) affine matrix that takes points (n, 3) to others, or None where there is none.

    Where the points lie in a plane the matrix keeps lengths across it as near to 1 as it can.
    """
    middle, target = before.mean(0), after.mean(0)
    linear, *_ = np.linalg.lstsq(before - middle, after - target, rcond=1e-6)
    spread = before - middle
    _, sizes, axes = np.linalg.svd(spread, full_matrices=False)
    missing = axes[sizes <= 1e-6 * max(sizes[0], np.finfo(float).tiny)]
    linear = linear.T + sum((np.outer(axis, axis) for axis in missing), np.zeros((3, 3)))
    error = np.abs((before - middle) @ linear.T + target - after).max()
    rounding = 8 * float(np.finfo(np.float32).eps) * max(np.abs(after).max(), np.abs(before).max())
    if error > rounding + 1e-6 * np.ptp(after, axis=0).max():
        return None
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, target - linear @ middle
    return matrix
