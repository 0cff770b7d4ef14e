"""Tab, Ctrl+J, Ctrl+R, Alt+G, Alt+S, Ctrl+T, P, I and Shift+Q on shapes and nets. The operators' polls let the keys pass for
everything else. Those on the knot strip are asked only with the mouse over it."""

import bpy

#: Keymap, operator, key, what is held with it; the first that applies is taken.
_ITEMS = (
    ('Object Non-modal', "splinewright.edit_net", 'TAB', None),
    ('Object Non-modal', "splinewright.edit_source", 'TAB', None),
    ('Object Non-modal', "splinewright.edit_linked", 'TAB', None),
    ('Object Non-modal', "splinewright.leave_net", 'TAB', None),
    ('Object Mode', "splinewright.join", 'J', 'ctrl'),
    ('Mesh', "splinewright.insert_here", 'R', 'ctrl'),
    ('Curve', "splinewright.insert_here", 'R', 'ctrl'),
    ('Mesh', "splinewright.pull_here", 'G', 'alt'),
    ('Curve', "splinewright.pull_here", 'G', 'alt'),
    ('Curve', "splinewright.radius_here", 'S', 'alt'),
    ('Curve', "splinewright.tilt_here", 'T', 'ctrl'),
    ('Mesh', "splinewright.separate_pieces", 'P', None),
    ('Curve', "splinewright.separate_pieces", 'P', None),
    ('Mesh', "splinewright.key_points", 'I', None),
    ('Curve', "splinewright.key_points", 'I', None),
    ('Mesh', "splinewright.pie", 'Q', 'shift'),
    ('Curve', "splinewright.pie", 'Q', 'shift'),
)

#: The keymap with the mouse over the knot strip; operator, key, how it is pressed.
STRIP = "Splinewright Knot Strip"
_ON_STRIP = (
    ("splinewright.insert_on_strip", 'LEFTMOUSE', 'DOUBLE_CLICK'),
    ("splinewright.remove_on_strip", 'X', 'PRESS'),
    ("splinewright.remove_on_strip", 'DEL', 'PRESS'),
)

#: Keymaps where a click in Edit Mode is looked for, in their order, and those of Blender's own whose Select it is. The former
#: hold it for any button: which one selects is asked of the latter.
_CLICKED = (("3D View Tool: Tweak", "3D View Tool: Tweak"), ("3D View Tool: Tweak (fallback)", "3D View Tool: Tweak (fallback)"),
            ("Mesh", "3D View"))

_made, _quiet = [], []


def of_user():
    """[(keymap, item, operator)] of the user's configuration, which has what a user changed; the item is None where a
    user removed it."""
    config, found = bpy.context.window_manager.keyconfigs.user, []
    for keymap, made in _made:
        own, taken = config.keymaps.get(keymap.name) if config else None, [item for _, item, _ in found]
        items = [item for item in own.keymap_items if item.idname == made.idname and item not in taken] if own else []
        item = min(items, key=lambda item: (item.is_user_defined, item.type != made.type), default=None)
        found.append((own, item, made.idname))
    return found


def of_strip(config):
    """The keymap for the knot strip of a configuration. Items of the add-on stay where Blender reads its keys again;
    Blender counts those of which the default one has the map, too."""
    return config.keymaps.new(name=STRIP, space_type='VIEW_3D', region_type='WINDOW')


CLASSES = ()


def register():
    config = bpy.context.window_manager.keyconfigs.addon
    if config is None:                  # in background
        return
    for name, operator, key, held in _ITEMS:
        keymap = config.keymaps.new(name=name)
        _made.append((keymap, keymap.keymap_items.new(operator, key, 'PRESS', **({held: True} if held else {}))))
    keymap = of_strip(config)
    of_strip(bpy.context.window_manager.keyconfigs.default)
    _quiet.append((keymap, keymap.keymap_items.new("gizmogroup.gizmo_tweak", 'LEFTMOUSE', 'PRESS', any=True)))
    for operator, key, value in _ON_STRIP:
        _made.append((keymap, keymap.keymap_items.new(operator, key, value)))
    _quiet.extend(_clicks(config))


def _clicks(config):
    for name, own in _CLICKED:
        where = {} if name == "Mesh" else {'space_type': 'VIEW_3D', 'region_type': 'WINDOW', 'tool': True}
        keymap = config.keymaps.new(name=name, **where)
        for button in ('LEFTMOUSE', 'RIGHTMOUSE'):
            for value in ('PRESS', 'CLICK'):
                item = keymap.keymap_items.new("splinewright.select_seen", button, value, any=True)
                item.properties.keymap = own
                yield keymap, item


def unregister():
    for keymap, item in (*_made, *_quiet):
        keymap.keymap_items.remove(item)
    _made.clear()
    _quiet.clear()
