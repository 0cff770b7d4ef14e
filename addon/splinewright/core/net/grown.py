"""What became of curves whose net gained and lost points: the definition that follows, and which point is which then.

Points beyond an open end are appended, points between two neighbors subdivide, points that are gone are removed; splines
are closed and opened, parted and connected.
Copies that lie where they were made are passed over.
"""

from dataclasses import dataclass, replace
from functools import reduce
from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.words import phrase
from ..shape import definition as definitions
from ..verbs import verbs
from . import curve_net, point_edits
from .point_edits import Point

#: In place of a number: a new point. A copy of a point with a number has a smaller one.
NEW = -1


#: A point that was passed over once for all.
STRAY = -2 - 2 ** 30


def copy_of(number):
    """What stands for a copy of a point, and the other way round."""
    return -2 - number


@dataclass(frozen=True, eq=False)
class Run:
    """A spline as it is now: of each point its number in the net, NEW, copy_of() one or STRAY, and where it is."""

    numbers: np.ndarray                 # (k,)
    positions: np.ndarray               # (k, 3), or (k, 3, 3) with handles: before, the point, after
    weights: np.ndarray                 # (k,)
    closed: bool
    turned: np.ndarray                  # (k,) bool: whether the direction was switched since the net was made

    @property
    def places(self):
        return self.positions if self.positions.ndim == 2 else self.positions[:, 1]

    @property
    def is_turned(self):
        own = self.numbers >= 0
        return bool(own.any() and self.turned[own].all())

    def point(self, i, is_turned):
        if self.positions.ndim == 2:
            return Point(self.positions[i].astype(np.float64), float(self.weights[i]))
        before, position, after = self.positions[i].astype(np.float64)
        return Point(position, 1.0, *((after, before) if is_turned else (before, after)))


@dataclass(frozen=True, eq=False)
class Grown:
    """A definition, its net, and for each run the numbers of its points there."""

    net: object
    numbers: tuple
    origins: np.ndarray                 # (n,) of each point the number of the one it was, or was copied from, or NEW
    added: np.ndarray                   # numbers of points that were appended, where nothing else was done
    note: str
    faces: tuple = ()                   # of a cage: slots of each face that is to be made
    parted: frozenset = frozenset()     # of a cage: of each face that is to go for those the set of its slots


def grow(net, definition, runs):
    """The Grown net of a definition, which is what the net said of its points that are there; None where it has neither
    gained nor lost any, or is not told what became of it. Raises Refusal, with the reason, where there is no such shape."""
    by_piece = _plans(net, runs)
    if by_piece is None or all(len(plans) == 1 and plans[0].is_idle for plans in by_piece):
        return None
    before = verbs.curves_of(definition)
    edits = [plan.carried_out(before) for plans in by_piece for plan in plans]
    curves = [edited.curve for edited in edits]
    made = curve_net.make(definitions.from_value(curves[0] if definition.form == 'curve' and len(curves) == 1 else curves))
    plans = [plan for of_piece in by_piece for plan in of_piece]
    gone = sum(len(plan.gone) for plan in plans if len(by_piece[plan.piece]) == 1)
    return _told(made, runs, plans, edits, _arrows(net, by_piece), _note(gone, max(edited.error for edited in edits)))


def _note(gone, error):
    if not gone or not error:
        return ""
    return phrase("without those {count} points the shape lies within {error} of what it was",
                  one="without that point the shape lies within {error} of what it was", count=gone, error=decimals.text_of(error))


def settled(runs):
    """The numbers of each run where copies that lie beyond an end where that is are passed over once for all; None where
    there are none."""
    numbers = [run.numbers.copy() for run in runs]
    for run, own in zip(runs, numbers):
        known = np.flatnonzero(own >= 0)
        if len(known) and not run.closed:
            for end, slots in ((known[0], range(known[0])), (known[-1], range(known[-1] + 1, len(own)))):
                for slot in slots:
                    if own[slot] == copy_of(own[end]) and (run.places[slot] == run.places[end]).all():
                        own[slot] = STRAY
    return numbers if any((own != run.numbers).any() for own, run in zip(numbers, runs)) else None


def _told(made, runs, plans, after, stays, note):
    """stays: numbers of the points of arrows that are there as they were."""
    numbers = [np.full(len(run.numbers), NEW) for run in runs]
    origins = np.full(len(made.spline_points[0]), NEW)
    added, now_of, first = [], {}, 0
    for plan, edited, spline in zip(plans, after, made.splines):
        if spline.count != len(plan.slots):
            raise Refusal("the shape takes no such points: undo that")
        own = first + np.argsort(np.argsort(edited.order))
        numbers[plan.run][plan.slots] = own
        was = runs[plan.run].numbers[plan.slots]
        origins[own] = np.where(was < NEW, copy_of(was), was)
        now_of.update(zip(was[was >= 0].tolist(), own[was >= 0].tolist()))
        added += own[[i for i, slot in enumerate(plan.slots) if slot in plan.appended]].tolist()
        first += spline.count
    for number in stays:
        now_of[number], origins[first] = first, number
        first += 1
    for found, run in zip(numbers, runs):
        for i in np.flatnonzero((found == NEW) & (run.numbers != NEW)):
            number = int(run.numbers[i])
            if number == STRAY:
                found[i] = STRAY
                continue
            now = now_of.get(number if number >= 0 else copy_of(number), NEW)
            found[i] = copy_of(now) if number < NEW != now else now
    if not all(plan.only_appends for plan in plans):
        added = []
    return Grown(made, tuple(numbers), origins, np.array(sorted(added), dtype=np.int64), note)


def _arrows(net, by_piece):
    """The points of the arrows of pieces that are there still."""
    number, found = sum(spline.count for spline in net.splines[:len(by_piece)]), []
    for plans, piece in zip(by_piece, net.source.pieces):
        count = 2 * _count_infinite(net, piece)
        found += range(number, number + count) if plans else ()
        number += count
    return found


def _count_infinite(net, piece):
    return 0 if piece.kind == 'hermite' else int((net.source.pool[piece.indices, 3] == 0).sum())


# What happened to each piece -----------------------------------------------------------------------


def _plans(net, runs):
    """Of each piece its _Plans: one where it is there, none where it is gone or connected with one before it, several where
    it was split. None where it is not told what happened."""
    bounds = np.cumsum([0] + [spline.count for spline in net.splines])
    pieces = net.source.pieces
    if not all((net.source.pool[piece.indices.ravel(), 3] != 0).any() for piece in pieces):
        return None                     # one of them lies at infinity
    parts = [part for r, run in enumerate(_claimed(runs)) for part in _parts(run, r, bounds)]
    plans = []
    for i, piece in enumerate(pieces):
        of_piece = [part for part in parts if part.piece == i]
        if len(of_piece) > 1 and _count_infinite(net, piece):
            raise Refusal("a curve with points at infinity is not parted here: use Split for that")
        found = [_plan(net, bounds[i], part) for part in of_piece]
        plans.append(sorted(found, key=lambda plan: plan.begins))
    if not any(plans):
        return None
    if not all(plans) and any((run.numbers == NEW).all() for run in runs):
        return None                     # it may be of another type now
    return _connected(plans, runs)


def _claimed(runs):
    """The runs where copies count as points that are connected as those were which are so no more: Split leaves a copy of
    the point at which it parts."""
    numbers = [np.where(run.numbers < NEW, copy_of(run.numbers), run.numbers) for run in runs]
    links = [_links(run, own) for run, own in zip(runs, numbers)]
    there = {link for run, of_run in zip(runs, links) for link, (a, b) in of_run.items()
             if run.numbers[a] >= 0 and run.numbers[b] >= 0}
    result = []
    for run, own, of_run in zip(runs, numbers, links):
        claimed = [slot for link, slots in of_run.items() if link not in there for slot in slots]
        taken = run.numbers.copy()
        taken[claimed] = own[claimed]
        result.append(replace(run, numbers=taken))
    return result


def _links(run, own):
    """{number of the first of two neighbors in the net: their slots}, where they are connected in a run."""
    after = np.arange(1, len(own) + run.closed) % max(len(own), 1)
    pairs = [(a, b) for a, b in enumerate(after.tolist()) if own[a] >= 0 <= own[b] and abs(own[a] - own[b]) == 1]
    return {int(min(own[a], own[b])): (a, b) for a, b in pairs}


class _Part(NamedTuple):
    """Points of a run that are of one piece, and those that are new between and beyond them."""

    piece: int
    run: Run
    number: int                         # of the run
    slots: list                         # in the direction of the piece
    @property
    def is_turned(self):
        return len(self.slots) > 1 and self.slots[0] > self.slots[-1]


def _parts(run, r, bounds):
    own = np.flatnonzero(run.numbers >= 0)
    pieces = np.searchsorted(bounds, run.numbers[own], 'right') - 1
    starts = np.flatnonzero(np.diff(pieces, prepend=-1))
    if len(starts) > 1 and run.closed:
        raise Refusal("different curves are connected at both ends at once: connect one, and then the other")
    ends = [*own[starts[1:]], len(run.numbers)]
    for start, first, last in zip(starts.tolist(), [0, *ends], ends):
        slots, i = list(range(first, last)), own[start:][pieces[start:] == pieces[start]]
        yield _Part(int(pieces[start]), run, r, slots[::-1] if run.turned[i].any() else slots)


def _connected(plans, runs):
    """Plans of pieces where those that are connected by a run are one."""
    for r in range(len(runs)):
        found = [plan for of_piece in plans for plan in of_piece if plan.run == r]
        if len(found) < 2:
            continue
        if any(len(plans[plan.piece]) > 1 for plan in found):
            raise Refusal("a curve was parted and connected with another at once: do one after the other")
        is_turned = runs[r].is_turned
        found.sort(key=lambda plan: plan.slots.min(), reverse=is_turned)
        for plan in found:
            plans[plan.piece] = []
        plans[min(plan.piece for plan in found)] = [_Connected(tuple(found), is_turned)]
    return plans


@dataclass(frozen=True, eq=False)
class _Connected:
    """The edit to make with pieces that were connected to one. The same questions as of a _Plan."""

    plans: tuple
    is_turned: bool
    is_idle = only_appends = False
    gone = appended = frozenset()

    @property
    def piece(self):
        return min(plan.piece for plan in self.plans)

    @property
    def run(self):
        return self.plans[0].run

    @property
    def slots(self):
        return np.concatenate([plan.slots[::-1] if self._goes_back(plan) else plan.slots for plan in self.plans])

    def _goes_back(self, plan):
        return (plan.slots[0] > plan.slots[-1]) != self.is_turned

    def carried_out(self, curves):
        parts = [plan.carried_out(curves) for plan in self.plans]
        parts = [point_edits.as_chain(part) if plan.is_cubic else part for plan, part in zip(self.plans, parts)]
        parts = [point_edits.turned(part) if self._goes_back(plan) else part for plan, part in zip(self.plans, parts)]
        return reduce(point_edits.joined, parts)


@dataclass(frozen=True, eq=False)
class _Plan:
    """The edit to make with a piece, or a part of it."""

    piece: int
    run: int
    begins: int                         # the first of its points that is there
    slots: np.ndarray                   # of each point that the net is to have its place in the run
    gone: list                          # places of points that are gone, in the order of the net
    gaps: list                          # (place among the points that stay, how many are new after it)
    before: list                        # Points beyond the start, from the curve outwards
    after: list
    appended: frozenset                 # their places in the run
    was_closed: bool
    closed: bool
    order: np.ndarray                   # of the points of the net the control points
    is_cubic: bool                      # two points with handles

    @property
    def is_idle(self):
        return self.only_appends and not (self.before or self.after)

    @property
    def only_appends(self):
        return not (self.gone or self.gaps) and self.closed == self.was_closed

    def carried_out(self, curves):
        curve = curves[self.piece]
        if self.is_idle:
            return point_edits.started(curve, self.order, self.closed)
        if self.is_cubic:
            edited = point_edits.as_chain(point_edits.started(curve, self.order, False))
        else:
            edited = point_edits.started(curve, self.order, self.was_closed)
        if self.was_closed and not self.closed:
            edited = point_edits.opened(point_edits.begun_at(edited, self.begins))
        edited = _without(edited, self.gone)
        if self.closed and not self.was_closed:
            edited = point_edits.closed(edited)
        for place, times in reversed(self.gaps):
            edited = point_edits.inserted(edited, place, times)
        for points, at_start in ((self.before, True), (self.after, False)):
            for point in points:
                edited = point_edits.appended(edited, point, at_start)
        return edited


def _without(edited, gone):
    """Without points by their places: from the ends first."""
    places = list(gone)
    while places and not edited.closed and places[-1] == len(edited.order) - 1:
        edited = point_edits.removed(edited, places.pop())
    while places and not edited.closed and places[0] == 0:
        edited = point_edits.removed(edited, 0)
        places = [place - 1 for place in places[1:]]
    for place in reversed(places):
        edited = point_edits.removed(edited, place)
    return edited


def _plan(net, first, part):
    run, piece, spline = part.run, net.source.pieces[part.piece], net.splines[part.piece]
    slots = np.array(part.slots)
    known = [slot for slot in part.slots if run.numbers[slot] >= 0]
    if spline.closed and run.closed:    # it may begin anywhere
        at = int(run.numbers[known].argmin())
        known = known[at:] + known[:at]
    begins, places = int(run.numbers[known[0]] - first), run.numbers[known] - first
    if spline.closed and not run.closed:
        places = (places - begins) % spline.count
    if (np.diff(places) <= 0).any():
        raise Refusal("its points are connected in another order than before: the shape has them as they were")
    gaps, taken = [], list(known)
    for k, (one, other) in enumerate(zip(known, [*known[1:], None])):
        if other is None and not run.closed:
            break
        between = _between(slots, one, known[0] if other is None else other)
        new = [slot for slot in between if run.numbers[slot] == NEW]
        if new:
            gaps.append((k, len(new)))
            taken += new
    before = after = []
    if not run.closed:
        start, end = slots.tolist().index(known[0]), slots.tolist().index(known[-1])
        before = _beyond(run, slots[:start][::-1], known[0])
        after = _beyond(run, slots[end + 1:], known[-1])
    kept = [slot for slot in slots.tolist() if slot in {*taken, *before, *after}]
    if run.closed:
        at = kept.index(known[0])
        kept = kept[at:] + kept[:at]
    gone = sorted(set(range(spline.count)) - set(places.tolist()))
    more = [[run.point(slot, part.is_turned) for slot in beyond] for beyond in (before, after)]
    return _Plan(part.piece, part.number, begins, np.array(kept), gone, gaps, *more, frozenset((*before, *after)),
                 spline.closed, run.closed, _order(net.source.pool, piece, spline),
                 piece.kind != 'hermite' and spline.kind == 'BEZIER')


def _between(slots, one, other):
    """The slots after one and before another, around the end."""
    at = slots.tolist()
    start, stop = at.index(one) + 1, at.index(other)
    return at[start:stop] if stop >= start else at[start:] + at[:stop]


def _beyond(run, slots, end):
    """The slots of points that were appended beyond an end: those that are not where it is."""
    return [slot for slot in slots.tolist() if run.numbers[slot] != STRAY and (run.places[slot] != run.places[end]).any()]


def _order(pool, piece, spline):
    """Of each point of the net of a piece its control point; of a cubic with handles its two ends."""
    if piece.kind == 'hermite':
        return np.arange(spline.count)
    if spline.kind == 'BEZIER':
        return np.array([0, 3])
    rows = piece.indices[:-1] if len(piece.indices) > 2 and piece.indices[0] == piece.indices[-1] else piece.indices
    return np.flatnonzero(pool[rows, 3] != 0)
