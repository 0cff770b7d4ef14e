"""How a definition comes about, kept beside it on the Mesh or Curve: by following another object, or from
the numbers and points of a recipe. A shape without one has points of its own."""

import numpy as np

from ..core.recipes.table import RECIPES
from . import store

KEY = "splinewright_recipe"
VERSION = 2
_FOLLOW = 'follow'


def has(data):
    return KEY in data.keys()


def kind(data):
    """The kind of a recipe of numbers and points, or ""."""
    found = data[KEY]['kind'] if has(data) else ""
    return "" if found == _FOLLOW else found


def follows(data):
    return has(data) and not kind(data)


def remove(data):
    if has(data):
        del data[KEY]


def require_free(data):
    """Raises ValueError where a recipe would write over what is changed by other ways."""
    if follows(data):
        raise ValueError(f"{data.name} follows another object: use Make Editable first")
    if has(data):
        raise ValueError(f"{data.name} is made by a recipe: change its numbers in the panel, or use Make Editable first")


def read_input(data):
    """The object that the shape follows, None where it follows none.

    Raises UnreadableDefinition for a recipe of a newer Splinewright.
    """
    if not follows(data):
        return None
    _require_known(data)
    return data[KEY].get('input')


def follows_a_shape(data):
    """Whether what it follows was a shape when it began to."""
    return bool(data[KEY].get('shape', False))


def write(data, source):
    """Make the shape follow an object from now on.

    The pointer also tells Blender's depsgraph to evaluate what is followed where it is hidden, in renders, too.
    """
    store.assign(data, KEY, {'version': VERSION, 'kind': _FOLLOW, 'input': source,
                             'shape': store.has_definition(source.data)})


def of(data):
    """The Recipe of numbers and points, or None. Raises UnreadableDefinition for one of a newer Splinewright."""
    if not kind(data):
        return None
    _require_known(data)
    return RECIPES[kind(data)]


def parameters(data):
    """The numbers and texts of a recipe, by name."""
    recipe, group = of(data), data[KEY]['parameters']
    return {name: type(default)(group[name]) if name in group.keys() else default
            for name, default in recipe.defaults.items()}


def points(data):
    """(n, 3) float64: the points of a recipe."""
    return np.array(data[KEY]['points'], dtype=np.float64).reshape(-1, 3)


def write_made(data, recipe, values, rows, error):
    """Keep a recipe with its parameters and points, and how far what it made may lie from what it should be."""
    store.assign(data, KEY, {'version': VERSION, 'kind': recipe.kind, 'parameters': dict(values), 'error': float(error),
                             'points': np.ascontiguousarray(rows, dtype=np.float64).ravel()})


def error(data):
    return data[KEY]['error']


def _require_known(data):
    if data[KEY].get('version', 0) > VERSION or kind(data) not in ("", *RECIPES):
        raise store.UnreadableDefinition(f"{data.name} has a recipe of a newer Splinewright: it is shown as it was last")
