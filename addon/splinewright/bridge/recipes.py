"""How a definition comes about, kept beside it on the Mesh or Curve: by following another object, or from
the numbers and points of a recipe. A shape without one has points of its own."""

import numpy as np

from ..core.recipes.table import RECIPES
from . import store

KEY = "splinewright_recipe"
VERSION = 2
#: Keys of the pointers to the objects that a shape is made from, and of whether each was a shape then.
_INPUTS = (('input', 'shape'), ('input_2', 'shape_2'))


def has(data):
    return KEY in data.keys()


def kind(data):
    """The kind of a recipe, or ""."""
    return data[KEY]['kind'] if has(data) else ""


def follows(data):
    """Whether the shape is made from other objects."""
    return has(data) and _INPUTS[0][1] in data[KEY].keys()


def has_points(data):
    """Whether the shape is made from points of its own, which its net shows."""
    return has(data) and not follows(data) and len(data[KEY].get('points', ())) > 0


def remove(data):
    if has(data):
        del data[KEY]


def require_free(data):
    """Raises ValueError where a recipe would write over what is changed by other ways."""
    if follows(data):
        raise ValueError(f"{data.name} follows another object: use Make Editable first")
    if has(data):
        raise ValueError(f"{data.name} is made by a recipe: change its numbers in the panel, or use Make Editable first")


def read_inputs(data):
    """The objects that a shape is made from, None for one that was deleted; [] where there are none.

    Raises UnreadableDefinition for a recipe of a newer Splinewright.
    """
    if not follows(data):
        return []
    return [data[KEY].get(pointer) for pointer, _ in _INPUTS[:len(of(data).inputs)]]


def was_shape(data, number):
    """Whether an input was a shape when it was chosen."""
    return bool(data[KEY].get(_INPUTS[number][1], False))


def write_derived(data, recipe, values, sources, error):
    """Make a shape from objects from now on.

    The pointers also tell Blender's depsgraph to evaluate what is followed where it is hidden, in renders, too.
    """
    group = {'version': VERSION, 'kind': recipe.kind, 'parameters': dict(values), 'error': float(error)}
    for (pointer, flag), source in zip(_INPUTS, sources):
        group.update({pointer: source, flag: store.has_definition(source.data)})
    store.assign(data, KEY, group)


def write_error(data, error):
    """Keep how far what a recipe made may lie from what it should be."""
    data[KEY]['error'] = float(error)


def of(data):
    """The Recipe, or None. Raises UnreadableDefinition for one of a newer Splinewright."""
    if not kind(data):
        return None
    _require_known(data)
    return RECIPES[kind(data)]


def parameters(data):
    """The numbers and texts of a recipe, by name."""
    recipe, group = of(data), data[KEY].get('parameters', {})
    try:
        return {name: type(default)(group[name]) if name in group.keys() else default
                for name, default in recipe.defaults.items()}
    except (TypeError, ValueError, AttributeError) as error:
        raise store.UnreadableDefinition(f"the recipe of {data.name} is damaged: {error}") from error


def points(data):
    """(n, 3) float64: the points of a recipe; none where it has inputs."""
    try:
        return np.array(data[KEY].get('points', ()), dtype=np.float64).reshape(-1, 3)
    except (TypeError, ValueError) as error:
        raise store.UnreadableDefinition(f"the recipe of {data.name} is damaged: its points are none") from error


def around(data):
    """(n, 3): the points around which curves that may run far are shown; None where they are shown as they are."""
    return points(data) if has(data) and kind(data) in RECIPES and RECIPES[kind(data)].is_endless else None


def write_made(data, recipe, values, rows, error):
    """Keep a recipe with its parameters and points, and how far what it made may lie from what it should be."""
    store.assign(data, KEY, {'version': VERSION, 'kind': recipe.kind, 'parameters': dict(values), 'error': float(error),
                             'points': np.ascontiguousarray(rows, dtype=np.float64).ravel()})


def error(data):
    return data[KEY].get('error', 0.0)


def _require_known(data):
    if data[KEY].get('version', 0) > VERSION or kind(data) not in RECIPES:
        raise store.UnreadableDefinition(f"{data.name} has a recipe of a newer Splinewright: it is shown as it was last")
