"""Pictures of lectures of a curve or surface: halved polygons, hulls, points of C2 chains, marks and arrows."""

from ..base.library import sc
from ..formulas import chain_points, halving, hulls, marks, teaching
from ..verbs import verbs
from . import wanted
from .recipe import Parameter, Recipe
from .teaching_recipes import PIECE, of_parts

_MARKER = Parameter("marker", "Marker", "Radius of the marks; 0 for none", 0.03, 0.0, unit='LENGTH')
_STEPS = Parameter("steps", "Steps", "How often the polygons are divided", 3, 0, 12)
_RATIO = Parameter("ratio", "Ratio", "Where legs are divided: 0.5 is their middle", 0.5, 0.0, 1.0)
_DISTANCE = Parameter("distance", "Distance", "From each step to the next, along X; 0 draws them over each other", 0.0, unit='LENGTH')
_HULLS_OF = Parameter("hulls_of", "Hulls Of", "Which control points have a hull together", "spans", choices=(
    ("spans", "Spans", "Those that act on a span: degree + 1 of a curve"), ("whole", "Whole", "All of a curve or patch")))
_SHOW_HULLS = Parameter("show", "Show", "Which of them are drawn", "hulls", choices=(
    ("hulls", "Hulls", "Each hull"), ("intersections", "Intersections", "What neighboring hulls of a curve have in common"),
    ("both", "Both", "Hulls, and what neighboring ones have in common")))
_POLYGONS = Parameter("polygons", "Polygons", "Which polygons are drawn", "both", choices=(
    ("both", "Both", "The polygon of the spline and those of its Bezier form"), ("spline", "Spline", "The polygon of the spline"),
    ("bezier", "Bezier", "The polygons of its Bezier form"), ("none", "None", "Points alone")))
_MARK_STEPS = Parameter("steps", "Steps", "Equal steps of the parameter, with a mark at each end; 0 for none", 8, 0, 200)
_TANGENTS = Parameter("tangents", "Tangents at Corners", "Both tangents at each corner, as arrows", True)
_ARROW = Parameter("arrow", "Tangent Length", "Of the arrows at corners", 0.5, 1e-3, unit='LENGTH', where=("tangents", (True,)))
_DERIVATIVES = Parameter("derivatives", "Derivatives at Ends", "As arrows in their true length; of a Hermite chain at every node", False)


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


def _chain_points(inputs, piece, polygons, marker):
    curves = teaching.curves_of(inputs[0])
    if len(curves) > 1 and all(isinstance(curve, sc.BezierCurve) and curve.degree == 3 for curve in curves):
        parts, warning = chain_points.of_chain(curves, polygons, marker)
        return of_parts(parts, warning=warning)
    return of_parts(chain_points.of_curve(teaching.curve_of(inputs[0], piece), polygons, marker))


def _marks(inputs, steps, marker, tangents, arrow, derivatives):
    curves = teaching.curves_of(inputs[0])
    arrows, zero = marks.derivatives(curves) if derivatives else ([], "")
    return of_parts(marks.steps(curves, steps, marker) + (marks.tangents(curves, arrow) if tangents else []) + arrows, said=zero)


RECIPES = (
    Recipe("halving", "Halved Polygons", "The control polygons divided again and again by de Casteljau, step by step; they follow the curve",
           (_STEPS, _RATIO, _DISTANCE), _halving, thickness=0.004, inputs=(wanted.ONE_CURVE,)),
    Recipe("hulls", "Convex Hulls", "Convex hulls of the control points of spans, curves or patches; they follow when points move",
           (_HULLS_OF, _SHOW_HULLS, _MARKER), _hulls, thickness=0.004, inputs=(wanted.CURVE_OR_SURFACE,)),
    Recipe("chain_points", "Chain Points",
           "Points d, e, f and g between a cubic spline and its Bezier form, with ratios; they follow the curve",
           (_POLYGONS, _MARKER, PIECE), _chain_points, thickness=0.004, inputs=(wanted.ONE_CURVE,)),
    Recipe("marks", "Marks on a Curve", "Marks at equal steps of the parameter, tangents at corners, derivatives at ends; they follow the curve",
           (_MARK_STEPS, _MARKER, _TANGENTS, _ARROW, _DERIVATIVES), _marks, thickness=0.004, inputs=(wanted.ONE_CURVE,)),
)
