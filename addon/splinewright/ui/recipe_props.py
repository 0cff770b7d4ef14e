"""The parameters of recipes in panels and operators, made from the table of recipes.

Numbers are kept in float64 beside the definition; properties only show and change them.
"""

from functools import partial

import bpy
import numpy as np
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, PointerProperty, StringProperty

from ..bridge.data import problems, settings
from ..bridge.follow import follow
from ..bridge.net import keyed
from ..bridge.recipes import parameters, recipes
from ..bridge.shape import recipe_edit
from ..core.base import decimals
from ..core.base.failures import FAILURES, Refusal, sentence
from ..core.base.words import phrase, say
from ..core.recipes.table import RECIPES
from . import fields, inputs_list, texts


def property_of(parameter, **more):
    """Blender's property for a parameter. more: what Blender's property functions take."""
    named = {'name': parameter.label, 'description': parameter.description, 'default': parameter.default, **more}
    if parameter.choices:
        return EnumProperty(items=parameter.choices, **named)
    if isinstance(parameter.default, bool):
        return BoolProperty(**named)
    if isinstance(parameter.default, str):
        return StringProperty(**named)
    if isinstance(parameter.default, int):
        return IntProperty(min=int(parameter.least), max=int(parameter.most), **named)
    return FloatProperty(min=parameter.least, max=parameter.most, unit=parameter.unit, precision=5, step=1, **named)


def typed(recipe, properties):
    """The values of a recipe's parameters, from an operator's properties."""
    return {parameter.name: parameters.as_typed(parameter, getattr(properties, parameter.name))
            for parameter in recipe.parameters}


def _updater(recipe, parameter):
    """What Blender calls when a user, or a script, has changed a property; never for keys and drivers."""
    name = parameters.name_of(recipe, parameter)

    def update(self, context):
        data = self.id_data
        if recipes.kind(data) == recipe.kind and not settings.is_quiet(data):
            _change(data, parameter.name, parameters.as_typed(parameter, getattr(self, name)))
    return update


def _list_property(recipe, parameter):
    """The numbers of a text as fields, each of which takes keys."""
    name = parameters.list_name_of(recipe, parameter)

    def update(self, context):
        data = self.id_data
        if recipes.kind(data) == recipe.kind and not settings.is_quiet(data):
            text = getattr(self, parameters.name_of(recipe, parameter))
            _change(data, parameter.name, parameters.with_numbers(text, dict(enumerate(getattr(self, name)))))
    return FloatVectorProperty(name=parameter.label, description="Takes keys and drivers", size=parameter.numbers,
                               precision=5, step=10, update=update)


def _change(data, name, value):
    """Change a parameter. Where nothing results the property shows again what it did. Blender calls this a second time for a number of
    a list, which then is what it was: that takes no sentence away."""
    try:
        if value == recipes.parameters(data)[name]:
            return
        keyed.set_parameters(data, {name: value})
        problems.set_problem(data, problems.SETTING, "")
    except FAILURES as error:
        problems.set_problem(data, problems.SETTING, sentence(error))
        recipes.show(data)


def _change_frame(self, context):
    """What Blender calls when a user, or a script, has chosen the object that gives the place."""
    data = self.id_data
    if settings.is_quiet(data) or not recipes.follows(data):
        return
    try:
        follow.set_frame(data, self.frame, bpy.context.evaluated_depsgraph_get())
        problems.set_problem(data, problems.SETTING, "")
    except FAILURES as error:
        problems.set_problem(data, problems.SETTING, sentence(error))
        recipes.show(data)


def _length_name(recipe, i):
    return f"{recipe.kind}_length_{i}"


def _length_property(recipe, label, description, first, last):
    """A length that points of a recipe have: nothing but them is kept, and it has no keys."""
    def get(self):
        points = _points_of(self.id_data)
        return float(np.linalg.norm(points[last] - points[first])) if points is not None else 0.0

    def put(self, length):
        points = _points_of(self.id_data)
        if points is not None:
            _change_points(self.id_data, points, first, last, decimals.typed(length))

    def _points_of(data):
        try:
            return recipes.points(data) if recipes.kind(data) == recipe.kind else None
        except FAILURES:
            return None                 # the panel says it
    return FloatProperty(name=label, description=description, min=0.0, unit='LENGTH', precision=5, step=1, get=get, set=put,
                         options=set())


def _change_points(data, points, first, last, length):
    """Let one point be so far from another."""
    away = points[last] - points[first]
    try:
        if not np.any(away):
            raise Refusal("the point lies where the other one is: move it in the net first")
        points = points.copy()
        points[last] = points[first] + away * (length / np.linalg.norm(away))
        recipe_edit.set_points(data, points)
        problems.set_problem(data, problems.SETTING, "")
    except FAILURES as error:
        problems.set_problem(data, problems.SETTING, sentence(error))


class SplinewrightInput(bpy.types.PropertyGroup):
    """A row of the list of what a surface is made from. What counts is the recipe."""


class SplinewrightRecipe(bpy.types.PropertyGroup):
    """Parameters of the recipe that makes a shape."""

    __annotations__ = {
        **{parameters.name_of(recipe, parameter): property_of(parameter, update=_updater(recipe, parameter))
           for recipe in RECIPES.values() for parameter in recipe.parameters},
        **{parameters.list_name_of(recipe, parameter): _list_property(recipe, parameter)
           for recipe in RECIPES.values() for parameter in recipe.parameters if parameter.numbers},
        **{_length_name(recipe, i): _length_property(recipe, *length)
           for recipe in RECIPES.values() for i, length in enumerate(recipe.lengths)},
        'inputs': CollectionProperty(type=SplinewrightInput, options=set()),
        'active_input': IntProperty(name="Active", description="The row that buttons beside the list move or remove", min=0, options=set()),
        'frame': PointerProperty(type=bpy.types.Object, name="About", update=_change_frame,
                                 description="Its place and axes count in place of the shape's own; the shape follows it")}


def draw(layout, data, is_net_out=False):
    """The parameters of the recipe that makes a data-block, if it has any.

    While its net is out only what the net shows can be changed: Edit Mode's undo would not bring the rest back.
    """
    stored = recipes.read(data)
    recipe = stored.recipe
    if not (recipe.parameters or recipe.lengths):
        return
    texts.draw_note(layout, recipe.label, icon='PROPERTIES')
    column = layout.column(align=True)
    if recipe.frame:
        row = fields.choice(column, parameters.of(data), 'frame', recipe.frame)
        row.operator("splinewright.axis_from_edge", text="", icon='EDGESEL')
    for i, _ in enumerate(recipe.lengths):
        row = column.row(align=True)
        row.enabled = not is_net_out
        fields.number(row.column(align=True), parameters.of(data), _length_name(recipe, i))
    for parameter in recipe.counting(parameters.of(data), partial(parameters.name_of, recipe)):
        row = column.row(align=True)
        row.enabled = not is_net_out or parameter.name == 'closed'
        name = parameters.name_of(recipe, parameter)
        if isinstance(parameter.default, str):
            row = fields.choice(row.column(align=True), parameters.of(data), name)
            if parameter.name == 'edges':
                row.operator("splinewright.round_here", text="", icon='EYEDROPPER')
        elif isinstance(parameter.default, bool):
            row.prop(parameters.of(data), name)
        else:
            fields.number(row.column(align=True), parameters.of(data), name)
        if parameter.numbers:
            _draw_list(column, data, recipe, parameter, is_net_out)
    if recipe.has_more:
        inputs_list.draw(layout, data, recipe)
    if stored.error:
        texts.draw_note(layout, phrase("Within {error:.1e} of the exact result", error=stored.error))
    if stored.said:
        texts.draw_note(layout, stored.said)
    if stored.warning:
        texts.draw_note(layout, stored.warning, icon='ERROR')


def _draw_list(layout, data, recipe, parameter, is_net_out):
    """A field for each number of a text."""
    group = parameters.of(data)
    grid = layout.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    grid.enabled = not is_net_out
    letter = 'v' if parameter.name.endswith('_v') else 'u'
    for i in parameters.numbers_in(getattr(group, parameters.name_of(recipe, parameter)), parameter.numbers):
        grid.prop(group, parameters.list_name_of(recipe, parameter), index=i, text=say(f"{letter}{i}"))


CLASSES = (SplinewrightInput, SplinewrightRecipe)


def register():
    for data in (bpy.types.Curve, bpy.types.Mesh):
        data.splinewright_parameters = PointerProperty(type=SplinewrightRecipe)


def unregister():
    for data in (bpy.types.Curve, bpy.types.Mesh):
        del data.splinewright_parameters
