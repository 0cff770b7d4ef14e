"""Tools of ours in the toolbar of 3D views, while there is something for them to be used on."""

from pathlib import Path
from typing import NamedTuple

import bpy
from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active

from . import editing, hand

_ICONS = Path(__file__).resolve().parent.parent / "icons"
_NETS = ('EDIT_MESH', 'EDIT_CURVE')
#: They are shown behind this one of Blender's.
_BEFORE = "builtin.transform"


class Tool(NamedTuple):
    """A tool: what it is called and shown by, the operator that its button calls, with which settings and modifiers,
    which of the settings the header shows of patches, and the modes where it is."""

    name: str
    label: str
    description: str
    icon: str
    operator: str
    settings: tuple
    modifiers: tuple = ()
    shown: tuple = ()
    modes: tuple = _NETS
    cursor: str = 'CROSSHAIR'


_TOOLS = (
    Tool("insert_knot", "Insert Knot", "Click the curve or patch where a knot is to be; it is shown at the mouse. Ctrl takes "
         "the middle of the span", "insert_knot", "splinewright.insert_here", (("at_once", True),),
         modifiers=('ctrl',), shown=("direction",), modes=(*_NETS, 'OBJECT')),
    Tool("pull", "Pull Shape", "Press anywhere on the curve or patch and pull: it goes where it is pulled to, and the control "
         "points follow with the least change", "pull", "splinewright.pull_here", (("at_once", True),),
         shown=("locality",), modes=(*_NETS, 'OBJECT')),
    Tool("weight", "Weight", "Drag a control point sideways to change its weight, and those of all selected ones if it is among "
         "them", "weight", "splinewright.weight_here", (("at_mouse", True), ("is_drag", True)), cursor='MOVE_X'),
)


def _keys(tool):
    """Its items of Blender's keymaps. A key that its operator leaves to others selects, as with Blender's own tools."""
    for modifier in (None, *tool.modifiers):
        held = {modifier: True} if modifier else {}
        yield tool.operator, {"type": 'LEFTMOUSE', "value": 'PRESS', **held}, {"properties": list(tool.settings)}


def _draw_settings(tool):
    def draw(context, layout, active):
        properties = active.operator_properties(tool.operator)
        if context.object is not None and context.object.type == 'MESH':
            for name in tool.shown:
                layout.row().prop(properties, name, expand=True)
    return draw


def _icon(name):
    """What Blender calls an icon: one of ours, or of its own."""
    return name if name.startswith("ops.") else str(_ICONS / name)


def _class_of(tool, mode):
    """Blender's class for a tool in a mode."""
    body = {
        'bl_space_type': 'VIEW_3D', 'bl_context_mode': mode, 'bl_idname': _id(tool.name), 'bl_label': tool.label,
        'bl_description': tool.description, 'bl_icon': _icon(tool.icon), 'bl_keymap': tuple(_keys(tool)),
        'bl_cursor': tool.cursor, 'bl_options': {'KEYMAP_FALLBACK'}, 'bl_operator': tool.operator}
    if tool.shown:
        body['draw_settings'] = staticmethod(_draw_settings(tool))
    return type(f"SPLINEWRIGHT_TOOL_{tool.name}_{mode.lower()}", (bpy.types.WorkSpaceTool,), body)


def _id(name):
    return f"splinewright.{name}"


class _Section:
    """Our tools of a mode among Blender's, which calls such an entry to learn what there is now."""

    def __init__(self, mode):
        self.mode = mode
        self.classes = [_class_of(tool, mode) for tool in _TOOLS if mode in tool.modes]

    def __call__(self, context):
        """context: None asks for all."""
        if context is None or _is_wanted(context, self.mode):
            yield None
            yield from (cls._bl_tool for cls in self.classes)

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
    """Whether tools of ours have something to be used on; one that is in use is shown wherever it is."""
    if mode == 'OBJECT' and hand.shapes(context) or mode != 'OBJECT' and editing.nets_in_edit_mode(context):
        return True
    return any(is_active(context, name) for name in (tool.name for tool in _TOOLS))


def is_active(context, name):
    """Whether a tool of ours is the one in use."""
    active = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return active is not None and active.idname == _id(name)


def settings(context, name):
    """The settings of the operator of a tool in use."""
    tool = next(tool for tool in _TOOLS if tool.name == name)
    active = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return active.operator_properties(tool.operator)


_sections = ()

CLASSES = ()


def register():
    global _sections
    if bpy.context.window_manager.keyconfigs.addon is None:
        return                          # in background there are neither keys nor toolbars
    _sections = tuple(map(_Section, (*_NETS, 'OBJECT')))
    for section in _sections:
        section.put_in()


def unregister():
    global _sections
    for section in _sections:
        section.take_out()
    _sections = ()
