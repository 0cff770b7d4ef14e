"""What a shape measures at the mouse is shown there; a click takes the place into the panel Measure."""

import bpy
import numpy as np

from ...bridge.analysis import surveys
from ...bridge.shape import shape
from ...core.analysis import measured
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import say
from .. import active_shape, editing, measure_overlay, picking
from ..ui_state import ui_state
from .gesture import redraw
from .pointing import Pointing


class SPLINEWRIGHT_OT_measure_here(Pointing, bpy.types.Operator):
    bl_idname = "splinewright.measure_here"
    bl_label = "Measure"
    bl_description = ("Show parameters, point, curvatures and torsion of a shape at the mouse; click to measure there in the "
                      "panel")
    bl_options = {'UNDO'}
    works_on_nets = True

    hint = "Point at a shape to measure it   |   Click: take the place into the panel   |   Esc, Right Mouse: Cancel"

    @classmethod
    def poll(cls, context):
        if not _shapes(context):
            cls.poll_message_set(say("Select a Splinewright shape, or edit its net"))
            return False
        return True

    def invoke(self, context, event):
        return self.begin(context, event)

    def look(self, context, event):
        self._found, ui_state.measured = measured_at(context, event.mouse_x, event.mouse_y)
        redraw()
        return self._found is not None

    def forget(self):
        ui_state.measured = None

    def clicked(self, context):
        name, number, fractions = self._found
        self.cancel(context)
        ob = context.view_layer.objects.get(name)
        if not shape.has_shape(ob):
            return {'CANCELLED'}
        take(context, ob, number, fractions)
        # Edit Mode's undo steps would not hold it.
        return {'FINISHED'} if context.mode == 'OBJECT' else {'CANCELLED'}


def take(context, ob, number, fractions):
    """Let the panel Measure show a shape at parts (u, v) of the domain of a piece."""
    nets = {active_shape.shape_of(net): net for net in editing.nets_in_edit_mode(context)}
    context.view_layer.objects.active = nets.get(ob, ob)
    settings = ob.data.splinewright
    if active_shape.count_of(ob.data) > 1:
        active_shape.take(ob.data, number)
    settings.measure_u, settings.measure_v = fractions


def _shapes(context):
    """The selected shapes, and the active one."""
    active = active_shape.shape_of(context.object) if context.mode == 'OBJECT' else None
    return list({ob.name: ob for ob in (*active_shape.shapes(context), active) if ob}.values())


def measured_at(context, x, y):
    """((name of an object, number of its piece, parts of the domain) or None, a measure_overlay.Measured or None) at a pixel
    of the window."""
    view = picking.view_at(x, y)
    obs = [ob for ob in _shapes(context) if ob.visible_get()]
    try:
        found = picking.pointed_at(x, y, obs, context.evaluated_depsgraph_get())
    except FAILURES:
        return None, None               # such a shape shows nothing to point at
    if found is None:
        return None, None
    ob, number, parameters = found
    try:
        piece = surveys.moved_of(ob.data, np.array(ob.matrix_world, dtype=np.float64)).pieces[number - 1]
        place = measured.place(piece, parameters)
    except FAILURES as error:
        return None, measure_overlay.Measured(view[0].as_pointer(), x, y, None, (sentence(error),))
    shown = measure_overlay.Measured(view[0].as_pointer(), x, y, place, place.words)
    return (ob.name, number, measured.fractions_of(piece, parameters)), shown


CLASSES = (SPLINEWRIGHT_OT_measure_here,)
