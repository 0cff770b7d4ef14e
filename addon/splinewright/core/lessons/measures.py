"""Numbers of the shapes of a lesson: a closed list. Nothing of a lesson's file is ever run."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import curve_measures, seam_measures
from .lesson import Measure


class Shown(NamedTuple):
    """A shape that is there: its value, and the settings of its recipe."""

    value: object
    settings: dict


def measured(measure, shapes):
    """The number of a Measure; shapes: {name: Shown}. Raises Refusal, or an error of the library."""
    if measure.shape not in shapes:
        raise Refusal(f"there is no shape {measure.shape!r} now")
    shown = shapes[measure.shape]
    given = {name: measured(value, shapes) if isinstance(value, Measure) else value for name, value in measure.arguments.items()}
    if measure.kind == 'setting':
        return _setting(shown, **given)
    kind = KINDS[measure.kind]
    taken = _patches if kind.is_of_patches else _curve
    if 'to' in given:
        given['to'] = taken(_known(shapes, given['to']), 1)
    return float(kind.function(taken(shown, int(given.pop('piece', 1))), **given))


def _known(shapes, name):
    if name not in shapes:
        raise Refusal(f"there is no shape {name!r} now")
    return shapes[name]


def _setting(shown, name):
    if not isinstance(shown.settings.get(name), (int, float)):
        raise Refusal(f"the shape has no number {name!r}")
    return float(shown.settings[name])


def _curve(shown, piece):
    values = shown.value if isinstance(shown.value, list) else [shown.value]
    if not 1 <= piece <= len(values):
        raise Refusal(f"there is no piece {piece}")
    if not hasattr(values[piece - 1], 'domain') or isinstance(values[piece - 1].domain[0], tuple):
        raise Refusal("it is not a curve")
    return values[piece - 1]


def _patches(shown, _piece):
    found = shown.value if isinstance(shown.value, (list, sc.PatchSet)) else [shown.value]
    if not hasattr(found[0], 'domain') or not isinstance(found[0].domain[0], tuple):
        raise Refusal("it is not a surface")
    return [found[i] for i in range(len(found))]


def _coordinate(axis):
    return lambda curve, at: curve.evaluate(at)[axis]


def _point(axis):
    return lambda curve, index: np.asarray(curve.points).reshape(-1, 3)[_index(curve, index)][axis]


def _index(curve, index):
    if not 0 <= index < len(curve.points):
        raise Refusal(f"there is no control point {index:g}")
    return int(index)


def _weight(curve, index):
    return 1.0 if curve.weights is None else curve.weights[_index(curve, index)]


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


class Kind(NamedTuple):
    """A kind of Measure: what it takes beside the shape and a piece, and how it is found of a curve."""

    takes: tuple
    function: object
    is_of_patches: bool = False         # its function takes the patches of the shape


#: What measures there are beside 'setting', a number of a recipe. `at` is a parameter, `index` counts control points from 0.
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
    'basis': Kind(('index', 'at'), _basis),
    'distance': Kind(('to',), _distance),
    'self_intersections': Kind((), lambda curve: len(curve.to_nurbs().self_intersections().points)),
    'setting': Kind(('name',), None),
    **{name: Kind(*each) for name, each in curve_measures.MEASURES.items()},
    **{name: Kind(*each, True) for name, each in seam_measures.MEASURES.items()},
}
#: Errors that measure() may raise.
FAILURES = (Refusal, sc.Error)
