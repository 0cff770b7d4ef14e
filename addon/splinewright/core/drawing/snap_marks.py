"""Where the drawing may meet curves that are there: their ends, middles, and where they are met at a right angle."""

from typing import NamedTuple

import numpy as np

END, MIDPOINT, FOOT = "End", "Midpoint", "Perpendicular"
#: Steps in which a foot is looked for, of a segment that is bent; halvings that find it.
_STEPS, _HALVINGS = 64, 50


class Mark(NamedTuple):
    """A place (3,), and what it is called."""

    name: str
    place: np.ndarray


def segments(curves):
    """The parts of curves between corners and joints, as NURBS."""
    return [part for curve in curves for part in _parted(curve.to_nurbs())]


def _parted(curve):
    start, end = curve.domain
    knots, counts = np.unique(curve.knots, return_counts=True)
    cuts = knots[(counts >= curve.degree) & (knots > start) & (knots < end)]
    return curve.parts(cuts) if len(cuts) else [curve]


def of_segments(found):
    """The Marks of segments() that do not depend on the drawing."""
    return [mark for curve in found for mark in _own(curve)]


def _own(curve):
    start, end = curve.domain
    ends = curve.evaluate(np.array([start, end]))
    if not (ends[0] == ends[1]).all():
        yield Mark(END, ends[0])
        yield Mark(END, ends[1])
    if curve.degree == 1 and len(curve.points) == 2:
        yield Mark(MIDPOINT, ends.mean(0))
        return
    length = curve.length()
    if length > 0:
        yield Mark(MIDPOINT, curve.evaluate(curve.parameter_at_length(0.5 * length)))


def feet(found, point):
    """The Marks on segments() where the way to a point (3,) is at right angles to them."""
    return [Mark(FOOT, place) for curve in found for place in _feet(curve, np.asarray(point))]


def _feet(curve, point):
    def across(u):
        jets = curve.derivatives(u, 1)
        return ((jets[..., 0, :] - point) * jets[..., 1, :]).sum(-1)

    steps = 1 if curve.degree == 1 else _STEPS
    u = np.linspace(*curve.domain, steps + 1)
    values = across(u)
    for i in np.flatnonzero(values[:-1] * values[1:] < 0):
        low, high, is_rising = u[i], u[i + 1], values[i] < 0
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if (across(middle) < 0) == is_rising else (low, middle)
        yield curve.evaluate(0.5 * (low + high))
