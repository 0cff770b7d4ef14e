"""Faired patches: borders stay, the tolerance is kept and used, and what moves balances the energy of a thin plate."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

RNG = np.random.default_rng(78)
PLAIN, PERIODIC = 'plain', 'periodic'


def knots_of(kind, degree, count):
    if kind == PERIODIC:
        return np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, count))])
    if kind == 'unclamped':
        return np.cumsum(RNG.uniform(0.5, 1.5, count + degree + 1))
    inner = np.sort(RNG.uniform(0.05, 0.95, count - degree - 1))
    if kind == 'multiple' and len(inner) > 1:
        inner[1] = inner[0]
    return np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])


def patch_of(degrees=(3, 3), counts=(9, 8), kinds=(PLAIN, PLAIN), rational=False, scale=1.0, offset=0.0):
    u, v = (np.linspace(0, 1, count) for count in counts)
    if PERIODIC in kinds:
        turn = kinds.index(PERIODIC)
        angle = 2 * np.pi * np.arange(counts[turn]) / counts[turn]
        angles = angle[:, None] if turn == 0 else angle[None, :]
        other = v[None, :] if turn == 0 else u[:, None]
        points = np.stack(np.broadcast_arrays((2 + 0.5 * other) * np.cos(angles), (2 + 0.5 * other) * np.sin(angles),
                                              3 * other * np.ones_like(angles)), -1)
    else:
        u, v = np.meshgrid(u, v, indexing='ij')
        points = np.stack([4 * u, 3 * v, 0.3 * np.sin(5 * u) * np.cos(4 * v)], -1)
    points = points + 0.05 * RNG.standard_normal(points.shape)
    weights = RNG.uniform(0.5, 2, counts) if rational else None
    knots = tuple(knots_of(*each) for each in zip(kinds, degrees, counts))
    return sc.NurbsPatch(degrees, knots, scale * (points + offset), weights, periodic=tuple(kind == PERIODIC for kind in kinds))


def dense(patch, count=60):
    return [np.clip(np.linspace(*domain, count), *domain) for domain in patch.domain]


def farthest(a, b):
    return np.linalg.norm(a.evaluate_grid(*dense(a)) - b.evaluate_grid(*dense(a)), axis=-1).max()


def functions(degree, knots, periodic, count):
    """(nodes, count) values, first and second derivatives of the basis functions at Gauss nodes; the nodes' weights."""
    unit = [sc.NurbsCurve(degree, knots, np.stack([row, 0 * row, 0 * row], -1), periodic=periodic) for row in np.eye(count)]
    breaks = np.unique(np.clip(knots, *unit[0].domain))
    at, weights = np.polynomial.legendre.leggauss(degree + 2)
    nodes = np.concatenate([a + (b - a) * (at + 1) / 2 for a, b in zip(breaks, breaks[1:])])
    shares = np.concatenate([(b - a) * weights / 2 for a, b in zip(breaks, breaks[1:])])
    values = np.stack([curve.derivatives(nodes, 2)[:, :, 0] for curve in unit], -1)
    return values.transpose(1, 0, 2), shares


def plate(patch):
    """The mass and the energy of a thin plate as long and wide as the net in the mean, dense, by quadrature."""
    net = patch.points
    grams = []
    for axis in range(2):
        closed = np.concatenate([net, net.take([0], axis)], axis) if patch.periodic[axis] else net
        length = np.linalg.norm(np.diff(closed, axis=axis), axis=-1).sum(axis).mean()
        values, shares = functions(patch.degree[axis], patch.knots[axis], patch.periodic[axis], net.shape[axis])
        stretch = length / np.ptp(patch.domain[axis])
        grams.append([(row.T * shares) @ row * stretch ** (1 - 2 * k) / length for k, row in enumerate(values)])
    (a, b, c), (d, e, f) = grams
    return np.kron(a, d), np.kron(c, d) + 2 * np.kron(b, e) + np.kron(a, f)


def free_of(patch, rows=(1, 1)):
    """Which control points may move."""
    free = np.ones(patch.points.shape[:2], bool)
    for axis, row in enumerate(rows):
        if not patch.periodic[axis]:
            take = [slice(None)] * 2
            for end in (slice(None, row), slice(-row, None)):
                take[axis] = end
                free[tuple(take)] = False
    return free


KINDS = [(PLAIN, PLAIN), (PERIODIC, PLAIN), (PLAIN, PERIODIC), (PERIODIC, PERIODIC), ('unclamped', PLAIN), ('multiple', 'unclamped')]


@pytest.mark.parametrize('kinds', KINDS)
@pytest.mark.parametrize('rational', [False, True])
@pytest.mark.parametrize('scale', [1.0, 1e-140, 1e140])
def test_it_bends_less_within_the_tolerance(kinds, rational, scale):
    patch = patch_of(kinds=kinds, rational=rational, scale=scale)
    _, energy = plate(patch.with_points(patch.points / scale))
    bent = [np.einsum('ic,ij,jc', net, energy, net) for net in [(patch.points / scale).reshape(-1, 3)]]
    for part in (1e-4, 1e-3, 1e-2):
        tolerance = part * np.ptp(patch.points)
        made, error = patch.fair(tolerance)
        assert error <= tolerance and farthest(patch, made) <= error * (1 + 1e-12)
        assert error > 0.5 * tolerance                        # it is used
        for old, new in zip((*patch.knots, patch.weights), (*made.knots, made.weights)):
            np.testing.assert_array_equal(new, old)
        net = (made.points / scale).reshape(-1, 3)
        bent.append(np.einsum('ic,ij,jc', net, energy, net))
        for side, axis in zip(('u0', 'u1', 'v0', 'v1'), (0, 0, 1, 1)):
            if patch.periodic[axis]:
                continue
            at = patch.domain[axis][int(side[1])]
            borders = [shape.isocurve('uv'[axis], at) for shape in (patch, made)]
            along = dense(patch)[1 - axis]
            np.testing.assert_allclose(borders[1].evaluate(along), borders[0].evaluate(along), rtol=0,
                                       atol=1e-13 * np.abs(patch.points).max())
    assert np.all(np.diff(bent) < 0)


@pytest.mark.parametrize('kinds', [kinds for kinds in KINDS if 'unclamped' not in kinds])
@pytest.mark.parametrize('degrees, counts', [((3, 3), (9, 8)), ((2, 4), (6, 11)), ((1, 3), (5, 7)), ((9, 2), (13, 5)),
                                             ((5, 5), (6, 6))])
def test_what_moves_balances_the_energy(kinds, degrees, counts):
    """An independent second implementation: dense matrices by Gauss and Legendre, from curves with one point that is not 0."""
    patch = patch_of(degrees, counts, kinds)
    made = patch.fair(0.02).value
    mass, energy = plate(patch)
    free = free_of(patch).ravel()
    moved = (mass @ (made.points - patch.points).reshape(-1, 3))[free]
    pull = -(energy @ made.points.reshape(-1, 3))[free]
    if not free.any() or not moved.any():
        assert made == patch
        return
    factor = np.vdot(pull, moved) / np.vdot(pull, pull)
    assert factor > 0
    np.testing.assert_allclose(moved, factor * pull, rtol=0, atol=1e-8 * np.abs(moved).max())


def test_tangents_stay_where_asked():
    patch = patch_of(counts=(10, 9), rational=True)
    for ends, rows in (('points', (1, 1)), ('tangents', (2, 2)), (('points', 'tangents'), (1, 2))):
        made = patch.fair(0.1, ends=ends).value
        moved = np.any(made.points != patch.points, axis=-1)
        np.testing.assert_array_equal(moved, free_of(patch, rows))


def test_where_nothing_may_move_it_stays():
    flat = sc.BezierPatch(RNG.standard_normal((4, 4, 3)))
    made, error = flat.fair(0.1, ends='tangents')
    assert error == 0 and made == flat.to_nurbs()


def plane_on(patch):
    """The control points of a plane whose points are linear in the parameters."""
    u, v = (np.array([np.mean(knots[i + 1:i + 1 + p]) for i in range(len(knots) - p - 1)])
            for p, knots in zip(patch.degree, patch.knots))
    return np.stack(np.broadcast_arrays(4 * u[:, None], 3 * v[None], 1.0 + u[:, None] - v[None]), -1)


@pytest.mark.parametrize('degrees', [(3, 3), (2, 5), (4, 4)])
@pytest.mark.parametrize('near', [1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9])
def test_a_plane_stays_however_near_knots_lie(degrees, near):
    inner = [0.3, 0.3 + near, 0.3 + 2 * near, 0.5, 0.5, 0.8]
    knots = tuple([0.0] * (p + 1) + inner + [1.0] * (p + 1) for p in degrees)
    counts = tuple(len(k) - p - 1 for k, p in zip(knots, degrees))
    patch = sc.NurbsPatch(degrees, knots, np.zeros((*counts, 3)))
    plane = plane_on(patch)
    made, error = patch.with_points(plane).fair(0.1)
    assert error < 1e-11 and np.abs(made.points - plane).max() < 1e-11


def test_a_plane_stays_and_noise_goes():
    patch = patch_of(counts=(20, 20))
    plane = plane_on(patch)
    made, error = patch.with_points(plane).fair(0.1)
    assert error < 1e-14 and np.abs(made.points - plane).max() < 1e-14
    noise = np.zeros_like(plane)
    noise[1:-1, 1:-1] = 1e-3 * RNG.standard_normal((18, 18, 3))
    made, error = patch.with_points(plane + noise).fair(1e-2)
    assert np.abs(made.points - plane).max() < 1e-5 < error


@pytest.mark.parametrize('exponent', [-990, 990])
def test_the_same_in_every_size(exponent):
    patch = patch_of(rational=True)
    near = patch.fair(0.05).value
    far = patch.with_points(np.ldexp(patch.points, exponent)).fair(np.ldexp(0.05, exponent)).value
    np.testing.assert_allclose(np.ldexp(far.points, -exponent), near.points, rtol=0, atol=1e-12)


@pytest.mark.parametrize('domain', [1e-150, 1e150, 3.0])
def test_the_same_on_every_domain(domain):
    patch = patch_of()
    wide = sc.NurbsPatch(patch.degree, (patch.knots[0] * domain, patch.knots[1] - 7.0), patch.points)
    np.testing.assert_allclose(wide.fair(0.05).value.points, patch.fair(0.05).value.points, rtol=0, atol=1e-9)


def test_far_from_the_origin():
    patch = patch_of()
    far = patch.with_points(patch.points + 1e6)
    np.testing.assert_allclose(far.fair(0.05).value.points - 1e6, patch.fair(0.05).value.points, rtol=0, atol=1e-6)


@pytest.mark.parametrize('degree', range(1, 10))
def test_every_degree(degree):
    patch = patch_of((degree, max(degree, 2)), (degree + 3, degree + 4))
    made, error = patch.fair(0.03)
    assert error <= 0.03 and farthest(patch, made) <= error * (1 + 1e-12)


def test_every_kind_of_patch():
    torus = build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0)
    hermite = sc.BezierPatch(RNG.standard_normal((4, 4, 3))).to_hermite()
    for patch in (torus, hermite, sc.BezierPatch(RNG.standard_normal((5, 6, 3)))):
        made, error = patch.fair(0.1)
        assert isinstance(made, sc.NurbsPatch) and 0 < error <= 0.1


def test_poles_and_edges_that_are_shared_stay():
    sphere = build.sphere((0, 0, 0), 1.0)
    for ends in ('points', 'tangents'):
        made = sphere.refine('u', [0.1, 0.2]).refine('v', [0.3]).fair(0.05, ends=ends).value
        for axis, domain in zip('uv', made.domain):
            for end in domain:
                if np.ptp(sphere.isocurve(axis, end).points, axis=0).max() < 1e-12:
                    assert np.ptp(made.isocurve(axis, end).points, axis=0).max() < 1e-12


def test_a_net_of_many_points_along_one_side():
    long = patch_of((3, 3), (4000, 5))
    even = np.concatenate([np.zeros(3), np.linspace(0, 1, 3998), np.ones(3)])
    made, error = sc.NurbsPatch((3, 3), (even, long.knots[1]), long.points).fair(0.02)
    assert 0.01 < error <= 0.02


def test_patches_that_cannot_be_faired():
    patch = patch_of()
    for tolerance in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            patch.fair(tolerance)
    with pytest.raises(sc.InvalidShape, match="degree 1 in both"):
        patch_of((1, 1)).fair(0.1)
    for ends in ('x', ('points', 'x')):
        with pytest.raises(sc.InvalidShape, match="none of"):
            patch.fair(0.1, ends=ends)
    with pytest.raises(TypeError):
        patch.fair(0.1, ends=1)
    weights = np.ones((9, 8))
    weights[3, 3] = 0
    with pytest.raises(sc.InvalidShape, match="infinity"):
        sc.NurbsPatch(patch.degree, patch.knots, patch.points, weights).fair(0.1)
    with pytest.raises(sc.InvalidShape, match="degrees are too high"):
        sc.BezierPatch(RNG.standard_normal((256, 4, 3))).fair(0.1)
    with pytest.raises(sc.InvalidShape, match="degrees are too high"):
        sc.BezierPatch(RNG.standard_normal((31, 31, 3))).fair(0.1)
    with pytest.raises(sc.InvalidShape, match="too large to be faired"):
        patch_of((3, 3), (700, 700)).fair(0.1)
    with pytest.raises(sc.Cancelled):
        patch_of((3, 3), (100, 100)).fair(0.1, cancel=lambda: True)
