"""Centroids and second moments of solids: closed forms, an independent rule, and the laws of motions."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

PI = math.pi
UP = (0, 0, 1)
ORIGIN = (0, 0, 0)


def solid(*patches):
    return sc.PatchSet.from_patches(patches)


def disc(radius, height=0.0):
    return build.disc((0, 0, height), UP, radius)


def floor(radius):
    return disc(radius).reversed("v")


def tetrahedron():
    corners = np.array([ORIGIN, (2, 0, 0), (0, 3, 0), (0, 0, 4)], float)
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    return solid(*(sc.BezierPatch([[corners[a], corners[a]], [corners[b], corners[c]]]) for a, b, c in faces))


def ellipsoid():
    ball = solid(build.sphere(ORIGIN, 1.0))
    return ball.with_points(ball.points * [1.0, 2.0, 3.0] + [4.0, 5.0, 6.0])


def closed_forms():
    """Volume, centroid and second moments about it."""
    cone = PI * 9 * 4 / 3
    torus = 2 * PI**2 * 3 * 1
    tilt = np.array([(2, 0, 0), (0, 3, 0), (0, 0, 4)], float)
    simplex = tilt @ (np.eye(3) / 20 - np.ones((3, 3)) / 80) @ tilt.T * 4
    return [
        (solid(build.sphere((1, 2, 3), 2.0)), 32 * PI / 3, (1, 2, 3), np.eye(3) * 128 * PI / 15),
        (solid(build.cylinder(ORIGIN, UP, 2, 3), floor(2), disc(2, 3)), 12 * PI, (0, 0, 1.5),
         np.diag([12 * PI, 12 * PI, 9 * PI])),
        (solid(build.cone(ORIGIN, UP, 3, 4), floor(3)), cone, (0, 0, 1),
         np.diag([cone * 27 / 20, cone * 27 / 20, cone * 3 * 16 / 80])),
        (solid(build.torus(ORIGIN, UP, 3, 1)), torus, ORIGIN,
         np.diag([torus * (9 / 2 + 3 / 8)] * 2 + [torus / 4])),
        (ellipsoid(), 8 * PI, (4, 5, 6), np.diag([1, 4, 9]) * 8 * PI / 5),
        (tetrahedron(), 4.0, (0.5, 0.75, 1.0), simplex),
    ]


def is_near(found, expected, relative=1e-12, size=None):
    size = np.abs(expected).max() if size is None else size
    return np.abs(np.asarray(found) - expected).max() <= relative * size


@pytest.mark.parametrize("body, volume, middle, moments", closed_forms())
def test_bodies_have_the_moments_of_their_closed_form(body, volume, middle, moments):
    assert is_near(body.volume(), volume)
    assert is_near(body.centroid(), middle, size=10.0)
    assert is_near(body.second_moments(), moments)
    way = np.array(middle) - (7.0, -8.0, 9.0)
    assert is_near(body.second_moments((7.0, -8.0, 9.0)), moments + volume * np.outer(way, way))


@pytest.mark.parametrize("body, volume, middle, moments", closed_forms())
def test_inward_normals_keep_the_centroid_and_turn_the_sign_of_the_moments(body, volume, middle, moments):
    assert is_near(body.flipped().centroid(), middle, size=10.0)
    assert is_near(body.flipped().second_moments(), -moments)


@pytest.mark.parametrize("body, volume, middle, moments", closed_forms())
def test_moments_far_away_lose_no_more_than_the_points_do(body, volume, middle, moments):
    shift = np.array([2.0**20, -(2.0**21), 2.0**19])
    far = body.with_points(body.points + shift)
    assert is_near(far.centroid() - shift, middle, 1e-9)
    assert is_near(far.second_moments(), moments, 1e-8)


@pytest.mark.parametrize("exponent", [-498, -180, -60, 60, 180, 498])
def test_centroids_scale_exactly(exponent):
    for body, *_ in closed_forms():
        large = body.with_points(np.ldexp(body.points, exponent))
        assert (np.ldexp(large.centroid(), -exponent) == body.centroid()).all()
        if abs(exponent) <= 180:  # beyond, fifth powers are no normal numbers
            assert (np.ldexp(large.second_moments(), -5 * exponent) == body.second_moments()).all()


def wavy_box(degree, rational, seed=4):
    """A bent box with a rational lid, of six patches of the degree, that share their sides."""
    rng = np.random.default_rng(seed)
    at = np.linspace(0, 1, degree + 1)
    net = np.stack(np.meshgrid(at, at, at, indexing="ij"), -1)
    net = net + rng.uniform(-0.1, 0.1, net.shape) / degree
    weights = rng.uniform(0.5, 2.0, net.shape[:3]) if rational else np.ones(net.shape[:3])
    faces = [np.s_[0], np.s_[-1], np.s_[:, 0], np.s_[:, -1], np.s_[:, :, 0], np.s_[:, :, -1]]
    patches = []
    for face, is_swapped in zip(faces, (1, 0, 0, 1, 1, 0)):
        points, w = net[face], weights[face]
        if is_swapped:
            points, w = points.swapaxes(0, 1), w.T
        patches.append(sc.BezierPatch(points, w if rational else None))
    return solid(*patches)


def dense_moments(body, count=60):
    """Volume, centroid and second moments about it, by one rule of Gauss and the flux of other fields."""
    nodes, shares = np.polynomial.legendre.leggauss(count)
    nodes, shares = 0.5 + 0.5 * nodes, 0.5 * shares
    volume, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
    for patch in (body[i] for i in range(len(body))):
        u, v = np.meshgrid(nodes, nodes, indexing="ij")
        derivatives = patch.derivatives(u.ravel(), v.ravel(), 1)
        points, along_u, along_v = derivatives[..., 0, 0, :], derivatives[..., 1, 0, :], derivatives[..., 0, 1, :]
        normals = np.cross(along_u, along_v) * np.outer(shares, shares).ravel()[:, None]
        x, y, z = points.T
        volume += (x * normals[:, 0]).sum()
        first += 0.5 * (points**2 * normals).sum(0)
        for i in range(3):
            second[i, i] += (points[:, i] ** 3 * normals[:, i]).sum() / 3
        for i, j, k in ((0, 1, 2), (0, 2, 1), (1, 2, 0)):
            second[i, j] += (points[:, i] * points[:, j] * points[:, k] * normals[:, k]).sum()
            second[j, i] = second[i, j]
    middle = first / volume
    return volume, middle, second - volume * np.outer(middle, middle)


@pytest.mark.parametrize("degree", range(1, 10))
@pytest.mark.parametrize("rational", [False, True])
def test_bent_boxes_of_every_degree_have_the_moments_of_a_dense_rule(degree, rational):
    body = wavy_box(degree, rational)
    volume, middle, moments = dense_moments(body)
    assert volume > 0.5
    assert is_near(body.centroid(), middle, 2e-12) and is_near(body.second_moments(), moments, 4e-12)


def test_tolerances_are_kept():
    body = wavy_box(5, True)
    _, middle, moments = dense_moments(body)
    for tolerance in (1e-2, 1e-5, 1e-8):
        assert is_near(body.centroid(tolerance=tolerance), middle, tolerance)
        assert is_near(body.second_moments(tolerance=tolerance), moments, tolerance, np.trace(moments))


def test_moments_turn_with_the_body():
    turn, _ = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    body = wavy_box(3, True)
    turned = body.with_points(body.points @ turn.T, body.weights)
    assert is_near(turned.centroid(), turn @ body.centroid(), 1e-13, 1.0)
    assert is_near(turned.second_moments(), turn @ body.second_moments() @ turn.T)
    assert is_near(turned.second_moments(), turned.second_moments().T, 0.0)


def two_sides_of_a_square():
    square = sc.BezierPatch(np.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]], float))
    return solid(square, square.reversed("v"))


def pillow(weight):
    """A flat square under another one that bulges, whose middle point has this weight."""
    at = np.linspace(0.0, 1.0, 3)
    flat = np.stack(np.meshgrid(at, at, [0.0], indexing="ij"), -1)[:, :, 0]
    top, weights = flat.copy(), np.ones((3, 3))
    top[1, 1, 2], weights[1, 1] = 1.0, weight
    return solid(sc.BezierPatch(top, weights), sc.BezierPatch(flat).swapped())


@pytest.mark.parametrize("weight", [-2.9, -2.9999, -2.9999999, 1e3, 1e5])
def test_bodies_that_run_far_or_have_wild_weights_have_the_volume_they_have(weight):
    """Their centroid lies on the axis; the moments along it are those of the body turned upside down."""
    body = pillow(weight)
    far = np.abs(body.centroid()[2])
    assert is_near(body.centroid()[:2], (0.5, 0.5), 1e-10, max(far, 1.0))
    turned = body.with_points(body.points * (1, 1, -1), body.weights)
    assert is_near(turned.centroid(), body.centroid() * (1, 1, -1), 1e-11, max(far, 1.0))
    assert is_near(turned.second_moments() * [[1, 1, -1], [1, 1, -1], [-1, -1, 1]], -body.second_moments(), 1e-11)


@pytest.mark.parametrize("measure", ["centroid", "second_moments"])
@pytest.mark.parametrize("weight, error, message", [
    (-9.0, sc.PointAtInfinity, "the patch passes through infinity"), (-3.0, sc.PointAtInfinity, "infinity"),
    (1e100, sc.InvalidShape, "the centroid cannot be found: the weights of the patch differ too much in size for it"),
])
def test_weights_without_moments_are_refused_with_a_sentence(measure, weight, error, message):
    with pytest.raises(error, match=message):
        getattr(pillow(weight), measure)()


@pytest.mark.parametrize("tolerance", [1e-15, 1e-300])
def test_what_rounding_cannot_give_is_not_asked_for(tolerance):
    body = wavy_box(3, True)
    assert is_near(body.centroid(tolerance=tolerance), body.centroid(), 1e-12)
    assert is_near(body.second_moments(tolerance=tolerance), body.second_moments(), 1e-12)


@pytest.mark.parametrize("measure", ["centroid", "second_moments"])
@pytest.mark.parametrize("body, how, error, message", [
    (solid(build.cylinder(ORIGIN, UP, 1, 3), floor(1)), {}, sc.InvalidShape, "meets no other"),
    (ellipsoid(), {"tolerance": 0}, sc.InvalidShape, "tolerance = 0 is not a positive number"),
    (ellipsoid(), {"tolerance": math.nan}, sc.InvalidShape, "tolerance = nan"),
    (ellipsoid(), {"tolerance": "much"}, TypeError, "tolerance"),
    (two_sides_of_a_square(), {}, sc.InvalidShape, "the patches enclose no volume: they have no centroid"),
])
def test_what_has_no_moments_is_refused_with_a_sentence(measure, body, how, error, message):
    with pytest.raises(error) as refused:
        getattr(body, measure)(**how)
    assert message in str(refused.value)


@pytest.mark.parametrize("about, error", [
    ((0, 0, 0, 0), sc.InvalidShape), ((0, math.nan, 0), sc.InvalidShape), ("here", TypeError),
])
def test_a_wrong_point_is_refused_by_its_name(about, error):
    with pytest.raises(error, match="about"):
        ellipsoid().second_moments(about)


def test_second_moments_too_large_for_a_number_are_refused():
    with pytest.raises(sc.InvalidShape, match="the second moment is too large for a number"):
        solid(build.sphere(ORIGIN, 1e100)).second_moments()
