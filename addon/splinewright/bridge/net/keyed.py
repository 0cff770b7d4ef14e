"""What keys and drivers change: the parameters of recipes, the settings of how finely a shape is shown, control points.

Blender sets them while it evaluates, when no geometry may be written. They are shown by the handlers that it calls when it
has done so.
"""

from contextlib import contextmanager

import bpy

from ...core.base.failures import text_of
from ..data import animation, problems, settings, store
from ..data.file_state import key, state
from ..follow import follow
from ..keys import point_keys
from ..recipes import parameters, recipes
from ..shape import recipe_edit, shape
from . import keyed_net


def set_parameters(data, changes, depsgraph=None):
    """Change parameters of a recipe by name. Raises, and changes nothing, where nothing results."""
    if recipes.follows(data):
        follow.set_parameters(data, changes, depsgraph or bpy.context.evaluated_depsgraph_get())
    else:
        recipe_edit.set_parameters(data, changes)


def is_shape(block):
    """Whether it is a shape whose parameters, settings or points have keys or drivers, which move it here."""
    return isinstance(block, (bpy.types.Mesh, bpy.types.Curve)) and not block.library and has_keys(block)


def has_keys(data):
    """Whether a data-block is a shape whose parameters, settings or points have keys or drivers."""
    return store.has_definition(data) and any(channel.data_path.startswith(_OURS) for channel in animation.channels(data))


#: Beginnings of data paths.
_OF_SETTINGS, _OF_PARAMETERS = "splinewright.", "splinewright_parameters."
_OURS = (_OF_SETTINGS, _OF_PARAMETERS, point_keys.PATH)


def show(changed, depsgraph):
    """Show what changed data-blocks were given; those that were written. In a render the originals are given nothing."""
    for data in changed:
        if isinstance(data, (bpy.types.Mesh, bpy.types.Curve)) and problems.of(data, problems.KEYED) and not is_shape(data):
            problems.set_problem(data, problems.KEYED, "")     # there are no keys any more
    return {data for data in changed if is_shape(data) and _show(data, data.evaluated_get(depsgraph), depsgraph)}


def _show(data, evaluated, depsgraph):
    """Whether the shape changed. Whatever goes wrong is kept in words: others are to be shown, too."""
    try:
        paths = animation.paths(data)
        is_other = any(path.startswith(_OF_SETTINGS) for path in paths) and _take_settings(data, evaluated, paths)
        changes = _changes(data, evaluated, {path.removeprefix(_OF_PARAMETERS) for path in paths})
        definition, problem = point_keys.given(data, evaluated) if _goes_by_keys(data) else (None, "")
        if changes:
            set_parameters(data, changes, depsgraph)
        elif definition is not None:
            lost = keyed_net.set_definition(data, definition)
            problem = "; ".join(filter(None, (problem, lost)))
        elif is_other:
            shape.rewrite(data)
        problems.set_problem(data, problems.KEYED, problem)
        return is_other or bool(changes) or definition is not None
    except Exception as error:
        problems.set_problem(data, problems.KEYED, text_of(error))
        return False


@contextmanager
def kept():
    """Points of nets that are out stay where they are meanwhile."""
    state.shows_keys = False
    try:
        yield
    finally:
        state.shows_keys = True


def _goes_by_keys(data):
    return state.shows_keys or keyed_net.held_net(data) is None


def _take_settings(data, evaluated, paths):
    """Whether a shape was written by other settings than it has now. A resolution of curves that has keys counts."""
    given = settings.values(evaluated)
    if isinstance(data, bpy.types.Curve) and given['mode'] == settings.AUTOMATIC and f"{_OF_SETTINGS}resolution_u" in paths:
        given['mode'] = settings.COUNT
    settings.take(data, given)
    return state.shown.get(key(data)) != given


def _changes(data, evaluated, names):
    """{name: value} of those parameters that are other than the recipe's. names: of properties."""
    stored = recipes.read(data)
    if stored is None:
        return {}
    given = parameters.changes(stored.recipe, stored.values, parameters.of(evaluated))
    found = {parameter.name: given[parameter.name] for parameter in stored.recipe.parameters
             if parameter.name in given and parameters.name_of(stored.recipe, parameter) in names}
    return {**found, **_changed_lists(data, evaluated, stored)}


def _changed_lists(data, evaluated, stored):
    """As _changes(): texts of numbers, of which those with keys or drivers are taken."""
    found = {}
    for parameter in stored.recipe.parameters:
        if parameter.numbers:
            name = parameters.list_name_of(stored.recipe, parameter)
            numbers, before = getattr(parameters.of(evaluated), name), stored.values[parameter.name]
            text = parameters.with_numbers(before, {i: numbers[i] for i in _keyed_places(data, _OF_PARAMETERS + name)})
            found.update({parameter.name: text} if text != before else {})
    return found


def _keyed_places(data, path):
    return {channel.array_index for channel in animation.channels(data) if channel.data_path == path}
