"""Nets in piecewise Bezier form along one axis: linear in the homogeneous points, so weights may be anything."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc


class Axis(NamedTuple):
    """Degree and knots of a curve, or of u or v of a patch; periodic ones hold one period."""

    degree: int
    knots: np.ndarray
    periodic: bool = False

    @property
    def domain(self):
        return sc.basis.KnotVector(self.degree, self.knots, self.periodic).domain

    @property
    def joints(self):
        """The distinct knots of the domain."""
        start, end = self.domain
        inner = self.knots[(self.knots > start) & (self.knots < end)]
        return np.unique([start, *inner, end])


def bezier_rows(axis, rows, joints):
    """The (k * degree + 1, c) rows of k Bezier pieces that meet at `joints`, for (n, c) rows on the
    axis. `joints` are those of the axis and any more; no inner knot may break the rows apart."""
    cuts = np.setdiff1d(joints, axis.joints)
    columns = [_bezier_columns(axis, rows[:, i:i + 3], cuts) for i in range(0, rows.shape[1], 3)]
    return np.concatenate(columns, axis=1)


def _bezier_columns(axis, columns, cuts):
    """bezier_rows() of up to three columns: those of a curve without weights."""
    points = np.zeros((len(columns), 3))
    points[:, :columns.shape[1]] = columns
    curve = sc.NurbsCurve(axis.degree, axis.knots, points, periodic=axis.periodic)
    if len(cuts):
        curve = curve.refine(cuts)
    pieces = [piece.homogeneous_points[:, :columns.shape[1]] for piece in curve.to_bezier()]
    return np.concatenate([pieces[0][:1], *(piece[1:] for piece in pieces)])


def homogeneous(points, weights):
    """(..., 4): the points times their weights, and the weights; a weight of 0 keeps the direction."""
    scale = np.where(weights == 0, 1.0, weights)[..., None]
    return np.concatenate([points * scale, weights[..., None]], axis=-1)
