"""A clean curve near what was drawn or measured: strokes of Grease Pencil, annotations, vertices of a mesh in Edit Mode."""

import bpy

from ...bridge import strokes
from ...core import polylines
from ...core.failures import Refusal
from ...core.recipes.table import RECIPES
from .. import recipe_props
from . import new_shapes
from .adding import resolution_property
from .from_points import CurvesFromPoints

_SPLINE = RECIPES['approximating']
_MORE = {'closed': {'options': {'SKIP_SAVE'}, 'description': "Go back to the first point; loops of edges and closed "
                    "strokes always do"}}


class SPLINEWRIGHT_OT_fit_curve(CurvesFromPoints, bpy.types.Operator):
    bl_idname = "splinewright.fit_curve"
    bl_label = "Fit Curve"
    bl_description = ("Add a clean curve near many points, within a tolerance or with so many control points: along each stroke "
                      "of the selected Grease Pencil objects, or of the annotations where none is selected, or along the "
                      "selected vertices of a mesh in Edit Mode")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    recipe, shape_name = _SPLINE, "Fitted Curve"
    needs = "Draw with Grease Pencil or Annotate and come to Object Mode, or select vertices in the Edit Mode of a mesh"
    __annotations__ = {
        **{parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, {}))
           for parameter in _SPLINE.parameters},
        'resolution_u': resolution_property(default=_SPLINE.resolution)}

    @classmethod
    def can_take_objects(cls, context):
        if any(map(strokes.is_drawn, context.selected_objects)) or strokes.has_annotations(context):
            return True
        cls.poll_message_set(cls.needs)
        return False

    def lines_of_objects(self, context):
        drawn = [ob for ob in context.selected_objects if strokes.is_drawn(ob)]
        frame = context.scene.frame_current
        found = ([(ob, *stroke) for ob in drawn for stroke in strokes.of_object(ob, frame)] if drawn else
                 [(None, *stroke) for stroke in strokes.of_annotations(context)])
        lines = [(source, polylines.without_repeats(points), closed) for source, points, closed in found]
        lines = [line for line in lines if len(line[1]) > 1]
        if not lines:
            raise Refusal("there are no strokes" if drawn else self.needs)
        return lines

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "by", expand=True)
        for parameter in _SPLINE.parameters:
            if parameter.name not in ('by', 'control_points' if self.by == 'tolerance' else 'tolerance'):
                layout.prop(self, parameter.name)
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_fit_curve,)
