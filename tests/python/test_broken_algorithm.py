"""The sentence for where the rational algorithm breaks."""

import pytest

import splinecore as sc
from addon_core import core

teaching = core("formulas.teaching")


@pytest.mark.parametrize('points, weights, u, said', (
    ([(0, 0), (1, 1), (2, 0)], [1, 0, 1], 0.5, "level 0, point 2: it is a direction, of weight 0"),
    ([(0, 0), (1, 1), (2, 0)], [1, -1, 1], 0.5, "level 1, point 1: the weights 0.5 and -0.5 cancel"),
    ([(1e308, 0), (1e308, 0), (-1.7e308, 0)], None, -3.0, "level 1, point 1: it is too large for a number")))
def test_a_break_is_told_with_points_counted_once(points, weights, u, said):
    curve = sc.BezierCurve(points) if weights is None else sc.BezierCurve(points, weights)
    rows, broken = curve.rational_casteljau_triangle(u)
    assert teaching.broken_text(broken) == "the rational algorithm breaks at " + said
