"""Verbs that keep the curve, on a thousand curves of every kind, and those that say how far they move it (row S15)."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc
from random_curves import (along, error, homogeneous, homogeneous_at, parameters, random_curve, random_curves,
                           sampled_distance, shares)
from shapes import circle, closed_cubic, cubic

COUNT = 1000


def within(curve, rng):
    start, end = curve.domain
    return start + rng.uniform(0.05, 0.95) * (end - start)


def mirrored(curve):
    start, end = curve.domain
    return lambda u: start + (end - u)


def inserted_and_removed(curve, rng):
    u, times = within(curve, rng), int(rng.integers(1, curve.degree + 1))
    return curve.insert_knot(u, times).remove_knot(u, times).value


def refined_and_cleared(curve, rng):
    return curve.refine([within(curve, rng) for _ in range(3)]).remove_knots(1e-7).value


KEEPING = {
    "insert_knot": lambda curve, rng: curve.insert_knot(within(curve, rng), int(rng.integers(1, curve.degree + 1))),
    "refine": lambda curve, rng: curve.refine([within(curve, rng) for _ in range(5)]),
    "elevate": lambda curve, rng: curve.elevate(int(rng.integers(1, 4))),
    "elevate and reduce": lambda curve, rng: curve.elevate().reduce().value,
    "remove_knot": inserted_and_removed,
    "unrolled": lambda curve, rng: curve.unrolled(),
    "clamped": lambda curve, rng: curve.clamped(),
}


@pytest.mark.parametrize("verb", KEEPING)
def test_verbs_keep_a_thousand_curves(verb):
    degrees = set()
    for index, curve in enumerate(random_curves(20, COUNT)):
        after = KEEPING[verb](curve, np.random.default_rng(index))
        assert after.domain == curve.domain
        assert error(curve, after) <= 1e-12, index
        degrees.add((curve.degree, curve.periodic))
    assert len(degrees) == 18


def test_the_comparison_sees_a_point_that_moved_by_little():
    for curve in random_curves(21, 100):
        points = curve.points.copy()
        points[len(points) // 2] += 1e-6
        assert error(curve, curve.with_points(points)) > 1e-12


def test_reversed_runs_back_over_the_same_domain():
    for curve in random_curves(22, COUNT):
        back = curve.reversed()
        assert back.domain == curve.domain and error(curve, back, mirrored(curve)) <= 1e-12
        assert np.array_equal(back.reversed().points, curve.points)


def test_split_gives_parts_of_the_same_points():
    for index, curve in enumerate(random_curves(23, COUNT)):
        u = within(curve, np.random.default_rng(index))
        parts = curve.split(u)
        assert len(parts) == (1 if curve.periodic else 2) and parts[0].domain[curve.periodic - 1] == u
        for part in parts:
            at = parameters(part)
            far = np.abs(homogeneous(curve, at) - homogeneous(part, at)).max()
            assert far <= 1e-12 * np.abs(curve.homogeneous_points).max(), index


def test_to_bezier_gives_a_curve_for_every_span():
    for index, curve in enumerate(random_curves(19, COUNT)):
        start, end = curve.domain
        knots = np.unique(np.r_[start, curve.knots[(curve.knots > start) & (curve.knots < end)], end])
        parts = curve.to_bezier()
        assert len(parts) == len(knots) - 1 and all(part.degree == curve.degree for part in parts)
        u = parameters(curve).reshape(len(parts), -1)
        for part, first, last, at in zip(parts, knots, knots[1:], u):
            t = [(Fraction(value) - Fraction(first)) / (Fraction(last) - Fraction(first)) for value in at]
            far = np.abs(homogeneous(curve, at) - homogeneous_at(part, t)).max()
            assert far <= 1e-12 * np.abs(curve.homogeneous_points).max(), index


def moebius_error(curve, after, rho):
    """Relative to the largest control point, and to the point at each parameter, which may be far smaller."""
    u, rho = parameters(curve), Fraction(rho)
    moved = along(curve.domain, [x / (rho * (1 - x) + x) for x in shares(curve, u)])
    one, other = homogeneous(curve, u), homogeneous_at(after, moved)
    factor = (one * other).sum(axis=1) / (other * other).sum(axis=1)
    far = np.abs(one - factor[:, None] * other).max(axis=1)
    return far.max() / np.abs(curve.homogeneous_points).max(), (far / np.abs(one).max(axis=1)).max()


def knot_rounding(curve):
    """How far rounding a knot may move a point, as a share of it: by degree over the shortest span."""
    knots = np.unique(np.r_[curve.domain, inner_knots(curve)])
    return curve.degree * np.finfo(float).eps * np.abs(knots).max() / np.diff(knots).min()


def test_moebius_moves_parameters_along_the_same_curve():
    for index, curve in enumerate(random_curves(24, COUNT)):
        rho = 2 ** np.random.default_rng(index).uniform(-2, 2)
        after = curve.moebius(rho)
        far, locally = moebius_error(curve, after, rho)
        assert far <= 1e-12 and locally <= 1e-12 + knot_rounding(curve) + knot_rounding(after), index


def test_the_standard_form_is_a_moebius_map():
    for curve in random_curves(25, COUNT, ends="clamped"):
        # Weights of one sign at the ends are what a standard form asks for.
        curve = curve.with_weights(np.r_[abs(curve.weights[0]), curve.weights[1:-1], abs(curve.weights[-1])])
        after = curve.standard_form()
        rho = (curve.weights[0] / curve.weights[-1]) ** (1 / curve.degree)
        finite = curve.weights != 0
        assert after.weights[0] == after.weights[-1] == 1
        assert np.array_equal(after.points[finite], curve.points[finite])
        far, locally = moebius_error(curve, after, rho)
        assert far <= 1e-12 and locally <= 2e-12


def test_elevation_adds_a_copy_of_every_knot():
    assert circle().elevate().knots.tolist() == sorted([*circle().knots, *range(5)])
    assert cubic().elevate(0) == cubic()
    line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (6, 3)]).elevate(2)
    assert np.abs(line.points - [(0, 0, 0), (2, 1, 0), (4, 2, 0), (6, 3, 0)]).max() <= 1e-15
    assert closed_cubic().elevate().periodic


def test_points_far_from_a_removed_knot_keep_every_bit():
    curve = sc.NurbsCurve(2, range(13), np.random.default_rng(1).normal(size=(10, 3)), np.linspace(0.3, 3, 10))
    result = curve.remove_knot(5).value
    assert np.array_equal(result.points[[0, 1, 2]], curve.points[[0, 1, 2]])
    assert np.array_equal(result.points[5:], curve.points[6:])


def can_all_go(curve, inserted, tolerance):
    """Whether inserted knots can go one after the other: near a pole rounding alone may move points farther."""
    fine = left = curve.refine(inserted)
    for u in inserted:
        left = left.remove_knot(u).value
    return fine.largest_distance(left) <= tolerance


def test_removed_knots_are_those_that_were_inserted():
    could = 0
    for index, curve in enumerate(random_curves(26, 200)):
        after = refined_and_cleared(curve, np.random.default_rng(index))
        rng = np.random.default_rng(index)
        if can_all_go(curve, [within(curve, rng) for _ in range(3)], 1e-7):
            assert len(after.points) <= len(curve.points), index
            could += 1
        if (curve.weights > 0).all():
            assert sampled_distance(curve, after) <= 1e-7 * (1 + 1e-9)
    assert could > 190


@pytest.mark.parametrize("inserted", [[2.9, 1.9, 0.8], [2.1, 0.1, 1.5], [1.3, 0.2, 0.5], [1.6, 2.2, 0.3]])
def test_inserted_knots_go_from_beside_a_weight_that_is_zero_but_for_rounding(inserted):
    """The first knots that go leave a rounding in place of the weight of zero, and its point far away."""
    points = [(4, -1, 2), (1, 1, 1), (-3, 5, 0), (2, 7, -6), (8, -4, 3), (1, 2, 9)]
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], points, [1.5, 0, 1, 3, 0.5, 0.25])
    assert can_all_go(curve, inserted, 1e-9)
    after, error = curve.refine(inserted).remove_knots(1e-9)
    assert len(after.points) == 6 and error <= 1e-9


def inner_knots(curve):
    start, end = curve.domain
    return np.unique(curve.knots[(curve.knots > start) & (curve.knots < end)])


APPROXIMATIONS = {
    "remove_knot": lambda curve: curve.remove_knot(inner_knots(curve)[0]),
    "remove_knots": lambda curve: curve.remove_knots(3.0),
    "reduce": lambda curve: curve.reduce(),
    "reduce by two": lambda curve: curve.reduce(2),
}


@pytest.mark.parametrize("verb", APPROXIMATIONS)
def test_the_error_is_the_largest_distance(verb):
    rng, compared = np.random.default_rng(27), 0
    for _ in range(120):
        curve = random_curve(rng, degree=int(rng.integers(3, 8)), spans=3)
        value, bound = APPROXIMATIONS[verb](curve)
        if not np.isfinite(bound):
            assert value.pieces() != curve.pieces() or not value.weights.all()
            continue
        distance = sampled_distance(curve, value)
        slack = 1e-11 * np.abs(curve.points).max()
        assert distance <= bound + slack and bound <= 1.02 * distance + slack
        compared += distance > 0.01
    assert compared > 30


def test_remove_knots_keeps_its_tolerance_and_goes_as_far_as_it_can():
    for curve in random_curves(28, 60, positive=True):
        value, bound = curve.remove_knots(2.0)
        assert bound <= 2.0 and sampled_distance(curve, value) <= 2.0
        assert curve.remove_knots(0).error == 0
    smooth = sc.NurbsCurve(3, [0] * 4 + [3] * 4, np.eye(4, 3)).refine([1, 1, 2])
    assert len(smooth.remove_knots(1e-12).value.points) == 4


def test_a_tolerance_that_the_error_exceeds_is_not_reached():
    for call in (lambda most: circle().remove_knot(1, tolerance=most), lambda most: circle().reduce(tolerance=most)):
        bound = call(10).error
        assert 0.05 < bound < 1 and call(bound).error == bound
        with pytest.raises(sc.ToleranceNotReached, match=r"cannot be \w+ within 0.01: the error would be 0\.\d+"):
            call(0.01)


def test_the_largest_distance_of_curves_with_a_closed_form():
    flat = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 0), (2, 0)])
    high = flat.with_points([(0, 0), (1, 1), (2, 0)])
    assert 0.5 <= flat.largest_distance(high) <= 0.505
    assert flat.largest_distance(flat) == 0
    assert 2 <= circle().largest_distance(circle().transformed(-np.eye(3))) <= 2.02
    assert 0.5 <= circle().largest_distance(circle().transformed(1.5 * np.eye(3))) <= 0.505
    assert flat.elevate(3).largest_distance(flat.insert_knot(0.3)) <= 1e-15


def test_the_largest_distance_is_infinite_where_one_curve_alone_runs_to_infinity():
    conic = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (0, 1), (-1, 0)], [1, 1, 1])
    for weight in (-1.0, -1.5):
        hyperbola = conic.with_weights([1, weight, 1])
        assert conic.largest_distance(hyperbola) == hyperbola.largest_distance(conic) == np.inf
        assert hyperbola.elevate().largest_distance(hyperbola) <= 1e-12
        assert 1 <= hyperbola.transformed(np.eye(3, 4) + np.eye(3, 4, 3)).largest_distance(hyperbola) <= 1.02
    positive = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], np.eye(4, 3), [4, 0.01, 0.01, 1])
    assert positive.remove_knot(1).error == np.inf
    with pytest.raises(sc.ToleranceNotReached, match="would be inf"):
        positive.remove_knot(1, tolerance=1e300)
    assert positive.remove_knots(1e300).value == positive


def test_the_largest_distance_is_symmetric_and_keeps_the_triangle_inequality():
    for curve in random_curves(29, 60, positive=True):
        rng = np.random.default_rng(len(curve.points))
        one, other = (curve.with_points(curve.points + rng.uniform(-1, 1, curve.points.shape)) for _ in range(2))
        there, back = one.largest_distance(other), other.largest_distance(one)
        assert abs(there - back) <= 0.011 * there
        assert there <= 1.02 * (one.largest_distance(curve) + curve.largest_distance(other))


def test_a_thousand_knots_are_removed():
    rng = np.random.default_rng(3)
    knots = np.r_[[0] * 3, range(998), [997] * 3]
    wild = sc.NurbsCurve(3, knots, rng.normal(size=(1000, 3)))
    tame = sc.NurbsCurve(3, [0] * 4 + [997] * 4, rng.normal(size=(4, 3)), [1, 2, 1, 1]).refine(np.arange(1, 997))
    assert len(tame.remove_knots(1e-9).value.points) == 4
    assert len(wild.remove_knots(1e-9).value.points) == 1000
