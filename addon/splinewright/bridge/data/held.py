"""Joints and seams that hold, kept as a text beside the definition. read() is the one door."""

import json

from ...core.base.failures import Refusal
from ...core.joints import held
from ...core.joints.held import Held
from . import store

KEY = "splinewright_held"


def has(data):
    """Whether any are stored, readable or not."""
    return KEY in data.keys()


def read(data, definition=None):
    """The Helds of a shape. Raises UnreadableDefinition where the stored data is none. definition: of the shape, where it is
    known."""
    if not has(data):
        return ()
    try:
        seams = tuple(Held((a, side), (b, other), smoothness, moves)
                      for a, side, b, other, smoothness, moves in json.loads(data[KEY]))
        definition = definition or store.read(data)
        for seam in seams:
            held.require_valid(seam, definition)
    except (Refusal, TypeError, ValueError, RecursionError) as error:
        raise store.UnreadableDefinition("What holds in {name} is damaged: release it ({error})",
                                         name=data.name, error=error) from error
    return seams


def known(data):
    """read(), and none where they are damaged."""
    try:
        return read(data)
    except store.UnreadableDefinition:
        return ()


def write(data, seams):
    if seams:
        data[KEY] = json.dumps([[*seam.first, *seam.second, seam.smoothness, seam.moves] for seam in seams])
    elif has(data):
        del data[KEY]


def with_one(data, seam):
    """The Helds of a shape, and one in place of what was said of it before."""
    return *_without(read(data), seam.first, seam.second), seam


def hold(data, seam):
    """Let a seam hold from now on."""
    write(data, with_one(data, seam))


def release(data, first, second):
    write(data, _without(read(data), first, second))


def _without(seams, first, second):
    return tuple(seam for seam in seams if {seam.first, seam.second} != {first, second})


def of_all(obs):
    """The Helds of several shapes, numbered as their pieces are one after the other in the space of the first."""
    found, count = (), 0
    for ob in obs:
        is_mirrored = ob.matrix_world.determinant() * obs[0].matrix_world.determinant() < 0
        found += held.shifted(held.mirrored(known(ob.data)) if is_mirrored and ob.type == 'MESH' else known(ob.data), count)
        count += len(store.read(ob.data).pieces)
    return found


def mirror(data):
    """After u and v of patches were exchanged."""
    write(data, held.mirrored(known(data)))


def carry(data, seams, before, parents=None):
    """After a shape was given other pieces than it had in the definition `before`: they came of those with these numbers, by
    default of those with their own, and these seams held."""
    if seams:
        definition = store.read(data)
        parents = range(len(definition.pieces)) if parents is None else parents
        seams = held.carried(seams, parents, before, definition)
    write(data, seams)
