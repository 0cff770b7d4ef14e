"""A curve as the lectures write it: coefficients, equation, triangles of numbers. Plain text, to be read."""

import numpy as np

from . import teaching
from .library import sc

#: Spans of a curve that are written out.
MOST_SPANS = 16


def text(curve, position):
    """All that is to say of a NurbsCurve; position is 0 at its start and 1 at its end."""
    start, end = curve.domain
    u = min(start + position * (end - start), end)
    parts = [_points(curve), _power(curve), _conic(curve), _basis_triangle(curve, u), _casteljau(curve, u)]
    return "\n\n".join("\n".join(lines) for lines in parts if lines) + "\n"


def conic_lines(curve):
    """Pairs of a label and a text for a curve that is one conic; [] for any other."""
    try:
        kind, conic = sc.conics.class_of(curve), sc.conics.implicit(curve)
    except (ValueError, ArithmeticError):
        return []
    found = [("Class", kind.replace("_", " ")), ("Conic", conic.type.replace("_", " ")), ("Equation", equation(conic))]
    if conic.eccentricity is not None:
        found.append(("Eccentricity", _number(conic.eccentricity)))
    found += [("Focus", _vector(focus)) for focus in conic.foci]
    return found


def equation(conic):
    """The equation in the coordinates x, y of the conic's plane."""
    terms = [(c, name) for c, name in zip(conic.coefficients, ("x²", "xy", "y²", "x", "y", "")) if abs(c) > 0.0]
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
    lines = [f"  {label}: {value}" for label, value in conic_lines(curve)]
    if not lines:
        return []
    conic = sc.conics.implicit(curve)
    plane = (f"  x and y from {_vector(conic.origin)} along {_vector(conic.x_axis)} and {_vector(conic.y_axis)}")
    return ["Conic:", *lines, plane]


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
        lines.append("  Here " + teaching.broken_text(broken) + "; the homogeneous one goes on:")
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
