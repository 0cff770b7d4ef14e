"""Ends of curves: other domains, clamped and unclamped knots, closed curves made periodic (row S15)."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import (along, error, homogeneous, homogeneous_at, parameters, random_curves, sampled_distance,
                           shares)
from shapes import circle, closed_cubic, cubic, random_points, semicircle

COUNT = 1000


def copies(curve, u):
    return int((curve.knots == u).sum())


def test_another_domain_keeps_the_points_and_maps_the_knots():
    for index, curve in enumerate(random_curves(30, COUNT)):
        rng = np.random.default_rng(index)
        start = float(rng.uniform(-5, 5))
        end = start + float(rng.uniform(0.1, 20))
        after = curve.with_domain((start, end))
        assert after.domain == (start, end) and after.periodic == curve.periodic
        assert np.array_equal(after.points, curve.points) and np.array_equal(after.weights, curve.weights)
        u = parameters(curve)
        far = homogeneous(curve, u) - homogeneous_at(after, along((start, end), shares(curve, u)))
        assert np.abs(far).max() <= 1e-12 * np.abs(curve.homogeneous_points).max(), index


def test_the_same_domain_is_the_same_curve():
    for curve in (circle(), cubic(), closed_cubic()):
        assert curve.with_domain(curve.domain) == curve
        assert curve.with_domain((10, 11)).with_domain(list(curve.domain)).largest_distance(curve) <= 1e-14


def test_clamped_ends_are_the_outer_points():
    for curve in random_curves(31, COUNT, positive=True):
        after = curve.clamped()
        assert not after.periodic and after.domain == curve.domain
        assert copies(after, after.domain[0]) == copies(after, after.domain[1]) == curve.degree + 1
        assert after.knots[0] == after.domain[0] and after.knots[-1] == after.domain[1]
        ends = curve.evaluate(curve.domain[0]), curve.evaluate(curve.domain[1], side="left")
        assert np.abs(after.points[[0, -1]] - ends).max() <= 1e-12 * np.abs(curve.points).max()


def test_a_clamped_curve_stays_as_it_is():
    assert circle().clamped() == circle()
    assert cubic().clamped().clamped() == cubic().clamped()


def test_unclamped_knots_go_on_in_steps_by_the_outer_spans():
    for index, curve in enumerate(random_curves(32, COUNT)):
        after = curve.unclamped()
        assert not after.periodic and after.domain == curve.domain
        assert error(curve, after) <= 1e-14 and error(curve, after.clamped()) <= 1e-14, index
        # Points go outside to make up for knots outside, but not far.
        largest = np.abs(after.homogeneous_points).max()
        assert largest <= 200 * np.abs(curve.clamped().homogeneous_points).max()
        u = parameters(curve)
        assert np.abs(homogeneous(curve, u) - homogeneous(after, u)).max() <= 1.5e-15 * max(largest, 1.0), index
        if not curve.periodic:
            knots = after.knots
            spans = np.diff(np.unique(knots[(knots >= after.domain[0]) & (knots <= after.domain[1])]))
            before, behind = np.diff(knots[:curve.degree + 1]), np.diff(knots[-curve.degree - 1:])
            step = min(1, 9 / curve.degree ** 2)
            assert np.allclose(before, step * spans[0], rtol=1e-9)
            assert np.allclose(behind, step * spans[-1], rtol=1e-9)


def test_unclamping_keeps_points_that_the_ends_have_no_part_in():
    curve = sc.NurbsCurve(3, [0] * 4 + [1, 2, 3, 4] + [5] * 4, random_points(8, seed=4), np.linspace(1, 2, 8))
    after = curve.unclamped()
    assert after.knots.tolist() == list(range(-3, 9))
    assert np.array_equal(after.points[2:-2], curve.points[2:-2])
    assert after.clamped().largest_distance(curve) <= 1e-12
    assert closed_cubic().unclamped() == closed_cubic().unrolled()


def test_a_cut_periodic_curve_becomes_the_periodic_one_again():
    """Where weights differ, rounding may cut a curve farther off than by the few roundings that are the default."""
    default, beyond = 2.0**-46, 0
    for index, curve in enumerate(random_curves(33, COUNT, ends="periodic", positive=True)):
        size, cut = np.abs(curve.points).max(), curve.clamped()
        loose, strict = (cut.to_periodic(tolerance) for tolerance in (1e-6, None))
        assert len(loose.value.points) == len(curve.points), index
        assert strict.error <= default * size
        is_beyond = loose.error > default * size
        assert is_beyond or len(strict.value.points) == len(curve.points), index
        beyond += is_beyond
        for value, bound in (loose, strict):
            assert value.periodic and bound <= 1e-13 * size
            assert error(curve, value) <= 1e-14
            assert sampled_distance(curve, value, 20) <= bound + 1e-13 * size
    assert beyond < COUNT / 100


def test_a_cut_periodic_curve_of_any_weights_becomes_the_same_curve_again():
    closed = 0
    for curve in random_curves(35, COUNT, ends="periodic", positive=False):
        cut = curve.clamped()
        if cut.weights[0] == 0:
            continue
        assert error(curve, cut.to_periodic().value) <= 1e-12
        closed += 1
    assert closed > 900


def test_a_circle_keeps_its_corner_free_seam():
    value, bound = circle().to_periodic()
    assert bound == 0 and value.periodic and len(value.points) == 8
    u = np.linspace(0, 4, 33)
    assert np.abs(value.evaluate(u) - circle().evaluate(u)).max() <= 1e-15
    assert copies(value, 0.0) + copies(value, 4.0) - 1 == 2
    assert closed_cubic().to_periodic().value == closed_cubic()


def test_ends_that_nearly_meet_are_moved_within_the_tolerance():
    points = circle().points.copy()
    points[-1] += (0, 0.001, 0)
    open_circle = circle().with_points(points)
    value, bound = open_circle.to_periodic(0.01)
    assert value.periodic and 0.0005 <= bound <= 0.01
    assert sampled_distance(open_circle, value) <= bound * (1 + 1e-9)
    with pytest.raises(sc.ToleranceNotReached, match="ends do not meet within 5e-04: the error would be 0.001"):
        open_circle.to_periodic(0.0005)


REFUSED = [
    (lambda: circle().with_domain((1, 1)), "from 1 to 1 is empty"),
    (lambda: circle().with_domain((2, 1)), "from 2 to 1 is empty"),
    (lambda: circle().with_domain((0, np.inf)), "is not finite"),
    (lambda: circle().with_domain((np.nan, 1)), "is empty|is not finite"),
    (lambda: circle().with_domain((-1e308, 1e308)), "is not finite"),
    (lambda: circle().with_domain((0, 5e-324)), "so narrow that knots would become equal"),
    (lambda: cubic().with_domain((1e308, 1.1e308)).with_domain((-1.7e308, 0)), "range of numbers"),
    (lambda: circle().with_domain((1, 2, 3)), "domain has 3 values"),
    (lambda: circle().with_domain(3), r"domain has shape \(\)"),
    (lambda: cubic().to_periodic(), "weights at the ends are .* and .*: a periodic curve needs equal ones"),
    (lambda: circle().to_periodic(-1e-9), "tolerance = -1e-09 is below 0"),
    (lambda: circle().to_periodic(np.nan), "tolerance = nan"),
    (lambda: semicircle().with_weights([0, 1, 1]).to_nurbs().to_periodic(5), "lies at infinity"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("bad", [None, "ab", [None, 1], [1j, 2], object(), {}, [True, False]])
def test_what_is_no_pair_of_numbers_raises_type_error(bad):
    with pytest.raises(TypeError, match="^domain"):
        circle().with_domain(bad)
    if bad is not None:
        with pytest.raises(TypeError, match="^tolerance"):
            circle().to_periodic(bad)


def test_an_end_that_moves_may_move_the_curve_by_more_where_weights_are_negative():
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, -1), (0, 0.01)], [1, -0.3, 1, 1])
    value, bound = curve.to_periodic(1)
    assert 0.005 < bound <= 1 and sampled_distance(curve, value) <= bound * (1 + 1e-9)
