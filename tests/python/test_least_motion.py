"""Equations of a joint tell what may move, and the least motion meets them."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_joint_points import SMOOTHNESS, joined, meeting, rows, sides


def strips(first, second):
    """What joint_equations takes of the same."""
    before, p, spans, after, q, beyond = sides(first, second)
    return before[:, None], p, spans, after[:, None], q, beyond


def with_one_weight(first, second):
    """The same curves, with equal weights where they meet."""
    return first, sc.NurbsCurve(second.degree, second.knots, second.points, second.weights * (first.weights[-1] / second.weights[0]))


@pytest.mark.parametrize("rational", (False, True))
@pytest.mark.parametrize("continuity", SMOOTHNESS[1:])
@pytest.mark.parametrize("degree", range(2, 6))
def test_motions_that_meet_the_equations_keep_the_continuity(degree, continuity, rational):
    for seed in range(3):
        first, second = joined(*with_one_weight(*meeting(seed, degree, rational)), continuity, "both")
        factors = build.joint_equations(*strips(first, second), continuity)
        assert factors.shape == (int(continuity[1]), 1, 6)
        rng = np.random.default_rng(seed)
        wanted = rng.uniform(-0.05, 0.05, (6, 3))
        wanted[3] = wanted[0]
        together = np.vstack([factors[:, 0], [1.0, 0, 0, -1, 0, 0]])
        motion = wanted - np.linalg.pinv(together) @ (together @ wanted)
        points = [rows(first), rows(second)]
        points[0][::-1][:3, :3] += motion[:3]
        points[1][:3, :3] += motion[3:]
        one, other = (sc.NurbsCurve(degree, curve.knots, part[:, :3], part[:, 3]) for curve, part in zip((first, second), points))
        found = one.continuity_to(other, tolerance=1e-7)
        assert (found.c if continuity[0] == "C" else found.g) >= int(continuity[1])


@pytest.mark.parametrize("factor", (2.0, 0.1, -1.0, -3.0))
@pytest.mark.parametrize("continuity", ("G1", "G2"))
def test_geometric_continuity_knows_no_common_factor_of_weights(continuity, factor):
    """All weights of a curve times a number are the same curve."""
    whole = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 2.5, 1), (4, 0, 0)], [1, 2, 0.5, 3]).to_nurbs()
    first, second = whole.split(0.4)
    other = sc.NurbsCurve(3, second.knots, second.points, factor * second.weights)
    found, same = (build.joint_equations(*strips(first, each), continuity) for each in (other, second))
    for one, two in zip(found[:, 0], same[:, 0]):
        assert np.allclose(one / np.abs(one).max(), factor / abs(factor) * two / np.abs(two).max(), rtol=0, atol=1e-9)


def test_there_are_none_where_it_does_not_hold():
    first, second = meeting(0, 3, True)
    for continuity in SMOOTHNESS[1:]:
        assert build.joint_equations(*strips(first, second), continuity) is None
    assert build.joint_equations(*strips(first, second), "C0").shape == (0, 1, 6)
    assert build.joint_equations(*strips(*joined(first, second, "C1")), "C1") is None  # their weights differ there
    before, *rest = strips(first, second)
    before[0, 0, 3] = 0.0
    assert build.joint_equations(before, *rest, "C0") is None


def some_equations(rng, points, count):
    """(n, 6) numbers of points in columns, (2, n, 6) factors."""
    columns = np.stack([rng.choice(points, 6, replace=False) for _ in range(count)])
    return columns, rng.normal(size=(2, count, 6)) * 10.0 ** rng.uniform(-3, 3, (2, count, 1))


def matrix_of(equations, points):
    matrix = []
    for columns, factors in equations:
        for one in factors:
            for column, row in zip(columns, one):
                line = np.zeros(points)
                np.add.at(line, column, row / np.linalg.norm(row))
                matrix.append(line)
    return np.array(matrix)


@pytest.mark.parametrize("size", (1e-150, 1.0, 1e150))
@pytest.mark.parametrize("seed", range(40))
def test_it_is_the_shortest_of_all_that_meet_the_equations(seed, size):
    rng = np.random.default_rng(seed)
    points = int(rng.integers(12, 80))
    equations = [some_equations(rng, points, int(rng.integers(1, 6))) for _ in range(int(rng.integers(1, 4)))]
    is_free = rng.random(points) < 0.8
    moved = np.where(rng.random((points, 1)) < 0.3, rng.normal(size=(points, 3)), 0.0)
    matrix = matrix_of(equations, points)
    known = np.linalg.lstsq(matrix[:, is_free], -matrix @ moved, rcond=1e-10)[0]
    is_met = np.abs(matrix[:, is_free] @ known + matrix @ moved).max() < 1e-10
    found = build.least_motion(equations, moved * size, is_free)
    if not is_met:
        assert found is None
        return
    assert not found[~is_free].any()
    assert np.abs(found[is_free] / size - known).max() <= 1e-8 * max(1.0, np.abs(known).max())


def test_equations_that_depend_on_others_are_no_harm():
    rng = np.random.default_rng(3)
    columns, factors = some_equations(rng, 20, 4)
    moved, is_free = np.zeros((20, 3)), np.ones(20, bool)
    moved[columns[0, 0]] = 1.0
    is_free[columns[0, 0]] = False
    once, twice = (build.least_motion([(columns, factors)] * count, moved, is_free) for count in (1, 2))
    assert np.allclose(once, twice, rtol=1e-10, atol=1e-12)


def test_what_is_met_does_not_move():
    apart = np.array([[0, 1, 2], [3, 4, 5]]), np.ones((1, 2, 3))
    moved = np.zeros((6, 3))
    moved[0], moved[1] = (1, 0, 0), (-1, 0, 0)
    assert not build.least_motion([apart], moved, [True] * 6).any()
    moved[1] = 0.0
    motion = build.least_motion([apart], moved, [False] + [True] * 5)
    assert np.allclose(motion[1:3], (-0.5, 0, 0)) and not motion[[0, 3, 4, 5]].any()
    assert build.least_motion([apart], moved, [False] * 3 + [True] * 3) is None
    assert build.least_motion([], moved, [True] * 6).shape == (6, 3)


def test_a_long_seam_takes_little_time():
    count = 20_000
    columns = np.arange(6 * count).reshape(count, 6)
    moved = np.zeros((6 * count, 3))
    moved[::6] = 1.0
    is_free = np.arange(6 * count) % 6 > 0
    motion = build.least_motion([(columns, np.ones((1, count, 6)))], moved, is_free)
    assert np.allclose(motion[is_free], -0.2)


@pytest.mark.parametrize("changed, kind, words", [
    ({"equations": [([[0, 9]], [[[1, 1]]])]}, sc.InvalidShape, "no point 9"),
    ({"equations": [([[0, -1]], [[[1, 1]]])]}, sc.InvalidShape, "no point -1"),
    ({"equations": [([[0.5, 1]], [[[1, 1]]])]}, TypeError, "integers"),
    ({"equations": [([[0, 1]], [[[0, 0]]])]}, sc.InvalidShape, "all zero"),
    ({"equations": [([[0, 1]], [[1, 1]])]}, sc.InvalidShape, "shape"),
    ({"free": [1, 0]}, TypeError, "bool"),
    ({"free": [True]}, sc.InvalidShape, "1 values for 2 points"),
    ({"moved": [[np.inf, 0, 0], [0, 0, 0]]}, sc.InvalidShape, "not finite"),
])
def test_what_is_wrong_is_said(changed, kind, words):
    given = {"equations": [([[0, 1]], [[[1, 1]]])], "moved": np.zeros((2, 3)), "free": [True, True]}
    with pytest.raises(kind, match=words):
        build.least_motion(**given | changed)
