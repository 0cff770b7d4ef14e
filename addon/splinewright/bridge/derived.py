"""What a recipe makes from other objects, as they are now."""

import numpy as np

from ..core import definition as definitions
from ..core import transform
from . import shape, store
from .native import read_native


def made(recipe, values, sources, owner, depsgraph):
    """What a recipe makes from objects, in the space of the object `owner`. Raises ValueError or ArithmeticError."""
    inverse = _matrix(owner, depsgraph).inverted_safe()
    inputs = []
    for source in sources:
        into = np.array(inverse @ _matrix(source, depsgraph))
        inputs.append(transform.transformed(_definition_of(source, depsgraph), into))
    return recipe.make(inputs, **values)


def is_possible(ob):
    """Whether a shape can be made from an object."""
    return ob is not None and (ob.type in ('CURVE', 'SURFACE') or shape.has_shape(ob))


def not_followed(source):
    """What of an object has no effect on what follows it: short sentences."""
    return [] if shape.has_shape(source) else read_native.not_followed(source)


def _definition_of(source, depsgraph):
    """What an object is now, in its own space. Raises ValueError if it shows nothing."""
    if shape.has_shape(source):
        return store.read(source.data)
    if not is_possible(source):
        raise ValueError(f"{source.name} is no curve, surface or Splinewright shape")
    reading = read_native.read(source, depsgraph)
    if reading.value is None:
        raise ValueError(f"{source.name} shows nothing that could be followed")
    return definitions.from_value(reading.value)


def _matrix(ob, depsgraph):
    return ob.evaluated_get(depsgraph).matrix_world
