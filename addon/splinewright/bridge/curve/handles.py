"""Handle types of a shape's joints, kept as a text beside the definition on a Curve. read() is the one door.

A text for each piece, two letters to a joint, "" where its handles are what they look like: see core.net.handles.
"""

import json

from ...core.base.failures import Refusal
from ...core.net import handles
from ..data import store

KEY = "splinewright_handles"


def read(data, definition=None):
    """The types of a shape's pieces; () where none are given. Raises UnreadableDefinition where the stored data is
    none. definition: of the shape, where it is known."""
    if KEY not in data.keys():
        return ()
    try:
        types = json.loads(data[KEY])
        types = tuple(types) if type(types) is list else types
        handles.require_valid(types, store.read(data) if definition is None else definition)
    except (Refusal, TypeError, ValueError, RecursionError) as error:
        raise store.UnreadableDefinition("The handle types of {name} are damaged ({error}): its handles are what they look like, "
                                         "until one is given a type",
                                         name=data.name, error=error) from error
    return types


def known(data, definition=None):
    """read(), and () where they are damaged."""
    try:
        return read(data, definition)
    except store.UnreadableDefinition:
        return ()


def problem(data):
    """Why read() cannot, or ""."""
    try:
        read(data)
    except store.UnreadableDefinition as error:
        return str(error)
    return ""


def write(data, types):
    if any(types):
        data[KEY] = json.dumps(types)
    elif KEY in data.keys():
        del data[KEY]


def of_pieces(data, definition):
    """The types of each piece of a shape's definition, "" where nothing is said."""
    return known(data, definition) or ("",) * len(definition.pieces)


def of_all(blocks):
    """The types of the pieces of several shapes, one after the other."""
    return tuple(letters for data in blocks for letters in of_pieces(data, store.read(data)))


def carry(data, types, before, changed):
    """After a shape was given a core.verbs.verbs.Changed definition in place of the one before, with these types."""
    write(data, handles.carried(types, before, changed))
