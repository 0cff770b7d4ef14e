"""In the status bar: which keys do what while a net is edited. Blender's own hints stay beside it."""

import bpy

from ..bridge import versions
from ..bridge.file_state import state
from . import editing, keymaps, preferences

_MODIFIERS = ('ctrl', 'shift', 'alt', 'oskey')
_WORDS = {"splinewright.leave_net": "Done", "splinewright.insert_here": "Insert Knot",
          "splinewright.pull_here": "Pull Shape", "splinewright.radius_here": "Radius", "splinewright.tilt_here": "Tilt",
          "splinewright.key_points": "Key Points",
          "splinewright.pie": "Pie Menu"}


def said(context):
    """[(icons of keys, words)] for what is at hand; none while something else is going on."""
    if not preferences.get().show_hints or state.status or _is_busy(context.window):
        return []
    if not editing.nets_in_edit_mode(context):
        return []
    room = 'Curve' if context.mode == 'EDIT_CURVE' else 'Mesh'
    items = [(item, operator) for keymap, item, operator in keymaps.of_user()
             if item and item.active and operator in _WORDS and keymap.name in (room, 'Object Non-modal')]
    return [(_icons(item), _WORDS[operator]) for item, operator in items]


def _is_busy(window):
    """Whether a gesture is under way, whose keys are others; of Blender's own not all versions tell."""
    if versions.knows_modal_operators and window.modal_operators:
        return True
    return bool(state.aimed or state.pulled or state.weighing or state.picking or state.moved_knot)


def _icons(item):
    """Names of Blender's icons of keys; a key that has none is left out of it."""
    known = bpy.types.UILayout.bl_rna.functions['label'].parameters['icon'].enum_items
    held = [name.upper() for name in _MODIFIERS if getattr(item, name)]
    wanted = [f"EVENT_{name}" for name in (*held, item.type)]
    return [name for name in wanted if name in known]


def _draw(self, context):
    for icons, words in said(context):
        row = self.layout.row(align=True)
        for icon in icons[:-1]:
            row.label(text="", icon=icon)
        row.label(text=words, icon=icons[-1] if icons else 'NONE')
    self.layout.separator()


CLASSES = ()


def register():
    bpy.types.STATUSBAR_HT_header.prepend(_draw)


def unregister():
    bpy.types.STATUSBAR_HT_header.remove(_draw)
