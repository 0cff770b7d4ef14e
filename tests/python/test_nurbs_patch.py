"""NurbsPatch: torus, cylinder, and changes that keep the surface (row S20)."""

import numpy as np
import pytest

import splinecore as sc
from shapes import cylinder, inside, random_points, torus, wavy_patch


def grid_of(patch, count=21):
    return [inside(domain, count) for domain in patch.domain]


def test_torus_satisfies_its_equation_and_normals_leave_the_tube():
    patch = torus()
    u, v = grid_of(patch, 41)
    points, normals = patch.evaluate_grid_with_normals(u, v)
    ring = np.hypot(points[..., 0], points[..., 1])
    assert np.abs((ring - 3) ** 2 + points[..., 2] ** 2 - 1).max() <= 1e-14
    center = points * np.stack([3 / ring, 3 / ring, 0 * ring], axis=-1)
    assert np.abs(normals - (points - center)).max() <= 2e-14


def test_cylinder_is_round_and_its_normals_are_horizontal():
    patch = cylinder()
    points, normals = patch.evaluate_grid_with_normals(*grid_of(patch))
    assert np.abs(np.hypot(points[..., 0], points[..., 1]) - 1).max() <= 4e-16
    assert np.abs(normals[..., :2] - points[..., :2]).max() <= 2e-15
    assert (normals[..., 2] == 0).all()


@pytest.mark.parametrize("patch", [torus(), cylinder(), wavy_patch()])
def test_refining_and_inserting_keep_the_surface(patch):
    grid = grid_of(patch)
    expected = patch.evaluate_grid(*grid)
    for axis, domain in zip("uv", patch.domain):
        new = np.linspace(*domain, 7)[1:-1] + 1e-3
        assert np.abs(patch.refine(axis, new).evaluate_grid(*grid) - expected).max() <= 1e-13
        assert np.abs(patch.insert_knot(axis, new[0], 2).evaluate_grid(*grid) - expected).max() <= 1e-13


def test_split_cuts_plain_directions_and_opens_periodic_ones():
    patch = wavy_patch()
    before, after = patch.split("u", 0.75)
    assert before.domain[0] == (0, 0.75) and after.domain[0] == (0.75, 2)
    assert np.abs(after.evaluate(1.0, 3.0) - patch.evaluate(1.0, 3.0)).max() <= 4e-15
    (opened,) = patch.split("v", 1.5)
    assert opened.domain[1] == (1.5, 6.5) and opened.periodic == (False, False)
    v = np.linspace(1.5, 6.5, 30)
    assert np.abs(opened.evaluate(1.0, v) - patch.evaluate(1.0, v)).max() <= 1e-14


def test_bezier_rows_are_the_surface_span_by_span():
    patch = wavy_patch()
    rows = patch.to_bezier()
    assert len(rows) == 2 and all(len(row) == 4 for row in rows)
    t = np.linspace(0, 1, 5)[1:-1]
    for row, (low, high) in zip(rows, [(0, 0.5), (0.5, 2)]):
        for piece, (start, end) in zip(row, [(0, 1), (1, 2), (2, 4), (4, 5)]):
            expected = patch.evaluate_grid(low + t * (high - low), start + t * (end - start))
            assert np.abs(piece.evaluate_grid(t, t) - expected).max() <= 1e-14


def test_reversed_and_swapped_are_the_same_surface():
    patch = wavy_patch()
    turned, swapped = patch.reversed("u"), patch.swapped()
    assert np.abs(turned.evaluate(0.5, 2.2) - patch.evaluate(1.5, 2.2)).max() <= 4e-15
    assert np.abs(swapped.evaluate(2.2, 0.5) - patch.evaluate(0.5, 2.2)).max() <= 4e-15
    assert swapped.degree == (2, 3) and swapped.periodic == (True, False)


def test_periodic_parameters_count_modulo_the_period():
    patch = wavy_patch()
    u, v = np.array([0.0, 0.25, 1.5]), np.array([0.5, 2.25, 4.75])
    for turns in (-10, 5, 500):
        for of in (patch.evaluate, patch.evaluate_grid, lambda *at: patch.derivatives(*at, 2),
                   lambda *at: patch.curvatures(*at).gauss):
            assert np.array_equal(of(u, v), of(u, v + turns))
        assert patch.isocurve('v', 2.25 + turns) == patch.isocurve('v', 2.25)


def test_unrolled_has_no_periodic_direction():
    patch = wavy_patch()
    plain = patch.unrolled()
    assert plain.periodic == (False, False) and plain.points.shape == (5, 6, 3)
    assert np.array_equal(plain.evaluate_grid(*grid_of(patch)), patch.evaluate_grid(*grid_of(patch)))


def test_properties_are_what_was_given():
    patch = wavy_patch()
    assert patch.degree == (3, 2) and patch.domain == ((0, 2), (0, 5)) and patch.is_rational
    assert patch.knots[1].tolist() == [0, 1, 2, 4, 5]
    assert [knots.count for knots in patch.knot_vectors] == [5, 4]
    assert (patch.points == random_points(5, 4, seed=11)).all()
    assert (patch.with_points(-patch.points).weights == patch.weights).all()
    assert (patch.with_weights(2 * patch.weights).weights == 2 * patch.weights).all()
    assert patch.to_nurbs() == patch
    again = sc.NurbsPatch.from_homogeneous(patch.degree, patch.knots, patch.homogeneous_points, patch.periodic)
    assert np.abs(again.points - patch.points).max() <= 1e-15


def test_sides_are_chosen_for_each_direction():
    points = np.zeros((4, 4, 3))
    points[..., 0] = np.arange(4)[:, None]
    points[..., 1] = np.arange(4)
    gap = [0, 0, 1, 1, 2, 2]
    patch = sc.NurbsPatch((1, 1), (gap, gap), points)
    assert patch.evaluate(1, 1).tolist() == [2, 2, 0]
    assert patch.evaluate(1, 1, side="left").tolist() == [1, 1, 0]
    assert patch.evaluate(1, 1, side=("left", "right")).tolist() == [1, 2, 0]
    assert patch.evaluate_grid([1], [1], side=("right", "left")).tolist() == [[[2, 1, 0]]]


def test_infinity_is_refused_or_marked():
    points = np.array([[(0, 0), (0, 1)], [(1, 0), (1, 1)]], float)
    patch = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), points, [[1, 1], [-1, -1]])
    with pytest.raises(sc.PointAtInfinity, match="u = 0.5, v = 0.25"):
        patch.evaluate(0.5, 0.25)
    marked = patch.evaluate_grid([0, 0.5], [0.25], at_infinity="nan")
    assert np.isfinite(marked[0]).all() and np.isnan(marked[1]).all()
    assert np.isnan(patch.derivatives(0.5, 0.25, 1, at_infinity="nan")).all()


def test_grids_are_the_same_bits_in_any_batch_and_order():
    patch = wavy_patch()
    u, v = grid_of(patch, 9)
    for name in ("evaluate_grid", "evaluate_grid_with_normals"):
        grid = np.array(getattr(patch, name)(u, v))
        turned = np.array(getattr(patch, name)(u[::-1], v[::-1]))
        assert np.array_equal(grid, turned[..., ::-1, ::-1, :])
        one = np.array(getattr(patch, name)(u[3:4], v[4:5]))
        assert np.array_equal(grid[..., 3:4, 4:5, :], one)


def test_pairs_are_the_same_bits_in_any_batch_and_order():
    patch = wavy_patch()
    u, v = np.meshgrid(*grid_of(patch, 9), indexing="ij")
    together = patch.evaluate(u, v)
    assert np.array_equal(together, patch.evaluate(u[::-1], v[::-1])[::-1])
    assert np.array_equal(together[3, 4], patch.evaluate(u[3, 4], v[3, 4]))
    slopes = patch.derivatives(u, v, 2)
    assert np.array_equal(slopes[5, 6], patch.derivatives(u[5, 6], v[5, 6], 2))
