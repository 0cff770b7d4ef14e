"""Seams that hold, kept as a text beside the definition on a Mesh. read() is the one door."""

import json

from ..core import held
from ..core.failures import Refusal
from ..core.held import Held
from . import store

KEY = "splinewright_held"


def read(data):
    """The Helds of a shape. Raises UnreadableDefinition where what is stored is none."""
    if KEY not in data.keys():
        return ()
    try:
        seams = _stored(data)
        for seam in seams:
            held.require_valid(seam, len(store.read(data).pieces))
    except (Refusal, TypeError, ValueError) as error:
        raise store.UnreadableDefinition(f"The seams of {data.name} that hold are damaged: release them ({error})") from error
    return seams


def _stored(data):
    """Raises TypeError or ValueError."""
    return tuple(Held((a, side), (b, other), smoothness, moves)
                 for a, side, b, other, smoothness, moves in json.loads(data[KEY]))


def write(data, seams):
    if seams:
        data[KEY] = json.dumps([[*seam.first, *seam.second, seam.smoothness, seam.moves] for seam in seams])
    elif KEY in data.keys():
        del data[KEY]


def hold(data, seam):
    """Let a seam hold from now on, in place of what was said of it before."""
    write(data, (*without(read(data), seam.first, seam.second), seam))


def release(data, first, second):
    write(data, without(read(data), first, second))


def without(seams, first, second):
    return tuple(seam for seam in seams if {seam.first, seam.second} != {first, second})


def carry(data, parents):
    """After a verb: the pieces came of those with these numbers. What was damaged is dropped."""
    if KEY in data.keys():
        try:
            before = _stored(data)
        except (TypeError, ValueError):
            before = ()
        write(data, held.carried(before, parents, store.read(data)))
