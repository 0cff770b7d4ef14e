"""Which of Blender's eight kinds of knots a knot vector is."""

import numpy as np

from . import native
from .native import Direction, Flags

#: Knots that differ by less, relative to the domain, are Blender's: it rounds its own to float32.
KNOT_ROUNDING = 1e-12

#: Of two that fit equally the first is taken.
_OPEN = (Flags(endpoint=True), Flags(), Flags(endpoint=True, bezier=True), Flags(bezier=True))
_CYCLIC = tuple(flags._replace(cyclic=True) for flags in _OPEN)


def matching_direction(axis, count):
    """The Direction of count points whose knots are those of the axis up to scale and shift, or None.

    The outermost knots of an open axis have no effect on the shape: they choose between two that fit.
    """
    fitting = []
    for flags in _CYCLIC if axis.periodic else _OPEN:
        direction = Direction(count, axis.degree, flags)
        if native.is_valid_curve(direction) and native.used_count(direction) == count:
            distances = _distances(axis, direction)
            if (distances if axis.periodic else distances[1:-1]).max() <= KNOT_ROUNDING:
                fitting.append((distances.max(), direction))
    return min(fitting, key=lambda pair: pair[0])[1] if fitting else None


def _distances(axis, direction):
    """How far each knot lies from Blender's, with both domains stretched to [0, 1]."""
    theirs = native.periodic_knots(direction) if direction.flags.cyclic else native.plain_knots(direction)
    return np.abs(_from_0_to_1(axis.knots, axis.domain) - _from_0_to_1(theirs, native.domain(direction)))


def _from_0_to_1(knots, domain):
    start, end = domain
    return (knots - start) / (end - start)
