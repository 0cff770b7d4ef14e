"""Shapes that recipes make from their numbers and points."""

from contextlib import suppress

import numpy as np

from ...core.base.failures import FAILURES, Refusal
from ...core.base.library import sc
from ...core.base.words import phrase
from ...core.recipes.table import RECIPES
from ...core.shape import definition as definitions
from ..cage import free_net
from ..curve import curve_layers
from ..data import store
from ..recipes import recipes
from . import shape

#: By how much of its size two shapes may differ that are one: a map that is known by points in single precision is no nearer.
_NEAR = 1e-5


def new_data(name, recipe, values, points, resolution, result=None, progress=shape.no_progress):
    """A new Curve that a recipe makes of points. result: what it makes, where that is known; progress: as of shape.new_data().
    Raises Refusal or an error of the library."""
    result = result or recipe.make(points, **values)
    data = shape.new_data(name, result.definition, resolution, progress, points if recipe.is_endless else None)
    curve_layers.thicken(data, recipe.thickness)
    recipes.write_made(data, recipe, values, points, result)
    return data


def set_parameters(data, changes):
    """Change parameters of a recipe of points, by name. Raises, and changes nothing, if it cannot be made."""
    _remake(data, {**recipes.parameters(data), **changes}, recipes.points(data))
    held = free_net.editing(data)
    if held is not None and 'closed' in changes:
        free_net.set_closed(held, changes['closed'])
    if held is not None:
        held.update_tag()               # points that were refused may fit now


def set_points(data, points):
    """Give a recipe other points (n, 3). Raises, and changes nothing, if it cannot be made."""
    _remake(data, recipes.parameters(data), np.asarray(points, dtype=np.float64))


def end(data):
    """Drop the recipe of a shape. Returns a sentence about what would not be right without it and is left out, or "". Raises Refusal,
    and changes nothing, if it cannot be done."""
    shape.require_writable(data)
    recipe = RECIPES.get(recipes.kind(data))
    before = store.read(data) if recipe and recipe.applied else None
    left = before and recipe.applied(before)
    if left is None or len(left.pieces) == len(before.pieces):
        recipes.remove(data)
        return ""
    shape.set_definition(data, left)
    recipes.remove(data)
    return phrase("{name} keeps its curve and the plane: rays, polygons and marks would not follow the curve; rays of a Perspective Image do",
                  name=data.name)


def take_along(data, matrix, moved):
    """Whether the recipe of a shape can make what an affine map (4, 4) makes of it, with its points moved and its lengths
    scaled; then it does."""
    stored = recipes.read(data)
    size = moved.spread / store.read(data).spread
    lengths = {each.name: stored.values[each.name] * size for each in stored.recipe.parameters if each.unit == 'LENGTH'}
    points = stored.points @ matrix[:3, :3].T + matrix[:3, 3]
    for values in (stored.values, {**stored.values, **lengths}):
        with suppress(*FAILURES):
            result = stored.recipe.make(points, **values)
            if result.definition.is_near(moved, _NEAR):
                _remake(data, values, points)
                return True
    return False


def _remake(data, values, points):
    recipe = recipes.of(data)
    result = recipe.make(points, **values)
    shape.set_definition(data, result.definition, around=points if recipe.is_endless else None)
    recipes.write_made(data, recipe, values, points, result)


def edited(data):
    """The definition that the net of a shape edits: its own, or the polygon of its recipe's points."""
    if not recipes.has_points(data):
        return store.read(data)
    points = recipes.points(data)
    knots = np.concatenate([[0.0], np.arange(len(points)), [len(points) - 1.0]])
    return definitions.from_value(sc.NurbsCurve(1, knots, points))


def takes_any_count(data):
    """Whether the net of a shape may gain and lose points."""
    return recipes.has_points(data) and recipes.of(data).can_gain_points


def is_closed(data):
    """Whether the recipe of a shape goes back to its first point."""
    return recipes.of(data).can_close and recipes.parameters(data)['closed']


def follow_net(data, definition):
    """Take the polygon of a recipe's points from its net; whether the shape changed."""
    _require_no_weights(definition.pool[:, 3])
    points = definition.pool[definition.pieces[0].indices, :3]
    if np.array_equal(points, recipes.points(data)):
        return False
    set_points(data, points)
    return True


def follow_points(data, net, is_turned):
    """Take points, and whether they are closed, from a net that gains and loses points; whether the shape changed.

    is_turned: whether the direction of the net was switched, which turns no groups over.
    """
    if not takes_any_count(data):
        raise Refusal("the shape is made in another way since its net came: leave the net")
    recipe, spline = recipes.of(data), free_net.require_one_polygon(net)
    _require_no_weights(net.weights)
    if spline.closed and not recipe.can_close:
        raise Refusal("{label} cannot be closed: open its net (Toggle Cyclic), the shape waits", label=phrase(recipe.label))
    if spline.count < 2:
        raise Refusal("a curve needs two points: the shape waits for more")
    points = net.positions[::-1] if recipe.has_groups and is_turned else net.positions
    if spline.closed == is_closed(data) and np.array_equal(points, recipes.points(data)):
        return False
    closed = {'closed': spline.closed} if recipe.can_close else {}
    _remake(data, {**recipes.parameters(data), **closed}, points)
    return True


def _require_no_weights(weights):
    if (weights != 1.0).any():
        raise Refusal("the points of this recipe have no weights: use Apply Construction for that")
