"""A tool of the add-on is chosen by an entry of a menu, as its button in the toolbar does: F3 finds entries, and no buttons."""

import bpy
from bpy.props import EnumProperty

from ...core.base.words import phrase, say
from ..tool_table import TOOLS
from . import reports


class SPLINEWRIGHT_OT_use_tool(bpy.types.Operator):
    bl_idname = "splinewright.use_tool"
    bl_label = "Choose Tool"
    bl_description = "Choose this tool of the toolbar; the tool header has its settings"
    bl_options = {'INTERNAL'}
    works_on_nets = True

    tool: EnumProperty(name="Tool", items=[(tool.name, tool.label, tool.description) for tool in TOOLS.values()],
                       options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def description(cls, context, properties):
        return say(TOOLS[properties.tool].description)

    @classmethod
    def poll(cls, context):
        if bpy.app.background or context.area is None or context.area.type != 'VIEW_3D':
            cls.poll_message_set(say("Tools are in the toolbar of 3D views"))
            return False
        return True

    def execute(self, context):
        tool = TOOLS[self.tool]
        if context.mode not in tool.modes:
            return reports.cancelled(self, phrase("the tool {label} is not there in this mode", label=phrase(tool.label)))
        return bpy.ops.wm.tool_set_by_id(name=tool.idname, space_type='VIEW_3D')


CLASSES = (SPLINEWRIGHT_OT_use_tool,)
