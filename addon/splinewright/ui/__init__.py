"""What a user sees and calls. register() here is the only one."""

import bpy

from ..core import library
from . import preferences


def _rooms():
    """Modules with CLASSES and, some, register() and unregister(); imported only with the library."""
    from . import (continuity_panel, curve_tools, formulas_panel, handlers, keymaps, menus, messages, net_props, overlay,
                   panels, patch_tools, props, recipe_props)
    from .operators import (add_curve, add_patch, add_recipe, curve_join, curve_verbs, edit, exchange, extract,
                            fineness, follow, formulas, from_objects, infinity, life, native, patch_join, patch_verbs,
                            set_knots)
    return (props, net_props, recipe_props, add_curve, add_recipe, add_patch, exchange, edit, set_knots, infinity, life,
            follow, from_objects, native, curve_verbs, curve_join, patch_verbs, patch_join, extract, fineness, formulas,
            panels, curve_tools, patch_tools, continuity_panel, formulas_panel, menus, keymaps, overlay, messages, handlers)


def register():
    bpy.utils.register_class(preferences.SplinewrightPreferences)
    if library.problem:
        return
    for room in _rooms():
        for cls in room.CLASSES:
            bpy.utils.register_class(cls)
        if hasattr(room, 'register'):
            room.register()


def unregister():
    if not library.problem:
        for room in reversed(_rooms()):
            if hasattr(room, 'unregister'):
                room.unregister()
            for cls in reversed(room.CLASSES):
                bpy.utils.unregister_class(cls)
    bpy.utils.unregister_class(preferences.SplinewrightPreferences)
