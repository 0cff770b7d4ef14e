"""Measures of curves as outlines, of their knots and of conics: numbers by name, for measures.py."""

from ..base.failures import Refusal
from ..base.library import sc

#: Beyond this distance from the control points a curve counts as gone to infinity.
_FAR = 1000.0


def _knot(curve, index):
    knots = curve.to_nurbs().knots
    if not 0 <= index < len(knots):
        raise Refusal("there is no knot {index:g}", index=index)
    return knots[int(index)]


def _corners(curve):
    return sum(joint.g < 1 for _, joint in curve.to_nurbs().joints())


def _eccentricity(curve):
    found = sc.conics.implicit(curve).eccentricity
    if found is None:
        raise Refusal("the conic is degenerate")
    return found


#: {name: (what it takes, function)}. `index` counts from 0.
MEASURES = {
    'start': ((), lambda curve: curve.domain[0]),
    'end': ((), lambda curve: curve.domain[1]),
    'knot': (('index',), _knot),
    'closed': ((), lambda curve: curve.is_closed),
    'corners': ((), _corners),
    'area': ((), lambda curve: abs(curve.signed_area())),
    'eccentricity': ((), _eccentricity),
    'arcs': ((), lambda curve: len(curve.to_nurbs().finite_arcs(_FAR))),
}
