"""Circles and surfaces of revolution to be sculpted: cubic, with single knots and without weights around, so that they stay smooth
whatever is pulled, and near the exact ones."""

import math
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Spans around a whole turn: at least, by which their number grows, and at most.
_FEWEST, _STEP, _MOST = 8, 4, 512
DEGREE = 3
#: A whole turn is as long, in parameters, as the exact one.
_LENGTH = 4.0


class Around(NamedTuple):
    """A circle of radius 1, or an arc of it."""

    knots: np.ndarray
    points: np.ndarray                  # (n, 2)
    periodic: bool
    error: float                        # the largest distance from the exact one


def around(start, sweep, tolerance, keeps_ends=False):
    """The Around from an angle on, None for a whole turn, whose error is at most a tolerance. keeps_ends: where it starts and ends it
    is exact. Raises Refusal."""
    of_spans = _of_spans_through_knots if keeps_ends else _of_spans
    turn = 2 * math.pi if sweep is None else sweep
    share = abs(turn) / (2 * math.pi)
    spans = next((count for count in range(_FEWEST, _MOST + 1, _STEP) if of_spans(count)[1] <= tolerance), None)
    if spans is None:
        raise Refusal("so near to a circle of that size it would take more than {most} points around: give a larger tolerance",
                      most=_MOST)
    spans = max(1, math.ceil(spans * share))
    step = turn / spans
    factor, error = of_spans(2 * math.pi / abs(step))
    count = spans if sweep is None else spans + DEGREE
    angles = start + step * (np.arange(count) - 1)
    points = factor * np.stack([[function(angle) for angle in angles] for function in (math.cos, math.sin)], 1)
    if sweep is None:
        return Around(_LENGTH * np.arange(spans + 1) / spans, points, True, error)
    knots = _LENGTH * share * np.arange(-DEGREE, spans + DEGREE + 1) / spans
    whole = sc.NurbsCurve(DEGREE, knots, np.column_stack([points, np.zeros(count)])).clamped()
    return Around(whole.knots, whole.points[:, :2], False, error)


def _of_spans(count):
    """(by what control points on the circle are multiplied, how far the curve then lies from it): the largest and the smallest
    radius, in the middles of spans and at knots, are as far from 1."""
    at_knots, between = _radii(count)
    return 2 / (at_knots + between), abs(at_knots - between) / (at_knots + between)


def _of_spans_through_knots(count):
    """As _of_spans(), where the curve is exact at knots."""
    at_knots, between = _radii(count)
    return 1 / at_knots, abs(between / at_knots - 1)


def _radii(count):
    """At knots, and in the middles of spans, of control points on a circle of radius 1."""
    step = 2 * math.pi / count
    return (4 + 2 * math.cos(step)) / 6, (46 * math.cos(step / 2) + 2 * math.cos(1.5 * step)) / 48


def ellipse(center, to_a, to_b, tolerance):
    """(the curve, how far it lies from the exact one): of the vectors from the center to the ends of two half axes."""
    longest = max(np.linalg.norm(to_a), np.linalg.norm(to_b))
    found = around(0.0, None, _relative(tolerance, longest))
    points = np.asarray(center) + found.points @ np.array([to_a, to_b])
    return sc.NurbsCurve(DEGREE, found.knots, points, periodic=True), found.error * longest


def revolved(curve, through, direction, start, sweep, tolerance):
    """(the surface of a curve that turns about an axis, how far it lies from the exact one). sweep: None for a whole turn."""
    profile = curve.to_nurbs()
    unit = np.asarray(direction) / np.linalg.norm(direction)
    is_finite = profile.weights != 0
    away = profile.points - np.where(is_finite[:, None], through, 0.0)
    along = np.outer(away @ unit, unit)
    radial = away - along
    aside = np.cross(unit, radial)
    radius = _largest_radius(profile, through, unit, radial)
    found = around(start, sweep, _relative(tolerance, radius))
    feet = along + np.where(is_finite[:, None], through, 0.0)
    points = feet + found.points[:, 0, None, None] * radial + found.points[:, 1, None, None] * aside
    weights = np.tile(profile.weights, (len(points), 1))
    made = sc.NurbsPatch((DEGREE, profile.degree), (found.knots, profile.knots), points, weights, (found.periodic, profile.periodic))
    return made, found.error * radius


def _relative(tolerance, radius):
    return tolerance / radius if radius > 0 else math.inf


def _largest_radius(profile, through, unit, radial):
    """From the axis: that of control points bounds it where all weights are positive."""
    if (profile.weights > 0).all():
        return float(np.linalg.norm(radial, axis=1).max())
    away = profile.evaluate(np.linspace(*profile.domain, 1025)[:-1]) - through
    return 1.01 * float(np.linalg.norm(away - np.outer(away @ unit, unit), axis=1).max())
