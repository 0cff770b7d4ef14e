"""Radius and tilt along a curve, as its control points have them: joints of chains go over into each other as in Blender's
own Bezier curves, other control points by the basis of the curve, as in its NURBS.

Columns: radius, tilt. Places are parts of the domain of a curve.
"""

from dataclasses import dataclass

import numpy as np

from . import handles
from .library import sc
from .native import native_along

#: The least radius that a change leaves, Blender's own.
LEAST_RADIUS = 0.001
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


def counting(definition, number, curve, at, way='LINEAR'):
    """(m, n): how much each of the points that the net shows of a piece counts at places (m,) on it, and behind them those
    at infinity. way: how joints go over into each other, as Blender names it."""
    piece = definition.pieces[number]
    joints = handles.joints(definition, piece)
    if len(joints):
        closed = bool(joints[-1] < 1.0)
        ends, count = np.append(joints, 1.0) if closed else joints, len(joints)
        fractions = np.interp(at, ends, np.linspace(0.0, 1.0, len(ends)))
        return native_along.along_bezier(np.eye(count), closed, fractions, [way] * count)
    own = _by_basis(curve.to_nurbs(), at)
    rows = piece.indices
    if len(rows) > 2 and rows[0] == rows[-1]:
        own, rows = np.column_stack([own[:, 0] + own[:, -1], own[:, 1:-1]]), rows[:-1]
    return own[:, np.argsort(definition.pool[rows, 3] == 0, kind='stable')]


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

    values: np.ndarray                  # (m, 2)
    bases: tuple                        # counting() of each column
    own: np.ndarray                     # (n, 2) of its points


def held(values, bases):
    """The Held of values (m, 2) where the points count so much; the points have what gives them, as nearly as can be."""
    own = []
    for column, basis in zip(values.T, bases):
        first = column[basis.argmax(0)]         # where each counts most
        is_plain = (column == column[0]).all() or basis.size > _MOST
        own.append(first if is_plain else native_along.nearest(basis, first, column))
    return Held(values, bases, np.stack(own, 1))


def changed(before, points, factor=1.0, angle=0.0):
    """(m, 2): the values of a Held when the radii of some points, by their numbers, are multiplied, and their tilts turned."""
    radii, found = before.own[points, 0], before.values.copy()
    if factor != 1.0:
        steps = np.maximum(radii * factor, LEAST_RADIUS) - radii
        found[:, 0] = np.maximum(found[:, 0] + before.bases[0][:, points] @ steps, 0.0)
    found[:, 1] += before.bases[1][:, points].sum(1) * angle
    return found
