"""Names of what lectures name: control points, weights, knots, functions, levels of a construction, marks; and where they stand."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from ..shape import parameters, sewing
from ..verbs import verbs
from . import functions, orders, products, signs, teaching

#: Shapes with more labels show how many there are instead.
MOST = 400
#: Of a graph this number of points are looked at for the one farthest from 0, of one over a rectangle so many along each parameter.
_SAMPLES, _SAMPLES_EACH_WAY = 65, 33


class Label(NamedTuple):
    """A text: its base, what stands below its line, what follows, and what stands below the line of that."""

    base: str
    below: str
    after: str
    point: tuple                        # (3,) in the space of the shape
    part: str = ""                      # the name of the piece of a picture that it belongs to
    index: str = ""

    @property
    def runs(self):
        """[(text, whether it stands below the line)], none of them empty."""
        return [(text, is_below) for text, is_below in ((self.base, False), (self.below, True), (self.after, False), (self.index, True)) if text]


def of(definition):
    """The Labels of a definition; where there are too many one that says so."""
    if not any(piece.name for piece in definition.pieces):
        found = [*_of_points(definition), *(_of_knots(definition) if definition.has_curves else _of_knots_of_patches(definition))]
    else:
        found = _of_picture(definition) if definition.has_curves else _of_surfaces(definition)
    return found if len(found) <= MOST else [Label("", "", phrase("{number:,} names: too many to write", number=len(found)), found[0].point)]


def _of_points(definition):
    """Each point once, by the first piece that has it; P_i of a curve, P_{i,j} of a patch, after the number of its piece."""
    found, known = [], set()
    for number, piece in enumerate(definition.pieces):
        prefix = f"{number + 1}:" if len(definition.pieces) > 1 else ""
        indices = piece.indices if piece.kind != 'hermite' else piece.indices[0]
        for place in np.ndindex(indices.shape):
            row = int(indices[place])
            x, y, z, w = definition.pool[row].tolist()
            if row not in known and w != 0.0:
                weight = "" if w == 1.0 else f"  w = {w:.4g}"
                found.append(Label(f"{prefix}P", ",".join(map(str, place)), weight, (x, y, z)))
            known.add(row)
    return found


def _of_knots(definition):
    """u_i on curves at their inner knots, those that coincide together."""
    found = []
    for curve in verbs.curves_of(definition):
        if not hasattr(curve, 'knots'):
            continue
        knots = np.array(curve.knots)
        at = parameters.inner_knots(curve)
        places = curve.evaluate(at, at_infinity='nan') if len(at) else ()
        for u, place in zip(at, places):
            if np.isfinite(place).all():
                found.append(Label("u", _range(np.flatnonzero(knots == u)), f" = {u:.4g}", tuple(place.tolist())))
    return found


def _of_knots_of_patches(definition):
    """u_i and v_j at inner knots, along the sides where the other parameter begins."""
    return [label for patch in sewing.patches_of(definition) if isinstance(patch, sc.NurbsPatch) for axis in (0, 1)
            for label in _of_knots_along(patch, axis)]


def _of_knots_along(patch, axis):
    knots, (start, end) = np.array(patch.knots[axis]), patch.domain[axis]
    inner = np.unique(knots[(knots > start) & (knots < end)])
    other = patch.domain[1 - axis][:1]
    places = patch.evaluate_grid(*((inner, other) if axis == 0 else (other, inner)), at_infinity='nan').reshape(-1, 3) if len(inner) else ()
    return [Label("uv"[axis], _range(np.flatnonzero(knots == value)), f" = {value:.4g}", tuple(place.tolist()))
            for value, place in zip(inner, places) if np.isfinite(place).all()]


def _range(numbers):
    return str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}…{numbers[-1]}"


def _of_picture(definition):
    found, named = [], set()
    curves = verbs.curves_of(definition)
    for piece, curve in zip(definition.pieces, curves):
        kind, _, rest = piece.name.partition(" ")
        if kind == signs.TEXT:
            continue                    # it is written already
        if kind == functions.TICK:
            found.append(Label("", "", rest, tuple(curve.points[0].tolist()), piece.name))
        elif kind in (signs.MARK, signs.ARROW):
            found.append(Label(*signs.named(piece.name), tuple(signs.place_of(piece.name, curve.points).tolist()), piece.name))
        elif kind == orders.ORDER:
            found.append(Label("", "", rest, _below(curve), piece.name))
        elif kind == "level":
            found += _of_level(piece.name, int(rest), curve.points)
        elif kind == teaching.POINT:
            found += _of_last_level(definition.pieces, curves, piece.name, curve.points)
        elif products.factors(piece.name) and piece.name not in named:
            named.add(piece.name)
            found.append(_of_functions(piece.name, _farthest(curve)))
    return found


def _of_surfaces(definition):
    """Products of functions, each once, where it is farthest from 0."""
    tops = {}
    for piece, patch in zip(definition.pieces, sewing.patches_of(definition)):
        if products.factors(piece.name):
            tops.setdefault(piece.name, []).append(_top(patch))
    return [_of_functions(name, max(places, key=lambda place: abs(place[2]))) for name, places in tops.items()]


def _of_functions(name, place):
    """Of one function, or of the product of two."""
    (base, below), *other = products.factors(name)
    after, index = other[0] if other else ("", "")
    return Label(base, below, after and f" {after}", place, name, index)


def _top(patch):
    """Where a graph over a rectangle is farthest from 0."""
    points = patch.evaluate_grid(*(np.linspace(*interval, _SAMPLES_EACH_WAY) for interval in patch.domain)).reshape(-1, 3)
    return tuple(points[np.abs(points[:, 2]).argmax()].tolist())


def _of_level(part, level, points):
    """P_i, M_{01}, M_{012}: by the control points that they come from."""
    name = "P" if level == 0 else "M"
    return [Label(name, "".join(map(str, range(i, i + level + 1))), "", tuple(point.tolist()), part) for i, point in enumerate(points)]


def _of_last_level(pieces, curves, part, circle):
    """The point that all control points lead to, where a polygon says how many there are."""
    counts = [int(piece.name.partition(" ")[2]) + len(curve.points) - 1 for piece, curve in zip(pieces, curves) if piece.name.startswith("level ")]
    if not counts:
        return []
    middle = (circle.min(axis=0) + circle.max(axis=0)) / 2.0
    return [Label("M", "".join(map(str, range(max(counts) + 1))), "", tuple(middle.tolist()), part)]


def _below(curve):
    """Under the first of its points that is a place."""
    places = curve.points[curve.weights != 0.0]
    return float(places[:, 0].min()), float(places[:, 1].min()), float(places[0, 2])


def _farthest(curve):
    """Where a graph is farthest from 0."""
    points = curve.evaluate(np.linspace(*curve.domain, _SAMPLES))
    return tuple(points[np.abs(points[:, 1]).argmax()].tolist())
