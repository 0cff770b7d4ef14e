"""Control points that keys and drivers move: rows of a definition's pool. What Blender gives them, in float32; and which row
is which when the shape gets other pieces."""

from dataclasses import replace
from itertools import product

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.words import phrase
from .definition import have_same_pieces

_SINGLE = np.finfo(np.float32)
#: What Blender rounds, as a part of the largest number.
_ROUNDING = 8 * float(_SINGLE.eps)


def weighted(definition):
    """(n,) bool: rows that may have a weight. Points, tangents and twists of Hermite pieces have none, nor have directions."""
    plain = [piece.indices.ravel() for piece in definition.pieces if piece.kind == 'hermite']
    return (definition.pool[:, 3] != 0) & ~np.isin(np.arange(len(definition.pool)), np.concatenate([[-1], *plain]))


def require_single(pool, rows):
    """Raises Refusal where rows of a pool are no numbers that Blender's keys hold, which are of single precision."""
    given = np.abs(pool[rows])
    if (given > _SINGLE.max).any():
        raise Refusal("a point lies farther away, or has a larger weight, than keys reach (3.4e38)")
    if 0 < given[:, :3].max(initial=0.0) < _SINGLE.tiny or ((given[:, 3] > 0) & (given[:, 3] < _SINGLE.tiny)).any():
        raise Refusal("the numbers of these points are smaller than keys hold (1e-38)")


def taken(definition, rows, given, is_given):
    """(the definition with what rows (k,) are given, itself where they have that; why some of it is not taken, or "").

    given: (k, 4) float32, of which only is_given (k, 4) counts. A value that equals the row's number in float32 stays as it is.
    """
    pool = definition.pool[rows]
    with np.errstate(over='ignore'):
        wanted = is_given & (pool.astype(np.float32) != given)
    wanted[:, 3] &= weighted(definition)[rows] | (pool[:, 3] == 0)
    if not wanted.any():
        return definition, ""
    problem, is_wild = "", (wanted & ~np.isfinite(given)).any(1)
    is_weight = wanted[:, 3] & ~is_wild & ((pool[:, 3] == 0) | (given[:, 3] == 0))
    if is_wild.any():
        problem = phrase("keys or drivers give point {rows} a number that is none: it stays where it was", rows=rows[is_wild][0])
    elif is_weight.any():
        row = rows[is_weight][0]
        problem = (phrase("point {row} lies at infinity: its weight stays 0", row=row) if pool[is_weight][0, 3] == 0 else
                   phrase("keys or drivers give point {row} the weight 0, which would take it out of the shape: it keeps its weight",
                          row=row))
    wanted[is_wild] = False
    wanted[is_weight, 3] = False
    if not wanted.any():
        return definition, problem
    pool[wanted] = decimals.typed_all(given[wanted])
    every = definition.pool.copy()
    every[rows] = pool
    return replace(definition, pool=every), problem


def as_present(net, definition, present, rows):
    """What a net says, with those of the rows as the shape has them, pool `present`, that lie where it has them."""
    said = definition.pool
    if said.shape != present.shape:
        return definition
    slack = np.zeros(len(said))
    handles = net.handles[net.rows[net.handles] < len(said)]
    reach = _ROUNDING * np.abs(net.positions).max(initial=0.0)
    slack[net.rows[handles]] = reach / np.abs(net.factors[handles])
    with np.errstate(over='ignore'):
        is_there = (said[rows].astype(np.float32) == present[rows].astype(np.float32)).all(1)
    is_there |= (np.abs(said[rows] - present[rows]) <= slack[rows, None]).all(1)
    pool = said.copy()
    pool[rows[is_there]] = present[rows[is_there]]
    return definition if np.array_equal(pool, said) else replace(definition, pool=pool)


def carried(before, after, rows=None):
    """(n,) of each row of a definition the same point's row in another, which came of it, or -1. rows: those that matter; others
    may be left out.

    Where the pieces are what they were points have moved, unless they were reversed. Otherwise a point is the same that
    lies where it lay, seen from an end of its piece: what a verb did not touch.
    """
    found = np.full(len(before.pool), -1)
    lie_alike = _comparison(before.pool, after.pool)
    if have_same_pieces(before, after) or _are_alike(before, after, lie_alike):
        for one, other in zip(before.pieces, after.pieces):
            found[one.indices.ravel()] = _turned(one, other, lie_alike).ravel()
        return found
    is_left = [True] * len(after.pieces)
    asked = [one for one in before.pieces if rows is None or np.isin(one.indices, rows).any()]
    for one in asked:                   # what is whole comes first: parts of others may look like it
        for i, other in enumerate(after.pieces):
            if is_left[i] and _form(one) == _form(other) and lie_alike(one.indices, other.indices).all():
                found[one.indices.ravel()] = other.indices.ravel()
                is_left[i] = False
                break
    for one in asked:
        if (found[one.indices] < 0).any():
            for i, other in enumerate(after.pieces):
                if is_left[i] and (one.kind == 'hermite') == (other.kind == 'hermite'):
                    _match_ends(one, other, lie_alike, found)
    return found


def _comparison(pool, other):
    """A function of rows of a pool, and as many of another, that tells which lie alike but for rounding."""
    slack = 16 * np.finfo(np.float64).eps * np.abs(pool).max(0, initial=0.0)
    return lambda rows, others: (np.abs(pool[rows] - other[others]) <= slack).all(-1)


def _are_alike(before, after, lie_alike):
    """Whether pieces differ in knots only, or in which rows they share, where most points lie where they lay."""
    if [_form(piece) for piece in before.pieces] != [_form(piece) for piece in after.pieces]:
        return False
    if all(np.array_equal(one.indices, other.indices) for one, other in zip(before.pieces, after.pieces)):
        return True
    same = [lie_alike(one.indices, other.indices).ravel() for one, other in zip(before.pieces, after.pieces)]
    return 2 * np.concatenate(same).mean() > 1


def _form(piece):
    return piece.kind, piece.indices.shape, piece.degree, piece.periodic


def _axes(piece):
    """The axes of its indices along which a piece runs."""
    return range(1 if piece.kind == 'hermite' else 0, piece.indices.ndim)


def _turns(piece):
    """The indices of a piece as they are, and reversed in all ways."""
    axes = _axes(piece)
    for swaps in (False, True) if len(axes) == 2 else (False,):
        for is_turned in product((False, True), repeat=len(axes)):
            turned = np.swapaxes(piece.indices, *axes) if swaps else piece.indices
            yield np.flip(turned, [axis for axis, turns in zip(axes, is_turned) if turns])


def _turned(one, other, lie_alike):
    """The indices of a piece as another has them: reversed where it lies there only so. Tangents are others then: -1."""
    if one.kind != 'hermite':
        ways = (turned for turned in _turns(other) if turned.shape == one.indices.shape)
        return next((turned for turned in ways if lie_alike(one.indices, turned).all()), other.indices)
    for i, turned in enumerate(_turns(other)):
        if turned.shape == one.indices.shape and lie_alike(one.indices[0], turned[0]).all():
            return other.indices if i == 0 else np.stack([turned[0], *np.full_like(turned[1:], -1)])
    return other.indices


def _match_ends(one, other, lie_alike, found):
    """Note those points from each end, or corner, of a piece on that lie where they do in another."""
    axes = _axes(one)
    for turned in _turns(other):
        for ends in product((False, True), repeat=len(axes)):
            flipped = [axis for axis, is_last in zip(axes, ends) if is_last]
            _match_from(np.flip(one.indices, flipped), np.flip(turned, flipped), axes, lie_alike, found)


def _match_from(mine, theirs, axes, lie_alike, found):
    common = tuple(slice(min(a, b)) for a, b in zip(mine.shape, theirs.shape))
    mine, theirs = mine[common], theirs[common]
    same = lie_alike(mine, theirs)
    if axes[0] == 1:                    # a point with its tangents
        same = np.broadcast_to(same.all(0), same.shape)
    for axis in axes:
        same = np.logical_and.accumulate(same, axis)
    new = same & (found[mine] < 0)
    found[mine[new]] = theirs[new]
