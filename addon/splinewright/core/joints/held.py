"""Continuity that holds: joints of curves and seams of patches that are made smooth again whenever a side of theirs has moved."""

import itertools
import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..verbs.patch_curves import SIDES
from . import held_joints, held_seams, patch_joints

#: How often all are gone through where they share pieces.
_ROUNDS = 12
#: What moves less, as a part of the largest number, was there already.
_ROUNDING = 16 * np.finfo(np.float64).eps
#: What still moves more after all rounds, as a part of the shape's size or of its weights, contradicts itself.
_AGREED = 1e-9


class Held(NamedTuple):
    """A joint or seam that holds: (piece counted from 0, where on it) of both, what they share there, and which gives way.

    Where: of a patch a side, of a curve 'start', 'end', or of both a knot inside it.
    """

    first: tuple
    second: tuple
    smoothness: str
    moves: str


class Contradiction(Refusal):
    """The joints that are to hold do not hold together."""

    def __init__(self):
        super().__init__("the locked continuities contradict each other: unlock a joint or seam")


def require_valid(held, definition):
    """Raises Refusal unless this may be a joint or seam of a definition."""
    for piece, place in (held.first, held.second):
        if type(piece) is not int or not 0 <= piece < len(definition.pieces) or not _is_place(place, definition.has_curves):
            raise Refusal("what holds is none of the shape's")
    is_at_knot = definition.has_curves and not {held.first[1], held.second[1]} <= set(held_joints.ENDS)
    if (held.first == held.second) != is_at_knot:
        raise Refusal("a knot holds beside itself, and a side beside another")
    smoothness = held_joints.SMOOTHNESS if definition.has_curves else patch_joints.SMOOTHNESS
    if held.smoothness not in smoothness or held.moves not in patch_joints.MOVES:
        raise Refusal("what holds says nothing that is known")


def _is_place(place, is_of_curve):
    if not is_of_curve:
        return place in SIDES
    return place in held_joints.ENDS or type(place) is float and math.isfinite(place)


def are_one(definition, held):
    """Whether the two sides of a Held, or of a core.joints.seams.Seam, are one: edges with the same rows of the pool, or ends in one
    place."""
    return _room(definition).meet(definition, held)


def is_there(definition, held):
    """Whether a joint of curves has both its sides, in whatever place."""
    try:
        held_joints.require_possible(definition, held)
    except Refusal:
        return False
    return True


def can_hold(definition, first, second):
    """Whether there is anything that can hold between two sides."""
    held = Held(first, second, 'C0', 'second')
    return is_there(definition, held) if definition.has_curves else are_one(definition, held)


def why_not(definition, first, second):
    """Why nothing can hold between two sides of patches, as a sentence, or ""."""
    if definition.has_curves or can_hold(definition, first, second):
        return ""
    if first[0] == second[0]:
        return "A patch does not hold to itself: Make Periodic closes it"
    return "Two edges that only lie on each other do not hold: Join Patches makes them one"


def _room(definition):
    return held_joints if definition.has_curves else held_seams


def shifted(seams, count):
    """Seams of pieces after pieces were inserted before them."""
    return tuple(seam._replace(first=(seam.first[0] + count, seam.first[1]), second=(seam.second[0] + count, seam.second[1]))
                 for seam in seams)


def carried(seams, parents, before, definition):
    """Those of the seams of the definition `before` that are seams of another still, whose pieces came of the pieces with these
    numbers; where both sides were cut, all of its parts. A knot is the same that lies in the same place, with the same side
    before it."""
    found = []
    for held in seams:
        now = [[i for i, parent in enumerate(parents) if parent == piece] for piece, _ in (held.first, held.second)]
        moved = [one for a, b in itertools.product(*now) for one in _at_pieces(held, a, b, before, definition)]
        moved = [one for one in moved if are_one(definition, one)]
        found += moved if len(moved) == 1 or not definition.has_curves else []
    return tuple(found)


def _at_pieces(held, a, b, before, definition):
    """A Held between other pieces; of a knot that which is the same on piece `a`."""
    if held.first != held.second:
        return [held._replace(first=(a, held.first[1]), second=(b, held.second[1]))]
    if a != b:
        return []
    places = held_joints.same_knots(before, held.first, definition, a)
    return [held._replace(first=(a, place), second=(a, place)) for place in places]


def at_knots_of(seams, before, definition):
    """The seams of curves at the knots that have the same places in their lists in another definition."""
    found = []
    for held in seams:
        piece, place = held.first
        if place not in held_joints.ENDS:
            was, now = before.pieces[piece].knots[0], definition.pieces[piece].knots[0]
            place = (piece, float(now[np.searchsorted(was, place)]))
            held = held._replace(first=place, second=place)
        found.append(held)
    return tuple(found)


def mirrored(seams):
    """Seams of patches whose u and v were exchanged."""
    other = {'u': 'v', 'v': 'u'}
    return tuple(seam._replace(first=(seam.first[0], other[seam.first[1][0]] + seam.first[1][1:]),
                               second=(seam.second[0], other[seam.second[1][0]] + seam.second[1][1:])) for seam in seams)


def applied(definition, seams, led=frozenset()):
    """The definition with these Held made to hold; itself where they do. led: rows of the pool that a hand moves.

    Raises Refusal where one takes other knots, or they contradict one another.
    """
    room = _room(definition)
    pool = definition.pool.copy()
    finite = pool[pool[:, 3] != 0]
    reach, weight = np.abs(finite[:, :3]).max(initial=0.0), np.abs(finite[:, 3]).max(initial=0.0)
    rounding = _ROUNDING * np.array([reach, reach, reach, weight])
    agreed = np.maximum(_AGREED * np.array([definition.size] * 3 + [weight]), 4 * rounding)
    for _ in range(_ROUNDS):
        moved = [_moved(pool, room.made_to_hold(definition, pool, held, led), rounding) for held in seams]
        if (np.array(moved).reshape(-1, 4) <= agreed).all():
            break
    else:
        raise Contradiction
    return definition if np.array_equal(pool, definition.pool) else replace(definition, pool=pool)


def _moved(pool, made, rounding):
    """Move the rows of a pool that are off by more than rounding (4,) to what was made of them; (4,) how far."""
    rows, values = made
    change = np.abs(values - pool[rows])
    is_moved = (change > rounding).any(-1)
    pool[rows[is_moved]] = values[is_moved]
    return change.max(0)
