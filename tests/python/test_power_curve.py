"""PowerCurve: monomials, and their exact conversion to and from Bezier (row S2)."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import cubic, hermite_chain, parabola, point_lists, random_points, semicircle

NAN, INF = float("nan"), float("inf")
ULP = 2.0**-52
small = st.integers(-64, 64).map(lambda n: n / 8)


def exact(rows):
    return [[Fraction(value) for value in row] for row in np.asarray(rows, float).tolist()]


def exact_value(rows, origin, t):
    """sum c_k (t - origin)^k in fractions."""
    x = Fraction(t) - Fraction(origin)
    return [sum(row[axis] * x**k for k, row in enumerate(rows)) for axis in range(len(rows[0]))]


def exact_bernstein(rows, origin, start, end):
    """Control points from coefficients, in fractions: about start, then b_i = sum C(i, k) / C(n, k) h^k d_k."""
    n, shift, length = len(rows) - 1, Fraction(start) - Fraction(origin), Fraction(end) - Fraction(start)
    about = [[sum(comb(j, k) * rows[j][axis] * shift ** (j - k) for j in range(k, n + 1)) for axis in range(3)]
             for k in range(n + 1)]
    return [[sum(Fraction(comb(i, k), comb(n, k)) * length**k * about[k][axis] for k in range(i + 1))
             for axis in range(3)] for i in range(n + 1)]


def exact_power(points, origin):
    """Coefficients about origin from control points over [0, 1], in fractions."""
    n = len(points) - 1
    about = [[comb(n, k) * sum((-1) ** (k - i) * comb(k, i) * points[i][axis] for i in range(k + 1))
              for axis in range(3)] for k in range(n + 1)]
    return [[sum(comb(j, k) * about[j][axis] * Fraction(origin) ** (j - k) for j in range(k, n + 1))
             for axis in range(3)] for k in range(n + 1)]


def assert_rounded(values, expected):
    """Each value is the exact one up to its last digit, or to 1e-28 of the largest where sums cancel."""
    flat = [value for row in expected for value in row]
    largest = max(map(abs, flat))
    for value, right in zip(np.asarray(values).ravel().tolist(), flat):
        assert abs(Fraction(value) - right) <= abs(right) * Fraction(ULP) + largest * Fraction(1e-28)


def test_the_twisted_cubic_is_the_lectures():
    curve = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], domain=(-1, 2))
    t = np.linspace(-1, 2, 31)
    assert np.abs(curve.evaluate(t) - np.stack([t, t**2, t**3], 1)).max() <= 8 * ULP
    assert curve.degree == 3 and curve.domain == (-1, 2) and not curve.is_rational and curve.origin == 0
    assert curve.to_nurbs().points[:, 0].tolist() == [-1, 0, 1, 2]


def test_the_lectures_matrix_takes_bezier_points_to_coefficients():
    points = random_points(4, seed=2)
    rows = np.array([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]) @ points
    assert np.abs(sc.BezierCurve(points).to_power().coefficients - rows[::-1]).max() <= 2 * ULP * np.abs(rows).max()
    assert sc.BezierCurve([(0, 0), (0, 4), (4, 4), (4, 0)]).to_power().coefficients[:, :2].tolist() == [
        [0, 0], [0, 12], [12, -12], [-8, 0]]


@given(point_lists(), small, small, st.sampled_from([0.125, 1.0, 3.0, 1e3]))
def test_control_points_are_the_exact_ones_rounded_once(rows, origin, start, length):
    curve = sc.PowerCurve(rows, origin, (start, start + length))
    assert_rounded(curve.to_nurbs().points, exact_bernstein(exact(rows), origin, start, start + length))


@given(point_lists(), small)
def test_coefficients_are_the_exact_ones_rounded_once(points, origin):
    assert_rounded(sc.BezierCurve(points).to_power(origin).coefficients, exact_power(exact(points), origin))


@given(point_lists(), small, small)
def test_another_origin_is_the_same_curve(rows, origin, other):
    curve = sc.PowerCurve(rows, origin)
    moved = curve.with_origin(other)
    assert moved.origin == other and moved.domain == curve.domain and moved == curve.to_power(other)
    sizes = sum(np.abs(c).max() * max(abs(other), abs(1 - other)) ** k for k, c in enumerate(moved.coefficients))
    t = np.linspace(0, 1, 9)
    right = np.array([[float(value) for value in exact_value(exact(rows), origin, u)] for u in t])
    assert np.abs(moved.evaluate(t) - right).max() <= 16 * ULP * (sizes + np.abs(right).max() + 1e-300)


@given(point_lists(), st.lists(st.floats(0.25, 4), min_size=9, max_size=9))
def test_rational_curves_go_there_and_back(points, weights):
    curve = sc.BezierCurve(points, weights[:len(points)])
    (again,) = curve.to_power().to_bezier()
    scale = 2.0 ** (2 * len(points)) * 4e3
    assert np.abs(again.homogeneous_points - curve.homogeneous_points).max() <= ULP * scale * 4


def test_the_error_of_a_far_origin_is_what_the_page_says():
    points = random_points(11, seed=4)
    curve, t = sc.BezierCurve(points), np.linspace(0, 1, 101)
    for origin in (0.5, 0.0, 2.0, 10.0):
        moved = curve.to_power(origin)
        bound = sum(np.abs(c).max() * np.abs(t - origin) ** k for k, c in enumerate(moved.coefficients))
        error = np.abs(moved.evaluate(t) - curve.evaluate(t)).max(axis=1)
        assert (error <= ULP * bound + 8 * ULP * np.abs(points).max()).all(), origin


def test_derivative_differentiates_the_monomials():
    curve = sc.PowerCurve([(1, 2, 3), (4, 5, 6), (7, 8, 9), (1, 0, -2)], 0.5, (0, 2))
    slope = curve.derivative()
    assert slope.coefficients.tolist() == [[4, 5, 6], [14, 16, 18], [3, 0, -6]]
    assert slope.origin == 0.5 and slope.domain == (0, 2) and slope.weights.tolist() == [1, 0, 0]
    u = np.linspace(0, 2, 9)
    assert np.abs(slope.evaluate(u) - curve.derivatives(u, 1)[:, 1]).max() <= 64 * ULP
    line = sc.PowerCurve([(1, 2), (3, 4)]).derivative()
    assert line.coefficients.tolist() == [[3, 4, 0], [0, 0, 0]] and line.derivative().evaluate(0.5).tolist() == [0, 0, 0]


def test_the_derivative_of_a_rational_curve_is_the_quotient_rules():
    curve = parabola()
    u = np.linspace(*curve.domain, 21)
    slope = curve.derivative()
    assert slope.degree == 4 and slope.is_rational
    assert np.abs(slope.evaluate(u) - curve.derivatives(u, 1)[:, 1]).max() <= 1e-14


def test_split_narrows_the_domain_and_reversed_mirrors_the_origin():
    curve = parabola()
    before, after = curve.split(1.0)
    assert before.domain == (0.25, 1) and after.domain == (1, 2) and before.origin == curve.origin
    assert np.array_equal(before.coefficients, curve.coefficients) and curve == before.with_domain((0.25, 2))
    back = curve.reversed()
    assert back.origin == 2.75 and back.domain == curve.domain and back.reversed() == curve
    u = np.linspace(0.25, 2, 15)
    assert np.abs(back.evaluate(2.25 - u) - curve.evaluate(u)).max() <= 1e-15


@given(point_lists(), st.floats(-3, 3), st.floats(-3, 3))
def test_reversed_is_right_also_where_the_mirrored_origin_has_more_digits(rows, origin, start):
    curve = sc.PowerCurve(rows, origin, (start, start + 0.7))
    (b,), (c,) = curve.to_bezier(), curve.reversed().to_bezier()
    size = max(1, np.abs(b.points).max(), max(np.abs(r).max() * 7.0**k for k, r in enumerate(curve.coefficients)))
    assert np.abs(c.points[::-1] - b.points).max() <= 64 * ULP * size


def test_rational_parts_are_what_was_given():
    curve = parabola()
    assert curve.is_rational and curve.weights.tolist() == [2, 0.25, 0.5]
    assert curve.coefficients.tolist() == [[1, 0, 2], [0.5, 1, 0], [0, 0.25, 1]]
    assert curve.homogeneous_coefficients.tolist() == [[1, 0, 2, 2], [0.5, 1, 0, 0.25], [0, 0.25, 1, 0.5]]
    assert sc.PowerCurve.from_homogeneous(curve.homogeneous_coefficients, -0.5, curve.domain) == curve
    for array in (curve.coefficients, curve.weights, curve.homogeneous_coefficients):
        assert not array.flags.writeable
    assert repr(curve) == "PowerCurve(degree=2, origin=-0.5, rational)"
    assert repr(sc.PowerCurve([(0, 0), (1, 1)])) == "PowerCurve(degree=1, origin=0)"


def test_a_point_at_infinity_is_a_zero_of_the_denominator():
    curve = sc.PowerCurve.from_homogeneous([(1, 0, 0, -0.5), (0, 1, 0, 1)])
    assert curve.pieces() == [(0, 0.5), (0.5, 1)] and len(curve.polylines(8)) == 2
    with pytest.raises(sc.PointAtInfinity, match="0.5"):
        curve.evaluate(0.5)
    assert np.isnan(curve.evaluate([0.5], at_infinity="nan")).all()
    assert np.abs(semicircle().to_power().evaluate(0.5) - (0, 1, 0)).max() == 0


@pytest.mark.parametrize("curve", [cubic(), hermite_chain()])
def test_every_span_becomes_a_power_curve_about_its_start(curve):
    powers = curve.to_power()
    assert len(powers) == len(curve.to_bezier()) and powers[0].domain[0] == curve.domain[0]
    for power in powers:
        u = np.linspace(*power.domain, 9)[:-1]
        assert power.origin == power.domain[0]
        assert np.abs(power.evaluate(u) - curve.evaluate(u)).max() <= 64 * ULP * 2


def test_a_cubic_becomes_a_hermite_chain():
    chain = sc.PowerCurve([(0, 1), (2, 0), (0, 3), (4, 4)], domain=(1, 3)).to_hermite()
    assert chain.parameters.tolist() == [1, 3] and np.allclose(chain.points, [(6, 8, 0), (114, 136, 0)], rtol=1e-15)


def test_degree_255_about_the_start_is_right():
    rows = np.random.default_rng(1).uniform(0, 1, (256, 3))
    curve = sc.PowerCurve(rows)
    for t in (0.0, 0.3, 0.9, 1.0):
        right = np.array([float(value) for value in exact_value(exact(rows), 0, t)])
        assert np.abs(curve.evaluate(t) / right - 1).max() <= 1e-13


ROWS = [(0, 0), (1, 1)]


@pytest.mark.parametrize("call, words", [
    (lambda: sc.PowerCurve([(0, 0)]), "coefficients has 1 rows"),
    (lambda: sc.PowerCurve(np.zeros((0, 3))), "coefficients has 0 rows"),
    (lambda: sc.PowerCurve(np.zeros((257, 3))), "degree = 256"),
    (lambda: sc.PowerCurve(np.zeros((1_000_000, 2))), "degree = 999999"),
    (lambda: sc.PowerCurve([(0, 0), (1, NAN)]), r"coefficients\[1\].y = nan"),
    (lambda: sc.PowerCurve([0, 1]), r"coefficients has shape \(2,\)"),
    (lambda: sc.PowerCurve(np.zeros((3, 4))), r"coefficients has shape \(3, 4\)"),
    (lambda: sc.PowerCurve(ROWS, INF), "origin = inf"),
    (lambda: sc.PowerCurve(ROWS, 0, (1, 1)), r"domain = \(1, 1\)"),
    (lambda: sc.PowerCurve(ROWS, 0, (2, 1)), r"domain = \(2, 1\)"),
    (lambda: sc.PowerCurve(ROWS, 0, (0, NAN)), r"domain"),
    (lambda: sc.PowerCurve(ROWS, 0, (-1e308, 1e308)), r"domain"),
    (lambda: sc.PowerCurve(ROWS, 0, (0, 1, 2)), "domain has 3 values"),
    (lambda: sc.PowerCurve([(0, 0), (1, 1), (1e300, 0)], 0, (0, 1e10)), "overflow on the domain"),
    (lambda: sc.PowerCurve([(0, 0), (1, 1), (1, 0)], 1e200), "overflow on the domain"),
    (lambda: sc.PowerCurve.from_homogeneous(np.ones((2, 3))), r"coefficients has shape \(2, 3\)"),
    (lambda: sc.PowerCurve.from_homogeneous([(1, 1, 1, 0), (1, 1, 1, 0)]), "every w is zero"),
    (lambda: sc.PowerCurve.from_homogeneous([(1, 1, 1, INF), (1, 1, 1, 0)]), r"coefficients\[0\].w = inf"),
    (lambda: sc.PowerCurve(ROWS).with_origin(NAN), "origin = nan"),
    (lambda: sc.PowerCurve(ROWS).with_domain((3, 2)), "domain"),
    (lambda: sc.PowerCurve(ROWS).split(1), "u = 1 is not inside"),
    (lambda: sc.BezierCurve(ROWS).to_power(INF), "origin = inf"),
    (lambda: sc.BezierCurve(random_points(4, seed=0)).to_power(1e200), "coefficients"),
    (lambda: sc.PowerCurve.from_homogeneous(np.ones((150, 4))).derivative(), "degree = 298"),
    (lambda: parabola().evaluate(3), r"u = 3 is outside"),
    (lambda: parabola().to_hermite(), "weights"),
])
def test_bad_numbers_are_named(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call, words", [
    (lambda: sc.PowerCurve(None), "coefficients"), (lambda: sc.PowerCurve("ab"), "coefficients"),
    (lambda: sc.PowerCurve(ROWS, "0"), "origin"), (lambda: sc.PowerCurve(ROWS, None), "origin"),
    (lambda: sc.PowerCurve(ROWS, 0, None), "domain"), (lambda: parabola().with_origin([1, 2]), "origin"),
    (lambda: sc.PowerCurve(), ""), (lambda: parabola().split("x"), "u"), (lambda: sc.BezierCurve(ROWS).to_power(None), "origin"),
])
def test_what_is_no_number_raises_type_error(call, words):
    with pytest.raises(TypeError, match=words):
        call()
