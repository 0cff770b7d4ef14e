"""The matrices and the triangular scheme of the lectures (rows S4, S6, S13, S14)."""

from fractions import Fraction
from math import comb, factorial

import numpy as np
import pytest
from hypothesis import given

import splinecore as sc
from shapes import closed_cubic, cubic, inside, nurbs_curves, random_points

KnotVector = sc.basis.KnotVector


def test_the_matrices_of_degree_3_are_the_lectures():
    assert np.array_equal(sc.basis.uniform_matrix(3),
                          np.array([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 0, 3, 0], [1, 4, 1, 0]]) / 6)
    assert np.array_equal(sc.basis.uniform_to_bezier(3),
                          np.array([[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]]) / 6)
    assert sc.basis.bezier_matrix(3).tolist() == [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]]
    assert sc.basis.hermite_matrix().tolist() == [[2, 1, -2, 1], [-3, -2, 3, -1], [0, 1, 0, 0], [1, 0, 0, 0]]
    assert sc.basis.uniform_matrix(0).tolist() == sc.basis.bezier_matrix(0).tolist() == [[1]]


def exact_uniform(degree):
    """Coefficients of t^k in the functions on a span, from the truncated powers: sum (-1)^s C(p+1, s) (x - s)^p / p!."""
    functions = []
    for j in range(degree + 1):
        power = [Fraction(0)] * (degree + 1)
        for s in range(degree - j + 1):  # x = t + degree - j
            for k in range(degree + 1):
                power[k] += Fraction((-1) ** s * comb(degree + 1, s) * comb(degree, k) * (degree - j - s) ** (degree - k),
                                     factorial(degree))
        functions.append(power)
    return functions


@pytest.mark.parametrize("degree", range(1, 19))
def test_every_number_of_the_uniform_matrices_is_right_in_its_last_digit(degree):
    functions = exact_uniform(degree)
    expected = [[float(function[k]) for function in functions] for k in range(degree, -1, -1)]
    assert sc.basis.uniform_matrix(degree).tolist() == expected
    bezier = [[float(sum(Fraction(comb(i, k), comb(degree, k)) * function[k] for k in range(i + 1)))
               for function in functions] for i in range(degree + 1)]
    assert sc.basis.uniform_to_bezier(degree).tolist() == bezier


@pytest.mark.parametrize("degree", [1, 2, 5, 20, 33])
def test_every_number_of_bezier_matrices_is_the_integer(degree):
    expected = [[comb(degree, k) * comb(k, j) * (-1) ** (k - j) for j in range(degree + 1)] for k in range(degree, -1, -1)]
    assert sc.basis.bezier_matrix(degree).astype(int).tolist() == expected


def test_the_matrices_make_the_curves():
    points = random_points(4, seed=51)
    t = np.linspace(0, 1, 11)
    powers = np.stack([t**3, t**2, t, np.ones(11)], 1)
    spline = sc.NurbsCurve(3, np.arange(8.0), points)
    assert np.abs(powers @ sc.basis.uniform_matrix(3) @ points - spline.evaluate(3 + t)).max() <= 1e-14
    assert np.abs(sc.basis.uniform_to_bezier(3) @ points - spline.to_bezier()[0].points).max() <= 1e-15
    assert np.abs(powers @ sc.basis.bezier_matrix(3) @ points - sc.BezierCurve(points).evaluate(t)).max() <= 1e-14
    chain = sc.HermiteCurve(points[[0, 2]], points[[1, 3]])
    assert np.abs(powers @ sc.basis.hermite_matrix() @ points - chain.evaluate(t)).max() <= 1e-14


def test_the_triangle_on_0_to_5_is_the_lectures():
    rows = KnotVector(2, [0, 1, 2, 3, 4, 5]).triangle(2.5)
    assert [row[0].tolist() for row in rows] == [[2], [1, 2], [0, 1, 2]]
    assert [row[1].tolist() for row in rows] == [[1], [0.5, 0.5], [0.125, 0.75, 0.125]]
    assert rows[0][2].size == rows[0][3].size == 0
    assert rows[2][2].tolist() == [0, 0.75, 0.25] and rows[2][3].tolist() == [0.25, 0.75, 0]


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_functions_on_0_to_5_are_shifts_of_one(degree):
    knots = KnotVector(degree, [0, 1, 2, 3, 4, 5])
    u = np.linspace(0, 4.984375, 320)
    for i in range(1, knots.count):
        assert np.abs(knots.function(i, u) - knots.function(0, u - i)).max() <= 1e-15
    for value in (0.25, 1, 2.5, 4.75):
        indices, values, _, _ = knots.triangle(value)[-1]
        assert values.tolist() == [knots.function(i, value) for i in indices]


def test_the_triangle_exists_where_the_domain_is_empty():
    knots = KnotVector(2, [0, 1, 2, 3])
    assert [row[1].tolist() for row in knots.triangle(0.5)] == [[1], [0.5], [0.125]]
    assert [row[0].tolist() for row in knots.triangle(2.5)] == [[2], [1], [0]]
    with pytest.raises(sc.InvalidShape, match=r"u = 3 is outside \[0, 3\)"):
        knots.triangle(3)


@given(nurbs_curves())
def test_rows_of_the_triangle_feed_each_other_and_end_in_the_functions(curve):
    knots = curve.knot_vector
    for u in inside(curve.domain, 5):
        rows = knots.triangle(u)
        assert len(rows) == curve.degree + 1
        for (below, values_below, _, _), (indices, values, rising, falling) in zip(rows, rows[1:]):
            known = dict(zip(below.tolist(), values_below.tolist()))
            for i, value, up, down in zip(indices.tolist(), values, rising, falling):
                assert (up != 0) <= (i in known) and (down != 0) <= (i + 1 in known) and 0 <= up <= 1 and 0 <= down <= 1
                assert value == up * known.get(i, 0.0) + down * known.get(i + 1, 0.0)
        all_values = np.zeros(knots.count)
        all_values[rows[-1][0]] = rows[-1][1]
        assert np.abs(all_values - knots.functions(u)).max() <= 1e-13


def test_the_triangle_of_a_periodic_vector_has_its_own_indices():
    knots = closed_cubic().knot_vector
    for u in (0.5, 2.75, 5.5, 6.25):
        indices, values, _, _ = knots.triangle(u)[-1]
        row = np.zeros(5)
        row[indices] = values
        assert np.abs(row - knots.functions(u)).max() <= 1e-15


def test_derivatives_on_0_1_2_3_are_the_lectures_pieces_differentiated():
    knots = KnotVector(2, [0, 1, 2, 3])
    u = np.array([0.5, 1.25, 2.0, 2.5, 3.0, -1.0])
    expected = [[0.125, 0.5, 1], [0.6875, 0.5, -2], [0.5, -1, 1], [0.125, -0.5, 1], [0, 0, 0], [0, 0, 0]]
    assert knots.function_derivatives(0, u, 2).tolist() == expected
    assert knots.function_derivatives(0, 1.5, 4)[3:].tolist() == [0, 0]


@given(nurbs_curves())
def test_derivatives_of_functions_make_those_of_the_curve(curve):
    knots = curve.knot_vector
    u = inside(curve.domain, 6)
    order = min(2, curve.degree)
    table = np.stack([knots.function_derivatives(i, u, order) for i in range(knots.count)])
    samples = sc.basis.Samples(knots, u, order)
    for k in range(order + 1):
        right = samples.apply(np.eye(knots.count), k).T
        assert np.abs(table[..., k] - right).max() <= 1e-12 * np.abs(right).max()
    assert np.abs(table[..., 0].sum(0) - 1).max() <= 1e-13 and np.abs(table[..., 1].sum(0)).max() <= 1e-10


def test_derivatives_of_periodic_functions_are_those_of_samples():
    knots = closed_cubic().knot_vector
    u = np.linspace(-3, 9, 25)
    table = np.stack([knots.function_derivatives(i, u, 2) for i in range(5)], 1)
    right = sc.basis.Samples(knots, u, 2)
    assert np.abs(table[..., 2] - right.apply(np.eye(5), 2)).max() <= 1e-13


def test_spans_are_those_of_positive_length():
    knots = cubic().knot_vector
    assert knots.spans.tolist() == sorted(set(knots.span(inside(knots.domain, 100)).tolist()))
    assert not knots.spans.flags.writeable and KnotVector(2, [0, 1, 2, 3]).spans.size == 0


KNOTS = KnotVector(1, [0, 1, 2, 3])


@pytest.mark.parametrize("call, error, words", [
    (lambda: sc.basis.uniform_matrix(19), sc.InvalidShape, r"degree = 19 is outside \[0, 18\]"),
    (lambda: sc.basis.uniform_to_bezier(-1), sc.InvalidShape, "degree = -1"),
    (lambda: sc.basis.bezier_matrix(34), sc.InvalidShape, r"degree = 34 is outside \[0, 33\]"),
    (lambda: sc.basis.bezier_matrix(10**30), sc.InvalidShape, "degree = 10{30}"),
    (lambda: sc.basis.uniform_matrix(3.0), TypeError, "degree"), (lambda: sc.basis.uniform_matrix(None), TypeError, "degree"),
    (lambda: KNOTS.triangle(-0.5), sc.InvalidShape, r"u = -0.5 is outside"),
    (lambda: KNOTS.triangle(np.nan), sc.InvalidShape, "u = nan"), (lambda: KNOTS.triangle([0, 1]), TypeError, "u must be one"),
    (lambda: KNOTS.function_derivatives(2, 0, 1), sc.InvalidShape, "i = 2"),
    (lambda: KNOTS.function_derivatives(0, [0, np.inf], 1), sc.InvalidShape, r"u\[1\] = inf"),
    (lambda: KNOTS.function_derivatives(0, 0, 65), sc.InvalidShape, "order = 65"),
    (lambda: KNOTS.function_derivatives(0, 0, -1), sc.InvalidShape, "order = -1"),
    (lambda: KNOTS.function_derivatives(0, "a", 1), TypeError, "u"),
])
def test_bad_arguments_are_named(call, error, words):
    with pytest.raises(error, match=words):
        call()
