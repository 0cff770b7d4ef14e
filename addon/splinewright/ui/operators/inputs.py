"""What a surface is made from, where that is any number of curves: their order, their directions, more and fewer of them."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ...bridge.data import store
from ...bridge.follow import follow, recipe_results
from ...bridge.recipes import parameters, recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import say
from ...core.surfaces import sections
from . import polls, reports
from .from_objects import is_wanted
from .selected import OnFollowers


def takes_more(ob):
    """Whether an object is a shape that is made from any number of others."""
    if ob is None or not shape.has_shape(ob) or not recipes.follows(ob.data):
        return False
    try:
        return recipes.of(ob.data).has_more
    except store.UnreadableDefinition:
        return False


class _OnInputs:
    """Changes the list of what the active shape is made from."""

    bl_options = {'REGISTER', 'UNDO'}

    index: IntProperty(name="Number", description="Which of those that it is made from, counted from 0", min=0,
                       options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not takes_more(context.object):
            cls.poll_message_set(say("Select a surface that is made from any number of curves"))
            return False
        return True

    def execute(self, context):
        data = context.object.data
        try:
            stored = recipes.read(data)
            inputs = self.changed(context, list(zip(stored.sources, stored.turned)))
            follow.set_inputs(data, *zip(*inputs), context.evaluated_depsgraph_get())
        except FAILURES as error:
            return reports.failed(self, error, context.object.name)
        return reports.finished(self, reports.Report())

    def require(self, inputs):
        if self.index >= len(inputs):
            raise Refusal("it is made from {count} objects, there is none of number {index}",
                          "it is made from {count} object, there is none of number {index}", count=len(inputs), index=self.index + 1)


class SPLINEWRIGHT_OT_move_input(_OnInputs, bpy.types.Operator):
    bl_idname = "splinewright.move_input"
    bl_label = "Move Input"
    bl_description = "Move it one place up or down in the order"

    way: EnumProperty(name="Way", items=[('UP', "Up", "Before the one above it"), ('DOWN', "Down", "After the one below it")],
                      options={'SKIP_SAVE'})

    def changed(self, context, inputs):
        self.require(inputs)
        to = self.index + (-1 if self.way == 'UP' else 1)
        if not 0 <= to < len(inputs):
            raise Refusal("it is the first one" if to < 0 else "it is the last one")
        inputs.insert(to, inputs.pop(self.index))
        parameters.of(context.object.data).active_input = to
        return inputs


class SPLINEWRIGHT_OT_turn_input(_OnInputs, bpy.types.Operator):
    bl_idname = "splinewright.turn_input"
    bl_label = "Flip Direction"
    bl_description = "Reverse its direction"

    def changed(self, context, inputs):
        self.require(inputs)
        source, is_turned = inputs[self.index]
        inputs[self.index] = source, not is_turned
        return inputs


class SPLINEWRIGHT_OT_remove_input(_OnInputs, bpy.types.Operator):
    bl_idname = "splinewright.remove_input"
    bl_label = "Remove from List"
    bl_description = "Leave this curve out of the surface; the curve itself stays"

    def changed(self, context, inputs):
        self.require(inputs)
        del inputs[self.index]
        return inputs


class SPLINEWRIGHT_OT_add_inputs(_OnInputs, bpy.types.Operator):
    bl_idname = "splinewright.add_inputs"
    bl_label = "Add Selected"
    bl_description = "Make the surface from the other selected objects, too, each where it belongs along those in the list"

    def changed(self, context, inputs):
        known = {source for source, _ in inputs}
        recipe = recipes.of(context.object.data)
        wanted = recipe.wanted_at(len(inputs))
        new = [ob for ob in context.selected_objects
               if ob != context.object and ob not in known and recipe_results.can_make(recipe, ob) and is_wanted(ob, wanted)]
        if not new:
            raise Refusal("select others beside it that are not in the list")
        both = inputs + [(ob, False) for ob in new]
        order = _arranged(context, both)
        return [both[i] for i in sections.with_new(order, len(inputs))] if order else both


def _arranged(context, inputs):
    """The order of inputs that their recipe takes at first, as numbers from 0, or none where it has none. Raises Refusal."""
    recipe, sources = recipes.of(context.object.data), [source for source, _ in inputs]
    if not recipe.arranged:
        return []
    if None in sources:
        raise Refusal("an object it is made from was deleted: leave it out first")
    return recipe.arranged(recipe_results.inputs_of(recipe, sources, follow.first_space(sources, context.evaluated_depsgraph_get())))


class _Ordering(_OnInputs):
    """Changes the order of those that have one."""

    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not recipes.of(context.object.data).arranged:
            cls.poll_message_set(say("The order of its curves does not count"))
            return False
        return True


class SPLINEWRIGHT_OT_sort_inputs(_Ordering, bpy.types.Operator):
    bl_idname = "splinewright.sort_inputs"
    bl_label = "Sort"
    bl_description = "Take the curves in the order in which they lie one behind the other, or along the rail"

    def changed(self, context, inputs):
        return [inputs[i] for i in _arranged(context, inputs)]


class SPLINEWRIGHT_OT_reverse_inputs(_Ordering, bpy.types.Operator):
    bl_idname = "splinewright.reverse_inputs"
    bl_label = "Reverse Order"
    bl_description = "Take the curves from the last to the first; rails stay before them"

    def changed(self, context, inputs):
        fixed = recipes.of(context.object.data).fixed
        return [*inputs[:fixed], *inputs[fixed:][::-1]]


class SPLINEWRIGHT_OT_show_inputs(OnFollowers, bpy.types.Operator):
    bl_idname = "splinewright.show_inputs"
    bl_label = "Show Inputs"
    bl_description = "Show or hide the objects that the shape is made from, as H does"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    how: EnumProperty(name="How", items=[('SHOW', "Show", "They are seen"), ('HIDE', "Hide", "They are not seen")])

    @property
    def done(self):
        return "Showed the inputs of {what}" if self.how == 'SHOW' else "Hid the inputs of {what}"

    def work(self, context, ob):
        for source in recipes.pointers(ob.data):
            if context.view_layer.objects.get(source.name) == source:
                source.hide_set(self.how == 'HIDE')


CLASSES = (SPLINEWRIGHT_OT_move_input, SPLINEWRIGHT_OT_turn_input, SPLINEWRIGHT_OT_remove_input, SPLINEWRIGHT_OT_add_inputs,
           SPLINEWRIGHT_OT_sort_inputs, SPLINEWRIGHT_OT_reverse_inputs, SPLINEWRIGHT_OT_show_inputs)
