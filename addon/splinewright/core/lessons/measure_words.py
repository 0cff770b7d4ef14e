"""Measures in words, as a sentence about a lesson's question names them: weight of point 1 of arc."""

from ..base.words import phrase
from ..recipes.table import RECIPES
from .lesson import Measure
from .measures import measured

_AXES = "xyz"
#: By the kind of a measure; what it takes fills them, and {axis} where there is one for each.
_PATTERNS = {
    **dict.fromkeys(_AXES, "coordinate {axis} of {shape} at {at}"),
    **{f"point_{axis}": "coordinate {axis} of point {index} of {shape}" for axis in _AXES},
    'weight': "weight of point {index} of {shape}",
    'count': "number of control points of {shape}",
    'degree': "degree of {shape}",
    'length': "length of {shape}",
    'multiplicity': "multiplicity of the knot {at} of {shape}",
    'c': "parametric continuity of {shape} at {at}",
    'g': "geometric continuity of {shape} at {at}",
    'gap': "gap of {shape} at {at}",
    'angle': "angle of {shape} at {at}",
    'curvature': "curvature of {shape} at {at}",
    'speed': "speed of {shape} at {at}",
    'jump': "jump of derivative {order} of {shape} at {at}",
    'basis': "basis function {index} of {shape} at {at}",
    'distance': "distance of {shape} to {to}",
    **{f"{where}_c": "parametric continuity of {shape} to {to}" for where in ('joint', 'seam')},
    **{f"{where}_g": "geometric continuity of {shape} to {to}" for where in ('joint', 'seam')},
    **{f"{where}_gap": "gap of {shape} to {to}" for where in ('joint', 'seam')},
    **{f"{where}_angle": "angle of {shape} to {to}" for where in ('joint', 'seam')},
    'seam_bend': "difference of the curvatures of {shape} and {to}",
    **{f"low_{axis}": "lowest {axis} of {shape}" for axis in _AXES},
    **{f"high_{axis}": "highest {axis} of {shape}" for axis in _AXES},
    'self_intersections': "number of self-intersections of {shape}",
    'setting': "{label} of {name}",
    'faces': "number of faces of {shape}",
    'facet_distance': "distance of the facets from {shape}",
    'start': "first parameter of {shape}",
    'end': "last parameter of {shape}",
    'knot': "knot {index} of {shape}",
    'closed': "closedness of {shape}",
    'corners': "number of corners of {shape}",
    'area': "area of {shape}",
    'eccentricity': "eccentricity of {shape}",
    'energy': "bending energy of {shape}",
    'influence': "influence of point {index} of {shape}",
    'away': "part of {shape} that lies off {to}",
    'arcs': "number of finite arcs of {shape}",
    **{f"surface_{axis}": "coordinate {axis} of {shape} at {at}, {at_v}" for axis in _AXES},
    **{f"normal_{axis}": "coordinate {axis} of the normal of {shape} at {at}, {at_v}" for axis in _AXES},
}


def named(measure, shapes):
    """A Measure in words; shapes: {name: measures.Shown}. Raises what measured() raises."""
    given, pattern = measure.arguments, _PATTERNS[measure.kind]
    if measure.kind == 'setting':
        shown = shapes.get(measure.shape)
        return phrase(pattern, label=_label(given['name'], shown.settings if shown else {}), name=measure.shape)
    shape = phrase("{shape}, piece {piece},", shape=measure.shape, piece=given['piece']) if 'piece' in given else measure.shape
    numbers = {name: number(given[name], shapes) for name in ('at', 'at_v', 'index', 'order') if name in given}
    others = {'to': given['to']} if 'to' in given else {}
    axis = {'axis': measure.kind[-1]} if "{axis}" in pattern else {}
    return phrase(pattern, shape=shape, **numbers, **others, **axis)


def number(value, shapes):
    """A number, or that of a Measure, in four digits."""
    return f"{(measured(value, shapes) if isinstance(value, Measure) else value) + 0.0:.4g}"


def _label(name, settings):
    """What the panel calls a setting of the recipe that has exactly these settings."""
    labels = {parameter.label for recipe in RECIPES.values() if recipe.defaults.keys() == settings.keys()
              for parameter in recipe.parameters if parameter.name == name}
    return phrase(labels.pop()) if len(labels) == 1 else name.replace("_", " ")
