"""Control points beside a joint: they make it smooth, and what need not move stays."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SMOOTHNESS = ("C0", "G1", "C1", "G2", "C2")
MOVES = ("second", "first", "both")


def curve(rng, degree, rational, spans=3):
    inner = np.sort(rng.uniform(1, 9, spans - 1))
    knots = np.concatenate([[0.0] * (degree + 1), inner, [10.0] * (degree + 1)])
    points = np.cumsum(rng.uniform(0.3, 1.0, (degree + spans, 3)), axis=0)
    return sc.NurbsCurve(degree, knots, points, rng.uniform(0.7, 1.4, len(points)) if rational else None)


def rows(curve):
    return np.column_stack([curve.points, curve.weights])


def sides(first, second):
    """What joint_points takes of the end of one curve and the start of another."""
    p, q = first.degree, second.degree
    before = first.knots[-1] - first.knots[[-p - 2, max(-p - 3, -len(first.knots))]]
    after = second.knots[[q + 1, min(q + 2, len(second.knots) - 1)]] - second.knots[0]
    return rows(first)[::-1][:3], p, before, rows(second)[:3], q, after


def joined(first, second, *how, **moved):
    """Both curves with the points that joint_points gives."""
    before, after = build.joint_points(*sides(first, second), *how, **moved)
    whole = rows(first), rows(second)
    whole[0][::-1][:3], whole[1][:3] = before, after
    return [sc.NurbsCurve(one.degree, one.knots, points[:, :3], points[:, 3]) for one, points in zip((first, second), whole)]


def meeting(seed, degree, rational):
    rng = np.random.default_rng(seed)
    first, second = curve(rng, degree, rational), curve(rng, degree, rational)
    return first, second.transformed(np.column_stack([np.eye(3), first.points[-1] - second.points[0] + rng.uniform(-0.3, 0.3, 3)]))


@pytest.mark.parametrize("rational", (False, True))
@pytest.mark.parametrize("moves", MOVES)
@pytest.mark.parametrize("continuity", SMOOTHNESS)
@pytest.mark.parametrize("degree", range(2, 8))
def test_one_curve_continues_the_other(degree, continuity, moves, rational):
    for seed in range(3):
        first, second = meeting(seed, degree, rational)
        one, other = joined(first, second, continuity, moves)
        found = one.continuity_to(other)
        assert (found.c if continuity[0] == "C" else found.g) >= int(continuity[1])
        assert moves != "second" or np.array_equal(one.points, first.points)
        assert moves != "first" or np.array_equal(other.points, second.points)
        assert np.array_equal(one.weights, first.weights) and np.array_equal(other.weights, second.weights)


def test_tangents_keep_the_speed_of_each_side():
    first, second = meeting(5, 3, True)
    for moves in MOVES:
        one, other = joined(first, second, "G1", moves)
        speeds = [np.linalg.norm(curve.derivatives(at, 1)[1]) for curve, at in ((first, 10.0), (one, 10.0), (second, 0.0), (other, 0.0))]
        assert np.allclose(speeds[::2], speeds[1::2], rtol=1e-12)


@pytest.mark.parametrize("continuity", SMOOTHNESS)
def test_points_that_need_not_move_stay_to_the_last_digit(continuity):
    first, second = joined(*meeting(1, 4, True), continuity, "both")
    again = joined(first, second, "C0", "both")
    assert all(np.array_equal(one.points, other.points) for one, other in zip((first, second), again))
    one, other = joined(first, second, continuity, "second")
    assert np.array_equal(one.points, first.points) and np.allclose(other.points, second.points, rtol=1e-13, atol=1e-13)


def test_an_end_that_was_moved_takes_the_joint_along():
    first, second = meeting(2, 3, False)
    for moves in MOVES:
        one, other = joined(first, second, "G2", moves, second_moved=[True, False, False])
        assert np.array_equal(one.points[-1], second.points[0]) and np.array_equal(other.points[0], second.points[0])
        one, other = joined(first, second, "G2", moves, first_moved=(True, False, False), second_moved=(False,) * 3)
        assert np.array_equal(one.points[-1], first.points[-1]) and np.array_equal(other.points[0], first.points[-1])


@pytest.mark.parametrize("size, offset", [(1e-150, 0), (1e-9, 0), (1e150, 0), (1, 1e6), (1e-3, -1e3)])
@pytest.mark.parametrize("continuity", SMOOTHNESS)
def test_size_and_place_do_not_matter(continuity, size, offset):
    for seed in range(4):
        given = sides(*meeting(seed, 3, True))
        moved = [np.column_stack([part[:, :3] * size + offset, part[:, 3]]) if np.ndim(part) == 2 else part for part in given]
        for plain, other in zip(build.joint_points(*given, continuity, "both"), build.joint_points(*moved, continuity, "both")):
            rounding = 1e-12 + 1e3 * np.finfo(float).eps * abs(offset) / size
            assert np.abs((other[:, :3] - offset) / size - plain[:, :3]).max() < rounding * 20


def test_a_side_without_a_direction_changes_nothing_else():
    still = np.array([[1.0, 0, 0, 1]] * 3)
    other = np.array([[1.0, 0, 0, 1], [2, 1, 0, 1], [3, 0, 0, 1]])
    for continuity in ("G1", "G2"):
        before, after = build.joint_points(still, 2, (1, 1), other, 2, (1, 1), continuity, "both")
        assert np.array_equal(before, still) and np.array_equal(after, other)


@pytest.mark.parametrize("changed, words", [
    ({"first": [[0, 0, 0, 0], [1, 0, 0, 1], [2, 0, 0, 1]]}, "infinity"),
    ({"first": [[0, 0, 0, 1], [1, 0, 0, 1]]}, "has 2 points"),
    ({"second": [[0, 0, 0, 1]] * 4}, "has 4 points"),
    ({"second": [[0, 0, 0, 1], [1, np.nan, 0, 1], [2, 0, 0, 1]]}, "not finite"),
    ({"second_degree": 1, "continuity": "C2"}, "degree 1, which is too low"),
    ({"first_degree": 0}, "1 or more"),
    ({"first_spans": (0, 1)}, "spans"),
    ({"second_spans": (2, 1)}, "spans"),
    ({"second_moved": [True]}, "1 points"),
    ({"continuity": "G3"}, "continuity"),
    ({"moves": "none"}, "moves"),
])
def test_what_is_wrong_is_said(changed, words):
    points = [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]
    given = {"first": points, "first_degree": 2, "first_spans": (1, 1), "second": points, "second_degree": 2, "second_spans": (1, 1)}
    with pytest.raises(sc.InvalidShape, match=words):
        build.joint_points(**given | changed)


def test_what_leaves_the_numbers_is_refused():
    points = np.array([[0, 0, 0, 1.0], [1, 0, 0, 1], [2, 1, 0, 1]])
    with pytest.raises(sc.InvalidShape, match="range of numbers"):
        build.joint_points(points * [1e300, 1e300, 1e300, 1], 2, (1e-300, 1e-300), points, 2, (1e300, 1e300), "C2")
