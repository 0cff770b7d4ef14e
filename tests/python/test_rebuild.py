"""Rebuilt and faired curves and patches: what can be exact is; errors are those of dense samples."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, conics

from test_interpolate import walk

RNG = np.random.default_rng(77)


def curve_of(degree, count, periodic=False, rational=False, unclamped=False, scale=1.0, offset=0.0):
    points = scale * (walk(count) + offset)
    if periodic:
        knots = np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, count))])
    elif unclamped:
        knots = np.cumsum(RNG.uniform(0.5, 1.5, count + degree + 1))
    else:
        inner = np.sort(RNG.uniform(0, 1, count - degree - 1))
        knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    weights = RNG.uniform(0.5, 2, count) if rational else None
    return sc.NurbsCurve(degree, knots, points, weights, periodic=periodic)


def farthest(a, b, count=5000):
    start, end = a.domain
    u = np.clip(np.linspace(start, end, count), start, end)
    return np.linalg.norm(a.evaluate(u) - b.evaluate(u), axis=1).max()


KINDS = [dict(), dict(periodic=True), dict(rational=True), dict(unclamped=True), dict(periodic=True, rational=True)]


@pytest.mark.parametrize('kind', KINDS)
@pytest.mark.parametrize('degree', [1, 2, 3, 5, 9])
@pytest.mark.parametrize('scale', [1.0, 1e-150, 1e150])
def test_the_error_is_the_largest_distance(kind, degree, scale):
    curve = curve_of(4, 15, scale=scale, **kind)
    made, error = curve.rebuild(20, degree)
    seen = farthest(curve, made)
    assert seen <= error * (1 + 1e-12) and error <= 1.02 * seen
    assert (made.degree, len(made.points), made.periodic) == (degree, 20, curve.periodic)
    assert made.domain == curve.domain and not made.is_rational
    assert np.ptp(np.diff(np.unique(made.knots))) < 1e-9 * (made.domain[1] - made.domain[0])


@pytest.mark.parametrize('degree', range(1, 10))
@pytest.mark.parametrize('offset', [0.0, 1e7])
def test_a_curve_on_even_knots_comes_back(degree, offset):
    even = np.concatenate([np.zeros(degree), np.linspace(0, 1, 9), np.ones(degree)])
    curve = sc.NurbsCurve(degree, even, walk(degree + 8) + offset)
    made, error = curve.rebuild(degree + 8)
    size = np.abs(curve.points).max()
    np.testing.assert_allclose(made.points, curve.points, rtol=0, atol=1e-11 * size)
    assert error < 1e-13 * size


def test_down_to_one_span():
    curve = curve_of(3, 12)
    made, error = curve.rebuild(6, 5)
    assert len(made.points) == 6 and len(np.unique(made.knots)) == 2
    np.testing.assert_allclose(made.points[[0, -1]], curve.points[[0, -1]], rtol=1e-15)
    assert error == pytest.approx(farthest(curve, made), rel=0.02)


def test_tangents_stay_where_asked():
    curve = curve_of(3, 12, rational=True)
    made = curve.rebuild(9, 4, ends='tangents').value
    for u, side in zip(curve.domain, ('right', 'left')):
        wanted, found = (each.derivatives(u, 1, side=side)[:2] for each in (curve, made))
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize('kind', KINDS)
@pytest.mark.parametrize('part', [1e-2, 1e-4, 1e-6])
def test_a_tolerance_is_kept_with_few_points(kind, part):
    curve = curve_of(3, 12, **kind)
    tolerance = part * np.ptp(curve.points)
    made, error = curve.rebuild(degree=5, tolerance=tolerance)
    assert error <= tolerance and farthest(curve, made) <= tolerance
    least = len(made.points) - 1
    if least > 6:
        assert curve.rebuild(least, 5).error > tolerance


@pytest.mark.parametrize('kind, degree, least', [(dict(), 1, 2), (dict(), 3, 4), (dict(periodic=True), 1, 3),
                                                 (dict(periodic=True), 3, 3), (dict(periodic=True), 5, 5)])
def test_a_wide_tolerance_takes_as_few_points_as_the_degree_needs(kind, degree, least):
    curve = curve_of(degree, 12, **kind)
    assert len(curve.rebuild(degree=degree, tolerance=100 * np.ptp(curve.points)).value.points) == least


def test_every_kind_of_curve_is_rebuilt():
    ellipse = conics.ellipse((0, 0), (2, 0), (0, 1))
    for curve in (ellipse, sc.BezierCurve(walk(6)), sc.HermiteCurve(walk(2), walk(2))):
        made, error = curve.rebuild(tolerance=1e-6, degree=3)
        assert error <= 1e-6 and isinstance(made, sc.NurbsCurve)


def test_curves_that_cannot_be_rebuilt():
    curve = curve_of(3, 12)
    for arguments, message in ((dict(), "count or tolerance is needed"), (dict(count=3), "^count = 3 control points are fewer than the 4"),
                               (dict(count=3, tolerance=100), "^count = 3 control points are fewer than the 4 that degree 3 needs$"),
                               (dict(count=3, degree=2, ends='tangents'), "^3 control points are fewer than the 4 that the ends"),
                               (dict(count=3, degree=2, ends='tangents', tolerance=100), "^3 control points are fewer than the 4"),
                               (dict(tolerance=1, degree=0), "^degree = 0"),
                               (dict(count=0), "count = 0"), (dict(count=9, degree=0), "degree = 0"),
                               (dict(tolerance=0.0), "tolerance = 0"), (dict(tolerance=np.nan), "tolerance = nan"),
                               (dict(count=9, ends='x'), "none of")):
        with pytest.raises(sc.InvalidShape, match=message):
            curve.rebuild(**arguments)
    closed = curve_of(3, 12, periodic=True)
    for arguments in (dict(), dict(tolerance=100)):
        with pytest.raises(sc.InvalidShape, match="^count = 2 control points are fewer than the 3 that degree 3 needs$"):
            closed.rebuild(2, **arguments)
    with pytest.raises(sc.ToleranceNotReached, match="with 8 control points.*the error would be"):
        curve.rebuild(8, tolerance=1e-9)
    infinite = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [[0, 0], [1, 0], [2, 1]], [1, 0, -1])
    with pytest.raises((sc.PointAtInfinity, sc.InvalidShape)):
        infinite.rebuild(5)


def energy(curve):
    u = np.linspace(*curve.domain, 20001)
    return np.mean(np.sum(curve.derivatives(np.clip(u, *curve.domain), 2)[..., 2, :]**2, -1))


@pytest.mark.parametrize('kind', KINDS)
@pytest.mark.parametrize('degree', [2, 3, 5])
@pytest.mark.parametrize('scale', [1.0, 1e-140, 1e140])
def test_fair_curves_bend_less_within_the_tolerance(kind, degree, scale):
    curve = curve_of(degree, 20, scale=scale, **kind)
    last = np.inf
    for part in (1e-4, 1e-3, 1e-2):
        tolerance = part * np.ptp(curve.points)
        made, error = curve.fair(tolerance)
        assert error <= tolerance and farthest(curve, made) <= tolerance * (1 + 1e-12)
        assert error > 0.5 * tolerance                        # it is used
        np.testing.assert_array_equal(made.knots, curve.knots)
        np.testing.assert_array_equal(made.weights, curve.weights)
        if not kind.get('rational'):
            bent = energy(made.transformed(np.eye(3) / scale))
            assert bent < last
            last = bent
        if not curve.periodic:
            ends = np.array(curve.domain)
            np.testing.assert_allclose(made.evaluate(ends), curve.evaluate(ends), rtol=0, atol=1e-13 * np.abs(curve.points).max())
    if not kind.get('rational'):
        assert last < energy(curve.transformed(np.eye(3) / scale))


def test_noise_goes_and_a_straight_line_stays():
    knots = np.concatenate([np.zeros(3), np.linspace(0, 1, 58), np.ones(3)])
    t = (knots[1:-3] + knots[2:-2] + knots[3:-1]) / 3
    smooth = np.stack([t, np.sin(3 * t), 0 * t], -1)
    noisy = sc.NurbsCurve(3, knots, smooth + 1e-3 * RNG.standard_normal((60, 3)))
    made = noisy.fair(6e-3).value
    assert energy(made) < 0.5 * energy(noisy)
    line = sc.NurbsCurve(3, knots, np.outer(t, [1, 2, 3]))
    straight, error = line.fair(1.0)
    wanted = np.linspace(0, 1, 500)
    assert np.linalg.matrix_rank(straight.evaluate(wanted) - straight.evaluate(0.0), tol=1e-9) == 1 and error < 1.0


def test_tangents_of_fair_curves_stay_where_asked():
    curve = curve_of(3, 15)
    made = curve.fair(0.2, ends='tangents').value
    np.testing.assert_array_equal(made.points[[0, 1, -2, -1]], curve.points[[0, 1, -2, -1]])


@pytest.mark.parametrize('exponent', [-990, 990])
def test_fair_curves_are_the_same_in_every_size(exponent):
    curve = curve_of(3, 20)
    near = curve.fair(0.05).value
    far = curve.with_points(np.ldexp(curve.points, exponent)).fair(np.ldexp(0.05, exponent)).value
    np.testing.assert_allclose(np.ldexp(far.points, -exponent), near.points, rtol=0, atol=1e-12)


def test_curves_that_cannot_be_faired():
    curve = curve_of(3, 9)
    with pytest.raises(sc.InvalidShape, match="degree is too high"):
        sc.BezierCurve(walk(256)).fair(0.1)
    for tolerance in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            curve.fair(tolerance)
    with pytest.raises(sc.InvalidShape, match="degree 1"):
        curve_of(1, 5).fair(0.1)
    with pytest.raises(sc.InvalidShape, match="infinity"):
        sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [[0, 0], [1, 0], [2, 1]], [1, 0, 1]).fair(0.1)


def patch_of(degree_u=3, degree_v=2, count_u=9, count_v=7, rational=False, periodic=False):
    u, v = np.meshgrid(np.linspace(0, 1, count_u), np.linspace(0, 1, count_v), indexing='ij')
    points = np.stack([4 * u, 3 * v, np.sin(5 * u) * np.cos(4 * v)], -1) + 0.05 * RNG.standard_normal((count_u, count_v, 3))
    if periodic:
        knots_u = np.arange(count_u + 1.0)
    else:
        knots_u = np.concatenate([np.zeros(degree_u), np.linspace(0, 1, count_u - degree_u + 1), np.ones(degree_u)])
    knots_v = np.concatenate([np.zeros(degree_v), np.linspace(0, 1, count_v - degree_v + 1), np.ones(degree_v)])
    weights = RNG.uniform(0.5, 2, (count_u, count_v)) if rational else None
    return sc.NurbsPatch((degree_u, degree_v), (knots_u, knots_v), points, weights, periodic=(periodic, False))


@pytest.mark.parametrize('kind', [dict(), dict(rational=True), dict(periodic=True)])
def test_patches(kind):
    patch = patch_of(**kind)
    made, error = patch.rebuild((14, 12), (4, 3))
    u, v = (np.clip(np.linspace(*domain, 160), *domain) for domain in patch.domain)
    seen = np.linalg.norm(patch.evaluate_grid(u, v) - made.evaluate_grid(u, v), axis=-1).max()
    assert seen <= error * (1 + 1e-9) and error <= 1.1 * seen
    assert made.points.shape[:2] == (14, 12) and made.periodic == patch.periodic
    if not kind.get('periodic'):
        corners = np.ix_([0, -1], [0, -1])
        np.testing.assert_allclose(made.points[corners], patch.points[corners], rtol=0, atol=1e-14 * 4)


def test_a_patch_on_even_knots_comes_back_and_one_span_is_a_bezier_patch():
    patch = patch_of()
    made, error = patch.rebuild((9, 7))
    np.testing.assert_allclose(made.points, patch.points, rtol=0, atol=1e-12)
    assert error < 1e-13
    one = patch.rebuild(6, 5).value
    assert one.points.shape[:2] == (6, 6) and len(np.unique(one.knots[0])) == 2


def test_patches_that_cannot_be_rebuilt():
    patch = patch_of()
    for arguments, message in (((3, 9), "along u"), ((9, 2), "along v"), ((0, 9), "counts = 0")):
        with pytest.raises(sc.InvalidShape, match=message):
            patch.rebuild(arguments)
    with pytest.raises(sc.InvalidShape, match="degree = 0"):
        patch.rebuild(9, 0)


def test_the_poles_of_a_sphere_stay_points():
    sphere = build.sphere((0, 0, 0), 1.0)
    made, error = sphere.rebuild((20, 20), (3, 3))
    assert error < 0.05
    for domain, axis in zip(sphere.domain, "uv"):
        for end in domain:
            old, new = (shape.isocurve(axis, end).points for shape in (sphere, made))
            if np.ptp(old, axis=0).max() < 1e-12:
                assert np.ptp(new, axis=0).max() < 1e-12


@pytest.mark.parametrize('degree', [2, 3, 5, 7])
@pytest.mark.parametrize('step', [1e-2, 1e-4, 1e-6, 1e-9])
def test_a_faired_line_stays_a_line_however_near_its_knots_lie(degree, step):
    knots = np.r_[np.zeros(degree + 1), 1, 1 + step, 2, 3, np.full(degree + 1, 4)]
    middles = np.array([knots[i + 1:i + 1 + degree].mean() for i in range(len(knots) - degree - 1)])
    line = np.stack([middles, 2 * middles, -middles], 1)
    made, error = sc.NurbsCurve(degree, knots, line).fair(0.1)
    assert error < 1e-13 and np.abs(made.points - line).max() < 1e-13


@pytest.mark.parametrize('degree', [2, 3, 5, 7])
@pytest.mark.parametrize('step', [1e-2, 1e-4])
def test_smoothing_leaves_a_line_where_knots_lie_near_each_other(degree, step):
    t = np.linspace(0, 4, 60)
    points = np.stack([t, 2 * t, -t], 1)
    knots = np.r_[np.zeros(degree + 1), 1, 1 + step, 2, 3, np.full(degree + 1, 4)]
    curve, error = sc.fit.approximate(points, degree=degree, parameters=t, knots=knots, smoothing=1.0)
    assert error < 1e-11 and np.abs(curve.evaluate(t) - points).max() < 1e-11
