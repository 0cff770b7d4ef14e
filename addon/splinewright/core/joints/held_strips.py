"""What a joint or seam that holds asks of the rows of the pool beside it, as linear equations of where these lie."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import held_joints


class Strip(NamedTuple):
    """The first rows of a side, from the edge on."""

    rows: np.ndarray                    # (3, n) of the pool
    degree: int
    spans: tuple                        # from the edge to the first and second knot beyond it


class Equations(NamedTuple):
    """Of n columns: the sum of factors times what the rows move by is to be 0, in one equation for each order from 1 on."""

    rows: np.ndarray                    # (n, 6): three of each side
    factors: np.ndarray                 # (orders, n, 6)


def strips_of(definition, held):
    """Both Strips, the columns of the second in the order of the first's. Raises Refusal where they are none."""
    if definition.has_curves:
        return tuple(_of_curve(side) for side in held_joints.sides_of(definition, held))
    first, second = (_of_patch(definition.pieces[patch], side) for patch, side in (held.first, held.second))
    if not np.array_equal(first.rows[0], second.rows[0]):
        second = second._replace(rows=second.rows[:, ::-1])
        if not np.array_equal(first.rows[0], second.rows[0]):
            raise Refusal("a seam that is to hold is none any more: release it")
    return first, second


def _of_curve(side):
    rows = np.concatenate([side.rows, np.repeat(side.rows[:1], 3 - len(side.rows))])
    return Strip(rows[:, None], side.degree, side.spans)


def _of_patch(piece, side):
    axis, is_end = 'uv'.index(side[0]), side.endswith('end')
    if piece.kind == 'hermite':
        raise Refusal("seams of Hermite patches do not hold: make them NURBS patches first")
    rows = np.moveaxis(piece.indices, axis, 0)
    rows = rows[::-1] if is_end else rows
    degree = piece.degree[axis] if piece.kind == 'nurbs' else len(rows) - 1
    knots = piece.knots[axis] if piece.kind == 'nurbs' else np.repeat([0.0, 1.0], degree + 1)
    away = knots[-1] - knots[::-1] if is_end else knots - knots[0]
    if away[degree] > 0:
        raise Refusal("a patch does not end at the edge of its points there")
    spans = tuple(away[[degree + 1, min(degree + 2, len(away) - 1)]])
    return Strip(np.concatenate([rows[:3], np.repeat(rows[:1], max(0, 3 - len(rows)), axis=0)]), degree, spans)


def equations_of(definition, held, pool):
    """The Equations of a Held, its numbers from a pool in which it holds; None where it does not hold there, or lies at infinity.
    Raises Refusal where it is none."""
    first, second = strips_of(definition, held)
    factors = sc.build.joint_equations(pool[first.rows], first.degree, first.spans, pool[second.rows], second.degree, second.spans,
                                       held.smoothness)
    return None if factors is None else Equations(np.concatenate([first.rows, second.rows]).T, factors)
