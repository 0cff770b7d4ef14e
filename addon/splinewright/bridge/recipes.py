"""How a definition comes about where it follows another object: kept beside it, on the Mesh or Curve."""

from . import store

KEY = "splinewright_recipe"
VERSION = 1


def read_input(data):
    """The object that the shape follows, None where it follows none.

    Raises UnreadableDefinition for a recipe of a newer Splinewright.
    """
    if KEY not in data.keys():
        return None
    recipe = data[KEY]
    if recipe.get('version', 0) > VERSION:
        raise store.UnreadableDefinition(f"{data.name} has a recipe of a newer Splinewright: it is shown as it was last")
    return recipe.get('input')


def has(data):
    return KEY in data.keys()


def follows_a_shape(data):
    """Whether what it follows was a shape when it began to."""
    return bool(data[KEY].get('shape', False))


def write(data, source):
    """Make the shape follow an object from now on.

    The pointer also tells Blender's depsgraph to evaluate what is followed where it is hidden, in renders, too.
    """
    store.assign(data, KEY, {'version': VERSION, 'kind': 'follow', 'input': source,
                             'shape': store.has_definition(source.data)})


def remove(data):
    if has(data):
        del data[KEY]
