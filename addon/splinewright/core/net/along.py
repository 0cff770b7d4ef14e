"""Radius and tilt along a curve, as its control points have them: joints of chains go over into each other as in Blender's
own Bezier curves, other control points by the basis of the curve, as in its NURBS.

Columns: radius, tilt. Places are parts of the domain of a curve.
"""

from dataclasses import dataclass
from typing import Callable, NamedTuple

import numpy as np

from ..base.library import sc
from ..native import native_along
from . import handles

#: The least radius that a change leaves, Blender's own.
LEAST_RADIUS = 0.001
#: More entries of a matrix than this are not solved for.
_MOST = 4_000_000


def places(definition, number, curve, steps):
    """(m,): where a piece is reported, a given number of steps to each of its spans."""
    ends = handles.joints(definition, definition.pieces[number])
    if not len(ends):
        nurbs = curve.to_nurbs()
        knots, (start, end) = np.unique(nurbs.knots), nurbs.domain
        ends = (knots[(knots >= start) & (knots <= end)] - start) / (end - start)
    ends = np.unique(np.clip(np.concatenate([[0.0], ends, [1.0]]), 0.0, 1.0))
    return np.interp(np.arange(steps * (len(ends) - 1) + 1) / steps, np.arange(len(ends)), ends)


class Mixture(NamedTuple):
    """What lies at places on a piece, of what lies at its points: those that the net shows, and behind them those at
    infinity."""

    of: Callable                        # (n, k) of the points -> (m, k) at the places
    own: np.ndarray                     # (n,) where on the piece each of the points counts most, or so
    is_met: bool                        # whether what lies there is what the points have


def mixture(definition, number, curve, at, way='LINEAR'):
    """The Mixture of a piece at places (m,). way: how joints go over into each other, as Blender names it."""
    piece = definition.pieces[number]
    joints = handles.joints(definition, piece)
    if len(joints):
        closed = bool(joints[-1] < 1.0)
        ends = np.append(joints, 1.0) if closed else joints
        fractions = np.interp(at, ends, np.linspace(0.0, 1.0, len(ends)))
        return Mixture(lambda columns: native_along.along_bezier(columns, closed, fractions, [way] * columns.shape[1]),
                       joints, way != 'BSPLINE')
    nurbs, ranks, order = _basis_of(definition, piece, curve)
    return Mixture(lambda columns: _by_basis(nurbs, columns[ranks], at), _middles(nurbs)[order], False)


def _basis_of(definition, piece, curve):
    """(the NURBS of a piece, for each of its control points the number of that which the net shows, for each of those the
    number of the control point)."""
    rows = piece.indices
    numbers = np.arange(len(rows))
    if len(rows) > 2 and rows[0] == rows[-1]:
        numbers[-1], rows = 0, rows[:-1]
    order = np.argsort(definition.pool[rows, 3] == 0, kind='stable')
    return curve.to_nurbs(), np.argsort(order)[numbers], order


def _mixing(curve, points):
    """A curve of points (n, 3) by the basis of another, with its weights where they are of one sign."""
    weights = np.abs(curve.weights) if (curve.weights > 0).all() or (curve.weights < 0).all() else None
    return sc.NurbsCurve(curve.degree, curve.knots, points, weights, curve.periodic)


def _by_basis(curve, columns, at):
    """(m, k) of columns (n, k) by the basis of a curve, with its weights where they are of one sign."""
    start, end = curve.domain
    parameters = np.clip(start + at * (end - start), start, end)
    found = []
    for i in range(0, columns.shape[1], 3):
        points = np.zeros((len(columns), 3))
        points[:, :columns[:, i:i + 3].shape[1]] = columns[:, i:i + 3]
        found.append(_mixing(curve, points).evaluate(parameters))
    return np.concatenate(found, 1)[:, :columns.shape[1]]


def factor(definition, number, curve, own):
    """The curve over the domain of a piece of which x is what lies along it, where its points have own (n,), as of Held.own:
    by the basis of the curve; between joints of chains without overshoot."""
    piece = definition.pieces[number]
    joints = handles.joints(definition, piece)
    start, end = curve.domain
    if len(joints):
        closed = bool(joints[-1] < 1.0)
        at, values = (np.append(joints, 1.0), np.append(own, own[0])) if closed else (joints, np.asarray(own))
        slopes = _slopes(at, values, closed) / (end - start)
        along = [np.column_stack([column, np.zeros((len(at), 2))]) for column in (values, slopes)]
        return sc.HermiteCurve(*along, np.append(start + at[:-1] * (end - start), end))
    nurbs, ranks, _ = _basis_of(definition, piece, curve)
    return _mixing(nurbs, np.column_stack([np.asarray(own)[ranks], np.zeros((len(ranks), 2))]))


def _slopes(at, values, closed):
    """(n,): harmonic means of the slopes before and behind where these are of one sign, otherwise 0."""
    secants = np.diff(values) / np.diff(at)
    before = np.concatenate([secants[-1:] if closed else secants[:1], secants])
    behind = np.concatenate([secants, secants[:1] if closed else secants[-1:]])
    with np.errstate(divide='ignore', invalid='ignore'):
        return np.where(before * behind > 0, 2.0 / (1.0 / before + 1.0 / behind), 0.0)


def _middles(curve):
    """(n,): of each control point the mean of its inner knots, as a part of the domain."""
    (start, end), degree, count = curve.domain, curve.degree, len(curve.points)
    first = np.arange(count)[:, None] + np.arange(1, degree + 1)
    if curve.periodic:
        turns, numbers = np.divmod(first - degree, count)
        knots = curve.knots[numbers] + turns * (end - start)
        return (knots.mean(1) - start) / (end - start) % 1.0
    return np.clip((curve.knots[first].mean(1) - start) / (end - start), 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class Held:
    """What lies along a piece before some of its control points are changed."""

    values: np.ndarray                  # (m, 2)
    mixtures: tuple                     # of each column
    own: np.ndarray                     # (n, 2) of its points


def held(at, values, mixtures):
    """The Held of values (m, 2) at places; the points have what gives them, as nearly as can be."""
    own = []
    for column, mixed in zip(values.T, mixtures):
        first = np.interp(mixed.own, at, column)
        if not mixed.is_met and (column != column[0]).any() and len(first) * len(at) <= _MOST:
            first = native_along.nearest(mixed.of(np.eye(len(first))), first, column)
        own.append(first)
    return Held(values, mixtures, np.stack(own, 1))


def changed(before, points, factor=1.0, angle=0.0):
    """(m, 2): the values of a Held when the radii of some points, by their numbers, are multiplied, and their tilts turned."""
    found, steps = before.values.copy(), np.zeros((len(before.own), 2))
    if factor != 1.0:
        radii = before.own[points, 0]
        steps[points, 0] = np.maximum(radii * factor, LEAST_RADIUS) - radii
    steps[points, 1] = angle
    for i, mixed in enumerate(before.mixtures):
        found[:, i] += mixed.of(steps[:, i:i + 1])[:, 0]
    found[:, 0] = np.maximum(found[:, 0], 0.0)
    return found
