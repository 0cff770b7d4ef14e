"""Areas and winding numbers of closed plane curves: closed forms, dense polygons, every kind of curve, and errors."""

import math

import numpy as np
import pytest

import random_curves
import shapes
import splinecore as sc


RING = shapes.circle()


def closed_curves(seed, count, positive=True):
    """Periodic ones without a gap."""
    for curve in random_curves.random_curves(seed, count, positive=positive, ends="periodic"):
        if len(curve.points) > 1 and len(curve.divide(2, tolerance=1e-3)) == 2:
            yield curve


def polygon(curve, per_span=300):
    knots = np.unique(np.r_[curve.domain, curve.knots])
    parts = np.arange(per_span) / per_span
    return curve.evaluate((knots[:-1, None] + np.diff(knots)[:, None] * parts).ravel())[:, :2]


def shoelace(points):
    x, y = points.T
    return 0.5 * (x * np.roll(y, -1) - np.roll(x, -1) * y).sum()


def turns(points, center):
    """The sum of the angles of a polygon's sides."""
    angles = np.arctan2(*(points - center).T[::-1])
    steps = np.diff(np.r_[angles, angles[:1]])
    return round(((steps + math.pi) % (2 * math.pi) - math.pi).sum() / (2 * math.pi))


@pytest.mark.parametrize("size", [1e-120, 1.0, 1e120])
@pytest.mark.parametrize("center", [0.0, 1e4])
def test_an_ellipse_in_any_plane(size, center):
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    flat = np.c_[np.array(shapes.SQUARE) * (3, 2), np.zeros(9)]
    curve = sc.NurbsCurve(2, shapes.CIRCLE_KNOTS, (flat @ turn.T + center) * size, shapes.SQUARE_WEIGHTS)
    near = 1e-13 * max(1, center)
    assert curve.signed_area(turn[:, 2]) / size**2 == pytest.approx(6 * math.pi, rel=near)
    assert curve.reversed().signed_area(1e-9 * turn[:, 2]) / size**2 == pytest.approx(-6 * math.pi, rel=near)
    assert abs(curve.signed_area(turn[:, 0])) <= 1e-11 * max(1, center) * size**2
    inside, outside = (size * (turn @ np.array(at) + center) for at in ((2.9, 0.1, 5), (2.9, 1, 0)))
    assert curve.winding_number(inside, turn[:, 2]) == 1
    assert curve.winding_number(inside, -turn[:, 2]) == curve.reversed().winding_number(inside, turn[:, 2]) == -1
    assert curve.winding_number(outside, turn[:, 2]) == 0


def test_polynomials_are_exact():
    square = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0)])
    assert square.signed_area() == pytest.approx(2, rel=1e-15)
    loop = sc.BezierCurve([(0, 0), (3, 3), (-2, 3), (0, 0)])
    assert loop.signed_area() == pytest.approx(0.05 * 3 * (3 * 3 + 2 * 3), rel=1e-15)  # 3/20 (x₁ y₂ - x₂ y₁)
    assert sc.BezierCurve([(0, 0), (1, 1), (1, 1), (0, 0)]).signed_area() == pytest.approx(0, abs=1e-15)


def test_areas_and_turns_are_those_of_dense_polygons():
    rng = np.random.default_rng(2)
    compared = {0: 0, 1: 0}
    for curve in closed_curves(3, 60):
        points = polygon(curve)
        size = np.ptp(points, axis=0).max()
        area = curve.signed_area()
        assert abs(area - shoelace(points)) < 1e-3 * size**2, curve
        assert curve.clamped().signed_area() == pytest.approx(area, rel=1e-9, abs=1e-10 * size**2)
        for _ in range(20):
            center = rng.uniform(points.min(0), points.max(0))
            if np.linalg.norm(points - center, axis=1).min() < 0.02 * size:
                continue
            expected = turns(points, center)
            assert curve.winding_number(center) == expected, (curve, center)
            compared[min(abs(expected), 1)] += 1
    assert min(compared.values()) > 50


def test_rays_through_corners_and_along_sides():
    """The ray runs along the x axis of the view, whichever that is: every direction of a square is tried."""
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
    for angle in np.arange(16) * math.pi / 8:
        c, s = np.round(math.cos(angle), 15), np.round(math.sin(angle), 15)
        turned = np.array(square, float) @ np.array([[c, s], [-s, c]])
        curve = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], turned)
        for corner in turned:
            for part, expected in ((0.5, 1), (-0.25, 1), (1.5, 0)):
                assert curve.winding_number(part * corner) == expected
        middle = (turned[0] + turned[1]) / 2
        assert curve.winding_number(turned[0] + 2.5 * (turned[1] - turned[0])) == 0
        for on_it in (turned[1], middle):
            with pytest.raises(sc.InvalidShape, match="point lies on the curve"):
                curve.winding_number(on_it)


def test_weights_of_any_sign():
    ring = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)], [1, 0, 1, 0, 1])
    assert ring.signed_area() == pytest.approx(math.pi, rel=1e-12)
    assert ring.winding_number((0.5, 0.5)) == 1 and ring.winding_number((0.8, 0.8)) == 0
    minus = ring.with_weights(-np.array(ring.weights))  # its directions are taken the other way
    assert minus.signed_area() == pytest.approx(-math.pi, rel=1e-12)
    assert minus.winding_number((0.5, 0.5)) == -1
    wild = RING.with_weights(-1e200 * np.array(RING.weights))
    assert wild.signed_area() == pytest.approx(math.pi, rel=1e-12) and wild.winding_number((0.5, 0.5)) == 1


@pytest.mark.parametrize("shape", [(0,), (1,), (7,), (2, 3), (4, 1, 2)])
def test_points_of_any_shape_are_wound_around_as_each_of_them(shape):
    points = np.random.default_rng(len(shape)).uniform(-1.5, 1.5, (*shape, 2))
    found = RING.winding_number(points)
    assert found.shape == shape and found.dtype == np.int64
    assert found.ravel().tolist() == [RING.winding_number(point) for point in points.reshape(-1, 2)]
    assert type(RING.winding_number((0.5, 0.5))) is int


@pytest.mark.parametrize("call, error, message", [
    (lambda: shapes.semicircle().signed_area(), sc.InvalidShape, "the curve is not closed: its ends are apart by"),
    (lambda: shapes.semicircle().winding_number((0, 0)), sc.InvalidShape, "the curve is not closed"),
    (lambda: sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (1, 1), (0, 0)]).signed_area(), sc.InvalidShape,
     "the curve is not closed: it is in 2 pieces"),
    (lambda: RING.signed_area((0, 0, 0)), sc.InvalidShape, "normal is not a direction"),
    (lambda: RING.signed_area(tolerance=0), sc.InvalidShape, "tolerance = 0 is not a positive number"),
    (lambda: RING.signed_area(tolerance=math.nan), sc.InvalidShape, "tolerance"),
    (lambda: RING.winding_number((1, 0)), sc.InvalidShape, "point lies on the curve"),
    (lambda: RING.winding_number((math.nan, 0)), sc.InvalidShape, "point"),
    (lambda: RING.winding_number([(0, 0), (1, 0)]), sc.InvalidShape, "point[1] lies on the curve"),
    (lambda: RING.winding_number([(0, 0), (0, math.nan)]), sc.InvalidShape, "point[1, 1] = nan is not finite"),
    (lambda: RING.winding_number([[0], [1]]), sc.InvalidShape, "point has shape (2, 1)"),
    (lambda: shapes.semicircle().winding_number([(0, 0), (1, 5)]), sc.InvalidShape, "the curve is not closed"),
    (lambda: RING.winding_number(None), TypeError, "point"),
    (lambda: RING.winding_number((0, 0, 0, 0)), sc.InvalidShape, "point"),
    (lambda: shapes.hyperbola().signed_area(), sc.PointAtInfinity, ""),
])
def test_bad_arguments_are_named(call, error, message):
    with pytest.raises(error) as caught:
        call()
    assert str(caught.value).startswith(message)
