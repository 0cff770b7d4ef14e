"""Shapes made from other objects, live."""

from ..formulas import teaching
from ..meets import projecting
from ..verbs import verbs
from . import wanted
from .recipe import Parameter, Recipe, Result

_PIECE = Parameter("piece", "Piece", "Which curve of the object, counted from 1", 1, 1)
_SCHEME = Parameter("scheme", "Scheme", "Which points are shown", "de_boor", choices=(
    ("de_boor", "de Boor", "On the knots of the curve: every corner cut is a knot inserted"),
    ("casteljau", "de Casteljau", "Of the Bezier curve in the span, homogeneous: it never breaks"),
    ("rational", "de Casteljau, rational", "Of the Bezier curve in the span, with weights in every step: "
     "it breaks where one is zero")))


def _follow(inputs):
    return Result(inputs[0])


def _basis(inputs, piece, width, height):
    return Result(teaching.basis_graphs(teaching.nurbs_of(inputs[0], piece).knot_vector, width, height))


def _construction(inputs, piece, position, scheme, marker):
    return Result(teaching.construction(teaching.nurbs_of(inputs[0], piece), position, scheme, marker))


def _projected(inputs, tolerance, cancel=None):
    curves, pieces = map(verbs.pieces_of, inputs)
    made = [projecting.curve_on(pieces, curve, tolerance, cancel) for curve in curves]
    values, errors = zip(*made)
    return Result(list(values) if len(values) > 1 else values[0], max(errors))


RECIPES = (
    Recipe("follow", "Live Copy", "A copy that follows the object, with its own transform", (), _follow, inputs=(wanted.ONE_OBJECT,)),
    Recipe("basis", "Basis Functions",
           "The graphs of the basis functions of a curve, exact, on its knots; they follow when the knots change",
           (Parameter("width", "Width", "From the first to the last knot", 2.0, 1e-3, unit='LENGTH'),
            Parameter("height", "Height", "Of the value 1", 1.0, unit='LENGTH'), _PIECE),
           _basis, resolution=16, inputs=(wanted.ONE_CURVE,), is_beside=True),
    Recipe("construction", "Construction of a Point",
           "The polygons by which a point of a curve is found; they follow when the curve is edited",
           (Parameter("position", "Position", "0 is the start of the curve, 1 its end", 0.5, 0.0, 1.0), _SCHEME,
            Parameter("marker", "Marker", "Radius of a circle around the point; 0 for none", 0.03, 0.0, unit='LENGTH'),
            _PIECE),
           _construction, inputs=(wanted.ONE_CURVE,)),
    Recipe("projected", "Project Curve",
           "The curve of the nearest points on a surface, within a tolerance; it follows the curve and the surface",
           (Parameter("tolerance", "Tolerance", "How far the curve may lie from the nearest points, in the scene", 0.001, 1e-9,
                      unit='LENGTH', of_scene=True),), _projected, resolution=24, inputs=(wanted.ONE_CURVE, wanted.ONE_SURFACE), is_measured=True,
           takes_cancel=True),
)
