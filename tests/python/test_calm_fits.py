"""Interpolation by default stays within a chord of its points at all degrees, moves with them, and what else fits or finds
places says what it does: each kind on 1000 random inputs."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit

PARTS = 5


def turning(rng):
    q = np.linalg.qr(rng.standard_normal((3, 3)))[0]
    return q * np.sign(np.linalg.det(q))


def wild_points(rng, count):
    """Walks, clusters, zigzags, copies a millionth away, and figures with one long chord."""
    steps = rng.standard_normal((count, 3)) * (1, 1, rng.integers(2))
    kind = rng.integers(8)
    if kind == 0:
        return steps
    if kind == 1:
        return steps * 10.0**rng.uniform(-6, 0, (count, 1))
    if kind == 2:
        return np.cumsum(steps * np.where(rng.random(count) < rng.uniform(0.05, 0.95), 1, 10.0**-rng.uniform(1, 6))[:, None], 0)
    if kind == 3:
        return np.c_[np.arange(count) * 10.0**-rng.uniform(0, 6), (-1.0)**np.arange(count), np.zeros(count)]
    if kind == 4:
        walk = np.repeat(np.cumsum(steps, 0), rng.integers(1, 4, count), 0)[:count]
        return walk + 1e-6 * rng.standard_normal(walk.shape)
    if kind == 5:
        centers = rng.standard_normal((5, 3))
        return centers[np.sort(rng.integers(0, 5, count))] + 10.0**-rng.uniform(2, 6) * steps
    if kind == 6:
        row = np.c_[np.arange(count) * 1e-6, np.zeros((count, 2))]
        row[rng.integers(count):, 1] = 1
        return row
    return np.cumsum(steps, 0)


def between_knots(curve, each):
    knots = np.unique(np.clip(curve.knots, *curve.domain))
    return np.concatenate([np.linspace(a, b, each) for a, b in zip(knots, knots[1:])])


def away_from_polygon(found, points):
    """Of the longest of its sides."""
    nearest = np.full(len(found), np.inf)
    for a, b in zip(points, points[1:]):
        side = b - a
        share = np.clip((found - a) @ side / max(side @ side, 1e-300), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(found - a - share[:, None] * side, axis=1))
    return nearest.max() / np.linalg.norm(np.diff(points, axis=0), axis=1).max()


def count_for(rng, degree, most):
    return int(np.exp(rng.uniform(np.log(max(3, degree + 1)), np.log(most))))


@pytest.mark.parametrize('part', range(PARTS))
def test_curves_of_all_degrees_stay_within_a_chord(part, inputs):
    """They swung 423 times the size of all points (degree 15), and 42 times at degree 11."""
    rng = np.random.default_rng([81, part])
    for _ in range(inputs(1000) // PARTS):
        degree, closed = int(rng.integers(1, 16)), bool(rng.random() < 0.3)
        points = wild_points(rng, count_for(rng, degree, 100)) * 10.0**rng.uniform(-6, 6)
        made = fit.interpolate(points, degree, closed=closed)
        polygon = np.r_[points, points[:1]] if closed else points
        assert away_from_polygon(made.value.evaluate(between_knots(made.value, 8)), polygon) <= 1.0
        assert made.value.nearest(points).distances.max() <= made.error + 1e-12 * np.abs(points).max()


@pytest.mark.parametrize('part', range(PARTS))
def test_curves_move_with_their_points(part, inputs):
    """Of degree 15 they moved by 3.5e-6 more or less."""
    rng = np.random.default_rng([82, part])
    for _ in range(inputs(1000) // PARTS):
        degree = int(rng.integers(1, 16))
        points = np.cumsum(rng.standard_normal((count_for(rng, degree, 100), 3)), 0)
        turn, move = turning(rng), rng.standard_normal(3)
        size = 10.0**rng.uniform(-6, 6)
        curve = fit.interpolate(points, degree).value
        others = fit.interpolate(size * (points @ turn.T + move), degree).value, fit.interpolate(points[::-1], degree).value
        shares = np.linspace(0, 1, 200)
        at = curve.evaluate(curve.domain[0] + shares * np.ptp(curve.domain))
        moved = others[0].evaluate(others[0].domain[0] + shares * np.ptp(others[0].domain)) / size
        back = others[1].evaluate(others[1].domain[0] + shares[::-1] * np.ptp(others[1].domain))
        most = 1e-11 * np.abs(points).max()
        assert np.abs(at @ turn.T + move - moved).max() < most and np.abs(at - back).max() < most


@pytest.mark.parametrize('part', range(PARTS))
def test_patches_of_all_degrees_stay_within_three_sides(part, inputs):
    rng = np.random.default_rng([83, part])
    for _ in range(inputs(1000) // PARTS):
        degrees = tuple(rng.integers(1, 16 if rng.random() < 0.3 else 6, 2).tolist())
        counts = [count_for(rng, degree, 20) for degree in degrees]
        grid = rng.standard_normal((*counts, 3))
        if rng.random() < 0.5:
            steps = [np.cumsum(np.where(rng.random(n) < 0.3, 1, 10.0**-rng.uniform(1, 6))) for n in counts]
            grid[..., :2] = np.stack(np.meshgrid(*steps, indexing='ij'), -1)
        patch = fit.interpolate_patch(grid, degrees).value
        u, v = (np.linspace(*each, 60) for each in patch.domain)
        sides = max(np.linalg.norm(np.diff(grid, axis=axis), axis=-1).max() for axis in (0, 1))
        found = patch.evaluate_grid(u, v)
        beyond = np.maximum(grid.min((0, 1)) - found, found - grid.max((0, 1)))
        assert beyond.max() <= 3 * sides


def test_even_steps_of_a_smooth_row_stay():
    """What does not swing is as it was: a helix through even points is told to many digits."""
    angle = np.linspace(0, 6, 60)
    curve = fit.interpolate(np.c_[np.cos(angle), np.sin(angle), angle], 9).value
    at = np.linspace(*curve.domain, 500)
    found = curve.evaluate(at)
    np.testing.assert_allclose(found, np.c_[np.cos(found[:, 2]), np.sin(found[:, 2]), found[:, 2]], rtol=0, atol=1e-9)


def rough(rng):
    """A function with a kink, a jump, an infinite derivative or a narrow bell, and places near which that is."""
    place, power = rng.uniform(0.01, 0.99), rng.uniform(0.1, 1)
    near = np.unique(np.clip(np.r_[place + np.outer([1, -1], np.geomspace(1e-15, 1, 200)).ravel(), place], 0, 1))
    width = rng.uniform(0.005, 0.1)
    return [(lambda x: np.abs(x - place)**power), (lambda x: np.sign(x - place)), (lambda x: np.floor(7 * x + place)),
            (lambda x: 1 / (x + width)), (lambda x: np.exp(-((x - place) / width)**2)),
            (lambda x: np.sin(x * place / 1e-3))][rng.integers(6)], near


@pytest.mark.parametrize('part', range(PARTS))
def test_projections_of_kinks_jumps_and_bells_say_how_far_they_are(part, inputs):
    rng = np.random.default_rng([84, part])
    for _ in range(inputs(1000) // PARTS):
        function, near = rough(rng)
        degree = int(rng.integers(1, 6))
        knots = np.r_[[0.0] * (degree + 1), np.sort(rng.uniform(0.05, 0.95, rng.integers(0, 4))), [1.0] * (degree + 1)]
        made = fit.project(lambda x: np.stack([x, function(x)], -1), knots, degree)
        at = np.union1d(np.linspace(0, 1, 3001), near)
        values = function(at)
        assert np.abs(made.value.evaluate(at)[:, 1] - values).max() <= made.error * (1 + 1e-3) + 1e-12 * np.abs(values).max()


def test_a_bell_of_a_hundredth_of_a_span_is_seen():
    """Between the places that were looked at it was nothing, with an error of 2e-16 said."""
    for place in np.linspace(0.05, 0.95, 91):
        made = fit.project(lambda x: np.stack([x, np.exp(-((x - place) / 0.003)**2)], -1), [0] * 4 + [1] * 4)
        assert made.error > 0.9


@pytest.mark.parametrize('part', range(PARTS))
def test_lengths_turned_into_parameters_come_back(part, inputs):
    """Beside cusps, stops and wild weights as well."""
    rng = np.random.default_rng([85, part])
    for _ in range(inputs(1000) // PARTS):
        degree = int(rng.integers(2, 7))
        points = rng.standard_normal((degree + 1, 3)) * 10.0**rng.uniform(-6, 6)
        for _ in range(rng.integers(0, 3)):
            at = rng.integers(1, degree + 1)
            points[at] = points[at - 1]
        weights = 10.0**rng.uniform(-3, 3, degree + 1) if rng.random() < 0.5 else None
        curve = sc.BezierCurve(points, weights)
        whole = curve.length()
        if whole == 0:
            continue
        wanted = whole * rng.uniform(0, 1)
        u = curve.parameter_at_length(wanted)
        assert abs(curve.length(0, u) - wanted) < 1e-8 * whole


def test_a_patch_that_closes_at_nine_places_alone_is_open():
    """Its sides meet at eighths and are apart between: curves that leave its domain were taken around."""
    from splinecore import build
    at = np.linspace(0, 1, 41)
    apart = 0.2 * np.sin(8 * np.pi * at)**2
    angle = np.linspace(0, 2 * np.pi, 20)
    ring = np.stack([np.cos(angle), np.sin(angle)], -1)
    grid = np.concatenate([np.repeat(ring[:, None], len(at), 1), np.repeat(at[None, :, None], len(angle), 0)], -1)
    grid[-1, :, 0] += apart
    patch = fit.interpolate_patch(grid, parameters=(np.arange(20.0), at)).value
    image = sc.BezierCurve([[15, 0.3], [25, 0.7]])
    with pytest.raises(sc.InvalidShape, match="domain"):
        build.curve_on_patch(patch, image)
