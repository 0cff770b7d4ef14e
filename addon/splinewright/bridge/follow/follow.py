"""Shapes that follow an object: which they are, in which order, and how they are brought up to date."""

import heapq

import bpy
from mathutils import Matrix

from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.recipes.table import FOLLOW
from ..curve import curve_layers, handles
from ..data import held, problems, store
from ..data.file_state import block_of, key, state
from ..keys import point_keys
from ..recipes import causes, late, placing, recipes
from ..shape import shape
from . import recipe_results, updating


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
    data = shape.new_data(f"{first.name} {made}" if first else made, result.definition, resolution)
    curve_layers.thicken(data, recipe.thickness)
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
        raise Refusal("{name} is no Splinewright shape: it cannot follow anything", name=ob.name)
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
        raise Refusal("{name} is not made from objects: it moves freely", name=data.name)
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
        raise Refusal("{name} has no axis that an object could give", name=data.name)
    if frame is not None:
        require_no_cycle(data, frame)
    frames = (frame,) if frame is not None else ()
    _make_anew(data, stored._replace(values={**stored.values, **dict(changes)}, frames=frames), depsgraph)


def set_inputs(data, sources, turned, depsgraph):
    """Make a shape from other objects than now, or in another order, each turned or not. Raises as set_parameters()."""
    stored = recipes.read(data)
    if not stored or not stored.recipe.has_more:
        raise Refusal("{name} is not made from any number of objects", name=data.name)
    if not stored.recipe.takes(len(sources)):
        raise Refusal("it is made from {wanted}", wanted=phrase(stored.recipe.wanted))
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
    owner, inputs = updating.owner_of(data, updating.Turn(depsgraph)), (*wanted.sources, *wanted.frames)
    if None in inputs:
        raise Refusal("{missing}: it stays as it was last",
                      missing=_missing(data, updating.in_use()) or "an object it is made from was deleted")
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
            raise Cycle("{name} would follow itself", name=ob.name)
        if key(ob) not in seen and ob.data and recipes.follows(ob.data):
            waiting += recipes.all_pointers(ob.data)
        seen.add(key(ob))


def refresh(changed, depsgraph, budget=None, made=None):
    """Bring the followers of changed blocks up to date, inputs before what follows them. budget: a late.Budget by which some are
    put off; made: updating.Made of some, by their keys."""
    _note(changed)
    if not state.followers:
        return
    turn = updating.Turn(depsgraph, budget, made, state.doubtful)
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
        name = index.order[number]
        if turn.budget and turn.budget.is_over() and late.put_off_again(name):
            continue
        data = None if name in done else _follower(index, number)
        if data is None:
            continue
        done.add(key(data))
        due = blocks.intersection(causes.of(data))
        is_own = due == {data}
        if due and updating.update(data, turn, is_own and data not in changed, is_own):
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
    turn, state.doubtful, state.causes = updating.Turn(depsgraph), set(), None
    take_late()
    for data in list(map(block_of, _index().order)):
        updating.update(data, turn)
        if depsgraph.mode == 'VIEWPORT' and recipes.watch(data):
            state.doubtful.add(key(data))           # its driver was taken away: now Blender evaluates what it needs


def finish(blocks, depsgraph, budget=None, made=None):
    """Bring late.blocks() up to date, and what follows them; budget and made as of refresh()."""
    refresh(_taken(blocks), depsgraph, budget, made)


def in_order(blocks):
    """Followers, each after what it follows."""
    numbers = {name: number for number, name in enumerate(_index().order)}
    return sorted(blocks, key=lambda data: numbers.get(key(data), -1))


def take_late():
    """The followers that are late, which are to be brought up to date now."""
    return _taken(late.blocks()) if state.late else set()


def _taken(blocks):
    if None in blocks:
        late.forget_lost()
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
    missing = _missing(data, updating.in_use())
    if missing:
        return phrase("{missing}: it stays as it was last", missing=missing)
    return problems.of(data, problems.FOLLOWING)


def look_for_inputs():
    """Find out which followers miss an object that they are made from."""
    in_use = updating.in_use()
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
    return phrase("{named} were deleted, or are in no scene" if len(gone) > 1 else "{named} was deleted, or is in no scene", named=named)


_KINDS = {'CURVE': "the curve", 'SURFACE': "the surface", 'MESH': "the surface", 'EMPTY': "the point", 'FONT': "the text"}


def _in_words(name, ob):
    kind = _KINDS.get(ob.type, "the object") if ob else "the object"
    return f"{kind} '{name}'" if name else "an object"


def followers_of(ob):
    """The data-blocks that are made from an object, or go where it is."""
    return [data for blocks in (bpy.data.meshes, bpy.data.curves) for data in blocks if recipes.is_from(data, {ob})]


def links():
    """Pairs of a follower and an object that it follows, of those that are shown."""
    turn = updating.Turn(None)
    return [(data, source) for data in _blocks() if updating.owner_of(data, turn) for source in recipes.all_pointers(data)]


def _blocks():
    blocks = [block_of(name) for name in sorted(state.followers)]
    if all(data is not None and _is_live(data) for data in blocks):
        return blocks
    scan()                              # one was renamed or removed
    return [block_of(name) for name in sorted(state.followers)]
