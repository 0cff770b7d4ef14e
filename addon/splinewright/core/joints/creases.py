"""Knots inside patches at which these may have a crease, as their points alone meet there, and those at which they have one."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc
from .joints import SMOOTH

#: So many knots are measured.
_MOST = 64


class Crease(NamedTuple):
    """Of a patch, counted from 0, along an axis, 'u' or 'v', a knot, and the splinecore SeamContinuity there."""

    patch: int
    axis: str
    knot: float
    measured: object


def creases_of(definition):
    """(the Creases of a definition of patches, how many other knots inside may come to have one, or were too many to be
    measured)."""
    places = [(i, axis, knot) for i, piece in enumerate(definition.pieces) for axis in 'uv' for knot in _sharp_knots(piece, axis)]
    found, patches = [], {}
    for i, axis, knot in places[:_MOST]:
        if i not in patches:
            patches[i] = _patch(definition, i)
        measured = _measured(patches[i], axis, knot)
        if measured is not None and measured.g < 1:
            found.append(Crease(i, axis, knot, measured))
    return found, len(places) - len(found)


def _patch(definition, number):
    """The NurbsPatch of a piece of a definition."""
    piece = definition.pieces[number]
    rows = definition.pool[piece.indices]
    return sc.NurbsPatch(piece.degree, piece.knots, rows[..., :3], rows[..., 3], piece.periodic)


def _sharp_knots(piece, axis):
    """The knots inside a piece, of a periodic one the first one, too, that are as often there as its degree says."""
    if piece.kind != 'nurbs':
        return []
    axis = 'uv'.index(axis)
    knots, degree = piece.knots[axis], piece.degree[axis]
    inner = knots[:-1] if piece.periodic[axis] else knots[(knots > knots[degree]) & (knots < knots[-degree - 1])]
    values, times = np.unique(inner, return_counts=True)
    return values[times >= degree].tolist()


def _measured(patch, axis, knot):
    try:
        parts = patch.split(axis, knot)
        return sc.seam_continuity(parts[0], f"{axis}_end", parts[-1], f"{axis}_start", tolerance=SMOOTH, reversed=False)
    except (sc.InvalidShape, sc.PointAtInfinity):
        return None
