"""What the lectures say of uniform cubic B-splines (row S13)."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import point_lists, random_points

MATRIX = [[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 0, 3, 0], [1, 4, 1, 0]]
TO_BEZIER = [[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]]


def uniform(points):
    """Over [3, n + 1] for points 0 to n: joint k lies at the parameter k."""
    return sc.NurbsCurve(3, np.arange(len(points) + 4.0), points)


def repeated(points, times):
    """The middle one of seven points several times."""
    return np.repeat(points, [1, 1, 1, times, 1, 1, 1], axis=0)


def bends(curve, u):
    """Curvatures before and after a joint, by their definition."""
    _, first, second = np.moveaxis([curve.derivatives(u, 2, side=side) for side in ("left", "right")], 1, 0)
    return np.linalg.norm(np.cross(first, second), axis=1) / np.linalg.norm(first, axis=1) ** 3


def both_sides(curve, u, order):
    return [curve.derivatives(u, order, side=side) for side in ("left", "right")]


@pytest.mark.parametrize("seed", range(20))
def test_a_doubled_point_puts_the_joint_on_a_leg_where_the_curve_is_straight(seed):
    a, p, b = random_points(7, seed=seed)[2:5]
    curve = uniform(repeated(random_points(7, seed=seed), 2))
    for joint, neighbor in ((5.0, a), (6.0, b)):
        left, right = both_sides(curve, joint, 2)
        assert np.abs(left - right).max() <= 1e-13
        assert np.abs(left[0] - (5 * p + neighbor) / 6).max() <= 1e-14
        # Along the leg, and bent in no direction but that.
        assert np.abs(np.cross(left[1:], p - neighbor)).max() <= 1e-13
        assert np.linalg.norm(left[1]) >= 0.4 * np.linalg.norm(p - neighbor)
        assert bends(curve, joint).max() <= 1e-12
        found = curve.continuity(joint)
        assert found.c >= 2 and found.g >= 2
    assert bends(curve, 5.5).min() > 1e-3 and bends(curve, 4.0).min() > 1e-6


@pytest.mark.parametrize("seed", range(20))
def test_a_tripled_point_gives_straight_legs_and_a_corner_that_is_smooth_in_the_parameter(seed):
    points = random_points(7, seed=seed)
    a, p, b = points[2:5]
    curve = uniform(repeated(points, 3))
    # Joint 6 lies in the point; the segments beside it run along the legs, the last sixth of each.
    assert np.abs(curve.evaluate(6.0) - p).max() <= 1e-14
    for start, neighbor in ((5.0, a), (6.0, b)):
        u = np.linspace(start, start + 1, 21)
        off = np.cross(curve.evaluate(u, side="left" if start == 5 else "right") - p, neighbor - p)
        assert np.abs(off).max() <= 1e-13
    assert np.abs(curve.evaluate([5.0, 7.0]) - [(5 * p + a) / 6, (5 * p + b) / 6]).max() <= 1e-14
    left, right = both_sides(curve, 6.0, 3)
    assert np.abs(left[:3] - right[:3]).max() <= 1e-13 and np.abs(left[1:3]).max() <= 1e-13
    assert np.abs(left[3] - (p - a)).max() <= 1e-12 and np.abs(right[3] - (b - p)).max() <= 1e-12
    found = curve.continuity(6.0)
    assert found.c == 2 and found.g == 0


@given(point_lists(5, 12), st.data())
def test_a_joint_lies_in_the_hulls_of_both_its_segments(points, data):
    points = np.array(points)
    joint = data.draw(st.integers(4, len(points) - 1))
    before, after = points[joint - 4:joint], points[joint - 3:joint + 1]
    at = uniform(points).evaluate(float(joint))
    slack = 1e-14 * (1 + np.abs(points).max())
    # A sum of the three points that both share, with the lectures' shares: so it is in either hull.
    assert np.abs(at - (points[joint - 3] + 4 * points[joint - 2] + points[joint - 1]) / 6).max() <= slack
    normal = np.array(data.draw(st.lists(st.floats(-1, 1), min_size=3, max_size=3)))
    for hull in (before, after):
        heights = hull @ normal
        assert heights.min() - 3 * slack <= at @ normal <= heights.max() + 3 * slack


@given(point_lists(4, 4), st.floats(0, 1))
def test_a_segment_lies_in_the_hull_of_its_four_points(points, t):
    functions = sc.basis.KnotVector(3, np.arange(8.0)).functions(3 + t, side="left" if t == 1 else "right")
    assert (functions >= 0).all() and abs(functions.sum() - 1) <= 1e-15
    at = uniform(points).evaluate(3 + t, side="left" if t == 1 else "right")
    assert np.abs(functions @ points - at).max() <= 1e-14 * (1 + np.abs(points).max())


@pytest.mark.parametrize("found, sixths", [(sc.basis.uniform_matrix, MATRIX), (sc.basis.uniform_to_bezier, TO_BEZIER)])
def test_the_matrices_are_the_rationals_of_the_lectures_rounded_once(found, sixths):
    assert found(3).tolist() == [[float(Fraction(value, 6)) for value in row] for row in sixths]


def test_the_rationals_of_the_lectures_are_the_basis_functions():
    """By Cox and de Boor in polynomials of t with fractions, on the knots -3 to 4."""
    functions = [[Fraction(int(i == 3))] for i in range(7)]
    for p in range(1, 4):
        # (t - i) / p of one, (i + p + 1 - t) / p of the next; index 0 is the knot -3.
        functions = [added(times(functions[i], Fraction(3 - i, p), Fraction(1, p)),
                           times(functions[i + 1], Fraction(i + p + 1 - 3, p), Fraction(-1, p)))
                     for i in range(len(functions) - 1)]
    for j, function in enumerate(functions):
        assert [6 * value for value in function[::-1]] == [row[j] for row in MATRIX]
    # Bezier coefficients from powers: b_i = sum C(i, k) / C(3, k) a_k.
    shares = [[1, 0, 0, 0], [1, Fraction(1, 3), 0, 0], [1, Fraction(2, 3), Fraction(1, 3), 0], [1, 1, 1, 1]]
    for i, row in enumerate(shares):
        assert [6 * sum(share * function[k] for k, share in enumerate(row)) for function in functions] == TO_BEZIER[i]


def times(power, constant, slope):
    """A polynomial in t, lowest power first, times constant + slope t."""
    return [constant * low + slope * high for low, high in zip([*power, 0], [0, *power])]


def added(one, other):
    return [a + b for a, b in zip(one, other)]
