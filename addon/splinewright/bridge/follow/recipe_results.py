"""What a recipe makes from other objects, as they are now."""

import numpy as np

from ...core.base.failures import AboutInputs, Refusal
from ...core.shape import definition as definitions
from ...core.shape import transform
from ...core.surfaces import sections
from ..data import store
from ..native import read_native
from ..recipes import placing, recipes
from ..shape import radii, read_polygons, shape


def result(recipe, values, sources, space, frames=(), turned=()):
    """What a recipe makes from objects in a placing.Space; frames and turned as of recipes.Stored. Raises Refusal or an error
    of the library."""
    return work(recipe, values, sources, space, frames, turned)(None)


def work(recipe, values, sources, space, frames=(), turned=()):
    """A function that gives result() for a `cancel` as the library takes it, and reads nothing of Blender's any more. Raises
    Refusal."""
    make = _made_in(recipe, values, sources, space, frames, turned)
    return make if (space.applied == np.eye(4)).all() else _then(make, space.applied)


def made_of(stored, space):
    """(whether that is all, what result() depends on for a recipes.Stored), to be compared with what that was. Of anything but a shape
    nothing can be told but its place."""
    recipe, sources, digests = stored.recipe, stored.sources, []
    for source in sources:
        digests.append(source.type if source.type == 'EMPTY' else store.digest(source.data) if shape.has_shape(source) else None)
    matrices = [space.matrix, space.applied, *map(space.of, (*sources, *stored.frames))]
    is_all = None not in digests and not recipe.radius_asked
    return is_all, (recipe.kind, stored.values, stored.turned, [source.name for source in sources], digests,
                    [matrix.tobytes() for matrix in matrices])


def _then(make, matrix):
    """make() of which the result is moved by a matrix."""
    def moved(cancel):
        made = make(cancel)
        return made._replace(value=_under(made.definition, matrix))
    return moved


def _made_in(recipe, values, sources, space, frames, turned):
    if recipe.has_places:
        return recipe.work(np.array([space.of(frame)[:3, 3] for frame in frames]), values)
    inputs = inputs_of(recipe, sources, space)
    more = {'frame': space.of(frame) for frame in frames}
    if recipe.has_turns:
        more['turned'] = [*turned, *[False] * (len(sources) - len(turned))]
    if recipe.takes_spaces:
        more['spaces'] = [_into(recipe, space, source) for source in sources]
    if recipe.radius_asked:
        is_asked = values[recipe.radius_asked]
        more['factor'] = radii.along_curve(sources[0], definition_of(sources[0], space.depsgraph)) if is_asked else None
    make = _naming(recipe.work(inputs, {**values, **more}), [source.name for source in sources])
    return _then(make, np.linalg.inv(space.to_lengths())) if recipe.is_measured else make


def _naming(make, names):
    """make() that says the names of inputs that are in the way."""
    def named(cancel):
        try:
            return make(cancel)
        except AboutInputs as error:
            raise error.named(names) from error
    return named


def inputs_of(recipe, sources, space):
    """The definitions of objects as a recipe takes them. Raises Refusal."""
    if recipe.is_from_mesh:
        return [read_polygons.polygons_of(source, space.of(source)) for source in sources]
    if recipe.is_beside:
        return [definition_of(source, space.depsgraph) for source in sources]
    return [_input(recipe, i, source, space) for i, source in enumerate(sources)]


def _input(recipe, number, source, space):
    point = _point_of(source) if recipe.takes_points else None
    if point is not None:
        return sections.Point(tuple((_into(recipe, space, source) @ [*point, 1.0])[:3].tolist()))
    definition = definition_of(source, space.depsgraph)
    return definition if number in recipe.own_spaces else _under(definition, _into(recipe, space, source))


def _point_of(source):
    """Where in its own space an object is a place alone, as an empty is, and a curve of one point; else None."""
    if source.type == 'EMPTY':
        return 0.0, 0.0, 0.0
    return None if shape.has_shape(source) else read_native.single_point(source)


def _into(recipe, space, source):
    return space.to_lengths() @ space.of(source) if recipe.is_measured else space.of(source)


def _under(definition, matrix):
    return definition if (matrix == np.eye(4)).all() else transform.transformed(definition, matrix)


def matrix_in(ob, owner, depsgraph):
    """(4, 4): from the space of one object to that of another, or of the world for None. Raises Refusal where that has no
    room for it."""
    return placing.of_object(owner, depsgraph).of(ob)


def is_possible(ob):
    """Whether a shape can be made from an object."""
    return ob is not None and (ob.type in ('CURVE', 'SURFACE') or shape.has_shape(ob))


def can_make(recipe, ob):
    """Whether a recipe makes shapes from such an object."""
    if recipe.is_from_mesh:
        return read_polygons.is_mesh(ob)
    return is_possible(ob) or recipe.takes_points and ob is not None and ob.type == 'EMPTY'


def not_followed(source):
    """What of an object has no effect on what follows it: short sentences."""
    if shape.has_shape(source) or source.type == 'EMPTY':
        return []
    return read_polygons.not_followed(source) if read_polygons.is_mesh(source) else read_native.not_followed(source)


def not_followed_by(data, sources):
    """not_followed() of all objects that a shape is made from, but for the radius where it is asked for."""
    stored = recipes.read(data)
    asked = stored.recipe.radius_asked
    is_followed = bool(asked and stored.values[asked])
    return [text for i, source in enumerate(sources) for text in not_followed(source)
            if not (is_followed and i == 0 and text == read_native.RADIUS)]


def definition_of(source, depsgraph):
    """What an object is now, in its own space. Raises Refusal if it shows nothing."""
    if shape.has_shape(source):
        return store.read(source.data)
    if not is_possible(source):
        raise Refusal("{name} is not a curve, surface or Splinewright shape", name=source.name)
    reading = read_native.read(source, depsgraph)
    if reading.value is None:
        raise Refusal("{name} shows nothing that could be followed", name=source.name)
    return definitions.from_value(reading.value)
