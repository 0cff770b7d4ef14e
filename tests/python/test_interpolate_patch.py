"""Patches through grids: against curves line by line, dense tensor solutions of scipy, what was sampled, closed forms."""

import time

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit

RNG = np.random.default_rng(29)


def sheet(rows, columns, dimensions=3):
    u, v = np.meshgrid(np.arange(rows), np.arange(columns), indexing='ij')
    grid = np.stack([u, v, np.sin(0.9 * u) * np.cos(0.7 * v)], -1) + RNG.uniform(-0.2, 0.2, (rows, columns, 3))
    return grid[..., :dimensions]


def steps(count, closed=False):
    return np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, count if closed else count - 1))])


def distance(patch, u, v, grid):
    return np.abs(patch.evaluate_grid(u, v)[..., :grid.shape[-1]] - grid).max()


@pytest.mark.parametrize('closed', [(False, False), (True, False), (False, True), (True, True)])
@pytest.mark.parametrize('degrees', [(p, 10 - p) for p in range(1, 10)])
def test_it_passes_through_its_points(degrees, closed):
    grid, u, v = sheet(14, 17), steps(14, closed[0]), steps(17, closed[1])
    patch, error = fit.interpolate_patch(grid, degrees, (u, v), closed=closed)
    assert (patch.degree, patch.periodic, patch.points.shape) == (degrees, closed, (14, 17, 3))
    assert error < 1e-10
    assert distance(patch, u[:14], v[:17], grid) <= error + 1e-14 * np.abs(patch.points).max()


@pytest.mark.parametrize('ends', [('averaged', 'natural'), ('natural', 'not_a_knot'), ('natural', 'natural')])
@pytest.mark.parametrize('degrees', [(3, 5), (5, 3), (7, 3)])
def test_its_control_points_are_curves_through_those_of_curves(degrees, ends):
    grid, u, v = sheet(12, 13), steps(12), steps(13)
    patch = fit.interpolate_patch(grid, degrees, (u, v), ends=ends).value
    along_v = np.array([fit.interpolate(line, degrees[1], v, ends=ends[1]).value.points for line in grid])
    both = [fit.interpolate(along_v[:, j], degrees[0], u, ends=ends[0]).value for j in range(along_v.shape[1])]
    wanted = np.stack([curve.points for curve in both], 1)
    np.testing.assert_allclose(patch.points, wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())
    np.testing.assert_array_equal(patch.knots[0], both[0].knots)


@pytest.mark.parametrize('degrees', [(1, 3), (2, 2), (3, 3), (4, 5)])
@pytest.mark.parametrize('ends', ['averaged', 'not_a_knot'])
def test_as_scipy(degrees, ends):
    interpolate = pytest.importorskip('scipy.interpolate', reason='python3-scipy is not installed')
    grid, u, v = sheet(20, 15), steps(20), steps(15)
    patch = fit.interpolate_patch(grid, degrees, (u, v), ends=ends).value
    along_u = interpolate.make_interp_spline(u, grid, degrees[0], t=patch.knots[0])
    net = interpolate.make_interp_spline(v, along_u.c.swapaxes(0, 1), degrees[1], t=patch.knots[1]).c.swapaxes(0, 1)
    np.testing.assert_allclose(patch.points, net, rtol=0, atol=1e-12 * np.abs(net).max())
    if degrees == (3, 3) and ends == 'not_a_knot':
        other = interpolate.RectBivariateSpline(u, v, grid[..., 2], kx=3, ky=3, s=0)
        at = np.linspace(0, u[-1], 40), np.linspace(0, v[-1], 50)
        np.testing.assert_allclose(patch.evaluate_grid(*at)[..., 2], other(*at), rtol=0, atol=1e-12)


def test_a_patch_that_was_sampled_comes_back():
    def knots(degree, count):
        return np.concatenate([np.zeros(degree + 1), np.sort(RNG.uniform(0, 1, count - degree - 1)), np.ones(degree + 1)])

    for degrees in ((1, 2), (2, 3), (3, 3), (5, 4)):
        chains = knots(degrees[0], 11), knots(degrees[1], 9)
        shape = sc.NurbsPatch(degrees, chains, RNG.normal(size=(11, 9, 3)))
        at = [np.array([chain[i + 1:i + p + 1].mean() for i in range(len(chain) - p - 1)])
              for p, chain in zip(degrees, chains)]
        patch = fit.interpolate_patch(shape.evaluate_grid(*at), degrees, tuple(at), chains).value
        np.testing.assert_allclose(patch.points, shape.points, rtol=0, atol=1e-9)


def torus(count):
    angles = np.arange(count) * 2 * np.pi / count
    radius = 3 + np.cos(angles)[None, :]
    return np.stack([radius * np.cos(angles)[:, None], radius * np.sin(angles)[:, None],
                     np.broadcast_to(np.sin(angles), (count, count))], -1)


def test_a_torus_closes_in_both_directions():
    patch, error = fit.interpolate_patch(torus(48), parameters='uniform', closed=True)
    assert patch.periodic == (True, True)
    assert error < 1e-14
    x, y, z = np.moveaxis(patch.evaluate_grid(np.linspace(0, 48, 101), np.linspace(0, 48, 103)), -1, 0)
    np.testing.assert_allclose(np.hypot(np.hypot(x, y) - 3, z), 1, rtol=0, atol=2e-5)
    radii = np.linalg.norm(patch.points[..., :2], axis=-1)
    np.testing.assert_allclose(radii, np.broadcast_to(radii[:1], radii.shape), rtol=0, atol=1e-13)


@pytest.mark.parametrize('kind, power', [('chordal', 1.0), ('centripetal', 0.5)])
@pytest.mark.parametrize('closed', [False, True])
def test_parameters_are_means_of_the_rows(kind, power, closed):
    grid = sheet(9, 18)
    grid[:, 3] = grid[0, 3]
    ends = np.concatenate([grid, grid[:1]]) if closed else grid
    lengths = np.linalg.norm(np.diff(ends, axis=0), axis=-1)**power
    lengths = np.delete(lengths, 3, axis=1)
    shares = (lengths / lengths.sum(0)).mean(1)
    u = np.concatenate([[0.0], np.cumsum(shares)]) * lengths.sum(0).mean()
    patch = fit.interpolate_patch(grid, parameters=(kind, 'uniform'), closed=(closed, False)).value
    wanted = fit.interpolate_patch(grid, parameters=(u, np.arange(18.0)), closed=(closed, False)).value
    np.testing.assert_allclose(patch.knots[0], wanted.knots[0], rtol=1e-13)
    np.testing.assert_allclose(patch.points, wanted.points, rtol=0, atol=1e-11)


@pytest.mark.parametrize('kind', ['uniform', 'centripetal', 'chordal'])
def test_a_moved_curve_sweeps_its_own_parameters(kind):
    line = np.cumsum(RNG.uniform(0.2, 1, (30, 3)), 0)
    patch = fit.interpolate_patch(line[:, None] + np.arange(5.0)[:, None] * [0, 0, 2], parameters=kind).value
    curve = fit.interpolate(line, parameters=kind).value
    np.testing.assert_allclose(patch.knots[0], curve.knots, rtol=1e-13)
    np.testing.assert_allclose(patch.points[:, 0], curve.points, rtol=0, atol=1e-11)


def test_poles_are_no_obstacle():
    around, up = np.linspace(0, 2 * np.pi, 25)[:-1], np.linspace(-np.pi / 2, np.pi / 2, 13)
    ball = np.stack([np.cos(up) * np.cos(around)[:, None], np.cos(up) * np.sin(around)[:, None],
                     np.broadcast_to(np.sin(up), (24, 13))], -1)
    ball[:, 0], ball[:, -1] = [0, 0, -1], [0, 0, 1]
    patch, error = fit.interpolate_patch(ball, closed=(True, False))
    assert error < 1e-14
    radii = np.linalg.norm(patch.evaluate_grid(np.linspace(*patch.domain[0], 60), np.linspace(*patch.domain[1], 60)), axis=-1)
    np.testing.assert_allclose(radii, 1, atol=1e-3)


@pytest.mark.parametrize('closed', [False, True])
@pytest.mark.parametrize('scale', [1e-150, 1e-30, 1e30, 1e150])
def test_it_does_not_depend_on_the_scale(scale, closed):
    grid, exact = sheet(9, 8), 2.0**round(np.log2(scale))
    for parameters in ('chordal', 'uniform'):
        near, far = (fit.interpolate_patch(grid * factor, parameters=parameters, closed=closed).value
                     for factor in (1.0, exact))
        np.testing.assert_allclose(far.points / exact, near.points, rtol=0, atol=1e-12)
    u, v = steps(9, closed), steps(8, closed)
    near, far = (fit.interpolate_patch(grid, 3, (u * factor, v / factor), closed=closed).value for factor in (1.0, exact))
    np.testing.assert_allclose(far.points, near.points, rtol=0, atol=1e-12)


def test_far_from_the_origin_points_keep_their_digits():
    assert fit.interpolate_patch(sheet(20, 20) + 1e8).error < 1e-7


def test_two_columns_lie_in_the_plane():
    patch, error = fit.interpolate_patch(sheet(6, 7, 2))
    assert error < 1e-13
    assert not patch.points[..., 2].any()


def test_many_points_take_linear_time():
    def seconds(count):
        grid = torus(count)
        start = time.process_time()
        patch, error = fit.interpolate_patch(grid, parameters='uniform')
        assert error < 1e-13
        return time.process_time() - start

    few, many = min(seconds(250) for _ in range(3)), seconds(1000)
    assert many < 16 * 5 * few


def test_one_answer_of_cancel_ends_it():
    with pytest.raises(sc.Cancelled):
        fit.interpolate_patch(torus(700), cancel=lambda: True)


MISSING = sheet(6, 5)
MISSING[3, 2, 1] = np.nan
DOUBLED = sheet(6, 5)
DOUBLED[3] = DOUBLED[2]

BAD = [
    (dict(points=MISSING), r'points\[3, 2\]\.y = nan is not finite'),
    (dict(points=sheet(3, 6)), 'along u: 3 conditions are too few for degree 3'),
    (dict(points=sheet(6, 1)), 'along v: points has 1 rows, at least 2'),
    (dict(points=sheet(6, 5)[0]), r'\(nu, nv, 2 or 3\)'),
    (dict(points=np.zeros((0, 5, 3))), '0 by 5'),
    (dict(points=np.zeros((6, 5, 4))), 'rows of 2 or 3'),
    (dict(points=np.zeros((6, 5, 3))), 'along u coincide in every line'),
    (dict(points=np.broadcast_to(sheet(6, 1), (6, 5, 3))), 'along v coincide in every line'),
    (dict(points=DOUBLED), 'along u: line 3 is too close to line 2'),
    (dict(points=np.sign(sheet(6, 5) - 2) * 1.7e308), 'far apart along u'),
    (dict(degrees=(3, 0)), 'along v: degree = 0'),
    (dict(degrees=300), 'along u: degree = 300'),
    (dict(degrees=(3, 4), closed=True, points=sheet(6, 3)), 'along v: 3 conditions are too few'),
    (dict(parameters=(range(6), [0, 1, 1, 2, 3])), r'along v: parameters\[2\]'),
    (dict(parameters=(range(6), [0, 1, 2, 3, np.inf])), 'along v: parameters'),
    (dict(parameters=(range(6), range(6))), 'along v: parameters has 6 values, 5'),
    (dict(parameters='chord'), "parameters = 'chord'"),
    (dict(parameters='uniform', knots=([0] * 4 + [1] * 4, None)), 'along u: .*4 control points; 6 conditions'),
    (dict(parameters='uniform', knots=([0, 0, 0, 0, 0.1, 0.2, 5, 5, 5, 5], None)), 'along u: .*too many lie between'),
    (dict(ends='free'), "ends = 'free'"),
    (dict(ends='natural', degrees=(3, 2)), 'along v: natural ends need an odd degree'),
    (dict(ends='natural', closed=(False, True)), 'along v: a closed'),
    (dict(points=RNG.normal(size=(300, 5, 3)), degrees=(100, 3)), 'rounding leaves'),
]


@pytest.mark.parametrize('wrong, sentence', BAD, ids=lambda value: value if isinstance(value, str) else '')
def test_what_cannot_be_is_refused(wrong, sentence):
    wrong = {'points': sheet(6, 5), **wrong}
    with pytest.raises(sc.InvalidShape, match=sentence):
        fit.interpolate_patch(**wrong)


@pytest.mark.parametrize('wrong, sentence', [
    (dict(degrees=(3, 3, 3)), 'degrees .* pair'), (dict(degrees=2.5), 'degrees'), (dict(closed=1), 'closed'),
    (dict(knots=[0, 0, 1, 1]), 'knots .* pair'), (dict(parameters=3), 'parameters'), (dict(cancel=3), 'cancel'),
    (dict(points=None), 'points'),
])
def test_wrong_types_are_named(wrong, sentence):
    wrong = {'points': sheet(6, 5), **wrong}
    with pytest.raises((TypeError, sc.InvalidShape), match=sentence):
        fit.interpolate_patch(**wrong)
