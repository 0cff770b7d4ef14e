"""Measures of curves as outlines, of what joins in them, of their knots and of conics: numbers by name, for measures.py."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Beyond this distance from the control points a curve counts as gone to infinity.
_FAR = 1000.0


def _knot(curve, index):
    knots = curve.to_nurbs().knots
    if not 0 <= index < len(knots):
        raise Refusal(f"there is no knot {index:g}")
    return knots[int(index)]


def _jump(curve, at, order):
    """How far the derivatives of an order on both sides of a parameter differ."""
    nurbs, order = curve.to_nurbs(), int(order)
    if not 0 <= order <= nurbs.degree:
        raise Refusal(f"derivatives have the orders 0 to {nurbs.degree}")
    before, after = (nurbs.derivatives([at], order, side=side)[0][order] for side in ('left', 'right'))
    return np.linalg.norm(after - before)


def _corners(curve):
    return sum(joint.g < 1 for _, joint in curve.to_nurbs().joints())


def _eccentricity(curve):
    found = sc.conics.implicit(curve).eccentricity
    if found is None:
        raise Refusal("the conic is degenerate")
    return found


#: {name: (what it takes, function)}. `at` is a parameter, `index` counts from 0;
#: 'joint_angle' is the angle in radians from the end of a curve to the start of another one.
MEASURES = {
    'start': ((), lambda curve: curve.domain[0]),
    'end': ((), lambda curve: curve.domain[1]),
    'knot': (('index',), _knot),
    'jump': (('at', 'order'), _jump),
    'closed': ((), lambda curve: curve.is_closed),
    'corners': ((), _corners),
    'joint_angle': (('to',), lambda curve, to: curve.continuity_to(to).angle),
    'area': ((), lambda curve: abs(curve.signed_area())),
    'eccentricity': ((), _eccentricity),
    'arcs': ((), lambda curve: len(curve.finite_arcs(_FAR))),
}
