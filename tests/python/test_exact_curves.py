"""Insertion, elevation, removal and reduction against an exact second implementation (row S15)."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc
from exact_splines import (elevation_matrix, exact, functions, inserted, insertion_matrix, nearest, product, rounded,
                           value)
from random_curves import ENDS, random_curve

SEEDS = range(12)


def parts(curve):
    return curve.degree, exact(curve.knots), exact(curve.homogeneous_points)


def small_curve(seed, ends="clamped"):
    """Without a gap: there the interpolation has no unique solution."""
    rng, degree = np.random.default_rng(seed), 1 + seed % 4
    while True:
        curve = random_curve(rng, seed % 2 == 0, degree=degree, ends=ends, spans=3)
        start, end = curve.domain
        if all((curve.knots == u).sum() <= degree for u in curve.knots if start < u < end):
            return curve, rng


def within(curve, rng):
    start, end = curve.domain
    return start + float(rng.uniform(0.05, 0.95)) * (end - start)


def difference(points, fractions):
    expected = rounded(fractions)
    return np.abs(points - expected).max() / np.abs(expected).max()


def test_fractions_are_a_partition_of_one_and_a_known_curve():
    knots = exact([0, 0, 0, 1, 3, 3, 3])
    assert all(sum(functions(2, knots, Fraction(k, 7))) == 1 for k in range(22))
    parabola = exact([(-1, 1), (0, -1), (1, 1)])
    assert value(2, exact([-1, -1, -1, 1, 1, 1]), parabola, Fraction(1, 3)) == [Fraction(1, 3), Fraction(1, 9)]
    raised, matrix = elevation_matrix(1, exact([0, 0, 1, 1]))
    assert raised == [0, 0, 0, 1, 1, 1] and product(matrix, [[0], [1]]) == [[0], [Fraction(1, 2)], [1]]


@pytest.mark.parametrize("ends", ["clamped", "unclamped"])
@pytest.mark.parametrize("seed", SEEDS)
def test_inserted_points_are_boehms(seed, ends):
    curve, rng = small_curve(seed, ends)
    degree, knots, points = parts(curve)
    u = within(curve, rng)
    for _ in range(degree):
        knots, points = inserted(degree, knots, points, Fraction(u))
    result = curve.insert_knot(u, degree)
    assert exact(result.knots) == knots
    assert difference(result.homogeneous_points, points) <= 1e-15


@pytest.mark.parametrize("seed", SEEDS)
def test_elevated_points_are_those_that_interpolate(seed):
    curve, _ = small_curve(seed)
    degree, knots, points = parts(curve)
    raised, matrix = elevation_matrix(degree, knots)
    result = curve.elevate()
    assert exact(result.knots) == raised
    assert difference(result.homogeneous_points, product(matrix, points)) <= 1e-15


@pytest.mark.parametrize("seed", SEEDS)
def test_removed_points_are_the_nearest(seed):
    curve, rng = small_curve(seed, ENDS[seed % 2])
    u = within(curve, rng)
    times = 1 + seed % curve.degree
    fine = curve.insert_knot(u, times)
    # Moved at random, so that nothing but an approximation is left.
    fine = fine.with_points(fine.points + rng.uniform(-1, 1, fine.points.shape))
    degree, knots, _ = parts(curve)
    points = exact(fine.homogeneous_points)
    matrix = insertion_matrix(degree, knots, Fraction(u), times)
    untouched = {row.index(1): j for j, row in enumerate(matrix) if 1 in row}
    expected = nearest(matrix, points, {i: points[j] for i, j in untouched.items()})
    result = fine.remove_knot(u, times).value
    assert exact(result.knots) == knots
    assert difference(result.homogeneous_points, expected) <= 1e-12
    for i, j in untouched.items():
        assert np.array_equal(result.points[i], fine.points[j]) and result.weights[i] == fine.weights[j]


@pytest.mark.parametrize("seed", SEEDS)
def test_reduced_points_are_the_nearest_with_the_same_ends(seed):
    curve, rng = small_curve(seed)
    degree, knots, _ = parts(curve)
    raised, matrix = elevation_matrix(degree, knots)
    given = sc.NurbsCurve(degree + 1, [float(knot) for knot in raised], rng.uniform(-1, 1, (len(matrix), 3)),
                          rng.uniform(0.5, 2, len(matrix)))
    points = exact(given.homogeneous_points)
    expected = nearest(matrix, points, {0: points[0], len(matrix[0]) - 1: points[-1]})
    result = given.reduce().value
    assert exact(result.knots) == knots
    assert difference(result.homogeneous_points, expected) <= 1e-12
    assert np.array_equal(result.points[[0, -1]], given.points[[0, -1]])


VERBS = {
    "elevate": lambda curve, u: curve.elevate(2), "insert_knot": lambda curve, u: curve.insert_knot(u, curve.degree),
    "refine": lambda curve, u: curve.refine(np.linspace(*curve.domain, 7)[1:-1]),
    "clamped": lambda curve, u: curve.clamped(),
    "remove_knot": lambda curve, u: curve.insert_knot(u).remove_knot(u).value,
    "reduce": lambda curve, u: curve.elevate().reduce().value, "unclamped": lambda curve, u: curve.unclamped(),
}


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("ends", ENDS)
def test_only_the_new_points_are_rounded(verb, ends):
    """Values of both curves in fractions differ by the rounding of control points alone."""
    for seed in range(4):
        curve, rng = small_curve(seed, ends)
        after = VERBS[verb](curve, within(curve, rng))
        start, end = exact(curve.domain)
        size = np.abs(after.homogeneous_points).max()
        for k in range(5):
            u = start + (end - start) * Fraction(2 * k + 1, 11)
            one, other = (rounded([value(*parts(which.unrolled()), u)]) for which in (curve, after))
            assert np.abs(one - other).max() <= 1e-14 * size
