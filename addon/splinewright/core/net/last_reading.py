"""What a net of patches said last: where nothing but positions is other since, those are read that are.

It gives the bits that core.net.reading and core.net.exact_net give.
"""

from typing import NamedTuple

import numpy as np

from ..base.arrays import are_equal
from ..shape.definition import Definition
from . import snapped
from .exact_net import Exact, in_rows


class Snapshot(NamedTuple):
    """What Blender holds of a net: m vertices."""

    numbers: list                       # as they are written on the vertices
    weights: list
    positions: np.ndarray               # (m, 3) float32
    occasion: tuple = ()                # what is the same while points are moved and nothing else is done
    slots: np.ndarray = None            # those that moved() since the one before, where it was compared with that

    def moved(self, positions):
        """(k,) the slots whose positions are others in these, as many."""
        differ = positions.view(np.uint32) != self.positions.view(np.uint32)
        return (differ[:, 0] | differ[:, 1] | differ[:, 2]).nonzero()[0]


def of(net, said, typed, found, definition):
    """The LastReading of a net that was read, or None where it is not to be had: points are missing, or handles there."""
    is_whole = said is not None and not found.problem and not found.extra and len(said.positions) == len(found.slots)
    if not is_whole or not net.are_points.all() or len(np.unique(net.rows)) < len(net.rows):
        return None
    return LastReading(net, said, typed, found, definition)


class LastReading:
    """A core.net.reading.Reading, and the definition that it says."""

    def __init__(self, net, said, typed, found, definition):
        self._net, self.said, self._typed = net, said, typed
        self._found, self._definition = found, definition
        self._is_in_order = np.array_equal(found.slots, np.arange(len(found.slots)))
        self._are_weights_kept = bool(found.state.kept_weights.all())
        self.rows = None                # of the pool, (k,): what again() moved last

    def again(self, net, said, typed):
        """(the Reading, the definition) of what the net says now, which is the last one then; None where more than
        positions is other, or a typed number is concerned."""
        is_same = net is self._net and (typed is self._typed or are_equal(typed, self._typed))
        if said is None or not is_same or not self.agrees(said):
            return None
        slots = self.said.moved(said.positions) if said.slots is None else said.slots
        if not len(slots):
            return self._found, self._definition
        vertices = slots if self._is_in_order else np.flatnonzero(np.isin(self._found.slots, slots))
        positions = said.positions[slots if self._is_in_order else self._found.slots[vertices]]
        if not np.isfinite(positions).all() or len(typed) and np.isin(typed[:, 0], vertices).any():
            return None
        found, definition = self._with(vertices, positions)
        if self._has_snapped(said, found):
            return None
        self.said, self._found, self._definition = said, found, definition
        return found, definition

    def _has_snapped(self, said, found):
        """Whether a point was put onto another one: core.net.exact_net gives it the digits of that."""
        net, moved = self._net, np.flatnonzero(~found.state.kept)
        places = said.positions if self._is_in_order else said.positions[found.slots]
        return bool(len(moved)) and bool(snapped.targets(net.single, places.astype(np.float64), moved, net.order))

    def agrees(self, said):
        """Whether a Said is the last one but for positions."""
        return ((said.numbers is self.said.numbers or said.numbers == self.said.numbers)
                and (said.weights is self.said.weights or said.weights == self.said.weights))

    def _with(self, vertices, positions):
        """(the Reading, the definition) with vertices at other positions, float32."""
        net, state = self._net, self._found.state
        are_kept = in_rows(positions == net.single[vertices])
        exact = np.where(are_kept[:, None], net.positions[vertices], positions)
        now, kept = state.positions.copy(), state.kept.copy()
        now[vertices], kept[vertices] = exact, are_kept
        self.rows = net.rows[vertices]
        found = self._found._replace(state=Exact(now, state.weights, kept, state.kept_weights))
        if self._are_weights_kept and kept.all():
            return found, net.source
        before = net.definition if self._definition is net.source else self._definition
        pool = before.pool.copy()
        pool[self.rows, :3] = exact
        return found, Definition(before.form, pool, before.pieces)
