"""In the status bar: which keys do what while a net is edited, and over the knot strip, and what stopped following. Blender's hints
stay beside it."""

import bpy

from ..bridge.data import versions
from ..bridge.data.settings import overlays_of
from ..core.base.words import say
from . import editing, finishing, keymaps, preferences, stopped, toolbar
from .ui_state import ui_state

_MOUSE = {'LEFTMOUSE': 'MOUSE_LMB', 'MIDDLEMOUSE': 'MOUSE_MMB', 'RIGHTMOUSE': 'MOUSE_RMB'}
_MODIFIERS = ('ctrl', 'shift', 'alt', 'oskey')
_WORDS = {"splinewright.leave_net": "Done", "splinewright.insert_here": "Insert Knot",
          "splinewright.pull_here": "Pull Shape", "splinewright.radius_here": "Radius", "splinewright.tilt_here": "Tilt",
          "splinewright.key_points": "Insert Point Keyframes",
          "splinewright.pie": "Pie Menu"}
#: Of what is told by Blender's message bus.
_owner = object()
_WORDS_ON_STRIP = {"splinewright.insert_on_strip": "twice: Insert Knot", "splinewright.remove_on_strip": "Remove Knot"}


def shown_keys(context):
    """[(icons of keys, words)] for the current state; none while something else is happening."""
    if not preferences.get().show_hints or ui_state.status or _is_busy(context.window):
        return []
    if ui_state.pointed_knot and overlays_of(context.scene).strip:
        return _on_strip(is_at_knot=ui_state.pointed_knot.mark is not None)
    tool = toolbar.active(context)
    keys = [(list(icons), words) for icons, words in tool.keys] if tool else []
    if not editing.nets_in_edit_mode(context):
        return keys
    return keys + _known(_WORDS, 'Curve' if context.mode == 'EDIT_CURVE' else 'Mesh', 'Object Non-modal')


def _on_strip(is_at_knot):
    """With one key for each, as far as there are icons."""
    icons_of = {words: icons for icons, words in reversed(_known(_WORDS_ON_STRIP, keymaps.STRIP)) if icons}
    found = [(icons_of[words], words) for words in _WORDS_ON_STRIP.values() if words in icons_of]
    return [(['MOUSE_LMB_DRAG'], "Move Knot"), *found] if is_at_knot else found[:1]


def _known(words, *rooms):
    """Those of the keymaps of these names."""
    return [(_icons(item), words[operator]) for keymap, item, operator in keymaps.of_user()
            if item and item.active and operator in words and keymap.name in rooms]


def redraw(context):
    """Blender draws the status bar again where its text is set."""
    for window in context.window_manager.windows:
        if not _is_busy(window):        # a gesture says what its keys do
            window.workspace.status_text_set(say(ui_state.status or None))


def follow_tools():
    """Have the status bar drawn again where another tool is chosen. Blender forgets this when a file is opened."""
    bpy.msgbus.clear_by_owner(_owner)
    bpy.msgbus.subscribe_rna(key=(bpy.types.WorkSpace, 'tools'), owner=_owner, args=(), notify=lambda: redraw(bpy.context))


def say_stopped():
    """Let the status bar be drawn again where what stopped following is another; while a gesture is under way, later."""
    windows = list(bpy.context.window_manager.windows)
    wanted = tuple(stopped.in_status(window.view_layer) for window in windows)
    if wanted != ui_state.stopped and (any(wanted) or any(ui_state.stopped)) and not any(map(_is_busy, windows)):
        ui_state.stopped = wanted
        redraw(bpy.context)


def _is_busy(window):
    """Whether a gesture is under way, whose keys are others; of Blender's own not all versions tell."""
    if versions.knows_modal_operators and finishing.has_operators(window):
        return True
    return any((ui_state.finishing, ui_state.is_pointing, ui_state.drawn_stroke, ui_state.contour, ui_state.aimed, ui_state.pulled, ui_state.weighing, ui_state.picking,
                ui_state.rounding, ui_state.moved_knot, ui_state.measured))


def _icons(item):
    """Names of Blender's icons of keys; a key that has none is left out of it."""
    known = bpy.types.UILayout.bl_rna.functions['label'].parameters['icon'].enum_items
    held = [name.upper() for name in _MODIFIERS if getattr(item, name)]
    wanted = [_MOUSE.get(name, f"EVENT_{name}") for name in (*held, item.type)]
    return [name for name in wanted if name in known]


def _draw(self, context):
    problem = stopped.in_status(context.view_layer)
    if problem:
        self.layout.label(text=say(problem), icon='ERROR')
    for icons, words in shown_keys(context):
        row = self.layout.row(align=True)
        for icon in icons[:-1]:
            row.label(text="", icon=icon)
        row.label(text=say(words), icon=icons[-1] if icons else 'NONE')
    self.layout.separator()


CLASSES = ()


def register():
    follow_tools()
    bpy.types.STATUSBAR_HT_header.prepend(_draw)


def unregister():
    bpy.msgbus.clear_by_owner(_owner)
    bpy.types.STATUSBAR_HT_header.remove(_draw)
