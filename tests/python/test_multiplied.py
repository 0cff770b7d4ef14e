"""A homogeneous curve times a linear function is the same curve: against products of polynomials, of curves of every kind."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc


def product(rows, start, end):
    """Bezier points of the product, in fractions."""
    n = len(rows)
    rows = [[Fraction(x) for x in row] for row in rows]
    found = []
    for i in range(n + 1):
        before = [Fraction(i, n) * Fraction(end) * x for x in rows[i - 1]] if i else [Fraction(0)] * 4
        after = [Fraction(n - i, n) * Fraction(start) * x for x in rows[i]] if i < n else [Fraction(0)] * 4
        found.append([float(a + b) for a, b in zip(before, after)])
    return np.array(found)


@pytest.mark.parametrize('degree', (1, 2, 3, 7, 20, 60))
def test_bezier_points_are_those_of_the_product(degree):
    random = np.random.default_rng(degree)
    rows = random.integers(-9, 9, (degree + 1, 4)).astype(float)
    rows[0, 3] = 3.0
    found = sc.BezierCurve.from_homogeneous(rows).multiplied(0.25, 4.0)
    assert found.degree == degree + 1
    assert np.allclose(found.homogeneous_points, product(rows, 0.25, 4.0), rtol=1e-13, atol=1e-13)


def curves(random, count):
    for _ in range(count):
        degree = int(random.integers(1, 8))
        inner = np.sort(random.uniform(0.0, 1.0, int(random.integers(0, 5))))
        inner = np.repeat(inner, random.integers(1, degree + 1, len(inner)))
        knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)]) * 10.0 ** random.integers(-3, 4) + random.uniform(-1, 1)
        number = len(knots) - degree - 1
        weights = np.exp2(random.uniform(-3, 3, number))
        yield sc.NurbsCurve(degree, knots, random.uniform(-5, 5, (number, 3)), weights)
        yield sc.NurbsCurve(degree, np.cumsum(random.uniform(0.1, 2.0, number + degree + 1)), random.uniform(-5, 5, (number, 3)), weights)
        count = degree + 2
        yield sc.NurbsCurve(degree, np.cumsum(random.uniform(0.1, 2.0, count + 1)), random.uniform(-5, 5, (count, 3)), weights[:1].repeat(count),
                            periodic=True)


def test_places_stay_and_homogeneous_coordinates_are_multiplied():
    random = np.random.default_rng(44)
    for curve in curves(random, 60):
        a, b = np.exp2(random.uniform(-4, 4, 2))
        found = curve.multiplied(a, b)
        start, end = curve.domain
        assert found.domain == curve.domain and found.degree == curve.degree + 1 and not found.periodic
        u = np.concatenate([np.linspace(start, end, 41), np.array(curve.knots)])
        u = u[(u >= start) & (u <= end)]
        assert np.allclose(found.evaluate(u), curve.evaluate(u), rtol=1e-11, atol=1e-11)
        weights = [sc.NurbsCurve(one.degree, one.knots, np.column_stack([one.weights, np.zeros((len(one.weights), 2))]), periodic=one.periodic)
                   .evaluate(u)[:, 0] for one in (curve, found)]
        factor = a + (u - start) / (end - start) * (b - a)
        assert np.allclose(weights[1], factor * weights[0], rtol=1e-11, atol=0)


def test_it_is_joined_as_smoothly_as_before():
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3], np.random.default_rng(1).uniform(-1, 1, (7, 3)), [1, 2, 1, 3, 1, 2, 1])
    found = curve.multiplied(1.0, 5.0)
    for u in (1.0, 2.0):
        assert found.knot_vector.multiplicity(u) == curve.knot_vector.multiplicity(u) + 1
    assert [(u, joint.c) for u, joint in found.joints()] == [(u, joint.c) for u, joint in curve.joints()]


def test_a_point_at_infinity_stays_there():
    found = sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]).multiplied(1.0, 1.0)
    assert np.allclose(np.linalg.norm(found.evaluate(np.linspace(0, 1, 9)), axis=1), 1.0, rtol=0, atol=1e-15)
    assert np.allclose(found.homogeneous_points, sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]).elevate().homogeneous_points, rtol=0, atol=1e-15)


@pytest.mark.parametrize('ends', ((0.0, 1.0), (1.0, -1.0), (np.inf, 1.0), (1.0, np.nan), (1e-320, 1.0), (1.0, 1e101)))
def test_what_is_not_above_0_is_refused(ends):
    with pytest.raises(sc.InvalidShape, match=r"^(start|end) = .* is not"):
        sc.BezierCurve(np.eye(3)).multiplied(*ends)


def test_the_degree_has_a_limit():
    with pytest.raises(sc.InvalidShape, match="exceed 255"):
        sc.BezierCurve(np.zeros((256, 3))).multiplied(1.0, 2.0)
