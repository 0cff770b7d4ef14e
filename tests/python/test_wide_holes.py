"""Holes of three to eight sides that are wide or deep: the filling is as fair as their borders, and never folds in silence."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

BERNSTEIN = np.linalg.inv([[math.comb(2, k) * t ** k * (1 - t) ** (2 - k) for k in range(3)] for t in (0, 0.5, 1)])


def on_sphere(corners):
    """What lies over a quadrilateral of the plane on the unit sphere, seen from its south pole: exact, of degree 2."""
    t = np.array([0, 0.5, 1])
    u, v = np.meshgrid(t, t, indexing="ij")
    x, y = np.moveaxis(np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], -1) @ np.array(corners), -1, 0)
    square = x * x + y * y
    points = np.einsum("ia,jb,abk->ijk", BERNSTEIN, BERNSTEIN, np.stack([2 * x, 2 * y, 1 - square, 1 + square], -1))
    return sc.BezierPatch(points[..., :3] / points[..., 3:], points[..., 3])


def corners_at(count, half_angle, turns=0.0, lengths=1.0):
    angles = 2 * np.pi * (np.arange(count) + turns) / count
    return (math.tan(half_angle / 2) * np.ones(count) * lengths)[:, None] * np.c_[np.cos(angles), np.sin(angles)]


def hole(inner, word, matrix=np.eye(3, 4)):
    outer = 1.4 * inner
    following = np.roll(np.arange(len(inner)), -1)
    return [(on_sphere([inner[i], inner[k], outer[k], outer[i]]).transformed(matrix), "v_start", word) for i, k in enumerate(following)]


def dense(patch, count=21):
    places = np.linspace(0.002, 0.998, count)
    return patch.evaluate_grid_with_normals(*(a + places * (b - a) for a, b in patch.domain))


def off_sphere(filling, matrix=np.eye(3, 4)):
    """The largest distance from the sphere that the matrix moves, and the least cosine of normals to its own."""
    back = np.linalg.inv(matrix[:, :3])
    off, cosines = 0.0, []
    for patch in filling.patches:
        points, normals = dense(patch)
        points, normals = (points - matrix[:, 3]) @ back.T, normals @ matrix[:, :3]
        lengths = np.linalg.norm(points, axis=-1)
        off = max(off, np.abs(lengths - 1).max())
        cosines.append((points * normals).sum(-1) / lengths / np.linalg.norm(normals, axis=-1))
    cosines = np.concatenate([one.ravel() for one in cosines])
    return off, (cosines * np.sign(np.median(cosines))).min()


@pytest.mark.parametrize("word, most", [("G1", 0.03), ("G2", 0.08)])
@pytest.mark.parametrize("count", range(3, 9))
@pytest.mark.parametrize("degrees", [20, 40, 57, 69, 80, 85])
def test_a_wide_hole_in_a_sphere_is_closed(count, degrees, word, most):
    filling = build.fill(hole(corners_at(count, math.radians(degrees), 0.3), word))
    off, cosine = off_sphere(filling)
    assert off <= most * math.radians(degrees) and cosine > 0.98
    assert filling.gap <= 2e-6 and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4


def turned(rng):
    return np.c_[np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.normal(0, 3, 3)]


def test_random_holes_in_spheres_are_closed(inputs):
    """Corners anywhere round, at unlike distances from the middle."""
    rng = np.random.default_rng(21)
    wanted = inputs(1000)
    closed = within = 0
    for _ in range(wanted):
        count = int(rng.integers(3, 9))
        inner = corners_at(count, math.radians(rng.uniform(15, 85)), rng.uniform(-0.25, 0.25, count), np.exp(rng.uniform(-0.15, 0.15, count)))
        matrix = turned(rng)
        try:
            filling = build.fill(hole(inner, str(rng.choice(["G1", "G2"])), matrix))
        except sc.InvalidShape as error:  # of the sides beside a corner that is no convex one
            assert "back over" in str(error)
            continue
        closed += 1
        off, cosine = off_sphere(filling, matrix)
        assert off <= 0.15 and cosine > 0.8
        within += off <= 0.03
    assert closed >= 0.99 * wanted and within >= 0.97 * wanted


def least_turn(filling):
    """The least cosine between normals at places beside each other."""
    least = 1.0
    for patch in filling.patches:
        normals = dense(patch, 65)[1]
        least = min(least, (normals[1:] * normals[:-1]).sum(-1).min(), (normals[:, 1:] * normals[:, :-1]).sum(-1).min())
    return least


def test_random_holes_in_ellipsoids_do_not_fold(inputs):
    rng = np.random.default_rng(22)
    wanted = inputs(1000)
    closed = 0
    for _ in range(wanted):
        count = int(rng.integers(3, 9))
        inner = corners_at(count, math.radians(rng.uniform(15, 85)), rng.uniform(-0.2, 0.2, count))
        matrix = turned(rng) * 1.0
        matrix[:, :3] = matrix[:, :3] @ np.diag(np.exp(rng.uniform(-0.7, 0.7, 3)))
        try:
            filling = build.fill(hole(inner, str(rng.choice(["G1", "G2"])), matrix))
        except sc.InvalidShape as error:
            assert "back over" in str(error)
            continue
        closed += 1
        assert least_turn(filling) > 0.0
    assert closed >= 0.97 * wanted


def test_a_filling_that_would_fold_is_refused():
    """A side so much heavier in its middle that lines from it run over each other."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
    out = np.array([(0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0)], float)
    around = []
    for i in range(4):
        points = np.linspace(corners[i], corners[(i + 1) % 4], 3)[:, None] + np.array([0, 1])[None, :, None] * out[i]
        points[1, 0] -= 0.2 * out[i]
        weights = np.array([[1, 1], [100, 100], [1, 1]]) if i == 0 else np.ones((3, 2))
        around.append((sc.BezierPatch(points, weights), "v_start", "G1"))
    try:
        filling = build.fill(around)
    except sc.InvalidShape as error:
        assert "back over" in str(error)
    else:
        assert least_turn(filling) > 0.0
