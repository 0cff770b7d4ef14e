"""Tab and Ctrl+J on shapes. The operators' polls let the keys pass for everything else."""

import bpy

from . import preferences

#: Keymap, operator, key, control; the first that applies is taken.
_ITEMS = (
    ('Object Non-modal', "splinewright.edit_net", 'TAB', False),
    ('Object Non-modal', "splinewright.leave_net", 'TAB', False),
    ('Object Mode', "splinewright.join", 'J', True),
)

_made = []


def update():
    """Follow the preference."""
    for _, item in _made:
        item.active = preferences.get().use_keys


CLASSES = ()


def register():
    config = bpy.context.window_manager.keyconfigs.addon
    if config is None:                  # in background
        return
    for name, operator, key, control in _ITEMS:
        keymap = config.keymaps.new(name=name)
        _made.append((keymap, keymap.keymap_items.new(operator, key, 'PRESS', ctrl=control)))
    update()


def unregister():
    for keymap, item in _made:
        keymap.keymap_items.remove(item)
    _made.clear()
