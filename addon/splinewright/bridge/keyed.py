"""What keys and drivers change: the parameters of recipes, and the settings of how finely a shape is shown.

Blender sets them while it evaluates, often in another thread, when no geometry may be written. So they are noted then,
and shown by the handlers that it calls when it has done so.
"""

import bpy

from ..core.failures import told
from . import animation, follow, problems, recipes, remaking, settings, shape, store
from .file_state import block_of, key, state


def set_parameters(data, changes, depsgraph=None):
    """Change parameters of a recipe by name. Raises, and changes nothing, where nothing comes of it."""
    if recipes.follows(data):
        follow.set_parameters(data, changes, depsgraph or bpy.context.evaluated_depsgraph_get())
    else:
        remaking.set_parameters(data, changes)


def is_evaluating(data, name, value):
    """Whether it is Blender's evaluation that sets a parameter: then it is noted, and show() is to come.

    What is animated is set on the copy that is evaluated, and right after that on the original.
    """
    if data.is_evaluated:
        state.keyed.setdefault(key(data.original), {})[name] = value
        return True
    noted = state.keyed.get(key(data), {})
    return name in noted and noted[name] == value


def show(changed, depsgraph):
    """Show what was noted, and the settings that `changed` data-blocks were given; the data-blocks that were written."""
    noted, state.keyed = state.keyed, {}
    of_recipes = {block_of(name): changes for name, changes in noted.items()}
    written = {data for data, changes in of_recipes.items() if data and _show_parameters(data, changes, depsgraph)}
    return written | {data for data in changed if has_settings(data) and _show_settings(data, depsgraph)}


def _show_parameters(data, changes, depsgraph):
    """Whether the shape changed."""
    if data.library or not recipes.has(data):
        return False
    try:
        known = recipes.parameters(data)
        changes = {name: value for name, value in changes.items() if known.get(name, value) != value}
        if changes:
            set_parameters(data, changes, depsgraph)
        problems.tell(data, problems.KEYED, "")
        return bool(changes)
    except Exception as error:          # other shapes are to be shown, too
        problems.tell(data, problems.KEYED, told(error))
        return False


def has_settings(block):
    """Whether it is a shape whose settings have keys or drivers."""
    return (isinstance(block, (bpy.types.Mesh, bpy.types.Curve)) and not block.library
            and block.animation_data is not None and store.has_definition(block)
            and any(path.startswith("splinewright.") for path in animation.paths(block)))


def _show_settings(data, depsgraph):
    """Whether the shape changed. In a render the original does not have the values of the frame."""
    given = settings.values(data.evaluated_get(depsgraph))
    if state.shown.get(key(data)) == given:
        return False
    settings.take(data, given)
    try:
        shape.rewrite(data)
        problems.tell(data, problems.KEYED, "")
        return True
    except Exception as error:
        problems.tell(data, problems.KEYED, told(error))
        return False
