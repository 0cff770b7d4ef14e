"""How many straight pieces show a span of a curve: by angle, by tolerance, whatever its size and pace."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build

curve_steps = core('verbs.curve_steps')
FOUR = math.radians(4.0)


def turns(curve, count):
    """Between the pieces that are shown, corners of the curve left out."""
    found = []
    for points, closed in curve.polylines(count, 10.0, None):
        ways = np.diff(np.r_[points, points[:2]] if closed else points, axis=0)
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
        found += np.arccos(np.clip((ways[:-1] * ways[1:]).sum(1), -1, 1)).tolist()
    return np.array(found)


@pytest.mark.parametrize('scale', (1e-6, 1.0, 1e6))
def test_circles_turn_by_little_and_lines_are_one_piece(scale):
    circle = sc.conics.circle((0, 0, 0), scale)
    count = curve_steps.steps(circle, FOUR)
    assert 24 <= count <= 32 and turns(circle, count).max() <= 1.05 * FOUR
    assert curve_steps.steps(sc.BezierCurve([(0, 0, 0), (scale, 0, 0)]), FOUR) == 1
    square = build.contour([(0, 0, 0), (scale, 0, 0), (scale, scale, 0)], closed=True)
    assert curve_steps.steps(square, FOUR) == 1
    near = curve_steps.steps(circle, None, 1e-4 * scale)
    assert near == next(n for n in curve_steps._COUNTS if 1 - math.cos(math.pi / 2 / n / 2) <= 1.0001e-4)


def test_more_is_not_taken_than_it_takes_nor_more_than_96():
    rng = np.random.default_rng(3)
    for number in range(300):
        degree = int(rng.integers(2, 6))
        curve = sc.BezierCurve(rng.normal(size=(degree + 1, 3)) * 10.0**rng.uniform(-3, 3), 2.0**rng.uniform(-2, 2, degree + 1))
        count = curve_steps.steps(curve, FOUR)
        assert count in curve_steps._COUNTS
        if count < 96:
            assert turns(curve, count).max() <= 1.7 * FOUR, number
        if 1 < count:
            fewer = curve_steps._COUNTS[curve_steps._COUNTS.index(count) - 1]
            at = np.linspace(0, 1, fewer + 1)
            ways = curve.derivatives(np.linspace(0, 1, 64 * fewer + 1), 1)[:, 1]
            ways /= np.linalg.norm(ways, axis=1, keepdims=True)
            step = np.arccos(np.clip((ways[:-1] * ways[1:]).sum(1), -1, 1)).reshape(fewer, 64).sum(1)
            assert step.max() > 0.98 * FOUR, (number, at)


def test_of_many_spans_there_are_not_too_many_and_of_what_is_endless_it_cannot_be_told():
    rng = np.random.default_rng(4)
    wild = sc.NurbsCurve(3, np.arange(5004.0), rng.normal(size=(5000, 3)))
    assert curve_steps.steps(wild, FOUR) <= 4
    assert curve_steps.steps(sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]), FOUR) is None
    cusp = sc.BezierCurve([(0, 0, 0), (1, 1, 0), (0, 1, 0), (1, 0, 0)])
    assert curve_steps.steps(cusp, FOUR) <= 96
