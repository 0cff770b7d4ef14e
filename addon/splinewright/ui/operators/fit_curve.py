"""A clean curve near what was drawn or measured: strokes of Grease Pencil, annotations, vertices of a mesh in Edit Mode."""

import bpy

from ...core.base.words import say
from ...core.recipes.table import RECIPES
from .. import recipe_props
from . import new_shapes
from .adding import resolution_property
from .from_points import CurvesFromPoints, are_strokes_there, lines_of_strokes

_SPLINE = RECIPES['approximating']
_MORE = {'tolerance': {'description': "How far points may lie from the curve, in the scene"},
         'closed': {'options': {'SKIP_SAVE'}, 'description': "Go back to the first point; loops of edges and closed "
                    "strokes always do"}}


class SPLINEWRIGHT_OT_fit_curve(CurvesFromPoints, bpy.types.Operator):
    bl_idname = "splinewright.fit_curve"
    bl_label = "Fit Curve"
    bl_description = ("Add a clean curve near strokes or selected vertices, within a tolerance or with a number of control "
                      "points")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    recipe, shape_name, is_measured = _SPLINE, "Fitted Curve", True
    needs = "Draw with Grease Pencil or Annotate and come to Object Mode, or select vertices in the Edit Mode of a mesh"
    __annotations__ = {
        **{parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, {}))
           for parameter in _SPLINE.parameters},
        'resolution_u': resolution_property(default=_SPLINE.resolution)}

    @classmethod
    def can_take_objects(cls, context):
        if are_strokes_there(context):
            return True
        cls.poll_message_set(say(cls.needs))
        return False

    def lines_of_objects(self, context):
        return lines_of_strokes(context, self.needs)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "by", expand=True)
        for parameter in _SPLINE.counting(self):
            if parameter.name != 'by':
                layout.prop(self, parameter.name)
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_fit_curve,)
