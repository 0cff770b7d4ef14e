"""Names of what lectures name: control points, weights, knots, functions, levels of a construction, marks; and where they stand."""

from typing import NamedTuple

import numpy as np

from ..base.words import phrase
from ..formulas import functions, orders, signs, teaching
from ..shape import definition as definitions
from ..shape import parameters
from ..verbs import verbs

#: Shapes with more labels show how many there are instead.
MOST = 400
#: Of a graph this number of points are looked at for the one farthest from 0.
_SAMPLES = 65


class Label(NamedTuple):
    """A text: its base, what stands below its line, what follows."""

    base: str
    below: str
    after: str
    point: tuple                        # (3,) in the space of the shape
    part: str = ""                      # the name of the piece of a picture that it belongs to


def of(definition):
    """The Labels of a definition; where there are too many one that says so."""
    is_picture = definition.has_curves and any(piece.name for piece in definition.pieces)
    found = _of_picture(definition) if is_picture else [*_of_points(definition), *_of_knots(definition)]
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
    for curve in verbs.curves_of(definition) if definition.has_curves else ():
        if not hasattr(curve, 'knots'):
            continue
        knots = np.array(curve.knots)
        at = parameters.inner_knots(curve)
        places = curve.evaluate(at, at_infinity='nan') if len(at) else ()
        for u, place in zip(at, places):
            if np.isfinite(place).all():
                found.append(Label("u", _range(np.flatnonzero(knots == u)), f" = {u:.4g}", tuple(place.tolist())))
    return found


def _range(numbers):
    return str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}…{numbers[-1]}"


def _of_picture(definition):
    found, named = [], set()
    curves = verbs.curves_of(definition)
    for piece, curve in zip(definition.pieces, curves):
        kind, _, rest = piece.name.partition(" ")
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
        elif piece.name.endswith("}") and piece.name not in named:
            named.add(piece.name)
            base, below = piece.name[:-1].split("_{")
            found.append(Label(base, below, "", _farthest(curve), piece.name))
    return found


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
