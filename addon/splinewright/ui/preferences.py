"""The add-on's preferences. They work without the native library, to say what is wrong with it."""

import bpy
from bpy.props import BoolProperty

from ..core import library
from . import texts

_NAME = __package__.rpartition('.')[0]


def get():
    """The preferences in use; their defaults where Blender has none yet."""
    addon = bpy.context.preferences.addons.get(_NAME)
    return addon.preferences if addon and addon.preferences else _Defaults


class _Defaults:
    use_keys = True


def _keys_changed(self, context):
    from . import keymaps
    keymaps.update()


class SplinewrightPreferences(bpy.types.AddonPreferences):
    bl_idname = _NAME

    use_keys: BoolProperty(
        name="Tab edits the net of a shape, Ctrl+J joins shapes",
        description="Off: Blender's own Tab and Ctrl+J, and buttons in the sidebar for ours",
        default=True, update=_keys_changed)

    def draw(self, context):
        layout = self.layout
        if library.problem:
            texts.draw_problem(layout, library.problem, width=90)
            return
        layout.label(text=f"Native library splinecore {library.sc.__version__} is loaded", icon='CHECKMARK')
        layout.prop(self, "use_keys")


