"""Two curves as one, with what they share at the joint measured afterwards (row S7)."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, error, random_curve, sampled_distance
from shapes import circle, closed_cubic, cubic, random_points, semicircle

KINDS = {"C0": (0, 0), "G1": (0, 1), "C1": (1, 1), "C2": (2, 2)}


def pairs(seed, count=150, **kind):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield tuple(random_curve(rng, **{"ends": str(rng.choice(["clamped", "unclamped"])), **kind}) for _ in range(2))


def halves(first, second, joined):
    """(before, after) of both parts, on one domain."""
    start, end = first.domain[1], joined.domain[1]
    one, other = joined.split(start)
    return (first, one), (second.with_domain((start, end)), other)


@pytest.mark.parametrize("kind", KINDS)
def test_the_joint_has_the_continuity_that_was_asked_for(kind):
    c, g = KINDS[kind]
    for index, (first, second) in enumerate(pairs(60)):
        if index % 2 == 0:
            first, second = (which.with_weights(np.ones(len(which.weights))) for which in (first, second))
        value, _ = first.join(second, kind)
        found = value.continuity(first.domain[1])
        assert found.c >= c and found.g >= g
        assert value.domain[0] == first.domain[0] and not value.periodic
        assert value.degree == max(first.degree, second.degree, c + 1)
        if not first.is_rational and not second.is_rational:
            assert (value.knots == first.domain[1]).sum() <= value.degree - c


def test_second_derivatives_meet_where_a_curve_has_a_short_span_at_its_end():
    rng = np.random.default_rng(63)
    for _ in range(200):
        steps = np.r_[np.ones(5), rng.uniform(0.5, 1), 10 ** rng.uniform(-3, -1), np.ones(5)]
        first = sc.NurbsCurve(5, np.cumsum(np.r_[0, steps]), rng.uniform(-10, 10, (7, 3)))
        second = sc.NurbsCurve(5, [0] * 6 + [1] * 6, rng.uniform(-10, 10, (6, 3)))
        value, _ = first.join(second, "C2")
        joint = first.domain[1]
        assert value.continuity(joint).c >= 2 and (value.knots == joint).sum() == 3


@pytest.mark.parametrize("kind", KINDS)
def test_the_error_is_how_far_the_curves_moved(kind):
    for first, second in pairs(61, 60):
        value, bound = first.join(second, kind)
        moved = max(sampled_distance(before, after, 400) for before, after in halves(first, second, value))
        slack = 1e-11 * max(np.abs(first.points).max(), np.abs(second.points).max())
        assert moved <= bound + slack and bound <= 1.02 * moved + slack
        assert moved > 0.01


@pytest.mark.parametrize("kind", ["C0", "C1", "C2"])
def test_no_smaller_move_of_the_points_gives_the_same_continuity(kind):
    """Least squares: the moves are across every change of the points that keeps the joint as it is."""
    rng = np.random.default_rng(62)
    for _ in range(40):
        first, second = (random_curve(rng, degree=3, ends="clamped", spans=1).with_weights(np.ones(4))
                         for _ in range(2))
        second = second.with_domain(first.domain).with_domain((first.domain[1], 2 * first.domain[1] - first.domain[0]))
        if kind != "C0":
            speed = np.linalg.norm(first.derivatives(first.domain[1], 1)[1])
            legs = second.points - second.points[0]
            legs *= speed / np.linalg.norm(second.derivatives(second.domain[0], 1)[1])
            second = second.with_points(second.points[0] + legs)
        value, _ = first.join(second, kind)
        parts = value.split(first.domain[1])
        moves = np.r_[parts[0].points - first.points, parts[1].points - second.points]
        conditions = np.zeros((3, 8))
        conditions[0, 3:5] = -1, 1
        conditions[1, 2:6] = 1, -1, -1, 1
        conditions[2, 1:7] = -1, 2, -1, 1, -2, 1
        basis = conditions[:KINDS[kind][0] + 1]
        # The solution of least length, as numpy finds it.
        expected = np.linalg.lstsq(basis, -basis @ np.r_[first.points, second.points], rcond=None)[0]
        assert np.abs(moves - expected).max() <= 1e-11


def test_pieces_of_one_curve_are_that_curve_again():
    rng = np.random.default_rng(63)
    for _ in range(60):
        whole = random_curve(rng, degree=int(rng.integers(3, 8)), ends="clamped", spans=1)
        middle = float(whole.domain[0] + rng.uniform(0.3, 0.7) * (whole.domain[1] - whole.domain[0]))
        for kind in KINDS:
            value, bound = whole.split(middle)[0].join(whole.split(middle)[1], kind)
            size = np.abs(whole.points).max()
            assert bound <= 1e-12 * size
            if kind != "C0":
                assert len(value.points) == len(whole.points)
                assert value.domain == whole.domain or kind != "G1"
                assert value.with_domain(whole.domain).largest_distance(whole) <= 1e-12 * size


def between_knots(rng, curve):
    """A place in the middle part of the domain that leaves no span beside it too short for its derivatives to be known."""
    start, length = curve.domain[0], curve.domain[1] - curve.domain[0]
    while True:
        place = float(start + rng.uniform(0.3, 0.7) * length)
        if np.abs(curve.knots - place).min() >= 1e-3 * length:
            return place


@pytest.mark.parametrize("kind", KINDS)
def test_the_two_parts_of_a_thousand_split_curves_are_the_whole_again(kind):
    """To the same knots: the joint has none but those that were there."""
    rng = np.random.default_rng(64)
    for index in range(1000):
        whole = random_curve(rng, degree=int(rng.integers(KINDS[kind][0] + 1, 10)), ends=ENDS[index % 2])
        middle = between_knots(rng, whole)
        value, bound = whole.split(middle)[0].join(whole.split(middle)[1], kind)
        assert value.domain == whole.domain and bound <= 1e-12 * np.abs(whole.points).max()
        assert error(whole, value) <= 1e-12, index
        assert np.array_equal(value.knots, whole.clamped().knots)


def test_lines_meet_in_the_middle_of_their_ends():
    one = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
    other = sc.NurbsCurve(1, [5, 5, 7, 7], [(1, 2), (2, 2)])
    value, bound = one.join(other)
    assert value.points.tolist() == [[0, 0, 0], [1, 1, 0], [2, 2, 0]] and value.knots.tolist() == [0, 0, 1, 3, 3]
    assert 1 <= bound <= 1.01


def test_aligned_legs_keep_their_lengths_and_point_the_middle_way():
    one = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(-2, 1), (-1, 0), (0, 0)])
    other = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (0, 3), (5, 5)])
    value, _ = one.join(other, "G1")
    diagonal = np.array([1, 1, 0]) / np.sqrt(2)
    assert np.allclose(value.points[[1, 2, 3]], [-diagonal, 0 * diagonal, 3 * diagonal], rtol=0, atol=1e-15)


def test_weights_stay_in_proportion_and_directions_stay_directions():
    value, _ = circle().with_weights(circle().weights * 3).join(circle())
    assert np.allclose(value.weights, 3 * np.r_[circle().weights, circle().weights[1:]])
    half = semicircle().to_nurbs()
    both, bound = half.join(half.transformed(np.diag([-1, -1, 1])))
    assert bound <= 1e-15 and both.weights.tolist() == [1, 0, 1, 0, 1]
    assert np.abs(np.linalg.norm(both.evaluate(np.linspace(0, 2, 33)), axis=1) - 1).max() <= 1e-15


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1e150, 1e300])
def test_joining_does_not_depend_on_the_units(kind, scale):
    first, second = circle(), cubic()
    value, bound = first.join(second, kind)
    large, large_bound = first.with_points(first.points * scale).join(second.with_points(second.points * scale), kind)
    assert np.allclose(large.points / scale, value.points, rtol=1e-12, atol=1e-12)
    assert np.isclose(large_bound / scale, bound, rtol=0.02)
    short = first.with_domain((0, scale)).join(second.with_domain((0, scale)), kind).value
    assert short.continuity(scale).c >= KINDS[kind][0]


def towards_infinity(x, height):
    """A cubic from x to x + 3 whose inner control points are directions."""
    return sc.NurbsCurve.from_homogeneous(3, [0, 0, 0, 0, 1, 1, 1, 1],
                                          [(x, 0, 0, 1), (0, height, 0, 0), (0, height, 0.3, 0), (x + 3, 0, 0, 1)])


def test_directions_that_agree_already_are_joined():
    whole = towards_infinity(0, 1)
    first, second = whole.split(0.4)
    for kind in KINDS:
        value, bound = first.join(second, kind)
        assert bound <= 1e-14 and sampled_distance(value.with_domain((0, 1)), whole) <= 1e-13


REFUSED = [
    (lambda: towards_infinity(0, 1).join(towards_infinity(3.5, -2), "C1"), "too few that can move"),
    (lambda: towards_infinity(0, 1).join(towards_infinity(3.5, -2), "C2"), "too few that can move"),
    (lambda: circle().join(circle(), "C3"), "continuity = 'C3' is not 'C0', 'G1', 'C1' or 'C2'"),
    (lambda: circle().join(circle(), "c1"), "continuity = 'c1'"), (lambda: circle().join(circle(), None), "= None"),
    (lambda: circle().join(circle(), 1), "continuity = 1"), (lambda: circle().join(circle(), ""), "continuity = ''"),
    (lambda: circle().join(closed_cubic()), "a periodic curve has no end to join"),
    (lambda: closed_cubic().join(circle()), "a periodic curve has no end to join"),
    (lambda: circle().join(semicircle().with_weights([0, 1, 1]).to_nurbs()), "an end to join lies at infinity"),
    (lambda: semicircle().with_weights([1, 1, 0]).to_nurbs().join(circle()), "an end to join lies at infinity"),
    (lambda: circle().join(circle().reversed(), "G1"), "leave the joint the same way"),
    (lambda: circle().join(semicircle().to_nurbs(), "G1"), "a point next to the joint lies at infinity"),
    (lambda: circle().join(sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0), (1, 0)]), "G1"), "leaves the joint in no direction"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_what_cannot_be_joined_is_refused(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("bad", [None, 3, "curve", sc.BezierPatch(np.zeros((2, 2, 3))), [circle()]])
def test_what_is_no_curve_is_refused(bad):
    with pytest.raises(sc.InvalidShape, match="a curve is expected"):
        circle().join(bad)


def test_joining_changes_neither_curve():
    points = random_points(8, seed=9)
    one, other = (sc.NurbsCurve(3, [0] * 4 + [1] * 4, half) for half in (points[:4], points[4:]))
    one.join(other, "C2")
    assert np.array_equal(one.points, points[:4]) and np.array_equal(other.points, points[4:])
