"""Tab, Ctrl+J and Ctrl+R on shapes and nets. The operators' polls let the keys pass for everything else."""

import bpy

#: Keymap, operator, key, control; the first that applies is taken.
_ITEMS = (
    ('Object Non-modal', "splinewright.edit_net", 'TAB', False),
    ('Object Non-modal', "splinewright.edit_source", 'TAB', False),
    ('Object Non-modal', "splinewright.leave_net", 'TAB', False),
    ('Object Mode', "splinewright.join", 'J', True),
    ('Mesh', "splinewright.insert_here", 'R', True),
    ('Curve', "splinewright.insert_here", 'R', True),
)

_made = []


def of_user():
    """[(keymap, item, operator)] of the user's configuration, which has what a user changed; the item is None where a
    user removed it."""
    config, found = bpy.context.window_manager.keyconfigs.user, []
    for keymap, made in _made:
        own = config.keymaps.get(keymap.name) if config else None
        items = [item for item in own.keymap_items if item.idname == made.idname] if own else []
        found.append((own, min(items, key=lambda item: item.is_user_defined, default=None), made.idname))
    return found


CLASSES = ()


def register():
    config = bpy.context.window_manager.keyconfigs.addon
    if config is None:                  # in background
        return
    for name, operator, key, control in _ITEMS:
        keymap = config.keymaps.new(name=name)
        _made.append((keymap, keymap.keymap_items.new(operator, key, 'PRESS', ctrl=control)))


def unregister():
    for keymap, item in _made:
        keymap.keymap_items.remove(item)
    _made.clear()
