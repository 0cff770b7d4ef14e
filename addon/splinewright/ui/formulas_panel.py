"""The formulas of a shape, in the sidebar: what conic a curve is."""

import bpy

from ..bridge.data import store
from ..bridge.shape import shape
from ..core.formulas import formulas
from ..core.shape import definition as definitions
from . import texts
from .sub_panel import ClosedPanel

#: Curves with more control points than this are no conic that one would call so.
_MOST_POINTS = 16


class SPLINEWRIGHT_PT_formulas(ClosedPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_formulas"
    bl_label = "Formulas"
    bl_order = 8

    @classmethod
    def poll(cls, context):
        return shape.has_shape(context.object)

    def draw(self, context):
        texts.draw_pairs(self.layout, _conic(context.object.data))
        self.layout.operator("splinewright.write_formulas", icon='TEXT')


def _conic(data):
    try:
        definition = store.read(data)
    except store.UnreadableDefinition:
        return []
    if not definition.has_curves or len(definition.pieces) > 2 or len(definition.pool) > _MOST_POINTS:
        return []
    value = definitions.to_value(definition)
    return formulas.conic_lines((value[0] if isinstance(value, list) else value).to_nurbs())


CLASSES = (SPLINEWRIGHT_PT_formulas,)
