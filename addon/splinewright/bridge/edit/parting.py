"""Pieces of a shape are deleted, or become separate shapes."""

from ...core.base.failures import Refusal
from ...core.verbs import verbs
from . import replace_pieces


def delete(data, numbers):
    """Take pieces, counted from 0, out of a shape. Returns the definition before and the core.verbs.verbs.Changed.

    Raises Refusal, and changes nothing, where none would be left or the definition is not to be changed.
    """
    before = replace_pieces.read(data)
    changed = verbs.kept(before, [i for i in range(len(before.pieces)) if i not in numbers])
    replace_pieces.put(data, before, changed)
    return before, changed


def separate(ob, groups):
    """Make an object of each group of pieces, with all that lies on them, and take them out of the shape.

    groups: lists of numbers counted from 0. Where they hold all pieces the first group stays in the object. Returns the new
    objects, in the collections of the first. Raises Refusal, and changes nothing, as delete().
    """
    definition = replace_pieces.read(ob.data)
    taken = {number for group in groups for number in group}
    rest = [i for i in range(len(definition.pieces)) if i not in taken]
    if not rest:
        rest, *groups = groups
    if not groups:
        raise Refusal("that is all of it already: there is nothing to separate it from")
    made = [_copy_of(ob) for _ in groups]
    for copy, group in zip([*made, ob], [*groups, rest]):
        before = replace_pieces.read(copy.data)
        replace_pieces.put(copy.data, before, verbs.kept(before, group))
    return made


def _copy_of(ob):
    copy = ob.copy()
    copy.data = ob.data.copy()
    for collection in ob.users_collection:
        collection.objects.link(copy)
    return copy
