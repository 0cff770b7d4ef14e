"""Patches near grids and scattered points: what comes from such a patch comes back; errors are those of dense checks."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit

RNG = np.random.default_rng(5)


def clamped(degree, count):
    inner = np.sort(RNG.uniform(0.1, 0.9, count - degree - 1))
    return np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])


def patch_of(degrees, counts, scale=1.0, offset=0.0):
    knots = [clamped(degree, count) for degree, count in zip(degrees, counts)]
    u, v = np.meshgrid(*(np.linspace(0, 1, count) for count in counts), indexing='ij')
    points = np.stack([3 * u, 2 * v, 0.5 * np.sin(4 * u) * np.cos(3 * v)], -1) + RNG.uniform(-0.05, 0.05, (*counts, 3))
    return sc.NurbsPatch(degrees, knots, scale * (points + offset))


def wave(u, v):
    return np.stack([4 * u, 3 * v, 0.5 * np.sin(5 * u) * np.cos(4 * v)], -1)


def cloud(count, noise=0.0):
    u, v = RNG.uniform(0, 1, (2, count))
    return wave(u, v) + noise * RNG.standard_normal((count, 3))


@pytest.mark.parametrize('degrees', [(1, 1), (2, 3), (3, 3), (5, 4), (9, 2)])
@pytest.mark.parametrize('scale, offset', [(1.0, 0.0), (1e-150, 0.0), (1e150, 0.0), (1.0, 1e7)])
def test_a_grid_of_a_patch_gives_it_back(degrees, scale, offset):
    patch = patch_of(degrees, (degrees[0] + 5, degrees[1] + 4), scale, offset)
    u, v = (np.linspace(0, 1, count) for count in (90, 80))
    made, error = fit.approximate_patch(patch.evaluate_grid(u, v), degrees=degrees, parameters=(u, v), knots=patch.knots)
    size = np.abs(patch.points).max()
    np.testing.assert_allclose(made.points, patch.points, rtol=0, atol=1e-9 * size)
    assert error < 1e-13 * size


@pytest.mark.parametrize('fixed_ends', [True, False])
def test_it_is_the_least_sum_of_squares(fixed_ends):
    u, v = np.linspace(0, 1, 25), np.linspace(0, 1, 21)
    grid = wave(*np.meshgrid(u, v, indexing='ij')) + 0.05 * RNG.standard_normal((25, 21, 3))
    made, error = fit.approximate_patch(grid, (7, 6), parameters=(u, v), fixed_ends=fixed_ends)
    left = grid - made.evaluate_grid(u, v)
    assert error == pytest.approx(np.linalg.norm(left, axis=-1).max(), rel=1e-12)
    if fixed_ends:
        np.testing.assert_allclose(made.points[[0, 0, -1, -1], [0, -1, 0, -1]], grid[[0, 0, -1, -1], [0, -1, 0, -1]], rtol=1e-14)
        return
    functions = [np.array([sc.NurbsCurve(3, knots, [[float(k == i), 0] for k in range(count)]).evaluate(at)[:, 0]
                           for i in range(count)]) for knots, count, at in zip(made.knots, (7, 6), (u, v))]
    gradient = np.einsum('iu,jv,uvc->ijc', *functions, left)
    np.testing.assert_allclose(gradient, 0, atol=1e-11)


def test_a_closed_direction_and_a_tolerance():
    a, z = np.meshgrid(np.linspace(0, 2 * np.pi, 60, endpoint=False), np.linspace(0, 3, 40), indexing='ij')
    tube = np.stack([(2 + np.sin(z)) * np.cos(a), (2 + np.sin(z)) * np.sin(a), z], -1)
    for tolerance in (1e-1, 1e-2, 1e-4):
        made, error = fit.approximate_patch(tube, tolerance=tolerance, closed=(True, False))
        assert error <= tolerance and made.periodic == (True, False)
        near = made.nearest(tube.reshape(-1, 3)).distances.max()
        assert near <= error * (1 + 1e-9)
    assert made.points.shape[0] < 60 and made.points.shape[1] < 40
    with pytest.raises(sc.ToleranceNotReached, match="5 x 5 control points within 1e-09"):
        fit.approximate_patch(tube, 5, tolerance=1e-9, closed=(True, False))


def test_where_parameters_are_almost_equal_a_tolerance_is_reached_or_said_not_to_be():
    rng, found = np.random.default_rng(6), set()
    for _ in range(400):
        u, v = (np.sort(rng.uniform(0, 1, count)) for count in rng.integers(6, 12, 2))
        for parameters in (u, v):
            i = rng.integers(1, len(parameters) - 1)
            parameters[i] = parameters[i - 1] + 10.0**-rng.uniform(8, 16)
        if min(np.diff(u).min(), np.diff(v).min()) <= 0:
            continue
        points = rng.normal(size=(len(u), len(v), 3))
        tolerance = 10.0**-rng.uniform(-1, 6)
        try:
            made = fit.approximate_patch(points, tolerance=tolerance, degrees=tuple(rng.integers(1, 4, 2).tolist()),
                                         parameters=(u, v))
        except sc.ToleranceNotReached:
            found.add('not reached')
            continue
        assert np.abs(made.value.evaluate_grid(u, v) - points).max() <= made.error * (1 + 1e-9) <= tolerance * (1 + 1e-9)
        found.add('reached')
    assert found == {'reached', 'not reached'}


def test_smoothing_of_a_grid():
    u, v = np.linspace(0, 1, 30), np.linspace(0, 1, 30)
    noisy = wave(*np.meshgrid(u, v, indexing='ij')) + 0.02 * RNG.standard_normal((30, 30, 3))
    rough, smooth = (fit.approximate_patch(noisy, (20, 20), parameters=(u, v), smoothing=each).value for each in (0.0, 1e-5))
    bend = [np.abs(np.diff(each.points, 2, axis=0)).sum() for each in (rough, smooth)]
    assert bend[1] < bend[0]


@pytest.mark.parametrize('scale, offset', [(1.0, 0.0), (1e-150, 0.0), (1e150, 0.0), (1.0, 1e6)])
def test_scattered_points_of_a_patch_give_it_back(scale, offset):
    patch = patch_of((3, 2), (8, 7), scale, offset)
    at = RNG.uniform(0, 1, (2000, 2))
    at[:4] = [[0, 0], [0, 1], [1, 0], [1, 1]]
    points = patch.evaluate(*at.T)
    made, error = fit.approximate_scattered(points, degrees=(3, 2), parameters=at, knots=patch.knots, corrections=0)
    size = np.abs(patch.points).max()
    np.testing.assert_allclose(made.points, patch.points, rtol=0, atol=1e-11 * size)
    assert error < 1e-12 * size


def test_weights_draw_the_patch():
    points = cloud(400, 0.05)
    heavy = np.ones(400)
    heavy[7] = 1e6
    made = fit.approximate_scattered(points, 5, weights=heavy, corrections=0).value
    assert made.nearest(points[7]).distances < 1e-3
    same = fit.approximate_scattered(points, 5, weights=np.full(400, 1e200), corrections=0).value
    np.testing.assert_allclose(same.points, fit.approximate_scattered(points, 5, corrections=0).value.points, atol=1e-12)


def test_corrections_bring_the_patch_nearer_and_the_error_is_true():
    points = cloud(3000)
    last = np.inf
    for corrections in (0, 8):
        made, error = fit.approximate_scattered(points, (10, 9), corrections=corrections)
        distances = made.nearest(points).distances
        assert error == pytest.approx(distances.max(), rel=1e-9)
        rms = np.sqrt(np.mean(distances**2))
        assert rms <= last
        last = rms


@pytest.mark.parametrize('tolerance', [3e-2, 1e-3])
def test_scattered_points_within_a_tolerance(tolerance):
    points = cloud(3000)
    made, error = fit.approximate_scattered(points, tolerance=tolerance)
    assert made.nearest(points).distances.max() <= error * (1 + 1e-9) <= tolerance * (1 + 1e-9)


def test_a_tolerance_that_only_more_control_points_than_points_could_keep():
    points = np.random.default_rng(8).uniform(0, 1, (60, 3)) * [1, 1, 0.1]
    with pytest.raises(sc.ToleranceNotReached, match="control points, and of .* do not determine control point"):
        fit.approximate_scattered(points, tolerance=1e-6)


def test_smoothing_fills_a_hole():
    points = cloud(3000)
    points = points[np.hypot(points[:, 0] - 2, points[:, 1] - 1.5) > 0.8]
    with pytest.raises(sc.InvalidShape, match="do not determine control point"):
        fit.approximate_scattered(points, 25)
    made, error = fit.approximate_scattered(points, 25, smoothing=1e-9)
    assert error < 0.02 and abs(made.nearest([2, 1.5, 0.5 * np.sin(2.5) * np.cos(2)]).distances) < 0.1


def near_an_empty_span(inside, axis):
    """Of degree 3, with one point as far inside the last span, away from the others' plane."""
    u, v = np.random.default_rng(5).uniform(0, 1, (2, 400)) * [[0.9], [1.0]]
    points = np.stack([u, v, 2 * u - v], -1)
    points = np.vstack([points, [[0.9, y, 1.8 - y] for y in (0, 1)], [[0.9 + inside, y, 3] for y in np.linspace(0, 1, 30)]])
    knots = [[0] * 4 + [0.3, 0.6, 0.9] + [1] * 4, [0] * 4 + [1] * 4][::1 if axis == 0 else -1]
    return points, dict(knots=knots, parameters=points[:, [axis, 1 - axis]], corrections=0)


@pytest.mark.parametrize('axis', [0, 1])
def test_points_that_hardly_determine_a_control_point_are_refused(axis):
    """It was 1e9 times as far away as they are from each other, and the patch with it."""
    points, options = near_an_empty_span(1e-4, axis)
    place = (r"\(6, [0-3]\)", r"\([0-3], 6\)")[axis]
    with pytest.raises(sc.InvalidShape, match=f"^the points hardly determine control point {place}, which would lie more than a "
                                              "million times as far away as they do: fewer control points or smoothing are"):
        fit.approximate_scattered(points, **options)
    with pytest.raises(sc.InvalidShape, match="or more smoothing are needed$"):
        fit.approximate_scattered(points, **options, smoothing=1e-30)
    made = fit.approximate_scattered(points, **options, smoothing=1e-9).value
    assert np.abs(made.points).max() < 100
    points, options = near_an_empty_span(0.05, axis)
    made, error = fit.approximate_scattered(points, **options)
    assert error < 1 and error == pytest.approx(made.nearest(points).distances.max(), rel=1e-9)


def hardly_enough_points(rng):
    """Points, their places, degrees and counts: of as many control points as some parts of the points can tell, or more."""
    degrees, more = rng.integers(3, 7, 2), rng.integers(3, 8, 2)
    points = rng.uniform(0, 1, (int(rng.integers(100, 400)), 3)) * [1, 1, 0.2]
    at = points[:, :2]**rng.integers(1, 4)
    at = (at - at.min(axis=0)) / np.ptp(at, axis=0)
    return points, at, tuple(map(int, degrees)), tuple(map(int, degrees + 1 + more))


@pytest.mark.parametrize('seed', [*range(30), 1390])
def test_what_is_not_refused_is_nearest_in_the_sum_of_squares(seed):
    """No control points of the same net, by a dense solver, bring the points nearer: with those a million times as far away
    they missed the points by 2e10 times as much."""
    points, at, degrees, counts = hardly_enough_points(np.random.default_rng(seed))
    try:
        made = fit.approximate_scattered(points, counts, degrees, parameters=at, corrections=0).value
    except sc.InvalidShape as refused:
        assert "determine" in str(refused) and str(refused).endswith("smoothing are needed")
        return
    rows = [np.stack([sc.basis.KnotVector(degree, knots).function(i, places) for i in range(count)], -1)
            for degree, knots, count, places in zip(degrees, made.knots, counts, at.T)]
    table = np.einsum('ni,nj->nij', *rows).reshape(len(points), -1)
    best = points - table @ np.linalg.lstsq(table, points, rcond=1e-15)[0]
    left = points - made.evaluate(*at.T)
    assert np.linalg.norm(left) <= np.linalg.norm(best) * (1 + 1e-6)


def test_a_patch_that_swings_too_widely_to_tell_its_nearest_points_is_refused_as_one():
    points, at, degrees, counts = hardly_enough_points(np.random.Generator(np.random.PCG64([2, 8])))
    with pytest.raises(sc.InvalidShape, match="^the points hardly determine the patch, which swings too widely .* are needed$"):
        fit.approximate_scattered(points, counts, degrees, parameters=at, corrections=0)
    assert fit.approximate_scattered(points, counts, degrees, parameters=at, corrections=0, smoothing=1e-8).error < 0.2


@pytest.mark.parametrize('step, place', [(1, r"\(8, [01]\)"), (-1, r"\([01], 8\)")])
def test_a_control_point_that_is_not_determined_is_named_by_u_and_v(step, place):
    at = RNG.uniform(0, 1, (400, 2)) * (0.75, 1)
    knots = [[0] * 4 + [0.2, 0.4, 0.5, 0.6, 0.8] + [1] * 4, [0, 0, 1, 1]]
    with pytest.raises(sc.InvalidShape, match="do not determine control point " + place):
        fit.approximate_scattered(wave(*at.T), degrees=(3, 1)[::step], knots=knots[::step], parameters=at[:, ::step])


@pytest.mark.parametrize('turn', np.linspace(0, 2, 7))
def test_the_first_parameters_lie_in_the_least_rectangle(turn):
    points = RNG.uniform(-1, 1, (500, 2)) * (3, 1)
    points[:4] = [[-3, -1], [3, -1], [3, 1], [-3, 1]]
    c, s = np.cos(turn), np.sin(turn)
    made = fit.approximate_scattered(points @ [[c, s], [-s, c]], (4, 4), corrections=0).value
    assert made.domain[0] == (0, 1) and made.domain[1] == pytest.approx((0, 1 / 3), abs=1e-12)
    corner = made.points[0, 0]
    assert np.cross(made.points[-1, 0] - corner, made.points[0, -1] - corner)[2] > 0


def test_both_directions_are_alike_and_long_nets_are_ordinary():
    points = cloud(3000, 0.01)
    at = points[:, :2] / (4, 3)
    at = (at - at.min(axis=0)) / np.ptp(at, axis=0)
    for smoothing in (0.0, 1e-7):
        one, other = (fit.approximate_scattered(points, counts, (3, 2)[::step], parameters=at[:, ::step], smoothing=smoothing,
                                                corrections=0).value for counts, step in (((14, 6), 1), ((6, 14), -1)))
        np.testing.assert_allclose(other.points.transpose(1, 0, 2), one.points, rtol=0, atol=1e-9)
    long = fit.approximate_scattered(points, (5, 2000), smoothing=1e-9, corrections=0).value
    assert long.points.shape == (5, 2000, 3)


@pytest.mark.parametrize('degree', [2, 3, 5])
@pytest.mark.parametrize('gap', 10.0**-np.arange(1, 13))
def test_smoothing_leaves_a_plane_beside_short_spans(degree, gap):
    """It has no energy, however large that is of what bends there: it was moved by 1e-5 where spans were 1e-4 long."""
    u, v = RNG.uniform(0, 1, (2, 2000))
    points = np.stack([u, v, 2 * u - v], -1)
    knots = np.r_[[0.0] * (degree + 1), 0.3, 0.3 + gap, 0.6, [1.0] * (degree + 1)]
    for weight in (1e-6, 1e-3, 1.0):
        try:
            made = fit.approximate_scattered(points, None, degree, parameters=np.stack([u, v], -1), knots=(knots, knots),
                                             smoothing=weight, corrections=0).value
        except sc.InvalidShape as refused:
            assert "less smoothing" in str(refused) and weight / gap**3 > 1e8
        else:
            np.testing.assert_allclose(made.evaluate(u, v), points, rtol=0, atol=1e-5 if weight / gap**3 > 1e10 else 1e-11)


def test_points_in_one_line_of_parameters_are_refused_with_smoothing_too():
    t = np.linspace(0, 1, 50)
    points = np.stack([t, t, np.sin(t)], -1)
    with pytest.raises(sc.InvalidShape, match="more than one line"):
        fit.approximate_scattered(points, 6, parameters=np.stack([t, t], -1), smoothing=1e-6)


def test_nets_beyond_all_memory_are_refused():
    for counts, degrees in (((3000, 3000), 3), ((100_000, 100_000), 1), (256, 255)):
        with pytest.raises(sc.InvalidShape, match="is too large for scattered points"):
            fit.approximate_scattered(cloud(100), counts, degrees, smoothing=1e-6)


def test_what_is_refused():
    points = cloud(100)
    for arguments, message in ((dict(), "counts, knots or tolerance are needed"), (dict(counts=3), "^along u: count = 3 control points are fewer than the 4"),
                               (dict(counts=(9, 3)), "^along v: count = 3"), (dict(counts=(3, 9), tolerance=100), "^along u: count = 3"),
                               (dict(counts=(9, 4), degrees=(3, 4), tolerance=100), "^along v: count = 4 control points are fewer"),
                               (dict(counts=8, degrees=0), "degree = 0"), (dict(tolerance=1, degrees=(3, -2)), "^along v: degree = -2"), (dict(counts=8, smoothing=-1), "smoothing = -1"),
                               (dict(counts=8, weights=[1.0]), "weights has 1 values"), (dict(tolerance=0.0), "tolerance = 0"),
                               (dict(counts=8, corrections=-1), "corrections = -1"),
                               (dict(counts=8, parameters=points), r"parameters has shape \(100, 3\)"),
                               (dict(counts=8, parameters=np.full((100, 2), np.nan)), "not finite"),
                               (dict(counts=8, parameters=np.ones((100, 2))), "the same along u"),
                               (dict(knots=([0, 0, 1, 1], [0, 0, 1, 1]), degrees=1), "belong to parameters")):
        with pytest.raises(sc.InvalidShape, match=message):
            fit.approximate_scattered(points, **arguments)
    with pytest.raises(sc.InvalidShape, match="on a line"):
        fit.approximate_scattered(np.outer(np.linspace(0, 1, 50), [1, 2, 3]), 4)
    with pytest.raises(sc.InvalidShape, match="on a line"):
        fit.approximate_scattered(np.ones((50, 3)), 4)
    with pytest.raises(sc.InvalidShape, match="at least 3"):
        fit.approximate_scattered(points[:2], 4)
    with pytest.raises(sc.InvalidShape, match="less smoothing, fewer control points or knots farther from each other"):
        fit.approximate_scattered(points, 5, smoothing=1e20)
    with pytest.raises(sc.ToleranceNotReached, match="control points and this much smoothing within"):
        fit.approximate_scattered(points, (5, 6), tolerance=1e-3, smoothing=1.0)
    points[3, 1] = np.nan
    with pytest.raises(sc.InvalidShape, match=r"points\[3\]"):
        fit.approximate_scattered(points, 4)
    grid = wave(*np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 8), indexing='ij'))
    with pytest.raises(sc.ToleranceNotReached, match="by 9 x 8 control points and this much smoothing within"):
        fit.approximate_patch(grid, tolerance=1e-3, smoothing=(0, 1e3))
    for arguments, message in ((dict(), "counts, knots or tolerance"), (dict(counts=(4, 9)), "along v: count = 9 control points are more"),
                               (dict(counts=(4, 3)), "^along v: count = 3 control points are fewer than the 4 that degree 3"),
                               (dict(counts=(3, 4), tolerance=100), "^along u: count = 3 control points are fewer than the 4"),
                               (dict(counts=(4, 2), tolerance=100, closed=True), "^along v: count = 2 .* the 3 that degree 3 needs"),
                               (dict(counts=5, degrees=(3, 0)), "along v: degree = 0"), (dict(tolerance=-1), "tolerance = -1"),
                               (dict(counts=5, smoothing=(0, -1)), "along v: smoothing = -1"),
                               (dict(counts=5, smoothing=np.nan), "smoothing = nan"),
                               (dict(counts=5, smoothing=(0, 1e25), fixed_ends=False), "^along v: beside .* less smoothing are"),
                               (dict(counts=5, parameters=(np.zeros(9), 'chordal')), "along u: parameters"),
                               (dict(counts=5, weights=(np.ones(8), None)), "^along u: weights has 8 values for 9 points"),
                               (dict(counts=5, weights=(None, -np.ones(8))), r"^along v: weights\[0\] = -1"),
                               (dict(points=grid[:3], tolerance=0.1), "^along u: 3 points are too few for degree 3, which needs"),
                               (dict(points=grid[:, :3], counts=4), "^along v: 3 points are too few for degree 3, which needs")):
        with pytest.raises(sc.InvalidShape, match=message):
            fit.approximate_patch(**{'points': grid, **arguments})


@pytest.mark.parametrize('which', ['u', 'v', 'uv'])
def test_weights_of_rows_are_those_of_their_points(which):
    """Their products, in the whole sum of squares, by a dense solver and as weights of scattered points."""
    places = [np.sort(RNG.uniform(0, 1, count)) for count in (14, 11)]
    grid = wave(*np.meshgrid(*places, indexing='ij')) + 0.1 * RNG.standard_normal((14, 11, 3))
    weights = [10.0**RNG.uniform(-2, 2, count) if axis in which else None for axis, count in zip('uv', (14, 11))]
    made, error = fit.approximate_patch(grid, (6, 5), (3, 2), places, weights=tuple(weights), fixed_ends=False)
    rows = [np.stack([sc.basis.KnotVector(degree, knots).function(i, at) for i in range(count)], -1)
            for degree, knots, count, at in zip((3, 2), made.knots, (6, 5), places)]
    table = np.einsum('ai,bj->abij', *rows).reshape(14 * 11, -1)
    of_points = np.outer(*(np.ones(count) if w is None else w for w, count in zip(weights, (14, 11)))).ravel()
    root = np.sqrt(of_points)[:, None]
    wanted = np.linalg.lstsq(table * root, grid.reshape(-1, 3) * root, rcond=None)[0]
    np.testing.assert_allclose(made.points.reshape(-1, 3), wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())
    assert error == pytest.approx(np.linalg.norm(made.evaluate_grid(*places) - grid, axis=-1).max(), rel=1e-9)
    assert np.abs(made.points - fit.approximate_patch(grid, (6, 5), (3, 2), places, fixed_ends=False).value.points).max() > 1e-3
    at = np.stack(np.meshgrid(*places, indexing='ij'), -1).reshape(-1, 2)
    same = fit.approximate_scattered(grid.reshape(-1, 3), None, (3, 2), parameters=at, knots=made.knots, weights=of_points,
                                     corrections=0).value
    np.testing.assert_allclose(same.points, made.points, rtol=0, atol=1e-9 * np.abs(wanted).max())


def test_with_a_tolerance_counts_are_the_most_and_may_be_above_the_points():
    grid = wave(*np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 8), indexing='ij'))
    few = fit.approximate_patch(grid, tolerance=0.05)
    assert few.error <= 0.05 and fit.approximate_patch(grid, (100, 50), tolerance=0.05).value == few.value


def with_a_gap(value):
    rows = wave(*np.meshgrid(np.linspace(0, 1, 6), np.linspace(0, 1, 5), indexing='ij')).tolist()
    rows[1][2] = value
    return rows


@pytest.mark.parametrize('make', [fit.interpolate_patch, lambda points: fit.approximate_patch(points, 4)])
@pytest.mark.parametrize('points, message', [
    (with_a_gap(None), r"points\[1, 2\] is missing"),
    (with_a_gap([0, 1]), r"points\[1, 2\] = \[0, 1\] has 2 values, the rows before have 3"),
    (with_a_gap([0, 1, None]), r"points\[1, 2, 2\] = None is not a real number"),
    (with_a_gap([0, np.nan, 1]), r"points\[1, 2\]\.y = nan is not finite"),
    ([*with_a_gap([0, 1, 2])[:3], None, *with_a_gap([0, 1, 2])[3:]], r"points\[3\] is missing"),
    ([*with_a_gap([0, 1, 2])[:3], with_a_gap(0)[0][:4]], r"points\[3\] = .* has 4 values, the rows before have 5"),
])
def test_a_grid_with_a_missing_point_says_which(make, points, message):
    with pytest.raises((sc.InvalidShape, TypeError), match=message):
        make(points)


@pytest.mark.parametrize('make', [fit.interpolate_patch, lambda grid, **how: fit.approximate_patch(grid, 5, **how)])
def test_grids_on_a_line_with_rows_twice_and_with_parameters_that_fall(make):
    i, j = np.meshgrid(np.arange(9.0), np.arange(9.0), indexing='ij')
    on_a_line = (i + j)[..., None] * (1.0, 2.0, 3.0)
    made = make(on_a_line)
    assert made.error < 1e-13 and np.linalg.matrix_rank(made.value.points.reshape(-1, 3), tol=1e-9) == 1
    plane = np.stack([i, j, 0 * i], -1)
    with pytest.raises(sc.InvalidShape, match="points along u: line 4 is too close to line 3"):
        make(plane[np.r_[:4, 3:8]])
    with pytest.raises(sc.InvalidShape, match=r"along u: parameters\[3\] = 2 does not increase from 3"):
        make(plane, parameters=([0, 1, 3, 2, 4, 5, 6, 7, 8], 'uniform'))
