"""The net of points that may become more and fewer: the digits behind the present points."""

from dataclasses import replace

import numpy as np


def digits(net, typed, numbers, positions):
    """(n, 3) float64: the known digits of float32 positions; a position of which none are known stays as it is.

    Known are the points that the net was made with, by their numbers, and typed rows (number, x, y, z, w), of which
    later ones win. New points carry copies of a number: hence a number only decides where one position has two kinds
    of digits.
    """
    known = _known(net, typed)
    exact = positions.astype(np.float64)
    for i, (number, position) in enumerate(zip(numbers.tolist(), map(tuple, positions.tolist()))):
        exact[i] = known.get((number, position), known.get(position, exact[i]))
    return exact


def _known(net, typed):
    """Digits by number and float32 position, and by position alone."""
    rows = np.concatenate([np.column_stack([np.arange(len(net.positions)), net.positions]), typed[:, :4]])
    with np.errstate(over='ignore'):
        at = map(tuple, rows[:, 1:].astype(np.float32).tolist())
    known = {}
    for (number, *row), position in zip(rows.tolist(), at):
        known[number, position] = known[position] = row
    return known


def present(net, positions, weights, splines):
    """The Net of other points than it was made with, in the order of the splines."""
    count = len(positions)
    return replace(net, positions=positions, weights=weights, rows=np.arange(count, dtype=np.int32),
                   origins=np.full((count, 3), -1, np.int32), factors=np.ones(count), splines=tuple(splines))
