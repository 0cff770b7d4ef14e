"""The space in which a shape is made from objects, and where those lie in it.

A shape that stays on its inputs is made in the space of the object itself. One that moves freely has a space beside it: that stays
where it is while the shape is moved, or an input, and moves along where all of them are moved as one. What Apply took out of the
object is applied to the shape made there, after it was made: axes, planes and lengths mean what they meant.
"""

from typing import NamedTuple

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ..data import store
from . import recipes

#: Keys in the group of a recipe: the space's matrix, those of the object and of its inputs when they were looked at last, and
#: those from the inputs to the space; what was applied, from the space to the shape. All float64, row by row.
_PLACE, _SEEN, _RELATIVE, _APPLIED = 'place', 'seen', 'relative', 'applied'
_SINGLE = float(np.finfo(np.float32).eps)


class Space(NamedTuple):
    """Where a recipe works."""

    matrix: np.ndarray                  # (4, 4): from it to the world
    depsgraph: bpy.types.Depsgraph
    kept: dict = {}                     # of an object the (4, 4) from its space to this one, where that is kept
    applied: np.ndarray = np.eye(4)     # from it to the shape that shows what is made in it

    def of(self, ob):
        """(4, 4): from the space of an object, or of the world for None, to this one."""
        return self.kept[ob] if ob in self.kept else _between(self.matrix, world(ob, self.depsgraph))

    def to_lengths(self):
        """(4, 4): from this space to one in which lengths are those of the world; turned as that only where it must be."""
        linear = self.matrix[:3, :3]
        size = abs(float(np.linalg.det(linear))) ** (1 / 3)
        if np.abs(linear.T @ linear - size * size * np.eye(3)).max() > 16 * _SINGLE * size * size:
            return self.matrix
        return np.diag([*[1.0 if abs(size - 1.0) <= 16 * _SINGLE else size] * 3, 1.0])


def of_object(ob, depsgraph):
    """The Space of an object, or of the world for None. Raises Refusal where that has no room for anything."""
    matrix = world(ob, depsgraph)
    if not abs(np.linalg.det(matrix[:3, :3])) > 0.0:
        raise Refusal("{name} has a scale of 0: it cannot show what it follows", name=ob.name)
    return Space(matrix, depsgraph)


def beside(ob, depsgraph):
    """The Space that lies and is turned as an object, or as the world for None, without its scale."""
    if ob is None:
        return Space(np.eye(4), depsgraph)
    location, rotation, _ = ob.evaluated_get(depsgraph).matrix_world.decompose()
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation.to_matrix(), location
    return Space(matrix, depsgraph)


def world(ob, depsgraph):
    """(4, 4): from the space of an object, or of the world for None, to the world."""
    return np.eye(4) if ob is None else np.array(ob.evaluated_get(depsgraph).matrix_world, dtype=np.float64)


def _between(space, own):
    """From one space to another. What single precision cannot tell from 0, or from no map at all, is that: going there and
    back would move every point by a rounding, and the end of a profile that is off its axis by a rounding is no pole."""
    if _are_one(space, own):
        return np.eye(4)
    found = np.linalg.inv(space) @ own
    far = max(np.abs(own[:3, 3]).max(), np.abs(space[:3, 3]).max()) * np.abs(np.linalg.inv(space[:3, :3])).max()
    rounding = 4 * _SINGLE * np.array([*[np.abs(found[:3, :3]).max()] * 3, far])
    found[np.abs(found) <= rounding] = 0.0
    found[3] = 0.0, 0.0, 0.0, 1.0
    return found


def _are_one(space, own):
    return np.abs(space - own).max() <= 4 * _SINGLE * max(1.0, np.abs(own).max())


def moves_freely(data):
    """Whether a shape that is made from objects is moved without them."""
    return recipes.follows(data) and _PLACE in data[recipes.KEY].keys()


def is_away(data, ob):
    """Whether a shape that moves freely was moved from where its inputs lie."""
    return moves_freely(data) and not _are_one(_matrices(data, _PLACE)[0],
                                               np.array(ob.matrix_world, dtype=np.float64) @ _applied(data))


def start(data, space, ob, inputs):
    """Let a shape move freely from now on. ob: its object, or None for one that lies as the space does."""
    own = world(ob, space.depsgraph) if ob is not None else space.matrix
    seen = np.array([own, *(world(each, space.depsgraph) for each in inputs)])
    _write(data, space.matrix, seen, np.array([space.of(each) for each in inputs]))
    if (space.applied != np.eye(4)).any():
        _write_matrices(data, _APPLIED, space.applied)


def stop(data):
    """Let a shape stay on its inputs from now on."""
    for name in (_PLACE, _SEEN, _RELATIVE, _APPLIED):
        data[recipes.KEY].pop(name, None)


def kept_up(data, ob, inputs, depsgraph):
    """The Space that a shape is made in now, after its object and inputs may have been moved. Raises Refusal."""
    if not moves_freely(data):
        return of_object(ob, depsgraph)
    place, seen, relative = _matrices(data, _PLACE)[0], _matrices(data, _SEEN), _matrices(data, _RELATIVE)
    now = np.array([world(each, depsgraph) for each in (ob, *inputs)])
    if len(relative) != len(inputs) or len(seen) != len(now):
        seen, relative = np.full_like(now, np.nan), np.empty((len(inputs), 4, 4))
    if not np.array_equal(seen, now):
        if _are_moved_as_one(seen, now):
            place = now[0] @ np.linalg.inv(seen[0]) @ place
        else:
            for i in np.flatnonzero((seen != now).any(axis=(1, 2))[1:]):
                relative[i] = _between(place, now[i + 1])
        _write(data, place, now, relative)
    return Space(place, depsgraph, dict(zip(inputs, relative)), _applied(data))


def now(data, ob, inputs, depsgraph):
    """kept_up() as it was left, with nothing written. Raises Refusal."""
    if not moves_freely(data):
        return of_object(ob, depsgraph)
    return Space(_matrices(data, _PLACE)[0], depsgraph, dict(zip(inputs, _matrices(data, _RELATIVE))), _applied(data))


def applied(data, matrix, inputs, depsgraph):
    """The Space of a shape that moves freely after an affine matrix (4, 4) was applied to what it shows."""
    before = now(data, None, inputs, depsgraph)
    return before._replace(applied=matrix @ before.applied)


def _are_moved_as_one(before, now):
    """Whether all matrices, from the first one on, were changed by the same map."""
    moved = np.abs(now - before).max(axis=(1, 2))
    if not (moved > 0.0).all() or not abs(np.linalg.det(before[0])) > 0.0:
        return False
    expected = now[0] @ np.linalg.inv(before[0]) @ before[1:]
    sizes = np.abs(now[1:]).max(axis=(1, 2)) + np.abs(now[0]).max()
    return bool((np.abs(expected - now[1:]).max(axis=(1, 2)) <= 1e-3 * moved[1:] + 64 * _SINGLE * sizes).all())


def _applied(data):
    found = _matrices(data, _APPLIED)
    return found[0] if len(found) else np.eye(4)


def _matrices(data, name):
    """Raises UnreadableDefinition for damaged data."""
    try:
        found = np.array(data[recipes.KEY].get(name, ()), dtype=np.float64).reshape(-1, 4, 4)
        if np.isfinite(found).all() and (len(found) or name != _PLACE):
            return found.copy()
    except (TypeError, ValueError):
        pass
    raise store.UnreadableDefinition("The recipe of {name} is damaged (its place is none): it is shown as it was last",
                                     name=data.name)


def _write(data, place, seen, relative):
    for name, matrices in ((_PLACE, place), (_SEEN, seen), (_RELATIVE, relative)):
        _write_matrices(data, name, matrices)


def _write_matrices(data, name, matrices):
    store.overwrite(data[recipes.KEY], name, np.ascontiguousarray(matrices, dtype=np.float64).ravel())
