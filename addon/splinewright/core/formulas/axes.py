"""Axes with ticks and a grid, as a drawing on paper has them."""

import math

import numpy as np

from ..base.failures import Refusal
from .functions import AXIS, TICK, Part, line

GRID = "grid"
#: Most ticks along an axis.
MOST = 200


def picture(ranges, steps, tick, has_grid):
    """The Parts of axes through the origin, or through the nearest place where ranges leave it out.

    ranges: (first, last) along x and y, or along x, y and z; steps: how far ticks lie apart along each; tick: their length. Raises Refusal.
    """
    ticks = [_multiples(limits, step, name) for limits, step, name in zip(ranges, steps, "xyz")]
    base = [min(max(0.0, first), last) for first, last in ranges]
    parts = _grid(ranges, ticks, base) if has_grid else []
    for axis, limits in enumerate(ranges):
        parts.append(Part(AXIS, line(*(_at(base, axis, end) for end in limits))))
        across, digits = 1 if axis == 0 else 0, _digits(ticks[axis], steps[axis])
        for value in ticks[axis]:
            place = _at(base, axis, value)
            if axis > 0 and value == base[axis] and base[0] in ticks[0]:
                continue                # the first axis has a tick where they cross
            parts.append(Part(f"{TICK} {value:.{digits}g}", line(_at(place, across, place[across] - tick), place)))
    return parts


def _multiples(limits, step, name):
    """The multiples of a step within limits."""
    first, last = limits
    if not first < last:
        raise Refusal("{name} ends at {last:g}: it must be above its start, {first:g}", name=name, last=last, first=first)
    low, high = math.ceil(first / step - 1e-9), math.floor(last / step + 1e-9)
    if high - low >= MOST:
        raise Refusal("{name} has {count} ticks: {most} are the most", name=name, count=high - low + 1, most=MOST)
    return np.arange(low, high + 1) * step + 0.0


def _digits(values, step):
    """How many tell each multiple of a step from the next one, also far from 0."""
    largest = np.abs(values).max(initial=0.0)
    return 6 if largest == 0.0 else min(17, max(6, math.floor(math.log10(largest)) - math.floor(math.log10(step)) + 2))


def _grid(ranges, ticks, base):
    """Lines in the plane of x and y at every tick."""
    lines = []
    for axis, across in ((0, 1), (1, 0)):
        for value in ticks[axis]:
            place = _at(base, axis, value)
            lines.append(Part(GRID, line(*(_at(place, across, end) for end in ranges[across]))))
    return lines


def _at(place, axis, value):
    """A place (x, y, z) with another coordinate."""
    moved = [*place, 0.0][:3]
    moved[axis] = float(value)
    return tuple(moved)
