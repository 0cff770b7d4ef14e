"""Places by arc length: closed forms, the length up to what was found, parts that are equal, and errors in words."""

import math

import numpy as np
import pytest
from scipy import special

import random_curves
import shapes
import splinecore as sc
from test_lengths import arms, dense, random_curves as curves_of_degrees

LINE = sc.NurbsCurve(1, [0, 0, 1, 3, 3], [(0, 0), (1, 0), (5, 0)])


def ellipse(a, b):
    return sc.NurbsCurve(2, shapes.CIRCLE_KNOTS, np.array(shapes.SQUARE) * (a, b), shapes.SQUARE_WEIGHTS)


def pieces_of(seed, count):
    """Curves of every kind that stay finite and are no single point."""
    return [curve for curve in random_curves.random_curves(seed, count, positive=True) if len(curve.points) > 1]


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
@pytest.mark.parametrize("center", [0.0, 1e3])
def test_equal_parts_of_a_circle_are_equal_angles(size, center):
    curve = sc.NurbsCurve(2, shapes.CIRCLE_KNOTS, size * (np.array(shapes.SQUARE) + center), shapes.SQUARE_WEIGHTS)
    for count in (1, 2, 7, 1000):
        u = curve.divide(count)
        assert u.shape == (count,) and u[0] == 0
        x, y = (curve.evaluate(u)[:, :2] / size - center).T
        angles = np.unwrap(np.arctan2(y, x))
        assert np.abs(angles - 2 * math.pi * np.arange(count) / count).max() < 1e-12 * max(1, center)


def test_the_perimeter_of_an_ellipse_is_the_elliptic_integral():
    for a, b in ((2, 1), (5, 4.5), (100, 1)):
        curve = ellipse(a, b)
        m = 1 - (b / a) ** 2
        assert abs(curve.length() / (4 * a * special.ellipe(m)) - 1) < 1e-13
        angles = np.linspace(0.01, 1.56, 40)  # from the end of the long axis on
        lengths = a * (special.ellipe(m) - special.ellipeinc(math.pi / 2 - angles, m))
        found = curve.evaluate(curve.parameter_at_length(lengths))
        expected = np.stack([a * np.cos(angles), b * np.sin(angles)], -1)
        assert np.abs(found[:, :2] - expected).max() < 1e-10 * curve.length()


def test_lengths_up_to_what_was_found_are_those_that_were_asked_for():
    rng = np.random.default_rng(4)
    for curve in [*pieces_of(1, 60), *curves_of_degrees(rng)]:
        whole = curve.length()
        lengths = whole * rng.random((3, 2))
        found = curve.parameter_at_length(lengths)
        assert found.shape == (3, 2)
        for s, u in zip(lengths.ravel(), found.ravel()):
            step = np.spacing(u) * np.linalg.norm(curve.derivatives(u, 1)[1])  # between two parameters that there are
            assert abs(curve.length(end=u) - s) <= 1e-10 * whole + step, (curve, s, u)


def test_what_else_is_asked_for_changes_no_bit():
    rng = np.random.default_rng(5)
    for curve in pieces_of(2, 20):
        lengths = curve.length() * rng.random(30)
        found = curve.parameter_at_length(lengths)
        assert [curve.parameter_at_length(s) for s in lengths[::7]] == list(found[::7])
        assert (np.argsort(found, kind="stable") == np.argsort(lengths, kind="stable")).all()


def test_parts_have_equal_lengths():
    for curve in pieces_of(3, 60):
        u = curve.divide(9)
        is_closed = len(u) == 9
        assert not curve.periodic or is_closed or len(curve.pieces()) > 1
        ends = [*u, curve.domain[1]] if is_closed else u
        assert ends[0] == curve.domain[0] and ends[-1] == curve.domain[1]
        parts = [curve.length(a, b) for a, b in zip(ends[:-1], ends[1:])]
        assert np.ptp(parts) <= 2e-10 * curve.length()


def test_steps_go_as_far_as_the_length():
    assert LINE.divide_by_length(2).tolist() == pytest.approx([0, 1.5, 2.5])
    assert LINE.divide_by_length(2.5).tolist() == pytest.approx([0, 1.75, 3.0])
    assert LINE.divide_by_length(6).tolist() == [0]
    ring = shapes.circle()
    assert len(ring.divide_by_length(ring.length() / 12)) == 12
    assert len(ring.divide_by_length(0.9 * ring.length() / 12)) == 14


@pytest.mark.parametrize("size", [1e-120, 1.0, 1e120])
def test_cusps_are_passed(size):
    """(t², t³) stops at t = 0, here inside the domain, at a knot, and at the start."""
    def branch(start, end):
        power = sc.PowerCurve(size * np.array([(0, 0, 0), (0, 0, 0), (1, 0, 0), (0, 1, 0)]), domain=(start, end))
        return power.to_nurbs()

    for start, end in ((-1, 1), (-0.3, 1), (0, 1)):
        curve = branch(start, end)
        t = np.array([0.001, 0.01, 0.1, 0.5, 0.9])
        before = arms(-start) if start else 0.0
        found = curve.parameter_at_length(size * np.array([before + arms(x) for x in t]))
        assert np.abs([arms(u) - arms(x) for u, x in zip(found, t)]).max() <= 1e-10
        assert np.abs(found - t).max() < 1e-6


def test_where_the_curve_stands_still_it_is_the_first_parameter():
    curve = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 0), (3, 0)])
    assert curve.parameter_at_length([0, 0.5, 1, 2, 3]) == pytest.approx([0, 0.5, 1, 2.5, 3], abs=1e-15)
    gap = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (9, 0), (9, 2)])
    assert gap.parameter_at_length([1, 1 + 2e-9, 2]) == pytest.approx([1, 1, 1.5], abs=2e-9)


def test_periodic_curves_go_on():
    ring = shapes.closed_cubic()
    start, end = ring.domain
    whole, period = ring.length(), end - start
    lengths = whole * np.array([0.25, 1.25, -0.75, 7.25, -3.75])
    found = ring.parameter_at_length(lengths)
    assert found - found[0] == pytest.approx(period * np.array([0, 1, -1, 7, -4]), abs=1e-9)
    assert ring.length(start, found[3]) == pytest.approx(lengths[3], rel=1e-10)


def test_every_kind_of_curve_has_them():
    for curve in shapes.curves():
        nurbs = curve if isinstance(curve, sc.NurbsCurve) else curve.to_nurbs()
        assert (curve.divide(5) == nurbs.divide(5)).all()
        assert (curve.divide_by_length(0.3) == nurbs.divide_by_length(0.3)).all()
        assert curve.parameter_at_length(0.2) == nurbs.parameter_at_length(0.2)
        assert dense(nurbs) == pytest.approx(curve.length(), rel=1e-11)


def test_many_places_on_many_spans():
    count = 20_000
    points = np.cumsum(np.random.default_rng(6).normal(size=(count, 3)), axis=0)
    curve = sc.NurbsCurve(3, range(count + 4), points)
    u = curve.divide(count)
    picked = np.linspace(0, count, 50).astype(int)
    whole = curve.length()
    for i in picked:
        assert abs(curve.length(end=u[i]) / whole - i / count) < 1e-10


@pytest.mark.parametrize("call, message", [
    (lambda: LINE.parameter_at_length(-1), "s = -1 is outside [0, "),
    (lambda: LINE.parameter_at_length([[1, 2], [3, 5.001]]), "s[3] = 5.001 is outside [0, "),
    (lambda: LINE.parameter_at_length([1, math.nan]), "s[1] = nan is not finite"),
    (lambda: LINE.parameter_at_length(1, tolerance=0), "tolerance = 0 is not a positive number"),
    (lambda: LINE.parameter_at_length(1, tolerance=math.nan), "tolerance = nan"),
    (lambda: LINE.divide(0), "count = 0 is outside [1, 4194304]"),
    (lambda: LINE.divide(5_000_000), "count = 5000000 is outside"),
    (lambda: LINE.divide_by_length(0), "step = 0 is not a positive length"),
    (lambda: LINE.divide_by_length(1e-9), "step = 1e-09 makes more than 2^22 parts of the length "),
    (lambda: sc.BezierCurve([(1, 1)] * 4).divide(3), "the curve has no length"),
    (lambda: sc.NurbsCurve(1, [0, 1, 2], [(1, 1)] * 2, periodic=True).parameter_at_length(1),
     "the curve has no length"),
])
def test_bad_arguments_are_named(call, message):
    with pytest.raises(sc.InvalidShape) as caught:
        call()
    assert str(caught.value).startswith(message)


def test_bad_kinds_and_curves_to_infinity():
    for call in (lambda: LINE.parameter_at_length("a"), lambda: LINE.divide(2.5), lambda: LINE.divide(3, cancel=1)):
        with pytest.raises(TypeError):
            call()
    for call in (lambda: shapes.hyperbola().divide(3), lambda: shapes.hyperbola().parameter_at_length(1)):
        with pytest.raises(sc.PointAtInfinity):
            call()
    with pytest.raises(sc.Cancelled):
        sc.NurbsCurve(3, range(100_004), np.random.default_rng(1).normal(size=(100_000, 3))).divide(
            9, cancel=lambda: True)
    assert LINE.parameter_at_length([]).shape == (0,)
