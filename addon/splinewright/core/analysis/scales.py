"""Axes with numbers and a grid around a shape, as a view shows them: through its origin or near it, with ticks at round steps."""

import math
from typing import NamedTuple

import numpy as np

from ..formulas import axes
from ..formulas.functions import TICK
from ..formulas.labels import Label

#: Between so many and half of them ticks there are along the longest side of a shape.
_TICKS = 12
#: A shape that is no higher than this part of its size has no axis of z.
_FLAT = 1e-6
#: Length of a tick, as a part of the step.
_TICK = 0.15


class Scale(NamedTuple):
    lines: np.ndarray                   # (n, 2, 3): axes and ticks
    grid: np.ndarray                    # (n, 2, 3)
    labels: list                        # of labels.Label: the numbers of ticks


def of(definition):
    """The Scale around the control points of a definition, and around its origin where that is no farther away than they reach."""
    places = definition.pool[definition.pool[:, 3] != 0.0, :3]
    low, high = places.min(axis=0), places.max(axis=0)
    size = float((high - low).max())
    if size == 0.0:
        return Scale(np.empty((0, 2, 3)), np.empty((0, 2, 3)), [])
    low, high = np.where((low > 0.0) & (low <= size), 0.0, low), np.where((high < 0.0) & (high >= -size), 0.0, high)
    size = float((high - low).max())
    step = _round(size / _TICKS)
    count = 3 if high[2] - low[2] > _FLAT * size else 2
    ranges = [_range(low[axis], high[axis], step) for axis in range(count)]
    parts = axes.picture(ranges, [step] * count, _TICK * step, True)
    ticks = [part for part in parts if part.name.startswith(TICK)]
    labels = [Label("", "", part.name.partition(" ")[2], tuple(part.curve.points[0].tolist())) for part in ticks]
    return Scale(_lines(part for part in parts if part.name != axes.GRID), _lines(part for part in parts if part.name == axes.GRID), labels)


def _range(low, high, step):
    """Whole steps around both, one at least."""
    first, last = math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step
    return first, max(last, first + step)


def _round(step):
    """1, 2 or 5 times a power of ten, no smaller than a step."""
    power = 10.0 ** math.floor(math.log10(step))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= step * (1.0 - 1e-9))


def _lines(parts):
    return np.array([part.curve.points for part in parts]).reshape(-1, 2, 3)
