"""Where on a piece of a shape one points at, and what a knot there would be, as lines."""

from typing import NamedTuple

import numpy as np

from ..shape import parameters
from . import patch_verbs

#: Points of a span between which a curve is seen as straight.
_PER_SPAN = 24
#: Points of a line across a patch.
_PER_LINE = 65


class Samples(NamedTuple):
    """Points (n, 3) of a curve at its parameters (n,), nan where it lies at infinity."""

    parameters: np.ndarray
    points: np.ndarray


def samples(curve):
    """The Samples of a curve, by which its parameter at a pixel is found."""
    ends = np.concatenate([[0.0], *(np.linspace(start, end, _PER_SPAN + 1)[1:] for start, end in parameters.spans_of(curve))])
    start, end = curve.domain
    at = start + ends * (end - start)
    return Samples(at, curve.evaluate(at, at_infinity='nan'))


def of_domain(piece, fractions):
    """The parameters of a curve or patch at parts of its domain, one for each axis."""
    domains = (piece.domain,) if len(fractions) == 1 else piece.domain
    return tuple(start + float(part) * (end - start) for (start, end), part in zip(domains, fractions))


def in_middle(piece, aimed):
    """The middle of the span that each of the parameters lies in."""
    axes = (piece,) if len(aimed) == 1 else [patch_verbs.Along(piece, axis) for axis in 'uv']
    return tuple(_middle(axis, parameter) for axis, parameter in zip(axes, aimed))


def _middle(curve, parameter):
    middles, widths = parameters.span_middles(curve), parameters.span_widths(curve)
    return float(middles[np.abs((parameter - middles) / widths).argmin()])


def lines(piece, aimed, direction):
    """Polylines (n, 3) along which knots would lie: the point of a curve; of a patch the isocurves of the U, V or BOTH
    parameters."""
    if len(aimed) == 1:
        return [piece.evaluate([aimed[0]], at_infinity='nan')]
    (start_u, end_u), (start_v, end_v) = piece.domain
    u, v = aimed
    of = {'U': piece.evaluate(np.full(_PER_LINE, u), np.linspace(start_v, end_v, _PER_LINE), at_infinity='nan'),
          'V': piece.evaluate(np.linspace(start_u, end_u, _PER_LINE), np.full(_PER_LINE, v), at_infinity='nan')}
    return [of[axis] for axis in 'UV' if direction in (axis, 'BOTH')]
