"""Circles that touch three lines, and frames at the ends of closed curves: 1000 random inputs each."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def triangle(rng):
    while True:
        corners = rng.standard_normal((3, 2)) * (1, 10.0**rng.uniform(-1, 0))
        sides = np.linalg.norm(np.roll(corners, -1, 0) - corners, axis=1)
        half = sides.sum() / 2
        area = np.sqrt(max(0, half * np.prod(half - sides)))
        if area > 1e-2 * half**2:
            return corners, sides, half, area


def test_the_circle_in_a_triangle(inputs):
    """By its closed form, at scales from a millionth to a million, and far from the origin."""
    rng = np.random.default_rng([91, 0])
    for _ in range(inputs(1000)):
        corners, sides, half, area = triangle(rng)
        places = (half - np.roll(sides, -1)) / sides
        scale, move = 10.0**rng.uniform(-6, 6), rng.uniform(-10, 10, 2)
        curves = [sc.BezierCurve(scale * (np.stack([corners[i], corners[(i + 1) % 3]]) + move)) for i in range(3)]
        near = places + rng.uniform(-0.01, 0.01, 3) * np.minimum(places, 1 - places)
        arc, center, radius, parameters = build.touching_circle(*curves, near)
        assert radius == pytest.approx(scale * area / half, rel=1e-9)
        np.testing.assert_allclose(parameters, places, rtol=0, atol=1e-8)


def found_circle(pieces, near, turn, move):
    try:
        curves = [sc.BezierCurve(points @ turn.T + move, weights=weights) for points, weights in pieces]
        _, _, radius, parameters = build.touching_circle(*curves, near)
    except sc.InvalidShape:
        return None
    return radius, parameters


def test_circles_do_not_depend_on_a_motion(inputs):
    """Curves of degrees 1 to 4 anywhere: both have the circle, or neither."""
    rng = np.random.default_rng([93, 0])
    count = 0
    for _ in range(inputs(4000)):
        pieces = []
        for _ in range(3):
            degree = int(rng.integers(1, 5))
            weights = 10.0 ** rng.uniform(-0.5, 0.5, degree + 1)
            pieces.append((rng.standard_normal(2) + 0.8 * rng.standard_normal((degree + 1, 2)), weights))
        near = rng.uniform(0.1, 0.9, 3)
        angle = rng.uniform(0, 2 * np.pi)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        here = found_circle(pieces, near, np.eye(2), np.zeros(2))
        there = found_circle(pieces, near, turn, rng.uniform(-5, 5, 2))
        assert (here is None) == (there is None)
        if here is None:
            continue
        count += 1
        assert there[0] == pytest.approx(here[0], rel=1e-7)
        np.testing.assert_allclose(there[1], here[1], rtol=0, atol=1e-6)
    assert count > inputs(200)


def test_places_are_parameters(inputs):
    lines = [sc.BezierCurve([[0, 0], [4, 0]]), sc.BezierCurve([[4, 0], [0, 3]]), sc.BezierCurve([[0, 3], [0, 0]])]
    for wrong in ([2, 0.5, 0.5], [np.nan, 0.5, 0.5], [[0, 0], [1, 1], [0, 1]], [0.2, 0.3]):
        with pytest.raises((sc.InvalidShape, TypeError, ValueError)):
            build.touching_circle(*lines, wrong)


def test_frames_carried_around_closed_curves(inputs):
    """At the end stands what was carried there: the tangent is the start's, and the normal as far as the curve turns it."""
    rng = np.random.default_rng([92, 0])
    for _ in range(inputs(1000)):
        degree = int(rng.integers(2, 6))
        count = int(rng.integers(max(4, degree + 1), 12))
        knots = np.r_[0, np.cumsum(rng.uniform(0.1, 1, count))]
        curve = sc.NurbsCurve(degree, knots, rng.standard_normal((count, 3)), periodic=True)
        end = curve.domain[1]
        frames = curve.frames([curve.domain[0], end - 1e-7 * knots[-1], end])
        np.testing.assert_allclose(frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), (3, 3, 3)), atol=1e-12)
        np.testing.assert_allclose(frames[2, 0], frames[0, 0], atol=1e-9)
        assert np.abs(frames[2] - frames[1]).max() < 1e-2
