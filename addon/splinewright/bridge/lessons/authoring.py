"""Shapes of a teacher's scene, as a lesson says them."""

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.lessons import reading
from ...core.lessons.drafts import Present
from ...core.lessons.measures import Shown
from ...core.recipes.table import RECIPES
from ...core.shape import definition as definitions
from ...core.shape import transform
from ..data import settings, store
from ..recipes import placing, recipes
from ..shape import shape
from .stage import SHAPE


def known(scene):
    """{object: name} of the shapes of a scene that its lesson knows. Of copies the first one counts."""
    found = {}
    for ob in sorted(scene.objects, key=lambda ob: (ob.name != ob.get(SHAPE), ob.name)):
        if SHAPE in ob.keys() and shape.has_shape(ob) and str(ob[SHAPE]) not in found.values():
            found[ob] = str(ob[SHAPE])
    return found


def with_inputs(obs):
    """Shapes, and those that they are made from, each after its inputs."""
    found = {}

    def put(ob, above):
        if ob in found or ob in above:
            return
        for source in recipes.read_inputs(ob.data) if recipes.has(ob.data) else ():
            if shape.has_shape(source):
                put(source, (*above, ob))
        found[ob] = None
    for ob in obs:
        put(ob, ())
    return list(found)


def present(obs, names, depsgraph):
    """{name: Present} of shapes; names: {object: name} of all that the lesson knows. Raises Refusal or an error of the library."""
    return {names[ob]: _present(ob, names, depsgraph) for ob in obs}


def _present(ob, names, depsgraph):
    if shape.is_touched(ob.data):
        raise Refusal("{name} was changed by hand: use Discard Manual Changes first", name=ob.name)
    stored, faces = recipes.read(ob.data), _faces(ob.data)
    why = _why_value(ob, stored, names, depsgraph) if stored else ""
    if stored is None or why:
        return Present("", (), {}, _around(ob, np.zeros(3), depsgraph), why, faces=faces)
    place, points = _place(ob, names, depsgraph), () if stored.sources or _starts(stored) else tuple(map(tuple, stored.points.tolist()))
    return Present(stored.recipe.kind, tuple(names[source] for source in stored.sources), dict(stored.values), _around(ob, place, depsgraph),
                   points=points, faces=faces, place=(0.0, 0.0, 0.0) if stored.sources else tuple(place.tolist()))


def _around(ob, place, depsgraph):
    """The value of a shape, around a place in the world."""
    definition, matrix = store.read(ob.data), placing.world(ob, depsgraph)
    matrix[:3, 3] -= place
    return definitions.to_value(definition if np.array_equal(matrix, np.eye(4)) else transform.transformed(definition, matrix))


def _place(ob, names, depsgraph):
    """(3,): where a lesson puts the object of a shape."""
    stored = recipes.read(ob.data)
    if stored is None or _why_value(ob, stored, names, depsgraph):
        return np.zeros(3)
    return _place(stored.sources[0], names, depsgraph) if stored.sources else placing.world(ob, depsgraph)[:3, 3].copy()


def _faces(data):
    """How many faces each span of a surface has, where that was chosen and a lesson can say it."""
    chosen = settings.of(data)
    found = chosen.resolution_u, chosen.resolution_v
    return found if isinstance(data, bpy.types.Mesh) and chosen.mode == settings.COUNT and max(found) <= reading.MOST_FACES else ()


def _starts(stored):
    """Whether a recipe has the points that it starts from."""
    return not len(stored.points) or np.array_equal(stored.points, stored.recipe.start_for(stored.values))


def _why_value(ob, stored, names, depsgraph):
    """Why a lesson cannot make a shape by its recipe, or ""."""
    if stored.frames or any(stored.turned):
        return "an object gives its axis or place, or an input is turned"
    if not stored.sources:
        if not _starts(stored) and stored.recipe.has_groups:
            return "its points were moved"
        if not _starts(stored) and len(stored.points) > reading.MOST_ENTRIES:
            return phrase("it has {number} points, and {most_entries} are the most",
                          number=len(stored.points), most_entries=reading.MOST_ENTRIES)
        is_turned = not np.allclose(placing.world(ob, depsgraph)[:3, :3], np.eye(3), rtol=1e-6, atol=1e-6)
        return "it was turned or scaled" if is_turned else ""
    if None in stored.sources:
        return "what it was made from is gone"
    strange = next((source.name for source in stored.sources if source not in names), "")
    if strange:
        return phrase("it is made from {strange}, which is not a shape of the lesson", strange=strange)
    if not _is_at(ob, placing.beside(stored.sources[0], depsgraph).matrix, depsgraph):
        return "it does not lie where it was made"
    is_own = stored.recipe.own_spaces or stored.recipe.takes_spaces
    return "what it is made from was moved" if is_own and not all(_is_at(one, np.eye(4), depsgraph) for one in stored.sources) else ""


def _is_at(ob, matrix, depsgraph):
    return np.allclose(placing.world(ob, depsgraph), matrix, rtol=1e-6, atol=1e-6)


def recipe_of(ob):
    """The Recipe of a shape, or None, as far as it can be told without reading all of it."""
    return RECIPES.get(recipes.kind(ob.data))


def shown(found):
    """What measures take of {name: Present}."""
    return {name: Shown(one.value, one.settings) for name, one in found.items()}


def mark(names):
    """Let objects {object: name} be shapes of the lesson."""
    for ob, name in names.items():
        ob[SHAPE] = name


def new_names(obs, names):
    """{object: name} with those of more objects."""
    found = dict(names)
    for ob in obs:
        if ob not in found:
            taken, name, number = set(found.values()), ob.name, 2
            while name in taken:
                name, number = f"{ob.name} {number}", number + 1
            found[ob] = name
    return found


def unmark(scene):
    """Its shapes belong to no lesson any more."""
    for ob in scene.objects:
        if SHAPE in ob.keys():
            del ob[SHAPE]


def graph():
    """The depsgraph of the current view layer."""
    layer = bpy.context.view_layer
    layer.update()
    return layer.depsgraph
