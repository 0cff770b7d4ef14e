"""Joints and seams that hold while a net is out: points that no hand moved follow, and the net shows them where they are.

What they were placed from is kept until the gesture that moved them has ended: so it may move them again and again, and where
it is called off they are where they were.
"""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...core.base.words import phrase
from ...core.joints import held as seams_that_hold
from ...core.joints import held_bounds
from ..data import held, store
from ..data.file_state import ended_operators
from . import selection


@dataclass(eq=False)
class Placed:
    """Rows of the pool that were placed in a gesture: as the net has them in float32, and from where; those that a hand moved."""

    shown: dict = field(default_factory=dict)
    origins: dict = field(default_factory=dict)
    led: set = field(default_factory=set)
    before: Any = None                  # the pool of the shape when the gesture began
    ended: tuple = ()                   # the ended_operators() at that time


def followed(data, ob, current, definition):
    """A definition, as the net says it, in which the joints or seams of its shape hold. Raises Refusal or an error of the
    library."""
    current.lost = ""
    seams = _kept(data, current, definition) if definition.has_curves else held.read(data, definition)
    if not seams:
        return definition
    placed = current.placed
    if placed.ended != ended_operators():
        placed = current.placed = Placed(before=store.pool(data), ended=ended_operators())
    start = replace(definition, pool=_as_before(definition.pool, placed))
    placed.led |= _led(store.pool(data), start.pool, definition.pool)
    kept = held_bounds.kept(start, seams, placed.led, placed.before)
    after, current.lost = kept.definition, held_bounds.sentence(kept.lost)
    _show(ob, current, definition.pool, after.pool)
    for row in np.flatnonzero((after.pool != start.pool).any(1)).tolist():
        placed.shown[row], placed.origins[row] = after.pool[row].astype(np.float32), start.pool[row]
    return after


def _kept(data, current, definition):
    """The joints of a shape that are there still in what its net became; the others are released, which current.released
    says."""
    seams = held.read(data)
    if not seams:
        return ()
    kept, shown = (), store.read(data)
    if len(definition.pieces) == len(shown.pieces):
        stays = seams_that_hold.is_there if len(definition.pool) == len(shown.pool) else seams_that_hold.are_one
        kept = tuple(joint for joint in seams if stays(definition, joint))
    if len(kept) < len(seams):
        held.write(data, kept)
        current.released = phrase("{count} of the joints that held are released: what they joined is not there any more",
                                  one="{count} of the joints that held is released: what it joined is not there any more",
                                  count=len(seams) - len(kept))
    return kept


def _led(shown, start, pool):
    """The rows that lie elsewhere in the net than the shape has them, and were not placed."""
    if shown.shape != pool.shape:
        return set()
    moved = (shown.astype(np.float32) != pool.astype(np.float32)).any(1)
    return set(np.flatnonzero(moved & (start == pool).all(1)).tolist())


def _as_before(pool, placed):
    """The pool with rows where they were that lie as they were placed."""
    before = pool.copy()
    for row, shown in placed.shown.items():
        if (pool[row].astype(np.float32) == shown).all():
            before[row] = placed.origins[row]
    return before


def _show(ob, current, before, after):
    rows = np.flatnonzero((before.astype(np.float32) != after.astype(np.float32)).any(1))
    net = current.net
    vertices = np.flatnonzero(np.isin(net.rows, rows) & net.are_points & (current.slots >= 0))
    if len(vertices):
        selection.place(ob, net, vertices, after[net.rows[vertices]])
