"""The sidebar panel, and the same in the object data properties."""

import bpy

from ..bridge import shape, store
from ..core import describe
from . import texts

#: Characters that fit a line of the sidebar.
_WIDTH = 40


class _ShapePanel:
    bl_label = "Splinewright"

    @classmethod
    def poll(cls, context):
        return shape.has_shape(context.object)

    def draw(self, context):
        data = context.object.data
        layout = self.layout
        try:
            definition = store.read(data)
        except store.UnreadableDefinition as error:
            texts.draw_problem(layout, str(error), _WIDTH)
            return
        column = layout.column(align=True)
        for label, text in describe.lines(definition):
            row = column.split(factor=0.3)
            row.label(text=label)
            row.label(text=text)
        layout.separator()
        settings = data.splinewright
        column = layout.column(align=True)
        if definition.has_curves:
            column.prop(settings, "resolution_u", text="Resolution")
        else:
            column.prop(settings, "resolution_u")
            column.prop(settings, "resolution_v", text="V")
            layout.prop(settings, "sharp_angle")
            layout.label(text=f"{len(data.vertices):,} vertices, {len(data.polygons):,} faces")
        if settings.problem:
            texts.draw_problem(layout, settings.problem, _WIDTH)


class SPLINEWRIGHT_PT_shape(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_shape"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "Splinewright"


class SPLINEWRIGHT_PT_data(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_data"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "data"
    bl_options = {'DEFAULT_CLOSED'}


CLASSES = (SPLINEWRIGHT_PT_shape, SPLINEWRIGHT_PT_data)
