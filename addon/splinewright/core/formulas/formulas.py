"""A curve as the lectures write it: coefficients, equation, matrices, triangles of numbers. Plain text, to be read."""

from fractions import Fraction

import numpy as np

from ..base.library import sc
from ..shape import definition as definitions
from . import patch_formulas, spline, triangles, written
from .exact import Number, coefficients, read

#: Spans of a curve that are written out, and the highest degree of one that is.
MOST_SPANS = 16
MOST_DEGREE = 30
#: Parts of the size that come of rounding.
_ROUNDING = 1e-12
#: Parts of the largest coefficient of a conic that come of rounding.
_OF_CONIC = 1e-13


def text(value, position):
    """All that is to say of a curve or patch; position is 0 at its start and 1 at its end, in both directions of a patch."""
    parts = patch_formulas.parts(value, position) if isinstance(value, definitions.PATCHES) else _parts(value, position)
    return "\n\n".join("\n".join(lines) for lines in parts if lines) + "\n"


def _parts(curve, position):
    of_curve, rows = spline.of_curve(curve)
    allowed = written.allowed_for(curve.points)
    start, end = of_curve.domain
    u = start + Fraction(str(position)) * (end - start)
    parts = [_hermite_points(curve, allowed) if of_curve.kind == 'Hermite' else _points(curve, of_curve, allowed)]
    if curve.degree > MOST_DEGREE:
        return [*parts, [f"Formulas are written up to degree {MOST_DEGREE}: this is degree {curve.degree}"]]
    count = len(curve.points)
    return [*parts, _power(curve, of_curve, rows), _conic(curve.to_nurbs()), spline.matrix_lines(of_curve, of_curve.letter, _names(count)),
            triangles.scheme_lines(of_curve), triangles.basis_lines(of_curve, u, of_curve.letter), triangles.de_boor_lines(of_curve, rows, u, count, allowed),
            triangles.casteljau_lines(of_curve, rows, u, allowed)]


def _names(count):
    """What control points of a segment are called; those of a periodic curve begin again."""
    return lambda indices: f"P{indices[0] % count} to P{indices[-1] % count}"


def conic_lines(curve):
    """Pairs of a label and a text for a curve that lies on one conic, in whatever form; [] for any other."""
    try:
        conic = sc.conics.implicit(curve)
    except sc.Error:
        return []
    return _lines_of(curve, conic)


def _lines_of(curve, conic):
    found = [("Class", sc.conics.class_of(curve).replace("_", " "))] if _is_one_arc(curve) else []
    found += [("Conic", conic.type.replace("_", " ")), ("Equation", equation(conic))]
    if conic.eccentricity is not None:
        found.append(("Eccentricity", _computed([conic.eccentricity], _ROUNDING)[0]))
    return found + [("Focus", _place(focus, _rounding_of(curve))) for focus in conic.foci]


def _rounding_of(curve):
    points = curve.points
    return _ROUNDING * float(np.abs(points[np.isfinite(points)]).max(initial=0.0))


def _is_one_arc(curve):
    return curve.degree == 2 and len(curve.points) == 3


def equation(conic):
    """The equation in the coordinates x, y of the conic's plane."""
    texts = _computed(conic.coefficients, _OF_CONIC * float(np.abs(conic.coefficients).max()))
    return written.summed(zip(texts, ("x²", "xy", "y²", "x", "y", ""))) + " = 0"


def _place(point, within):
    return "(" + ", ".join(_computed(point, within)) + ")"


def _computed(values, within):
    """Numbers that the library found, within a bound, as texts."""
    return [written.number(Number(Fraction(float(value)), within)) if np.isfinite(value) else "infinite" for value in values]


def _points(curve, of_curve, allowed):
    is_bezier = of_curve.kind == 'Bezier'
    lines = [f"{of_curve.kind} curve of degree {curve.degree}" + (", periodic" if not is_bezier and curve.periodic else "")]
    if not is_bezier:
        lines.append("Knots: " + " ".join(written.number(read(knot), of_curve.allowed) for knot in curve.knots))
    lines.append("Control points (x, y, z) and weights:")
    rows = zip(curve.points, curve.weights)
    return lines + [f"  P{i}  {_vector(p, allowed)}  w = {written.number(read(w))}{'  (at infinity)' if w == 0 else ''}"
                    for i, (p, w) in enumerate(rows)]


def _hermite_points(curve, allowed):
    """Lecture row S4."""
    nodes = spline.of_curve(curve)[0]
    count = len(curve.points) - 1
    lines = [f"Hermite chain of degree 3 of {count} segment{'s' if count > 1 else ''}",
             "Parameters: " + " ".join(written.number(node, nodes.allowed) for node in nodes.knots),
             "Points P (x, y, z) and derivatives R by the parameter:"]
    for i, (point, (incoming, outgoing)) in enumerate(zip(curve.points, curve.tangents)):
        is_one = np.array_equal(incoming, outgoing) or i in (0, count)
        shown = (("", incoming if i == count else outgoing),) if is_one else ((" before", incoming), (" after", outgoing))
        lines.append(f"  P{i}  {_vector(point, allowed)}" + "".join(f"  R{i}{side}  {_vector(each)}" for side, each in shown))
    return lines


def _power(curve, of_curve, rows):
    """Lecture row S2."""
    def part(segment):
        return lambda: _span(segment, of_curve, rows, curve.is_rational)
    return ["Power basis, span by span:", *written.listed(list(map(part, of_curve.segments)), MOST_SPANS, "spans")]


def _span(segment, of_curve, rows, is_rational):
    variable, where = written.from_start(of_curve.letter, "s", segment.start, of_curve.allowed)
    lines = [f"  on {of_curve.on(segment)}{', with ' + where if where else ''}"]
    for name, row in zip("XYZW" if is_rational else "xyz", coefficients(segment, rows)):
        allowed = 0.0 if is_rational else written.share_of(row, [segment.length ** k for k in range(len(row))])
        texts = written.numbers(row, [allowed / float(segment.length ** k) for k in range(len(row))])
        lines.append(f"    {name} = {written.summed(zip(texts, (written.power(variable, k) for k in range(len(row)))))}")
    return lines


def _conic(curve):
    """Lecture row S10."""
    try:
        conic = sc.conics.implicit(curve)
    except sc.Error:
        return []
    within = _rounding_of(curve)
    x_axis, y_axis = (_place(axis, _ROUNDING) for axis in (conic.x_axis, conic.y_axis))
    lines = [f"  {label}: {value}" for label, value in _lines_of(curve, conic)]
    return ["Conic:", *lines, f"  x and y from {_place(conic.origin, within)} along {x_axis} and {y_axis}"]


def _vector(point, allowed=np.inf):
    return written.vector(map(read, point), allowed)
