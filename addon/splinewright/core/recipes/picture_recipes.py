"""Pictures of lectures of a curve or surface: halved polygons, hulls, points of C2 chains, marks and arrows, discs, orders, influence, labels."""

from dataclasses import replace

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..formulas import chain_points, discs, ducks, halving, hulls, influence, labels, lettering, marks, orders, teaching
from ..verbs import verbs
from . import wanted
from .curve_recipes import SPACING, WAVE
from .recipe import Parameter, Recipe
from .teaching_recipes import PIECE, of_parts, of_surfaces

_MARKER = Parameter("marker", "Marker", "Radius of the marks; 0 for none", 0.03, 0.0, unit='LENGTH')
_STEPS = Parameter("steps", "Steps", "How often the polygons are divided", 3, 0, 12)
_RATIO = Parameter("ratio", "Ratio", "Where legs are divided: 0.5 is their middle", 0.5, 0.0, 1.0)
_DISTANCE = Parameter("distance", "Distance", "From each step to the next, along X; 0 draws them over each other", 0.0, unit='LENGTH')
_HULLS_OF = Parameter("hulls_of", "Hulls Of", "Which control points have a hull together", "spans", choices=(
    ("spans", "Spans", "Those that act on a span: degree + 1 of a curve"), ("whole", "Whole", "All of a curve or patch")))
_SHOW_HULLS = Parameter("show", "Show", "Which of them are drawn", "hulls", choices=(
    ("hulls", "Hulls", "Each hull"), ("intersections", "Intersections", "What neighboring hulls have in common"),
    ("both", "Both", "Hulls, and what neighboring ones have in common")))
_POLYGONS = Parameter("polygons", "Polygons", "Which polygons are drawn", "both", choices=(
    ("both", "Both", "The polygon of the spline and those of its Bezier form"), ("spline", "Spline", "The polygon of the spline"),
    ("bezier", "Bezier", "The polygons of its Bezier form"), ("none", "None", "Points alone")))
_MARK_STEPS = Parameter("steps", "Steps", "Equal steps of the parameter, with a mark at each end; 0 for none", 8, 0, 200)
_TANGENTS = Parameter("tangents", "Tangents at Corners", "Both tangents at each corner, as arrows", True)
_ARROW = Parameter("arrow", "Tangent Length", "Of the arrows at corners", 0.5, 1e-3, unit='LENGTH', where=("tangents", (True,)))
_POSITION = Parameter("position", "Position", "0 is the start of the curve, 1 its end; of patches where u begins and ends", 0.5, 0.0, 1.0)
_POSITION_V = Parameter("position_v", "Position Along V", "Of patches; 0 is where v begins, 1 where it ends", 0.5, 0.0, 1.0)
_DERIVATIVES = Parameter("derivatives", "Derivatives at Ends", "As arrows in their true length; of a Hermite chain at every node", False)


def _halving(inputs, steps, ratio, distance):
    return of_parts(halving.halving(teaching.curves_of(inputs[0]), ratio, steps, distance))


def _hulls(inputs, hulls_of, show, marker):
    shapes, by_spans = verbs.pieces_of(inputs[0]), hulls_of == 'spans'
    found = hulls.groups(shapes, by_spans)
    neighboring = hulls.neighbors(shapes, found, by_spans)
    if not by_spans:
        found, neighboring = hulls.whole(found, inputs[0].has_curves)
    parts, said = hulls.picture(found, show, marker, neighboring)
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


def _discs(inputs, piece, position, position_v, radius):
    shape = teaching.piece_of(inputs[0], piece)
    nurbs, letter = shape.to_nurbs(), "B" if isinstance(shape, (sc.BezierCurve, sc.BezierPatch)) else "N"
    if inputs[0].has_curves:
        parts, warning = discs.picture(nurbs, position, radius, letter)
    else:
        parts, warning = discs.picture_of_patch(nurbs, (position, position_v), radius, letter)
    if not parts:
        raise Refusal(warning)
    return of_parts(parts, warning=warning)


def _orders(inputs, piece, wanted_orders, columns, polygons):
    curve = teaching.curve_of(inputs[0], piece).to_nurbs()
    found = orders.typed(wanted_orders, len(curve.points)) or orders.all_of(curve)
    if not wanted_orders.strip() and len(curve.points) > 5:
        said = phrase("{count} orders: of two neighbors swapped, for there are too many", count=len(found))
    else:
        said = phrase("{count} orders", one="{count} order", count=len(found))
    return of_parts(orders.picture(curve, found, columns, polygons), said)


def _influence(inputs, piece, index, index_v, marker, above):
    if inputs[0].has_curves:
        moved, pattern = influence.of_curves(inputs[0], piece, index, marker), "it moves {share:.3g} % of the length"
    else:
        moved, pattern = influence.of_patches(inputs[0], piece, (index, index_v), above), "it moves {share:.3g} % of the area"
    said = "" if moved.share is None else phrase(pattern, share=100.0 * moved.share)
    return of_parts(moved.parts, said) if inputs[0].has_curves else of_surfaces(moved.parts, said)


def _labels(inputs, height, plane):
    found = labels.of(inputs[0])
    if not found:
        raise Refusal("nothing of it has a name")
    return of_parts(lettering.picture(found, height, plane))


def _ducks(points, spacing, marker, ends):
    parts, energy = ducks.picture(points, spacing, marker, ends)
    return of_parts(parts, phrase("bending energy {energy_text}", energy_text=ducks.energy_text(energy)))


_LETTERS = Parameter("height", "Text Height", "Of capital letters", 0.12, 1e-6, unit='LENGTH')
_LETTERS_IN = Parameter("plane", "Text Plane", "In which letters lie", "xy", choices=(
    ("xy", "XY", "Read from above"), ("xz", "XZ", "Read from the front"), ("yz", "YZ", "Read from the right")))
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
    Recipe("discs", "Discs of a Point",
           "A circle around each control point with the value of its function as area, with weights; they follow the shape",
           (_POSITION, _POSITION_V, Parameter("radius", "Radius", "Of the circle for the value 1", 0.5, 1e-6, unit='LENGTH'), PIECE), _discs, thickness=0.004,
           inputs=(wanted.CURVE_OR_SURFACE,)),
    Recipe("orders", "Orders of Points", "The curves that the same control points make in other orders; they follow the points",
           (Parameter("wanted_orders", "Orders", "Orders of the points, counted from 0, between commas: 0 2 1 3, 1 0 2 3; empty for all", ""),
            Parameter("columns", "Columns", "How many curves are beside each other; 0 draws them over each other", 4, 0, 120),
            Parameter("polygons", "Polygons", "The control polygon of each", True), PIECE), _orders, thickness=0.004,
           inputs=(wanted.ONE_CURVE,)),
    Recipe("influence", "Influence of a Point", "The part of a curve or surface that a control point moves, and its share; it follows the shape",
           (Parameter("index", "Point", "Of the control point, counted from 0; of patches along u", 1, 0, 100_000),
            Parameter("index_v", "Point Along V", "Of the control point of a patch, counted from 0", 1, 0, 100_000),
            _MARKER, Parameter("above", "Distance", "Parts of a surface are drawn so far from it, on both sides", 0.005, 0.0, unit='LENGTH'),
            PIECE), _influence, thickness=0.02, inputs=(wanted.CURVE_OR_SURFACE,)),
    Recipe("labels", "Labels", "Names of control points, weights, knots, functions and ticks as curves that render; they follow the shape",
           (_LETTERS, _LETTERS_IN), _labels, resolution=1, thickness=0.006, inputs=(wanted.CURVE_OR_SURFACE,)),
    Recipe("ducks", "Spline with Ducks", "A strip held at points by weights, as draftsmen have it: the natural spline, and its bending energy",
           (replace(SPACING, name="spacing"), _MARKER, Parameter("ends", "Ends", "How far the strip reaches beyond the outer points, where it is straight", 0.3, 0.0,
                                        unit='LENGTH')), _ducks, WAVE, True, 24, thickness=0.01),
)
