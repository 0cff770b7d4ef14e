"""A curve as the lectures write it: coefficients, equation, triangles of numbers. Plain text, to be read."""

import numpy as np

from ..base.library import sc
from . import teaching

#: Spans of a curve that are written out, and the highest degree of one that is.
MOST_SPANS = 16
MOST_DEGREE = 30
#: Parts of the size that come of rounding.
_ROUNDING = 1e-12
#: Parts of the largest number that come of rounding, too.
_SAME = 1e-10


def text(curve, position):
    """All that is to say of a NurbsCurve; position is 0 at its start and 1 at its end."""
    start, end = curve.domain
    u = min(start + position * (end - start), end)
    parts = [_points(curve)]
    if curve.degree <= MOST_DEGREE:
        parts += [_power(curve), _conic(curve), _matrix(curve), _basis_triangle(curve, u), _casteljau(curve, u)]
    return "\n\n".join("\n".join(lines) for lines in parts if lines) + "\n"


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
        found.append(("Eccentricity", _number(conic.eccentricity)))
    size = np.abs(_finite(curve.points)).max(initial=0.0)
    return found + [("Focus", _vector(np.where(np.abs(focus) > _ROUNDING * size, focus, 0.0))) for focus in conic.foci]


def _finite(points):
    return points[np.isfinite(points)]


def _is_one_arc(curve):
    return curve.degree == 2 and len(curve.points) == 3


def equation(conic):
    """The equation in the coordinates x, y of the conic's plane."""
    least = _SAME * 1e-3 * np.abs(conic.coefficients).max()
    terms = [(c, name) for c, name in zip(conic.coefficients, ("x²", "xy", "y²", "x", "y", "")) if abs(c) > least]
    return _sum(terms) + " = 0"


def _points(curve):
    lines = [f"NURBS curve of degree {curve.degree}{', periodic' if curve.periodic else ''}",
             "Knots: " + " ".join(map(_number, curve.knots)), "Control points (x, y, z) and weights:"]
    rows = zip(curve.points, curve.weights)
    lines += [f"  P{i}  {_vector(p)}  w = {_number(w)}{'  (at infinity)' if w == 0 else ''}" for i, (p, w) in enumerate(rows)]
    return lines


def _power(curve):
    """Lecture row S2."""
    lines = ["Power basis, span by span:"]
    spans = curve.to_power()
    for power in spans[:MOST_SPANS]:
        start, end = power.domain
        lines.append(f"  on [{_number(start)}, {_number(end)}]" +
                     (f", with s = t - {_number(power.origin)}" if power.origin else ""))
        variable = "s" if power.origin else "t"
        rows = power.homogeneous_coefficients if curve.is_rational else power.coefficients
        for axis, name in enumerate("XYZW" if curve.is_rational else "xyz"):
            lines.append(f"    {name} = {_polynomial(rows[:, axis], variable)}")
    if len(spans) > MOST_SPANS:
        lines.append(f"  and {len(spans) - MOST_SPANS} spans more")
    return lines


def _conic(curve):
    """Lecture row S10."""
    try:
        conic = sc.conics.implicit(curve)
    except sc.Error:
        return []
    lines = [f"  {label}: {value}" for label, value in _lines_of(curve, conic)]
    plane = (f"  x and y from {_vector(conic.origin)} along {_vector(conic.x_axis)} and {_vector(conic.y_axis)}")
    return ["Conic:", *lines, plane]


def _matrix(curve):
    """Lecture rows S6 and S13: what takes the control points of a span to the coefficients of 1, t, t², …"""
    knots = curve.knot_vector.knots
    if len(curve.points) == curve.degree + 1 and not curve.periodic and knots[0] == knots[curve.degree]:
        name, matrix = "Bezier", sc.basis.bezier_matrix(curve.degree)
    elif np.ptp(np.diff(knots)) <= _SAME * np.ptp(knots):
        name, matrix = "uniform B-spline", sc.basis.uniform_matrix(curve.degree)
    else:
        return []
    return [f"{name} matrix, t from 0 to 1 in a span:", *("  " + "  ".join(f"{_number(v):>14}" for v in row) for row in matrix)]


def _basis_triangle(curve, u):
    """Lecture row S14: which functions feed which."""
    lines = [f"Basis functions that are not zero at u = {_number(u)}, by degree:"]
    for degree, (indices, values, *_) in enumerate(curve.knot_vector.triangle(u)):
        lines.append("  " + "   ".join(f"N{i},{degree} = {_number(value)}" for i, value in zip(indices, values)))
    return lines


def _casteljau(curve, u):
    """Lecture row S9."""
    bezier, t = teaching.bezier_at(curve, u)
    lines = [f"de Casteljau on the Bezier curve of the span, at t = {_number(t)}, points and weights by level:"]
    rows, broken = bezier.rational_casteljau_triangle(t)
    for level, points in enumerate(rows):
        lines.append(f"  {level}:  " + "   ".join(f"{_vector(row[:3])} w = {_number(row[3])}" for row in points))
    if broken is not None:
        lines.append("  Here " + teaching.broken_text(broken) + "; the homogeneous algorithm continues:")
        for level, points in enumerate(bezier.casteljau_triangle(t)):
            lines.append(f"  {level}:  " + "   ".join("[" + " ".join(map(_number, row)) + "]" for row in points))
    return lines


def _polynomial(coefficients, variable):
    return _sum([(c, "" if k == 0 else variable if k == 1 else f"{variable}^{k}") for k, c in enumerate(coefficients)])


def _sum(terms):
    """c1 name1 + c2 name2 ..., without those that are zero."""
    written = ""
    for c, name in terms:
        if c == 0.0:
            continue
        sign = ("-" if c < 0 else "") if not written else (" - " if c < 0 else " + ")
        size = _number(abs(c))
        written += sign + (name if name and size == "1" else f"{size} {name}".rstrip())
    return written or "0"


def _vector(point):
    return "(" + ", ".join(map(_number, point)) + ")"


def _number(value):
    return f"{value + 0.0:.10g}" if np.isfinite(value) else "infinite"
