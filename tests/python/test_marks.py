"""Marks at equal parameters, tangents at corners, derivatives at ends: against closed forms."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

marks, signs, labels, definitions = (core(name) for name in ("formulas.marks", "formulas.signs", "formulas.labels", "shape.definition"))
PARABOLA = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])


def arrows_of(parts):
    """[(label, start, vector)]"""
    assert all(part.name.startswith(signs.ARROW) for part in parts)
    return [("".join(signs.named(part.name)), part.curve.points[0], part.curve.points[1] - part.curve.points[0]) for part in parts]


def places_of(parts):
    return np.array([signs.place_of(part.name, part.curve.points) for part in parts])


def test_marks_stand_at_equal_steps_of_the_parameter():
    parts = marks.steps([PARABOLA], 4, 0.1)
    x = np.linspace(-1, 1, 5)
    assert np.allclose(places_of(parts), np.column_stack([x, x**2, np.zeros(5)]), rtol=0, atol=1e-15)
    assert [part.name for part in parts] == [f"mark u = {u}" for u in ("0", "0.25", "0.5", "0.75", "1")]
    assert all(np.ptp(part.curve.points, axis=0) == pytest.approx([0.2] * 3) for part in parts)
    ring = sc.NurbsCurve(2, np.arange(6.0), np.random.default_rng(1).uniform(-1, 1, (5, 3)), periodic=True)
    assert np.allclose(places_of(marks.steps([ring], 10, 0.1)), ring.evaluate(np.arange(10) / 2), rtol=0, atol=1e-14)
    assert marks.steps([PARABOLA], 0, 0.1) == marks.steps([PARABOLA], 4, 0.0) == []
    assert len(marks.steps([sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [0, 1, 1])], 4, 0.1)) == 4


def test_both_tangents_of_a_corner():
    corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (2, 0), (2, 5)])
    (minus, at, arrives), (plus, _, leaves) = arrows_of(marks.tangents([corner], 0.5))
    assert (minus, plus) == ("T-", "T+") and at.tolist() == [2, 0, 0]
    assert np.allclose(arrives, (0.5, 0, 0), rtol=0, atol=1e-15) and np.allclose(leaves, (0, 0.5, 0), rtol=0, atol=1e-15)


@pytest.mark.parametrize('curves, count', (
    ([PARABOLA], 0), ([sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 0), (3, 3)])], 0),
    ([sc.BezierCurve([(0, 0), (1, 0)]), sc.BezierCurve([(1, 0), (1, 1)]), sc.BezierCurve([(1, 1), (0, 0)])], 3),
    ([sc.NurbsCurve(1, [0, 1, 2, 3, 4], [(0, 0), (1, 0), (1, 1), (0, 1)], periodic=True)], 4),
    ([sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 1), (0, 0)])], 3),
    ([sc.NurbsCurve(2, np.arange(6.0), [(1, 0), (1, 1), (0, 1), (-1, 0), (0, -1)], periodic=True)], 0)))
def test_corners_are_found_where_they_are(curves, count):
    assert len(marks.tangents(curves, 1.0)) == 2 * count


def test_a_tripled_point_has_two_tangents_though_its_derivatives_are_zero():
    """001.78: C2 and G0."""
    p = [(0, 0), (1, 1), (2, 2), (2, 2), (2, 2), (3, 1), (4, 0)]
    (_, at, arrives), (_, _, leaves) = arrows_of(marks.tangents([sc.NurbsCurve(3, np.arange(11.0), p)], 1.0))
    assert np.allclose(at, (2, 2, 0), rtol=0, atol=1e-14)
    assert np.allclose(arrives, np.array([1, 1, 0]) / 2**0.5, atol=1e-9) and np.allclose(leaves, np.array([1, -1, 0]) / 2**0.5, atol=1e-9)
    cusp = sc.BezierCurve([(0, 0), (1, 0), (0, 0)]).to_nurbs().insert_knot(0.5, 2)
    (_, _, arrives), (_, _, leaves) = arrows_of(marks.tangents([cusp], 1.0))[:2]
    assert np.allclose(arrives, (1, 0, 0), atol=1e-9) and np.allclose(leaves, (-1, 0, 0), atol=1e-9)


def test_derivatives_have_their_true_length():
    found, said = marks.derivatives([PARABOLA])
    (first, at, vector), (last, end, arrival) = arrows_of(found)
    assert (first, last, said) == ("R0", "R1", "") and vector.tolist() == [2, -4, 0] and arrival.tolist() == [2, 4, 0]
    assert (at.tolist(), end.tolist()) == ([-1, 1, 0], [1, 1, 0])
    points, tangents = np.random.default_rng(2).uniform(-1, 1, (2, 4, 3))
    chain = arrows_of(marks.derivatives([sc.HermiteCurve(points, tangents, [0, 1, 3, 3.5])])[0])
    assert np.allclose([start for _, start, _ in chain], points, atol=1e-14) and np.allclose([vector for _, _, vector in chain], tangents, rtol=0, atol=1e-12)
    corners = sc.HermiteCurve(points[:3], np.random.default_rng(3).uniform(-1, 1, (3, 2, 3)))
    assert len(marks.derivatives([corners])[0]) == 4
    smooth = sc.NurbsCurve(3, [0] * 4 + [1] + [2] * 4, np.random.default_rng(4).uniform(-1, 1, (5, 3)))
    assert len(marks.derivatives([smooth])[0]) == 2 and len(marks.derivatives([one.with_domain((i, i + 1)) for i, one in enumerate(smooth.split(1.0))])[0]) == 3


def test_derivatives_that_are_zero_or_infinite_are_told_or_left_out():
    found, said = marks.derivatives([sc.BezierCurve([(0, 0), (0, 0), (1, 1), (1, 1)])])
    assert not found and said == "2 derivatives at ends are zero"
    assert len(marks.derivatives([sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [0, 1, 1])])[0]) == 1
    assert marks.tangents([sc.BezierCurve([(1, 1)] * 4)], 1.0) == []


@pytest.mark.parametrize('vector', ((1, 0, 0), (0, 1, 0), (0, 0, 2), (-1, 1e-3, 5), (1e-6, 0, 0)))
def test_the_head_of_an_arrow_is_seen_along_every_axis(vector):
    vector = np.array(vector, float)
    (part,) = signs.arrow("R_{0}", np.ones(3), vector)
    points = part.curve.points
    assert np.allclose(points[[0, 1]], [np.ones(3), 1 + vector], rtol=0, atol=0)
    barbs = points[[2, 4, 6, 8]] - points[1]
    length = np.linalg.norm(vector)
    assert np.allclose(np.linalg.norm(barbs, axis=1), length * (0.15**2 + 0.05**2)**0.5, rtol=1e-8)
    for eye in np.eye(3):
        seen = np.cross(barbs, vector) @ eye
        assert np.abs(seen).max() > 0.01 * length**2 or abs(vector @ eye) > 0.9 * length


def test_marks_and_arrows_have_their_labels():
    parts = marks.steps([PARABOLA], 2, 0.1) + marks.derivatives([PARABOLA])[0]
    definition = definitions.named(definitions.from_value([part.curve for part in parts]), [part.name for part in parts])
    found = [(label.base, label.below, label.after, label.point) for label in labels.of(definition)]
    assert found[1] == ("u", "", " = 0.5", (0.0, 0.0, 0.0)) and found[3] == ("R", "0", "", (1.0, -3.0, 0.0)) and len(found) == 5
