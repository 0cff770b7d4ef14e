"""The part of a curve or surface that a control point moves (S14, S16): where its function is not zero."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import definition as definitions
from . import signs
from .functions import Part

INFLUENCE = "influence"


class Moved(NamedTuple):
    """What a control point moves, and which part that is of all, by length or area; None where that is infinite."""

    parts: list                         # of Part
    share: float | None


def of_curves(definition, piece, index, marker):
    """Moved of a control point of a definition of curves; pieces count from 1, points from 0. Raises Refusal."""
    row = _row(definition, piece, (index,))
    curves = _values(definition)
    parts = [curve.to_nurbs().part(*interval) for number, curve in enumerate(curves) for place in _places(definition, number, row)
             for interval in _intervals(*_axis_of_curve(curve), place[0])]
    parts = _once(parts)
    point = definition.pool[row]
    marks = signs.cross(f"P_{{{index}}}", signs.place(_homogeneous(point)), marker)
    return Moved([Part(INFLUENCE, one) for one in parts] + marks, _share([one.length for one in parts], [one.to_nurbs().length for one in curves]))


def of_patches(definition, piece, index, above):
    """Moved of a control point (i, j) of a definition of patches. above: how far from the surface parts are drawn, on both sides."""
    row = _row(definition, piece, index)
    patches = _values(definition)
    parts = [part for number, patch in enumerate(patches) for place in _places(definition, number, row) for part in _rectangles(patch, place)]
    parts = _once(parts)
    shown = [beside for part in parts for beside in ([part] if above == 0.0 else [_beside(part, above), _beside(part, -above)])]
    return Moved([Part(INFLUENCE, one) for one in shown], _share([one.area for one in parts], [one.to_nurbs().area for one in patches]))


def _values(definition):
    value = definitions.to_value(definition)
    return list(value) if definition.form in ('curves', 'patch_set') else [value]


def _row(definition, piece, place):
    if piece > len(definition.pieces):
        raise Refusal("there is no piece {piece}: there are {count}",
                      "there is no piece {piece}: there is {count}", piece=piece, count=len(definition.pieces))
    indices = _points_of(definition.pieces[piece - 1])
    if any(at >= count for at, count in zip(place, indices.shape)):
        last = ", ".join(str(count - 1) for count in indices.shape)
        raise Refusal("there is no control point {place}: the last one is {last}", place=', '.join(map(str, place)), last=last)
    return int(indices[place])


def _points_of(piece):
    """Without the derivatives of Hermite pieces."""
    return piece.indices[0] if piece.kind == 'hermite' else piece.indices


def _places(definition, number, row):
    """Where a row of the pool is a control point of a piece."""
    return [tuple(map(int, place)) for place in np.argwhere(_points_of(definition.pieces[number]) == row)]


def _homogeneous(row):
    return np.array([*(row[:3] * row[3] if row[3] != 0.0 else row[:3]), row[3]])


def _axis_of_curve(curve):
    """(degree, knots, domain, the number of points, whether it is periodic); a degree of 0 for nodes of a Hermite chain."""
    if isinstance(curve, sc.HermiteCurve):
        return 0, np.array(curve.parameters), curve.to_nurbs().domain, len(curve.points), False
    nurbs = curve.to_nurbs()
    return nurbs.degree, np.array(nurbs.unrolled().knots), nurbs.domain, len(nurbs.points), nurbs.periodic


def _axis_of_patch(patch, axis):
    if isinstance(patch, sc.HermitePatch):
        nodes = np.array(patch.parameters[axis])
        return 0, nodes, (nodes[0], nodes[-1]), len(nodes), False
    nurbs = patch.to_nurbs()
    return nurbs.degree[axis], np.array(nurbs.unrolled().knots[axis]), nurbs.domain[axis], nurbs.points.shape[axis], nurbs.periodic[axis]


def _intervals(degree, knots, domain, count, is_periodic, index):
    """Of the domain, on which a control point acts; two where that goes across the seam of a periodic axis."""
    if degree == 0:
        return [(knots[max(index - 1, 0)], knots[min(index + 1, count - 1)])]
    start, end = domain
    numbers = range(index, len(knots) - degree - 1, count) if is_periodic else (index,)
    found = [(max(knots[i], start), min(knots[i + degree + 1], end)) for i in numbers]
    found = sorted(each for each in found if each[0] < each[1])
    return [(start, end)] if any(b[0] < a[1] for a, b in zip(found, found[1:])) else found


def _rectangles(patch, place):
    nurbs = patch.to_nurbs()
    axes = [_intervals(*_axis_of_patch(patch, axis), place[axis]) for axis in (0, 1)]
    return [_part(_part(nurbs, 'u', u), 'v', v) for u in axes[0] for v in axes[1]]


def _part(patch, axis, interval):
    """A patch between two parameters along an axis, 'u' or 'v'."""
    number = 'uv'.index(axis)
    plain = patch.unrolled() if patch.periodic[number] else patch
    for at, which in zip(interval, (-1, 0)):
        start, end = plain.domain[number]
        if start < at < end:
            plain = plain.split(axis, at)[which]
    return plain


def _once(parts):
    """Without those that are there already: a point that a piece has twice."""
    return [one for i, one in enumerate(parts) if one not in parts[:i]]


def _beside(patch, distance):
    """Its control points moved along the normals nearest to them."""
    start, end = np.array(patch.domain).T
    places = [np.clip(vector.greville, first, last) for vector, first, last in zip(patch.knot_vectors, start, end)]
    normals = patch.evaluate_grid_with_normals(*places)[1]
    return patch.with_points(patch.points + distance * np.nan_to_num(normals))


def _share(parts, wholes):
    try:
        whole = sum(measure() for measure in wholes)
        return min(sum(measure() for measure in parts) / whole, 1.0) if whole > 0.0 else None
    except sc.Error:
        return None
