"""Data for drawings over an object, kept until Blender reports any change, or anything of the add-on is written."""

import bpy

from ..bridge.data.file_state import state


def kept(what, ob, make):
    """What make(ob) gave in the current view layer since the last change."""
    name = what, ob.as_pointer(), bpy.context.view_layer.as_pointer()
    if name not in state.overlaid:
        state.overlaid[name] = make(ob)
    return state.overlaid[name]
