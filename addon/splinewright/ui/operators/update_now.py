"""A shape whose inputs changed and that waits to be told is made again."""

import bpy

from ...bridge.data import problems
from ...bridge.follow import follow
from ...bridge.recipes import late
from ...bridge.shape import shape
from ...core.base.failures import Refusal
from .selected import OnSelected


class SPLINEWRIGHT_OT_update_now(OnSelected, bpy.types.Operator):
    bl_idname = "splinewright.update_now"
    bl_label = "Update Now"
    bl_description = "Make the selected shapes again from their inputs as they are now"
    needs = "Select a shape whose inputs changed since it was updated"
    done = "Updated {}"

    @staticmethod
    def fits(ob):
        return shape.has_shape(ob) and late.is_late(ob.data)

    def work(self, context, ob):
        follow.finish([ob.data], context.evaluated_depsgraph_get())
        problem = problems.of(ob.data, problems.FOLLOWING)
        if problem:
            raise Refusal(problem)


CLASSES = (SPLINEWRIGHT_OT_update_now,)
