"""What holds is kept by motions that are no more than a few times that of the hand; what cannot be kept so is less smooth."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from ..verbs import patch_curves
from . import held as all_held
from . import held_strips

#: How far a point that goes along may go, by how far the hand moved one, or where it moved none, by what lies beside a seam.
REACH = 10.0
#: What weights may grow or shrink by, where the hand changed none.
_HEAVIER = 2.0
#: What goes less, by how far the hand moved one, is not counted: the digits of a net are of single precision.
_LITTLE = 1e-5
_LESS = {'C2': 'C1', 'C1': 'C0', 'G2': 'G1', 'G1': 'C0'}


class Kept(NamedTuple):
    """A definition in which Helds hold, and which of them are less smooth than they are to be: pairs (Held, its smoothness)."""

    definition: object
    lost: tuple = ()


def kept(definition, seams, led=frozenset(), before=None):
    """The Kept of a definition. led: rows of the pool that a hand moves. before: the pool in which the seams held last.

    Of what keeps all as smooth as it is to be, within REACH, that is taken by which the fewest points go along: those of the side
    that gives way, or of both sides, but for what the hand moves, by the least sum of squares. Where nothing does, the touched part
    is kept less smooth, at worst C0. Raises Refusal, or an error of the library, where one takes other knots or has no edge.
    """
    known = before if before is not None and before.shape == definition.pool.shape else None
    work = _Work(definition, led, known)
    lowered = list(seams)
    while True:
        found = work.kept(lowered)
        if found is not None:
            return Kept(found, tuple((held, now.smoothness) for held, now in zip(seams, lowered) if held != now))
        touched = work.touched(lowered)
        less = [one._replace(smoothness=_LESS.get(one.smoothness, one.smoothness)) if i in touched else one
                for i, one in enumerate(lowered)]
        if less == lowered:
            raise work.error
        lowered = less


def sentence(lost):
    """What was not kept, in words; "" where all was."""
    if not lost:
        return ""
    (held, now), more = lost[0], len(lost) - 1
    others = phrase(", and {more} more less smooth", more=more) if more else ""
    return (phrase("{held} holds {now} only, not {smoothness}{others}: no points that go up to {reach:g} times as far as those "
                   "that were moved keep it",
                   held=_name(held), now=now, smoothness=held.smoothness, others=others, reach=REACH))


def _name(held):
    (piece, place), (other, other_place) = held.first, held.second
    if held.first == held.second:
        return phrase("the knot {place:.4g} of curve {piece}", place=place, piece=piece + 1)
    return phrase("{first} · {second}", first=patch_curves.named_side(place, piece + 1), second=patch_curves.named_side(other_place, other + 1))


class _Work:
    def __init__(self, definition, led, before):
        self._definition, self._led, self._before = definition, led, before
        self.error = None               # the first one of the library
        pool = definition.pool
        self._moved = np.zeros((len(pool), 3)) if before is None else pool[:, :3] - before[:, :3]
        self._is_weighed = before is None or (before[:, 3] != pool[:, 3]).any()
        self._is_led = np.isin(np.arange(len(pool)), list(led))
        self._hand = float(np.linalg.norm(self._moved[self._is_led], axis=1).max(initial=0.0))

    def kept(self, seams):
        """The definition in which these hold, within reach; None where none does."""
        try:
            whole = all_held.applied(self._definition, seams, self._led)
        except (all_held.Contradiction, sc.Error) as error:
            whole, self.error = None, self.error or error
        if whole is self._definition:
            return whole
        reach = self._reach(seams)
        ways = [self._by_giving_way(seams), whole, self._least(seams, ~self._is_led)]
        ways = [way for way in ways if way is not None and self._ways(way).max(initial=0.0) <= reach and self._keeps_weights(way)]
        return min(ways, key=self._count, default=None)

    def touched(self, seams):
        """The numbers of those that what was moved lies beside, or beside those that share rows with them; all where nothing
        was moved."""
        rows = [self._rows(held) for held in seams]
        is_reached = self._is_led.copy()
        found = set() if is_reached.any() else set(range(len(seams)))
        while True:
            more = {i for i, own in enumerate(rows) if is_reached[own].any()} - found
            if not more:
                return found or set(range(len(seams)))
            found |= more
            for i in more:
                is_reached[rows[i]] = True

    def _rows(self, held):
        return np.concatenate([strip.rows.ravel() for strip in held_strips.strips_of(self._definition, held)])

    def _by_giving_way(self, seams):
        """Only those move that are to, at the columns that were touched; None where that is not enough."""
        gives = np.zeros(len(self._moved), bool)
        for held in seams:
            for name, strip in zip(('first', 'second'), held_strips.strips_of(self._definition, held)):
                if held.moves in (name, 'both'):
                    gives[strip.rows[1:]] = True
        return self._least(seams, gives & ~self._is_led)

    def _least(self, seams, is_free):
        if self._is_weighed:
            return None
        moved, tied = self._ends_together(seams)
        equations = []
        for held in seams:
            one = held_strips.equations_of(self._definition, held, self._before)
            if one is None:
                return None
            equations.append(one._replace(rows=tied[one.rows]))
        is_fixed = np.zeros(len(tied), bool)
        np.logical_or.at(is_fixed, tied, ~is_free)
        motion = sc.build.least_motion(equations, moved, ~is_fixed)
        if motion is None:
            return None
        pool = self._definition.pool.copy()
        change = (moved + motion)[tied] - self._moved
        rows = (change != 0).any(1)
        pool[rows, :3] += change[rows]
        return replace(self._definition, pool=pool)

    def _ends_together(self, seams):
        """(n, 3) how far rows are moved where ends in one place go with that which the hand moved, and (n,) for each row the one
        that stands for it."""
        moved, tied = self._moved.copy(), np.arange(len(self._moved))
        if not self._definition.has_curves:
            return moved, tied
        for held in seams:
            a, b = (int(strip.rows[0, 0]) for strip in held_strips.strips_of(self._definition, held))
            leads = a if self._is_led[a] or not self._is_led[b] else b
            moved[[a, b]] = moved[leads]
            tied[tied == tied[b if leads == a else a]] = tied[leads]
        return moved, tied

    def _reach(self, seams):
        if self._hand > 0:
            return REACH * self._hand
        pool = self._definition.pool if self._before is None else self._before
        legs = [0.0]
        for held in seams:
            strips = held_strips.strips_of(self._definition, held)
            for strip in strips:
                away = np.linalg.norm(pool[strip.rows, :3] - pool[strips[0].rows[0], :3], axis=-1)
                legs.append(away[pool[strip.rows, 3] != 0].max(initial=0.0))
        return REACH * max(legs)

    def _ways(self, definition):
        """(n,) how far the rows of it have gone along."""
        return np.linalg.norm(definition.pool[:, :3] - self._definition.pool[:, :3], axis=1)

    def _keeps_weights(self, definition):
        """Whether weights that no hand changed are about what they were."""
        was, now = np.abs(self._definition.pool[:, 3]), np.abs(definition.pool[:, 3])
        return self._is_weighed or bool(((now <= _HEAVIER * was) & (was <= _HEAVIER * now)).all())

    def _count(self, definition):
        return int((self._ways(definition) > _LITTLE * self._hand).sum())
