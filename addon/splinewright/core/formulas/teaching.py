"""How a point of a curve is found, step by step (S6, S9, S15)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..verbs import verbs
from . import signs
from .functions import Part

#: What the circle around the point that is found is called.
POINT = "point"


def curves_of(definition):
    """The curves of a definition. Raises Refusal where there are none."""
    _require_curves(definition)
    return verbs.curves_of(definition)


def curve_of(definition, piece):
    """A curve of a definition; pieces are counted from 1. Raises Refusal where there is none."""
    _require_curves(definition)
    return piece_of(definition, piece)


def patch_of(definition, piece):
    """A patch of a definition; pieces are counted from 1. Raises Refusal where there is none."""
    if definition.has_curves:
        raise Refusal("it is made of curves: a surface is needed")
    return piece_of(definition, piece)


def piece_of(definition, piece):
    """A curve or patch of a definition; pieces are counted from 1. Raises Refusal where there is none."""
    if piece > len(definition.pieces):
        raise Refusal("there is no piece {piece}: the curve has {most}" if definition.has_curves else
                      "there is no piece {piece}: the surface has {most}", piece=piece, most=len(definition.pieces))
    value = definitions.to_value(definition)
    return value[piece - 1] if definition.form in ('curves', 'patch_set') else value


def _require_curves(definition):
    if not definition.has_curves:
        raise Refusal("it is made of patches: a curve is needed")


def construction(curve, position, scheme, marker, first=0, last=None):
    """The polygons of levels that lead to a point of a NurbsCurve, and a circle around the point: pictures.Part each.

    position: 0 for the start of the domain, 1 for its end. scheme: 'de_boor', 'casteljau' or 'rational'. first, last: the levels that
    are drawn; level 0 are the control points, the highest one is the point. Raises Refusal where the rational algorithm divides by
    zero, or no level is drawn.
    """
    start, end = curve.domain
    u = min(start + position * (end - start), end)
    levels = _de_boor(curve, u) if scheme == 'de_boor' else _casteljau(curve, u, scheme == 'rational')
    highest = len(levels) - 1
    last = highest if last is None else min(last, highest)
    if first > last:
        raise Refusal("the levels are 0 to {highest}: there is none from {first} to {last}", highest=highest, first=first, last=last)
    shown = [Part(f"level {number}", polyline) for number in range(first, last + 1) for polyline in signs.polygon(levels[number])]
    point = _point(curve, u)
    if marker > 0.0 and point is not None and (last == highest or not shown):
        shown.append(Part(POINT, sc.conics.circle(point, marker)))
    if not shown:
        raise Refusal("level {last} is a point: a marker with a radius shows it", last=last)
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
    return phrase("the rational algorithm breaks at level {level}, point {i}: {reason}", level=level, i=i + 1, reason=reason)


def bezier_at(curve, u):
    """(the BezierCurve in the span of u, its own parameter there)."""
    curve = curve.unrolled()
    start, end = curve.domain
    knots = np.unique(curve.knots[(curve.knots >= start) & (curve.knots <= end)])
    i = min(int(np.searchsorted(knots, u, 'right')) - 1, len(knots) - 2)
    return curve.to_bezier()[i], (u - knots[i]) / (knots[i + 1] - knots[i])
