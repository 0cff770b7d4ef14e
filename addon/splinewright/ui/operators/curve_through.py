"""A curve through the selection: vertices of a mesh in Edit Mode, the points of strokes, or the origins of objects, which
it follows."""

import re

import bpy
from bpy.props import BoolProperty

from ...bridge.edit import grease_pencil
from ...bridge.follow import follow
from ...core.base.failures import Refusal
from ...core.base.words import phrase, say
from ...core.recipes.table import RECIPES, THROUGH_OBJECTS
from .. import recipe_props
from . import new_shapes
from .adding import resolution_property
from .from_points import CurvesFromPoints, are_strokes_there, lines_of_strokes

_SPLINE = RECIPES['interpolating']
_FEW = "Select two objects or more, or draw with Grease Pencil or Annotate"
_MORE = {'closed': {'options': {'SKIP_SAVE'}, 'description': "Go back to the first point; loops of edges always do"}}


class SPLINEWRIGHT_OT_curve_through_points(CurvesFromPoints, bpy.types.Operator):
    bl_idname = "splinewright.curve_through_points"
    bl_label = "Add Curve Through Points"
    button = "Curve Through Points"
    bl_description = ("Add a spline through selected vertices, strokes of Grease Pencil or annotations, or through selected "
                      "objects, which it follows")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    recipe, shape_name = _SPLINE, "Curve Through Points"
    __annotations__ = {
        **{parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, {}))
           for parameter in _SPLINE.parameters},
        'live': BoolProperty(name="Follow Objects", default=True,
                             description="Let the curve follow the objects when they move"),
        'resolution_u': resolution_property(default=_SPLINE.resolution)}

    @classmethod
    def can_take_objects(cls, context):
        if len(context.selected_objects) > 1 or _takes_strokes(context) and are_strokes_there(context):
            return True
        cls.poll_message_set(say(_FEW))
        return False

    def warnings(self, new):
        degree = min(ob.data.splinewright.value.degree for ob in new)
        return (phrase("the degree is {degree}: there are no points for more", degree=degree),) if degree < self.degree else ()

    def lines_of_objects(self, context):
        return lines_of_strokes(context, _FEW)

    def of_objects(self, context):
        if _takes_strokes(context):
            return super().of_objects(context)
        if len(context.selected_objects) < 2:
            raise Refusal(_FEW)
        places = sorted(context.selected_objects, key=lambda ob: _in_numbers(ob.name))
        values, depsgraph = recipe_props.typed(_SPLINE, self), context.evaluated_depsgraph_get()
        if self.live:
            return [follow.new_object(THROUGH_OBJECTS, values, [], new_shapes.start(self), depsgraph, places)]
        return [self.new_object(self.shape_name, values, [ob.matrix_world.translation for ob in places])]

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for parameter in _SPLINE.counting(self):
            layout.prop(self, parameter.name)
        layout.prop(self, "live")
        new_shapes.draw(self, layout)


def _takes_strokes(context):
    return not context.selected_objects or any(map(grease_pencil.is_drawn, context.selected_objects))


def _in_numbers(name):
    """What sorts names as one reads them: P.2 comes before P.10."""
    return [(int(part), "") if part.isdigit() else (-1, part.casefold()) for part in re.split(r"(\d+)", name)]


CLASSES = (SPLINEWRIGHT_OT_curve_through_points,)
