"""Which edges of surfaces are rounded, and what results."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.numbers_in_words import numbers_of
from . import planes, rolling
from .body import body_of, require_two
from .cells import cells_of


#: At which an edge of one pair of sides is seen.
_PLACES = 49


class Rounded(NamedTuple):
    patches: list
    error: float
    count: int                          # of edges that were rounded


def rounded(shapes, text, radius, tolerance, cancel=None):
    """Lists of patches with edges of theirs rounded: those whose numbers a text has; without numbers those in which two shapes
    meet, or if there are not two of them, all. Raises Refusal or an error of the library."""
    body = body_between(shapes)
    if not body.edges:
        raise Refusal("there is no edge: no two sides lie on each other with an angle between their surfaces")
    numbers = _chosen(body, len(shapes), text)
    if not numbers:
        raise Refusal("no side of one surface lies on a side of the other one with an angle between them")
    chosen = [body.edges[number - 1] for number in numbers]
    for edge in chosen:
        require_two(body, edge)
    rolled = [edge for edge in chosen if not is_of_planes(body, edge)]
    flat = [edge for edge in chosen if is_of_planes(body, edge)]
    _require_apart(body, rolled, flat)
    places, error = {edge.number: _place_of(edge) for edge in body.edges}, 0.0
    for edge in rolled:
        now = _found(body, edge.number)
        cells, off = rolling.rolled(body, now, radius, tolerance, cancel)
        body, error = _numbered(body_of([(cell, 0) for cell in cells]), places), max(error, off)
    if flat:
        now = [_found(body, edge.number) for edge in flat]
        return Rounded(planes.rounded(body, now, radius), error, len(chosen))
    return Rounded(body.cells, error, len(chosen))


def _chosen(body, count, text):
    """The numbers of a text; without any those of edges in which two shapes meet, or if there are not two of them, of all."""
    chosen = numbers_of(text, "an edge", len(body.edges))
    return chosen or [edge.number for edge in body.edges if count != 2 or is_between(body, edge)]


def body_between(shapes):
    """The Body of lists of patches, whose cells belong to the number of their list."""
    patches = [(patch, i) for i, those in enumerate(shapes) for patch in those]
    return body_of([(cell, patches[number][1]) for cell, number in cells_of([patch for patch, _ in patches])])


def meet(shapes):
    """Whether two lists of patches have an edge in common."""
    body = body_between(shapes)
    return any(is_between(body, edge) for edge in body.edges)


def is_between(body, edge):
    """Whether two shapes meet in an edge."""
    return any(body.owners[first.cell] != body.owners[second.cell] for first, second in edge.pairs)


def middles_of(shapes):
    """(n, 3): a point on each edge of lists of patches, in the order of their numbers."""
    return np.array([_place_of(edge) for edge in body_between(shapes).edges]).reshape(-1, 3)


def lines_of(shapes, text):
    """([(n, 3)]: points along each edge of lists of patches, in the order of their numbers; the numbers that are rounded by a text).
    Raises Refusal."""
    body = body_between(shapes)
    lines = [np.concatenate([_points_of(first.curve) for first, _ in edge.pairs]) for edge in body.edges]
    return lines, _chosen(body, len(shapes), text)


def _points_of(curve):
    return curve.evaluate(np.linspace(*curve.domain, _PLACES))


def is_of_planes(body, edge):
    """Whether an edge is one segment between two planes."""
    a, b = ({body.face_of[pair[i].cell] for pair in edge.pairs} for i in range(2))
    if edge.is_closed or len(a) > 1 or len(b) > 1:
        return False
    if any(body.faces[face].plane is None for face in a | b):
        return False
    points = np.concatenate([np.asarray(first.curve.points) for first, _ in edge.pairs])
    along = points[-1] - points[0]
    return bool(np.linalg.norm(np.cross(points - points[0], along), axis=1).max() <= 1e-9 * (along @ along))


def _ends(edge):
    return {edge.pairs[0][0].start, edge.pairs[-1][0].end}


def _require_apart(body, rolled, flat):
    """Raises Refusal where edges that are not all of planes end in one corner."""
    for i, edge in enumerate(rolled):
        for other in (*rolled[i + 1:], *flat):
            shared = _ends(edge) & _ends(other)
            if shared:
                raise Refusal("{body}: edges {number} and {other_number} end there, and not all surfaces there are planes: round "
                              "one of them first, then the others with a smaller radius",
                              body=planes.named(body, min(shared)), number=edge.number, other_number=other.number)


def _place_of(edge):
    """In the middle of an edge."""
    curve = edge.pairs[len(edge.pairs) // 2][0].curve
    return curve.evaluate(0.5 * sum(curve.domain))


def _numbered(body, places):
    """A Body whose edges have the numbers of the places on them, by which users know them; 0 of what was not there."""
    for edge in body.edges:
        edge.number = next((number for number, place in places.items() if any(
            first.curve.nearest(place[None]).distances[0] <= 1e-6 * body.size for first, _ in edge.pairs)), 0)
    return body


def _found(body, number):
    for edge in body.edges:
        if edge.number == number:
            return edge
    raise Refusal("edge {number} is lost where another one is rounded: round them one after the other", number=number)
