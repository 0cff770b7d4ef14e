"""Tools of the add-on in the toolbar of 3D views, while there is something for them to be used on."""

from pathlib import Path

import bpy
from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active

from ..core.base.words import say
from . import active_shape, editing
from .tool_table import GROUPS, NETS, TOOLS

_ICONS = Path(__file__).resolve().parent.parent / "icons"
#: They are shown behind this one of Blender's.
_BEFORE = "builtin.transform"


def _keys(tool):
    """Its items of Blender's keymaps. A key that its operator leaves to others selects, as with Blender's own tools."""
    for modifier in (None, *tool.modifiers):
        held = {modifier: True} if modifier else {}
        yield tool.operator, {"type": 'LEFTMOUSE', "value": 'PRESS', **held}, {"properties": list(tool.settings)}


def draw_settings(tool, layout, properties, is_of_patches):
    """The settings of a tool's operator, in the header."""
    for name in (*tool.shown, *(tool.of_patches if is_of_patches else ())):
        setting = properties.bl_rna.properties[name]
        is_choice = setting.type == 'ENUM'
        if is_choice:
            layout.label(text=f"{say(setting.name)}:")
        layout.row().prop(properties, name, expand=is_choice)


def _drawing(tool):
    def draw(context, layout, active):
        is_of_patches = context.object is not None and context.object.type == 'MESH'
        draw_settings(tool, layout, active.operator_properties(tool.operator), is_of_patches)
    return draw


def icon_of(tool):
    """What Blender calls its icon: a path without the suffix."""
    return str(_ICONS / tool.name)


def _class_of(tool, mode):
    """Blender's class for a tool in a mode."""
    body = {
        'bl_space_type': 'VIEW_3D', 'bl_context_mode': mode, 'bl_idname': tool.idname, 'bl_label': tool.label,
        'bl_description': tool.description, 'bl_icon': icon_of(tool), 'bl_keymap': tuple(_keys(tool)),
        'bl_cursor': tool.cursor, 'bl_options': {'KEYMAP_FALLBACK'}, 'bl_operator': tool.operator}
    if tool.shown or tool.of_patches:
        body['draw_settings'] = staticmethod(_drawing(tool))
    return type(f"SPLINEWRIGHT_TOOL_{tool.name}_{mode.lower()}", (bpy.types.WorkSpaceTool,), body)


class _Section:
    """Our tools of a mode among Blender's, which calls such an entry to learn what there is now."""

    def __init__(self, mode):
        self.mode = mode
        groups = [[tool for tool in group if mode in tool.modes] for group in GROUPS]
        self._groups = [[(tool, _class_of(tool, mode)) for tool in group] for group in groups if group]
        self.classes = [cls for group in self._groups for _, cls in group]

    def __call__(self, context):
        """context: None asks for all."""
        is_wanted = context is None or _is_wanted(context, self.mode)
        shown = [tuple(cls._bl_tool for tool, cls in group if is_wanted or tool.is_always) for group in self._groups]
        yield from (None, *(group if len(group) > 1 else group[0] for group in shown if group)) if any(shown) else ()

    def put_in(self):
        listed = VIEW3D_PT_tools_active._tools[self.mode]
        for cls in self.classes:
            bpy.utils.register_tool(cls)
            listed.remove(cls._bl_tool)
        names = [getattr(item, 'idname', None) for item in listed]
        listed.insert(names.index(_BEFORE) + 1 if _BEFORE in names else len(names), self)

    def take_out(self):
        listed = VIEW3D_PT_tools_active._tools[self.mode]
        listed.remove(self)
        for cls in self.classes:
            listed.append(cls._bl_tool)
            bpy.utils.unregister_tool(cls)


def _is_wanted(context, mode):
    """Whether tools of the add-on have something to be used on; the one in use is always shown."""
    if mode == 'OBJECT' and active_shape.shapes(context) or mode != 'OBJECT' and editing.nets_in_edit_mode(context):
        return True
    return active(context) is not None


def active(context):
    """The Tool of the add-on that is in use, or None."""
    if context.workspace is None:
        return None
    found = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return next((tool for tool in TOOLS.values() if found is not None and found.idname == tool.idname), None)


def is_active(context, name):
    """Whether a tool of the add-on is the one in use."""
    found = active(context)
    return found is not None and found.name == name


def settings(context, tool):
    """The settings of the operator of a tool in use."""
    found = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return found.operator_properties(tool.operator)


_sections = ()

CLASSES = ()


def register():
    global _sections
    if bpy.context.window_manager.keyconfigs.addon is None:
        return                          # in background there are neither keys nor toolbars
    _sections = tuple(map(_Section, (*NETS, 'OBJECT')))
    for section in _sections:
        section.put_in()


def unregister():
    global _sections
    for section in _sections:
        section.take_out()
    _sections = ()
