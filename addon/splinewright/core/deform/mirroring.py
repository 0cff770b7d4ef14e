"""Shapes and their images in a mirror, as one: what ends on the plane continues across it."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..verbs import verbs

#: Heights below this part of the largest one are rounding.
_ROUNDING = 1e-12
#: Weights of two rows differ by one factor if they do so up to this part.
_SAME = 1e-9
_SIDES = ((0, 0), (0, -1), (1, 0), (1, -1))     # of the axes u and v: the first row and the last one


class Plane(NamedTuple):
    point: np.ndarray                   # (3,): on it
    normal: np.ndarray                  # (3,): of length 1

    def heights(self, points):
        return (points - self.point) @ self.normal

    def on(self, points):
        """(…, 3): the nearest points of the plane."""
        return points - self.heights(points)[..., None] * self.normal

    def image(self, points, weights):
        """(…, 3): points in the mirror; those at infinity, of weight 0, are directions."""
        heights = np.where(weights != 0.0, self.heights(points), points @ self.normal)
        return points - 2.0 * heights[..., None] * self.normal


class Mirrored(NamedTuple):
    pieces: list                        # of splinecore values: the half and its image
    count: int                          # of the ends or borders that lie on the plane
    moved: float                        # by how much the farthest control point went
    across: int                         # how many control points lie on the other side


def mirrored(definition, plane, gap, is_smooth):
    """A shape and its image. Ends and borders within a gap of the plane go onto it; is_smooth: the neighboring points move so that
    tangent planes, and with them curvatures, continue across it: by symmetry they do where the shape leaves the plane at right
    angles. Raises Refusal where weights are in the way of that, and where all lies in the plane."""
    pieces = [piece.to_nurbs() for piece in verbs.pieces_of(definition)]
    halves = [_half(piece, plane, gap, is_smooth) for piece in pieces]
    heights = _heights(halves, plane)
    if not np.abs(heights).max(initial=0.0) > gap:
        raise Refusal("it lies in the plane: its image is itself")
    most = heights[np.abs(heights).argmax()]
    join = _joined_curves if definition.has_curves else _both_patches
    return Mirrored([piece for half in halves for piece in join(half, plane)], sum(len(half.rows) for half in halves),
                    max(half.moved for half in halves), int((np.sign(most) * heights < -max(gap, _ROUNDING * abs(most))).sum()))


class _Half(NamedTuple):
    value: object
    rows: list                          # pairs of an axis and an index: the control points on the plane
    moved: float


def suggested_axis(definition, gap):
    """The one of x, y and z on whose plane through the origin most ends or borders lie, of those that the shape does not cross where
    there are any; where none does the one to which an end or border is nearest, or of a shape without any the shape itself. A plane
    in which all lies is none."""
    pieces = [piece.to_nurbs() for piece in verbs.pieces_of(definition)]
    planes = {name: Plane(np.zeros(3), normal) for name, normal in zip('xyz', np.eye(3))}
    halves = {name: [_half(piece, plane, gap, False) for piece in pieces] for name, plane in planes.items()}
    heights = {name: _heights(halves[name], plane) for name, plane in planes.items()}
    possible = [name for name in planes if np.abs(heights[name]).max(initial=0.0) > gap]

    def rank(name):
        count = sum(len(half.rows) for half in halves[name])
        is_crossed = heights[name].min(initial=0.0) < -gap and heights[name].max(initial=0.0) > gap
        return count > 0 and not is_crossed, count, not is_crossed, -_nearest(halves[name], heights[name], planes[name])
    return max(possible or planes, key=rank)


def _nearest(halves, heights, plane):
    """How near to a plane the nearest whole end or border is; without any, the nearest control point."""
    borders = [np.abs(plane.heights(_row(half.value.points, axis, i))).max() for half in halves for axis, i in _borders(half.value)]
    return min(borders, default=np.abs(heights).min(initial=np.inf))


def _borders(value):
    """Pairs of an axis and an index: the first and last rows of control points that are places, where they end."""
    return [(axis, i) for axis, i in _SIDES if axis < value.points.ndim - 1 and not _is_periodic(value, axis)
            and (_row(value.weights, axis, i) != 0.0).all()]


def _heights(halves, plane):
    """(n,): of all control points that are not at infinity."""
    return np.concatenate([plane.heights(half.value.points[half.value.weights != 0.0]) for half in halves])


def _half(piece, plane, gap, is_smooth):
    clamped = _clamped(piece)
    rows = [(axis, i) for axis, i in _borders(clamped) if _is_near(_row(clamped.points, axis, i), plane, gap)]
    clamped = _with_rows_beside(clamped, rows) if is_smooth else clamped
    points, weights = clamped.points.copy(), clamped.weights
    for axis, i in rows:
        _row(points, axis, i)[...] = plane.on(_row(points, axis, i))
    for axis, i in rows if is_smooth else ():
        _straighten(points, weights, axis, i, plane)
    moved = float(np.linalg.norm(points - clamped.points, axis=-1).max())
    return _Half(clamped.with_points(points) if rows else piece, rows, moved)


def _with_rows_beside(piece, rows):
    """Raised in degree until each row on the plane has one beside it for itself, which is on no other border."""
    for axis in {axis for axis, _ in rows}:
        missing = 2 + [other for other, _ in rows].count(axis) - piece.points.shape[axis]
        if missing > 0:
            piece = piece.elevate(missing) if isinstance(piece, sc.NurbsCurve) else piece.elevate('uv'[axis], missing)
    return piece


def _is_periodic(piece, axis):
    return piece.periodic if isinstance(piece.periodic, bool) else piece.periodic[axis]


def _clamped(piece):
    """With its ends in its outer points, unless it has none."""
    if isinstance(piece, sc.NurbsCurve):
        return piece if piece.periodic else piece.clamped()
    for axis, name in enumerate('uv'):
        piece = piece if piece.periodic[axis] else piece.clamped(name)
    return piece


def _row(array, axis, i):
    return array[(slice(None),) * axis + (i,)]


def _is_near(points, plane, gap):
    return bool((np.abs(plane.heights(points)) <= gap).all())


def _straighten(points, weights, axis, i, plane):
    """Let the row beside one on the plane lie at right angles to it."""
    beside = 1 if i == 0 else -2
    ratio = _row(weights, axis, beside) / _row(weights, axis, i)
    if np.ptp(ratio) > _SAME * np.abs(ratio).max():
        raise Refusal("weights along a border on the plane change otherwise than those beside it: tangent planes cannot be held "
                      "across it")
    row = _row(points, axis, beside)
    row[...] = _row(points, axis, i) + plane.heights(row)[..., None] * plane.normal


def _image(half, plane):
    """The half in the mirror; what lies on the plane stays, to the last digit."""
    value = half.value
    points = plane.image(value.points, value.weights)
    for axis, i in half.rows:
        _row(points, axis, i)[...] = _row(value.points, axis, i)
    return value.with_points(points)


def _both_patches(half, plane):
    return [half.value, _image(half, plane).swapped()]


def _joined_curves(half, plane):
    image = _image(half, plane)
    return sc.build.join_curves([half.value, image], 0.0) if half.rows else [half.value, image]
