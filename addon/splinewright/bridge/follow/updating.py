"""One follower brought up to date: whether it is to be, what from, and with what result."""

import functools
import math
from typing import NamedTuple

import bpy
import numpy as np

from ...core.base.failures import Refusal, text_of
from ...core.base.library import sc
from ...core.base.words import phrase
from ..data import problems, store
from ..data.file_state import block_of, key, state
from ..recipes import late, placing, recipes
from ..shape import shape
from . import recipe_results


class Made(NamedTuple):
    """What was made for a follower beside Blender."""

    made_of: tuple                      # as of recipe_results.made_of()
    result: object                      # a Result, or the exception that was raised
    seconds: float                      # how long that took


class Turn:
    """One turn of bringing followers up to date. budget: a late.Budget, or None; made: the Made of followers, by their keys;
    doubtful: keys of those that may not show what they should."""

    def __init__(self, depsgraph, budget=None, made=None, doubtful=frozenset()):
        self.depsgraph, self.budget, self._made, self._doubtful = depsgraph, budget, made or {}, doubtful

    def is_doubtful(self, data):
        return key(data) in self._doubtful

    def made(self, data, made_of):
        """The Made for a follower, or None where it is to be made from something else now."""
        found = self._made.get(key(data))
        return found if found is not None and found.made_of == made_of else None

    @functools.cached_property
    def in_use(self):
        return in_use()

    def shows(self, ob):
        """As shape.is_shown()."""
        return shape.is_shown(ob, self.depsgraph)


def in_use():
    """The objects that were not deleted: those in a scene, or in a collection, which may be instanced."""
    collections = (*bpy.data.collections, *(scene.collection for scene in bpy.data.scenes))
    return {ob for collection in collections for ob in collection.objects}


def owner_of(data, turn):
    """The object in whose space a follower lies: the first by name that is in use, or None. That is kept until an
    object is reported that could be it: to look for one costs as much as the file has objects."""
    name = key(data)
    if name in state.owners:
        known = state.owners[name]
        owner = block_of(known) if known else None
        if known is None or owner is not None and owner.data == data and owner in turn.in_use:
            return owner
    users = (ob for ob in bpy.data.objects if ob.data == data and ob in turn.in_use)
    owner = min(users, key=lambda ob: ob.name, default=None)
    state.owners[name] = key(owner) if owner else None
    return owner


def update(data, turn, is_alone=False, is_own=False):
    """Whether the follower changed. Whatever goes wrong is kept in words: others are to be brought up to date, too.

    is_alone: whether nothing but the place of its object is another. is_own: whether nothing that it is made from is.
    """
    try:
        known, (stored, space) = state.made.get(key(data)), _ready(data, turn)
        if stored is None:
            state.made.pop(key(data), None)     # meanwhile what it is made from may change
            return False
        if is_alone and placing.moves_freely(data):
            return False
        is_all, made_of = recipe_results.made_of(stored, space)
        is_same = (is_all or is_own and not late.has_mark(data)) and known == (made_of, store.digest(data)) and not shape.is_touched(data)
        made = None if is_same else turn.made(data, made_of)
        if not is_same and made is None and turn.budget and not turn.budget.allows(data):
            if turn.is_doubtful(data) or not (is_own and known is None and _is_untouched(data)):
                late.put_off(data)
            return False
        is_new = not is_same and _write(data, made or _made_now(stored, space, turn.budget, made_of))
        late.is_done(data)
        problems.set_problem(data, problems.FOLLOWING, "")
        state.made[key(data)] = made_of, store.digest(data)
        return is_new
    except sc.Cancelled:
        late.note(data, math.inf)
        late.put_off(data)
        return False
    except Exception as error:
        late.is_done(data)
        state.made.pop(key(data), None)
        problems.set_problem(data, problems.FOLLOWING, _naming_input(data, text_of(error)))
        return False


def _ready(data, turn):
    """(the recipes.Stored of a follower, its placing.Space); None for both where it is not to be brought up to date. Raises Refusal
    and UnreadableDefinition."""
    owner = owner_of(data, turn)
    if owner is None:
        return None, None
    stored = recipes.read(data)
    pointed = *stored.sources, *stored.frames
    if not turn.in_use.issuperset(pointed) or not all(map(turn.shows, pointed)):
        return None, None
    for source, was_shape in zip(stored.sources, stored.were_shapes):
        if was_shape and not shape.has_shape(source):
            raise Refusal("{name} is not a Splinewright shape any more: it stays as it was last", name=source.name)
    return stored, placing.kept_up(data, owner, pointed, turn.depsgraph)


def task_of(data, depsgraph):
    """(what a follower is made of, a function that makes it for a `cancel` as the library takes it and reads nothing of Blender's);
    None where it is not to be brought up to date. Raises Refusal and UnreadableDefinition."""
    stored, space = _ready(data, Turn(depsgraph))
    return None if stored is None else (recipe_results.made_of(stored, space)[1], _work(stored, space))


def _work(stored, space):
    return recipe_results.work(stored.recipe, stored.values, stored.sources, space, stored.frames, stored.turned)


def _made_now(stored, space, budget, made_of):
    """Raises FAILURES, and Cancelled where that takes more than a budget."""
    start = late.clock()
    result = _work(stored, space)(budget.is_over if budget else None)
    return Made(made_of, result, late.clock() - start)


def _write(data, made):
    """Whether a follower is another after it shows a Made. Raises FAILURES."""
    if isinstance(made.result, Exception):
        raise made.result
    start, result = late.clock() - made.seconds, made.result
    recipes.keep_names(data)
    is_new = not _same(store.read(data), result.definition) or shape.is_touched(data)
    if is_new:
        shape.set_definition(data, result.definition)
        recipes.write_achieved(data, result)
    late.note(data, late.clock() - start)
    return is_new


def _is_untouched(data):
    """Whether a follower of which nothing else is known shows what it was made of: its own place does not count, nor did others
    change it."""
    return placing.moves_freely(data) and not late.is_late(data) and not shape.is_touched(data)


def _naming_input(data, sentence):
    """A sentence with the name of the one object that a follower is made from, where it lacks that."""
    pointed = recipes.pointed_by_name(data)
    return sentence if len(pointed) != 1 or pointed[0][0] in sentence else phrase("{name}: {sentence}", name=pointed[0][0], sentence=sentence)


def _same(a, b):
    if a is None or a.form != b.form or len(a.pieces) != len(b.pieces) or not np.array_equal(a.pool, b.pool):
        return False
    return all(p.kind == q.kind and p.degree == q.degree and p.periodic == q.periodic
               and np.array_equal(p.indices, q.indices) and all(map(np.array_equal, p.knots, q.knots))
               for p, q in zip(a.pieces, b.pieces))
