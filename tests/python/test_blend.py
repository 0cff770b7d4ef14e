"""Curves between two ends that go on as the curves do: continuity measured, circles, scales, and bad calls."""

import itertools

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from splinecore import build, conics


def by_length(curve, u, side, order):
    """The unit tangent, the curvature vector and its derivative by the length, from derivatives by the parameter."""
    d = curve.derivatives(u, 3, side=side)
    v = np.linalg.norm(d[1])
    t = d[1] / v
    second = (d[2] - (d[2] @ t) * t) / v**2
    v1 = d[2] @ t
    v2 = (d[2] @ d[2] + d[1] @ d[3] - v1**2) / v
    third = (d[3] / v**3 - 3 * v1 * d[2] / v**4 - (v2 / v**4 - 3 * v1**2 / v**5) * d[1])
    return [t, second, third][:order]


@pytest.mark.parametrize("continuity", [1, 2, 3])
@pytest.mark.parametrize("end_a, end_b", itertools.product(("start", "end"), repeat=2))
def test_the_blend_goes_on_as_both_curves(continuity, end_a, end_b):
    rng = np.random.default_rng(continuity)
    for _ in range(40):
        a, b = (random_curve(rng, degree=int(rng.integers(3, 8)), ends="clamped") for _ in range(2))
        made = build.blend(a, b, continuity, end_a=end_a, end_b=end_b, strengths=rng.uniform(0.3, 3, 2))
        assert made.degree == 2 * continuity + 1
        for curve, end, at, way in ((a, end_a, 0.0, 1 if end_a == "end" else -1), (b, end_b, 1.0, 1 if end_b == "start" else -1)):
            u, side = curve.domain[end == "end"], "left" if end == "end" else "right"
            assert made.evaluate(at) == pytest.approx(curve.evaluate(u, side=side), abs=1e-9)
            size = np.linalg.norm(made.points[0] - made.points[-1])
            for k, (mine, its) in enumerate(zip(by_length(made, at, "right", continuity), by_length(curve, u, side, continuity))):
                assert mine * size**k == pytest.approx(way ** (k + 1) * its * size**k, rel=1e-6, abs=1e-6 * max(1, np.abs(its).max() * size**k))


def test_a_straight_blend():
    a, b = sc.BezierCurve([[0, 0, 0], [1, 0, 0]]), sc.BezierCurve([[3, 1, 0], [4, 1, 0]])
    made = build.blend(a, b, 0)
    assert made.points.tolist() == [[1, 0, 0], [3, 1, 0]]
    along = build.blend(a, sc.BezierCurve([[3, 0, 0], [4, 0, 0]]), 3)
    assert np.abs(along.points[:, 1:]).max() == 0 and np.diff(along.points[:, 0]).min() > 0


def test_a_blend_between_two_arcs_of_a_circle_is_nearly_the_circle():
    """The gap of an eighth of a turn; strengths are the speeds of the circle itself."""
    first = conics.arc_about((0, 0, 0), (1, 0, 0), (0, 1, 0))
    turn = 3 * np.pi / 4
    second = conics.arc_about((0, 0, 0), (np.cos(turn), np.sin(turn), 0), (-1, 0, 0))
    off = []
    for continuity in (1, 2, 3):
        strength = (np.pi / 4) / (2 * np.sin(np.pi / 8))
        made = build.blend(first, second, continuity, strengths=(strength, strength))
        off.append(np.abs(np.linalg.norm(made.evaluate(np.linspace(0, 1, 200)), axis=1) - 1).max())
    assert off[0] < 1e-3 and off[1] < 1e-5 and off[2] < 1e-7


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e150])
def test_blends_scale(scale):
    rng = np.random.default_rng(2)
    a, b = (random_curve(rng, degree=4, ends="clamped") for _ in range(2))
    matrix = np.diag([scale, scale, scale, 1.0])
    near = build.blend(a, b, 3)
    made = build.blend(a.transformed(matrix), b.transformed(matrix), 3)
    assert made.points / scale == pytest.approx(near.points, rel=1e-9, abs=1e-9)


def test_bad_blends():
    a, b = sc.BezierCurve([[0, 0, 0], [1, 0, 0]]), sc.BezierCurve([[3, 1, 0], [4, 1, 0]])
    for continuity in (-1, 4):
        with pytest.raises(sc.InvalidShape, match="continuity is"):
            build.blend(a, b, continuity)
    for strengths in ((0, 1), (1, -1), (np.nan, 1), (1,), (1, 2, 3)):
        with pytest.raises(sc.InvalidShape, match="strength"):
            build.blend(a, b, strengths=strengths)
    with pytest.raises(sc.InvalidShape, match="end_a = 'middle' is none of"):
        build.blend(a, b, end_a="middle")
    with pytest.raises(sc.InvalidShape, match="coincide"):
        build.blend(a, a, end_a="end", end_b="end")
    with pytest.raises(sc.InvalidShape, match="zero derivative"):
        build.blend(sc.BezierCurve([[0, 0, 0], [1, 0, 0], [1, 0, 0]]), b)
    with pytest.raises(sc.InvalidShape, match="b is list, a curve is expected"):
        build.blend(a, [1, 2])
