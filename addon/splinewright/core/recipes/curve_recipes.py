"""Curves through points (lecture rows S3, S5) and from formulas (S1)."""

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from .recipe import Parameter, Recipe, Result

_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the curve may lie from the formulas", 1e-6, 1e-12, unit='LENGTH')
SPACING = Parameter("parametrisation", "Spacing", "How the parameters of the points are spaced", "centripetal", choices=(
    ("uniform", "Uniform", "One apart"),
    ("centripetal", "Centripetal", "By the square roots of the distances: no loops where points crowd"),
    ("chordal", "Chordal", "By the distances")))
_ENDS = Parameter("ends", "Ends", "The direction at an open end", "parabola", choices=(
    ("parabola", "Parabola", "Of the parabola through three points"), ("chord", "Chord", "Towards the next point"),
    ("natural", "Natural", "Without curvature")), where=("closed", (False,)))
_CLOSED = Parameter("closed", "Closed", "Go back to the first point", False)
_TENSION = Parameter("tension", "Tension", "0 is Catmull-Rom; 1 makes corners at all points", 0.0, -5.0, 5.0)
_DEGREE = Parameter("degree", "Degree", "Of the pieces between knots; of few points it is lower", 3, 1, 9)
_KNOTS = Parameter("knots", "Knots", "Where an open curve has its knots", "averaged", choices=(
    ("averaged", "Averaged", "Averages of the points' parameters: safe with any spacing"),
    ("not_a_knot", "Not a Knot", "At the points, but for those next to the ends"),
    ("natural", "Natural", "At the points; straight at both ends: odd degrees"),
    ("typed", "Typed", "As they are typed")), where=("closed", (False,)))
_KNOT_VALUES = Parameter("knot_values", "Knot Values", "All knots, between spaces, from 0 to 1: as many as points and derivatives, and degree + 1 more", "", where=("knots", ("typed",)))
_START_AT = Parameter("start_derivative", "Derivative at Start", "x y z of an open curve, by parameters from 0 to 1; none where it is empty", "",
                      where=("closed", (False,)))
_END_AT = Parameter("end_derivative", "Derivative at End", "x y z of an open curve, by parameters from 0 to 1; none where it is empty", "",
                    where=("closed", (False,)))
WAVE = ((-1, 0, 0), (-0.5, 0.5, 0), (0, -0.3, 0), (0.5, 0.5, 0), (1, 0, 0))
_FORMULAS = (
    Parameter("x", "x(t)", "Numbers, t, pi, e, + - * / ^ and functions such as sin, exp, sqrt", "cos(3*t)"),
    Parameter("y", "y(t)", "As x", "sin(2*t)"), Parameter("z", "z(t)", "As x", "0"),
    Parameter("start", "Start", "First t", 0.0), Parameter("end", "End", "Last t", 2 * np.pi),
    Parameter("constants", "Constants", "Numbers that you name: a = 2, b = pi/3", ""))


#: Points, each followed by the heads of its derivatives.
_ZIGZAG = ((-1, 0, 0), (-0.5, 2, 0), (0, 0, 0), (0.5, -2, 0), (1, 0, 0), (1.5, 2, 0), (1, 1, 0), (1, -1, 0), (1, 0, 1),
           (1, 0, -1), (1, 1, 1), (1, -1, -1))


def _catmull_rom(points, parametrisation, tension, closed, ends):
    return Result(sc.build.catmull_rom(points, parametrisation, tension, closed, ends))


def _kochanek_bartels(points, tension, continuity, bias, parametrisation, closed, ends):
    return Result(sc.build.kochanek_bartels(points, tension, continuity, bias, parametrisation, closed, ends))


#: A polynomial that misses its points by more than this part of their extent is none of use.
_MOST_MISSED = 1e-3


_AT_START = ("the derivative at the start has {count} numbers: it takes 3", "the derivative at the start has {count} number: it takes 3")
_AT_END = ("the derivative at the end has {count} numbers: it takes 3", "the derivative at the end has {count} number: it takes 3")


def _interpolating(points, degree, parametrisation, knots, closed, knot_values="", start_derivative="", end_derivative=""):
    given = {} if closed else {'start': _vector(start_derivative, _AT_START), 'end': _vector(end_derivative, _AT_END)}
    given = {name: vector for name, vector in given.items() if vector is not None}
    most = len(points) if closed else degree if knots == 'natural' else len(points) + len(given) - 1
    degree, parameters = min(degree, most), parametrisation
    if given or knots == 'typed' and not closed:
        parameters = _spacing(points, parametrisation)
    if knots == 'typed' and not closed:
        curve, missed = sc.fit.interpolate(points, degree, parameters, numbers_of(knot_values), **given)
    else:
        curve, missed = sc.fit.interpolate(points, degree, parameters, ends='averaged' if knots == 'typed' else knots, closed=closed, **given)
    return Result(curve, _if_seen(missed, points))


def _vector(text, refused):
    """(3,) of a text; None of an empty one. refused: the patterns for counts of numbers that are not 3."""
    numbers = numbers_of(text)
    if numbers and len(numbers) != 3:
        raise Refusal(*refused, count=len(numbers))
    return np.array(numbers) if numbers else None


def numbers_of(text):
    """The numbers in a text, between spaces or commas. Raises Refusal."""
    found = []
    for word in text.replace(",", " ").split():
        try:
            found.append(float(word))
        except ValueError:
            raise Refusal("\"{word}\" is not a number: write numbers between spaces", word=word) from None
    return found


#: So often parameters are moved towards the nearest points.
_CORRECTIONS = 3


def _approximating(points, by, tolerance, control_points, degree, parametrisation, closed, cancel=None):
    degree = min(degree, len(points) - 1)
    least, most = (max(degree, 3) if closed else degree + 1), len(points)
    options = {'tolerance': tolerance} if by == 'tolerance' else {'count': min(max(control_points, least), most)}
    return Result(*sc.fit.approximate(points, degree=degree, parameters=parametrisation, closed=closed,
                                      corrections=_CORRECTIONS, cancel=cancel, **options))


def _polynomial(points, parametrisation, spline):
    parameters = _spacing(points, parametrisation)
    curve = sc.build.polynomial_through(points, parameters)
    missed = float(np.linalg.norm(curve.evaluate(parameters) - points, axis=1).max())
    if not missed <= _MOST_MISSED * np.ptp(points, axis=0).max():
        raise Refusal("{count} points are too many for one polynomial: in double precision it would miss them by {missed}",
                      count=len(points), missed=decimals.text_of(missed, 2))
    beside = [sc.build.catmull_rom(points, parameters)] if spline else []
    return Result([curve, *beside] if beside else curve, _if_seen(missed, points))


def _osculating(points, derivatives):
    size = 1 + derivatives
    if len(points) % size or len(points) < 2 * size:
        raise Refusal("{count} points are not two or more groups of {size}: a point and the heads of its derivatives",
                      "{count} point is not two or more groups of {size}: a point and the heads of its derivatives",
                      count=len(points), size=size)
    groups = points.reshape(-1, size, 3).copy()
    groups[:, 1:] -= groups[:, :1]
    return Result(sc.build.osculating_polynomial(list(groups), np.linspace(0.0, 1.0, len(groups))))


#: An error below this part of the size is rounding.
_SEEN = 1e-12


def _if_seen(missed, points):
    return missed if missed > _SEEN * np.abs(points).max() else 0.0


def _spacing(points, parametrisation):
    """Parameters in [0, 1]. Raises Refusal where two points in a row are one."""
    power = {'uniform': 0.0, 'centripetal': 0.5, 'chordal': 1.0}[parametrisation]
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1) ** power
    if not steps.all():
        raise Refusal("points {first} and {second} are one: choose uniform parameters",
                      first=np.argmin(steps) + 1, second=np.argmin(steps) + 2)
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    return knots / knots[-1]


def _helix(points, radius, end_radius, height, turns, tolerance):
    sweep = 2 * np.pi * turns
    if sweep == 0.0:
        raise Refusal("a helix needs some turns")
    constants = {'r': radius, 'd': end_radius - radius, 'h': height, 'q': sweep}
    return Result(*sc.build.curve_from_formulas(
        ["(r + d*t)*cos(q*t)", "(r + d*t)*sin(q*t)", "h*t"], (0.0, 1.0), tolerance=tolerance, constants=constants))


def _formula(points, x, y, z, start, end, constants, tolerance):
    known = constants_of(constants)
    if not start < end:
        raise Refusal("the last t is not above the first")
    formulas = [formula_of(name, text, ("t",), known) for name, text in (("x", x), ("y", y), ("z", z))]
    return Result(*sc.build.curve_from_formulas(formulas, (start, end), tolerance=tolerance))


def _projection(points, x, y, z, start, end, constants, degree, spans, fixed_ends, cancel=None):
    known = constants_of(constants)
    if not start < end:
        raise Refusal("the last t is not above the first")
    formulas = [formula_of(name, text, ("t",), known) for name, text in (("x", x), ("y", y), ("z", z))]
    knots = np.concatenate([np.repeat(start, degree), np.linspace(start, end, spans + 1), np.repeat(end, degree)])

    def function(t):
        return np.column_stack([np.broadcast_to(formula.evaluate(t), t.shape) for formula in formulas])
    curve, error = sc.fit.project(function, knots, degree, fixed_ends=fixed_ends, cancel=cancel)
    return Result(curve, error)


def formula_of(name, text, variables, constants):
    """A Formula. Raises Refusal that begins with the name, such as x(t)."""
    try:
        return sc.Formula(text, variables, constants)
    except sc.FormulaError as error:
        raise Refusal("{name}({variables}): {error}", name=name, variables=', '.join(variables), error=error) from error


def _at_commas(text):
    """The parts of a text between commas or semicolons that are not inside parentheses."""
    parts, depth = [""], 0
    for character in text:
        depth += (character == "(") - (character == ")")
        if character in ",;" and depth <= 0:
            parts.append("")
        else:
            parts[-1] += character
    return parts


def constants_of(text):
    """The numbers by name in a text such as "a = 2, b = pi/3"; a number may use those before it.

    Raises Refusal where one has no name or no value.
    """
    found = {}
    for part in filter(str.strip, _at_commas(text)):
        name, equals, value = part.partition("=")
        if not equals:
            raise Refusal("'{strip}' is no constant: write a name, = and a number", strip=part.strip())
        number = float(sc.Formula(value, ("_",), found).evaluate(0.0, at_undefined="nan"))
        if not np.isfinite(number):
            raise Refusal("the constant {name} has no finite value", name=name.strip())
        found[name.strip()] = number
    return found


THROUGH_OBJECTS = Recipe(
    "through_objects", "Curve Through Objects", "An interpolating spline through the origins of objects; it follows them",
    (_DEGREE, SPACING, _KNOTS, _KNOT_VALUES, _START_AT, _END_AT, _CLOSED), _interpolating, resolution=24, has_places=True)

RECIPES = (
    Recipe("interpolating", "Interpolating Spline",
           "The B-spline curve of a degree through points, smooth as that degree allows: uniform, chordal or centripetal",
           (_DEGREE, SPACING, _KNOTS, _KNOT_VALUES, _START_AT, _END_AT, _CLOSED), _interpolating, WAVE, True, 24),
    THROUGH_OBJECTS,
    Recipe("approximating", "Approximating Spline",
           "A clean B-spline near many points, by least squares: within a tolerance, or with a number of control points",
           (Parameter("by", "By", "What decides how many control points the curve has", "tolerance", choices=(
               ("tolerance", "Tolerance", "As few as lie within the tolerance of all points"),
               ("count", "Count", "A given number of control points"))),
            Parameter("tolerance", "Tolerance", "How far points may lie from the curve", 0.05, 1e-9, unit='LENGTH',
                      where=("by", ("tolerance",))),
            Parameter("control_points", "Count", "Control points of the curve; no more than there are points", 8, 2, 10_000,
                      where=("by", ("count",))),
            _DEGREE, SPACING, _CLOSED), _approximating, WAVE, True, 24, takes_cancel=True),
    Recipe("catmull_rom", "Catmull-Rom Spline", "A smooth curve through points, its tangents from their neighbors",
           (SPACING, _TENSION, _CLOSED, _ENDS), _catmull_rom, WAVE, True, 16),
    Recipe("kochanek_bartels", "Kochanek-Bartels Spline", "A Catmull-Rom spline with tension, continuity and bias",
           (_TENSION, Parameter("continuity", "Continuity", "Below and above 0: corners inwards, outwards", 0.0, -5.0, 5.0),
            Parameter("bias", "Bias", "Above 0 overshoots before, below 0 after a point", 0.0, -5.0, 5.0),
            SPACING, _CLOSED, _ENDS), _kochanek_bartels, WAVE, True, 16),
    Recipe("polynomial", "Polynomial Through Points", "The one polynomial of lowest degree through points: see how it oscillates",
           (SPACING, Parameter("spline", "Compare with Spline", "A Catmull-Rom spline through the same points, too", False)),
           _polynomial, WAVE, True, 64),
    Recipe("osculating", "Osculating Polynomial",
           "The polynomial of lowest degree with given points and derivatives: each point is followed by the heads of its derivatives",
           (Parameter("derivatives", "Derivatives", "How many are given at each point, equal parameters apart in [0, 1]",
                      1, 1, 5),), _osculating,
           _ZIGZAG, resolution=48, has_groups=True,
           count_for=lambda values: (3 if values['derivatives'] == 1 else 2) * (1 + values['derivatives'])),
    Recipe("helix", "Helix", "A helix or spiral around z",
           (Parameter("radius", "Radius", "At the start", 1.0, 0.0, unit='LENGTH'),
            Parameter("end_radius", "End Radius", "At the end", 1.0, 0.0, unit='LENGTH'),
            Parameter("height", "Height", "From start to end", 2.0, unit='LENGTH'),
            Parameter("turns", "Turns", "How often around; below 0 the other way", 3.0, -1000.0, 1000.0), _TOLERANCE), _helix, resolution=8),
    Recipe("formula", "Curve from Formula", "A curve from formulas in t: exact for polynomials, otherwise within a tolerance",
           (*_FORMULAS, _TOLERANCE), _formula, resolution=8),
    Recipe("projection", "Orthogonal Projection of Formula",
           "The spline on equal knots that is nearest to formulas in the mean square",
           (*_FORMULAS, Parameter("degree", "Degree", "Of the spline", 3, 1, 9), Parameter("spans", "Spans", "Between equal knots", 8, 1, 500),
            Parameter("fixed_ends", "Fixed Ends", "Begin and end where the formulas do", False)), _projection, resolution=24, takes_cancel=True),
)
