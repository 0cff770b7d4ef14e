"""All places where the distance from a point is stationary: dense samples of many kinds of shapes, and closed forms."""

import math

import numpy as np
import pytest

import shapes
import splinecore as sc
from random_curves import random_curve


def lengths(vectors):
    return np.linalg.norm(vectors, axis=-1)


def slopes(curve, point, u):
    """The cosine between C - P and C', nan at infinity."""
    at, way = np.moveaxis(curve.derivatives(u, 1, at_infinity="nan"), -2, 0)
    with np.errstate(all="ignore"):
        return ((at - point) * way).sum(-1) / (lengths(at - point) * lengths(way))


def ends_of_spans(curve):
    start, end = curve.domain
    return np.unique(np.r_[start, curve.knots[(curve.knots > start) & (curve.knots < end)], end])


def dense(curve, each):
    """Inside every span, dense at its ends."""
    t = 0.5 - 0.5 * np.cos(np.pi * (np.arange(each) + 0.5) / each)
    knots = ends_of_spans(curve)
    return (knots[:-1, None] + np.diff(knots)[:, None] * t).ravel()


def check_curve(curve, point, each=300, tolerance=1e-7):
    """Between the places the distance goes one way, and at each of them it does not."""
    found = curve.stationary_points(point)
    size = np.abs(curve.points).max() + np.abs(point).max()
    assert (np.diff(found.parameters) >= 0).all()
    assert np.allclose(lengths(found.points - point), found.distances, rtol=1e-12, atol=1e-13 * size)
    both = [curve.evaluate(found.parameters, side=side, at_infinity="nan") for side in ("left", "right")]
    assert np.fmin(*(lengths(at - found.points) for at in both)).max() <= 1e-10 * size
    start, end = curve.domain
    ends = ends_of_spans(curve)
    inner = ~np.isin(found.parameters, ends)
    assert (np.abs(slopes(curve, point, found.parameters[inner])) < tolerance).all()
    # Every stretch between places and knots.
    marks = np.unique(np.r_[ends, found.parameters])
    u = dense(curve, each)
    sign = np.sign(slopes(curve, point, u))
    far = np.abs(u[:, None] - marks).min(1) > 1e-5 * np.diff(ends).min()
    runs = {}
    for k in range(len(marks) - 1):
        inside = far & (u > marks[k]) & (u < marks[k + 1]) & (sign != 0) & np.isfinite(sign)
        runs[k] = set(sign[inside])
    if curve.weights.min() > 0:
        assert all(len(signs) <= 1 for signs in runs.values())
    for parameter, kind in zip(found.parameters, found.kinds):
        k = int(np.searchsorted(marks, parameter))
        left = runs.get(k - 1 if k or not curve.periodic else len(marks) - 2, set())
        right = runs.get(k, set())
        if np.sum(found.parameters == parameter) > 1 or curve.weights.min() <= 0:
            continue  # the two sides of a gap
        left, right = (next(iter(signs), 0) for signs in (left, right))
        assert kind == ("minimum" if left <= 0 <= right else "maximum" if left >= 0 >= right else "saddle")
    return found


@pytest.mark.parametrize("ends", ["clamped", "unclamped", "periodic"])
@pytest.mark.parametrize("degree", range(1, 10))
def test_of_curves_none_is_missing(degree, ends):
    rng = np.random.default_rng(degree)
    for _ in range(8):
        curve = random_curve(rng, degree=degree, ends=ends, spans=3)
        for point in rng.uniform(-12, 12, (3, 3)):
            check_curve(curve, point)


@pytest.mark.parametrize("degree", [2, 3, 5])
def test_of_curves_through_infinity_the_finite_places_count(degree):
    rng = np.random.default_rng(degree)
    for _ in range(10):
        curve = random_curve(rng, positive=False, degree=degree, spans=2, ends="unclamped")
        found = check_curve(curve, rng.uniform(-10, 10, 3), tolerance=1e-5)
        assert np.isfinite(found.points).all()


def rational_ellipse(a, b, center=(0, 0, 0), scale=1.0):
    circle = shapes.circle()
    return sc.NurbsCurve(2, circle.knots, circle.points * (a * scale, b * scale, 1) + center, circle.weights)


def test_an_ellipse_has_four_normals_through_a_point_inside_its_evolute_and_two_outside():
    curve = rational_ellipse(3, 1)
    for x, y in np.random.default_rng(1).uniform(-3, 3, (200, 2)):
        # (a x)^(2/3) + (b y)^(2/3) = (a² - b²)^(2/3)
        evolute = abs(3 * x) ** (2 / 3) + abs(y) ** (2 / 3) - 8 ** (2 / 3)
        if abs(evolute) > 0.01:
            assert len(curve.stationary_points((x, y)).kinds) == (4 if evolute < 0 else 2)


def test_the_axes_of_an_ellipse_are_its_normals_through_the_center():
    found = rational_ellipse(3, 1).stationary_points((0, 0))
    assert found.parameters == pytest.approx([0, 1, 2, 3], abs=1e-15)
    assert found.kinds == ("maximum", "minimum", "maximum", "minimum")
    assert found.distances == pytest.approx([3, 1, 3, 1], rel=1e-15)
    assert rational_ellipse(3, 1).nearest_all((0, 0)).parameters == pytest.approx([1, 3], abs=1e-15)
    assert repr(found) == "StationaryPoints(count=4)"


@pytest.mark.parametrize("scale", [1e-150, 1e-20, 1e20, 1e150])
def test_size_does_not_matter(scale):
    found = rational_ellipse(3, 1, scale=scale).stationary_points((0.5 * scale, 0.2 * scale))
    plain = rational_ellipse(3, 1).stationary_points((0.5, 0.2))
    assert found.parameters == pytest.approx(plain.parameters, rel=1e-13)
    assert found.distances == pytest.approx(plain.distances * scale, rel=1e-13)
    assert found.kinds == plain.kinds


def test_far_from_the_origin_and_from_far_away():
    there = rational_ellipse(3, 1, center=(1e8, -1e8, 1e7))
    found = there.stationary_points((1e8 + 0.5, -1e8 + 0.25, 1e7))
    assert found.parameters == pytest.approx(rational_ellipse(3, 1).stationary_points((0.5, 0.25)).parameters, abs=1e-6)
    # Then they are those where the tangent is at right angles to the direction.
    way = np.array([0.6, 0.8, 0])
    for far in (1e12, 1e60, 1e200):
        found = rational_ellipse(3, 1).stationary_points(far * way)
        assert found.parameters == pytest.approx(rational_ellipse(3, 1).extrema(way)[1:-1], abs=1e-11)
        assert found.distances == pytest.approx([far] * 2, rel=1e-11)


def test_a_line_has_one_foot_and_its_ends():
    line = sc.BezierCurve([(0, 0), (1, 0)])
    found = line.stationary_points((0.25, 3))
    assert found.parameters == pytest.approx([0, 0.25, 1], rel=1e-15)
    assert found.kinds == ("maximum", "minimum", "maximum")
    assert line.stationary_points((-1, 0)).kinds == ("minimum", "maximum")
    assert line.nearest_all((-1, 0)).parameters.tolist() == [0]


def test_corners_count_where_they_are_a_minimum_or_a_maximum():
    roof = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 1), (2, 0), (3, -1)])
    found = roof.stationary_points((1, 3))
    assert found.parameters.tolist() == [0, 1, 3]
    assert found.kinds == ("maximum", "minimum", "maximum")
    found = roof.stationary_points((1, -0.5))
    assert found.parameters == pytest.approx([0, 0.25, 1, 1.75, 3])
    assert found.kinds == ("maximum", "minimum", "maximum", "minimum", "maximum")
    assert roof.nearest_all((1, -0.5)).parameters == pytest.approx([0.25, 1.75])


def test_the_two_sides_of_a_gap_are_two_ends():
    gap = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (1, 1), (2, 1)])
    found = gap.stationary_points((1, 0.5))
    assert found.parameters.tolist() == [0, 1, 1, 2]
    assert found.points[1:3].tolist() == [[1, 0, 0], [1, 1, 0]]
    assert gap.nearest_all((1, 0.5)).distances.tolist() == [0.5, 0.5]


def test_the_seam_of_a_periodic_curve_is_one_place():
    square = sc.NurbsCurve(1, [0, 1, 2, 3, 4], [(1, 1), (-1, 1), (-1, -1), (1, -1)], periodic=True)
    found = square.stationary_points((0, 0))
    assert len(found.parameters) == 8 and found.parameters.max() < 4
    assert found.kinds.count("minimum") == 4
    assert square.nearest_all((0, 0)).distances.tolist() == [1, 1, 1, 1]
    assert len(square.nearest_all((0, 0.1)).distances) == 1
    assert len(square.nearest_all((0, 0.1), 0.1).distances) == 3
    assert len(square.nearest_all((0, 0.1), tolerance=1).distances) == 4


def test_where_a_curve_ends_where_it_begins_is_one_place_and_maybe_a_corner():
    found = shapes.circle().stationary_points((0.3, 0))
    assert found.parameters.tolist() == [0, 2] and found.kinds == ("minimum", "maximum")
    drop = sc.BezierCurve([(0, 0), (2, 2), (-2, 2), (0, 0)])
    assert drop.nearest_all((0, -1)).parameters.tolist() == [0]
    assert drop.stationary_points((0, -1)).kinds == ("minimum", "maximum")


def test_on_the_evolute_two_places_become_one():
    parabola = sc.BezierCurve([(-2, 4), (0, -4), (2, 4)])  # y = x²
    found = parabola.stationary_points((0, 0.5))
    assert found.parameters == pytest.approx([0, 0.5, 1], abs=1e-4)
    assert found.kinds == ("maximum", "minimum", "maximum")
    # Where the center of curvature is that of x = 1/2.
    found = parabola.stationary_points((-0.5, 1.25))
    assert found.kinds == ("maximum", "minimum", "saddle", "maximum") or len(found.kinds) == 5
    assert np.abs(found.parameters - 0.625).min() < 1e-6


def test_all_nearest_of_many_are_as_near_as_the_nearest():
    rng = np.random.default_rng(5)
    for _ in range(40):
        curve = random_curve(rng, spans=3)
        for point in rng.uniform(-12, 12, (2, 3)):
            best = curve.nearest(point)
            found = curve.nearest_all(point)
            assert np.abs(found.distances - best.distances).max() <= 1e-12
            assert np.abs(found.parameters - best.parameters).min() <= 1e-6
            wide = curve.nearest_all(point, 5.0)
            assert set(found.parameters) <= set(wide.parameters) and (wide.distances <= best.distances + 5).all()


def test_weights_that_are_wild():
    rng = np.random.default_rng(6)
    for _ in range(60):
        curve = random_curve(rng, spans=3)
        wild = sc.NurbsCurve(curve.degree, curve.knots, curve.points, 10 ** rng.uniform(-4, 4, len(curve.points)),
                             periodic=curve.periodic)
        point = rng.uniform(-12, 12, 3)
        found, best = wild.stationary_points(point), wild.nearest(point)
        assert found.distances.min() == pytest.approx(best.distances, abs=1e-11)
        assert found.kinds[found.distances.argmin()] == "minimum"


@pytest.mark.parametrize("call, error, text", [
    (lambda one: one.stationary_points((0, 0, math.nan)), sc.InvalidShape, "point"),
    (lambda one: one.stationary_points((0, 0, 0, 1)), sc.InvalidShape, "point"),
    (lambda one: one.stationary_points([(0, 0, 0)]), sc.InvalidShape, "point"),
    (lambda one: one.stationary_points(None), TypeError, "point"),
    (lambda one: one.stationary_points("here"), TypeError, "point"),
    (lambda one: one.stationary_points((0, 0), cancel=3), TypeError, "cancel"),
    (lambda one: one.nearest_all((0, math.inf)), sc.InvalidShape, "point"),
    (lambda one: one.nearest_all((0, 0), -1), sc.InvalidShape, "tolerance"),
    (lambda one: one.nearest_all((0, 0), math.nan), sc.InvalidShape, "tolerance"),
    (lambda one: one.nearest_all((0, 0), "wide"), TypeError, "tolerance"),
])
def test_bad_input(call, error, text):
    for one in (rational_ellipse(3, 1), sc.BezierCurve([(0, 0), (1, 1), (2, 0)])):
        with pytest.raises(error, match=text):
            call(one)


def test_from_the_center_of_a_circle_everything_is_stationary():
    with pytest.raises(sc.InvalidShape, match="constant from u = 0.0 to 1.0|constant from u = 0 to 1"):
        shapes.circle().stationary_points((0, 0, 3))
    moved = rational_ellipse(2, 2, center=(1e6, 3, 7))
    with pytest.raises(sc.InvalidShape, match="constant"):
        moved.stationary_points((1e6, 3, 9))
    with pytest.raises(sc.InvalidShape, match="constant"):
        moved.nearest_all((1e6, 3, 9))
    # Farther than the nearest place it does no harm.
    hook = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), (1, 1), (0, 1), (0, 0.5), (0, 0.2)],
                         [1, math.sqrt(0.5), 1, 1, 1])
    with pytest.raises(sc.InvalidShape, match="constant"):
        hook.stationary_points((0, 0))
    assert hook.nearest_all((0, 0)).parameters.tolist() == [2]
