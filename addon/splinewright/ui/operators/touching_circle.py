"""A circle, or an arc of one, that touches three curves."""

import bpy
from bpy.props import BoolProperty, IntProperty

from ...bridge.follow import recipe_results
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal
from ...core.base.library import sc
from ...core.base.words import phrase, say
from ...core.meets import touching
from ...core.shape import transform
from ...core.verbs import verbs
from . import new_shapes, reports
from .adding import Repeatable, add_in_front, can_add, resolution_property
from .long_work import LongWork

_NEEDS = "Select three curves of one plane"


class SPLINEWRIGHT_OT_add_touching_circle(LongWork, Repeatable, bpy.types.Operator):
    bl_idname = "splinewright.add_touching_circle"
    bl_label = "Add Touching Circle"
    button = "Touching Circle"
    bl_description = "Add a circle that touches three curves of one plane: pieces of the selected shapes, or Blender's own curves"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    number: IntProperty(name="Circle", description="Which of those that are found, the smallest first", default=1, min=1,
                        options={'SKIP_SAVE'})
    is_arc: BoolProperty(name="Arc", description="Only from where it touches the first curve through the second to the third")
    resolution_u: resolution_property(default=24)

    @classmethod
    def poll(cls, context):
        if not can_add(cls, context):
            return False
        if cls.has_made(context) or any(map(_is_curve, context.selected_objects)):
            return True
        cls.poll_message_set(say(_NEEDS))
        return False

    def tasks(self, context):
        return {'circles': self._task(context)}

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        sources = list(filter(_is_curve, context.selected_objects))
        try:
            found = self.result_of('circles', self._task(context))
            if self.number > len(found):
                raise Refusal("{count} circles touch them, there is none of number {number}",
                              "{count} circle touches them, there is none of number {number}", count=len(found), number=self.number)
            circle = found[self.number - 1]
            value = circle.arc if self.is_arc else sc.conics.circle(circle.center, circle.radius, circle.normal)
            data = shape.new_data("Touching Circle", value, new_shapes.start(self))
        except FAILURES as error:
            return reports.failed(self, error)
        ob = bpy.data.objects.new(data.name, data)
        add_in_front(context, ob, sources)
        which = phrase("circle {number} of {count}, ", number=self.number, count=len(found)) if len(found) > 1 else ""
        return self.finished(context, reports.Report(phrase("{which}radius {radius}",
                                                            which=which, radius=decimals.text_of(circle.radius))))

    def _task(self, context):
        """A function that gives the touching.Circles in the world, for a `cancel` as the library takes it. Raises Refusal."""
        depsgraph = context.evaluated_depsgraph_get()
        curves = [curve for ob in context.selected_objects if _is_curve(ob) for curve in verbs.curves_of(transform.transformed(
            recipe_results.definition_of(ob, depsgraph), recipe_results.matrix_in(ob, None, depsgraph)))]
        if len(curves) != 3:
            raise Refusal("{count} curves are selected: three are needed", "{count} curve is selected: three are needed", count=len(curves))
        return lambda cancel: touching.circles(*curves, cancel)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "number")
        layout.prop(self, "is_arc")
        new_shapes.draw(self, layout)


def _is_curve(ob):
    return ob.type == 'CURVE' and recipe_results.is_possible(ob)


CLASSES = (SPLINEWRIGHT_OT_add_touching_circle,)
