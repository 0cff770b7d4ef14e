"""The formulas of a curve: a few in the sidebar, all of them as a text."""

import bpy
from bpy.props import FloatProperty, IntProperty

from ..bridge import shape, store
from ..core import definition as definitions
from ..core import formulas, teaching
from ..core.failures import FAILURES, sentence
from .sub_panel import SubPanel

#: On a text that we wrote: the object it is about.
_OWNER = "splinewright_formulas_of"
#: Curves with more control points than this are no conic that one would call so.
_MOST_POINTS = 16


def _is_curve(ob):
    return shape.has_shape(ob) and ob.type == 'CURVE'


class SPLINEWRIGHT_OT_write_formulas(bpy.types.Operator):
    bl_idname = "splinewright.write_formulas"
    bl_label = "Formulas as Text"
    bl_description = ("Write the points, the power basis, the conic's equation, and the triangles of basis functions "
                      "and of de Casteljau at a point into a text of the Text Editor")
    bl_options = {'REGISTER', 'UNDO'}

    piece: IntProperty(name="Piece", description="Which curve of the shape, counted from 1", default=1, min=1)
    position: FloatProperty(name="Position", description="Of the triangles: 0 is the start of the curve, 1 its end",
                            default=0.5, min=0.0, max=1.0, precision=5)

    @classmethod
    def poll(cls, context):
        if not _is_curve(context.object):
            cls.poll_message_set("Select a curve shape")
            return False
        return True

    def execute(self, context):
        ob = context.object
        try:
            curve = teaching.nurbs_of(store.read(ob.data), self.piece)
            written = formulas.text(curve, float(str(round(self.position, 7))))
        except FAILURES as error:
            self.report({'ERROR'}, f"{ob.name}: {sentence(error)}")
            return {'CANCELLED'}
        text = _text_for(ob)
        text.from_string(written)
        self.report({'INFO'}, f"{text.name} is in the Text Editor")
        return {'FINISHED'}


def _text_for(ob):
    """The text that was written for an object before, or a new one: other texts are left alone."""
    for text in bpy.data.texts:
        if text.library is None and text.get(_OWNER) == ob.name:
            return text
    text = bpy.data.texts.new(f"{ob.name} Formulas")
    text[_OWNER] = ob.name
    return text


class SPLINEWRIGHT_PT_formulas(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_formulas"
    bl_label = "Formulas"

    @classmethod
    def poll(cls, context):
        return _is_curve(context.object)

    def draw(self, context):
        column = self.layout.column(align=True)
        for label, text in _conic(context.object.data):
            row = column.split(factor=0.3)
            row.label(text=label)
            row.label(text=text)
        self.layout.operator("splinewright.write_formulas", icon='TEXT')


def _conic(data):
    try:
        definition = store.read(data)
    except store.UnreadableDefinition:
        return []
    if len(definition.pieces) > 2 or len(definition.pool) > _MOST_POINTS:
        return []
    value = definitions.to_value(definition)
    return formulas.conic_lines((value[0] if isinstance(value, list) else value).to_nurbs())


CLASSES = (SPLINEWRIGHT_OT_write_formulas, SPLINEWRIGHT_PT_formulas)
