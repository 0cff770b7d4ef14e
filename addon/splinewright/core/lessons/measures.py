"""Numbers of the shapes of a lesson: a closed list. Nothing of a lesson's file is ever run."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import curve_measures, facets, seam_measures, surface_measures
from .lesson import Measure


class Shown(NamedTuple):
    """A shape that is there: its value, the settings of its recipe, and how a surface is drawn."""

    value: object
    settings: dict
    facets: object = None               # () -> facets.Facets; None of a curve


def measured(measure, shapes):
    """The number of a Measure; shapes: {name: Shown}. Raises Refusal, or an error of the library."""
    shown, kind = _known(shapes, measure.shape), KINDS[measure.kind]
    given = {name: measured(value, shapes) if isinstance(value, Measure) else value for name, value in measure.arguments.items()}
    if 'to' in given:
        given['to'] = _TAKEN[kind.of](_known(shapes, given['to']), 1)
    return float(kind.function(_TAKEN[kind.of](shown, int(given.pop('piece', 1))), **given))


def _known(shapes, name):
    if name not in shapes:
        raise Refusal("there is no shape {name!r} now", name=name)
    return shapes[name]


def _setting(shown, name):
    if not isinstance(shown.settings.get(name), (int, float)):
        raise Refusal("the shape has no number {name!r}", name=name)
    return shown.settings[name]


def _curve(shown, piece):
    values = shown.value if isinstance(shown.value, list) else [shown.value]
    if not 1 <= piece <= len(values):
        raise Refusal("there is no piece {piece}", piece=piece)
    if not hasattr(values[piece - 1], 'domain') or isinstance(values[piece - 1].domain[0], tuple):
        raise Refusal("it is not a curve")
    return values[piece - 1]


def _patches(shown, _piece):
    found = shown.value if isinstance(shown.value, (list, sc.PatchSet)) else [shown.value]
    if not len(found) or not hasattr(found[0], 'domain') or not isinstance(found[0].domain[0], tuple):
        raise Refusal("it is not a surface")
    return [found[i] for i in range(len(found))]


#: What the function of a Kind takes, of a Shown and the number of a piece.
_TAKEN = {'curve': _curve, 'patches': _patches, 'shown': lambda shown, _piece: shown}


def _coordinate(axis):
    return lambda curve, at: curve.evaluate(at)[axis]


def _point(axis):
    return lambda curve, index: np.asarray(curve.points).reshape(-1, 3)[_index(curve, index)][axis]


def _index(curve, index):
    if not 0 <= index < len(curve.points):
        raise Refusal("there is no control point {index:g}", index=index)
    return int(index)


def _weight(curve, index):
    number, weights = _index(curve, index), getattr(curve, 'weights', None)      # Hermite chains have none
    return 1.0 if weights is None else weights[number]


def _continuity(name):
    return lambda curve, at: getattr(curve.to_nurbs().continuity(at), name)


def _multiplicity(curve, at):
    return int((np.asarray(curve.to_nurbs().knots) == at).sum())


def _distance(curve, to):
    """How far points of a curve lie from another one at most."""
    places = curve.evaluate(np.linspace(*curve.domain, 101))
    return np.linalg.norm(to.nearest(places).points - places, axis=1).max()


def _basis(curve, index, at):
    nurbs = curve.to_nurbs()
    return nurbs.knot_vector.function(_index(nurbs, index), np.array([at]))[0]


def _speed(curve, at):
    return np.linalg.norm(curve.to_nurbs().derivatives([at], 1)[0][1])


def _jump(curve, at, order):
    """How far the derivatives of an order on both sides of a parameter differ."""
    nurbs, order = curve.to_nurbs(), int(order)
    if not 0 <= order <= nurbs.degree:
        raise Refusal("derivatives have the orders 0 to {degree}", degree=nurbs.degree)
    before, after = (nurbs.derivatives(at, order, side=side)[order] for side in ('left', 'right'))
    return np.linalg.norm(after - before)


def _joint(name):
    return lambda curve, to: getattr(curve.continuity_to(to), name)


def _limit(end, axis):
    return lambda curve: curve.bounding_box()[end][axis]


def _drawn(function):
    """A measure of how a surface is drawn."""
    def found(shown):
        if shown.facets is None:
            raise Refusal("it is not a surface")
        return function(shown.facets(), shown.value)
    return found


class Kind(NamedTuple):
    """A kind of Measure: what it takes beside the shape, and how it is found."""

    takes: tuple
    function: object
    of: str = 'curve'                   # what the function takes: a 'curve', of which the piece can be said, its 'patches', or the 'shown'


#: What measures there are. `at` is a parameter, `index` counts control points from 0, `to` is another curve; joint_… is said of the end
#: of a curve and the start of that one, low_x … high_z are the limits of the box around a curve. Angles are in radians.
KINDS = {
    **{axis: Kind(('at',), _coordinate(i)) for i, axis in enumerate("xyz")},
    **{f"point_{axis}": Kind(('index',), _point(i)) for i, axis in enumerate("xyz")},
    'weight': Kind(('index',), _weight),
    'count': Kind((), lambda curve: len(curve.points)),
    'degree': Kind((), lambda curve: curve.degree),
    'length': Kind((), lambda curve: curve.length()),
    'multiplicity': Kind(('at',), _multiplicity),
    **{name: Kind(('at',), _continuity(name)) for name in ('c', 'g', 'gap', 'angle')},
    'curvature': Kind(('at',), lambda curve, at: curve.curvature(at)),
    'speed': Kind(('at',), _speed),
    'jump': Kind(('at', 'order'), _jump),
    'basis': Kind(('index', 'at'), _basis),
    'distance': Kind(('to',), _distance),
    **{f"joint_{name}": Kind(('to',), _joint(name)) for name in ('c', 'g', 'gap', 'angle')},
    **{f"{name}_{axis}": Kind((), _limit(end, i)) for end, name in enumerate(('low', 'high')) for i, axis in enumerate("xyz")},
    'self_intersections': Kind((), lambda curve: len(curve.to_nurbs().self_intersections().points)),
    'setting': Kind(('name',), _setting, 'shown'),
    'faces': Kind((), _drawn(facets.count), 'shown'),
    'facet_distance': Kind((), _drawn(facets.distance), 'shown'),
    **{name: Kind(*each) for name, each in curve_measures.MEASURES.items()},
    **{name: Kind(*each, 'patches') for name, each in (seam_measures.MEASURES | surface_measures.MEASURES).items()},
}
#: Errors that measure() may raise.
FAILURES = (Refusal, sc.Error)
