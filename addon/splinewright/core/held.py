"""Continuity that holds: seams of patches that are made smooth anew whenever a side of theirs has moved (lecture row S21)."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from . import patch_joints
from .failures import Refusal
from .library import sc
from .patch_curves import SIDES

#: How often all seams are gone through where they share patches.
_ROUNDS = 12
#: What moves less, as a part of the largest number, was there already.
_ROUNDING = 16 * np.finfo(np.float64).eps
#: What still moves more after all rounds, as a part of the shape's size or of its weights, contradicts itself.
_AGREED = 1e-9


class Held(NamedTuple):
    """A seam that holds: (patch counted from 0, side) of both, what they share there, and which gives way."""

    first: tuple
    second: tuple
    smoothness: str
    moves: str


def require_valid(held, count):
    """Raises Refusal unless a seam is one of a shape of so many patches."""
    for patch, side in (held.first, held.second):
        if type(patch) is not int or not 0 <= patch < count or side not in SIDES:
            raise Refusal("a seam that holds is none of the shape's")
    if held.first == held.second or held.smoothness not in patch_joints.SMOOTHNESS or held.moves not in patch_joints.MOVES:
        raise Refusal("a seam that holds says nothing that is known")


def are_one(definition, held):
    """Whether the two sides of a seam, or of a core.seams.Seam, are one edge of two patches: the same rows of the pool."""
    if held.first[0] == held.second[0]:
        return False
    sides = [_border(definition.pieces[patch], side) for patch, side in (held.first, held.second)]
    return any(np.array_equal(sides[0], other) for other in (sides[1], sides[1][::-1]))


def _border(piece, side):
    axis, end = side.split('_')
    net = piece.indices[0] if piece.kind == 'hermite' else piece.indices
    return np.take(net, 0 if end == 'start' else -1, 'uv'.index(axis))


def shifted(seams, count):
    """Seams of patches before which there are so many more now."""
    return tuple(seam._replace(first=(seam.first[0] + count, seam.first[1]), second=(seam.second[0] + count, seam.second[1]))
                 for seam in seams)


def carried(seams, parents, definition):
    """Those of the seams that are seams of a definition still whose pieces came of the pieces with these numbers."""
    found = []
    for held in seams:
        now = [[i for i, parent in enumerate(parents) if parent == patch] for patch, _ in (held.first, held.second)]
        if all(len(numbers) == 1 for numbers in now):
            moved = held._replace(first=(now[0][0], held.first[1]), second=(now[1][0], held.second[1]))
            found += [moved] if are_one(definition, moved) else []
    return tuple(found)


def applied(definition, seams):
    """The definition with these Held seams made to hold; itself where they do. Raises Refusal where one takes other knots,
    or they contradict one another."""
    if not all(are_one(definition, held) for held in seams):
        raise Refusal("a seam that is to hold is none any more: release it")
    pool = definition.pool.copy()
    finite = pool[pool[:, 3] != 0]
    reach, weight = np.abs(finite[:, :3]).max(initial=0.0), np.abs(finite[:, 3]).max(initial=0.0)
    rounding = _ROUNDING * np.array([reach, reach, reach, weight])
    agreed = np.maximum(_AGREED * np.array([definition.size] * 3 + [weight]), 4 * rounding)
    for _ in range(_ROUNDS):
        moved = [_made_to_hold(definition, pool, held, rounding) for held in seams]
        if (np.array(moved).reshape(-1, 4) <= agreed).all():
            break
    else:
        raise Refusal("the seams that are to hold contradict one another: release one of them")
    return definition if np.array_equal(pool, definition.pool) else replace(definition, pool=pool)


def _made_to_hold(definition, pool, held, rounding):
    """Move the rows of the pool beside a seam that are off by more than rounding (4,); (4,) how far."""
    pieces = [definition.pieces[patch] for patch, _ in (held.first, held.second)]
    patches = [_patch(piece, pool) for piece in pieces]
    joined = sc.build.join_patches(patches[0], held.first[1], patches[1], held.second[1], held.smoothness, held.moves)
    farthest = np.zeros(4)
    for piece, before, after in zip(pieces, patches, (joined.first, joined.second)):
        if after.points.shape != before.points.shape or not all(map(np.array_equal, after.knots, before.knots)):
            raise Refusal("the patches beside a seam that is to hold have other knots or degrees now: release it, and hold it anew")
        rows = np.dstack([after.points, after.weights])
        change = np.abs(rows - pool[piece.indices])
        is_moved = (change > rounding).any(-1)
        pool[piece.indices[is_moved]] = rows[is_moved]
        farthest = np.maximum(farthest, change.max((0, 1)))
    return farthest


def _patch(piece, pool):
    """The NurbsPatch of a piece with its points from a pool."""
    rows = pool[piece.indices]
    if piece.kind == 'bezier':
        return sc.BezierPatch(rows[..., :3], rows[..., 3]).to_nurbs()
    if piece.kind != 'nurbs':
        raise Refusal("seams of Hermite patches do not hold: make them NURBS patches first")
    return sc.NurbsPatch(piece.degree, piece.knots, rows[..., :3], rows[..., 3], piece.periodic)
