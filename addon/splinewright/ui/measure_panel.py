"""What the active shape measures in the scene, and, folded, where it lies and what it is at a place of one of its curves or
patches, in the sidebar."""

import bpy
import numpy as np

from ..bridge.analysis import surveys
from ..bridge.cage import net_object
from ..bridge.data import store
from ..core.analysis import measured
from ..core.base import decimals
from ..core.base.failures import FAILURES, sentence
from ..core.base.words import say
from . import active_shape, fields, texts
from .sub_panel import ClosedPanel

#: While a net is edited shapes of more points are measured when it is left.
_MOST_WHILE_EDITED = 2000
_DIGITS = 7
#: What such a number takes beside words, in pixels of an interface that is not scaled.
_NUMBER = 84
#: Seconds that may go by while the panel is drawn; while a net is edited, which may be at every step of a drag.
_SOON, _SOON_WHILE_EDITED = 0.1, 0.02


class _Measuring(ClosedPanel):
    @classmethod
    def poll(cls, context):
        return active_shape.shape_of(context.object) is not None

    def draw(self, context):
        ob = active_shape.shape_of(context.object)
        try:
            definition = store.read(ob.data)
            is_edited = net_object.is_net(context.object)
            if is_edited and len(definition.pool) > _MOST_WHILE_EDITED:
                texts.draw_note(self.layout, "This many points are measured after editing")
                return
            matrix, seconds = np.array(ob.matrix_world, dtype=np.float64), _SOON_WHILE_EDITED if is_edited else _SOON
            self.draw_measured(self.layout, ob.data, matrix, definition, seconds)
        except store.UnreadableDefinition:
            return                      # the panel above says it
        except FAILURES as error:
            texts.draw_note(self.layout, sentence(error))


class SPLINEWRIGHT_PT_measure(_Measuring, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_measure"
    bl_label = "Measure"
    bl_order = 6

    @staticmethod
    def draw_measured(layout, data, matrix, _definition, seconds):
        whole = surveys.whole_soon(data, matrix, seconds)
        if whole is None:
            layout.operator("splinewright.measure_whole", icon='DRIVER_DISTANCE')
            return
        for problem in whole.problems:
            texts.draw_note(layout, problem)
        column = layout.column(align=True)
        for name, number in (("Length", whole.length), ("Area", whole.area), ("Volume", whole.volume)):
            if number is not None:
                _draw_row(column, name, number)
        if whole.box is not None:
            _draw_row(column, "Size", whole.box[1] - whole.box[0])


class SPLINEWRIGHT_PT_measure_place(_Measuring, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_measure_place"
    bl_label = "At a Point"
    bl_parent_id = "SPLINEWRIGHT_PT_measure"

    @staticmethod
    def draw_measured(layout, data, matrix, definition, seconds):
        chosen, count = data.splinewright, len(definition.pieces)
        layout.operator("splinewright.measure_here", text="Pick Point", icon='EYEDROPPER')
        if count > 1:
            fields.number(layout, chosen, "piece")
        layout.prop(chosen, "measure_u", slider=True)
        if isinstance(data, bpy.types.Mesh):
            layout.prop(chosen, "measure_v", slider=True)
        number = min(max(chosen.piece, 1), count) - 1
        column = layout.column(align=True)
        for name, value in surveys.place_of(data, matrix, number, (chosen.measure_u, chosen.measure_v), seconds):
            _draw_row(column, name, value)


class SPLINEWRIGHT_PT_measure_box(_Measuring, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_measure_box"
    bl_label = "Bounding Box"
    bl_parent_id = "SPLINEWRIGHT_PT_measure"

    @staticmethod
    def draw_measured(layout, data, matrix, _definition, seconds):
        whole = surveys.whole_soon(data, matrix, seconds)
        if whole is not None and whole.box is not None:
            column = layout.column(align=True)
            for name, corner in zip(("From", "To"), whole.box):
                _draw_row(column, name, corner)


def _draw_row(column, name, value):
    """A number beside its name, or three below one another."""
    numbers = measured.shown(value)
    for i, number in enumerate(numbers):
        words = f"{say(name)} {'XYZ'[i]}" if len(numbers) > 1 else say(name)
        if not texts.fits(words, _NUMBER):
            column.label(text=words)
            words = ""
        row = column.split(factor=texts.share([words], least=0.45))
        row.label(text=words)
        row.label(text=decimals.text_of(number, _DIGITS))


CLASSES = (SPLINEWRIGHT_PT_measure, SPLINEWRIGHT_PT_measure_place, SPLINEWRIGHT_PT_measure_box)
