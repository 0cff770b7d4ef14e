"""Two patches brought together along a side of each (lecture row S21)."""

from contextlib import contextmanager
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..base.failures import AboutInputs, Refusal, about_input
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..shape import sewing
from ..verbs import patch_curves, verbs
from . import seams

#: For continuity, in the order in which it asks for more.
SMOOTHNESS = ('C0', 'G1', 'C1', 'G2', 'C2')
#: Which patch gives way.
MOVES = ('second', 'first', 'both')
SIDES = tuple(patch_curves.SIDES)
#: Points that differ by less, as a part of the largest number, are to go to one place.
_ROUNDING = 1e-13
#: Places along a side at which the distance of two is taken.
_PLACES = np.linspace(0.0, 1.0, 9)


class Choice(NamedTuple):
    """Which patch, counted from 1, or 0 for the nearest; which of its sides, or None for the nearest."""

    number: int = 0
    side: str | None = None


class Joined(NamedTuple):
    """What became of a definition, and what was achieved."""

    changed: verbs.Changed
    first: tuple                        # (number counted from 1, side, how far it moved)
    second: tuple
    measured: object                    # the splinecore SeamContinuity of the edge
    came_apart: tuple                   # pairs of patches, counted from 1, that shared a side before and share none now


def joined(definition, first, second, smoothness, moves, linear=np.eye(3), parted=None):
    """The Joined definition in which two patches continue as one another.

    first, second: Choices. moves: 'second', 'first' or 'both'. linear: (3, 3), what takes the points to the space in
    which distances are measured. parted: `first` is one of a given number of patches at the beginning, `second` one of the rest,
    counted from there. Raises Refusal where there are no such sides, or they cannot be joined: AboutInputs, of which number 0 is what
    has the first patch, 1 what has the second.
    """
    patches = verbs.pieces_of(definition)
    if len(patches) < 2:
        raise Refusal("it has one patch: select two shapes to join, or Make Periodic to close it")
    with about_input(0):
        rows = _sides(patches, 0, parted or len(patches), first, linear)
    with about_input(1):
        columns = _sides(patches, parted or 0, len(patches), second, linear)
    (a, side_a), (b, side_b) = _nearest(rows, columns)
    with _about_both():
        found = sc.build.join_patches(patches[a], side_a, patches[b], side_b, smoothness, moves)
    after = list(patches)
    after[a], after[b] = found.first, found.second
    made = _with_neighbors(definition, ((a, found.first), (b, found.second)))
    made = made or sewing.sewn(definition, after, range(len(after)), joined=((a, b),))
    changed = verbs.Changed(made, tuple(range(len(after))), max(found.first_error, found.second_error))
    apart = tuple((i + 1, j + 1) for i, j in seams.opened(definition, made, changed.parents))
    return Joined(changed, (a + 1, side_a, found.first_error), (b + 1, side_b, found.second_error),
                  seams.measured(found.first, side_a, found.second, side_b), apart)


@contextmanager
def _about_both():
    """What the library refuses of two patches."""
    try:
        yield
    except sc.InvalidShape as error:
        raise AboutInputs("{}, {}: {reason}", 0, 1, reason=str(error)) from error


def _with_neighbors(definition, moved):
    """The definition in which two patches that share a side have other points, and with them all that share these points; None where
    they share none, or have other knots or degrees now. moved: (number counted from 0, patch) of both."""
    pool, written = definition.pool.copy(), np.zeros(len(definition.pool), bool)
    rows = [np.unique(definition.pieces[number].indices) for number, _ in moved]
    if not len(np.intersect1d(*rows)):
        return None
    for number, patch in moved:
        piece, new = definition.pieces[number], definitions.from_value(patch)
        (own,) = new.pieces
        if own.layout != piece.layout or not all(map(np.array_equal, own.knots, piece.knots)):
            return None
        there, points = piece.indices.ravel(), new.pool[own.indices.ravel()]
        if not _agree(pool[there][written[there]], points[written[there]]):
            return None
        pool[there[~written[there]]] = points[~written[there]]
        if not _agree(pool[there], points):     # a point that it has twice was to go to two places
            return None
        written[there] = True
    return replace(definition, pool=pool)


def _agree(these, those):
    return not len(these) or np.abs(these - those).max() <= _ROUNDING * np.abs(those).max()


def nearest_sides(first, second, first_choice=Choice(), second_choice=Choice()):
    """((number, side), (number, side)), counted from 0: the sides of two lists of patches that lie nearest to each other, of
    those that the Choices leave. Raises Refusal if there are none."""
    patches = [*first, *second]
    rows = _sides(patches, 0, len(first), first_choice, np.eye(3))
    columns = _sides(patches, len(first), len(patches), second_choice, np.eye(3))
    (a, side_a), (b, side_b) = _nearest(rows, columns)
    return (a, side_a), (b - len(first), side_b)


class _Side(NamedTuple):
    patch: int
    side: str
    points: np.ndarray                  # (9, 3) along it


def _sides(patches, start, end, choice, linear):
    """The sides that a Choice among the patches from start to end leaves. Raises Refusal if there is none."""
    count = end - start
    if choice.number > count:
        raise Refusal("there are {count} patches, none of number {number}", "there is {count} patch, none of number {number}",
                      count=count, number=choice.number)
    numbers = [start + choice.number - 1] if choice.number else range(start, end)
    found, reasons = [], []
    for i in numbers:
        for side in (choice.side,) if choice.side else SIDES:
            curve, reason = patch_curves.side_of(patches[i], side)
            if reason:
                reasons.append(phrase("patch {i}: {reason}", i=i - start + 1, reason=reason))
                continue
            low, high = curve.domain
            at = np.minimum(low + _PLACES * (high - low), high)
            points = np.concatenate([curve.evaluate(at[:-1], at_infinity='nan'),
                                     curve.evaluate(at[-1:], side='left', at_infinity='nan')])
            found.append(_Side(i, side, points @ linear.T))
    if not found:
        raise Refusal(", ".join(reasons[:4]))
    return found


def _nearest(rows, columns):
    """((patch, side), (another patch, side)) of the two sides that lie nearest to each other."""
    others = np.stack([side.points for side in columns])
    owners = np.array([side.patch for side in columns])
    best, pair = np.inf, None
    for row in rows:
        gaps = np.minimum(*(np.linalg.norm(row.points[::step] - others, axis=-1).mean(axis=1) for step in (1, -1)))
        gaps[(owners == row.patch) | np.isnan(gaps)] = np.inf
        nearest = int(gaps.argmin())
        if gaps[nearest] < best:
            best, pair = gaps[nearest], ((row.patch, row.side), (columns[nearest].patch, columns[nearest].side))
    if pair is None:
        raise Refusal("a patch is not joined to itself: Make Periodic closes it")
    return pair
