"""Curves as paths on a page: lines, parabolas and cubics exactly, all others by cubics within a hundredth of a millimeter.

A piece has homogeneous points (n + 1, 4) of the world: (x w, y w, z w, w), or a direction and 0. Under a perspective it is rational on the
page, whatever it was before.
"""

from typing import NamedTuple

import numpy as np

from . import bernstein
from .page import flat

#: How far from its curve a cubic that stands for a part of it may lie, in mm.
TOLERANCE = 0.01
#: Weights that differ by less, as a part of the largest, differ by rounding.
_ROUNDING = 1e-14
#: Of the largest weight the part below which a point counts as one at infinity.
_INFINITE = 1e-9
#: Parts of a piece are halved no more often: near infinity the page ends long before.
_HALVINGS = 40


class Path(NamedTuple):
    """steps: of each line, parabola or cubic the points (1, 2), (2, 2) or (3, 2) that follow the point before."""

    start: np.ndarray
    steps: tuple
    closed: bool = False

    @property
    def end(self):
        return self.steps[-1][-1]


def pieces_of(curves):
    """The pieces of splinecore curves, one after the other."""
    return [homogeneous(piece.points, piece.weights) for curve in curves for piece in curve.to_bezier()]


def homogeneous(points, weights=None):
    """(n, 4) of points (n, 3) and weights; a weight of 0 means a direction."""
    weights = np.ones(len(points)) if weights is None else np.asarray(weights, float)
    scales = np.where(weights == 0.0, 1.0, weights)[:, None]
    return np.column_stack([points * scales, weights])


def of_lines(pairs):
    """The pieces of straight lines between pairs of ends (n, 2, 3)."""
    return [homogeneous(pair) for pair in pairs]


def moved(pieces, matrix):
    """The pieces under a matrix (4, 4)."""
    return [piece @ matrix.T for piece in pieces]


def of_pieces(pieces, seen):
    """The Paths of pieces on a Page; pieces that follow each other make one. What lies behind the eye or beside the page is left out."""
    return joined([path for piece in pieces for path in of_piece(piece, seen)])


def of_piece(piece, seen):
    """The Paths of one piece on a Page: one for each stretch that is seen."""
    found = []
    for start, end, sign in _before_the_eye(piece, seen):
        rows = sign * flat(bernstein.part(piece, start, end), seen.matrix)
        found += _paths(rows, seen)
    return found


def _before_the_eye(piece, seen):
    """(start, end, the sign of its weights) of what of a piece lies before the eye and not at infinity."""
    weights = piece[:, 3]
    depths = flat(piece, seen.matrix)[:, 2] - seen.near * weights
    least = _INFINITE * np.abs(weights).max()
    if least == 0.0:
        return
    for sign in (1.0, -1.0):
        ends = bernstein.positive(sign * weights - least)
        if seen.has_perspective and ends:
            ends = bernstein.common(ends, bernstein.positive(sign * depths))
        yield from ((start, end, sign) for start, end in ends)


def _paths(rows, seen):
    """Of a piece (n + 1, 3) on the page whose depths are above 0; not all of their coefficients need be."""
    depths = rows[:, 2]
    is_polynomial = np.ptp(depths) <= _ROUNDING * depths.max()
    if len(rows) > 2 and not (is_polynomial and len(rows) <= 4):
        return _fitted(rows, seen, _HALVINGS)
    points = rows[:, :2] / depths[:, None]
    if _is_beside(rows, seen):
        return []
    return [Path(points[0], (points[1:] if np.ptp(points, axis=0).any() else points[:1],))]


def _is_beside(rows, seen):
    """Whether a piece lies beside one side of a page, as far as its points on the page enclose it."""
    if not (rows[:, 2] > 0.0).all():
        return False
    points = rows[:, :2] / rows[:, 2:]
    low, high = points.min(axis=0), points.max(axis=0)
    return bool((high < 0.0).any() or (low > (seen.width, seen.height)).any())


def _fitted(rows, seen, halvings):
    """The Paths of cubics for a rational piece, each within the tolerance, one Path for each stretch on the page."""
    if _is_beside(rows, seen):
        return []
    cubic = _hermite(rows)
    if not halvings or distance_bound(rows, cubic) <= TOLERANCE:
        return [Path(cubic[0], (cubic[1:],))]
    before, after = (_fitted(half, seen, halvings - 1) for half in bernstein.halves(rows))
    if before and after and np.array_equal(before[-1].end, after[0].start):
        between = Path(before[-1].start, before[-1].steps + after[0].steps)
        return [*before[:-1], between, *after[1:]]
    return before + after


def _hermite(rows):
    """(4, 2): the cubic with the ends of a rational piece and its first derivatives there."""
    start, end = rows[0, :2] / rows[0, 2], rows[-1, :2] / rows[-1, 2]
    part = (len(rows) - 1) / 3.0
    return np.array([start, start + part * (rows[1, :2] - rows[1, 2] * start) / rows[0, 2],
                     end - part * (rows[-2, 2] * end - rows[-2, :2]) / rows[-1, 2], end])


def distance_bound(rows, cubic):
    """A distance that no point of a rational piece (n + 1, 3) exceeds from the point of a cubic (4, 2) at the same parameter: the difference
    times the denominator is a polynomial, which its coefficients bound. Infinite where they do not tell that the denominator stays above 0."""
    depths = rows[:, 2:]
    if not (depths > 0.0).all():
        return np.inf
    raised = bernstein.product(rows[:, :2], np.ones((4, 1)))
    difference = raised - bernstein.product(cubic, depths)
    return float(np.linalg.norm(difference, axis=1).max() / depths.min())


def joined(paths):
    """Paths of which each begins where the one before it ends are one; one that ends where it begins is closed."""
    found = []
    for path in paths:
        if found and _is_same(found[-1].end, path.start):
            found[-1] = found[-1]._replace(steps=found[-1].steps + path.steps)
        else:
            found.append(path)
    return [path._replace(closed=True) if len(path.steps) > 1 and _is_same(path.end, path.start) else path for path in found]


def _is_same(one, other):
    """Whether two places on the page differ by rounding alone."""
    return bool(np.abs(one - other).max() <= 1e-9 * (1.0 + np.abs(one).max()))
