"""Shapes made from other objects, live."""

from ..meets import projecting
from ..verbs import verbs
from . import wanted
from .recipe import Parameter, Recipe, Result


def _follow(inputs):
    return Result(inputs[0])


def _projected(inputs, tolerance, cancel=None):
    curves, pieces = map(verbs.pieces_of, inputs)
    made = [projecting.curve_on(pieces, curve, tolerance, cancel) for curve in curves]
    values, errors = zip(*made)
    return Result(list(values) if len(values) > 1 else values[0], max(errors))


RECIPES = (
    Recipe("follow", "Live Copy", "A copy that follows the object, with its own transform", (), _follow, inputs=(wanted.ONE_OBJECT,)),
    Recipe("projected", "Project Curve",
           "The curve of the nearest points on a surface, within a tolerance; it follows the curve and the surface",
           (Parameter("tolerance", "Tolerance", "How far the curve may lie from the nearest points, in the scene", 0.001, 1e-9,
                      unit='LENGTH', of_scene=True),), _projected, resolution=24, inputs=(wanted.ONE_CURVE, wanted.ONE_SURFACE), is_measured=True,
           takes_cancel=True),
)
