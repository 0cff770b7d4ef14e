"""Plane faces as loops of their sides."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Corners that turn by less have no inside; nor have places with less room, as a part of the size.
_LEAST_SINE = 1e-9
#: Tangents of a span of a side that are looked at.
_SAMPLES = 8


class Span(NamedTuple):
    """A side of a face, or all of an edge that is rounded, with the face on its left."""

    start: int                          # numbers of corners
    end: int
    curves: tuple
    edge: int                           # the number of the edge if it is rounded; 0 otherwise
    across: int | None                  # the number of the face on its other side

    @property
    def is_line(self):
        """Whether it is one segment, whatever the paces of its curves."""
        points = np.concatenate([np.asarray(curve.points) for curve in self.curves])
        along = points[-1] - points[0]
        length = np.linalg.norm(along)
        return bool(length > 0.0 and np.linalg.norm(np.cross(points - points[0], along), axis=1).max() <= 1e-9 * length**2)


@dataclass
class Outline:
    """Of a face: its unit normal, and its Spans one behind the other."""

    face: int
    normal: np.ndarray
    spans: list

    def at(self, corner):
        """(the number of the Span that ends in a corner, that of the one that starts there)."""
        ending, = [i for i, span in enumerate(self.spans) if span.end == corner]
        return ending, (ending + 1) % len(self.spans)


def outline_of(body, face, edge_of, named):
    """The Outline of a plane face. edge_of: {number of a side: that of its edge}, of edges that are rounded. Raises Refusal."""
    normal = body.faces[face].plane[1]
    parts = []
    for i, side in enumerate(body.sides):
        if body.face_of[side.cell] != face:
            continue
        other = body.across.get(i)
        across = None if other is None else body.face_of[body.sides[other].cell]
        if across == face:
            continue
        span = Span(side.start, side.end, (side.curve,), edge_of.get(i, 0), across)
        parts.append(span if body.planes[side.cell][1] @ normal > 0.0 else _back(span))
    return Outline(face, normal, _merged(_loop(parts, named)))


def _back(span):
    return span._replace(start=span.end, end=span.start, curves=tuple(curve.reversed() for curve in span.curves[::-1]))


def _loop(parts, named):
    following = {}
    for part in parts:
        if part.start in following:
            raise Refusal("{named}: a plane surface beside it touches itself in a corner", named=named)
        following[part.start] = part
    loop = [parts[0]]
    while loop[-1].end in following and following[loop[-1].end] is not loop[0] and len(loop) < len(parts):
        loop.append(following[loop[-1].end])
    if len(loop) < len(parts):
        raise Refusal("{named}: a plane surface beside it has a hole", named=named)
    return loop


def _merged(loop):
    """With sides of one rounded edge as one, and open ones that go straight on."""
    start = next((i for i, span in enumerate(loop) if not _are_one(loop[i - 1], span)), 0)
    found = []
    for span in loop[start:] + loop[:start]:
        if found and _are_one(found[-1], span):
            found[-1] = found[-1]._replace(end=span.end, curves=(*found[-1].curves, *span.curves))
        else:
            found.append(span)
    return found


def _are_one(span, following):
    if span.edge or following.edge:
        return span.edge == following.edge
    together = span._replace(curves=(*span.curves, *following.curves))
    ways = [one.curves[-1].points[-1] - one.curves[0].points[0] for one in (span, following)]
    return span.across is None and following.across is None and together.is_line and ways[0] @ ways[1] > 0.0


def segment(start, end):
    """A row (2, 4) of points with weights."""
    return np.c_[[start, end], np.ones(2)]


def filled(pieces, normal, size):
    """NurbsPatches within a loop of pieces in a plane: rows (n, 4) of points with weights in Bernstein form, or curves. One where
    these are four segments, otherwise as many as pieces, about a point that sees them all, or points that see parts between chords.
    [] where there are none."""
    if len(pieces) == 4 and all(isinstance(piece, np.ndarray) and len(piece) == 2 for piece in pieces):
        corners = np.array([piece[0, :3] for piece in pieces])
        return [_quad(corners)] if _is_convex(corners, normal, size) else []
    curves = [_curve(piece) for piece in pieces]
    point = _point_that_sees(curves, normal, size)
    return _by_chords(curves, normal) if point is None else [_wedge(curve, point) for curve in curves]


def _by_chords(curves, normal):
    """Patches whose v_start are all of these curves, and chords."""
    try:
        made = list(sc.build.fill_rim(curves).value)
    except sc.InvalidShape:
        return []
    made = [patch if _turn(patch) @ normal > 0.0 else patch.reversed('u') for patch in made]
    rims = [np.asarray(patch.boundary('v_start').points) for patch in made]
    are_kept = all(any(np.array_equal(rim, curve.points) for rim in rims) for curve in curves)
    return made if are_kept else []


def _turn(patch):
    u, v = (0.5 * sum(domain) for domain in patch.domain)
    jets = patch.derivatives([u], [v], 1)[0]
    return np.cross(jets[1, 0], jets[0, 1])


def _quad(corners):
    knots = np.array([0.0, 0.0, 1.0, 1.0])
    return sc.NurbsPatch((1, 1), (knots, knots), corners[[[0, 3], [1, 2]]])


def _is_convex(corners, normal, size):
    ways = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(np.roll(ways, 1, axis=0), ways) @ normal
    lengths = np.linalg.norm(ways, axis=1)
    return bool((turns > _LEAST_SINE * lengths * np.roll(lengths, 1)).all() and lengths.min() > _LEAST_SINE * size)


def _curve(piece):
    if not isinstance(piece, np.ndarray):
        return piece
    return sc.NurbsCurve(len(piece) - 1, np.repeat([0.0, 1.0], len(piece)), piece[:, :3], piece[:, 3])


def _wedge(curve, point):
    """v from a curve to a point."""
    points, weights = np.asarray(curve.points), np.asarray(curve.weights)
    net = np.stack([points, np.broadcast_to(point, points.shape)], axis=1)
    return sc.NurbsPatch((curve.degree, 1), (curve.knots, [0.0, 0.0, 1.0, 1.0]), net, np.stack([weights, weights], axis=1))


def _point_that_sees(curves, normal, size):
    """The middle of what lies to the left of the tangents of all curves in a plane; None where nothing does."""
    points, ways = [], []
    for curve in curves:
        knots = np.unique(curve.knots)
        inner = np.linspace(knots[:-1], knots[1:], _SAMPLES, endpoint=False).T.ravel()
        jets = np.concatenate([curve.derivatives(inner, 1), curve.derivatives(knots[-1:], 1, side='left')])
        points.append(jets[:, 0])
        ways.append(jets[:, 1])
    points, lefts = np.concatenate(points), np.cross(normal, np.concatenate(ways))
    lengths = np.linalg.norm(lefts, axis=1)
    if not lengths.min() > 0.0:
        return None
    lefts /= lengths[:, None]
    seeing = _square(points, normal)
    for point, left in zip(points, lefts):
        seeing = _left_part(seeing, point, left)
        if len(seeing) < 3:
            return None
    middle = _middle(seeing)
    room = np.einsum('ij,ij->i', lefts, middle - points).min()
    return middle if room > _LEAST_SINE * size else None


def _square(points, normal):
    """(4, 3): around points in a plane."""
    x = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    x *= 2.0 * np.ptp(points, axis=0).max() / np.linalg.norm(x)
    y = np.cross(normal, x)
    return points.mean(axis=0) + np.array([-x - y, x - y, x + y, y - x])


def _left_part(polygon, point, left):
    """The part of a convex polygon to one side of a line."""
    rooms = (polygon - point) @ left
    found = []
    for i in range(len(polygon)):
        a, b = rooms[i - 1], rooms[i]
        if (a < 0.0) != (b < 0.0):
            found.append(polygon[i - 1] + a / (a - b) * (polygon[i] - polygon[i - 1]))
        if b >= 0.0:
            found.append(polygon[i])
    return np.array(found).reshape(-1, 3)


def _middle(polygon):
    """Of the area of a convex polygon."""
    spokes = polygon - polygon[0]
    areas = np.linalg.norm(np.cross(spokes[1:-1], spokes[2:]), axis=1)
    if not areas.sum() > 0.0:
        return polygon.mean(axis=0)
    return polygon[0] + areas @ (spokes[1:-1] + spokes[2:]) / (3.0 * areas.sum())
