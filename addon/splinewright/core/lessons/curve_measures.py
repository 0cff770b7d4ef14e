"""Measures of curves as outlines and strips, of their knots, of their points' influence, and of conics, for measures.py."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..formulas import ducks, influence
from ..shape import definition as definitions

#: Beyond this distance from the control points a curve counts as gone to infinity.
_FAR = 1000.0
#: At so many places curves are compared; from this part of its size on a curve lies off another one.
_PLACES, _OFF = 401, 1e-3


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


def _energy(curve):
    nurbs = curve.to_nurbs()
    if nurbs.is_rational:
        raise Refusal("the bending energy is that of a curve without weights")
    found = ducks.energy(nurbs)
    if not np.isfinite(found):
        raise Refusal("the curve stops or turns back: it has no bending energy")
    return found


def _influence(curve, index):
    found = influence.of_curves(definitions.from_value(curve), 1, int(index), 0.0).share
    if found is None:
        raise Refusal("the curve has no length")
    return found


def _away(curve, to):
    """Which part of its length lies off another curve."""
    places = curve.evaluate(np.linspace(*curve.domain, _PLACES))
    lengths = np.linalg.norm(np.diff(places, axis=0), axis=1)
    if not lengths.sum() > 1e-12 * np.abs(places).max():
        raise Refusal("the curve has no length")
    is_off = np.linalg.norm(to.nearest(places).points - places, axis=1) > _OFF * np.ptp(places, axis=0).max()
    return (is_off[:-1] & is_off[1:]) @ lengths / lengths.sum()


#: {name: (what it takes, function)}. `index` counts from 0; `influence` is the part of the length that a control point moves, `away` that
#: which lies off another curve.
MEASURES = {
    'start': ((), lambda curve: curve.domain[0]),
    'end': ((), lambda curve: curve.domain[1]),
    'knot': (('index',), _knot),
    'closed': ((), lambda curve: curve.is_closed),
    'corners': ((), _corners),
    'area': ((), lambda curve: abs(curve.signed_area())),
    'eccentricity': ((), _eccentricity),
    'energy': ((), _energy),
    'influence': (('index',), _influence),
    'away': (('to',), _away),
    'arcs': ((), lambda curve: len(curve.to_nurbs().finite_arcs(_FAR))),
}
