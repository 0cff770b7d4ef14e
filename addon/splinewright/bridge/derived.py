"""What a recipe makes from other objects, as they are now."""

import numpy as np

from ..core import definition as definitions
from ..core import transform
from ..core.failures import Refusal
from . import read_polygons, shape, store
from .native import read_native


def result(recipe, values, sources, owner, depsgraph, frames=(), turned=()):
    """What a recipe makes from objects, in the space of the object `owner`, or of the world where it is None; frames and
    turned as of recipes.Stored. Raises Refusal or an error of the library."""
    return work(recipe, values, sources, owner, depsgraph, frames, turned)(None)


def work(recipe, values, sources, owner, depsgraph, frames=(), turned=()):
    """A function that gives result() for a `cancel` as the library takes it, and reads nothing of Blender's any more. Raises
    Refusal."""
    if recipe.has_places:
        return recipe.work(np.array([matrix_in(frame, owner, depsgraph)[:3, 3] for frame in frames]), values)
    inputs = inputs_of(recipe, sources, owner, depsgraph)
    more = {'frame': matrix_in(frame, owner, depsgraph) for frame in frames}
    if recipe.has_turns:
        more['turned'] = [*turned, *[False] * (len(sources) - len(turned))]
    if recipe.takes_spaces:
        space = None if recipe.is_measured else owner
        more['spaces'] = [matrix_in(source, space, depsgraph) for source in sources]
    make = recipe.work(inputs, {**values, **more})
    if not recipe.is_measured:
        return make
    back = matrix_in(None, owner, depsgraph)

    def moved_back(cancel):
        made = make(cancel)
        return made._replace(value=_under(made.definition, back))
    return moved_back


def inputs_of(recipe, sources, owner, depsgraph):
    """The definitions of objects as a recipe takes them. Raises Refusal."""
    if recipe.is_from_mesh:
        return [read_polygons.polygons_of(source, matrix_in(source, owner, depsgraph)) for source in sources]
    inputs = [definition_of(source, depsgraph) for source in sources]
    if recipe.is_beside:
        return inputs
    space = None if recipe.is_measured else owner
    return [definition if i in recipe.own_spaces else _moved(definition, source, space, depsgraph)
            for i, (definition, source) in enumerate(zip(inputs, sources))]


def _moved(definition, source, owner, depsgraph):
    """A definition of one object in the space of another. Raises Refusal where that has no room for it."""
    return _under(definition, matrix_in(source, owner, depsgraph))


def _under(definition, matrix):
    return definition if (matrix == np.eye(4)).all() else transform.transformed(definition, matrix)


def matrix_in(ob, owner, depsgraph):
    """(4, 4): from the space of one object to that of another, or of the world for None. Raises Refusal where that has no
    room for it."""
    space, own = (np.array(_matrix(one, depsgraph), dtype=np.float64) for one in (owner, ob))
    if not abs(np.linalg.det(space[:3, :3])) > 0.0:
        raise Refusal(f"{owner.name} has a scale of 0: it cannot show what it follows")
    return np.eye(4) if _are_one(space, own) else np.linalg.inv(space) @ own


def _are_one(space, source_space):
    """Whether two spaces differ by less than Blender's single precision: going there and back would move every point
    by a rounding, and the end of a profile that is off its axis by a rounding is no pole."""
    return np.abs(space - source_space).max() <= 4 * np.finfo(np.float32).eps * max(1.0, np.abs(source_space).max())


def is_possible(ob):
    """Whether a shape can be made from an object."""
    return ob is not None and (ob.type in ('CURVE', 'SURFACE') or shape.has_shape(ob))


def can_make(recipe, ob):
    """Whether a recipe makes shapes from such an object."""
    return read_polygons.is_mesh(ob) if recipe.is_from_mesh else is_possible(ob)


def not_followed(source):
    """What of an object has no effect on what follows it: short sentences."""
    return [] if shape.has_shape(source) else read_native.not_followed(source)


def definition_of(source, depsgraph):
    """What an object is now, in its own space. Raises Refusal if it shows nothing."""
    if shape.has_shape(source):
        return store.read(source.data)
    if not is_possible(source):
        raise Refusal(f"{source.name} is no curve, surface or Splinewright shape")
    reading = read_native.read(source, depsgraph)
    if reading.value is None:
        raise Refusal(f"{source.name} shows nothing that could be followed")
    return definitions.from_value(reading.value)


def _matrix(ob, depsgraph):
    return ob.evaluated_get(depsgraph).matrix_world if ob is not None else np.eye(4)
