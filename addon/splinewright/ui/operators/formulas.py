"""The formulas of a curve or patch as a text."""

import bpy
from bpy.props import FloatProperty, IntProperty

from ...bridge.data import store
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.formulas import formulas, teaching
from .. import active_shape
from . import reports
from .pick_piece import draw_number

#: On a text that we wrote: the object it is about.
_OWNER = "splinewright_formulas_of"


class SPLINEWRIGHT_OT_write_formulas(bpy.types.Operator):
    bl_idname = "splinewright.write_formulas"
    bl_label = "Write Formulas as Text"
    bl_description = "Write points, power basis, matrices, equation and triangles of a curve or patch to a text, in fractions"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    piece: IntProperty(name="Piece", description="Which curve or patch of the shape, counted from 1", default=1, min=1,
                       options={'SKIP_SAVE'})
    position: FloatProperty(name="Position", description="Of the triangles: 0 is the start of the curve, 1 its end; of a patch in both directions",
                            default=0.5, min=0.0, max=1.0, precision=5)

    @classmethod
    def poll(cls, context):
        if not shape.has_shape(context.object):
            cls.poll_message_set(say("Select a Splinewright shape"))
            return False
        return True

    def invoke(self, context, event):
        active_shape.begin(self, [context.object])
        return self.execute(context)

    def draw(self, context):
        self.layout.use_property_split = True
        draw_number(self.layout, self, 'piece')
        self.layout.prop(self, 'position')

    def execute(self, context):
        ob = context.object
        active_shape.forget_asked()
        active_shape.note(self, 'piece', ob)
        try:
            piece = teaching.piece_of(store.read(ob.data), self.piece)
            written = formulas.text(piece, decimals.typed(self.position))
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        text = _text_for(ob)
        text.from_string(written)
        return reports.finished(self, reports.Report(phrase("{name} is in the Text Editor", name=text.name)))


def _text_for(ob):
    """The text that was written for an object before, or a new one: other texts are left alone."""
    for text in bpy.data.texts:
        if text.library is None and text.get(_OWNER) == ob.name:
            return text
    text = bpy.data.texts.new(f"{ob.name} Formulas")
    text[_OWNER] = ob.name
    return text


CLASSES = (SPLINEWRIGHT_OT_write_formulas,)
