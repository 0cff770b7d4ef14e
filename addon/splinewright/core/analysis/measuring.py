"""Distances of many points, some of them at a time, so that who waits for them sees how far it is."""

import time
from typing import Callable, NamedTuple

import numpy as np

#: Points that are measured first; from then on twice as many while they take less than this part of the time there is.
_FIRST, _SHARE = 64, 0.25


class Plan(NamedTuple):
    """The measures of a shape."""

    points: np.ndarray                  # (n, 3)
    spread: Callable                    # gives, of their distances (n,), those of all places


class Measuring:
    """The distances of a Plan's points, as far as they are known. distances: a function of points (n, 3)."""

    def __init__(self, plan, distances):
        self._plan, self._distances = plan, distances
        self._values, self._done, self._count = np.empty(len(plan.points)), 0, _FIRST

    @property
    def share(self):
        """How much of it is done, 0 to 1."""
        return self._done / len(self._values) if len(self._values) else 1.0

    def go_on(self, seconds=np.inf):
        """Whether all are known, after no more than about these seconds more."""
        end = time.monotonic() + seconds
        while self._done < len(self._values):
            start = time.monotonic()
            if start >= end:
                return False
            part = slice(self._done, self._done + self._count)
            self._values[part] = self._distances(self._plan.points[part])
            self._done = min(part.stop, len(self._values))
            if time.monotonic() - start < _SHARE * seconds:
                self._count *= 2
        return True

    def values(self):
        """The distances of all places, when all are known."""
        return self._plan.spread(self._values)


def all_at_once(plan, distances):
    """The distances of all places."""
    measuring = Measuring(plan, distances)
    measuring.go_on()
    return measuring.values()
