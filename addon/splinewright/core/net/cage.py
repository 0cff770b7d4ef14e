"""A cage of patches as it is now: its vertices, its connections, and ways that go straight on over quads."""

from dataclasses import dataclass
from functools import cached_property
from typing import Callable

import numpy as np

from .grown import NEW


@dataclass(frozen=True, eq=False)
class Cage:
    """m vertices by their slots: of each its number in the net, NEW, copy_of() one or STRAY, and where it is."""

    numbers: np.ndarray                 # (m,)
    places: np.ndarray                  # (m, 3) float32
    weights: np.ndarray                 # (m,) float32
    links: Callable                     # gives pairs (k, 2) of slots that are connected
    corners: Callable                   # gives of each face its slots

    @cached_property
    def beside(self):
        """Of each slot those that it is connected with."""
        found = [set() for _ in self.numbers]
        for one, other in np.asarray(self.links()).reshape(-1, 2).tolist():
            found[one].add(other)
            found[other].add(one)
        return found

    @cached_property
    def faces(self):
        """Of each face the set of its slots."""
        return [frozenset(corners) for corners in self.corners()]

    @cached_property
    def _faces_of(self):
        found = [set() for _ in self.numbers]
        for i, corners in enumerate(self.faces):
            for slot in corners:
                found[slot].add(i)
        return found

    def slots(self, count):
        """(count,) of each number its slot, or -1."""
        found = np.full(count, -1)
        own = np.flatnonzero(self.numbers >= 0)
        found[self.numbers[own]] = own
        return found

    def chain(self, start, end, taken):
        """The new vertices on the straight way between two slots, [] where they are connected, None where there is no such
        way or more than one. taken: slots that ways end at."""
        if end in self.beside[start]:
            return []
        ways = [self._way(start, first, end, taken) for first in self.beside[start] if self._is_free(first, taken)]
        ways = [way for way in ways if way is not None]
        return ways[0] if len(ways) == 1 else None

    def _is_free(self, slot, taken):
        return self.numbers[slot] == NEW and slot not in taken

    def _way(self, start, first, end, taken):
        """The slots from the first straight on to the end; None where it does not come."""
        way, before = [first], start
        while end not in self.beside[way[-1]]:
            here = way[-1]
            beside = self._faces_of[before] & self._faces_of[here]
            onward = [slot for slot in self.beside[here] if slot != before
                      and not self._faces_of[here] & self._faces_of[slot] & beside]
            if len(onward) != 1 or onward[0] in way or not self._is_free(onward[0], taken):
                return None
            way.append(onward[0])
            before = here
        return way
