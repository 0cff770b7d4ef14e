"""Which of the points that are there are the net's. Gestures of Blender copy points, number and all, and make new ones.

What a gesture leaves beside the net's points is a stray: a copy, where the point itself is there, or a new point.
"""

import numpy as np


def seals(count, first=0):
    """(count,) float32 by which the points with a number, from the first on, and their copies are told from what Blender
    makes between two: what lies between two seals is none, and 0 and 1, which new points have, are none."""
    numbers = np.arange(first, first + count, dtype=np.float64) % 65536
    return (1.25 + 0.5 * np.modf(numbers * numbers * 0.6180339887498949)[0]).astype(np.float32)


def of_net(numbers, found, seals):
    """The numbers (m,) of points that carry the seal of their number, -1 in place of others.

    found: (m,), the seals that they carry; seals: those of all numbers.
    """
    known = (numbers >= 0) & (numbers < len(seals))
    known[known] = found[known] == seals[numbers[known]]
    return np.where(known, numbers, -1)


def chosen(numbers, count, links=None, neighbors=()):
    """(count,): for each number of the net the slot of its point in `numbers` (m,), or -1 where none has it.

    Of several it is the one that is connected as the net was, else the first. links: a function that gives pairs of
    slots that are connected now, asked only where there are several; neighbors: pairs of numbers that were.
    """
    if len(numbers) == count and np.array_equal(numbers, np.arange(count)):
        return np.arange(count)
    slots = np.flatnonzero((numbers >= 0) & (numbers < count))
    own = numbers[slots]
    if links is not None and len(np.unique(own)) < len(own):
        likeness = _likeness(numbers, count, np.asarray(links()).reshape(-1, 2), np.asarray(neighbors).reshape(-1, 2))
        order = np.lexsort((slots, -likeness[slots], own))
    else:
        order = np.lexsort((slots, own))
    found, first = np.unique(own[order], return_index=True)
    result = np.full(count, -1)
    result[found] = slots[order[first]]
    return result


def _likeness(numbers, count, links, neighbors):
    """(m,): to how many points each is connected that were its neighbors."""
    pairs = numbers[links]
    known = (pairs >= 0).all(1) & (pairs < count).all(1) & np.isin(_keys(pairs, count), _keys(neighbors, count))
    return np.bincount(links[known].ravel(), minlength=len(numbers))


def _keys(pairs, count):
    return pairs.min(1) * (count + 1) + pairs.max(1)
