"""Rational curves: both de Casteljau algorithms, Moebius maps, the standard form, finite arcs (rows S9, S12)."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import (circle, closed_cubic, coordinates, hyperbola, inside, nurbs_curves, point_lists, positive, semicircle,
                    size_of)

unit = st.floats(0, 1)


@st.composite
def beziers(draw, weights=positive):
    points = draw(point_lists(2, 9))
    return sc.BezierCurve(points, draw(st.lists(weights, min_size=len(points), max_size=len(points))))


def close(one, other, shape, bound=1e-12):
    return np.abs(np.asarray(one) - other).max() <= bound * size_of(shape)


@given(beziers(), unit)
def test_both_algorithms_end_in_the_point(curve, u):
    rows = curve.casteljau_triangle(u)
    assert [row.shape for row in rows] == [(k, 4) for k in range(curve.degree + 1, 0, -1)]
    assert np.array_equal(rows[0], curve.homogeneous_points)
    rational, breakdown = curve.rational_casteljau_triangle(u)
    assert breakdown is None and [len(row) for row in rational] == [len(row) for row in rows]
    assert np.array_equal(rational[0], np.c_[curve.points, curve.weights])
    for one, other in zip(rows, rational):
        assert close(one[:, :3] / one[:, 3:], other[:, :3], curve) and np.allclose(one[:, 3], other[:, 3], rtol=1e-13)
    assert close(rational[-1][0, :3], curve.evaluate(u), curve)


@given(beziers(), unit)
def test_rational_rows_stay_in_the_box_of_the_row_above(curve, u):
    rows, _ = curve.rational_casteljau_triangle(u)
    slack = 1e-13 * size_of(curve)
    for above, row in zip(rows, rows[1:]):
        for i, point in enumerate(row):
            pair = above[i:i + 2, :3]
            assert (pair.min(axis=0) - slack <= point[:3]).all() and (point[:3] <= pair.max(axis=0) + slack).all()


def test_the_rational_algorithm_says_where_it_breaks():
    mixed = sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights=[1, -1, 1])
    rows, (row, index, reason) = mixed.rational_casteljau_triangle(0.5)
    assert (len(rows), row, index) == (1, 1, 0) and "cancel in row 1, point 0" in reason
    assert len(mixed.casteljau_triangle(0.5)) == 3
    rows, (row, index, reason) = semicircle().rational_casteljau_triangle(0.5)
    assert (rows, row, index) == ([], 0, 1) and "weights[1] = 0" in reason
    assert semicircle().casteljau_triangle(0.5)[-1].tolist() == [[0, 0.5, 0, 0.5]]


@given(beziers(), st.floats(-3, 4))
def test_outside_the_domain_both_extrapolate(curve, u):
    power = curve.to_power().with_domain((-3, 4))
    rows = curve.casteljau_triangle(u)
    slack = 1e-13 * 9.0**curve.degree * np.abs(curve.homogeneous_points).max()
    assert [len(row) for row in rows] == list(range(curve.degree + 1, 0, -1))
    point = np.polynomial.polynomial.polyval(u, power.homogeneous_coefficients)
    assert np.abs(rows[-1][0] - point).max() <= slack
    rational, breakdown = curve.rational_casteljau_triangle(u)
    for one, other in zip(rows, rational):
        assert np.allclose(one[:, 3], other[:, 3], rtol=1e-9, atol=slack)
    assert breakdown or len(rational) == len(rows)


def test_a_parabola_goes_on_outside():
    curve = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    for u in (-0.5, 1.5):
        at = [2 * u, 4 * u * (1 - u), 0]
        assert curve.casteljau_triangle(u)[-1].tolist() == [[*at, 1]]
        rows, breakdown = curve.rational_casteljau_triangle(u)
        assert breakdown is None and np.allclose(rows[-1], [[*at, 1]], rtol=0, atol=1e-15)


@given(point_lists(), positive, unit)
def test_equal_weights_are_the_polynomial_curve(points, weight, u):
    plain = sc.BezierCurve(points)
    weighted = sc.BezierCurve(points, [weight] * len(points))
    assert close(weighted.evaluate(u), plain.evaluate(u), plain, 1e-13)


@given(beziers(), st.sampled_from([-1.0, 3.7, -1e-5]), unit)
def test_scaling_weights_changes_nothing(curve, factor, u):
    assert close(curve.with_weights(curve.weights * factor).evaluate(u), curve.evaluate(u), curve)


@given(beziers(), st.lists(coordinates, min_size=3, max_size=3), unit)
def test_weights_of_one_sign_keep_the_curve_in_the_hull(curve, normal, u):
    heights = curve.points @ normal
    slack = 1e-12 * (1 + np.abs(normal).max()) * size_of(curve)
    assert heights.min() - slack <= curve.evaluate(u) @ normal <= heights.max() + slack


@given(beziers(), st.integers(0, 3), st.integers(0, 99))
def test_an_end_derivative_depends_on_the_first_points_only(curve, order, seed):
    if order >= curve.degree:
        return
    rng = np.random.default_rng(seed)
    rows = np.c_[curve.points, curve.weights]
    rows[order + 1:] += rng.uniform(0, 1, rows[order + 1:].shape)
    other = sc.BezierCurve(rows[:, :3], rows[:, 3])
    one = curve.derivatives(0, order)
    assert np.abs(other.derivatives(0, order) - one).max() <= 1e-10 * max(1, np.abs(one).max())


@given(beziers(), st.integers(0, 99), unit)
def test_a_perspective_image_is_a_rational_curve_with_new_weights(curve, seed, u):
    matrix = np.eye(4) + np.random.default_rng(seed).uniform(-0.1, 0.1, (4, 4))
    matrix[3, :3] *= 1e-4
    image = sc.BezierCurve.from_homogeneous(curve.homogeneous_points @ matrix.T)
    x, y, z, w = matrix @ [*curve.evaluate(u), 1]
    assert close(image.evaluate(u), np.array([x, y, z]) / w, curve)


def moved(u, domain, rho):
    start, end = domain
    x = (u - start) / (end - start)
    return np.minimum(start + (end - start) * (x / (rho * (1 - x) + x)), end)


@given(beziers(st.floats(-3, 3).filter(lambda w: abs(w) > 1e-3)), st.floats(0.1, 10))
def test_moebius_multiplies_weights_by_powers_of_rho(curve, rho):
    result = curve.moebius(rho)
    assert np.array_equal(result.points, curve.points)
    assert np.allclose(result.weights, curve.weights * rho ** np.arange(curve.degree + 1), rtol=1e-13, atol=0)


@given(nurbs_curves(), st.floats(0.2, 5))
def test_moebius_keeps_every_nurbs_curve(curve, rho):
    result = curve.moebius(rho)
    assert result.domain == curve.domain and result.degree == curve.degree
    u = inside(curve.domain)
    assert close(result.evaluate(moved(u, curve.domain, rho)), curve.evaluate(u), curve, 1e-11)


def test_moebius_opens_a_periodic_curve():
    curve = closed_cubic()
    result = curve.moebius(2.5)
    assert not result.periodic and result.domain == curve.domain
    u = inside(curve.domain)
    assert close(result.evaluate(moved(u, curve.domain, 2.5), side="left"), curve.evaluate(u, side="left"), curve)


@given(beziers())
def test_the_standard_form_has_the_weight_one_at_both_ends(curve):
    result = curve.standard_form()
    assert result.weights[0] == result.weights[-1] == 1
    rho = (curve.weights[0] / curve.weights[-1]) ** (1 / curve.degree)
    u = np.linspace(0, 1, 17)
    assert close(result.evaluate(moved(u, (0, 1), rho)), curve.evaluate(u), curve, 1e-11)


def test_the_standard_form_of_a_spline_keeps_its_points():
    curve = circle().with_weights(circle().weights * np.linspace(2, 3, 9))
    result = curve.standard_form()
    assert result.weights[0] == result.weights[-1] == 1 and np.array_equal(result.points, curve.points)


def test_finite_arcs_of_what_needs_no_cut_are_the_curve():
    for curve in (circle(), closed_cubic()):
        assert curve.finite_arcs(1) == [curve]


def test_finite_arcs_are_clipped_where_asked():
    arcs = hyperbola().finite_arcs(5)
    assert [isinstance(arc, sc.NurbsCurve) for arc in arcs] == [True] * 3
    for arc in arcs:
        assert (arc.weights > 0).all() and np.abs(arc.evaluate(inside(arc.domain))).max() <= 6
    starts, ends = zip(*(arc.domain for arc in arcs))
    assert starts[0] == 0 and ends[-1] == 1 and all(end < start for end, start in zip(ends, starts[1:]))


@given(nurbs_curves(), st.data(), positive)
def test_finite_arcs_of_any_weights_are_the_curve_with_positive_ones(curve, data, length):
    weights = data.draw(st.lists(st.sampled_from([1.0, 2.0, 0.0, -1.0]), min_size=len(curve.points),
                                 max_size=len(curve.points)))
    if not any(weights):
        return
    curve = curve.with_weights(weights)
    finite = curve.points[curve.weights != 0]
    low, high = finite.min(axis=0) - length, finite.max(axis=0) + length
    for arc in curve.finite_arcs(length):
        assert (arc.weights > 0).all()
        start, end = arc.domain
        points = arc.evaluate(inside((start, end)))
        slack = 1e-8 * (size_of(curve) + length)
        assert (low - slack <= points).all() and (points <= high + slack).all()


REFUSED = [
    (lambda: circle().finite_arcs(0), r"length = 0"), (lambda: hyperbola().finite_arcs(float("nan")), r"length"),
    (lambda: hyperbola().finite_arcs(-3), r"length = -3"), (lambda: circle().moebius(0), r"rho = 0"),
    (lambda: hyperbola().moebius(-1), r"rho = -1 is not positive"), (lambda: circle().moebius(1e200), r"range of numbers"),
    (lambda: closed_cubic().standard_form(), r"not clamped"),
    (lambda: semicircle().with_weights([1, 1, -1]).standard_form(), r"have not one sign"),
    (lambda: semicircle().casteljau_triangle(math.inf), r"u = inf"),
    (lambda: semicircle().casteljau_triangle(1e200), r"u = 1e\+200: point 0 of row 2 is too large"),
    (lambda: semicircle().rational_casteljau_triangle(float("nan")), r"u"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("bad", [None, "1", [1, 2], 1j, object()])
def test_what_is_no_number_raises_type_error(bad):
    curve = semicircle()
    for call in (curve.finite_arcs, curve.moebius, curve.casteljau_triangle, curve.rational_casteljau_triangle):
        with pytest.raises(TypeError):
            call(bad)
