"""Shapes that follow an object: which they are, in which order, and how they are brought up to date."""

import contextlib
import graphlib

import bpy
import numpy as np

from ..core import definition as definitions
from ..core.failures import FAILURES, sentence
from ..core.recipes.table import FOLLOW
from . import derived, recipes, shape, store

#: (is it a curve, name) of data-blocks that follow something. Only a hint: scan() makes it anew.
known = set()
#: Why a follower is not up to date, by the same keys.
problems = {}
_owners = {}


class Cycle(ValueError):
    """A shape would follow itself."""


def scan():
    """Find all followers of the file."""
    known.clear()
    problems.clear()
    _owners.clear()
    for blocks in (bpy.data.meshes, bpy.data.curves):
        known.update(_key(data) for data in blocks if recipes.follows(data))


def new_object(recipe, values, sources, resolution, depsgraph):
    """A new object, not linked to a scene, that a recipe makes from objects; it lies where the first one lies.

    Raises ValueError or ArithmeticError if it cannot be made.
    """
    made = derived.made(recipe, values, sources, sources[0], depsgraph)
    name = f"{sources[0].name} {recipe.label if recipe.parameters else 'Exact'}"
    data = shape.new_data(name, definitions.to_value(made.definition), resolution)
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = sources[0].matrix_world
    _write(data, recipe, values, sources, made.error)
    return ob


def attach(ob, source, depsgraph):
    """Make a shape follow another object from now on, in place of its own points.

    Raises Cycle if that follows the shape itself, ValueError if it cannot be followed.
    """
    if not shape.has_shape(ob):
        raise ValueError(f"{ob.name} is no Splinewright shape: it cannot follow anything")
    require_no_cycle(ob.data, source)
    shape.require_writable(ob.data)
    made = derived.made(FOLLOW, {}, [source], ob, depsgraph)
    shape.set_definition(ob.data, made.definition)
    _write(ob.data, FOLLOW, {}, [source], made.error)


def set_parameter(data, name, value, depsgraph):
    """Change one number or text of what is made from objects. Raises, and changes nothing, where nothing comes of it."""
    owner, sources = owner_of(data), recipes.read_inputs(data)
    if owner is None or None in sources:
        raise ValueError("an object it is made from was deleted: it stays as it was last")
    recipe, values = recipes.of(data), {**recipes.parameters(data), name: value}
    made = derived.made(recipe, values, sources, owner, depsgraph)
    shape.set_definition(data, made.definition)
    recipes.write_derived(data, recipe, values, sources, made.error)


def _write(data, recipe, values, sources, error):
    recipes.write_derived(data, recipe, values, sources, error)
    known.add(_key(data))


def require_no_cycle(data, source):
    """Raises Cycle if `source` shows `data`, or is made from what does."""
    waiting, seen = [source], set()
    while waiting:
        ob = waiting.pop()
        if ob.data == data:
            raise Cycle(f"{ob.name} would follow itself")
        if ob.name not in seen and ob.data:
            waiting += _inputs(ob.data)
        seen.add(ob.name)


def refresh(changed, depsgraph):
    """Bring the followers of changed blocks up to date, inputs before what follows them."""
    _note(changed)
    if not known:
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
            known.add(_key(block))


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
    if not all(source is not None and source.users_scene for source in recipes.read_inputs(data)):
        return "The object it follows was deleted, or is in no scene: it stays as it was last"
    return problems.get(_key(data), "")


def owner_of(data):
    """The object in whose space a follower lies: the first by name that is in a scene, or None."""
    hint = bpy.data.objects.get(_owners.get(_key(data), ""))
    if hint is None or hint.data != data or not hint.users_scene:
        hint = _find_owner(data)
        _owners[_key(data)] = hint.name if hint else ""
    return hint


def _find_owner(data):
    users = [ob for ob in bpy.data.user_map(subset={data})[data]
             if isinstance(ob, bpy.types.Object) and ob.data == data and ob.users_scene]
    return min(users, key=lambda ob: ob.name) if users else None


def _update(data, owner, sources, depsgraph):
    """Whether the follower changed."""
    key = _key(data)
    try:
        if not all(source.users_scene for source in sources):
            return False
        for i, source in enumerate(sources):
            if recipes.was_shape(data, i) and not shape.has_shape(source):
                raise ValueError(f"{source.name} is no Splinewright shape any more: it stays as it was last")
        made = derived.made(recipes.of(data), recipes.parameters(data), sources, owner, depsgraph)
        definition = made.definition
        problems.pop(key, None)
        if _same(store.read(data), definition) and not shape.is_touched(data):
            return False
        shape.set_definition(data, definition)
        recipes.write_error(data, made.error)
        return True
    except FAILURES as error:
        problems[key] = sentence(error)
        return False


def _same(a, b):
    if a is None or a.form != b.form or len(a.pieces) != len(b.pieces) or not np.array_equal(a.pool, b.pool):
        return False
    return all(p.kind == q.kind and p.degree == q.degree and p.periodic == q.periodic
               and np.array_equal(p.indices, q.indices) and all(map(np.array_equal, p.knots, q.knots))
               for p, q in zip(a.pieces, b.pieces))


def _in_order():
    """The followers, each after the shape that it follows. Those of a cycle are left out."""
    blocks = {_key(data): data for data in _blocks()}
    sorter = graphlib.TopologicalSorter(
        {key: {_key(source.data) for source in _inputs(data) if source.data} for key, data in blocks.items()})
    with contextlib.suppress(graphlib.CycleError):
        sorter.prepare()
    order = []
    while sorter.is_active():
        ready = sorter.get_ready()
        order += [blocks.pop(key) for key in sorted(ready) if key in blocks]
        sorter.done(*ready)
    for key in blocks:
        problems[key] = "It follows itself, in a circle: it stays as it was last"
    return order


def _blocks():
    blocks = [_block(key) for key in sorted(known)]
    if all(data is not None and recipes.follows(data) for data in blocks):
        return blocks
    scan()                              # one was renamed or removed
    return [_block(key) for key in sorted(known)]


def _inputs(data):
    """The objects that a shape is made from; [] where it is made from none, or one is missing or unknown."""
    try:
        sources = recipes.read_inputs(data)
    except store.UnreadableDefinition as error:
        problems[_key(data)] = str(error)
        return []
    return [] if None in sources else sources


def _key(data):
    return isinstance(data, bpy.types.Curve), data.name


def _block(key):
    is_curve, name = key
    return (bpy.data.curves if is_curve else bpy.data.meshes).get(name)
