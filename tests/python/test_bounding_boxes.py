"""Boxes of curves and patches: closed forms, and random shapes of every kind against dense samples."""

import math

import numpy as np
import pytest

import random_curves
import random_patches
import shapes
import splinecore as sc
from splinecore import build


def near_box(found, expected, relative=1e-14):
    expected = np.asarray(expected, float)
    return found.shape == (2, 3) and np.abs(found - expected).max() <= relative * np.abs(expected).max()


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_boxes_in_closed_form(size):
    ring = shapes.circle()
    tilted = np.array(ring.points) * size @ np.array([[0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]])
    curve = ring.with_points(tilted + size * np.array([1, 2, 3]))
    assert near_box(curve.bounding_box(), size * np.array([(0.4, 1, 2.2), (1.6, 3, 3.8)]))
    cubic = sc.PowerCurve(size * np.array([(0, 0, 0), (1, 0, 0), (0, -3, 0), (0, 1, 0)]), domain=(-0.5, 3))
    assert near_box(cubic.bounding_box(), size * np.array([(-0.5, -4, 0), (3, 0, 0)]))
    ball = build.sphere((3 * size, 0, -size), 2 * size)
    assert near_box(ball.bounding_box(), size * np.array([(1, -2, -3), (5, 2, 1)]), 2e-12)
    normal = np.array([1, 2, 2]) / 3
    torus = build.torus((0, 0, 0), normal, 3 * size, size)
    half = size * (3 * np.sqrt(1 - normal**2) + 1)
    assert near_box(torus.bounding_box(), [-half, half], 2e-12)
    axis = np.array([2, 3, 6]) / 7
    pipe = build.cylinder((0, 0, 0), axis, size, 5 * size)
    ends = np.array([0 * axis, 5 * size * axis])
    reach = size * np.sqrt(1 - axis**2)
    assert near_box(pipe.bounding_box(), [ends.min(0) - reach, ends.max(0) + reach], 2e-12)


def places(knots, domain, count):
    """All knots of a domain, just before them where there may be a gap, and so many places on every span."""
    ends = np.unique(np.r_[domain, np.clip(knots, *domain)])
    inside = ends[:-1, None] + np.diff(ends)[:, None] * np.linspace(0, 1, count)
    return np.unique(np.r_[ends, np.nextafter(ends[1:], -np.inf), inside.ravel()])


def test_boxes_of_random_curves_are_those_of_dense_samples():
    """1000 of every kind, denser where the samples are outermost."""
    for curve in random_curves.random_curves(1, 1000, positive=True):
        box = curve.bounding_box()
        u = places(curve.knots, curve.domain, 400)
        points = curve.evaluate(u)
        size = np.abs(box).max()
        assert (box[0] <= points.min(0) + 1e-14 * size).all() and (box[1] >= points.max(0) - 1e-14 * size).all()
        for side, sign in ((0, -1), (1, 1)):
            for axis in range(3):
                outermost = np.argsort(sign * points[:, axis])[-5:]
                close = np.linspace(u[np.maximum(outermost - 1, 0)], u[np.minimum(outermost + 1, len(u) - 1)], 801)
                found = (sign * np.r_[curve.evaluate(close.ravel())[:, axis], points[:, axis]]).max()
                assert abs(sign * found - box[side, axis]) < 2e-5 * size, (curve, side, axis)


def test_weights_of_any_sign_and_points_at_infinity():
    assert near_box(shapes.semicircle().bounding_box(), [(-1, 0, 0), (1, 1, 0)])
    beyond = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -math.sqrt(0.5), 1])
    assert near_box(beyond.bounding_box(), [(-1, -1, 0), (1, 1, 0)])
    assert near_box(sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [-3, math.sqrt(4.5), -3]).bounding_box(),
                    [(-1, -1, 0), (1, 1, 0)])
    with pytest.raises(sc.PointAtInfinity):
        shapes.hyperbola().bounding_box()
    half = [[(1, 0, 0), (1, 0, 1)], [(0, 1, 0), (0, 1, 0)], [(-1, 0, 0), (-1, 0, 1)]]
    patch = sc.BezierPatch(half, [[1, 1], [0, 0], [1, 1]])
    assert near_box(patch.bounding_box(), [(-1, 0, 0), (1, 1, 1)], 2e-12)
    with pytest.raises(sc.PointAtInfinity):
        sc.BezierPatch(half, [[1, 1], [-1.5, -1.5], [1, 1]]).bounding_box()


def test_every_kind_has_the_box_of_its_nurbs_form():
    for shape in [*shapes.curves(), *shapes.patches()]:
        same = shape if isinstance(shape, (sc.NurbsCurve, sc.NurbsPatch)) else shape.to_nurbs()
        assert (shape.bounding_box() == same.bounding_box()).all()


def test_boxes_of_random_patches_are_those_of_dense_samples():
    rng = np.random.default_rng(5)
    for patch in [*shapes.patches(), *(random_patches.random_patch(rng) for _ in range(60))]:
        box = patch.bounding_box()
        knots = patch.knots if isinstance(patch, sc.NurbsPatch) else patch.domain
        points = patch.evaluate_grid(*map(places, knots, patch.domain, (30, 30))).reshape(-1, 3)
        size = np.abs(box).max()
        assert (box[0] <= points.min(0) + 2e-12 * size).all() and (box[1] >= points.max(0) - 2e-12 * size).all()
        assert (np.abs(box - [points.min(0), points.max(0)]) < 0.05 * size).all()
        assert np.abs(patch.swapped().bounding_box() - box).max() <= 2e-12 * size


def test_far_away_no_digit_of_the_shape_is_lost():
    rng = np.random.default_rng(9)
    for degree in (2, 3, 9, 15):
        knots = np.r_[[0.0] * (degree + 1), 1, 2, [3.0] * (degree + 1)]
        points, weights = rng.integers(-64, 64, (degree + 3, 3)) / 64.0, 10.0 ** rng.uniform(-1, 1, degree + 3)
        for far in (0.0, 2.0**40, -(2.0**44)):
            curve = sc.NurbsCurve(degree, knots, points + far, weights)
            near = sc.NurbsCurve(degree, knots, points, weights)
            assert np.allclose(curve.bounding_box() - far, near.bounding_box(), rtol=0, atol=2e-16 * abs(far) + 1e-13)
            patch = sc.NurbsPatch((degree, 1), (knots, [0, 0, 1, 1]), np.stack([points, points[::-1]], 1) + far)
            home = patch.with_points(np.stack([points, points[::-1]], 1))
            assert np.allclose(patch.bounding_box() - far, home.bounding_box(), rtol=0,
                               atol=2e-12 * max(abs(far), 1.0))


def test_a_summit_inside_is_found():
    """x² + y² has its least and -(x² + y²) its largest value at a place that no halving meets."""
    line = np.array([0.0, 0.0, 1.0])

    def square(center):
        # Bernstein coefficients of (t - center)² on [0, 1].
        return np.array([center**2, center**2 - center, (1 - center) ** 2])

    u, v = np.meshgrid([0, 0.5, 1], [0, 0.5, 1], indexing="ij")
    for a, b in ((0.3, 0.7), (1 / 3, math.pi / 4), (1e-5, 0.999)):
        height = square(a)[:, None] + square(b)
        for sign in (1, -1):
            box = sc.BezierPatch(np.stack([u, v, sign * height + 5 * line[2]], -1)).bounding_box()
            assert abs(box[0 if sign > 0 else 1, 2] - 5) < 1e-11


def test_the_box_of_a_set_is_that_of_all_its_patches():
    parts = [build.sphere((0, 0, 0), 1), shapes.torus(), shapes.wavy_patch()]
    boxes = np.array([part.bounding_box() for part in parts])
    patches = [patch for part in parts for patch in (part if isinstance(part, sc.PatchSet) else [part])]
    found = sc.PatchSet.from_patches(patches).bounding_box()
    assert np.abs(found - [boxes[:, 0].min(0), boxes[:, 1].max(0)]).max() < 1e-11


@pytest.mark.parametrize("tolerance", [0, -1, math.nan, math.inf])
def test_a_tolerance_is_positive(tolerance):
    with pytest.raises(sc.InvalidShape, match="tolerance"):
        shapes.torus().bounding_box(tolerance=tolerance)
    with pytest.raises(TypeError):
        shapes.torus().bounding_box(tolerance="a")
