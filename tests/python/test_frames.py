"""Frames along curves: the differential equation, the integral of torsion, closed curves, corners, and errors."""

import math

import numpy as np
import pytest
from scipy import integrate

import random_curves
import shapes
import splinecore as sc


def turned_by(curve, places, start):
    """Normals at increasing places by integrating N' = -(N · T') T: the definition, with none of the steps."""
    def slope(u, normal):
        _, first, second = curve.derivatives(u, 2)
        speed = np.linalg.norm(first)
        tangent = first / speed
        bend = (second - (second @ tangent) * tangent) / speed
        return -(normal @ bend) * tangent

    knots = [u for u in np.unique(curve.knots) if curve.domain[0] < u < curve.domain[1]]
    found, normal, before = [], np.array(start), curve.domain[0]
    for u in sorted({*knots, *places}):
        if u > before:
            inner = (before, np.nextafter(u, before))
            normal = integrate.solve_ivp(slope, inner, normal, "DOP853", rtol=1e-12, atol=1e-12,
                                         first_step=1e-3 * (inner[1] - inner[0])).y[:, -1]
        before = u
        if u in places:
            found.append(normal)
    return np.array(found)


def smooth_curves(seed, count):
    """Of every kind, with simple knots: they have no corner; and no place where they nearly stand still."""
    rng = np.random.default_rng(seed)
    while count:
        degree = int(rng.integers(2, 8))
        ends = random_curves.ENDS[count % 3]
        spans = int(rng.integers(1, 6))
        inner = np.arange(1.0, spans)
        if ends == "periodic":
            knots = np.arange(spans + degree + 1.0)
        elif ends == "clamped":
            knots = np.r_[[0.0] * (degree + 1), inner, [float(spans)] * (degree + 1)]
        else:
            knots = np.arange(spans + 2.0 * degree + 1)
        total = len(knots) - 1 if ends == "periodic" else len(knots) - degree - 1
        points = np.cumsum(rng.normal((1, 0, 0), 0.7, (total, 3)), axis=0)
        curve = sc.NurbsCurve(degree, knots, points, rng.uniform(0.5, 2, total), periodic=ends == "periodic")
        u = np.linspace(*curve.domain, 400)
        speeds = np.linalg.norm(curve.derivatives(u, 1)[:, 1], axis=1)
        if speeds.min() > 0.05 * speeds.max():
            count -= 1
            yield curve


def is_frame(frames):
    return np.abs(frames @ np.swapaxes(frames, -1, -2) - np.eye(3)).max() < 1e-14 and (np.linalg.det(frames) > 0).all()


def test_normals_turn_as_the_differential_equation_says():
    for curve in smooth_curves(1, 12):
        places = np.linspace(*curve.domain, 6)[1:-1]
        start = curve.frames(curve.domain[0])
        frames = curve.frames(places)
        assert is_frame(frames)
        expected = turned_by(curve, list(places), start[1])
        assert np.abs(frames[:, 1] - expected).max() < 3e-10, curve


def test_against_frenet_s_frame_they_turn_by_the_torsion():
    """Along (t, t², t³) and along helices, to 1e-9 after six turns."""
    nodes, shares = np.polynomial.legendre.leggauss(40)
    cubic = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], domain=(-1, 2))
    t = np.linspace(0, 12 * math.pi, 400)
    helix = sc.fit.interpolate(np.stack([np.cos(t), np.sin(t), 0.3 * t], -1), 5).value
    for curve in (cubic, helix):
        knots = np.unique(curve.to_nurbs().knots if isinstance(curve, sc.PowerCurve) else curve.knots)
        half = np.diff(knots)[:, None] / 2
        u = knots[:-1, None] + half * (1 + nodes)
        speeds = np.linalg.norm(curve.derivatives(u, 1)[..., 1, :], axis=-1)
        angle = (half * shares * speeds * curve.torsion(u)).sum()
        end = curve.domain[1]
        (_, normal, _), frenet = curve.frames(end), curve.frenet_frame(end)
        found = math.atan2(normal @ frenet[2], normal @ frenet[1])
        assert abs(math.remainder(found + angle, 2 * math.pi)) < 1e-9


def test_what_else_is_asked_for_changes_no_bit():
    for curve in [*smooth_curves(3, 6), shapes.circle(), shapes.hermite_chain()]:
        u = np.random.default_rng(4).uniform(*curve.domain, (5, 7))
        all_of_them = curve.frames(u)
        assert all_of_them.shape == (5, 7, 3, 3)
        for place in ((0, 0), (2, 5), (4, 6)):
            assert (curve.frames(u[place]) == all_of_them[place]).all()
        assert (curve.frames(u, cancel=lambda: False)[::-1] == curve.frames(u[::-1])).all()


def test_plane_curves_keep_their_binormal_and_lines_their_frame():
    rng = np.random.default_rng(5)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    for seed in range(8):
        flat = np.cumsum(np.c_[rng.normal((1, 0), 0.8, (9, 2)), np.zeros(9)], axis=0) @ turn.T
        curve = sc.NurbsCurve(3, range(13), flat)
        frames = curve.frames(np.linspace(*curve.domain, 50), start=turn[:, 2])
        assert np.abs(np.abs(frames[:, 1] @ turn[:, 2]) - 1).max() < 1e-12
    line = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), (1, 2, 2), (2, 4, 4)], [1, 3, 1])
    frames = line.frames([0, 0.3, 1])
    assert np.abs(frames - frames[0]).max() < 1e-15 and np.abs(frames[0, 0] - np.array([1, 2, 2]) / 3).max() < 1e-15
    assert np.abs(line.frames(0.7, start=(0, 0, 5))[1] - np.array([-2, -4, 5]) / math.sqrt(45)).max() < 1e-15


def test_at_corners_and_cusps_they_turn_as_little_as_they_can():
    polyline = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)])
    frames = polyline.frames([0.5, 1, 1.5, 2.5], start=(0, 0, 1))
    assert np.abs(frames[:, 1] - [(0, 0, 1), (0, 0, 1), (0, 0, 1), (0, -1, 0)]).max() < 1e-15
    arriving = polyline.frames([1, 2, 3], start=(0, 0, 1), side="left")
    assert np.abs(arriving[:, 0] - np.eye(3)).max() < 1e-15
    assert np.abs(arriving[:, 1] - [(0, 0, 1), (0, 0, 1), (0, -1, 0)]).max() < 1e-15
    cusp = sc.PowerCurve([(0, 0, 0), (0, 0, 0), (1, 0, 0), (0, 1, 0)], domain=(-1, 1))
    frames = cusp.frames(np.linspace(-1, 1, 9), start=(0, 0, 1))
    assert is_frame(frames) and np.abs(frames[:, 1] - (0, 0, 1)).max() < 1e-12
    stop = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 0), (1, 3)])
    assert is_frame(stop.frames([0, 1, 1.5, 2, 2.5]))
    assert stop.frames(1.5)[0].tolist() == [1, 0, 0]


def test_closed_curves_are_closed_evenly_by_length():
    for curve in (c for c in smooth_curves(6, 30) if c.periodic):
        start, end = curve.domain
        u = np.linspace(start, end, 12)[1:-1]
        opened, closed = (curve.frames(u, closed=word) for word in (False, True))
        assert is_frame(closed) and (closed[:, 0] == opened[:, 0]).all()
        first = curve.frames(start, closed=True)
        assert np.abs(curve.frames(end, closed=True, side="left") - first).max() < 1e-9
        assert (first == curve.frames(start)).all()
        twist = np.arctan2((closed[:, 1] * opened[:, 2]).sum(1), (closed[:, 1] * opened[:, 1]).sum(1))
        last = curve.frames(end, side="left")
        whole = math.atan2(first[1] @ last[2], first[1] @ last[1])
        parts = np.array([curve.length(start, x) for x in u]) / curve.length()
        assert np.abs(twist - whole * parts).max() < 1e-9


@pytest.mark.parametrize("size", [1e-150, 1e-30, 1e30, 1e150])
def test_sizes_domains_and_weights_change_no_frame(size):
    points = np.random.default_rng(7).normal(size=(7, 3))
    knots = np.r_[[0.0] * 4, 0.25, 0.5, 0.5, [1.0] * 4]
    weights = np.linspace(0.5, 2, 7)
    u = np.linspace(0, 1, 9)
    frames = sc.NurbsCurve(3, knots, points, weights).frames(u)
    assert np.abs(sc.NurbsCurve(3, knots, points * size, -weights * 7).frames(u) - frames).max() < 1e-12
    assert np.abs(sc.NurbsCurve(3, knots * size, points, weights).frames(u * size) - frames).max() < 1e-12
    far = sc.NurbsCurve(3, 1e7 + knots, np.round(points * 2**20) / 2**20 + 2.0**24, weights).frames(1e7 + u)
    assert np.abs(far - frames).max() < 1e-5


def test_every_kind_of_curve_and_of_frame():
    for curve in shapes.curves():
        u = shapes.inside(curve.domain, 7)
        assert is_frame(curve.frames(u))
        assert (curve.frames(u, "frenet") == curve.frenet_frame(u)).all()
        assert np.abs(curve.frames(u)[:, 0] - curve.frenet_frame(u)[:, 0]).max() < 1e-12
    for curve in random_curves.random_curves(8, 60, positive=True):
        if len(curve.points) > 1:
            assert is_frame(curve.frames(shapes.inside(curve.domain, 5)))


LINE = sc.BezierCurve([(0, 0), (1, 0), (3, 0)])


@pytest.mark.parametrize("call, error, message", [
    (lambda: LINE.frames([0, 0.5], "frenet"), sc.InvalidShape, "the curve is straight or has a zero derivative at u[0] = 0"),
    (lambda: LINE.frames(0, "frenets"), sc.InvalidShape, "kind = 'frenets' is none of 'frenet', 'rotation_minimizing'"),
    (lambda: LINE.frames(0, 3), TypeError, "kind must be a str"),
    (lambda: LINE.frames([[0, 2]]), sc.InvalidShape, "u[0, 1] = 2 is outside the domain"),
    (lambda: LINE.frames(math.nan), sc.InvalidShape, "u = nan"),
    (lambda: LINE.frames(0, start=(2, 0, 0)), sc.InvalidShape, "start has no part at right angles"),
    (lambda: LINE.frames(0, start=(0, 0, 0)), sc.InvalidShape, "start has no part at right angles"),
    (lambda: LINE.frames(0, start=(0, 0, math.inf)), sc.InvalidShape, "start"),
    (lambda: LINE.frames(0, "frenet", start=(0, 0, 1)), sc.InvalidShape, "Frenet frames have no start"),
    (lambda: LINE.frames(0, closed=True), sc.InvalidShape, "the curve is not closed"),
    (lambda: LINE.frames(0, closed=1), TypeError, "closed"),
    (lambda: sc.NurbsCurve(1, [0, 1, 2, 3], [(0, 0), (1, 0), (0, 1)], periodic=True).frames(0, closed=True),
     sc.InvalidShape, "the curve has a corner where it closes"),
    (lambda: sc.BezierCurve([(1, 2)] * 3).frames(0), sc.InvalidShape, "the curve is a point"),
    (lambda: shapes.hyperbola().frames(0.1), sc.PointAtInfinity, ""),
])
def test_bad_arguments_are_named(call, error, message):
    with pytest.raises(error) as caught:
        call()
    assert str(caught.value).startswith(message)


def test_a_curve_that_turns_without_end_is_refused():
    rng = np.random.default_rng(5)
    for _ in range(4):
        curve = sc.NurbsCurve(9, range(20), rng.normal(size=(10, 3)), 10.0 ** rng.uniform(-12, 12, 10))
        try:
            assert np.isfinite(curve.frames(curve.domain)).all()
        except sc.ToleranceNotReached as error:
            assert "carried" in str(error)
