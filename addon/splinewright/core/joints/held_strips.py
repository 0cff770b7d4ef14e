"""What a joint or seam that holds asks of the rows of the pool beside it, as linear equations of where these lie.

With A and B for homogeneous points and t across from the first side into the second, and numbers that are one along the edge:
B_t = k A_t + g A and B_tt = k² A_tt + m A_t + e A. Of C1 and C2 k is 1 and m is 2 g k. The numbers are read from a pool in which
it holds; the weights stay.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from . import held_joints

#: How exactly the equations are to be met by the pool that their numbers are read from, as a part of their terms.
_HOLDS = 1e-6


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
    order = int(held.smoothness[1])
    first, second = strips_of(definition, held)
    edge = pool[first.rows[0]]
    if not edge[:, 3].all():
        return None
    unit = max(first.spans[0], second.spans[0])
    out, into = _derivatives(first, -1.0, unit), _derivatives(second, 1.0, unit)
    legs = [_about(pool[strip.rows], edge) for strip in (first, second)]
    scale = max(np.abs(leg[..., :3]).max() for leg in legs) or 1.0
    legs = [leg / ([scale] * 3 + [1.0]) for leg in legs]
    weights = [np.where(pool[strip.rows, 3] != 0, pool[strip.rows, 3], 1.0) for strip in (first, second)]
    read = _Numbers(held.smoothness[0] == 'C', legs, out, into)
    factors = []
    for k in range(1, order + 1):
        if not read.holds(k):
            return None
        on_first, on_edge = read.on_first(k)
        of_first = -on_first[:, None] * weights[0]
        of_first[0] -= on_edge * weights[0][0]
        factors.append(np.concatenate([of_first, into[k][:, None] * weights[1]]).T)
    rows = np.concatenate([first.rows, second.rows]).T
    return Equations(rows, np.array(factors).reshape(order, len(rows), 6))


def _derivatives(strip, sign, unit):
    """(3, 3): what the rows count in the derivatives across (The NURBS Book, formulas 3.4 and 3.8)."""
    p, (one, two) = strip.degree, np.array(strip.spans) / unit
    slope, bend = sign * p / one, (p - 1) * p / one
    return np.array([[1.0, 0.0, 0.0], [-slope, slope, 0.0], [bend / one, -bend * (1 / one + 1 / two), bend / two]])


def _about(rows, edge):
    """Homogeneous rows (3, n, 4) about the points of the edge."""
    finite = rows[..., 3:] != 0
    places = np.where(finite, (rows[..., :3] - edge[:, :3]) * rows[..., 3:], rows[..., :3])
    return np.concatenate([places, rows[..., 3:]], -1)


class _Numbers:
    """k, g, m and e by least squares."""

    def __init__(self, is_parametric, legs, out, into):
        self._is_parametric = is_parametric
        self._out, self._into = out, into
        self._first, self._second = legs
        self._edge = legs[0][0][:, 3]
        slope_a, slope_b = self._at(1)
        self._k = 1.0 if is_parametric else _ratio(slope_b[:, :3], slope_a[:, :3])
        self._g = _ratio(slope_b[:, 3] - self._k * slope_a[:, 3], self._edge)
        bend_a, bend_b = self._at(2)
        rest = bend_b - self._k**2 * bend_a
        self._m = 2 * self._g * self._k if is_parametric else _ratio(rest[:, :3], slope_a[:, :3])
        self._e = _ratio(rest[:, 3] - self._m * slope_a[:, 3], self._edge)

    def on_first(self, order):
        """(3,) and a number: what the rows of the first side count in the derivative of this order, and its edge beside that."""
        if order == 1:
            return self._k * self._out[1], self._g
        return self._k**2 * self._out[2] + self._m * self._out[1], self._e

    def holds(self, order):
        """Whether the rows meet the equation of this order, up to rounding."""
        on_first, on_edge = self.on_first(order)
        terms = [*(-factor * row for factor, row in zip(on_first, self._first)),
                 *(factor * row for factor, row in zip(self._into[order], self._second))]
        edge = np.zeros_like(terms[0])
        edge[:, 3] = -on_edge * self._edge
        terms.append(edge)
        sizes = np.abs(terms).max((0, 1))
        size = np.array([sizes[:3].max()] * 3 + [sizes[3]])
        return self._k > 0 and bool((np.abs(sum(terms)) <= _HOLDS * size).all())

    def _at(self, order):
        """(n, 4) of both sides: their derivatives at the edge."""
        return (np.tensordot(self._out[order], self._first, 1), np.tensordot(self._into[order], self._second, 1))


def _ratio(of, by):
    square = float((by * by).sum())
    return float((of * by).sum()) / square if square > 0 else 0.0
