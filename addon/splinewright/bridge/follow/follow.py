"""Shapes that follow an object: which they are, in which order, and how they are brought up to date."""

import functools
import heapq
import math

import bpy
import numpy as np
from mathutils import Matrix

from ...core.base.failures import Refusal, text_of
from ...core.base.library import sc
from ...core.recipes.table import FOLLOW
from ...core.shape import definition as definitions
from ..curve import handles
from ..data import held, problems, store
from ..data.file_state import block_of, key, state
from ..keys import point_keys
from ..recipes import causes, late, placing, recipes
from ..shape import shape
from . import recipe_results


#: What objects are called that recipes make whose label says what is done.
_CALLED = {'follow': "Exact", 'of_mesh': "NURBS"}


class Cycle(Refusal):
    """A shape would follow itself."""


def scan():
    """Find all followers of the file."""
    state.causes = None
    state.followers.clear()
    state.owners.clear()
    state.doubtful |= problems.told_of(problems.FOLLOWING)
    problems.forget(problems.FOLLOWING)
    problems.forget(problems.INPUTS)
    _add(data for blocks in (bpy.data.meshes, bpy.data.curves) for data in blocks)


def _add(blocks):
    """Keep those that are followers in mind. In older files nothing watches what they follow."""
    for data in blocks:
        if _is_live(data) and key(data) not in state.followers:
            state.followers.add(key(data))
            state.causes = None
            recipes.watch(data)
            if late.has_mark(data) and not late.is_late(data) and late.take_back(data):
                state.doubtful.add(key(data))


def _is_live(data):
    """Whether a data-block is to follow. Linked data cannot be written."""
    return recipes.follows(data) and not data.library


def new_object(recipe, values, sources, resolution, depsgraph, frames=(), result=None):
    """A new object, not linked to a scene, that a recipe makes from objects; it lies in first_space(), and moves freely.

    frames: as of recipes.Stored; result: of recipe_results.result() in that space, where that is known. Raises Refusal or an
    error of the library if it cannot be made.
    """
    first, space = next(iter(sources), None), first_space(sources, depsgraph)
    result = result or recipe_results.result(recipe, values, sources, space, frames)
    made = _CALLED.get(recipe.kind, recipe.label)
    data = shape.new_data(f"{first.name} {made}" if first else made, definitions.to_value(result.definition), resolution)
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = Matrix(space.matrix)
    _write(data, recipe, values, sources, result, frames)
    placing.start(data, space, None, (*sources, *frames))
    return ob


def first_space(sources, depsgraph):
    """The placing.Space of a new shape that is made from objects: where the first one lies, without its scale, or the
    world's."""
    return placing.beside(next(iter(sources), None), depsgraph)


def attach(ob, source, depsgraph):
    """Make a shape follow another object from now on, in place of its points.

    Raises Cycle if that follows the shape itself, ValueError if it cannot be followed.
    """
    if not shape.has_shape(ob):
        raise Refusal(f"{ob.name} is no Splinewright shape: it cannot follow anything")
    require_no_cycle(ob.data, source)
    shape.require_writable(ob.data)
    space = placing.of_object(ob, depsgraph)
    result = recipe_results.result(FOLLOW, {}, [source], space)
    point_keys.tell_lost(ob.data, point_keys.count(ob.data))
    point_keys.remove(ob.data)
    shape.set_definition(ob.data, result.definition)
    held.write(ob.data, ())
    handles.write(ob.data, ())
    _write(ob.data, FOLLOW, {}, [source], result)
    placing.start(ob.data, space, ob, [source])


def let_move_freely(data, is_free, depsgraph):
    """Whether a shape that is made from objects is to be moved without them, or to stay on them. Raises as set_parameters()."""
    stored = recipes.read(data)
    if not stored or not recipes.follows(data):
        raise Refusal(f"{data.name} is not made from objects: it moves freely")
    if is_free == placing.moves_freely(data):
        return
    if is_free:
        owner, inputs = _in_space(data, stored, depsgraph)
        placing.start(data, placing.of_object(owner, depsgraph), owner, inputs)
    else:
        placing.stop(data)
        _make_anew(data, stored, depsgraph)


def set_parameters(data, changes, depsgraph):
    """Change parameters of a shape that is made from objects, by name. Raises, and changes nothing, if it cannot be made."""
    stored = recipes.read(data)
    _make_anew(data, stored._replace(values={**stored.values, **changes}), depsgraph)


def set_frame(data, frame, depsgraph, changes=()):
    """Give a shape that is made from objects another one of which the place and axes count, or none, and other parameters by
    name. Raises as set_parameters()."""
    stored = recipes.read(data)
    if not stored or not stored.recipe.frame:
        raise Refusal(f"{data.name} has no axis that an object could give")
    if frame is not None:
        require_no_cycle(data, frame)
    frames = (frame,) if frame is not None else ()
    _make_anew(data, stored._replace(values={**stored.values, **dict(changes)}, frames=frames), depsgraph)


def set_inputs(data, sources, turned, depsgraph):
    """Make a shape from other objects than now, or in another order, each turned or not. Raises as set_parameters()."""
    stored = recipes.read(data)
    if not stored or not stored.recipe.has_more:
        raise Refusal(f"{data.name} is not made from any number of objects")
    if not stored.recipe.takes(len(sources)):
        raise Refusal(f"it is made from {stored.recipe.wanted}")
    for source in sources:
        if source is not None:
            require_no_cycle(data, source)
    _make_anew(data, stored._replace(sources=tuple(sources), turned=tuple(turned)), depsgraph)


def _make_anew(data, wanted, depsgraph):
    owner, inputs = _in_space(data, wanted, depsgraph)
    space = placing.kept_up(data, owner, inputs, depsgraph)
    result = recipe_results.result(wanted.recipe, wanted.values, wanted.sources, space, wanted.frames, wanted.turned)
    shape.set_definition(data, result.definition)
    is_free = placing.moves_freely(data)
    recipes.write_derived(data, wanted.recipe, wanted.values, wanted.sources, result, wanted.frames, wanted.turned)
    late.is_done(data)
    if is_free:
        placing.start(data, space, owner, inputs)
    problems.set_problem(data, problems.FOLLOWING, "")


def take_along(data, matrix, depsgraph):
    """Make a shape again whose mesh or curve was moved by an affine matrix (4, 4), as its object was by the inverse: one that
    moves freely keeps that. Raises as set_parameters()."""
    stored = recipes.read(data)
    owner, inputs = _in_space(data, stored, depsgraph)
    if placing.moves_freely(data):
        placing.start(data, placing.applied(data, matrix, inputs, depsgraph), owner, inputs)
    _make_anew(data, stored, depsgraph)


def _in_space(data, wanted, depsgraph):
    """The object in whose space a follower lies, and the objects that it is made from. Raises Refusal where one is gone."""
    state.owners.pop(key(data), None)
    owner, inputs = _owner_of(data, _Turn(depsgraph)), (*wanted.sources, *wanted.frames)
    if None in inputs:
        raise Refusal(f"{_missing(data, _in_use()) or 'an object it is made from was deleted'}: it stays as it was last")
    if owner is None:
        raise Refusal("it is in no scene: it stays as it was last")
    return owner, inputs


def _write(data, recipe, values, sources, result, frames=()):
    recipes.write_derived(data, recipe, values, sources, result, frames)
    state.followers.add(key(data))
    state.causes = None


def require_no_cycle(data, source):
    """Raises Cycle if `source` shows `data`, or is made from what does."""
    waiting, seen = [source], set()
    while waiting:
        ob = waiting.pop()
        if ob.data == data:
            raise Cycle(f"{ob.name} would follow itself")
        if key(ob) not in seen and ob.data and recipes.follows(ob.data):
            waiting += recipes.all_pointers(ob.data)
        seen.add(key(ob))


def refresh(changed, depsgraph, budget=None):
    """Bring the followers of changed blocks up to date, inputs before what follows them. budget: a late.Budget by which some are
    put off."""
    _note(changed)
    if not state.followers:
        return
    turn = _Turn(depsgraph, None if state.doubtful else budget)
    changed = {*changed, *filter(None, map(block_of, state.doubtful))}
    state.doubtful = set()
    blocks = {*changed, *(block.data for block in changed if isinstance(block, bpy.types.Object) and block.data)}
    done, index = set(), None
    while index is None or index is not state.causes:           # one had other causes than were known
        index = _index()
        _update_by(index, blocks, changed, turn, done)


def _update_by(index, blocks, changed, turn, done):
    """Update what blocks are causes of, and what follows that, as far as an index turns out to be right."""
    waiting = sorted({number for block in blocks for number in index.followers_of(block)})
    while waiting and index is state.causes:
        number = heapq.heappop(waiting)
        data = None if index.order[number] in done else _follower(index, number)
        if data is None:
            continue
        done.add(key(data))
        due = blocks.intersection(causes.of(data))
        is_own = due == {data}
        if due and _update(data, turn, is_own and data not in changed, is_own):
            blocks.add(data)
            for follower in index.followers_of(data):
                if follower > number and follower not in waiting:
                    heapq.heappush(waiting, follower)


def _index():
    """The causes.Index of all followers. Those of a circle are told so."""
    if state.causes is None:
        state.causes = causes.Index(_blocks())
        for data in state.causes.stuck:
            problems.set_problem(data, problems.FOLLOWING, "It follows itself, in a circle: it stays as it was last")
        state.causes.stuck = []
    return state.causes


def look_again(data):
    """A data-block changed, but for its geometry: a follower may follow others now."""
    if state.causes is not None and not state.causes.knows_all(data):
        state.causes = None


def _follower(index, number):
    """The follower of a number; None, and another index is to be made, where it is not as it was."""
    data = block_of(index.order[number])
    if data is not None and _is_live(data) and index.knows(number, data):
        return data
    if data is None or not _is_live(data):
        scan()                          # it was renamed or removed
    state.causes = None
    return None


def _note(blocks):
    """Changed blocks may be followers that are new to the file, or objects in whose space one lies."""
    _add(block for block in blocks if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)))
    for block in blocks:
        if isinstance(block, bpy.types.Object) and block.data and state.owners.get(key(block.data), block) is None:
            del state.owners[key(block.data)]


def refresh_all(changed, depsgraph):
    """Bring every follower up to date that a depsgraph shows: another frame, another file."""
    _note(changed)
    turn, state.doubtful, state.causes = _Turn(depsgraph), set(), None
    take_late()
    for data in list(map(block_of, _index().order)):
        _update(data, turn)
        if depsgraph.mode == 'VIEWPORT' and recipes.watch(data):
            state.doubtful.add(key(data))           # its driver was taken away: now Blender evaluates what it needs


def finish(blocks, depsgraph):
    """Bring late.blocks() up to date, and what follows them."""
    refresh(_taken(blocks), depsgraph)


def take_late():
    """The followers that are late, which are to be brought up to date now."""
    return _taken(late.blocks()) if state.late else set()


def _taken(blocks):
    if None in blocks:
        scan()                          # by its mark one that was renamed is found
    found = set(filter(None, blocks))
    for data in found:
        state.late.pop(key(data), None)
    return found


def problem(data):
    """Why a follower does not follow, or ""."""
    if not recipes.follows(data):
        return ""
    if data.library:
        return "It is linked from another file: it is shown as that was saved. Bake Animation there makes it move here"
    try:
        recipes.read(data)
    except store.UnreadableDefinition as error:
        return str(error)
    missing = _missing(data, _in_use())
    if missing:
        return f"{missing}: it stays as it was last"
    return problems.of(data, problems.FOLLOWING)


def look_for_inputs():
    """Find out which followers miss an object that they are made from."""
    in_use = _in_use()
    for data in _blocks():
        problems.set_problem(data, problems.INPUTS, _missing(data, in_use))


def stopped():
    """{data-block: why} of the followers that do not follow, as far as it was found out."""
    blocks = filter(None, map(block_of, sorted(problems.told_of(problems.INPUTS, problems.FOLLOWING))))
    return {data: problems.of(data, problems.INPUTS) or problems.of(data, problems.FOLLOWING) for data in blocks
            if recipes.follows(data)}


def _missing(data, in_use):
    """Which objects that a follower is made from are gone, in words, or ""."""
    gone = [_in_words(name, ob) for name, ob in recipes.pointed_by_name(data) if ob not in in_use]
    if not gone:
        return ""
    named = " and ".join(filter(None, (", ".join(gone[:-1]), gone[-1])))
    return f"{named} {'was' if len(gone) == 1 else 'were'} deleted, or {'is' if len(gone) == 1 else 'are'} in no scene"


_KINDS = {'CURVE': "the curve", 'SURFACE': "the surface", 'MESH': "the surface", 'EMPTY': "the point", 'FONT': "the text"}


def _in_words(name, ob):
    kind = _KINDS.get(ob.type, "the object") if ob else "the object"
    return f"{kind} '{name}'" if name else "an object"


class _Turn:
    """One go of bringing followers up to date."""

    def __init__(self, depsgraph, budget=None):
        self.depsgraph, self.budget = depsgraph, budget

    @functools.cached_property
    def in_use(self):
        return _in_use()

    def shows(self, ob):
        """As shape.is_shown()."""
        return shape.is_shown(ob, self.depsgraph)


def _in_use():
    """The objects that were not deleted: those in a scene, or in a collection, which may be instanced."""
    collections = (*bpy.data.collections, *(scene.collection for scene in bpy.data.scenes))
    return {ob for collection in collections for ob in collection.objects}


def _owner_of(data, turn):
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


def _update(data, turn, is_alone=False, is_own=False):
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
        if not is_same and turn.budget and not turn.budget.allows(data):
            if not (is_own and known is None and _is_untouched(data)):
                late.put_off(data)
            return False
        is_new = not is_same and _make(data, stored, space, turn.budget)
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
    owner = _owner_of(data, turn)
    if owner is None:
        return None, None
    stored = recipes.read(data)
    pointed = *stored.sources, *stored.frames
    if not turn.in_use.issuperset(pointed) or not all(map(turn.shows, pointed)):
        return None, None
    for source, was_shape in zip(stored.sources, stored.were_shapes):
        if was_shape and not shape.has_shape(source):
            raise Refusal(f"{source.name} is not a Splinewright shape any more: it stays as it was last")
    return stored, placing.kept_up(data, owner, pointed, turn.depsgraph)


def _make(data, stored, space, budget):
    """Whether a follower is another after it was made again. Raises FAILURES, and Cancelled where that takes more than a budget."""
    start = late.clock()
    make = recipe_results.work(stored.recipe, stored.values, stored.sources, space, stored.frames, stored.turned)
    result = make(budget.is_over if budget else None)
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
    return sentence if len(pointed) != 1 or pointed[0][0] in sentence else f"{pointed[0][0]}: {sentence}"


def _same(a, b):
    if a is None or a.form != b.form or len(a.pieces) != len(b.pieces) or not np.array_equal(a.pool, b.pool):
        return False
    return all(p.kind == q.kind and p.degree == q.degree and p.periodic == q.periodic
               and np.array_equal(p.indices, q.indices) and all(map(np.array_equal, p.knots, q.knots))
               for p, q in zip(a.pieces, b.pieces))


def followers_of(ob):
    """The data-blocks that are made from an object, or go where it is."""
    return [data for blocks in (bpy.data.meshes, bpy.data.curves) for data in blocks if recipes.is_from(data, {ob})]


def links():
    """Pairs of a follower and an object that it follows, of those that are shown."""
    turn = _Turn(None)
    return [(data, source) for data in _blocks() if _owner_of(data, turn) for source in recipes.all_pointers(data)]


def _blocks():
    blocks = [block_of(name) for name in sorted(state.followers)]
    if all(data is not None and _is_live(data) for data in blocks):
        return blocks
    scan()                              # one was renamed or removed
    return [block_of(name) for name in sorted(state.followers)]
