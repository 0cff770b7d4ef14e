"""Shapes that follow an object: which they are, in which order, and how they are brought up to date."""

import contextlib
import graphlib

import bpy
import numpy as np

from ..core import definition as definitions
from ..core.failures import Refusal, told
from ..core.recipes.table import FOLLOW
from . import derived, problems, recipes, shape, store
from .file_state import block_of, key, state


class Cycle(Refusal):
    """A shape would follow itself."""


def scan():
    """Find all followers of the file."""
    state.followers.clear()
    state.owners.clear()
    problems.forget(problems.FOLLOWING)
    for blocks in (bpy.data.meshes, bpy.data.curves):
        state.followers.update(key(data) for data in blocks if recipes.follows(data))


def new_object(recipe, values, sources, resolution, depsgraph):
    """A new object, not linked to a scene, that a recipe makes from objects; it lies where the first one lies.

    Raises Refusal or an error of the library if it cannot be result.
    """
    result = derived.result(recipe, values, sources, sources[0], depsgraph)
    name = f"{sources[0].name} {recipe.label if recipe.parameters else 'Exact'}"
    data = shape.new_data(name, definitions.to_value(result.definition), resolution)
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = sources[0].matrix_world
    _write(data, recipe, values, sources, result.error)
    return ob


def attach(ob, source, depsgraph):
    """Make a shape follow another object from now on, in place of its own points.

    Raises Cycle if that follows the shape itself, ValueError if it cannot be followed.
    """
    if not shape.has_shape(ob):
        raise Refusal(f"{ob.name} is no Splinewright shape: it cannot follow anything")
    require_no_cycle(ob.data, source)
    shape.require_writable(ob.data)
    result = derived.result(FOLLOW, {}, [source], ob, depsgraph)
    shape.set_definition(ob.data, result.definition)
    _write(ob.data, FOLLOW, {}, [source], result.error)


def set_parameter(data, name, value, depsgraph):
    """Change one number or text of what is made from objects. Raises, and changes nothing, where nothing comes of it."""
    owner, sources = owner_of(data), recipes.read_inputs(data)
    if owner is None or None in sources:
        raise Refusal("an object it is made from was deleted: it stays as it was last")
    stored = recipes.read(data)
    recipe, values = stored.recipe, {**stored.values, name: value}
    result = derived.result(recipe, values, sources, owner, depsgraph)
    shape.set_definition(data, result.definition)
    recipes.write_derived(data, recipe, values, sources, result.error)


def _write(data, recipe, values, sources, error):
    recipes.write_derived(data, recipe, values, sources, error)
    state.followers.add(key(data))


def require_no_cycle(data, source):
    """Raises Cycle if `source` shows `data`, or is made from what does."""
    waiting, seen = [source], set()
    while waiting:
        ob = waiting.pop()
        if ob.data == data:
            raise Cycle(f"{ob.name} would follow itself")
        if key(ob) not in seen and ob.data:
            waiting += _inputs(ob.data)
        seen.add(key(ob))


def refresh(changed, depsgraph):
    """Bring the followers of changed blocks up to date, inputs before what follows them."""
    _note(changed)
    if not state.followers:
        return
    changed = set(changed)
    for data in _in_order():
        sources, owner = _inputs(data), owner_of(data)
        if not sources or owner is None:
            continue
        causes = {owner, *(cause for source in sources for cause in _causes(source))}
        if not changed.isdisjoint(causes) and _update(data, owner, sources, depsgraph):
            changed.add(data)


def _causes(source):
    return source, source.data, getattr(source.data, 'shape_keys', None)


def _note(blocks):
    """Add the followers among changed blocks, which may be new to the file."""
    for block in blocks:
        if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)) and recipes.follows(block):
            state.followers.add(key(block))


def refresh_all(depsgraph):
    """Bring every follower up to date: another frame, another file."""
    for data in _in_order():
        sources, owner = _inputs(data), owner_of(data)
        if sources and owner is not None:
            _update(data, owner, sources, depsgraph)


def problem(data):
    """Why a follower does not follow, or ""."""
    if not recipes.follows(data):
        return ""
    try:
        sources = recipes.read_inputs(data)
    except store.UnreadableDefinition as error:
        return str(error)
    if not all(source is not None and source.users_scene for source in sources):
        return "The object it follows was deleted, or is in no scene: it stays as it was last"
    return problems.of(data, problems.FOLLOWING)


def owner_of(data):
    """The object in whose space a follower lies: the first by name that is in a scene, or None."""
    known = state.owners.get(key(data))
    hint = block_of(known) if known else None
    if hint is None or hint.data != data or not hint.users_scene:
        hint = _find_owner(data)
        state.owners[key(data)] = key(hint) if hint else None
    return hint


def _find_owner(data):
    users = [ob for ob in bpy.data.user_map(subset={data})[data]
             if isinstance(ob, bpy.types.Object) and ob.data == data and ob.users_scene]
    return min(users, key=lambda ob: ob.name) if users else None


def _update(data, owner, sources, depsgraph):
    """Whether the follower changed. Whatever goes wrong is kept in words: others are to be brought up to date, too."""
    try:
        if not all(source.users_scene for source in sources):
            return False
        stored = recipes.read(data)
        for source, was_shape in zip(sources, stored.were_shapes):
            if was_shape and not shape.has_shape(source):
                raise Refusal(f"{source.name} is no Splinewright shape any more: it stays as it was last")
        result = derived.result(stored.recipe, stored.values, sources, owner, depsgraph)
        definition = result.definition
        problems.tell(data, problems.FOLLOWING, "")
        if _same(store.read(data), definition) and not shape.is_touched(data):
            return False
        shape.set_definition(data, definition)
        recipes.write_error(data, result.error)
        return True
    except Exception as error:
        problems.tell(data, problems.FOLLOWING, told(error))
        return False


def _same(a, b):
    if a is None or a.form != b.form or len(a.pieces) != len(b.pieces) or not np.array_equal(a.pool, b.pool):
        return False
    return all(p.kind == q.kind and p.degree == q.degree and p.periodic == q.periodic
               and np.array_equal(p.indices, q.indices) and all(map(np.array_equal, p.knots, q.knots))
               for p, q in zip(a.pieces, b.pieces))


def _in_order():
    """The followers, each after the shape that it follows. Those of a cycle are left out."""
    blocks = {key(data): data for data in _blocks()}
    sorter = graphlib.TopologicalSorter(
        {name: {key(source.data) for source in _inputs(data) if source.data} for name, data in blocks.items()})
    with contextlib.suppress(graphlib.CycleError):
        sorter.prepare()
    order = []
    while sorter.is_active():
        ready = sorter.get_ready()
        order += [blocks.pop(name) for name in sorted(ready) if name in blocks]
        sorter.done(*ready)
    for data in blocks.values():
        problems.tell(data, problems.FOLLOWING, "It follows itself, in a circle: it stays as it was last")
    return order


def _blocks():
    blocks = [block_of(name) for name in sorted(state.followers)]
    if all(data is not None and recipes.follows(data) for data in blocks):
        return blocks
    scan()                              # one was renamed or removed
    return [block_of(name) for name in sorted(state.followers)]


def _inputs(data):
    """The objects that a shape is made from; [] where it is made from none, or one is missing or unknown."""
    try:
        sources = recipes.read_inputs(data)
    except store.UnreadableDefinition as error:
        problems.tell(data, problems.FOLLOWING, str(error))
        return []
    return [] if None in sources else sources
