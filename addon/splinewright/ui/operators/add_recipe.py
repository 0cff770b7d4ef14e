"""An Add operator for each recipe that starts from nothing, made from the table."""

import bpy
from bpy.props import IntProperty

from ...bridge.recipes import recipes
from ...bridge.shape import recipe_edit
from ...core.recipes.table import STARTING
from ...core.shape import starters
from .. import recipe_props, scene_tolerance
from . import new_shapes, reports
from .adding import AddShape, resolution_property


class _AddRecipe(AddShape):
    """`recipe` is what it adds."""

    recipe = None

    def execute(self, context):
        scene_tolerance.fill_from_scene(self, context, self.recipe)
        done = super().execute(context)
        words = recipes.read(context.object.data).said if done == {'FINISHED'} else ""
        return reports.finished(self, reports.Report(words)) if words else done

    def new_data(self, step):
        recipe = self.recipe
        values = recipe_props.typed(recipe, self)
        points = recipe.start_for(values) * self.size
        if recipe.has_any_count:
            points = _spread(points, self.count)
        return recipe_edit.new_data(recipe.label, recipe, values, points, new_shapes.start(self))

    def draw_shape(self, layout):
        for parameter in self.recipe.counting(self):
            layout.prop(self, parameter.name)
        if self.recipe.has_any_count:
            layout.prop(self, "count")
        new_shapes.draw(self, layout)

    def draw_size(self, layout):
        if self.recipe.points:
            layout.prop(self, "size")


def _spread(points, count):
    """This number of the points, or more on the curve y = 1 / (1 + 25 x²), Runge's, where they are not enough."""
    if count == len(points):
        return points
    return starters.runge(count) * abs(points).max()


def _class_for(recipe):
    annotations = {parameter.name: recipe_props.property_of(parameter, **scene_tolerance.options(parameter)) for parameter in recipe.parameters}
    annotations['resolution_u'] = resolution_property(default=recipe.resolution)
    if recipe.has_any_count:
        annotations['count'] = IntProperty(
            name="Points", description="How many; other than at first they lie on Runge's curve, 1 / (1 + 25 x²)",
            default=len(recipe.points), min=3, max=200, soft_max=32)
    name = f"SPLINEWRIGHT_OT_add_{recipe.kind}"
    faces = (new_shapes.Faces,) if recipe.is_surface else ()
    return type(name, (*faces, _AddRecipe, bpy.types.Operator), {
        'bl_idname': f"splinewright.add_{recipe.kind}", 'bl_label': f"Add {recipe.label}", 'button': recipe.label,
        'bl_description': recipe.description, 'recipe': recipe, '__annotations__': annotations, '__module__': __name__})


CLASSES = tuple(map(_class_for, STARTING))
