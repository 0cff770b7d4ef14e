"""Patches that share a border have the same knots along it: those of all of them are moved together."""

from typing import NamedTuple

import numpy as np

#: Knots that agree to this part of what they reach over are the same ones.
_SAME = 1e-9


class Along(NamedTuple):
    """The knots of a patch, counted from 0, along an axis; turned where they run the other way than those meant."""

    piece: int
    axis: int
    is_turned: bool = False


def together(definition, piece, axis, has_cuts=False):
    """The Alongs of all patches whose knots are to be those of one along an axis, that first; of curves it alone.

    has_cuts: whether they are to be cut together, as Bezier patches are, too.
    """
    found = {(piece, axis): False}
    if definition.has_curves:
        return [Along(piece, axis)]
    borders = _borders(definition.pieces)
    todo = [(piece, axis)]
    while todo:
        one = todo.pop()
        for rows, is_turned in _rows_along(definition.pieces[one[0]], one[1]):
            for other, turned in borders[rows]:
                goes_back = found[one] ^ is_turned ^ turned
                if other not in found and _are_same(definition.pieces, (piece, axis), other, goes_back, has_cuts):
                    found[other] = goes_back
                    todo.append(other)
    return [Along(*place, is_turned) for place, is_turned in found.items()]


def _borders(pieces):
    """{rows of the pool: [((piece, axis), whether they are turned there)]} for the borders of all patches."""
    found = {}
    for number, piece in enumerate(pieces):
        for axis in range(2):
            for rows, is_turned in _rows_along(piece, axis):
                found.setdefault(rows, []).append(((number, axis), is_turned))
    return found


def _rows_along(piece, axis):
    """(rows of the pool, whether they are turned) of both borders along an axis; of none that is a point."""
    net = piece.indices[0] if piece.kind == 'hermite' else piece.indices
    for end in (0, -1):
        rows = tuple(np.take(net, end, 1 - axis).tolist())
        if len(set(rows)) > 1:
            yield min(rows, rows[::-1]), rows[::-1] < rows


def _are_same(pieces, one, other, is_turned, has_cuts):
    """Whether two patches have the same knots along their axes, but for where they begin and how far they reach."""
    (first, axis), (second, other_axis) = (pieces[one[0]], one[1]), (pieces[other[0]], other[1])
    if not has_cuts and (first.kind != second.kind or first.kind == 'bezier'):
        return False
    if 'hermite' in (first.kind, second.kind) and first.kind != second.kind or is_periodic(first, axis) != is_periodic(second, other_axis):
        return False
    old, others = knots_of(first, axis), knots_of(second, other_axis)
    if len(old) != len(others):
        return False
    mapped = carried(old, old, others, is_turned)
    return bool((np.abs((mapped[::-1] if is_turned else mapped) - others) <= _SAME * (others[-1] - others[0])).all())


def is_periodic(piece, axis):
    return bool(piece.periodic) and bool(piece.periodic[axis])


def knots_of(piece, axis):
    """The knots of a patch along an axis, parameters of a Hermite patch; of a Bezier patch those of its form as NURBS."""
    if piece.kind != 'bezier':
        return piece.knots[axis]
    return np.repeat([0.0, 1.0], piece.indices.shape[axis])


def carried(numbers, old, others, is_turned):
    """Parameters among old knots as those among the others that are the same."""
    if (old[0], old[-1]) == (others[0], others[-1]):
        return old[0] + (old[-1] - numbers) if is_turned else numbers
    part = (numbers - old[0]) / (old[-1] - old[0])
    return others[0] + (1.0 - part if is_turned else part) * (others[-1] - others[0])
