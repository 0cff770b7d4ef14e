"""Contours that are drawn point after point: segments, and arcs that continue the part before them."""

import math
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

SEGMENT, ARC = 'segment', 'arc'
#: Ends of parts differ by rounding alone: as a part of the size.
_ROUNDING = 1e-9
#: A point that turns less from where the contour goes, in radians, lies straight on: no arc goes there but a segment.
_STRAIGHT = 1e-6


class Contour(NamedTuple):
    """Points that follow each other, what leads to each but the first, and whether the last leads to the first again, and by
    what."""

    points: tuple = ()                  # of (x, y, z)
    kinds: tuple = ()                   # SEGMENT or ARC
    closed: bool = False
    closing: str = SEGMENT

    def after(self, point, kind):
        if not self.points:
            return self._replace(points=(tuple(point),))
        return self._replace(points=(*self.points, tuple(point)), kinds=(*self.kinds, kind))

    def without_repeats(self):
        """Without points that lie where the one before them lies, and the parts that lead there."""
        kept = [i for i in range(len(self.points)) if i == 0 or self.points[i] != self.points[i - 1]]
        is_back = self.closed and len(kept) > 2 and self.points[kept[-1]] == self.points[0]
        found = self._replace(points=tuple(self.points[i] for i in kept), kinds=tuple(self.kinds[i - 1] for i in kept[1:]))
        return found._replace(points=found.points[:-1], kinds=found.kinds[:-1], closing=found.kinds[-1]) if is_back else found

    def sides(self):
        """Numbers, from 1, of the sides that are arcs; that to the first point again is the last."""
        of_all = (*self.kinds, self.closing) if self.closed else self.kinds
        return [i + 1 for i, kind in enumerate(of_all) if kind == ARC]

    def shortened(self):
        return self._replace(points=self.points[:-1], kinds=self.kinds[:-1])


def parts_of(contour):
    """The curves of a contour, one after the other. Raises Refusal where there are none."""
    points = [np.array(point) for point in contour.points]
    kinds = list(contour.kinds)
    if contour.closed and len(points) > 2:
        points.append(points[0])
        kinds.append(contour.closing)
    parts, way = [], None
    for start, end, kind in zip(points, points[1:], kinds):
        if np.array_equal(start, end):
            continue
        parts.append(_arc(start, way, end) if kind == ARC and way is not None else sc.BezierCurve([start, end]))
        way = parts[-1].derivatives(parts[-1].domain[1], 1, side='left')[1]
    if not parts:
        raise Refusal("a contour needs two points")
    return parts


def _arc(start, way, end):
    chord = end - start
    turn = math.atan2(np.linalg.norm(np.cross(way, chord)), way @ chord)
    if turn < _STRAIGHT:
        return sc.BezierCurve([start, end])
    if turn > math.pi - _STRAIGHT:
        raise Refusal("an arc cannot go straight back")
    return sc.conics.arc_from_tangent(start, way, end)


def curve_of(contour, radius=0.0):
    """A contour as one curve; its corners are arcs of a radius where that is above 0. Raises Refusal or an error of the
    library."""
    parts = parts_of(contour)
    size = np.abs(np.array(contour.points)).max()
    whole = sc.build.join_curves(parts, _ROUNDING * size)[0]
    return whole.rounded(radius) if radius > 0 else whole


def through(points, arcs, closed):
    """A Contour through points (n, 3) of which the sides with these numbers, from 1, are arcs; numbers of none count nothing."""
    kinds = [ARC if i + 1 in arcs else SEGMENT for i in range(len(points))]
    return Contour(tuple(map(tuple, points)), tuple(kinds[:len(points) - 1]), closed, kinds[-1])


def text_of(contour):
    """For a property of an operator."""
    rows = [" ".join(map(repr, map(float, point))) for point in contour.points]
    return "; ".join([rows[0], *(f"{kind} {row}" for kind, row in zip(contour.kinds, rows[1:])), *_closed(contour)])


def _closed(contour):
    if contour.closed:
        yield "closed" if contour.closing == SEGMENT else f"closed {contour.closing}"


def way_of(contour):
    """(3,): where a contour continues from its last point; None where it goes nowhere yet."""
    if len(contour.points) < 2:
        return None
    last = parts_of(contour._replace(closed=False))[-1]
    return last.derivatives(last.domain[1], 1, side='left')[1]


def from_text(text):
    """The Contour of a text. Raises Refusal."""
    made = Contour()
    try:
        for part in filter(str.strip, text.split(";")):
            words = part.split()
            if words[0] == "closed" and words[1:] in ([], [ARC]):
                made = made._replace(closed=True, closing=words[-1] if words[1:] else SEGMENT)
                continue
            kind = words.pop(0) if words[0] in (SEGMENT, ARC) else SEGMENT
            x, y, z = map(float, words)
            made = made.after((x, y, z), kind)
    except ValueError:
        raise Refusal("the contour is no list of points, each three numbers after 'segment' or 'arc'") from None
    if len(made.points) < 2 or not np.isfinite(made.points).all():
        raise Refusal("a contour needs two points or more")
    return made
