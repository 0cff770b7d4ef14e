"""The parameters of recipes as Blender's properties show them, in float32. What counts is the recipe beside them.

They keep their numbers themselves, without get and set functions: keyed values Blender sets in threads of
its own, where it must not call Python.
"""

import contextlib

import numpy as np

from ...core.base import decimals
from ..data import settings


def of(data):
    """The PropertyGroup of a data-block."""
    return data.splinewright_parameters


def name_of(recipe, parameter):
    """The attribute of a parameter among those of all recipes."""
    return f"{recipe.kind}_{parameter.name}"


def list_name_of(recipe, parameter):
    """The attribute of the list of a parameter that is a text of numbers."""
    return f"{name_of(recipe, parameter)}_list"


def numbers_in(text, most):
    """{place: float32 number} of the words of a text that are numbers, of a given number of words at most."""
    found = {}
    for i, word in enumerate(_words(text)[:most]):
        with contextlib.suppress(ValueError):
            found[i] = decimals.single(float(word))
    return found


def with_numbers(text, given):
    """A text of numbers with others, {place: float32 number}, in places that it has. Numbers that are the same keep their digits."""
    words, shown = _words(text), numbers_in(text, None)
    others = {i: number for i, number in given.items() if i in shown and shown[i] != number}
    if not others:
        return text
    return " ".join(f"{decimals.typed(others[i]):.9g}" if i in others else word for i, word in enumerate(words))


def _words(text):
    return text.replace(",", " ").split()


def as_typed(parameter, value):
    """The value as the user typed it: of a float32 the shortest decimal that is it."""
    if not isinstance(parameter.default, float):
        return value
    if np.float32(value) == np.float32(parameter.default):
        return parameter.default
    angle = decimals.typed_angle(value)
    return angle if parameter.unit == 'ROTATION' and np.float32(angle) == np.float32(value) else decimals.typed(value)


def changes(recipe, values, group):
    """{name: value} of the parameters that a group of properties shows other than these values."""
    given = {parameter.name: getattr(group, name_of(recipe, parameter)) for parameter in recipe.parameters}
    return {parameter.name: as_typed(parameter, given[parameter.name]) for parameter in recipe.parameters
            if not _are_one(values[parameter.name], given[parameter.name])}


def _are_one(value, shown):
    return np.float32(value) == np.float32(shown) if isinstance(value, float) else value == shown


def show(data, recipe, values, frames=(), count=0):
    """Let the properties of a data-block show these values, the object that gives the place, if any, and a list of this length."""
    group = of(data)
    with settings.quiet(data):
        for parameter in recipe.parameters:
            name, value = name_of(recipe, parameter), values[parameter.name]
            if not group.is_property_set(name) or not _are_one(value, getattr(group, name)):
                setattr(group, name, value)
            if parameter.numbers:
                _show_list(group, list_name_of(recipe, parameter), numbers_in(value, parameter.numbers))
        frame = frames[0] if frames else None
        if group.frame != frame:
            group.frame = frame
        while len(group.inputs) < count:
            group.inputs.add()
        while len(group.inputs) > count:
            group.inputs.remove(count)
        if group.active_input >= count > 0:
            group.active_input = count - 1


def _show_list(group, name, numbers):
    shown = list(getattr(group, name))
    wanted = [numbers.get(i, number) for i, number in enumerate(shown)]
    if wanted != shown or not group.is_property_set(name):
        setattr(group, name, wanted)


def are_shown(data, recipe, count=0):
    """Whether show() ever was called for a data-block that is made from this number of objects. It was not in older files."""
    group = of(data)
    return (len(group.inputs) == (count if recipe.has_more else 0)
            and all(group.is_property_set(name_of(recipe, parameter)) for parameter in recipe.parameters)
            and all(group.is_property_set(list_name_of(recipe, parameter)) for parameter in recipe.parameters if parameter.numbers))
