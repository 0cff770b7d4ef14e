"""BezierPatch: spheres, poles, splitting (row S19)."""

import numpy as np

import splinecore as sc
from shapes import random_points, sphere_octant

GRID = np.linspace(0, 1, 33)


def test_octant_has_radius_one_and_normals_along_the_radius():
    points, normals = sphere_octant().evaluate_grid_with_normals(GRID, GRID)
    assert np.abs(np.linalg.norm(points, axis=-1) - 1).max() <= 6e-16
    assert np.abs(normals - points).max() <= 1e-14


def test_the_pole_has_the_limit_of_the_normals():
    _, normals = sphere_octant().evaluate_grid_with_normals(GRID, [1.0])
    assert np.abs(normals - (0, 0, 1)).max() <= 1e-14


def test_bilinear_patch_is_its_formula():
    corners = random_points(2, 2, seed=1)
    patch = sc.BezierPatch(corners)
    u, v = np.meshgrid(GRID, GRID, indexing="ij")
    a, b = u[..., None], v[..., None]
    expected = ((1 - a) * (1 - b) * corners[0, 0] + (1 - a) * b * corners[0, 1]
                + a * (1 - b) * corners[1, 0] + a * b * corners[1, 1])
    assert np.abs(patch.evaluate(u, v) - expected).max() <= 1e-15
    twist = corners[1, 1] - corners[1, 0] - corners[0, 1] + corners[0, 0]
    assert np.abs(patch.derivatives(u, v, 1)[..., 1, 1, :] - twist).max() <= 4e-15


def test_mixed_derivatives_of_a_monomial_are_its_formula():
    # z = u² v³ over x = u, y = v.
    points = np.zeros((3, 4, 3))
    points[..., 0] = np.array([0, 0.5, 1])[:, None]
    points[..., 1] = np.arange(4) / 3
    points[2, 3, 2] = 1
    u, v = 0.3, 0.8
    z = sc.BezierPatch(points).derivatives(u, v, 3)[..., 2]
    along_u = np.array([u * u, 2 * u, 2, 0])
    along_v = np.array([v**3, 3 * v * v, 6 * v, 6])
    assert np.abs(z - np.outer(along_u, along_v)).max() <= 1e-14


def test_split_reversed_and_swapped_are_the_same_surface():
    patch = sphere_octant()
    before, after = patch.split("u", 0.25)
    assert np.abs(before.evaluate(GRID, 0.7) - patch.evaluate(0.25 * GRID, 0.7)).max() <= 1e-15
    low, high = patch.split("v", 0.5)
    assert np.abs(high.evaluate(0.2, GRID) - patch.evaluate(0.2, 0.5 + 0.5 * GRID)).max() <= 1e-15
    assert after.domain == low.domain == ((0, 1), (0, 1))
    assert np.abs(patch.reversed("u").evaluate(GRID, 0.4) - patch.evaluate(1 - GRID, 0.4)).max() <= 1e-15
    assert np.abs(patch.swapped().evaluate(0.4, GRID) - patch.evaluate(GRID, 0.4)).max() <= 1e-15
    _, turned = patch.swapped().evaluate_grid_with_normals([0.5], [0.25])
    _, normal = patch.evaluate_grid_with_normals([0.25], [0.5])
    assert np.abs(turned + normal).max() <= 1e-14


def test_properties_are_what_was_given():
    points, weights = random_points(3, 5, seed=2), np.linspace(1, 3, 15).reshape(3, 5)
    patch = sc.BezierPatch(points, weights)
    assert patch.degree == (2, 4) and patch.domain == ((0, 1), (0, 1)) and patch.is_rational
    assert (patch.points == points).all() and (patch.weights == weights).all()
    assert (patch.homogeneous_points[..., :3] == points * weights[..., None]).all()
    ((piece,),) = patch.to_bezier()
    assert np.abs(piece.points - points).max() <= 1e-15 and (piece.weights == weights).all()
    assert patch.to_nurbs().degree == (2, 4)
    assert (patch.with_points(points + 1).weights == weights).all()
    assert not patch.with_weights(np.ones((3, 5))).is_rational


def test_a_bicubic_patch_is_a_hermite_patch_and_back():
    patch = sc.BezierPatch(random_points(4, 4, seed=3))
    hermite = patch.to_hermite()
    assert np.abs(hermite.evaluate(GRID, GRID[::-1]) - patch.evaluate(GRID, GRID[::-1])).max() <= 4e-15
    assert np.abs(hermite.tangents_u[0, 0] - 3 * (patch.points[1, 0] - patch.points[0, 0])).max() <= 4e-15
    assert np.abs(hermite.to_bezier()[0][0].points - patch.points).max() <= 4e-15
