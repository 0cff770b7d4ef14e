"""Parameters that come from Blender's properties, which are float32, and the float64 knots that are meant."""

import numpy as np

from ..base import decimals


#: What is nearer to a knot than this part of all knots lies at it.
_AT_KNOT = 1e-9


class Exact(float):
    """A parameter that was worked out, not typed: it stands for itself."""


class Given(float):
    """A parameter that a command was given with every digit: it stands for itself, or for the knot that it lies at."""


def given(number, text):
    """A number that one of Blender's properties has; Given where the text beside it has that number with every digit."""
    try:
        exact = float(text)
    except ValueError:
        return number
    return Given(exact) if decimals.single(exact) == number else number


def snapped(number, knots):
    """decimals.typed(), or of the knots that are this number as float32 the one nearest to it; an Exact one as it is, a Given one
    or the knot that it lies at.

    So a knot such as 1/3 can be named in a property that holds float32.
    """
    if isinstance(number, Exact):
        return float(number)
    if isinstance(number, Given):
        nearest = knots[np.abs(knots - number).argmin()]
        return float(nearest if abs(nearest - number) <= _AT_KNOT * np.ptp(knots) else number)
    number = decimals.typed(number)
    with np.errstate(over='ignore'):
        same = knots[knots.astype(np.float32) == np.float32(number)]
    return float(same[np.abs(same - number).argmin()]) if len(same) else number


def knots_of(curve):
    """The float64 parameters of a curve that a number may mean: its knots; of a Bezier curve its ends."""
    return np.asarray(curve.to_nurbs().knots)


def inner_knots(curve):
    """The distinct knots inside the domain of a curve, growing."""
    start, end = curve.domain
    knots = np.unique(knots_of(curve))
    return knots[(knots > start) & (knots < end)]


def middle(curve):
    """The parameter in the middle of the domain."""
    start, end = curve.domain
    return start + (end - start) / 2


def middle_of_widest_span(curve):
    """The parameter in the middle of the widest span; of equal ones, the one nearest to middle()."""
    middles, widths = _spans(curve)
    widest = middles[widths >= widths.max() * (1 - 1e-9)]
    return float(widest[np.abs(widest - middle(curve)).argmin()])


def span_middles(curve):
    """The parameter in the middle of every span."""
    return _spans(curve)[0]


def span_widths(curve):
    """How long every span is."""
    return _spans(curve)[1]


def spans_of(curve):
    """Pairs of where each span starts and ends, as parts of the domain."""
    ends, (start, end) = _ends(curve), curve.domain
    fractions = ((ends - start) / (end - start)).tolist()
    return list(zip(fractions, fractions[1:]))


def _spans(curve):
    ends = _ends(curve)
    return ends[:-1] + np.diff(ends) / 2, np.diff(ends)


def _ends(curve):
    start, end = curve.domain
    return np.concatenate([[start], inner_knots(curve), [end]])
