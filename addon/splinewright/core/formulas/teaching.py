"""What the lectures draw beside a curve: basis functions (S14) and the construction of a point (S6, S9, S15)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import definition as definitions


def nurbs_of(definition, piece):
    """A curve of a definition as NURBS; pieces are counted from 1. Raises Refusal where there is none."""
    if not definition.has_curves:
        raise Refusal("it is made of patches: a curve is needed")
    if piece > len(definition.pieces):
        raise Refusal(f"there is no piece {piece}: the curve has {len(definition.pieces)}")
    value = definitions.to_value(definition)
    return (value[piece - 1] if isinstance(value, list) else value).to_nurbs()


def basis_graphs(knot_vector, width, height):
    """The graph of every basis function over its support, a NurbsCurve each.

    The knots from first to last are as wide as `width`, the value 1 is as high as `height`. Of a periodic
    knot vector what lies in the domain is drawn, and a function that crosses the seam in two parts.
    """
    degree, knots = knot_vector.degree, np.array(knot_vector.knots)
    start, end = knots[0], knots[-1]
    if knot_vector.periodic:
        start, end = knot_vector.domain
        knots = _unrolled_knots(knot_vector)
    scale = width / (end - start)
    graphs = []
    for i in range(len(knots) - degree - 1):
        graph = _within(_graph(degree, knots[i:i + degree + 2]), start, end)
        if graph is not None:
            points = graph.points.copy()
            points[:, 0] = (points[:, 0] - start) * scale
            points[:, 1] *= height
            graphs.append(graph.with_points(points))
    return graphs


def _unrolled_knots(knot_vector):
    points = np.zeros((knot_vector.count, 3))
    curve = sc.NurbsCurve(knot_vector.degree, knot_vector.knots, points, periodic=True)
    return np.array(curve.unrolled().knots)


def _graph(degree, knots):
    """(u, N(u), 0) of the one function that has these degree + 2 knots, on its support."""
    copies = [int((knots == end).sum()) for end in (knots[0], knots[-1])]
    padded = np.concatenate([np.full(degree + 1 - copies[0], knots[0]), knots,
                             np.full(degree + 1 - copies[1], knots[-1])])
    count = len(padded) - degree - 1
    points = np.zeros((count, 3))
    points[:, 0] = [padded[j + 1:j + degree + 1].mean() for j in range(count)]
    points[degree + 1 - copies[0], 1] = 1.0
    return sc.NurbsCurve(degree, padded, points)


def _within(curve, start, end):
    """The part of a curve in an interval, or None."""
    first, last = curve.domain
    if last <= start or first >= end:
        return None
    if first < start:
        curve = curve.split(start)[1]
    if last > end:
        curve = curve.split(end)[0]
    return curve


def construction(curve, position, scheme, marker):
    """The polygons of every level that lead to a point of a NurbsCurve, and a circle around the point.

    position: 0 for the start of the domain, 1 for its end. scheme: 'de_boor', 'casteljau' or 'rational'.
    Raises Refusal where the rational algorithm divides by zero.
    """
    start, end = curve.domain
    u = min(start + position * (end - start), end)
    levels = _de_boor(curve, u) if scheme == 'de_boor' else _casteljau(curve, u, scheme == 'rational')
    shown = [polyline for level in levels for polyline in _polylines(level)]
    point = _point(curve, u)
    if marker > 0.0 and point is not None:
        shown.append(sc.conics.circle(point, marker))
    return shown


def _point(curve, u):
    point = curve.evaluate([u], side='left' if u == curve.domain[1] else 'right', at_infinity='nan')[0]
    return point if np.isfinite(point).all() else None


def _de_boor(curve, u):
    """[(n, 4)]: the control points of the span, then those that each insertion of u brings (Boehm 1980)."""
    curve = curve.unrolled()
    if u == curve.domain[1]:
        curve = curve.reversed()
        u = curve.domain[0]
    degree = curve.degree
    span = int(np.searchsorted(curve.knots, u, 'right')) - 1
    levels = [curve.homogeneous_points[span - degree:span + 1]]
    missing = degree - curve.knot_vector.multiplicity(u)
    for times in range(1, missing + 1):
        first = span - degree + times
        inserted = curve.insert_knot(u, times).homogeneous_points
        levels.append(inserted[first:first + missing - times + 1])
    return levels


def _casteljau(curve, u, is_rational):
    """[(n, 4)]: the triangle of the Bezier curve in the span, from its control points on."""
    bezier, t = bezier_at(curve, u)
    if is_rational:
        _, broken = bezier.rational_casteljau_triangle(t)
        if broken is not None:
            raise Refusal(broken_text(broken))
    return bezier.casteljau_triangle(t)


def broken_text(broken):
    """A sentence for where the rational algorithm breaks. It counts points from 1, which the reasons of the library do not."""
    level, i, reason = broken
    if level == 0:
        reason = "it is a direction, of weight 0"
    elif "too large" in reason:
        reason = "it is too large for a number"
    else:
        reason = reason.partition(" in row")[0]
    return f"the rational algorithm breaks at level {level}, point {i + 1}: {reason}"


def bezier_at(curve, u):
    """(the BezierCurve in the span of u, its own parameter there)."""
    curve = curve.unrolled()
    start, end = curve.domain
    knots = np.unique(curve.knots[(curve.knots >= start) & (curve.knots <= end)])
    i = min(int(np.searchsorted(knots, u, 'right')) - 1, len(knots) - 2)
    return curve.to_bezier()[i], (u - knots[i]) / (knots[i + 1] - knots[i])


def _polylines(points):
    """The polygon of homogeneous points, as curves of degree 1. A leg with both ends at infinity is left out."""
    is_leg = (points[:-1, 3] != 0.0) | (points[1:, 3] != 0.0)
    runs = np.flatnonzero(np.diff(np.concatenate([[0], is_leg, [0]])))
    for first, last in runs.reshape(-1, 2):
        row = points[first:last + 1]
        knots = np.concatenate([[0.0], np.arange(len(row)), [len(row) - 1.0]])
        yield sc.NurbsCurve.from_homogeneous(1, knots, row)
