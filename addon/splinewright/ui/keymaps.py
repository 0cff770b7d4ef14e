"""Tab, Ctrl+J, Ctrl+R, Alt+G, Alt+S, Ctrl+T, I and Shift+Q on shapes and nets. The operators' polls let the keys pass for
everything else."""

import bpy

#: Keymap, operator, key, what is held with it; the first that applies is taken.
_ITEMS = (
    ('Object Non-modal', "splinewright.edit_net", 'TAB', None),
    ('Object Non-modal', "splinewright.edit_source", 'TAB', None),
    ('Object Non-modal', "splinewright.leave_net", 'TAB', None),
    ('Object Mode', "splinewright.join", 'J', 'ctrl'),
    ('Mesh', "splinewright.insert_here", 'R', 'ctrl'),
    ('Curve', "splinewright.insert_here", 'R', 'ctrl'),
    ('Mesh', "splinewright.pull_here", 'G', 'alt'),
    ('Curve', "splinewright.pull_here", 'G', 'alt'),
    ('Curve', "splinewright.radius_here", 'S', 'alt'),
    ('Curve', "splinewright.tilt_here", 'T', 'ctrl'),
    ('Mesh', "splinewright.key_points", 'I', None),
    ('Curve', "splinewright.key_points", 'I', None),
    ('Mesh', "splinewright.pie", 'Q', 'shift'),
    ('Curve', "splinewright.pie", 'Q', 'shift'),
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
    for name, operator, key, held in _ITEMS:
        keymap = config.keymaps.new(name=name)
        _made.append((keymap, keymap.keymap_items.new(operator, key, 'PRESS', **({held: True} if held else {}))))


def unregister():
    for keymap, item in _made:
        keymap.keymap_items.remove(item)
    _made.clear()
