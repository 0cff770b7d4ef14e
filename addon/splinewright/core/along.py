"""Radius and tilt along a curve, as its control points have them: joints of chains go over into each other evenly, as in
Blender's own Bezier curves, other control points by the basis of the curve, as in its NURBS.

Columns: radius, tilt. Places are parts of the domain of a curve.
"""

from dataclasses import dataclass

import numpy as np

from . import handles
from .library import sc

#: The least radius that a change leaves, Blender's own.
LEAST_RADIUS = 0.001
#: How much less it counts that values stay where they are than that what they give fits.
_PULL = 1e-6
#: More entries of a matrix than this are not solved for.
_MOST = 4_000_000


def places(definition, number, curve, steps):
    """(m,): where a piece is to be told of, so many steps to each of its spans."""
    ends = handles.joints(definition, definition.pieces[number])
    if not len(ends):
        nurbs = curve.to_nurbs()
        knots, (start, end) = np.unique(nurbs.knots), nurbs.domain
        ends = (knots[(knots >= start) & (knots <= end)] - start) / (end - start)
    ends = np.unique(np.clip(np.concatenate([[0.0], ends, [1.0]]), 0.0, 1.0))
    return np.interp(np.arange(steps * (len(ends) - 1) + 1) / steps, np.arange(len(ends)), ends)


def counting(definition, number, curve, at):
    """(m, n): how much each of the points that the net shows of a piece counts at places (m,) on it, and behind them those
    at infinity."""
    piece = definition.pieces[number]
    joints = handles.joints(definition, piece)
    if len(joints):
        closed = joints[-1] < 1.0
        ends, which = (np.append(joints, 1.0), [*range(len(joints)), 0]) if closed else (joints, range(len(joints)))
        return _together(np.stack([np.interp(at, ends, row) for row in np.eye(len(ends))], 1), which)
    own = _by_basis(curve.to_nurbs(), at)
    rows = piece.indices
    is_merged = len(rows) > 2 and rows[0] == rows[-1]
    own = _together(own, [*range(len(rows) - 1), 0]) if is_merged else own
    rows = rows[:-1] if is_merged else rows
    return own[:, np.argsort(definition.pool[rows, 3] == 0, kind='stable')]


def _together(columns, which):
    """The sums of those columns that are of the same point."""
    found = np.zeros((len(columns), max(which) + 1))
    for column, i in zip(columns.T, which):
        found[:, i] += column
    return found


def _by_basis(curve, at):
    """(m, n): the basis of a curve, with its weights where they are of one sign."""
    start, end = curve.domain
    parameters, count = np.clip(start + at * (end - start), start, end), len(curve.points)
    weights = np.abs(curve.weights) if (curve.weights > 0).all() or (curve.weights < 0).all() else None
    columns = []
    for i in range(0, count, 3):
        points = np.zeros((count, 3))
        points[np.arange(i, min(i + 3, count)), np.arange(min(3, count - i))] = 1.0
        columns.append(sc.NurbsCurve(curve.degree, curve.knots, points, weights, curve.periodic).evaluate(parameters))
    return np.concatenate(columns, 1)[:, :count]


@dataclass(frozen=True, eq=False)
class Held:
    """What lies along a piece before some of its control points are changed."""

    at: np.ndarray                      # (m,)
    values: np.ndarray                  # (m, 2)
    basis: np.ndarray                   # (m, n): counting()
    own: np.ndarray                     # (n, 2) of its points


def held(at, values, basis):
    """The Held of values (m, 2) at places; the points have what gives them, as nearly as can be."""
    near = basis.argmax(0)              # where each point counts most
    first = values[near]
    if (values == values[0]).all() or basis.size > _MOST:
        return Held(at, values, basis, first)
    count = basis.shape[1]
    missing = np.concatenate([values - basis @ first, np.zeros((count, 2))])
    return Held(at, values, basis, first + np.linalg.lstsq(np.concatenate([basis, _PULL * np.eye(count)]), missing, rcond=None)[0])


def changed(before, points, factor=1.0, angle=0.0):
    """(m, 2): the values of a Held when the radii of some points, by their numbers, are multiplied, and their tilts turned."""
    radii, counts, found = before.own[points, 0], before.basis[:, points], before.values.copy()
    if factor != 1.0:
        found[:, 0] = np.maximum(found[:, 0] + counts @ (np.maximum(radii * factor, LEAST_RADIUS) - radii), 0.0)
    found[:, 1] += counts.sum(1) * angle
    return found
