"""Pictures of lectures: graphs of basis functions, and how a point of a curve is found."""

from dataclasses import replace

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..formulas import axes, functions, teaching, triangle_picture
from ..shape import definition as definitions
from . import wanted
from .curve_recipes import numbers_of
from .recipe import Parameter, Recipe, Result

PIECE = Parameter("piece", "Piece", "Which curve of the object, counted from 1", 1, 1)
_SCHEME = Parameter("scheme", "Scheme", "Which points are shown", "de_boor", choices=(
    ("de_boor", "de Boor", "On the knots of the curve: every corner cut is a knot inserted"),
    ("casteljau", "de Casteljau", "Of the Bezier curve in the span, homogeneous: it never breaks"),
    ("rational", "de Casteljau, rational", "Of the Bezier curve in the span, with weights in every step: "
     "it breaks where one is zero")))
FAMILY = Parameter("family", "Functions", "Which functions are drawn", "bspline", choices=(
    ("bspline", "B-Spline", "Of a degree, on knots"), ("bernstein", "Bernstein", "The polynomials of Bezier curves"),
    ("hermite", "Hermite", "Cubic: of points and derivatives at nodes"), ("lagrange", "Lagrange", "Polynomials that are 1 at one node"),
    ("natural", "Natural Spline", "Cubic splines that are 1 at one node, straight at both ends")))
DEGREE = Parameter("degree", "Degree", "Of the functions", 2, 0, 9, where=("family", ("bspline", "bernstein")))
KNOTS = Parameter("knot_values", "Knots", "Knots or nodes between spaces; functions of degree p have p + 2 of them each", "0 1 2 3 4 5",
                   where=("family", ("bspline", "hermite", "lagrange", "natural")), numbers=32)
_SHOW = Parameter("show", "Show", "How the functions are drawn", "functions", choices=(
    ("functions", "Functions", "Each function"), ("sum", "With Sum", "Each function, and the sum of those that weigh points"),
    ("stacked", "Stacked", "Each function upon the sum of those before: together they are 1 where they are all")))
_WIDTH = Parameter("width", "Width", "From the first to the last knot", 2.0, 1e-3, unit='LENGTH')
_HEIGHT = Parameter("height", "Height", "Of the value 1", 1.0, unit='LENGTH')
_AXES = Parameter("axes", "Axes", "Axes with a tick at every knot", True, before=False)
_DOMAIN = Parameter("domain", "Domain", "A rectangle on the interval where all functions of each span are there: it is that of a curve", False)


def _functions(points, family, degree, knot_values, **drawn):
    return _picture(family_of(family, degree, numbers_of(knot_values)), **drawn)


def _basis(inputs, piece, **drawn):
    return _picture(functions.of_curve(teaching.curve_of(inputs[0], piece)), **drawn)


def family_of(name, degree, knots):
    """The Family that FAMILY names. Raises Refusal."""
    if name == 'bspline':
        return functions.of_knots(degree, knots)
    if name == 'bernstein':
        return functions.bernstein(degree)
    return getattr(functions, name)(knots)


def _picture(family, show, width, height, axes, domain):
    zero = functions.zero_functions(family)
    said = [phrase("zero everywhere: {zero}", zero=', '.join(zero))] if zero else []
    said += ["there is no domain: no span has all its functions"] if domain and family.domain is None else []
    return of_parts(functions.picture(family, show, width, height, axes, domain), "; ".join(said))


def of_parts(parts, said="", warning=""):
    """The Result that is a picture. Raises Refusal where it has no parts."""
    if not parts:
        raise Refusal("nothing is drawn: choose parts to show, or a radius")
    drawn = definitions.from_value([part.curve for part in parts])
    return Result(definitions.named(drawn, [part.name for part in parts]), said=said, warning=warning)


def of_surfaces(parts, said=""):
    """The Result that is a picture of patches; none are joined."""
    drawn = definitions.from_value(sc.PatchSet.from_patches([part.curve for part in parts], merge=False))
    return Result(definitions.named(drawn, [part.name for part in parts]), said=said)


def _construction(inputs, piece, position, scheme, marker, first_level, last_level):
    return of_parts(teaching.construction(teaching.curve_of(inputs[0], piece).to_nurbs(), position, scheme, marker, first_level, last_level))


def _axes(points, spatial, grid, tick, step, **limits):
    names = "xyz" if spatial else "xy"
    ranges = [(limits[f"{name}_from"], limits[f"{name}_to"]) for name in names]
    return of_parts(axes.picture(ranges, [step] * len(names), tick, grid))


def _triangle(points, degree, knot_values, **shown):
    return _scheme(degree, numbers_of(knot_values), **shown)


def _basis_triangle(inputs, piece, **shown):
    curve = teaching.curve_of(inputs[0], piece).to_nurbs().unrolled()
    return _scheme(curve.degree, curve.knots, **shown)


def _scheme(degree, knots, chosen, feeding, spans, across, down, marker):
    of = triangle_picture.scheme(degree, knots, across, down)
    return of_parts(triangle_picture.picture(of, _pairs(chosen), feeding == 'support', _whole(spans.split()), marker))


def _pairs(text):
    """[(i, degree)] of a text such as "1,3 2,3"."""
    found = [_whole(word.split(",")) for word in text.split()]
    for word, pair in zip(text.split(), found):
        if len(pair) != 2:
            raise Refusal("\"{word}\" is not a function: write number,degree, such as 1,3", word=word)
    return [tuple(pair) for pair in found]


def _whole(words):
    for word in words:
        if not word.isdecimal():
            raise Refusal("\"{word}\" is not a whole number from 0", word=word)
    return [int(word) for word in words]


def _limit(name, is_start):
    return Parameter(f"{name}_{'from' if is_start else 'to'}", f"{name.upper()} {'From' if is_start else 'To'}",
                     f"Where the axis of {name} {'begins' if is_start else 'ends'}", -1.0 if is_start else 3.0, unit='LENGTH',
                     where=("spatial", (True,)) if name == "z" else ())


_SCHEME_OF = (
    Parameter("chosen", "Functions", "Numbers and degrees of functions that are pointed out: 1,3 is N_1,3; several between spaces", ""),
    Parameter("feeding", "Show", "What they are shown with", "parents", choices=(
        ("parents", "Parents", "The two that each is made of, with the coefficients of Cox and de Boor"),
        ("support", "Support", "All that it depends on, back to the spans"))),
    Parameter("spans", "Spans", "Numbers of spans, between spaces: the functions that are not zero there", ""),
    Parameter("across", "Column Width", "From one degree to the next", 1.0, 1e-3, unit='LENGTH'),
    Parameter("down", "Row Height", "From one function to the next", 0.6, 1e-3, unit='LENGTH'),
    Parameter("marker", "Marker", "Radius of the marks", 0.03, 1e-6, unit='LENGTH'))
TRIANGLE = Recipe(
    "triangle", "Triangle of Functions on Knots", "The scheme of Cox and de Boor: each B-spline function and the two that it is made of",
    (replace(DEGREE, description="Of the highest functions", where=()), replace(KNOTS, where=()), *_SCHEME_OF), _triangle, resolution=1,
    thickness=0.004)
AXES = Recipe(
    "axes", "Axes", "Axes with a tick at every step, and a grid, to be drawn beside curves and to render",
    (*(_limit(name, is_start) for name in "xyz" for is_start in (True, False)),
     Parameter("step", "Step", "How far ticks and lines of the grid lie apart", 1.0, 1e-6, unit='LENGTH'),
     Parameter("tick", "Tick Length", "How long ticks are", 0.06, 0.0, unit='LENGTH'),
     Parameter("grid", "Grid", "Lines in the plane of x and y at every tick", False),
     Parameter("spatial", "Z Axis", "An axis of z, too", False)), _axes, resolution=1, thickness=0.005)
FUNCTIONS = Recipe(
    "functions", "Basis Functions on Knots", "The graphs of B-spline, Bernstein, Hermite, Lagrange or natural spline functions, exact",
    (FAMILY, DEGREE, KNOTS, _SHOW, _WIDTH, _HEIGHT, _AXES, _DOMAIN), _functions, resolution=16, thickness=0.006)
RECIPES = (
    Recipe("basis", "Basis Functions", "The graphs of the basis functions of a curve, exact; they follow when its knots change",
           (_WIDTH, _HEIGHT, PIECE, _SHOW, _AXES, _DOMAIN), _basis, resolution=16, thickness=0.006, inputs=(wanted.ONE_CURVE,), is_beside=True),
    Recipe("construction", "Construction of a Point",
           "The polygons by which a point of a curve is found; they follow when the curve is edited",
           (Parameter("position", "Position", "0 is the start of the curve, 1 its end", 0.5, 0.0, 1.0), _SCHEME,
            Parameter("marker", "Marker", "Radius of a circle around the point; 0 for none", 0.03, 0.0, unit='LENGTH'),
            PIECE, Parameter("first_level", "First Level", "Of the polygons that are drawn; 0 are the control points", 0, 0, 255),
            Parameter("last_level", "Last Level", "Of the polygons that are drawn; the highest one is the point", 255, 0, 255)),
           _construction, thickness=0.004, inputs=(wanted.ONE_CURVE,)),
    Recipe("basis_triangle", "Triangle of Functions", "The scheme of Cox and de Boor on the knots of a curve; it follows them",
           (*_SCHEME_OF, PIECE), _basis_triangle, resolution=1, thickness=0.004, inputs=(wanted.ONE_CURVE,), is_beside=True),
    FUNCTIONS, AXES, TRIANGLE,
)
