"""Fits of wild input stay near their points, and what they say of their errors is so: each kind on 1000 random inputs."""

import numpy as np
import pytest
from scipy.interpolate import BSpline

import splinecore as sc
from splinecore import fit

PARTS = 5


def box_size(points):
    return np.linalg.norm(np.ptp(points, axis=0))


def outside(found, points):
    """How far the farthest lies from the box of the points, beside its size."""
    low, high = points.min(0), points.max(0)
    away = np.maximum(0, np.maximum(low - found, found - high))
    return np.linalg.norm(away, axis=1).max() / box_size(points)


def between_knots(domain, knots, each=16):
    ends = np.unique(np.r_[domain[0], knots[(knots > domain[0]) & (knots < domain[1])], domain[1]])
    return np.concatenate([np.linspace(a, b, each) for a, b in zip(ends, ends[1:])])


def curve_outside(curve, points):
    return outside(curve.evaluate(between_knots(curve.domain, curve.knots)), points)


def patch_outside(patch, points):
    u, v = (between_knots(*each, 6) for each in zip(patch.domain, patch.knots))
    return outside(patch.evaluate_grid(u, v).reshape(-1, 3), points.reshape(-1, 3))


def wild_steps(rng, count):
    least = 10.0**rng.uniform(-12, -2)
    steps = np.ones(count)
    kind = rng.integers(4)
    if kind == 0:
        steps = 10.0**rng.uniform(np.log10(least), 0, count)
    elif kind < 3:
        steps[rng.random(count) < (0.5, 0.8)[kind - 1]] = least
    else:
        first = rng.integers(count)
        steps[first:first + rng.integers(1, 6)] = least
    steps[rng.integers(count)] = 1
    return steps


def wild_walk(rng, count):
    """Points whose distances are some as long as others a million times and more."""
    turns = rng.standard_normal((count - 1, 3)) * (1, 1, rng.integers(2))
    if rng.random() < 0.3:
        turns[:, 0] = np.abs(turns[:, 0]) + 2
    turns /= np.linalg.norm(turns, axis=1)[:, None]
    return np.r_[np.zeros((1, 3)), np.cumsum(turns * wild_steps(rng, count - 1)[:, None], 0)]


#: By degree, of the size of the box around the points; a polynomial through as many even points as its degree needs leaves
#: them by more the higher that is.
MOST = {1: 1e-9, 2: 0.3, 3: 0.7, 4: 2, 5: 3, 6: 3, 7: 4, 8: 6, 9: 12}


def smallest_step(points):
    """Of the size of all."""
    return np.linalg.norm(np.diff(points, axis=0), axis=1).min() / np.ptp(points, axis=0).max()


@pytest.mark.parametrize('part', range(PARTS))
def test_curves_through_wildly_uneven_points_stay_near(part, inputs):
    rng = np.random.default_rng([71, part])
    for _ in range(inputs(1000) // PARTS):
        degree, closed = int(rng.integers(1, 10)), bool(rng.random() < 0.3)
        points = 10.0**rng.uniform(-9, 9) * wild_walk(rng, int(rng.integers(max(3, degree + 1), 40)))
        if closed and np.linalg.norm(points[0] - points[-1]) == 0:
            continue
        try:
            made = fit.interpolate(points, degree, closed=closed)
        except sc.InvalidShape as refusal:
            assert "rounding leaves the shape" in str(refusal) and smallest_step(points) < 1e-9
            continue
        assert curve_outside(made.value, points) < MOST[degree]
        assert made.value.nearest(points).distances.max() <= made.error + 1e-12 * np.abs(points).max()


def test_points_close_beside_others_far_apart_make_no_swing():
    """The curve swung 41 beyond a figure 2 long."""
    rng = np.random.default_rng(5)
    for near in 10.0**-np.arange(1, 11):
        points = np.array([[0, 0], [1, 0], [1, near], [1 + near, near], [1 + near, 2 * near], [2, 1], [2, 1 - near]])
        for _ in range(10):
            turned = points + near * rng.uniform(-0.3, 0.3, points.shape)
            assert curve_outside(fit.interpolate(turned).value, np.pad(turned, ((0, 0), (0, 1)))) < 0.5


@pytest.mark.parametrize('part', range(PARTS))
def test_patches_through_wildly_uneven_rows_stay_near(part, inputs):
    rng = np.random.default_rng([72, part])
    for _ in range(inputs(1000) // PARTS):
        degrees = tuple(rng.integers(1, 5, 2).tolist())
        u, v = (np.r_[0, np.cumsum(wild_steps(rng, int(rng.integers(5, 16))))] for _ in range(2))
        heights = rng.uniform(-1, 1, (len(u), len(v)))
        grid = np.stack([*np.meshgrid(u, v, indexing='ij'), heights * np.minimum.outer(np.gradient(u), np.gradient(v))], -1)
        made = fit.interpolate_patch(grid, degrees)
        assert patch_outside(made.value, grid) < MOST[degrees[0]] + MOST[degrees[1]] + MOST[degrees[0]] * MOST[degrees[1]]


@pytest.mark.parametrize('degree', range(1, 10))
def test_closed_curves_through_as_few_points_as_control_points_are_needed(degree, inputs):
    rng = np.random.default_rng([73, degree])
    for _ in range(inputs(1000) // 9):
        count = max(degree, 3)
        u = np.r_[0, np.cumsum(10.0**rng.uniform(-1, 0, count))]
        points = rng.standard_normal((count, 3))
        made = fit.interpolate(points, degree, u, closed=True)
        curve = made.value
        assert curve.periodic and len(curve.points) == count
        assert np.linalg.norm(curve.evaluate(u[:-1]) - points, axis=1).max() < 1e-9 * np.abs(curve.points).max()
        at = rng.integers(count)
        turned = fit.interpolate(np.roll(points, -at, 0), degree, np.r_[u[at:], u[1:at + 1] + u[-1]] - u[at], closed=True).value
        places = rng.uniform(0, u[-1], 20)
        np.testing.assert_allclose(turned.evaluate((places - u[at]) % u[-1]), curve.evaluate(places), rtol=0,
                                   atol=1e-8 * np.abs(curve.points).max())
    if degree > 3:
        with pytest.raises(sc.InvalidShape, match=f"too few for degree {degree}, which needs at least {degree}$"):
            fit.interpolate(rng.standard_normal((degree - 1, 3)), degree, closed=True)


def test_a_closed_cubic_through_three_points_is_as_symmetric_as_they_are():
    angles = 2 * np.pi * np.arange(3) / 3
    points = np.stack([np.cos(angles), np.sin(angles)], -1)
    curve = fit.interpolate(points, closed=True).value
    np.testing.assert_allclose(np.linalg.norm(curve.points, axis=1), np.linalg.norm(curve.points[0]), rtol=1e-14)
    patch = fit.interpolate_patch(np.random.default_rng(1).standard_normal((3, 6, 3)), closed=(True, False)).value
    assert patch.periodic == (True, False) and patch.points.shape == (3, 6, 3)


def noisy_grid(rng):
    """A smooth height over a grid that is even, uneven or clustered, with noise, and a tolerance near the noise."""
    axes = []
    for _ in range(2):
        count = int(rng.integers(6, 41))
        kind = rng.integers(3)
        steps = np.ones(count - 1) if kind == 0 else rng.uniform(0.5, 1.5, count - 1)
        if kind == 2:
            steps[rng.random(count - 1) < 0.3] = 10.0**-rng.uniform(1, 6)
        axes.append(np.r_[0, np.cumsum(steps)] / steps.sum())
    u, v = np.meshgrid(*axes, indexing='ij')
    a, b = rng.uniform(1, 5, 2)
    noise = 10.0**rng.uniform(-5, -2)
    heights = 0.1 * np.sin(a * u) + 0.05 * np.cos(b * v) * v + noise * rng.standard_normal(u.shape)
    return np.stack([u, v, heights], -1), noise * 10.0**rng.uniform(-0.5, 1)


@pytest.mark.parametrize('part', range(PARTS))
def test_patches_near_noisy_grids_stay_near(part, inputs):
    rng = np.random.default_rng([74, part])
    for _ in range(inputs(1000) // PARTS):
        grid, tolerance = noisy_grid(rng)
        try:
            made = fit.approximate_patch(grid, tolerance=tolerance, degrees=tuple(rng.integers(1, 6, 2).tolist()))
        except sc.ToleranceNotReached as refused:
            assert refused.args
            continue
        assert made.error <= tolerance and patch_outside(made.value, grid) < 1


@pytest.mark.parametrize('counts, noise, tolerance', [((12, 12), 1e-3, 1e-3), ((25, 40), 1e-3, 1e-3), ((60, 60), 2e-4, 6e-4)])
@pytest.mark.parametrize('degree', [1, 2, 3, 4, 5])
def test_a_tolerance_beside_the_noise(counts, noise, tolerance, degree):
    """They were 1670, 5e15 and 3e14 away, of data 1 wide."""
    u, v = np.meshgrid(*(np.linspace(0, 1, count) for count in counts), indexing='ij')
    heights = 0.1 * np.sin(3 * u) + 0.05 * v**2
    grid = np.stack([u, v, heights + noise * np.random.default_rng(7).standard_normal(u.shape)], -1)
    made = fit.approximate_patch(grid, tolerance=tolerance, degrees=degree)
    found = made.value.evaluate_grid(*(np.linspace(*each, 200) for each in made.value.domain))
    away = found[..., 2] - 0.1 * np.sin(3 * found[..., 0]) - 0.05 * found[..., 1]**2
    assert made.error <= tolerance and np.abs(away).max() < 12 * noise


@pytest.mark.parametrize('degree', range(1, 8))
def test_noise_is_not_made_larger_by_almost_as_many_control_points_as_points(degree):
    """With knots by shares of the parameters alone it was, a billion times."""
    rng = np.random.default_rng(degree)
    u = np.arange(60) + rng.uniform(-0.3, 0.3, 60)
    for closed in (False, True):
        around = np.r_[u, u[0] + 60] if closed else u
        angle = 2 * np.pi * u / 60
        points = np.stack([np.cos(angle), np.sin(angle), rng.standard_normal(60)], -1)
        for count in range(max(3, degree + 1), 61):
            curve = fit.approximate(points, count, degree, around, closed=closed).value
            assert curve_outside(curve, points) < 30


def near_wild_curve_points(rng):
    points = wild_walk(rng, int(rng.integers(8, 120)))
    points += 10.0**rng.uniform(-9, -2) * rng.standard_normal(points.shape)
    return points, 10.0**rng.uniform(-6, 0) * box_size(points)


@pytest.mark.parametrize('part', range(PARTS))
def test_curves_within_a_tolerance_stay_near(part, inputs):
    rng = np.random.default_rng([75, part])
    refused, count = 0, inputs(1000) // PARTS
    for _ in range(count):
        points, tolerance = near_wild_curve_points(rng)
        options = {'weights': 10.0**rng.uniform(-3, 3, len(points))} if rng.random() < 0.3 else {}
        degree, closed = int(rng.integers(1, 6)), bool(rng.random() < 0.3)
        if closed and np.linalg.norm(points[0] - points[-1]) == 0:
            continue
        try:
            made = fit.approximate(points, degree=degree, tolerance=tolerance, closed=closed, **options)
        except sc.ToleranceNotReached as swinging:
            assert "without swinging far from them in between" in str(swinging)
            refused += 1
            continue
        assert made.error <= tolerance and curve_outside(made.value, points) < 4
        assert made.value.nearest(points).distances.max() <= made.error * (1 + 1e-9) + 1e-12 * np.abs(points).max()
    assert refused <= 1 + count // 100


def points_with_holes(rng):
    at = rng.uniform(-1, 1, (int(rng.integers(300, 1500)), 2))
    for _ in range(rng.integers(1, 4)):
        at = at[np.linalg.norm(at - rng.uniform(-1, 1, 2), axis=1) > rng.uniform(0.1, 0.7)]
    a, b = rng.uniform(1, 4, 2)
    noise = 10.0**rng.uniform(-5, -2)
    return np.c_[at, 0.2 * np.sin(a * at[:, 0]) * np.cos(b * at[:, 1]) + noise * rng.standard_normal(len(at))], noise


@pytest.mark.parametrize('part', range(PARTS))
def test_patches_near_scattered_points_with_holes_stay_near(part, inputs):
    rng = np.random.default_rng([76, part])
    for _ in range(inputs(200) // PARTS):
        points, noise = points_with_holes(rng)
        if len(points) < 60:
            continue
        try:
            made = fit.approximate_scattered(points, tolerance=noise * rng.uniform(4, 8))
        except sc.ToleranceNotReached as refused:
            assert "determine" in str(refused)
        else:
            assert made.value.nearest(points).distances.max() <= made.error * (1 + 1e-9)
            assert patch_outside(made.value, points) < 1.2
        try:
            made = fit.approximate_scattered(points, int(rng.integers(6, 21)))
        except sc.InvalidShape as refused:
            assert "determine" in str(refused)
        else:
            assert patch_outside(made.value, points) < 4.2


def rough_function(rng):
    """Pieces of waves with kinks and jumps between them, and where those are."""
    places = np.sort(rng.uniform(0, 1, rng.integers(1, 5)))
    bends, jumps = rng.normal(size=(2, len(places)))
    jumps *= rng.random(len(places)) < 0.3
    turns = rng.uniform(0, 20)

    def function(x):
        away = x[:, None] - places
        return np.sin(turns * x) + (bends * np.abs(away) + jumps * (away > 0)).sum(1)
    return function, places


@pytest.mark.parametrize('part', range(PARTS))
def test_projections_of_rough_functions_say_how_far_they_are(part, inputs):
    rng = np.random.default_rng([77, part])
    nodes, shares = np.polynomial.legendre.leggauss(30)
    for _ in range(inputs(1000) // PARTS):
        function, places = rough_function(rng)
        degree = int(rng.integers(1, 6))
        knots = np.r_[[0.0] * (degree + 1), np.sort(rng.uniform(0.05, 0.95, rng.integers(0, 5))), [1.0] * (degree + 1)]
        made = fit.project(lambda x: np.stack([x, function(x)], -1), knots, degree)
        ends = np.unique(np.r_[knots, places])
        at = np.concatenate([a + (b - a) * (nodes + 1) / 2 for a, b in zip(ends, ends[1:])])
        root = np.sqrt(np.concatenate([(b - a) / 2 * shares for a, b in zip(ends, ends[1:])]))
        rows = BSpline.design_matrix(at, knots, degree).toarray()
        wanted = np.linalg.lstsq(rows * root[:, None], function(at) * root, rcond=None)[0]
        size = np.abs(wanted).max()
        np.testing.assert_allclose(made.value.evaluate(at)[:, 1], rows @ wanted, rtol=0, atol=1e-9 * size)
        dense = np.unique(np.r_[np.linspace(0, 1, 4001), places, np.nextafter(places, 1)])
        left = np.abs(made.value.evaluate(dense)[:, 1] - function(dense)).max()
        assert left <= made.error * (1 + 1e-9) + 1e-12 * size


def test_noise_has_no_projection():
    rng = np.random.default_rng(1)
    with pytest.raises(sc.InvalidShape, match="too rough for its integrals to be told"):
        fit.project(lambda x: rng.standard_normal((len(x), 2)), [0] * 4 + [1] * 4)
