"""Shapes that recipes make from numbers and points of their own."""

import numpy as np

from ..core import definition as definitions
from ..core.library import sc
from . import recipes, shape, store


def new_data(name, recipe, values, points, resolution):
    """A new Curve that a recipe makes of points. Raises ValueError or ArithmeticError."""
    made = recipe.make(points, **values)
    data = shape.new_data(name, made.value, resolution, around=points if recipe.is_endless else None)
    recipes.write_made(data, recipe, values, points, made.error)
    return data


def set_parameter(data, name, value):
    """Change one number or text of a recipe of points. Raises, and changes nothing, where nothing comes of it."""
    values = {**recipes.parameters(data), name: value}
    _remake(data, values, recipes.points(data))


def set_points(data, points):
    """Give a recipe other points (n, 3). Raises, and changes nothing, where nothing comes of it."""
    _remake(data, recipes.parameters(data), np.asarray(points, dtype=np.float64))


def _remake(data, values, points):
    recipe = recipes.of(data)
    made = recipe.make(points, **values)
    shape.set_definition(data, made.definition, around=points if recipe.is_endless else None)
    recipes.write_made(data, recipe, values, points, made.error)


def edited(data):
    """The definition that the net of a shape edits: its own, or the polygon of its recipe's points."""
    if not recipes.has_points(data):
        return store.read(data)
    points = recipes.points(data)
    knots = np.concatenate([[0.0], np.arange(len(points)), [len(points) - 1.0]])
    return definitions.from_value(sc.NurbsCurve(1, knots, points))


def follow_net(data, definition):
    """Take the polygon of a recipe's points from its net; whether the shape changed."""
    if (definition.pool[:, 3] != 1.0).any():
        raise ValueError("the points of this recipe have no weights: use Make Editable for that")
    points = definition.pool[definition.pieces[0].indices, :3]
    if np.array_equal(points, recipes.points(data)):
        return False
    set_points(data, points)
    return True
