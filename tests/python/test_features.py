"""Signed curvature, inflections and extrema: closed forms, and dense signs of random curves of every kind."""

import math

import numpy as np
import pytest

import random_curves
import shapes
import splinecore as sc

CUBIC = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 0, 0), (0, 1, 0)], domain=(-1, 2))  # (t, t³)


def flat_curves(seed, count, **kind):
    for curve in random_curves.random_curves(seed, count, **kind):
        yield curve.with_points(curve.points * (1, 1, 0))


def dense(curve, per_span=400):
    """Parameters of every span, none at its ends."""
    knots = np.unique(np.r_[curve.domain, [u for u in curve.knots if curve.domain[0] < u < curve.domain[1]]])
    parts = (np.arange(per_span) + 0.5) / per_span
    return (knots[:-1, None] + np.diff(knots)[:, None] * parts).ravel(), knots


def test_signed_curvature_of_conics():
    u = np.linspace(0, 4, 33)[:-1]
    ring = shapes.circle()
    assert ring.signed_curvature(u) == pytest.approx(np.ones(32), rel=1e-12)
    assert ring.reversed().signed_curvature(u) == pytest.approx(-np.ones(32), rel=1e-12)
    assert ring.signed_curvature(u, (0, 0, -1e200)) == pytest.approx(-np.ones(32), rel=1e-12)
    ellipse = ring.with_points(np.array(ring.points) * (3, 2, 1))
    x, y = ellipse.evaluate(u)[:, :2].T
    expected = 1 / (36 * (x**2 / 81 + y**2 / 16) ** 1.5)
    assert ellipse.signed_curvature(u) == pytest.approx(expected, rel=1e-12)
    t = np.array([-1, -0.3, 0, 0.1, 2])
    assert CUBIC.signed_curvature(t) == pytest.approx(6 * t / (1 + 9 * t**4) ** 1.5, rel=1e-12, abs=1e-15)
    assert (np.abs(CUBIC.signed_curvature(t)) == CUBIC.curvature(t)).all()


@pytest.mark.parametrize('start, end', [(-1, 1), (-0.5, 2), (0, 5), (3, 3.5)])
def test_curvature_of_arcs_of_a_parabola(start, end):
    """Of y = x²: 2 / (1 + 4 x²)^(3/2)."""
    arc = sc.conics.conic_arc((start, start**2), ((start + end) / 2, start * end), (end, end**2), 1.0)
    u = np.linspace(0, 1, 33)
    x = arc.evaluate(u)[:, 0]
    assert x == pytest.approx(start + (end - start) * u, abs=1e-14)
    assert arc.signed_curvature(u) == pytest.approx(2 / (1 + 4 * x**2) ** 1.5, rel=1e-12)
    assert arc.curvature(u) == pytest.approx(2 / (1 + 4 * x**2) ** 1.5, rel=1e-12)
    assert arc.reversed().signed_curvature(u[::-1]) == pytest.approx(-2 / (1 + 4 * x**2) ** 1.5, rel=1e-12)


@pytest.mark.parametrize('a, b', [(1, 1), (3, 0.5), (0.2, 4)])
@pytest.mark.parametrize('half', [0.3, 1.0, 3.0])
def test_curvature_of_arcs_of_a_hyperbola(a, b, half):
    """Of x²/a² - y²/b² = 1, upwards on the right branch: it turns to the right."""
    end = np.array([a * np.cosh(half), b * np.sinh(half)])
    arc = sc.conics.conic_arc(end * (1, -1), (a / np.cosh(half), 0), end, np.cosh(half))
    u = np.linspace(0, 1, 33)
    x, y = arc.evaluate(u)[:, :2].T
    assert (x / a)**2 - (y / b)**2 == pytest.approx(np.ones(33), rel=1e-11)
    wanted = 1 / (a**2 * b**2 * (x**2 / a**4 + y**2 / b**4) ** 1.5)
    assert arc.curvature(u) == pytest.approx(wanted, rel=1e-11)
    assert arc.signed_curvature(u) == pytest.approx(-wanted, rel=1e-11)


def test_the_normal_is_that_of_the_plane_towards_z():
    rng = np.random.default_rng(1)
    for _ in range(20):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        turn *= np.sign(np.linalg.det(turn))
        flat = np.c_[rng.normal(size=(6, 2)), np.zeros(6)]
        curve = sc.NurbsCurve(3, range(10), flat)
        moved = sc.NurbsCurve(3, range(10), flat @ turn.T + 1e3)
        u = np.linspace(*curve.domain, 7)
        sign = math.copysign(1, turn[2, 2])
        assert moved.signed_curvature(u) == pytest.approx(sign * curve.signed_curvature(u), rel=1e-6, abs=1e-6)
        assert moved.inflections() == pytest.approx(curve.inflections(), abs=1e-7)
    upright = sc.BezierCurve([(0, 0, 0), (1, 0, 0), (1, 0, 1)])
    assert upright.signed_curvature(0.5) < 0  # seen from +y the xz plane is turned
    assert sc.BezierCurve([(0, 0, 0), (1, 2, 3), (2, 4, 6)]).signed_curvature(0.5) == 0


def test_inflections_in_closed_form():
    assert CUBIC.inflections() == pytest.approx([0], abs=2e-16)
    wave = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0), (0, -1, 0)], domain=(-1, 1))  # t² - t⁴
    assert wave.inflections() == pytest.approx([-math.sqrt(1 / 6), math.sqrt(1 / 6)], abs=1e-15)
    flat = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 0, 0), (0, 0, 0), (0, 1, 0)], domain=(-1, 1))  # t⁴ touches only
    assert flat.inflections().tolist() == []
    assert shapes.circle().inflections().tolist() == shapes.hyperbola().inflections().tolist() == []
    arcs = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (3, -1), (4, 0)])
    assert arcs.inflections().tolist() == [1]
    straight = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 3, 3, 4, 4, 4],
                             [(0, 1), (0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (4, -1)])
    assert straight.inflections().tolist() == [2]
    corner = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 1), (2, 0), (3, 0), (3, 1)])
    assert corner.signed_curvature([0.5, 1.5]).tolist() != [0, 0] and corner.inflections().tolist() == []
    helix = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], domain=(-1, 1))
    assert helix.inflections((0, 1, 0)) == pytest.approx([0], abs=1e-15)
    assert helix.inflections((0, 0, 1)).tolist() == []


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_signs_between_inflections_are_those_of_the_curvature(size):
    compared = 0
    for curve in flat_curves(2, 150, positive=True):
        curve = curve.with_points(curve.points * size)
        u, knots = dense(curve, 100)
        kappa = curve.signed_curvature(u, (0, 0, 1)) * size
        is_sure = np.abs(kappa) > 1e-5 * np.abs(kappa).max()
        found = curve.inflections((0, 0, 1))
        assert (np.diff(found) > 0).all()
        if curve.degree == 1 or len(curve.points) < 3:
            assert not len(found)
            continue
        for a, b in zip(knots[:-1], knots[1:]):
            inside = found[(found > a) & (found < b)]
            here = (u > a) & (u < b) & is_sure
            turns = np.searchsorted(inside, u[here])
            signs = np.sign(kappa[here])
            if len(signs):
                assert (signs == signs[0] * (-1.0) ** (turns - turns[0])).all(), (curve, inside)
                compared += len(inside)
    assert compared > 100


def test_extrema_in_closed_form():
    assert shapes.circle().extrema((1, 0, 0)).tolist() == [0, 2, 4]
    assert shapes.circle().extrema((1, 1, 0)) == pytest.approx([0, 0.5, 2.5, 4], abs=1e-15)
    ring = shapes.circle().to_periodic()
    ring = getattr(ring, "value", ring)
    assert ring.extrema((0, 1, 0)) == pytest.approx([1, 3], abs=1e-15)
    assert CUBIC.extrema((0, 1, 0)) == pytest.approx([-1, 0, 2], abs=2e-16)  # at rest, though it goes on up
    roof = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 2), (2, 3), (3, 0)])
    assert roof.extrema((0, 1, 0)).tolist() == [0, 2, 3]
    table = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 1), (2, 1), (3, 0)])
    assert table.extrema((0, 1e-200, 0)).tolist() == [0, 1, 2, 3]
    gap = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (5, 0), (6, 0)])
    assert gap.extrema((1, 0, 0)).tolist() == [0, 1, 2]


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_between_extrema_the_curve_goes_one_way(size):
    rng = np.random.default_rng(3)
    for curve in random_curves.random_curves(4, 150, positive=True):
        curve = curve.with_points(curve.points * size)
        way = rng.normal(size=3)
        found = curve.extrema(way)
        u, knots = dense(curve, 60)
        heights = curve.evaluate(u) @ way / size
        for a, b in zip(knots[:-1], knots[1:]):
            inside = [a, *found[(found > a) & (found < b)], b]
            for start, end in zip(inside[:-1], inside[1:]):
                steps = np.diff(heights[(u > start) & (u < end)])
                assert (steps > -1e-12).all() or (steps < 1e-12).all(), (curve, found)


SPACE = sc.BezierCurve([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)])


@pytest.mark.parametrize("call, error, message", [
    (lambda: SPACE.inflections(), sc.InvalidShape, "the curve lies in no plane: points["),
    (lambda: SPACE.signed_curvature(0.5), sc.InvalidShape, "the curve lies in no plane"),
    (lambda: SPACE.inflections((0, 0, 0)), sc.InvalidShape, "direction is not a direction: it is zero or not finite"),
    (lambda: SPACE.extrema((0, 0, 0)), sc.InvalidShape, "direction is not a direction"),
    (lambda: SPACE.extrema((0, 0, math.nan)), sc.InvalidShape, "direction"),
    (lambda: SPACE.extrema((0, 0, 0, 1)), sc.InvalidShape, "direction"),
    (lambda: SPACE.extrema(None), TypeError, "direction"),
    (lambda: SPACE.signed_curvature(0.5, (0, 0, 0)), sc.InvalidShape, "normal is not a direction"),
    (lambda: SPACE.signed_curvature(2, (0, 0, 1)), sc.InvalidShape, "u = 2 is outside the domain"),
    (lambda: shapes.hyperbola().extrema((1, 0, 0)), sc.PointAtInfinity, ""),
])
def test_bad_arguments_are_named(call, error, message):
    with pytest.raises(error) as caught:
        call()
    assert str(caught.value).startswith(message)
