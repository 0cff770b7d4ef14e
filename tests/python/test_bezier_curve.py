"""BezierCurve: conics, degree 60, points at infinity (rows S6, S9, S11)."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest

import splinecore as sc
from shapes import HALF, hyperbola, semicircle


def de_casteljau(points, t):
    """Exact: coordinates are fractions."""
    row = [tuple(map(Fraction, point)) for point in points]
    t = Fraction(t)
    while len(row) > 1:
        row = [tuple((1 - t) * a + t * b for a, b in zip(p, q)) for p, q in zip(row, row[1:])]
    return row[0]


def test_degree_60_is_within_1e_13_of_exact_de_casteljau():
    points = np.random.default_rng(60).uniform(-1, 1, (61, 3))
    curve = sc.BezierCurve(points)
    for t in (0.0, 2.0**-30, 0.1, 0.25, 1 / 3, 0.5, 0.77, 1 - 2.0**-40, 1.0):
        exact = np.array([float(value) for value in de_casteljau(points.tolist(), t)])
        assert np.abs(curve.evaluate(t) - exact).max() <= 1e-13 * np.abs(exact).max()


def test_degree_60_with_weights_is_within_1e_13_of_exact_de_casteljau():
    rng = np.random.default_rng(61)
    points, weights = rng.uniform(1, 2, (61, 3)), rng.uniform(0.1, 10, 61)
    curve = sc.BezierCurve(points, weights)
    rows = [[Fraction(w) * Fraction(x) for x in p] + [Fraction(w)] for p, w in zip(points.tolist(), weights.tolist())]
    for t in (0.125, 0.5, 0.9):
        *numerators, denominator = de_casteljau(rows, t)
        exact = np.array([float(value / denominator) for value in numerators])
        assert np.abs(curve.evaluate(t) / exact - 1).max() <= 1e-13


def test_degree_255_is_the_highest():
    u = np.linspace(0, 1, 9)
    line = sc.BezierCurve([(i / 255, 0) for i in range(256)])
    assert np.abs(line.evaluate(u)[:, 0] - u).max() <= 1e-13
    with pytest.raises(sc.InvalidShape, match="256"):
        sc.BezierCurve(np.zeros((257, 3)))


def test_quarter_circle_has_radius_one():
    arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, HALF, 1])
    radius = np.linalg.norm(arc.evaluate(np.linspace(0, 1, 101)), axis=1)
    assert np.abs(radius - 1).max() <= 4e-16


def test_semicircle_with_a_point_at_infinity_stays_on_the_circle():
    points = semicircle().evaluate(np.linspace(0, 1, 101))
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() <= 4e-16
    assert points[50].tolist() == [0, 1, 0]


@pytest.mark.parametrize("weight, sign", [(0.5, -1), (1, 0), (2, 1), (-0.5, -1)])
def test_middle_weight_chooses_the_conic(weight, sign):
    curve = sc.BezierCurve([(1, 0), (0, 0), (0, 1)], [1, weight, 1])
    x, y, _ = curve.evaluate(np.linspace(0, 1, 41)).T
    # With corners at the axes, x = t²/W and y = (1-t)²/W: (1 - x - y)² = 4 w² x y.
    assert np.abs((1 - x - y) ** 2 - 4 * weight**2 * x * y).max() <= 2e-14
    assert np.sign(weight**2 - 1) == sign


def test_weight_minus_one_passes_through_infinity_once():
    curve = sc.BezierCurve([(1, 0), (0, 0), (0, 1)], [1, -1, 1])
    assert curve.pieces() == [(0, 0.5), (0.5, 1)]
    with pytest.raises(sc.PointAtInfinity, match="0.5"):
        curve.evaluate([0.25, 0.5])
    marked = curve.evaluate([0.25, 0.5], at_infinity="nan")
    assert np.isfinite(marked[0]).all() and np.isnan(marked[1]).all()


def test_hyperbola_has_three_finite_pieces():
    curve = hyperbola()
    pieces = curve.pieces()
    assert len(pieces) == 3 and pieces[0][0] == 0 and pieces[-1][1] == 1
    # W = (1-t)² - 3 t (1-t) + t² is zero at t = (1 ± 1/√5)/2.
    assert np.allclose([pieces[0][1], pieces[1][1]], [0.5 - 0.5 / 5**0.5, 0.5 + 0.5 / 5**0.5], rtol=1e-14)
    lines = curve.polylines(64)
    assert len(lines) == 3 and all(np.isfinite(points).all() and not closed for points, closed in lines)


def test_at_infinity_a_derivative_is_refused_or_marked():
    curve = sc.BezierCurve([(1, 0), (0, 0), (0, 1)], [1, -1, 1])
    with pytest.raises(sc.PointAtInfinity):
        curve.derivatives(0.5, 1)
    assert np.isnan(curve.derivatives([0.5], 1, at_infinity="nan")).all()


def test_end_derivatives_come_from_the_end_points():
    points = np.random.default_rng(4).normal(size=(6, 3))
    derivatives = sc.BezierCurve(points).derivatives([0.0, 1.0], 2)
    assert np.allclose(derivatives[0, 1], 5 * (points[1] - points[0]), rtol=1e-14)
    assert np.allclose(derivatives[1, 2], 20 * (points[5] - 2 * points[4] + points[3]), rtol=1e-13)


def test_derivatives_above_the_degree_are_zero():
    values = sc.BezierCurve([(0, 0), (1, 2)]).derivatives(0.5, 64)
    assert values.shape == (65, 3) and (values[2:] == 0).all()


def test_split_is_de_casteljaus():
    curve = sc.BezierCurve([(0, 0), (0, 4), (4, 4), (4, 0)])
    before, after = curve.split(0.5)
    assert before.points[:, :2].tolist() == [[0, 0], [0, 2], [1, 3], [2, 3]]
    assert after.points[:, :2].tolist() == [[2, 3], [3, 3], [4, 2], [4, 0]]
    assert before.domain == after.domain == (0, 1)


def test_hermite_form_has_three_times_the_legs():
    curve = sc.BezierCurve([(0, 0), (1, 2), (3, 3), (4, 0)])
    chain = curve.to_hermite()
    assert chain.tangents[0, 1].tolist() == [3, 6, 0] and chain.tangents[1, 0].tolist() == [3, -9, 0]
    (again,) = chain.to_bezier()
    assert np.allclose(again.points, curve.points, rtol=1e-15)


def test_forms_and_properties_agree():
    curve = semicircle()
    assert curve.degree == 2 and curve.domain == (0, 1) and curve.is_rational
    assert curve.weights.tolist() == [1, 0, 1]
    assert curve.to_nurbs().knots.tolist() == [0, 0, 0, 1, 1, 1]
    assert curve.to_bezier() == [curve]
    assert sc.BezierCurve.from_homogeneous(curve.homogeneous_points) == curve
    assert curve.with_points(2 * curve.points).weights.tolist() == [1, 0, 1]
    assert curve.with_weights([1, 2, 1]).weights.tolist() == [1, 2, 1]
    assert curve.reversed().points.tolist() == curve.points[::-1].tolist()


def test_binomials_are_right_at_degree_40():
    u = 0.3
    spike = np.zeros((41, 3))
    spike[17, 0] = 1
    expected = comb(40, 17) * Fraction(u) ** 17 * (1 - Fraction(u)) ** 23
    assert abs(sc.BezierCurve(spike).evaluate(u)[0] / float(expected) - 1) <= 1e-14
