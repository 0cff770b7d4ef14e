"""A point of a shape is pulled, and its control points follow by the least change."""

from dataclasses import replace

import numpy as np

from . import definition as definitions
from . import verbs
from .failures import Refusal
from .library import sc


def pulled(definition, number, parameters, by, locality=0.0, keeps_tangent=False):
    """The definition with the point of piece `number`, from 0, at (u,) or (u, v) moved by a vector.

    keeps_tangent: of a curve. Raises Refusal or an error of the library.
    """
    pool = definition.pool.copy()
    if definition.has_curves:
        curve, piece = verbs.pieces_of(definition)[number], definition.pieces[number]
        moved = curve.dragged(parameters[0], by, np.zeros(3) if keeps_tangent else None, locality=locality)
        pool[piece.indices, :3] = _rows(moved)
    else:
        pool[:, :3] = definitions.to_patch_set(definition).dragged(number, *parameters, by, locality=locality).points
    if not np.isfinite(pool).all():
        raise Refusal("a point would be too far away for a number")
    return replace(definition, pool=pool)


def _rows(curve):
    """What the indices of a curve's piece stand for."""
    if isinstance(curve, sc.HermiteCurve):
        return np.stack([curve.points, curve.tangents[:, 0], curve.tangents[:, 1]])
    return curve.points


def followers(before, after):
    """(points (k, 3) that moved between two definitions, how far each did as a part of the farthest (k,))."""
    far = np.linalg.norm(after.pool[:, :3] - before.pool[:, :3], axis=1)
    moved = np.flatnonzero((far > 0) & (before.pool[:, 3] != 0))
    return after.pool[moved, :3], far[moved] / far[moved].max(initial=0.0) if len(moved) else far[moved]
