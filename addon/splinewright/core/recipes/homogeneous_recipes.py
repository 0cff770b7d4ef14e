"""Rational curves and the curves in homogeneous coordinates that they are images of, live in both directions."""

from ..formulas import homogeneous, teaching
from . import wanted
from .curve_recipes import formula_of
from .recipe import Parameter, Recipe, Result
from .teaching_recipes import PIECE, of_parts

_HEIGHT = Parameter("height", "Height", "Of the plane W = 1 above 0; below 0 it lies under it", 1.0, unit='LENGTH')
_PLANE_AT = Parameter("base", "Plane of Curve", "Which W lies in the plane of the curve", "one", choices=(
    ("one", "W = 1", "The curve is the image, 0 lies below it"), ("zero", "W = 0", "0 is the origin of the curve: z is W times the height")))
_START = Parameter("factor_start", "Factor at Start", "All coordinates are multiplied by a linear function, which changes no image", 1.0, 1e-6, 1e6)
_END = Parameter("factor_end", "Factor at End", "All coordinates are multiplied by a linear function, which changes no image", 1.0, 1e-6, 1e6)
_FACTOR = Parameter("factor", "Polynomial Factor", "A polynomial in the parameter t of the curve, of degree 4 or less, such as 1 + t^2", "1")
_MARKER = Parameter("marker", "Marker", "Radius of the marks at points; 0 for none", 0.03, 0.0, unit='LENGTH')
_POLYGONS = Parameter("polygons", "Polygons", "Of both curves", True)
_PLANE = Parameter("plane", "Plane and Axis", "A grid on the plane W = 1, and the axis of W", True)
_RAYS = Parameter("rays", "Rays", "From 0 through each control point", True)
_CONE = Parameter("cone", "Cone", "In how many equal steps of the parameter there are rays through the curve; 0 for none", 24, 0, 500)


def _lift(inputs, piece, height, base, factor, factor_start, factor_end, marker, polygons, plane, rays, cone):
    curve = teaching.curve_of(inputs[0], piece).to_nurbs()
    curve = homogeneous.multiplied_by(curve, homogeneous.factor_of(formula_of("a", factor, ("t",), {}), curve.domain))
    curve = homogeneous.multiplied(curve, factor_start, factor_end)
    return of_parts(homogeneous.picture(curve, homogeneous.space_of(height, base == 'one'), marker, polygons, plane, rays, cone))


def _perspective(inputs, x, y, z, plane, rays, cone):
    curves = teaching.curves_of(inputs[0])
    is_wanted = [piece.name == homogeneous.CURVE for piece in inputs[0].pieces]
    chosen = [curve for curve, this in zip(curves, is_wanted) if this or not any(is_wanted)]
    if rays or cone:
        return of_parts([part for curve in chosen for part in homogeneous.seen(curve.to_nurbs(), (x, y, z), plane, rays, cone)])
    images = [homogeneous.image(curve.to_nurbs(), (x, y, z), plane) for curve in chosen]
    return Result(images if len(images) > 1 else images[0])


def _view(inputs):
    return homogeneous.view_of(inputs[0]) if inputs[0].has_curves else {}


RECIPES = (
    Recipe("lift", "Homogeneous Curve",
           "The curve (X, Y, W) that a rational curve is the image of, with rays and plane W = 1",
           (_HEIGHT, _PLANE_AT, _FACTOR, _START, _END, _MARKER, _POLYGONS, _RAYS, _CONE, _PLANE, PIECE), _lift, thickness=0.004,
           inputs=(wanted.ONE_CURVE,), applied=homogeneous.applied),
    Recipe("perspective", "Perspective Image",
           "The rational curve in a plane that a curve in space stands for, as seen from a point",
           (Parameter("x", "Eye X", "Of the point that the curve is seen from", 0.0, unit='LENGTH'),
            Parameter("y", "Eye Y", "Of the point that the curve is seen from", 0.0, unit='LENGTH'),
            Parameter("z", "Eye Z", "Of the point that the curve is seen from", -1.0, unit='LENGTH'),
            Parameter("plane", "Plane Z", "The height of the plane of the image", 0.0, unit='LENGTH'),
            Parameter("rays", "Rays", "From the eye through each control point and its image", False),
            Parameter("cone", "Cone", _CONE.description, 0, 0, 500)), _perspective,
           inputs=(wanted.ONE_CURVE,), first_values=_view),
)
