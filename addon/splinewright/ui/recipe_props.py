"""The parameters of recipes in panels and operators, made from the table of recipes.

Numbers are kept in float64 beside the definition; properties only show and change them.
"""

import contextlib

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from ..bridge import keyed, problems, recipes, store
from ..core import decimals
from ..core.failures import FAILURES, sentence
from ..core.recipes.table import RECIPES


def property_of(parameter, options=None, **access):
    """Blender's property for a parameter. options: Blender's. access: get and set, where it keeps nothing itself."""
    named = {'name': parameter.label, 'description': parameter.description, **({'options': options} if options else {})}
    default = {} if access else {'default': parameter.default}
    if parameter.choices:
        return EnumProperty(items=parameter.choices, **named, **default, **access)
    if isinstance(parameter.default, bool):
        return BoolProperty(**named, **default, **access)
    if isinstance(parameter.default, str):
        return StringProperty(**named, **default, **access)
    if isinstance(parameter.default, int):
        return IntProperty(min=int(parameter.least), max=int(parameter.most), **named, **default, **access)
    return FloatProperty(min=parameter.least, max=parameter.most, unit=parameter.unit, precision=5, step=1,
                         **named, **default, **access)


def as_typed(parameter, value):
    """The value as the user typed it: of a float32 the shortest decimal that is it."""
    if not isinstance(parameter.default, float):
        return value
    if np.float32(value) == np.float32(parameter.default):
        return parameter.default
    return decimals.typed_angle(value) if parameter.unit == 'ROTATION' else decimals.typed(value)


def typed(recipe, properties):
    """The values of a recipe's parameters, from an operator's properties."""
    return {parameter.name: as_typed(parameter, getattr(properties, parameter.name)) for parameter in recipe.parameters}


def name_of(recipe, parameter):
    """The attribute of a parameter among those of all recipes."""
    return f"{recipe.kind}_{parameter.name}"


def _getter(recipe, parameter):
    def get(self):
        data = self.id_data
        value = parameter.default
        if recipes.kind(data) == recipe.kind:
            with contextlib.suppress(store.UnreadableDefinition):
                value = recipes.parameters(data)[parameter.name]
        return [choice[0] for choice in parameter.choices].index(value) if parameter.choices else value
    return get


def _setter(recipe, parameter):
    def set_it(self, value):
        data = self.id_data
        if recipes.kind(data) != recipe.kind:
            return
        value = parameter.choices[value][0] if parameter.choices else as_typed(parameter, value)
        if keyed.is_evaluating(data, parameter.name, value):
            return
        try:
            if value == recipes.parameters(data)[parameter.name]:
                return
            keyed.set_parameters(data, {parameter.name: value})
            problems.tell(data, problems.SETTING, "")
        except FAILURES as error:
            problems.tell(data, problems.SETTING, sentence(error))
    return set_it


class SplinewrightRecipe(bpy.types.PropertyGroup):
    """Parameters of the recipe that makes a shape."""

    __annotations__ = {
        name_of(recipe, parameter): property_of(parameter, get=_getter(recipe, parameter), set=_setter(recipe, parameter))
        for recipe in RECIPES.values() for parameter in recipe.parameters}


def draw(layout, data, is_net_out=False):
    """The parameters of the recipe that makes a data-block, if it has any.

    While its net is out only what the net shows can be changed: Edit Mode's undo would not bring the rest back.
    """
    recipe = recipes.of(data)
    if not recipe.parameters:
        return
    layout.label(text=recipe.label, icon='PROPERTIES')
    column = layout.column(align=True)
    for parameter in recipe.parameters:
        row = column.row(align=True)
        row.enabled = not is_net_out or parameter.name == 'closed'
        row.prop(data.splinewright_parameters, name_of(recipe, parameter))
    error = recipes.error(data)
    if error:
        layout.label(text=f"Within {error:.1e} of what is asked for", icon='INFO')


CLASSES = (SplinewrightRecipe,)


def register():
    for data in (bpy.types.Curve, bpy.types.Mesh):
        data.splinewright_parameters = PointerProperty(type=SplinewrightRecipe)


def unregister():
    for data in (bpy.types.Curve, bpy.types.Mesh):
        del data.splinewright_parameters
