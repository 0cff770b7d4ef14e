"""What happened to the rows of patches, read from a cage: rows that are gone, cut in, or extruded from a border."""

from collections import defaultdict
from dataclasses import dataclass, field

import numpy as np

from ..base.failures import Refusal
from .grown import NEW, STRAY, copy_of

_HALF = "a border that patches share is cut on one side only: cut the patches on both sides, the shape has them as they were"


@dataclass(eq=False)
class Axis:
    """The edit to make with a patch along an axis."""

    gone: list = field(default_factory=list)        # places of rows
    gaps: list = field(default_factory=list)        # (place among the rows that stay, fractions of the way to the next)
    is_mirrored: bool = False                       # whether those are told from the next row backwards
    before: bool = False                            # whether a row was extruded beyond the start, the end
    after: bool = False

    @property
    def torn(self):
        """The places, among the rows that stay, after which some are gone; -1 for those before all."""
        return {place - i - 1 for i, place in enumerate(self.gone)}

    @property
    def is_idle(self):
        return self.only_appends and not (self.before or self.after)

    @property
    def only_appends(self):
        return not (self.gone or self.gaps)


@dataclass(eq=False)
class Plan:
    """The edit to make with a patch, and the slots of its points then."""

    axes: tuple
    slots: np.ndarray                   # (rows, columns)
    is_torn: bool = False               # whether a row went with the faces beside it, so that there is a gap

    @property
    def is_idle(self):
        return all(axis.is_idle for axis in self.axes)


def grids(net):
    """Of each patch (rows, columns) vertices of its points in a net, -1 for directions at infinity."""
    points = np.flatnonzero(net.are_points)
    vertices = np.full(len(net.definition.pool), -1)
    vertices[net.rows[points]] = points
    return [vertices[piece.indices[0] if piece.kind == 'hermite' else piece.indices] for piece in net.definition.pieces]


def plans(net, cage):
    """Of each patch its Plan; None where it is not told what happened to rows of the net. Raises Refusal where it is, and
    cannot be."""
    whole, slots, fringes = grids(net), cage.slots(len(net.rows)), list(_fringes(cage))
    if (slots >= 0).all() and not fringes and not (cage.numbers == NEW).any():
        return None                     # as at every step of a drag beside copies
    periodic = [piece.periodic or (False, False) for piece in net.definition.pieces]
    found = [_without_gone(grid, slots) for grid in whole]
    if any(plan is None for plan in found) or not _are_rows(found, whole, slots):
        return None
    if not _cut(cage, found, periodic):
        return None
    _extruded(cage, fringes, found, periodic, _counts(net))
    _require_seams(found, whole)
    return found


def _without_gone(grid, slots):
    """The Plan of a patch without the rows that are gone; None where there are points gone that are no rows. A pole stays
    where other rows that run into it go."""
    gone = (grid >= 0) & (slots[grid] < 0)
    stays = ~gone & ((grid < 0) | _are_poles(grid, 0) | _are_poles(grid, 1))
    rows = [(gone | stays).all(1 - axis) & gone.any(1 - axis) for axis in (0, 1)]
    if rows[0].all() or rows[1].all() or not np.array_equal(gone, (rows[0][:, None] | rows[1]) & ~stays):
        return None
    kept = np.where(grid < 0, -1, slots[grid])[~rows[0]][:, ~rows[1]]
    return Plan(tuple(Axis(np.flatnonzero(row).tolist()) for row in rows), kept)


def _are_poles(grid, axis):
    """Whether the row of each vertex along an axis is one point."""
    rows = np.moveaxis(grid, axis, 0)
    return np.moveaxis(np.broadcast_to((rows == rows[:, :1]).all(1)[:, None], rows.shape), 0, axis)


def _are_rows(found, whole, slots):
    """Whether all points that are gone are of patches."""
    return (slots >= 0).all() or bool(np.isin(np.flatnonzero(slots < 0), np.concatenate([g.ravel() for g in whole])).all())


# Rows that were cut in -----------------------------------------------------------------------------


class _Ways:
    """Chains of new vertices between neighbors, each told once."""

    def __init__(self, cage):
        self._cage, self._known, self.taken = cage, {}, set()

    def between(self, one, other):
        """The chain from one slot to another, None where there is none."""
        if (one, other) not in self._known:
            chain = self._cage.chain(one, other, self.taken)
            self._known[one, other] = chain
            self._known[other, one] = chain[::-1] if chain else chain
        return self._known[one, other]

    def through(self, one, other, count):
        """between(); at a pole a multiple of that."""
        if min(one, other) < 0:
            return None
        return [one] * count if one == other else self.between(one, other)


def _pairs(slots, axis, periodic):
    """Of each gap between rows along an axis the pairs of neighbors."""
    rows = np.moveaxis(slots, axis, 0)
    following = np.roll(rows, -1, 0) if periodic else rows[1:]
    return [list(zip(row.tolist(), other.tolist())) for row, other in zip(rows, following)]


def _cut(cage, found, periodic):
    """Take up the inserted cut; False where the part between neighbors is unknown."""
    ways, by_pair, lengths, halves = _Ways(cage), defaultdict(list), {}, []
    for i, (plan, around) in enumerate(zip(found, periodic)):
        for axis in (0, 1):
            for place, pairs in enumerate(_pairs(plan.slots, axis, around[axis])):
                chains = [ways.between(*pair) for pair in pairs if min(pair) >= 0 and pair[0] != pair[1]]
                counts = {None if chain is None else len(chain) for chain in chains} or {0}
                if counts == {None} and place in plan.axes[axis].torn:
                    plan.is_torn, counts = True, {0}
                if None in counts:
                    return False
                if len(counts) > 1:
                    halves += pairs
                elif counts != {0}:
                    lengths[i, axis, place] = counts.pop()
                    for pair in pairs:
                        if min(pair) >= 0 and pair[0] != pair[1]:
                            by_pair[frozenset(pair)].append(((i, axis, place), pair))
    if any(frozenset(pair) in by_pair for pair in halves):
        raise Refusal(_HALF)
    if halves:
        return False
    fractions = _fractions(cage, ways, by_pair, lengths)
    by_patch = [{gap[1:]: told for gap, told in fractions.items() if gap[0] == i} for i in range(len(found))]
    return all(_with_chains(cage, ways, plan, gaps) for plan, gaps in zip(found, by_patch))


def _fractions(cage, ways, by_pair, lengths):
    """{gap: (fractions of the way at which rows were cut in, whether they are told from the next row backwards)}.

    What was cut by one loop has one: where the new vertices lie between their neighbors, on the average.
    """
    pairs_of = defaultdict(list)
    for uses in by_pair.values():
        for gap, pair in uses:
            pairs_of[gap].append(pair)
    told = {}
    for gap, count in lengths.items():
        if gap in told:
            continue
        turned, open_gaps, pairs = {gap: False}, [gap], {}
        while open_gaps:
            one = open_gaps.pop()
            for pair in pairs_of[one]:
                pairs[frozenset(pair)] = pair[::-1] if turned[one] else pair
                for other, its_pair in by_pair[frozenset(pair)]:
                    if other not in turned:
                        turned[other] = turned[one] != (its_pair != pair)
                        open_gaps.append(other)
        at = _where(cage, [(one, ways.between(one, other), other) for one, other in pairs.values()], count)
        told.update({other: (at, is_turned) for other, is_turned in turned.items()})
    return told


def _where(cage, chains, count):
    """The fractions at which chains of new vertices lie between their ends, on the average."""
    places, even = cage.places.astype(np.float64), np.arange(1, count + 1) / (count + 1)
    ends = places[[(one, other) for one, _, other in chains]]
    ways = ends[:, 1] - ends[:, 0]
    lengths = (ways * ways).sum(-1)
    is_long = lengths > 0
    if not is_long.any():
        return even.tolist()
    new = places[[chain for _, chain, _ in chains]] - ends[:, :1]
    found = ((new * ways[:, None]).sum(-1)[is_long] / lengths[is_long, None]).mean(0)
    found = np.where(np.abs(found - even) < 1e-4, even, np.clip(found, 0.01, 0.99))
    return (found if (np.diff(found) > 1e-3).all() else even).tolist()


def _with_chains(cage, ways, plan, gaps):
    """Put the new vertices of a patch among its slots, of gaps {(axis, place): (fractions, is_mirrored)}; whether they are
    all told."""
    for axis in (0, 1):
        own = [place for along, place in sorted(gaps) if along == axis]
        plan.axes[axis].is_mirrored = is_mirrored = any(gaps[axis, place][1] for place in own)
        plan.axes[axis].gaps = [(place, _told_from(is_mirrored, *gaps[axis, place])) for place in own]
        rows = np.moveaxis(plan.slots, axis, 0)
        parts = []
        for place, row in enumerate(rows):
            parts.append(row[None])
            if place in own:
                count = len(gaps[axis, place][0])
                chains = [ways.through(*pair, count) for pair in zip(row.tolist(), rows[(place + 1) % len(rows)].tolist())]
                if any(chain is None or len(chain) != count for chain in chains):
                    return False
                parts.append(np.array(chains).T)
        plan.slots = np.moveaxis(np.concatenate(parts), 0, axis)
        ways.taken.update(slot for slot in plan.slots.ravel().tolist() if cage.numbers[slot] == NEW)
    return True


def _told_from(is_mirrored, fractions, are_mirrored):
    return fractions if are_mirrored == is_mirrored else [1.0 - fraction for fraction in fractions[::-1]]


# Rows that were extruded ---------------------------------------------------------------------------


def _counts(net):
    """{pair of vertices: of how many faces of the net it is a side}."""
    found = defaultdict(int)
    for corners in net.faces:
        for i, corner in enumerate(corners):
            found[frozenset((corner, corners[i - 1]))] += 1
    return found


def _extruded(cage, fringes, found, periodic, counts):
    """Take up the rows that were extruded from borders, each beside all patches that it is a border of."""
    for fringe in fringes:
        sides = [(plan, axis, end) for plan, around in zip(found, periodic) for axis in (0, 1) for end in (0, -1)
                 if not around[axis] and _is_open(cage, counts, np.take(plan.slots, end, axis), fringe)]
        covered = {slot for plan, axis, end in sides for slot in np.take(plan.slots, end, axis).tolist()}
        if covered == set(fringe) and len({id(plan) for plan, _, _ in sides}) == len(sides):
            for plan, axis, end in sides:
                row = np.array([[fringe[slot] for slot in np.take(plan.slots, end, axis).tolist()]])
                rows = np.moveaxis(plan.slots, axis, 0)
                plan.slots = np.moveaxis(np.concatenate([rows, row] if end else [row, rows]), 0, axis)
                setattr(plan.axes[axis], 'after' if end else 'before', True)


def _is_open(cage, counts, border, fringe):
    """Whether a fringe has copies of all vertices of a border that has faces on one side only."""
    own = border.tolist()
    if len(set(own)) < 2 or not set(own) <= set(fringe):
        return False
    numbers = cage.numbers[own].tolist()
    sides = [pair for pair in zip(numbers, numbers[1:]) if pair[0] != pair[1]]
    return min(numbers) >= 0 and all(counts[frozenset(pair)] == 1 for pair in sides)


def _fringes(cage):
    """Of each group of copies that are connected, and with what they are copies of, {slot: slot of its copy}; those are
    left out that lie where they were made."""
    own = {number: slot for slot, number in enumerate(cage.numbers.tolist()) if number >= 0}
    copies = {}
    for slot in np.flatnonzero((cage.numbers < NEW) & (cage.numbers != STRAY)).tolist():
        origin = own.get(copy_of(int(cage.numbers[slot])))
        if origin is not None and origin in cage.beside[slot]:
            copies[slot] = origin
    while copies:
        group, ahead = {}, [next(iter(copies))]
        while ahead:
            slot = ahead.pop()
            if slot in copies:
                group[slot] = copies.pop(slot)
                ahead += cage.beside[slot]
        fringe = {origin: slot for slot, origin in group.items()}
        is_moved = any((cage.places[one] != cage.places[other]).any() for one, other in fringe.items())
        if is_moved and len(fringe) == len(group):
            yield fringe


# Borders that patches share ------------------------------------------------------------------------


def _side(grid, axis, end):
    return tuple(np.take(grid, end, axis).tolist())


def _require_seams(found, whole):
    """Raises Refusal unless the patches that shared a border share one."""
    by_side = defaultdict(list)
    for i, grid in enumerate(whole):
        for axis in (0, 1):
            for end in (0, -1):
                side = _side(grid, axis, end)
                if len(set(side)) > 1:
                    by_side[min(side, side[::-1])].append((i, axis, end))
    for uses in by_side.values():
        now = {min(side, side[::-1]) for side in (_side(found[i].slots, axis, end) for i, axis, end in uses)}
        if len(now) > 1:
            raise Refusal("patches that share a border would not meet there any more: extrude, cut or dissolve rows of both")
