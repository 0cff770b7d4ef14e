"""Conics (lecture row S10)."""

import math
from dataclasses import replace

from ..base.failures import Refusal
from ..base.library import sc
from ..deform import deformable
from .recipe import Parameter, Recipe, Result

_FORM = Parameter("form", "Form", "Which of the usual NURBS forms", "square", choices=(
    ("square", "Square", "Four quarters with their outer points on a square"),
    ("triangle", "Triangle", "Three thirds with their outer points on a triangle"),
    ("halves", "Halves", "Two halves, each with a point at infinity"),
    ("single", "Single", "One span of degree 5, all weights positive"),
    ("deformable", "Deformable", "No exact one: cubic, without weights and smooth everywhere, to be sculpted; within the tolerance")))
DEVIATION = Parameter("tolerance", "Tolerance", "How far a deformable one may lie from the exact one", 1e-3, 1e-9, unit='LENGTH',
                      where=("deformable", (True,)))
_OF_FORM = replace(DEVIATION, where=("form", ("deformable",)))

#: They are half diameters where the points do not lie at right angles.
_HALF_AXES = (("Half Axis A", "From the center to the first end, in units of the object; the end moves along it", 0, 1),
              ("Half Axis B", "From the center to the second end, in units of the object; the end moves along it", 0, 2))


def _by_weight(points, weight):
    return Result(sc.conics.conic_arc(*points, weight))


def _five_points(points):
    return _whole(sc.conics.through_points(points))


def _ellipse(points, form, tolerance):
    center, end_a, end_b = points
    if form == 'deformable':
        return Result(*deformable.ellipse(center, end_a - center, end_b - center, tolerance))
    return Result(sc.conics.ellipse(center, end_a - center, end_b - center, form))


def _hyperbola(points):
    center, vertex, end_b = points
    return Result(sc.conics.hyperbola(center, vertex - center, end_b - center))


def _foci(points, distance):
    return _whole(sc.conics.by_foci(*points, distance))


def _parabola(points):
    focus, first, second = points
    return _whole(sc.conics.parabola(focus, first, second - first))


def _equation(points, **coefficients):
    return _whole(sc.conics.ImplicitConic([coefficients[name] for name in "abcdef"]))


def _circle(points, radius, form, tolerance):
    if form == 'deformable':
        return Result(*deformable.ellipse((0, 0, 0), (radius, 0, 0), (0, radius, 0), tolerance))
    return Result(sc.conics.circle((0, 0, 0), radius, form=form))


def _arc(points, radius, start, sweep):
    return Result(sc.conics.arc((0, 0, 0), (radius, 0, 0), (0, radius, 0), start, sweep))


def _arc_by_points(points, by):
    make = {'through': sc.conics.arc_through, 'centre': sc.conics.arc_about,
            'tangent': lambda start, head, end: sc.conics.arc_from_tangent(start, head - start, end)}[by]
    return Result(make(*points))


_NOTHING = {'empty': "no real point", 'point': "one point only"}


def _whole(conic):
    curves = sc.conics.from_implicit(conic)
    if not curves:
        raise Refusal("no curve: the equation has {what}", what=_NOTHING.get(conic.type, conic.type))
    return Result(curves if len(curves) > 1 else curves[0])


RECIPES = (
    Recipe("conic", "Conic by Weight",
           "A conic arc from three points; the middle weight makes it an ellipse, a parabola or a hyperbola",
           (Parameter("weight", "Weight", "1 is a parabola, below 1 an ellipse, above 1 a hyperbola; below 0 the rest of it",
                      math.sqrt(0.5), -10.0, 10.0),),
           _by_weight, ((1, 0, 0), (1, 1, 0), (0, 1, 0)), is_endless=True),
    Recipe("five_points", "Conic Through Five Points", "The one conic through five points of a plane", (), _five_points,
           ((-1, 0, 0), (-0.5, 0.6, 0), (0.3, 0.7, 0), (1, 0.1, 0), (0.4, -0.6, 0)), is_endless=True),
    Recipe("ellipse", "Ellipse", "An ellipse by its center and the ends of two half diameters", (_FORM, _OF_FORM), _ellipse,
           ((0, 0, 0), (1, 0, 0), (0, 0.6, 0)), lengths=_HALF_AXES),
    Recipe("hyperbola", "Hyperbola", "Both branches by the center, a vertex and the end of the other half diameter", (),
           _hyperbola, ((0, 0, 0), (0.5, 0, 0), (0, 0.5, 0)), lengths=_HALF_AXES),
    Recipe("foci", "Conic by Foci", "The ellipse or hyperbola of points whose distances from two foci have one sum or difference",
           (Parameter("distance", "Sum, Difference", "More than the distance of the foci: an ellipse; less: a hyperbola",
                      2.5, 0.0, unit='LENGTH'),), _foci, ((-1, 0, 0), (1, 0, 0))),
    Recipe("parabola", "Parabola", "The points as far from a focus as from the line through two others", (), _parabola,
           ((0, 0.25, 0), (-1, -0.25, 0), (1, -0.25, 0)), is_endless=True),
    Recipe("equation", "Conic from Equation", "The conic of an implicit equation of degree 2 in x and y, by its six "
                                              "coefficients",
           tuple(Parameter(name, name, f"The factor of {term}", default) for name, term, default in (
               ("a", "x²", 1.0), ("b", "xy", 0.0), ("c", "y²", 4.0), ("d", "x", 0.0), ("e", "y", 0.0),
               ("f", "1", -1.0))), _equation),
    Recipe("circle", "Circle", "An exact circle in one of the usual NURBS forms, or a deformable one",
           (Parameter("radius", "Radius", "Distance from the middle", 1.0, 0.0, unit='LENGTH'), _FORM, _OF_FORM), _circle),
    Recipe("arc", "Circular Arc", "An exact arc of a circle",
           (Parameter("radius", "Radius", "Distance from the middle", 1.0, 0.0, unit='LENGTH'),
            Parameter("start", "Start", "Angle from the x axis", 0.0, unit='ROTATION'),
            Parameter("sweep", "Sweep", "Angle of the arc", math.pi / 2, -2 * math.pi, 2 * math.pi, unit='ROTATION')), _arc),
    Recipe("arc_by_points", "Arc by Points", "The arc of a circle given by three points",
           (Parameter("by", "By", "What the points are", "through", choices=(
               ("through", "Three Points", "Its start, a point on it, its end"),
               ("tangent", "Tangent", "Its start, where it goes from there, its end"),
               ("centre", "Center", "Its center, its start, and in which direction it ends: counterclockwise, seen from above"))),),
           _arc_by_points, ((1, 0, 0), (0.7, 0.7, 0), (0, 1, 0))),
)
