"""An operator for each recipe that makes a shape from selected objects, made from the table; Follow Object is its own."""

import bpy
from mathutils import Matrix

from ...bridge import derived, follow
from ...core.failures import FAILURES, sentence
from ...core.recipes.table import DERIVED, FOLLOW
from .. import recipe_props
from . import polls
from .adding import add_in_front, resolution_property


class _FromObjects:
    """`recipe` is what it makes, from the selected objects, the active one first."""

    bl_options = {'REGISTER', 'UNDO'}
    recipe = None

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        wanted = cls.recipe.inputs
        if len(_sources(context)) != len(wanted):
            cls.poll_message_set(f"Select {' and '.join(wanted)}")
            return False
        return True

    def execute(self, context):
        sources, recipe = _sources(context), self.recipe
        values, resolution = recipe_props.typed(recipe, self), (self.resolution_u, self.resolution_u)
        try:
            ob = follow.new_object(recipe, values, sources, resolution, context.evaluated_depsgraph_get())
        except FAILURES as error:
            self.report({'ERROR'}, f"{sources[0].name}: {sentence(error)}")
            return {'CANCELLED'}
        if recipe.is_beside:
            ob.matrix_world = ob.matrix_world @ _below(sources[0], ob)
        add_in_front(context, ob, sources)
        return {'FINISHED'}

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for parameter in self.recipe.parameters:
            layout.prop(self, parameter.name)
        layout.prop(self, "resolution_u", text="Resolution")


def _sources(context):
    """The selected objects that a shape can be made from, the active one first."""
    chosen = [ob for ob in context.selected_objects if derived.is_possible(ob)]
    return sorted(chosen, key=lambda ob: ob != context.object)


def _below(source, ob):
    """What moves a new object to where it lies under its source, in the source's x and y."""
    corners, own = ([[corner[axis] for corner in one.bound_box] for axis in range(3)] for one in (source, ob))
    gap = 0.3 * (max(own[1]) - min(own[1]))
    return Matrix.Translation((min(corners[0]) - min(own[0]), min(corners[1]) - gap - max(own[1]), 0.0))


def _class_for(recipe):
    annotations = {parameter.name: recipe_props.property_of(parameter) for parameter in recipe.parameters}
    annotations['resolution_u'] = resolution_property(default=recipe.resolution)
    return type(f"SPLINEWRIGHT_OT_add_{recipe.kind}", (_FromObjects, bpy.types.Operator), {
        'bl_idname': f"splinewright.add_{recipe.kind}", 'bl_label': recipe.label, 'bl_description': recipe.description,
        'recipe': recipe, '__annotations__': annotations, '__module__': __name__})


CLASSES = tuple(_class_for(recipe) for recipe in DERIVED if recipe is not FOLLOW)
