"""What takes too long to measure for the panel Measure is measured when a user asks for it."""

import bpy
import numpy as np

from ...bridge.analysis import surveys
from ...core.analysis import measured
from ...core.base.failures import FAILURES
from ...core.base.words import say
from .. import active_shape
from . import reports
from .long_work import LongWork
from .gesture import redraw


class SPLINEWRIGHT_OT_measure_whole(LongWork, bpy.types.Operator):
    bl_idname = "splinewright.measure_whole"
    bl_label = "Measure"
    bl_description = "Measure length, or area and volume, and the box of the active shape, which takes a while"
    bl_options = {'INTERNAL'}

    @classmethod
    def poll(cls, context):
        if active_shape.shape_of(context.object) is None:
            cls.poll_message_set(say("Make a Splinewright shape active"))
            return False
        return True

    def tasks(self, context):
        there = surveys.moved_of(*_data_and_matrix(context))
        return {'whole': lambda cancel: measured.whole(there, cancel)}

    def execute(self, context):
        ob = active_shape.shape_of(context.object)
        try:
            whole = self.result_of('whole', self.tasks(context)['whole'])
            surveys.keep_whole(*_data_and_matrix(context), whole)
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        redraw()
        return {'FINISHED'}


def _data_and_matrix(context):
    ob = active_shape.shape_of(context.object)
    return ob.data, np.array(ob.matrix_world, dtype=np.float64)


CLASSES = (SPLINEWRIGHT_OT_measure_whole,)
