"""The shapes that the Add menu starts from, as splinecore values of radius 1 around the origin."""

import json
import math
from pathlib import Path

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

KNOTS = ('CLAMPED', 'UNCLAMPED', 'PERIODIC')
#: Of arrays, to the last digit alike at every call, which numpy's own are not.
_cos, _sin = (np.vectorize(function, otypes=[np.float64]) for function in (math.cos, math.sin))
#: More control points than this in one patch are refused.
MOST_POINTS = 1_000_000


def _require_count(count_u, count_v):
    if count_u * count_v > MOST_POINTS:
        raise Refusal("{count_u} × {count_v} points are too many, {most:,} are the most", count_u=count_u, count_v=count_v, most=MOST_POINTS)


def knot_vector(degree, count, knots):
    """Uniform knots for `count` points: clamped, unclamped, or periodic."""
    if knots == 'PERIODIC':
        return np.arange(count + 1.0)
    if knots == 'UNCLAMPED':
        return np.arange(count + degree + 1.0)
    return np.concatenate([np.zeros(degree), np.arange(count - degree + 1.0),
                           np.full(degree, count - degree)])


def bezier_curve(degree):
    """An S that crosses the x axis in the middle."""
    return sc.BezierCurve(_wave(degree + 1))


def line(count):
    """A polyline along the x axis."""
    points = np.zeros((count, 3))
    points[:, 0] = np.linspace(-1.0, 1.0, count)
    return sc.NurbsCurve(1, knot_vector(1, count, 'CLAMPED'), points)


def nurbs_curve(degree, count, knots):
    points = _circle(count) if knots == 'PERIODIC' else _wave(count)
    return sc.NurbsCurve(degree, knot_vector(degree, count, knots), points, periodic=knots == 'PERIODIC')


def hermite_chain(count, closed):
    """A wave, or a closed chain that is nearly a circle."""
    if closed:
        points = _circle(count)[[*range(count), 0]]
        # The cubic through both ends that meets the circle in its middle (Hermite form of S8's arc).
        length = 4 * math.tan(math.pi / (2 * count))
        tangents = length * (np.column_stack([-points[:, 1], points[:, 0], points[:, 2]]) + 0.0)
        return sc.HermiteCurve(points, tangents)
    points = _wave(count)
    tangents = np.gradient(points, axis=0) if count > 1 else points
    return sc.HermiteCurve(points, tangents)


def bezier_chain(count, closed):
    """Cubics whose handles are as long as a third of the way between the neighbors, as those of Blender's own; closed
    it is nearly a circle."""
    if closed:
        return hermite_chain(count, True)
    x = np.linspace(-1.0, 1.0, count)
    points = _neat(np.column_stack([x, 0.5 * _cos(np.pi * np.arange(count)), np.zeros(count)]))
    tangents = np.zeros((count, 3))
    tangents[:, 0] = 1.5 * (x[1] - x[0])
    return sc.HermiteCurve(points, tangents)


def bezier_patch(degree_u, degree_v):
    return sc.BezierPatch(_hill(degree_u + 1, degree_v + 1))


def nurbs_patch(degree, count, knots):
    """A sheet, a tube where one direction is periodic, a torus where both are."""
    _require_count(*count)
    closed = tuple(kind == 'PERIODIC' for kind in knots)
    vectors = tuple(knot_vector(*axis) for axis in zip(degree, count, knots))
    if closed == (True, True):
        points = _torus(*count)
    elif closed == (True, False):
        points = _tube(*count)
    elif closed == (False, True):
        points = _tube(*count[::-1]).transpose(1, 0, 2)[::-1]
    else:
        points = _hill(*count)
    return sc.NurbsPatch(degree, vectors, points, periodic=closed)


def hermite_patch(count_u, count_v):
    """Ferguson's patch: twists are zero."""
    _require_count(count_u, count_v)
    points = _hill(count_u, count_v)
    tangents_u = np.gradient(points, axis=0)
    tangents_v = np.gradient(points, axis=1)
    return sc.HermitePatch(points, tangents_u, tangents_v)


def runge(count):
    """(count, 3): equally spaced points of y = 1 / (1 + 25 x²), through which polynomials oscillate (S3)."""
    x = np.linspace(-1.0, 1.0, count)
    return np.column_stack([x, 1.0 / (1.0 + 25.0 * x * x), np.zeros(count)])


def teapot():
    """Newell's teapot of 1975, z up, standing on z = 0, with a body of radius 1."""
    data = json.loads(Path(__file__).with_name("teapot.json").read_text())
    points = np.array(data['points'])
    patches = [np.array(rows, dtype=np.int32).reshape(4, 4) for rows in data['patches']]
    return sc.PatchSet(points / data['body_radius'], patches)


def scaled(value, factor):
    """The value with all coordinates multiplied; weights, knots and parameters stay."""
    if factor == 1.0:
        return value
    if isinstance(value, sc.HermiteCurve):
        return sc.HermiteCurve(value.points * factor, value.tangents * factor, value.parameters)
    if isinstance(value, sc.HermitePatch):
        nets = (value.points, value.tangents_u, value.tangents_v, value.twists)
        return sc.HermitePatch(*(net * factor for net in nets), parameters=value.parameters)
    return value.with_points(value.points * factor)


def _neat(points):
    """Without the roundings of sines, and without -0."""
    return np.round(points, 15) + 0.0


def _wave(count):
    x = np.linspace(-1.0, 1.0, count)
    y = 0.5 * _sin(np.pi * x) if count > 3 else 0.5 * (1.0 - x * x)
    return _neat(np.column_stack([x, y, np.zeros(count)]))


def _circle(count):
    angles = np.arange(count) * (2 * np.pi / count)
    return _neat(np.column_stack([_cos(angles), _sin(angles), np.zeros(count)]))


def _hill(count_u, count_v):
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, count_u), np.linspace(-1.0, 1.0, count_v), indexing='ij')
    inside = np.zeros((count_u, count_v))
    inside[1:-1, 1:-1] = 1.0
    return _neat(np.stack([x, y, inside * _cos(0.5 * np.pi * x * 0.9) * _cos(0.5 * np.pi * y * 0.9)], -1))


def _tube(around, along):
    """u runs around, v upwards: normals point outwards."""
    circle, height = _circle(around), np.linspace(-1.0, 1.0, along)
    points = np.repeat(circle[:, None, :], along, axis=1)
    points[..., 2] = height
    return points


def _torus(around, across):
    angles = np.arange(across) * (2 * np.pi / across)
    radius, height = 1.0 + 0.4 * _cos(angles), 0.4 * _sin(angles)
    circle = _circle(around)
    return _neat(np.stack([circle[:, None, 0] * radius, circle[:, None, 1] * radius,
                           np.broadcast_to(height, (around, across))], -1))
