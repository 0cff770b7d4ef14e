"""Pictures of lectures of a curve or surface: halved polygons, and hulls."""

from ..formulas import halving, hulls, teaching
from ..verbs import verbs
from . import wanted
from .recipe import Parameter, Recipe
from .teaching_recipes import of_parts

_MARKER = Parameter("marker", "Marker", "Radius of the marks; 0 for none", 0.03, 0.0, unit='LENGTH')
_STEPS = Parameter("steps", "Steps", "How often the polygons are divided", 3, 0, 12)
_RATIO = Parameter("ratio", "Ratio", "Where legs are divided: 0.5 is their middle", 0.5, 0.0, 1.0)
_DISTANCE = Parameter("distance", "Distance", "From each step to the next, along X; 0 draws them over each other", 0.0, unit='LENGTH')
_HULLS_OF = Parameter("hulls_of", "Hulls Of", "Which control points have a hull together", "spans", choices=(
    ("spans", "Spans", "Those that act on a span: degree + 1 of a curve"), ("whole", "Whole", "All of a curve or patch")))
_SHOW_HULLS = Parameter("show", "Show", "Which of them are drawn", "hulls", choices=(
    ("hulls", "Hulls", "Each hull"), ("intersections", "Intersections", "What neighboring hulls of a curve have in common"),
    ("both", "Both", "Hulls, and what neighboring ones have in common")))


def _halving(inputs, steps, ratio, distance):
    return of_parts(halving.halving(teaching.curves_of(inputs[0]), ratio, steps, distance))


def _hulls(inputs, hulls_of, show, marker):
    shapes, is_curve = verbs.pieces_of(inputs[0]), inputs[0].has_curves
    found = hulls.groups(shapes, hulls_of == 'spans')
    if not is_curve:
        parts, said = hulls.picture(found, 'hulls', marker, [False] * len(found))
        return of_parts(parts, warning=said, said="" if show == 'hulls' else "intersections are drawn of curves alone")
    closed = [getattr(shape, 'periodic', False) for shape in shapes]
    if hulls_of == 'whole':
        found, closed = [[each[0] for each in found]], [False]
    parts, said = hulls.picture(found, show, marker, closed)
    return of_parts(parts, warning=said)


RECIPES = (
    Recipe("halving", "Halved Polygons", "The control polygons divided again and again by de Casteljau, step by step; they follow the curve",
           (_STEPS, _RATIO, _DISTANCE), _halving, thickness=0.004, inputs=(wanted.ONE_CURVE,)),
    Recipe("hulls", "Convex Hulls", "Convex hulls of the control points of spans, curves or patches; they follow when points move",
           (_HULLS_OF, _SHOW_HULLS, _MARKER), _hulls, thickness=0.004, inputs=(wanted.CURVE_OR_SURFACE,)),
)
