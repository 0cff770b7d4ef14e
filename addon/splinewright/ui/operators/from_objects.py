"""An operator for each recipe that makes a shape from selected objects, made from the table; Add Live Copy is its own."""

from contextlib import suppress

import bpy
import numpy as np
from bpy.props import BoolProperty, StringProperty
from mathutils import Matrix

from ...bridge.analysis import surveys
from ...bridge.follow import follow, recipe_results
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.recipes.table import DERIVED, FOLLOW
from .. import active_shape, recipe_props, scene_tolerance
from . import new_shapes, reports
from .adding import Repeatable, add_in_front, can_add, resolution_property
from .long_work import LongWork
from .pick_piece import draw_number

#: Kinds of recipes that are called by what they do.
_VERBS = ('revolve', 'extrude', 'projected', 'loft', 'sweep', 'two_rails', 'filling', 'surface_blend', 'matched', 'rounded_edge', 'offset_surface', 'thickened',
          'extended_surface', 'of_mesh', 'mirror')
#: Of parameters that mean something for one object only.
_MORE = {name: {'options': {'SKIP_SAVE'}} for name in ('piece', 'edges')}


class _FromObjects(LongWork, Repeatable):
    """`recipe` is what it makes, from the selected objects, the active one first."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    recipe = None

    @classmethod
    def poll(cls, context):
        if not can_add(cls, context):
            return False
        if cls.has_made(context):
            return True
        reason = cls._lacking(sources_of(context, cls.recipe))
        if reason:
            is_text = "curve" in reason and any(ob.type == 'FONT' for ob in context.selected_objects)
            cls.poll_message_set(say(phrase("{reason}: Convert to Splinewright turns a text into curves",
                                        reason=reason) if is_text else reason))
        return not reason

    @classmethod
    def _lacking(cls, sources):
        """The objects to select in place of these objects, or ""."""
        recipe = cls.recipe
        fits = recipe.takes(len(sources)) and all(is_wanted(ob, recipe.wanted_at(i)) for i, ob in enumerate(sources))
        if fits and 'edges' in recipe.defaults and len(sources) == 1 and _has_no_edge(sources[0]):
            return "Select two surfaces that meet, or one with an edge inside it"
        return "" if fits else phrase("Select {wanted}", wanted=phrase(recipe.wanted))

    def invoke(self, context, event):
        if 'piece' in self.recipe.defaults:
            active_shape.begin(self, sources_of(context, self.recipe))
        return self.called(context) if self.recipe.takes_cancel else self.execute(context)

    def tasks(self, context):
        sources = sources_of(context, self.recipe)
        if self._lacking(sources):
            raise Refusal(self._lacking(sources))
        self._settle(context, sources)
        return {'result': self._task(context, self._arranged(context, sources))}

    def _task(self, context, sources):
        space = follow.first_space(sources, context.evaluated_depsgraph_get())
        return recipe_results.work(self.recipe, recipe_props.typed(self.recipe, self), sources, space, self._frames(context))

    def _arranged(self, context, sources):
        """The objects in the order in which the recipe takes them at first. Raises Refusal."""
        if not self.recipe.arranged:
            return sources
        inputs = self._inputs(context, sources)
        return [sources[i] for i in self.recipe.arranged(inputs)]

    def _inputs(self, context, sources):
        return recipe_results.inputs_of(self.recipe, sources, follow.first_space(sources, context.evaluated_depsgraph_get()))

    def execute(self, context):
        sources, recipe = sources_of(context, self.recipe), self.recipe
        if self._lacking(sources):
            return reports.cancelled(self, self._lacking(sources))
        active_shape.forget_asked()
        if 'piece' in recipe.defaults and shape.has_shape(sources[0]):
            active_shape.note(self, 'piece', sources[0])
        new_shapes.fill_from_preferences(self)
        self._settle(context, sources)
        values, resolution = recipe_props.typed(recipe, self), new_shapes.start(self)
        try:
            sources = self._arranged(context, sources)
            result = self.result_of('result', self._task(context, sources))
            ob = follow.new_object(recipe, values, sources, resolution, context.evaluated_depsgraph_get(),
                                   self._frames(context), result)
        except FAILURES as error:
            return reports.failed(self, error, sources[0].name)
        if recipe.is_beside:
            space = follow.first_space(sources, context.evaluated_depsgraph_get())
            ob.matrix_world = ob.matrix_world @ _below(_corners(sources[0]) @ space.of(sources[0])[:3, :3].T, ob)
        add_in_front(context, ob, sources)
        if recipe.is_surface and self.hide_inputs:
            for source in sources[:recipe.covered(values)] if recipe.covered else sources:
                source.hide_set(True)
        said = new_shapes.said_of([ob], recipes.error(ob.data)) if recipe.is_measured else ""
        words = "; ".join(filter(None, (said, result.said)))
        return self.finished(context, reports.Report(words, warnings=tuple(filter(None, (result.warning,)))))

    def _settle(self, context, sources):
        """Find the values not given."""
        if self.recipe.frame and not self.properties.is_property_set('frame'):
            self.frame = _beside(context)
        scene_tolerance.fill_from_scene(self, context, self.recipe)
        self._follow()
        if self.recipe.first_values and not (self.recipe.frame and self.frame):
            self._suggest(sources, context)

    def _frames(self, context):
        """The object of which the place and axes count, if there is to be one, in a tuple. Raises Refusal."""
        if not self.recipe.frame or not self.frame:
            return ()
        frame = context.scene.objects.get(self.frame)
        if frame is None:
            raise Refusal("there is no object named {frame} in this scene", frame=self.frame)
        return (frame,)

    def _follow(self):
        """A number that is not given is as the one that it follows, if that is: one radius makes no cone."""
        is_given = self.properties.is_property_set
        for parameter in self.recipe.parameters:
            if parameter.follows and is_given(parameter.follows) and not is_given(parameter.name):
                setattr(self, parameter.name, getattr(self, parameter.follows))

    def _suggest(self, sources, context):
        """What cannot be read is refused where it is used."""
        with suppress(*FAILURES):
            inputs = self._inputs(context, sources)
            for name, value in self.recipe.first_values(inputs).items():
                if not self.properties.is_property_set(name):
                    setattr(self, name, value)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        if self.recipe.frame:
            layout.prop_search(self, "frame", context.scene, "objects")
        for parameter in self.recipe.counting(self):
            if parameter.name == 'piece':
                draw_number(layout, self, parameter.name)
            else:
                layout.prop(self, parameter.name)
        if self.recipe.is_surface:
            layout.prop(self, "hide_inputs")
        new_shapes.draw(self, layout)


def sources_of(context, recipe):
    """The selected objects that a shape can be made from: what the recipe wants first, and the active one, come first."""
    chosen = [ob for ob in context.selected_objects if recipe_results.can_make(recipe, ob)]
    return sorted(chosen, key=lambda ob: (not is_wanted(ob, recipe.inputs[0]), ob != context.object))


def is_wanted(ob, what):
    """Whether an object from which its shape can be made is what a recipe names: a curve, a surface, a point, or any."""
    return what.accepts({'CURVE': 'curve', 'EMPTY': 'point'}.get(ob.type, 'surface'))


def lacking(context, recipe):
    """The objects to select for a recipe that makes shapes from objects, or ""."""
    operator = next(cls for cls in CLASSES if cls.recipe is recipe)
    return operator._lacking(sources_of(context, recipe))


def _has_no_edge(ob):
    with suppress(*FAILURES):
        return shape.has_shape(ob) and 'add_rounded_edge' in surveys.refused(ob.data)
    return False


def _beside(context):
    """The name of the one selected object that no shape can be made from, or ""."""
    others = [ob for ob in context.selected_objects if not recipe_results.is_possible(ob)]
    return others[0].name if len(others) == 1 else ""


def _below(around, ob):
    """What moves a new shape to where it lies under these points (n, 3), in its own x and y."""
    own = shape.points_of(ob.data)
    gap = 0.3 * np.ptp(own[:, 1])
    x, y = around.min(axis=0)[:2] - (own[:, 0].min(), gap + own[:, 1].max())
    return Matrix.Translation((x, y, 0.0))


def _corners(ob):
    """(n, 3): points around an object; the box of a shape that was not drawn yet is stale."""
    return shape.points_of(ob.data) if shape.has_shape(ob) else np.array(ob.bound_box)


def _label(recipe):
    """What Undo History shows: a verb."""
    return recipe.label if recipe.kind in _VERBS else phrase("Add {label}", label=phrase(recipe.label))


def _class_for(recipe):
    annotations = {parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, scene_tolerance.options(parameter)))
                   for parameter in recipe.parameters}
    if recipe.frame:
        annotations['frame'] = StringProperty(name=recipe.frame, options={'SKIP_SAVE'}, description=(
            "Object that gives the axes in place of the profile; at first the one selected with the profile"))
    if recipe.is_surface:
        annotations['hide_inputs'] = BoolProperty(name="Hide Inputs", default=recipe.covers_inputs, options={'SKIP_SAVE'}, description=(
            "Hide the inputs, as H does; Show Inputs in the panel brings them back"))
    annotations['resolution_u'] = resolution_property(default=recipe.resolution)
    faces = (new_shapes.Faces,) if recipe.is_surface else ()
    return type(f"SPLINEWRIGHT_OT_add_{recipe.kind}", (*faces, _FromObjects, bpy.types.Operator), {
        'bl_idname': f"splinewright.add_{recipe.kind}", 'bl_label': _label(recipe), 'button': recipe.label, 'bl_description': recipe.description,
        'recipe': recipe, '__annotations__': annotations, '__module__': __name__})


CLASSES = tuple(_class_for(recipe) for recipe in DERIVED if recipe is not FOLLOW)
