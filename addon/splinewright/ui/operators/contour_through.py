"""A contour through the selection: vertices of a mesh in Edit Mode, or the points of strokes."""

import bpy

from ...core.base.words import say
from ...core.recipes.table import RECIPES
from .. import recipe_props
from . import new_shapes
from .adding import resolution_property
from .from_points import CurvesFromPoints, are_strokes_there, lines_of_strokes

_CONTOUR = RECIPES['contour']
_FEW = "Draw with Grease Pencil or Annotate, or select vertices of a mesh in Edit Mode"
_MORE = {'closed': {'options': {'SKIP_SAVE'}, 'description': "Go back to the first point; loops of edges always do"}}


class SPLINEWRIGHT_OT_contour_through_points(CurvesFromPoints, bpy.types.Operator):
    bl_idname = "splinewright.contour_through_points"
    bl_label = "Add Contour Through Points"
    button = "Contour Through Points"
    bl_description = "Add a contour of segments through selected vertices or strokes, with sharp, round or chamfered corners"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    recipe, shape_name = _CONTOUR, "Contour"
    __annotations__ = {
        **{parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, {}))
           for parameter in _CONTOUR.parameters},
        'resolution_u': resolution_property(default=_CONTOUR.resolution)}

    @classmethod
    def can_take_objects(cls, context):
        if are_strokes_there(context):
            return True
        cls.poll_message_set(say(_FEW))
        return False

    def lines_of_objects(self, context):
        return lines_of_strokes(context, _FEW)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for parameter in _CONTOUR.counting(self):
            layout.prop(self, parameter.name)
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_contour_through_points,)
