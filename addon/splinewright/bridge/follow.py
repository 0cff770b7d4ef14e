"""Shapes that follow an object: which they are, in which order, and how they are brought up to date."""

import bpy
import numpy as np

from ..core import definition as definitions
from ..core import transform
from ..core.failures import FAILURES, sentence
from . import recipes, shape, store
from .native import read_native

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


def new_follower(source, resolution, depsgraph):
    """A new object, not linked to a scene, that follows `source` and lies where it lies.

    Raises ValueError if it cannot be followed.
    """
    _require_followable(source)
    definition = _definition_of(source, depsgraph)
    data = shape.new_data(f"{source.name} Exact", definitions.to_value(definition), resolution)
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = source.matrix_world
    for material in source.data.materials:
        data.materials.append(material)
    _write(data, source)
    return ob


def attach(ob, source, depsgraph):
    """Make a shape follow another object from now on, in place of its own points.

    Raises Cycle if that follows the shape itself, ValueError if it cannot be followed.
    """
    _require_followable(source)
    if not shape.has_shape(ob):
        raise ValueError(f"{ob.name} is no Splinewright shape: it cannot follow anything")
    require_no_cycle(ob.data, source)
    shape.require_writable(ob.data)
    shape.set_definition(ob.data, current(ob, source, depsgraph))
    _write(ob.data, source)


def _require_followable(source):
    if not shape.has_shape(source) and source.type not in ('CURVE', 'SURFACE'):
        raise ValueError(f"{source.name} is no curve, surface or Splinewright shape")


def _write(data, source):
    recipes.write(data, source)
    known.add(_key(data))


def require_no_cycle(data, source):
    """Raises Cycle if `source` shows `data`, or follows what does."""
    seen = set()
    while source is not None and source.name not in seen:
        if source.data == data:
            raise Cycle(f"{source.name} would follow itself")
        seen.add(source.name)
        source = _input(source.data) if source.data else None


def refresh(changed, depsgraph):
    """Bring the followers of changed blocks up to date, inputs before what follows them."""
    _note(changed)
    if not known:
        return
    changed = set(changed)
    for data in _in_order():
        source, owner = _input(data), owner_of(data)
        if source is None or owner is None:
            continue
        if not changed.isdisjoint((source, source.data, owner, getattr(source.data, 'shape_keys', None))):
            if _update(data, owner, source, depsgraph):
                changed.add(data)


def _note(blocks):
    """Add the followers among changed blocks, which may be new to the file."""
    for block in blocks:
        if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)) and recipes.follows(block):
            known.add(_key(block))


def refresh_all(depsgraph):
    """Bring every follower up to date: another frame, another file."""
    for data in _in_order():
        source, owner = _input(data), owner_of(data)
        if source is not None and owner is not None:
            _update(data, owner, source, depsgraph)


def problem(data):
    """Why a follower does not follow, or ""."""
    if not recipes.follows(data):
        return ""
    source = recipes.read_input(data)
    if source is None or not source.users_scene:
        return "The object it follows was deleted, or is in no scene: it stays as it was last"
    return problems.get(_key(data), "")


def not_followed(source):
    """What of an object has no effect on what follows it: short sentences."""
    return [] if shape.has_shape(source) else read_native.not_followed(source)


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


def current(owner, source, depsgraph):
    """The definition of what `source` is now, in the space of `owner`. Raises ValueError."""
    into = np.array(_matrix(owner, depsgraph).inverted_safe() @ _matrix(source, depsgraph))
    return transform.transformed(_definition_of(source, depsgraph), into)


def _definition_of(source, depsgraph):
    """What an object is now, in its own space. Raises ValueError if it shows nothing."""
    if shape.has_shape(source):
        return store.read(source.data)
    reading = read_native.read(source, depsgraph)
    if reading.value is None:
        raise ValueError(f"{source.name} shows nothing that could be followed")
    return definitions.from_value(reading.value)


def _matrix(ob, depsgraph):
    return ob.evaluated_get(depsgraph).matrix_world


def _update(data, owner, source, depsgraph):
    """Whether the follower changed."""
    key = _key(data)
    try:
        if not source.users_scene:
            return False
        if recipes.follows_a_shape(data) and not shape.has_shape(source):
            raise ValueError(f"{source.name} is no Splinewright shape any more: it stays as it was last")
        definition = current(owner, source, depsgraph)
        problems.pop(key, None)
        if _same(store.read(data), definition) and not shape.is_touched(data):
            return False
        shape.set_definition(data, definition)
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
    blocks = _blocks()
    depths = []
    for data in blocks:
        depth, source = 0, _input(data)
        while source is not None and depth <= len(blocks):
            depth, source = depth + 1, _input(source.data) if source.data else None
        if depth <= len(blocks):
            depths.append((depth, data))
        else:
            problems[_key(data)] = "It follows itself, in a circle: it stays as it was last"
    return [data for _, data in sorted(depths, key=lambda pair: pair[0])]


def _blocks():
    blocks = [_block(key) for key in sorted(known)]
    if all(data is not None and recipes.follows(data) for data in blocks):
        return blocks
    scan()                              # one was renamed or removed
    return [_block(key) for key in sorted(known)]


def _input(data):
    try:
        return recipes.read_input(data)
    except store.UnreadableDefinition as error:
        problems[_key(data)] = str(error)
        return None


def _key(data):
    return isinstance(data, bpy.types.Curve), data.name


def _block(key):
    is_curve, name = key
    return (bpy.data.curves if is_curve else bpy.data.meshes).get(name)
