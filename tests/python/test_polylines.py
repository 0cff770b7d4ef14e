"""Polylines of curves: steps in every span, closed ones, and how far those that run to infinity go."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curves
from shapes import circle, closed_cubic, cubic, curves, hyperbola, semicircle


def box_distance(curve, points):
    """How far a point lies outside the box of the finite control points, in the worst coordinate."""
    finite = curve.points[curve.weights != 0]
    return np.maximum(finite.min(axis=0) - points, points - finite.max(axis=0)).max()


def steps_of(curve, resolution):
    start, end = curve.domain
    knots = np.unique(np.r_[start, curve.knots[(curve.knots > start) & (curve.knots < end)], end])
    t = np.arange(resolution) / resolution
    return np.r_[(knots[:-1, None] + np.diff(knots)[:, None] * t).ravel(), end]


@pytest.mark.parametrize("resolution", [1, 3, 16])
def test_every_span_has_the_same_number_of_steps(resolution):
    for curve in curves():
        for reach in (None, 1, 1e6):
            ((points, closed),) = curve.polylines(resolution, reach)
            u = steps_of(curve.to_nurbs(), resolution)
            expected = curve.to_nurbs().evaluate(u[:-1] if closed else u)
            assert points.shape == expected.shape and np.abs(points - expected).max() <= 1e-14


def test_closed_curves_are_closed_and_others_are_not():
    assert [curve.polylines(4)[0][1] for curve in (circle(), closed_cubic(), cubic())] == [True, True, False]
    assert circle().polylines(4, 10)[0][1] and closed_cubic().polylines(4, reach=10)[0][1]
    assert not semicircle().polylines(4, 10)[0][1]
    assert not circle().split(3.5)[0].polylines(4)[0][1]


@pytest.mark.parametrize("reach", [3, 20, 1e3, 1e6])
def test_a_branch_of_a_hyperbola_ends_where_it_leaves_the_reach(reach):
    lines = hyperbola().polylines(64, reach)
    assert len(lines) == 3
    ends = []
    for points, closed in lines:
        assert not closed and box_distance(hyperbola(), points) <= reach * (1 + 1e-6)
        ends += [box_distance(hyperbola(), points[[0]]), box_distance(hyperbola(), points[[-1]])]
    # The outer ends are the end points of the curve, the four inner ones are at the border.
    assert np.allclose(ends[1:-1], reach, rtol=1e-3) and max(ends[0], ends[-1]) <= 0
    for points, _ in lines:
        # In barycentric coordinates l1² = 4 w² l0 l2, with the weight w = -3/2.
        x, y, _ = points.T
        assert np.abs(y**2 - 2.25 * ((1 - y) ** 2 - x**2)).max() <= 1e-9 * (1 + points**2).max()


def test_a_branch_beyond_the_reach_is_left_out():
    """The middle branch has its vertex in (0, 3), two above the control points."""
    assert [len(hyperbola().polylines(8, reach)) for reach in (1.99, 2.01)] == [2, 3]


def test_without_a_reach_the_lines_end_before_infinity_at_the_last_step():
    lines = hyperbola().polylines(4)
    assert len(lines) == 3 and all(np.isfinite(points).all() for points, _ in lines)


def test_a_curve_without_a_pole_is_the_same_at_any_reach():
    for curve in random_curves(70, 200, positive=True):
        (one, closed), *rest = curve.polylines(5)
        (other, also_closed), *more = curve.polylines(5, 1e-3)
        assert closed == also_closed and len(rest) == len(more) and np.array_equal(one, other)


def test_a_thousand_curves_of_any_weights_stay_within_the_reach_and_on_the_curve():
    cut = 0
    for curve in random_curves(71, 600, positive=False):
        lines = curve.polylines(6, 20)
        for points, closed in lines:
            assert len(points) >= 2 and np.isfinite(points).all()
            assert not closed or len(lines) == 1
            cut += len(lines) > 1
        start, end = curve.domain
        has_gap = any((curve.knots == u).sum() > curve.degree for u in curve.knots if start < u < end)
        if len(curve.pieces()) > 1 and not curve.periodic and not has_gap:
            assert all(box_distance(curve, points) <= 20 * (1 + 1e-3) + 1e-6 for points, _ in lines)
    assert cut > 300


def test_a_farther_reach_keeps_what_the_nearer_one_showed():
    for length in (4, 20, 200):
        near, far = hyperbola().polylines(32, length), hyperbola().polylines(32, 10 * length)
        assert [len(points) for points, _ in near] == [len(points) for points, _ in far]
        assert max(box_distance(hyperbola(), points) for points, _ in far) > 5 * length


def test_a_periodic_curve_that_runs_through_infinity_is_open():
    points = np.random.default_rng(1).uniform(-1, 1, (6, 3))
    ring = sc.NurbsCurve(2, range(7), points, [1, 1, -2, 1, 1, 1], periodic=True)
    lines = ring.polylines(16, 3)
    assert lines and not any(closed for _, closed in lines)
    assert all(box_distance(ring, points) <= 3 * (1 + 1e-6) for points, _ in lines)


@pytest.mark.parametrize("scale", [1e-150, 1e150])
def test_the_reach_does_not_depend_on_the_units(scale):
    plain = hyperbola()
    large = plain.with_points(plain.points * scale)
    for (one, _), (other, _) in zip(plain.polylines(8, 5), large.polylines(8, 5 * scale), strict=True):
        assert np.allclose(other / scale, one, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("weight", [-1.0, -1 + 1e-15, -1 - 1e-15, -1 + 1e-7, -0.9999, -1.0001, -0.5, -3.0])
def test_what_is_finite_but_far_ends_at_the_reach_as_what_runs_to_infinity(weight):
    conic = sc.conics.conic_arc((1, 0, 0), (1, 1, 0), (0, 1, 0), weight)
    lines = conic.polylines(64, 10)
    assert lines and all(box_distance(conic, points) <= 10 * (1 + 1e-9) for points, _ in lines)
    for points, _ in lines:
        assert np.linalg.norm(np.diff(points, axis=0), axis=1).max() < 12
    ends = [points[i] for points, _ in lines for i in (0, -1)]
    assert min(np.linalg.norm(end - (1, 0, 0)) for end in ends) == 0.0


def test_the_reach_may_be_around_points():
    line = sc.BezierCurve([(0, 0, 0), (100, 0, 0)])
    ((points, closed),) = line.polylines(10, 5, around=[(20, 0), (30, 0)])
    assert not closed and np.allclose(points[[0, -1]], [(15, 0, 0), (35, 0, 0)], atol=1e-7)
    assert line.polylines(10, 5, around=[(0, 50, 0)]) == []
    ((whole, closed),) = circle().polylines(8, 100, around=[(0, 0, 0)])
    assert closed and np.array_equal(whole, circle().polylines(8)[0][0])
    with pytest.raises(sc.InvalidShape, match="around"):
        line.polylines(10, 5, around=[1, 2])


REFUSED = [
    (lambda: circle().polylines(0, 1), "resolution = 0"), (lambda: circle().polylines(4097, 1), "resolution = 4097"),
    (lambda: circle().polylines(4, 0), "reach = 0 is not a positive length"),
    (lambda: hyperbola().polylines(4, -2), "reach = -2 is not a positive length"),
    (lambda: hyperbola().polylines(4, np.nan), "reach = nan"), (lambda: circle().polylines(4, np.inf), "reach = inf"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("bad", ["1", [1, 2], 1j, object(), True])
def test_what_is_no_length_raises_type_error_that_names_it(bad):
    with pytest.raises(TypeError, match="^reach"):
        circle().polylines(4, bad)
