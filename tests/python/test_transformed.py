"""Affine and projective maps of curves, the perspective image of a curve (rows S9, S15)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from random_curves import homogeneous, parameters, random_curves, sampled_distance
from shapes import circle, closed_cubic, inside, nurbs_curves, semicircle, size_of

seeds = st.integers(0, 2**32)


def divided(rows):
    return rows[:, :3] / rows[:, 3:]


@given(nurbs_curves(), seeds)
def test_an_affine_image_of_the_curve_is_the_curve_of_the_images(curve, seed):
    rng = np.random.default_rng(seed)
    matrix, shift = rng.uniform(-1, 1, (3, 3)), rng.uniform(-10, 10, 3)
    u = inside(curve.domain)
    moved = curve.transformed(np.c_[matrix, shift])
    assert np.array_equal(moved.weights, curve.weights)
    assert np.abs(moved.evaluate(u) - curve.evaluate(u) @ matrix.T - shift).max() <= 1e-12 * (10 + size_of(curve))
    assert curve.transformed(matrix) == curve.transformed(np.c_[matrix, np.zeros(3)])
    assert curve.transformed(np.r_[np.c_[matrix, shift], [[0, 0, 0, 1]]]) == moved


@given(nurbs_curves(), seeds)
def test_a_projective_image_of_the_curve_is_the_curve_of_the_images(curve, seed):
    matrix = np.eye(4) + np.random.default_rng(seed).uniform(-0.2, 0.2, (4, 4))
    matrix[3, :3] /= size_of(curve)
    u = inside(curve.domain)
    image = curve.transformed(matrix)
    expected = divided(np.c_[curve.evaluate(u), np.ones(len(u))] @ matrix.T)
    assert np.abs(image.evaluate(u) - expected).max() <= 1e-11 * size_of(curve)


def test_homogeneous_points_are_multiplied_for_a_thousand_curves_of_any_weights():
    for index, curve in enumerate(random_curves(40)):
        matrix = np.random.default_rng(index).uniform(-1, 1, (4, 4))
        u = parameters(curve)
        image = curve.transformed(matrix)
        far = np.abs(homogeneous(image, u) - homogeneous(curve, u) @ matrix.T).max()
        assert far <= 1e-12 * np.abs(curve.homogeneous_points).max(), index
        assert np.array_equal(image.knots, curve.knots) and image.periodic == curve.periodic


def test_a_map_and_its_inverse_and_two_maps_in_turn():
    rng = np.random.default_rng(5)
    one, other = np.eye(4) + rng.uniform(-0.1, 0.1, (2, 4, 4))
    for curve in (circle(), closed_cubic(), semicircle().to_nurbs()):
        assert sampled_distance(curve.transformed(one).transformed(np.linalg.inv(one)), curve) <= 1e-14
        together = curve.transformed(other @ one)
        assert sampled_distance(curve.transformed(one).transformed(other), together) <= 1e-14


def test_the_perspective_image_of_a_circle_is_a_conic_seen_from_the_eye():
    """Onto the plane z = 1 from the origin, as the lectures do: (x, y, z) -> (x / z, y / z, 1)."""
    lifted = circle().transformed([[1, 0, 0, 0], [0, 0, 0, 0], [0, 1, 0, 3]])
    perspective = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0]]
    tilted = lifted.transformed([[1, 0, 0, 0], [0, 1, 0.5, 0], [0, 0, 1, 0]])
    image = tilted.transformed(perspective)
    u = np.linspace(0, 4, 41)
    x, y, z = tilted.evaluate(u).T
    assert np.abs(image.evaluate(u) - np.c_[x / z, y / z, np.ones(41)]).max() <= 1e-15
    assert np.array_equal(image.weights, tilted.weights * tilted.points[:, 2])
    # x² + (z - 3)² = 1 divided by z².
    flat_x, flat_y = lifted.transformed(perspective).evaluate(u)[:, :2].T
    assert np.abs(flat_y).max() == 0 and np.abs(flat_x).max() <= 1 / np.sqrt(8) + 1e-15


def test_a_point_that_goes_to_infinity_is_a_direction_with_weight_zero():
    line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (2, 0, 1)])
    image = line.transformed([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 0]])
    assert image.weights.tolist() == [0, 1] and image.points.tolist() == [[0, 0, 0], [2, 0, 1]]
    assert image.evaluate(0.5).tolist() == [2, 0, 1]
    with pytest.raises(sc.PointAtInfinity):
        image.evaluate(0)
    hyperbola = circle().transformed([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0.5]])
    # The circle crosses y = -1/2, the plane that goes to infinity, twice.
    assert len(hyperbola.pieces()) == 3 and hyperbola.weights.min() < 0


def test_directions_are_turned_and_not_moved():
    moved = semicircle().to_nurbs().transformed([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]])
    assert moved.weights.tolist() == [1, 0, 1]
    assert moved.points.tolist() == [[5, 7, 7], [-1, 0, 0], [5, 5, 7]]


REFUSED = [
    (np.eye(2), r"matrix has shape \(2, 2\)"), (np.eye(5), r"matrix has shape \(5, 5\)"),
    (np.ones(3), r"matrix has shape \(3,\)"),
    (np.eye(4)[None], r"matrix has shape \(1, 4, 4\)"), (np.eye(4, 3), r"matrix has shape \(4, 3\)"),
    (np.diag([1, np.nan, 1]), r"matrix\[1, 1\] = nan is not finite"),
    (np.diag([1, 1, 1, -np.inf]), r"matrix\[3, 3\] = -inf is not finite"),
    (np.zeros((4, 4)), "weights are all zero"), (np.eye(3) * 1e308 * 1.7, "is not finite"),
]


@pytest.mark.parametrize("matrix, words", REFUSED)
def test_bad_matrices_raise_invalid_shape_and_change_nothing(matrix, words):
    curve = circle().transformed(2 * np.eye(3))
    with pytest.raises(sc.InvalidShape, match=words):
        curve.transformed(matrix)
    assert curve == circle().with_points(2 * circle().points)


@pytest.mark.parametrize("bad", [None, "abc", [[1j] * 3] * 3, object(), [["a"] * 3] * 3, np.eye(3, dtype=bool)])
def test_what_is_no_matrix_of_numbers_raises_type_error(bad):
    with pytest.raises(TypeError, match="^matrix"):
        circle().transformed(bad)


@pytest.mark.parametrize("scale", [1e150, 1e-150])
def test_huge_and_small_maps_are_exact(scale):
    image = circle().transformed(np.diag([scale] * 3))
    assert np.array_equal(image.points, circle().points * scale)
    u = np.linspace(0, 4, 9)
    divided_by = circle().transformed(np.diag([1, 1, 1, scale]))
    assert np.allclose(divided_by.evaluate(u) * scale, circle().evaluate(u), atol=1e-15)
