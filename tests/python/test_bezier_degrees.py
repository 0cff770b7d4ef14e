"""Elevation, reduction and flattening of Bezier curves (row S6)."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import HALF, hyperbola, point_lists, positive, random_points, semicircle


def test_elevation_has_the_lectures_points():
    curve = sc.BezierCurve([(0, 0), (3, 6), (9, 0)]).elevate()
    assert np.abs(curve.points[:, :2] - [(0, 0), (2, 4), (5, 4), (9, 0)]).max() <= 1e-15 and curve.degree == 3


@given(point_lists(2, 8), st.integers(1, 6), st.data())
def test_elevation_keeps_the_curve(points, times, data):
    curve = sc.BezierCurve(points, data.draw(st.lists(positive, min_size=len(points), max_size=len(points))))
    higher = curve.elevate(times)
    assert higher.degree == curve.degree + times
    assert np.array_equal(higher.points[[0, -1]], curve.points[[0, -1]])
    u = np.linspace(0, 1, 11)
    assert np.abs(higher.evaluate(u) - curve.evaluate(u)).max() <= 1e-12 * (np.abs(curve.points).max() + 1e-300)


@given(point_lists(2, 10))
def test_elevation_is_the_exact_one_rounded(points):
    rows = [[Fraction(x) for x in p] for p in points]
    n = len(rows)
    exact = [[Fraction(i, n) * (rows[i - 1][axis] if i else 0) + (1 - Fraction(i, n)) * (rows[i][axis] if i < n else 0)
              for axis in range(3)] for i in range(n + 1)]
    size = np.abs(points).max() + 1e-300
    values = np.array([[float(x) for x in p] for p in exact])
    assert np.abs(sc.BezierCurve(points).elevate().points - values).max() <= 4e-16 * size


@given(point_lists(2, 9), st.integers(1, 4))
def test_reduction_undoes_elevation(points, times):
    curve = sc.BezierCurve(points)
    lower, error = curve.elevate(times).reduce(times, tolerance=1e-9 * (np.abs(points).max() + 1))
    assert np.abs(lower.points - curve.points).max() <= 1e-10 * (np.abs(points).max() + 1e-300)
    assert lower.degree == curve.degree and error <= 1e-10 * (np.abs(points).max() + 1e-300)


@given(point_lists(3, 9))
def test_reduction_by_one_is_as_far_as_it_says_and_levels_its_error(points):
    curve = sc.BezierCurve(points)
    result = curve.reduce()
    u = np.linspace(0, 1, 4001)
    distance = np.linalg.norm(curve.evaluate(u) - result.value.evaluate(u), axis=1)
    size = np.abs(points).max() + 1e-300
    assert distance.max() <= result.error * (1 + 1e-9) + 1e-13 * size
    assert distance.max() >= result.error * (1 - 1e-3) - 1e-13 * size
    peaks = (distance[1:-1] >= distance[:-2]) & (distance[1:-1] >= distance[2:]) & (distance[1:-1] > 0.99 * result.error)
    if result.error > 1e-9 * size:
        assert peaks.sum() >= curve.degree - 1


def exact_reduction(points):
    """Minus the leading coefficient times the polynomial of least maximum on [0, 1] that vanishes at its ends, of
    degree 3: t (t - 1/2) (t - 1). In fractions, as monomials; the result's Bernstein points."""
    p = [[Fraction(x) for x in row] for row in points]
    columns = []
    for axis in range(3):
        a, b, c, d = (row[axis] for row in p)
        power = [a, 3 * (b - a), 3 * (a - 2 * b + c), d - 3 * c + 3 * b - a]
        lead = power[3]
        power = [power[0], power[1] - lead / 2, power[2] + lead * Fraction(3, 2)]
        columns.append([power[0], power[0] + power[1] / 2, sum(power)])
    return np.array(columns, dtype=float).T


@given(point_lists(4, 4))
def test_reduction_of_a_cubic_is_the_exact_one(points):
    lower = sc.BezierCurve(points).reduce().value
    assert np.abs(lower.points - exact_reduction(points)).max() <= 1e-14 * (np.abs(points).max() + 1e-300)


@given(point_lists(3, 8), st.integers(1, 6), st.data())
def test_reduction_of_rational_curves_keeps_its_bound(points, times, data):
    weights = data.draw(st.lists(st.floats(0.9, 1.1), min_size=len(points), max_size=len(points)))
    curve = sc.BezierCurve(points, weights)
    try:
        lower, error = curve.reduce(min(times, curve.degree - 1))
    except sc.InvalidShape as reason:
        assert "after a step" in str(reason)
        return
    u = np.linspace(0, 1, 101)
    distance = np.linalg.norm(curve.evaluate(u) - lower.evaluate(u), axis=1).max()
    assert distance <= error * (1 + 1e-9) + 1e-11 * np.abs(points).max()


def test_reduction_beyond_the_tolerance_is_refused_with_its_error():
    curve = sc.BezierCurve([(0, 0), (0.5, 0), (1, 1)])
    assert abs(curve.reduce().error - 0.25) <= 1e-15 and curve.reduce(tolerance=0.3).value.degree == 1
    with pytest.raises(sc.ToleranceNotReached, match="within 0.2: the error would be 0.2"):
        curve.reduce(tolerance=0.2)
    assert isinstance(curve.reduce(), sc.Approximation) and repr(curve.reduce()).startswith("Approximation(value=Bez")
    assert list(curve.reduce())[0].degree == 1 and len(list(curve.reduce().__iter__())) == 2


def distances_to(points, line):
    starts, ways = line[:-1], np.diff(line, axis=0)
    lengths = np.maximum((ways**2).sum(1), 1e-300)
    shares = np.clip(((points[:, None] - starts) * ways).sum(2) / lengths, 0, 1)
    return np.linalg.norm(points[:, None] - starts - shares[..., None] * ways, axis=2).min(1)


@given(point_lists(2, 7), st.floats(1e-3, 1), st.data())
def test_flattening_keeps_its_tolerance(points, relative, data):
    curve = sc.BezierCurve(points, data.draw(st.lists(positive, min_size=len(points), max_size=len(points))))
    size = np.abs(points).max() + 1e-300
    parameters, line = curve.flatten(relative * size)
    assert parameters[0] == 0 and parameters[-1] == 1 and (np.diff(parameters) > 0).all()
    assert line.shape == (len(parameters), 3)
    assert np.abs(curve.evaluate(parameters) - line).max() <= 1e-13 * size
    far = distances_to(curve.evaluate(np.linspace(0, 1, 200)), line)
    assert far.max() <= relative * size * (1 + 1e-9)


def test_flattening_halves_as_the_lectures_do():
    parameters, line = sc.BezierCurve([(0, 0), (0, 4), (4, 4), (4, 0)]).flatten(2.9)
    assert parameters.tolist() == [0, 0.5, 1] and line[1].tolist() == [2, 3, 0]
    arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, HALF, 1])
    counts = [len(arc.flatten(10.0**-k)[0]) for k in range(1, 9)]
    assert counts == sorted(counts) and counts[0] == 5 and counts[-1] <= 20_000


def test_flattening_a_semicircle_is_finite_and_a_hyperbola_refused():
    assert np.abs(np.linalg.norm(semicircle().flatten(0.01)[1], axis=1) - 1).max() <= 1e-15
    with pytest.raises(sc.PointAtInfinity, match="0.27"):
        hyperbola().flatten(0.01)
    with pytest.raises(sc.PointAtInfinity, match="u = 1"):
        sc.BezierCurve([(1, 0), (0, 1)], [1, 0]).flatten(0.01)


CURVE = sc.BezierCurve(random_points(4, seed=41))


@pytest.mark.parametrize("call, words", [
    (lambda: CURVE.elevate(-1), "times = -1"),
    (lambda: CURVE.elevate(253), "times = 253"), (lambda: CURVE.elevate(10**30), "times = 10{30}"),
    (lambda: CURVE.reduce(0), "times = 0"), (lambda: CURVE.reduce(3), "times = 3"),
    (lambda: sc.BezierCurve([(0, 0), (1, 1)]).reduce(), "degree = 1"),
    (lambda: CURVE.reduce(1, -1.0), "tolerance = -1"), (lambda: CURVE.reduce(1, float("nan")), "tolerance = nan"),
    (lambda: semicircle().reduce(), r"weights\[1\] = 0"), (lambda: CURVE.flatten(0), "tolerance = 0"),
    (lambda: CURVE.flatten(-1), "tolerance = -1"), (lambda: CURVE.flatten(float("inf")), "tolerance = inf"),
    (lambda: CURVE.flatten(1e-300), "262144 points"),
])
def test_bad_numbers_are_named(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call, words", [
    (lambda: CURVE.elevate(1.0), "times"), (lambda: CURVE.elevate(None), "times"), (lambda: CURVE.reduce("1"), "times"),
    (lambda: CURVE.reduce(1, "a"), "tolerance"), (lambda: CURVE.flatten(None), "tolerance"), (lambda: CURVE.flatten(), ""),
])
def test_what_is_of_another_type_raises_type_error(call, words):
    with pytest.raises(TypeError, match=words):
        call()
