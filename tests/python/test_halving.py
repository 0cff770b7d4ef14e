"""Polygons halved step by step: against de Casteljau's triangle and the curve itself."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

halving = core("formulas.halving")
FAILURES = core("base.failures")
RNG = np.random.default_rng(3)
CUBIC = sc.BezierCurve([(0, 0, 0), (0, 4, 0), (4, 4, 0), (4, 0, 0)])


def steps_of(curves, *settings):
    """[[points]]: of each step the points of its polygons."""
    found = {}
    for part in halving.halving(curves, *settings):
        found.setdefault(part.name, []).append(part.curve.points)
    return list(found.values())


def test_a_cubic_is_halved_as_in_the_lectures():
    (zero,), (one,), (two,) = steps_of([CUBIC], 0.5, 2, 0.0)
    assert np.array_equal(zero, CUBIC.points)
    assert np.array_equal(one[:, :2], [(0, 0), (0, 2), (1, 3), (2, 3), (3, 3), (4, 2), (4, 0)])
    assert len(two) == 13 and two[6].tolist() == [2, 3, 0]


@pytest.mark.parametrize('ratio', (0.25, 0.5, 0.9))
def test_one_step_at_any_ratio_is_the_border_of_the_triangle(ratio):
    curve = sc.BezierCurve(RNG.uniform(-1, 1, (6, 3)))
    levels = curve.casteljau_triangle(ratio)
    wanted = [*(level[0, :3] for level in levels), *(level[-1, :3] for level in levels[-2::-1])]
    assert np.allclose(steps_of([curve], ratio, 1, 0.0)[1][0], wanted, rtol=0, atol=1e-14)


def distance(curve, points):
    return curve.nearest(points).distances.max()


def random_curve(seed):
    rng = np.random.default_rng(seed)
    degree = int(rng.integers(1, 6))
    inner = np.sort(rng.choice([0.1, 0.5, 0.5, 0.8, 1.0], rng.integers(0, 4)))
    values, copies = np.unique(inner, return_counts=True)
    inner = np.repeat(values, np.minimum(copies, degree))
    knots = np.concatenate([np.full(degree + 1, -1.0), inner, np.full(degree + 1, 2.0)])
    count = len(knots) - degree - 1
    return sc.NurbsCurve(degree, knots, rng.uniform(-1, 1, (count, 3)), rng.uniform(0.2, 3, count))


@pytest.mark.parametrize('seed', range(20))
def test_polygons_come_to_the_curve_by_a_quarter_a_step(seed):
    """Corners that end a Bezier curve lie on it; others within a part of the first polygon's size that falls fourfold."""
    curve = random_curve(seed)
    steps = steps_of([curve], 0.5, 6, 0.0)
    far = [distance(curve, np.concatenate(polygons)) for polygons in steps[3:]]
    assert far[-1] <= max(far[0] / 4**3 * 4.0, 1e-9)
    for step, (points,) in enumerate(steps):
        joints = points[::curve.degree]
        assert len(points) == curve.degree * len(curve.to_bezier()) * 2**step + 1
        assert distance(curve, joints) < 1e-9


def test_steps_stand_beside_each_other_whatever_the_weights():
    curve = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, 0.5, 2])
    over, beside = steps_of([curve], 0.5, 2, 0.0), steps_of([curve], 0.5, 2, 3.0)
    for step in range(3):
        assert np.allclose(beside[step][0] - over[step][0], (3 * step, 0, 0), rtol=0, atol=1e-14)


def test_points_at_infinity_periodic_and_torn_curves():
    arc = sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1])
    assert np.allclose(steps_of([arc], 0.5, 1, 0.0)[1][0], [(1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0), (-1, 0, 0)], rtol=0, atol=1e-15)
    ring = sc.NurbsCurve(3, np.arange(8.0), RNG.uniform(-1, 1, (7, 3)), periodic=True)
    (points,) = steps_of([ring], 0.5, 0, 0.0)[0]
    assert len(points) == 22 and np.allclose(points[0], points[-1], rtol=0, atol=1e-14)
    torn = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (1, 1), (2, 1)])
    assert [len(polygons) for polygons in steps_of([torn], 0.5, 1, 0.0)] == [2, 2]
    assert len(steps_of([CUBIC, arc, ring], 0.5, 1, 0.0)[0]) == 3
    chain = sc.HermiteCurve(RNG.uniform(-1, 1, (4, 3)), RNG.uniform(-1, 1, (4, 3)))
    assert len(steps_of([chain], 0.5, 1, 0.0)[1][0]) == 19


@pytest.mark.parametrize('ratio', (0.0, 1.0))
def test_a_ratio_at_an_end_leaves_one_half_as_a_point(ratio):
    points = steps_of([CUBIC], ratio, 2, 0.0)[2][0]
    assert len(points) == 13 and len(np.unique(points, axis=0)) == 4


def test_too_many_points_are_refused_before_they_are_made():
    with pytest.raises(FAILURES.Refusal, match="step 12 has .* points: 20000 are the most"):
        halving.halving([random_curve(1)] * 9, 0.5, 12, 0.0)
