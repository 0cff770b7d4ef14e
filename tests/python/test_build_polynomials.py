"""Lagrange's and Hermite's polynomials against the same sums in fractions (row S3)."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import point_lists, random_points

NAN, INF = float("nan"), float("inf")
build = sc.build


def runge(x):
    return 1 / (1 + 25 * x * x)


def exact_lagrange(points, parameters, u):
    """The basis polynomials multiplied out, in fractions."""
    at, u = [Fraction(t) for t in parameters], Fraction(u)
    sums = [Fraction(0)] * 3
    for j, point in enumerate(points):
        factor = Fraction(1)
        for i, t in enumerate(at):
            if i != j:
                factor *= (u - t) / (at[j] - t)
        sums = [total + factor * Fraction(x) for total, x in zip(sums, point)]
    return np.array([float(total) for total in sums])


def exact_hermite(data, parameters):
    """Monomial coefficients of one coordinate by Gauss elimination on all conditions, in fractions."""
    rows = []
    count = sum(map(len, data))
    for t, derivatives in zip(parameters, data):
        for order, value in enumerate(derivatives):
            row = []
            for k in range(count):
                factor = Fraction(0)
                if k >= order:
                    factor = Fraction(t) ** (k - order)
                    for i in range(order):
                        factor *= k - i
                row.append(factor)
            rows.append(row + [Fraction(value)])
    for i in range(count):
        pivot = next(j for j in range(i, count) if rows[j][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for j in range(count):
            if j != i and rows[j][i] != 0:
                rows[j] = [x - rows[j][i] * y for x, y in zip(rows[j], rows[i])]
    return [row[-1] for row in rows]


@given(point_lists(2, 12), st.data())
def test_the_polynomial_is_lagranges(points, data):
    points = [tuple(map(float, point)) for point in points]
    steps = data.draw(st.lists(st.sampled_from([0.25, 0.5, 1.0, 1.5]), min_size=len(points), max_size=len(points)))
    parameters = np.cumsum(steps).tolist()
    curve = build.polynomial_through(points, parameters)
    assert curve.degree == len(points) - 1 and curve.domain == (parameters[0], parameters[-1])
    size = np.abs(curve.points).max() + 1e-300
    for u in np.linspace(*curve.domain, 7):
        assert np.abs(curve.evaluate(u) - exact_lagrange(points, parameters, u)).max() <= 1e-14 * size
    assert np.abs(curve.evaluate(parameters) - points).max() <= 1e-14 * size


@given(point_lists(2, 9))
def test_the_barycentric_form_is_the_same_polynomial(points):
    curve = build.polynomial_through(points)
    u = np.linspace(0, 1, 23).reshape(1, 23)
    direct = build.lagrange_evaluate(points, u)
    assert direct.shape == (1, 23, 3)
    assert np.abs(direct - curve.evaluate(u)).max() <= 1e-13 * (np.abs(curve.points).max() + 1e-300)
    nodes = np.arange(len(points)) / (len(points) - 1)
    assert np.array_equal(build.lagrange_evaluate(points, nodes), np.array(points, float))


@pytest.mark.parametrize("degree, bound", [(5, 1e-15), (10, 1e-13), (20, 1e-12), (30, 1e-11), (40, 1e-9)])
def test_runges_polynomial_on_equal_steps_is_exact_to_its_own_size(degree, bound):
    x = np.linspace(-1, 1, degree + 1)
    points = np.stack([x, runge(x), 0 * x], 1)
    curve = build.polynomial_through(points, x)
    for u in (-0.99, -0.6, 0.01, 0.3, 0.95):
        exact = exact_lagrange(points.tolist(), x.tolist(), u)
        assert np.abs(curve.evaluate(u) - exact).max() <= bound
    assert np.abs(curve.evaluate(x) - points).max() <= bound


@pytest.mark.parametrize("degree", [10, 40, 100])
def test_runges_polynomial_on_chebyshevs_parameters_converges(degree):
    x = -np.cos(np.pi * np.arange(degree + 1) / degree)
    points = np.stack([x, runge(x), 0 * x], 1)
    curve = build.polynomial_through(points, x)
    u = np.linspace(-1, 1, 301)
    error = np.abs(curve.evaluate(u)[:, 1] - runge(u)).max()
    assert error <= 2 * ((1 + 26**0.5) / 5) ** -degree
    assert np.abs(curve.evaluate(u) - build.lagrange_evaluate(points, u, x)).max() <= 1e-14
    assert np.abs(curve.evaluate(x) - points).max() <= 1e-14


def test_one_span_becomes_several_where_its_points_would_hide_the_curve():
    x = -np.cos(np.pi * np.arange(101) / 100)
    curve = build.polynomial_through(np.stack([x, runge(x)], 1), x)
    assert len(curve.to_bezier()) == 4 and curve.degree == 100 and np.abs(curve.points).max() < 2
    inner = curve.derivatives(curve.to_bezier() and 0.0, 3, side="left") - curve.derivatives(0.0, 3)
    assert np.abs(inner).max() <= 1e-6
    assert len(build.polynomial_through(random_points(8, seed=1)).to_bezier()) == 1


def test_the_polynomial_is_affinely_invariant_and_turns_with_its_points():
    points = random_points(7, seed=8)
    matrix, shift = random_points(3, seed=9), np.array([1, -2, 3])
    u = np.linspace(0, 1, 21)
    there = build.polynomial_through(points).evaluate(u) @ matrix + shift
    assert np.abs(build.polynomial_through(points @ matrix + shift).evaluate(u) - there).max() <= 1e-12
    back = build.polynomial_through(points[::-1]).evaluate(1 - u)
    assert np.abs(back - build.polynomial_through(points).evaluate(u)).max() <= 1e-12


small = st.integers(-16, 16).map(float)


@given(st.lists(st.lists(small, min_size=1, max_size=3), min_size=2, max_size=4), st.data())
def test_the_osculating_polynomial_is_the_solution_of_its_equations(data, draw):
    steps = draw.draw(st.lists(st.sampled_from([0.5, 1.0, 2.0]), min_size=len(data), max_size=len(data)))
    parameters = np.cumsum(steps).tolist()
    curve = build.osculating_polynomial([[(x, 0.0) for x in row] for row in data], parameters)
    coefficients = exact_hermite(data, parameters)
    assert curve.degree == sum(map(len, data)) - 1
    for u in np.linspace(*curve.domain, 9):
        exact = float(sum(c * Fraction(u) ** k for k, c in enumerate(coefficients)))
        assert abs(curve.evaluate(u)[0] - exact) <= 1e-14 * max(1, np.abs(curve.points).max())


def test_two_points_with_derivatives_are_hermites_cubic():
    chain = sc.HermiteCurve(random_points(2, seed=3), random_points(2, seed=4), [1, 3])
    data = np.stack([chain.points, chain.tangents[:, 1]], 1)
    curve = build.osculating_polynomial(data, [1, 3])
    u = np.linspace(1, 3, 11)
    assert np.abs(curve.evaluate(u) - chain.evaluate(u)).max() <= 1e-14


def test_a_domain_of_one_ulp_is_not_halved():
    data = [[(0, 0), (1e30, 0), (1e50, 1e60)], [(1, 1), (-1e33, 1e33), (1e55, 0)]]
    curve = build.osculating_polynomial(data, [1, np.nextafter(1, 2)])
    assert curve.degree == 5 and np.isfinite(curve.points).all() and len(curve.to_bezier()) == 1


LINE = [(0, 0), (1, 1)]


@pytest.mark.parametrize("call, words", [
    (lambda: build.polynomial_through([(0, 0)]), "points has 1 rows"),
    (lambda: build.polynomial_through(np.zeros((0, 3))), "points has 0 rows"),
    (lambda: build.polynomial_through(np.zeros((257, 3))), "degree = 256"),
    (lambda: build.polynomial_through(np.zeros((100_000, 3))), "degree = 99999"),
    (lambda: build.polynomial_through([0, 1]), r"points has shape \(2,\)"),
    (lambda: build.polynomial_through([(0, 0), (1, NAN)]), r"points\[1\].y = nan"),
    (lambda: build.polynomial_through(LINE, [0, 0]), r"parameters\[1\] = 0 does not increase"),
    (lambda: build.polynomial_through(LINE, [1, 0]), r"parameters\[1\] = 0 does not increase"),
    (lambda: build.polynomial_through(LINE, [0, INF]), r"parameters\[1\] = inf"),
    (lambda: build.polynomial_through(LINE, [0, 1, 2]), "parameters has 3 values"),
    (lambda: build.polynomial_through([(0, 0), (1e300, 0), (0, 0), (-1e300, 0)], [0, 1e-200, 2e-200, 1]), "overflow"),
    (lambda: build.lagrange_evaluate(LINE, [0.5, 2]), r"u\[1\] = 2 is outside"),
    (lambda: build.lagrange_evaluate(LINE, NAN), r"u\[0\] = nan"),
    (lambda: build.lagrange_evaluate([(0, 0)], 0), "points has 1 rows"),
    (lambda: build.osculating_polynomial([LINE, LINE], [0]), "data has 2 rows for 1"),
    (lambda: build.osculating_polynomial([LINE], [0]), "parameters has 1 values"),
    (lambda: build.osculating_polynomial([LINE, LINE], [1, 1]), r"parameters\[1\] = 1"),
    (lambda: build.osculating_polynomial([LINE, np.zeros((0, 2))], [0, 1]), r"data\[1\] is empty"),
    (lambda: build.osculating_polynomial([LINE, [(0, INF)]], [0, 1]), r"data\[1\]\[0\].y = inf"),
    (lambda: build.osculating_polynomial([LINE, [0, 1]], [0, 1]), r"data\[1\] has shape"),
    (lambda: build.osculating_polynomial([np.zeros((200, 2)), np.zeros((100, 2))], [0, 1]), "degree = 299"),
])
def test_bad_numbers_are_named(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call, words", [
    (lambda: build.polynomial_through(None), "points"), (lambda: build.polynomial_through(LINE, "ab"), "parameters"),
    (lambda: build.osculating_polynomial(3, [0, 1]), "data"), (lambda: build.osculating_polynomial("ab", [0, 1]), "data"),
    (lambda: build.osculating_polynomial([LINE, None], [0, 1]), r"data\[1\]"),
    (lambda: build.osculating_polynomial([LINE, LINE], None), "parameters"),
    (lambda: build.lagrange_evaluate(LINE, "x"), "u"), (lambda: build.lagrange_evaluate(LINE), "u"),
])
def test_what_is_no_number_raises_type_error(call, words):
    with pytest.raises(TypeError, match=words):
        call()
