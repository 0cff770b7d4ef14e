"""Curves near points: against numpy's least squares with functions of Cox and de Boor, scipy, and what was sampled."""

import threading

import numpy as np
import pytest
from scipy.interpolate import make_lsq_spline, make_smoothing_spline

import splinecore as sc
from splinecore import fit

from test_interpolate import function_row, walk
from test_kernels import found_by_sets

RNG = np.random.default_rng(31)


def wave(count, noise=0.0):
    t = np.sort(RNG.uniform(0, 1, count))
    t[0], t[-1] = 0.0, 1.0
    points = np.stack([4 * t, np.sin(7 * t), np.cos(5 * t * t)], -1)
    return t, points + noise * RNG.standard_normal(points.shape)


def distances(curve, u, points):
    return np.linalg.norm(curve.evaluate(u) - points, axis=1)


def functions(curve, u):
    end = curve.knots[-1]
    return np.array([function_row(curve.knots, curve.degree, at, 0, at == end) for at in u])


@pytest.mark.parametrize('degree', range(1, 13))
@pytest.mark.parametrize('is_fixed', [False, True])
def test_it_is_the_least_sum_of_squares(degree, is_fixed):
    u, points = wave(200, 0.05)
    weights = RNG.uniform(0.1, 10, 200)
    curve, error = fit.approximate(points, 20, degree, u, weights=weights, fixed_ends=is_fixed)
    rows = functions(curve, u)
    free = slice(1, -1) if is_fixed else slice(None)
    right = points.copy()
    if is_fixed:
        right -= rows[:, :1] * points[0] + rows[:, -1:] * points[-1]
        np.testing.assert_array_equal(curve.points[[0, -1]], points[[0, -1]])
    root = np.sqrt(weights)[:, None]
    wanted = np.linalg.lstsq(rows[:, free] * root, right * root, rcond=None)[0]
    np.testing.assert_allclose(curve.points[free], wanted, rtol=0, atol=1e-10 * np.abs(wanted).max())
    assert error == pytest.approx(distances(curve, u, points).max(), rel=1e-9)
    assert len(curve.points) == 20 and curve.degree == degree and not curve.is_rational


@pytest.mark.parametrize('degree', range(1, 8))
@pytest.mark.parametrize('count', [9, 20, 61, 120])
def test_knots_of_a_count_are_those_of_the_book(degree, count):
    """The NURBS Book, eq. 9.68, 9.69: every span has its share of the parameters. Where that is less than degree + 1, knots
    are averages (eq. 9.8) of as many even places as there are control points: with shares of so few a single parameter
    decides about a control point that it hardly moves."""
    u = (np.arange(200) + RNG.uniform(0.3, 0.7, 200)) / 200
    points = np.stack([4 * u, np.sin(7 * u)], -1)
    curve = fit.approximate(points, count, degree, u).value
    step = 200 / (count - degree)
    inner = []
    if step < degree + 1:
        places = np.interp(np.arange(count) * 199 / (count - 1), np.arange(200), u)
        inner = [places[j:j + degree].mean() for j in range(1, count - degree)]
    for j in range(1, count - degree if step >= degree + 1 else 1):
        i = int(j * step)
        share = j * step - i
        inner.append((1 - share) * u[i - 1] + share * u[i])
    np.testing.assert_allclose(curve.knots, [u[0]] * (degree + 1) + inner + [u[-1]] * (degree + 1), rtol=1e-13, atol=0)


MANY = """
import json, sys
sys.path.insert(0, sys.argv[1])
import numpy as np
import splinecore, test_approximate
u, points = test_approximate.wave(203, 0.05)
weights = 1 + u
found = [test_approximate.fit.approximate(points, 20, degree, u, weights=weights) for degree in range(1, 10)]
numbers = [[*made.value.points.ravel(), made.error] for made in found]
print(json.dumps([splinecore.__instruction_set__, numbers]))
"""


def test_every_set_of_instructions_gives_nearly_the_same():
    first, *others = found_by_sets(MANY)
    for other in others:
        np.testing.assert_allclose(other, first, rtol=0, atol=1e-12)


@pytest.mark.parametrize('number', range(1, 12))
def test_few_points_in_a_span(number):
    """So many in the second span, at one of which the weight is all."""
    u = np.concatenate([np.linspace(0, 1, 9), 1 + np.linspace(0, 1, number + 2)[1:-1], np.linspace(2, 3, 9)])
    points = np.stack([u, np.sin(3 * u), u * u], -1)
    weights = np.ones(len(u))
    weights[8 + number] = 1e6
    curve, error = fit.approximate(points, None, 3, u, knots=[0, 0, 0, 0, 1, 2, 3, 3, 3, 3], weights=weights, fixed_ends=False)
    root = np.sqrt(weights)[:, None]
    wanted = np.linalg.lstsq(functions(curve, u) * root, points * root, rcond=None)[0]
    np.testing.assert_allclose(curve.points, wanted, rtol=0, atol=1e-10)
    assert error == pytest.approx(distances(curve, u, points).max(), rel=1e-9)


@pytest.mark.parametrize('degree', [1, 2, 3, 5])
def test_it_agrees_with_scipy(degree):
    u, points = wave(500, 0.02)
    inner = np.linspace(0, 1, 12)[1:-1]
    knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    curve = fit.approximate(points, None, degree, u, knots=knots, fixed_ends=False).value
    theirs = make_lsq_spline(u, points, knots, degree)
    np.testing.assert_allclose(curve.points, theirs.c, rtol=0, atol=1e-12 * np.abs(theirs.c).max())


@pytest.mark.parametrize('degree', range(1, 10))
@pytest.mark.parametrize('scale', [1.0, 1e-150, 1e150])
@pytest.mark.parametrize('offset', [0.0, 1e6])
def test_what_was_sampled_from_such_a_spline_comes_back(degree, scale, offset):
    inner = np.sort(RNG.uniform(0.1, 0.9, 6))
    inner[3] = inner[2] if degree > 1 else inner[3]          # a double knot
    knots = scale * np.concatenate([np.zeros(degree + 1), np.sort(inner), np.ones(degree + 1)])
    wanted = sc.NurbsCurve(degree, knots, scale * (walk(degree + 7) + offset))
    u = scale * np.linspace(0, 1, 40 * (degree + 7))
    u[-1] = knots[-1]
    curve, error = fit.approximate(wanted.evaluate(u), None, degree, u, knots=knots)
    size = np.abs(wanted.points).max()
    np.testing.assert_allclose(curve.points, wanted.points, rtol=0, atol=2e-12 * size)
    assert error <= 1e-13 * size


@pytest.mark.parametrize('degree', range(1, 8))
def test_closed_curves(degree):
    angles = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    points = np.stack([np.cos(angles), np.sin(angles), np.sin(3 * angles)], -1)
    u = np.append(angles, 2 * np.pi)
    curve, error = fit.approximate(points, 24, degree, u, closed=True)
    assert curve.periodic and len(curve.points) == 24
    assert error == pytest.approx(distances(curve, angles, points).max(), rel=1e-6)
    assert error < {1: 0.2}.get(degree, 0.02)
    again, left = fit.approximate(curve.evaluate(angles), None, degree, u, knots=curve.knots, closed=True)
    np.testing.assert_allclose(again.points, curve.points, rtol=0, atol=1e-11)
    assert left < 1e-12


@pytest.mark.parametrize('count', [3, 4, 5])
def test_closed_curves_of_few_control_points(count):
    angles = np.linspace(0, 2 * np.pi, 50, endpoint=False)
    points = np.stack([np.cos(angles), np.sin(angles)], -1)
    curve, error = fit.approximate(points, count, 3, closed=True)
    assert len(curve.points) == count and error < 0.3
    with pytest.raises(sc.InvalidShape, match="count = 2 control points are fewer than the 3 that degree 3"):
        fit.approximate(points, 2, 3, closed=True)


def test_unclamped_knots_with_free_ends():
    u, points = wave(300)
    knots = np.arange(-3, 17) / 13
    curve, error = fit.approximate(points, None, 3, u, knots=knots, fixed_ends=False)
    rows = functions(curve, u)
    wanted = np.linalg.lstsq(rows, points, rcond=None)[0]
    assert distances(curve, u, points).max() == pytest.approx(error, rel=1e-9)
    assert np.sum((rows @ wanted - points)**2) == pytest.approx(np.sum(distances(curve, u, points)**2), rel=1e-9)
    with pytest.raises(sc.InvalidShape, match="first and last knot 4 times"):
        fit.approximate(points, None, 3, u, knots=knots)


@pytest.mark.parametrize('domain', [(0.0, 1.0), (1e-150, 3e-150), (1e7, 1e7 + 1)])
def test_ends_have_the_derivatives_asked_for(domain):
    u, points = wave(300, 0.01)
    u = np.clip(domain[0] + (domain[1] - domain[0]) * u, *domain)
    length = domain[1] - domain[0]
    start, end = np.array([[1, 2, 3], [0, 50, 1.0]]) / [[length], [length]], np.array([3, 2, 1.0]) / length
    start[1] = np.array([0, 50, 1.0]) / length if length**2 == 0 else np.array([0, 50, 1.0]) / length / length
    if not np.isfinite(start).all():
        start = start[:1]
    curve = fit.approximate(points, 15, 4, u, start=start, end=end).value
    for k, wanted in enumerate(start, 1):
        found = curve.derivatives(domain[0], k)[k]
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-7 * np.abs(wanted).max())
    np.testing.assert_allclose(curve.derivatives(domain[1], 1, side='left')[1], end, rtol=0, atol=1e-7 * np.abs(end).max())
    np.testing.assert_array_equal(curve.points[[0, -1]], points[[0, -1]])


@pytest.mark.parametrize('weight', [1e-8, 1e-4, 1e-1])
def test_smoothing_agrees_with_scipy(weight):
    _, points = wave(60, 0.1)
    u = np.linspace(0, 1, 60) + np.r_[0, RNG.uniform(-0.4, 0.4, 58) / 59, 0]
    knots = np.concatenate([[0.0] * 3, u, [1.0] * 3])
    curve = fit.approximate(points, None, 3, u, knots=knots, fixed_ends=False, smoothing=weight).value
    rounding = 1e-12 + 1e-15 * weight / np.diff(u).min()**3
    for axis in range(3):
        theirs = make_smoothing_spline(u, points[:, axis], lam=weight)
        np.testing.assert_allclose(curve.evaluate(u)[:, axis], theirs(u), rtol=0, atol=rounding)


@pytest.mark.parametrize('degree', [2, 3, 5, 7])
@pytest.mark.parametrize('gap', 10.0**-np.arange(1, 13))
def test_smoothing_leaves_a_straight_line_beside_short_spans(degree, gap):
    """It has no energy, however large that is of what bends there."""
    knots = np.r_[[0.0] * (degree + 1), 1, 1 + gap, 2, 3, [4.0] * (degree + 1)]
    u = np.linspace(0, 4, 60)
    points = np.outer(u, [1, 2, -1])
    for weight in (1e-6, 1e-3, 1.0):
        for fixed_ends in (True, False):
            try:
                made = fit.approximate(points, None, degree, u, knots=knots, smoothing=weight, fixed_ends=fixed_ends)
            except sc.InvalidShape as refused:
                assert "less smoothing" in str(refused) and weight / gap**3 > 1e8
            else:
                np.testing.assert_allclose(made.value.evaluate(u), points, rtol=0, atol=1e-5)
                assert made.error < 1e-5


@pytest.mark.parametrize('gap', 10.0**-np.arange(1, 13))
def test_smoothing_leaves_what_stays_in_one_place_beside_short_spans(gap):
    u = np.linspace(0, 4, 62)
    knots = np.array([0, 1, 1 + gap, 2, 3, 3.5, 4])
    points = np.outer(np.ones(61), [1, 2, -1])
    for weight in (1e-6, 1.0):
        try:
            made = fit.approximate(points, None, 3, u, knots=knots, smoothing=weight, closed=True).value
        except sc.InvalidShape as refused:
            assert "less smoothing" in str(refused) and weight / gap**3 > 1e8
        else:
            np.testing.assert_allclose(made.evaluate(u[:-1]), points, rtol=0, atol=1e-5)


def energy(curve):
    u = np.linspace(*curve.domain, 20001)
    return np.mean(np.sum(curve.derivatives(u, 2)[..., 2, :]**2, -1))


def test_more_smoothing_bends_less_and_is_farther():
    u, points = wave(300, 0.1)
    made = [fit.approximate(points, 60, 3, u, smoothing=weight).value for weight in (0.0, 1e-6, 1e-4, 1e-2)]
    energies = [energy(curve) for curve in made]
    squares = [np.sum(distances(curve, u, points)**2) for curve in made]
    assert energies == sorted(energies, reverse=True) and squares == sorted(squares)


@pytest.mark.parametrize('trial', range(60))
def test_every_tolerance_is_kept(trial):
    rng = np.random.default_rng(trial)
    count, degree = int(rng.integers(12, 400)), int(rng.integers(1, 7))
    t = np.linspace(0, 1, count)
    points = np.stack([np.sin(rng.uniform(1, 20) * t), t * rng.uniform(0.1, 3), np.cos(rng.uniform(1, 9) * t**2)], -1)
    points *= 10.0**rng.uniform(-3, 3)
    tolerance = np.ptp(points) * 10.0**rng.uniform(-6, -1)
    closed = trial % 4 == 3
    curve, error = fit.approximate(points, None, degree, 'uniform', tolerance=tolerance, closed=closed,
                                   corrections=trial % 3)
    assert error <= tolerance and curve.periodic == closed
    assert np.all(curve.nearest(points).distances <= error * (1 + 1e-9) + 1e-13 * np.abs(points).max())
    assert len(curve.points) <= count
    if not closed:
        np.testing.assert_array_equal(curve.points[[0, -1]], points[[0, -1]])


def test_a_tolerance_takes_few_control_points():
    t = np.linspace(0, 1, 10_000)
    points = np.stack([t, np.sin(6 * t)], -1)
    few = fit.approximate(points, None, 3, 'uniform', tolerance=1e-4)
    assert few.error <= 1e-4 and len(few.value.points) <= 20
    bump = np.stack([t, np.exp(-(200 * (t - 0.3))**2)], -1)
    curve = fit.approximate(bump, None, 3, 'uniform', tolerance=1e-3).value
    knots = curve.knots[4:-4] / curve.domain[1]
    assert np.mean(np.abs(knots - 0.3) < 0.05) > 0.6         # where the bump is
    assert len(curve.points) < 40


def test_corrections_come_nearer():
    angles = np.linspace(0, np.pi, 300)**1.5 / np.pi**0.5
    points = np.stack([np.cos(angles), np.sin(angles)], -1)
    before = fit.approximate(points, 6, 3, 'uniform')
    after = fit.approximate(points, 6, 3, 'uniform', corrections=30)
    assert after.error < 0.4 * before.error
    assert after.value.nearest(np.pad(points, ((0, 0), (0, 1)))).distances.max() <= after.error * (1 + 1e-12)


def test_a_hundred_thousand_points_and_the_same_bits_again():
    u, points = wave(100_000, 0.01)
    made = [fit.approximate(points, 200, 3, u) for _ in range(2)]
    assert made[0].value == made[1].value and made[0].error < 0.1
    found = []
    threads = [threading.Thread(target=lambda: found.append(fit.approximate(points, 200, 3, u).value)) for _ in range(3)]
    [thread.start() for thread in threads], [thread.join() for thread in threads]
    assert all(each == made[0].value for each in found) and len(found) == 3


def test_smoothing_that_keeps_a_tolerance_away_is_named():
    with pytest.raises(sc.ToleranceNotReached, match="by 30 control points and this much smoothing within 0.1: the error"):
        fit.approximate(walk(30), tolerance=0.1, smoothing=1e6)
    with pytest.raises(sc.InvalidShape, match="smoothing = 1e\\+25 leaves nothing of the points: .* less smoothing are needed$"):
        fit.approximate(walk(30), 9, smoothing=1e25, fixed_ends=False)
    with pytest.raises(sc.InvalidShape, match="smoothing = 1e\\+20 leaves nothing of the points: .* less smoothing are needed$"):
        fit.approximate(walk(30), 4, smoothing=1e20, fixed_ends=False)


BAD = [
    (dict(), "count, knots, tolerance or residual is needed"),
    (dict(count=5, knots=[0, 0, 0, 0, 1, 1, 1, 1]), "neither count nor tolerance"),
    (dict(count=3), "^count = 3 control points are fewer than the 4 that degree 3 needs$"),
    (dict(count=3, tolerance=100.0), "^count = 3 control points are fewer than the 4 that degree 3 needs$"),
    (dict(count=2, tolerance=100.0, closed=True), "^count = 2 control points are fewer than the 3 that degree 3 needs$"),
    (dict(count=4, tolerance=100.0, closed=True, degree=5), "^count = 4 control points are fewer than the 5 that degree 5"),
    (dict(count=4, tolerance=100.0, start=np.ones((2, 3)), end=(1, 0, 0)), "^4 control points are fewer than the 5 that the ends"),
    (dict(count=31), "^count = 31 control points are more than the 30 points$"),
    (dict(count=0), "count = 0 is not above 0"),
    (dict(count=8, degree=0), "degree = 0"),
    (dict(tolerance=0.0), "tolerance = 0"),
    (dict(tolerance=-1.0), "tolerance = -1"),
    (dict(tolerance=float('nan')), "tolerance = nan"),
    (dict(count=8, weights=np.ones(3)), "weights has 3 values for 30 points"),
    (dict(count=8, weights=np.r_[np.ones(29), 0.0]), r"weights\[29\] = 0"),
    (dict(count=8, weights=np.r_[np.nan, np.ones(29)]), r"weights\[0\] = nan"),
    (dict(count=8, smoothing=-1.0), "smoothing = -1"),
    (dict(count=8, degree=1, smoothing=1.0), "smoothing needs degree 2"),
    (dict(count=8, corrections=-1), "corrections = -1"),
    (dict(count=8, parameters=np.zeros(30)), r"parameters\[1\] = 0 does not increase from 0"),
    (dict(count=8, parameters=np.r_[np.arange(29.0), 27.5]), r"parameters\[29\] = 27.5 does not increase from 28"),
    (dict(points=walk(30)[np.r_[:8, 7:29]], count=8), r"points\[8\] is too close to points\[7\]"),
    (dict(count=8, parameters=np.arange(29.0)), "parameters has 29 values for 30 points"),
    (dict(count=8, start=np.ones((3, 3))), "3 derivatives at an end are too many for degree 3"),
    (dict(count=8, start=(1, 0, 0), fixed_ends=False), "derivatives are for the fixed ends"),
    (dict(count=8, start=(1, 0, 0), closed=True), "derivatives are for the fixed ends"),
    (dict(count=4, start=np.ones((2, 3)), end=(1, 0, 0)), "^4 control points are fewer than the 5 that the ends"),
    (dict(knots=[0, 0, 0, 0, 5, 5, 5, 5], parameters='uniform'), "leave the knots' domain"),
    (dict(knots=[0] * 4 + [28.1, 28.2, 28.3, 28.4] + [29] * 4, parameters='uniform'), "too few points have parameters"),
    (dict(points=walk(3), tolerance=0.1), "^3 points are too few for degree 3, which needs at least 4$"),
    (dict(points=walk(3), count=4), "^3 points are too few for degree 3, which needs at least 4$"),
    (dict(points=walk(5), degree=6, tolerance=0.1, closed=True), "^5 points are too few for degree 6, which needs at least 6$"),
    (dict(points=walk(4), tolerance=0.1, start=np.ones((2, 3)), end=(1, 0, 0)), "^4 points are too few beside 3 derivatives"),
]


@pytest.mark.parametrize('arguments, message', BAD)
def test_bad_input_is_refused_in_a_sentence(arguments, message):
    with pytest.raises(sc.InvalidShape, match=message):
        fit.approximate(**{'points': walk(30), **arguments})


def test_bad_points():
    points = walk(30)
    for bad, message in ((points[:1], "at least 2"), (np.zeros((30, 3)), "points"), (points[:, :1], "points"),
                         (np.where(np.arange(30)[:, None] == 7, np.nan, points), r"points\[7")):
        with pytest.raises(sc.InvalidShape, match=message):
            fit.approximate(bad, 8)
    with pytest.raises(TypeError):
        fit.approximate(points, "eight")


def test_what_cannot_be_reached_says_how_near_it_comes():
    u, points = wave(400, 0.1)
    with pytest.raises(sc.ToleranceNotReached, match="by 20 control points.*the error would be"):
        fit.approximate(points, 20, 3, u, tolerance=1e-3)
    collinear = np.outer(np.arange(9.0)**2, [1, 2, 3])
    curve, error = fit.approximate(collinear, 5)
    assert error < 1e-12 and np.linalg.matrix_rank(curve.points - curve.points[0], tol=1e-9) == 1


def test_it_can_be_cancelled():
    calls = []
    with pytest.raises(sc.Cancelled):
        fit.approximate(walk(200_000), None, 3, tolerance=1e-3, cancel=lambda: calls.append(0) or len(calls) > 2)


@pytest.mark.parametrize('degree', range(1, 8))
def test_projection_of_a_polynomial_is_that_polynomial(degree):
    knots = np.concatenate([np.zeros(degree), np.linspace(0, 2, 6), np.full(degree, 2.0)])
    factors = RNG.standard_normal((degree + 1, 3))
    curve, error = fit.project(lambda u: np.polynomial.polynomial.polyval(u, factors).T, knots, degree)
    u = np.linspace(0, 2, 100)
    wanted = np.polynomial.polynomial.polyval(u, factors).T
    np.testing.assert_allclose(curve.evaluate(u), wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())
    assert error < 1e-12 * np.abs(wanted).max()


@pytest.mark.parametrize('degree', [1, 2, 3, 4, 5])
def test_one_span_is_the_series_of_legendre(degree):
    from numpy.polynomial import Legendre
    from scipy.integrate import quad
    knots = [-1.0] * (degree + 1) + [1.0] * (degree + 1)
    curve, error = fit.project(lambda u: np.stack([u, np.exp(u)], -1), knots, degree)
    factors = [(2 * k + 1) / 2 * quad(lambda t, k=k: np.exp(t) * Legendre.basis(k)(t), -1, 1)[0] for k in range(degree + 1)]
    u = np.linspace(-1, 1, 300)
    np.testing.assert_allclose(curve.evaluate(u)[:, 1], Legendre(factors)(u), rtol=0, atol=1e-13)
    assert error >= np.abs(Legendre(factors)(u) - np.exp(u)).max() * (1 - 1e-6)


@pytest.mark.parametrize('closed', [False, True])
def test_what_a_projection_leaves_is_orthogonal(closed):
    knots = np.linspace(0, 2 * np.pi, 9) if closed else np.concatenate([[0.0] * 3, np.linspace(0, 2 * np.pi, 9), [2 * np.pi] * 3])

    def function(u):
        return np.stack([np.cos(u), np.sin(u), np.exp(np.sin(u))], -1)

    curve = fit.project(function, knots, 3, closed=closed).value
    nodes, weights = np.polynomial.legendre.leggauss(30)
    spans = np.unique(knots)
    u = np.concatenate([a + (b - a) * (nodes + 1) / 2 for a, b in zip(spans, spans[1:])])
    w = np.concatenate([(b - a) / 2 * weights for a, b in zip(spans, spans[1:])])
    left = (function(u) - curve.evaluate(u)) * w[:, None]
    for i in range(len(curve.points)):
        bump = np.zeros((len(curve.points), 3))
        bump[i] = 1.0
        row = sc.NurbsCurve(3, curve.knots, bump, periodic=closed).evaluate(u)[:, 0]
        assert np.abs(row @ left).max() < 1e-13


def test_a_projection_can_hold_its_ends():
    knots = [0.0] * 4 + [0.5] + [1.0] * 4
    curve = fit.project(lambda u: np.stack([u, np.exp(3 * u)], -1), knots, fixed_ends=True).value
    np.testing.assert_allclose(curve.points[[0, -1], :2], [[0, 1], [1, np.exp(3)]], rtol=1e-15)


def test_functions_that_are_none():
    knots = [0.0] * 4 + [1.0] * 4
    with pytest.raises(sc.InvalidShape, match="the function is not finite at"):
        fit.project(lambda u: np.stack([u, np.where(u > 0.5, np.inf, u)], -1), knots)
    with pytest.raises(sc.InvalidShape, match="function has 3 points"):
        fit.project(lambda u: np.zeros((3, 3)), knots)
    with pytest.raises(TypeError, match="not callable"):
        fit.project(3, knots)
    with pytest.raises(ZeroDivisionError):
        fit.project(lambda u: 1 / 0, knots)
    with pytest.raises(sc.InvalidShape):
        fit.project(lambda u: np.stack([u, u], -1), [0, 1])


def narrow_peak():
    t = np.linspace(0, 1, 30)
    return np.stack([t, np.exp(-((t - 0.5) / 0.03) ** 2)], -1)


def noise_beside_its_tolerance():
    """The same in every run: of others a few need 100 control points, those whose largest noise is beyond the tolerance."""
    t = np.linspace(0, 1, 400)
    return np.stack([6 * t, np.sin(6 * t)], -1) + 1e-3 * np.random.Generator(np.random.PCG64(4)).standard_normal((400, 2))


@pytest.mark.parametrize('points, tolerance, degree, most', [
    (narrow_peak(), 1e-3, 3, 20), (narrow_peak(), 1e-3, 5, 24), (noise_beside_its_tolerance(), 3.2e-3, 3, 24),
    (noise_beside_its_tolerance(), 3.2e-3, 5, 24), (walk(60), 0.3, 3, 58), (walk(60), 0.3, 5, 58)])
@pytest.mark.parametrize('scale', [1.0, 1e-150, 1e150])
def test_within_a_tolerance_no_more_control_points_than_are_needed(points, tolerance, degree, most, scale):
    """Where knots lie between every two points, too: not as many control points as points."""
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    curve, error = fit.approximate(scale * points, degree=degree, parameters=at, tolerance=scale * tolerance)
    assert error <= scale * tolerance and len(curve.points) <= most < len(points)
    found = distances(curve, at, scale * np.pad(points, ((0, 0), (0, 3 - points.shape[1])))) / scale
    assert found.max() == pytest.approx(error / scale, rel=1e-9)
