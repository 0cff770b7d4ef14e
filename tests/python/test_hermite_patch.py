"""HermitePatch: Ferguson's patch and its twists (row S20)."""

import numpy as np

import splinecore as sc
from shapes import hermite_net, random_points

CORNERS = np.array([[(0, 0, 0), (0, 2, 1)], [(3, 0, 1), (3, 2, 4)]], float)


def bilinear(twists):
    along_u = np.repeat((CORNERS[1:] - CORNERS[:1]), 2, axis=0)
    along_v = np.repeat((CORNERS[:, 1:] - CORNERS[:, :1]), 2, axis=1)
    return sc.HermitePatch(CORNERS, along_u, along_v, twists)


def test_bilinear_map_with_its_twist_is_reproduced():
    twist = CORNERS[1, 1] - CORNERS[1, 0] - CORNERS[0, 1] + CORNERS[0, 0]
    patch = bilinear(np.broadcast_to(twist, (2, 2, 3)))
    grid = np.linspace(0, 1, 17)
    expected = sc.BezierPatch(CORNERS).evaluate_grid(grid, grid)
    assert np.abs(patch.evaluate_grid(grid, grid) - expected).max() <= 2e-15


def test_without_twists_it_is_fergusons_patch():
    patch = bilinear(None)
    assert (patch.twists == 0).all()
    corners = patch.derivatives([[0, 0], [1, 1]], [[0, 1], [0, 1]], 1)
    assert np.abs(corners[..., 0, 0, :] - CORNERS).max() <= 1e-15
    assert np.abs(corners[..., 1, 1, :]).max() <= 1e-14


def test_patch_takes_its_points_tangents_and_twists():
    patch = hermite_net()
    u, v = patch.parameters
    values = patch.derivatives(u[:, None], v[None, :], 1)
    for got, given in [(values[..., 0, 0, :], patch.points), (values[..., 1, 0, :], patch.tangents_u),
                       (values[..., 0, 1, :], patch.tangents_v), (values[..., 1, 1, :], patch.twists)]:
        assert np.abs(got - given).max() <= 2e-14


def test_properties_are_what_was_given():
    patch = hermite_net()
    nets = random_points(4, 3, 2, seed=13)
    for name, net in zip(("points", "tangents_u", "tangents_v", "twists"), nets):
        assert (getattr(patch, name) == net).all()
    assert [row.tolist() for row in patch.parameters] == [[0, 1, 3], [0, 2]]
    assert patch.degree == (3, 3) and patch.domain == ((0, 3), (0, 2)) and not patch.is_rational
    plain = sc.HermitePatch(*nets)
    assert [row.tolist() for row in plain.parameters] == [[0, 1, 2], [0, 1]]
    half = sc.HermitePatch(*nets, parameters=(None, [0, 5]))
    assert half.domain == ((0, 2), (0, 5))


def test_other_forms_are_the_same_surface():
    patch = hermite_net()
    u, v = np.linspace(0, 3, 19), np.linspace(0, 2, 11)
    points, normals = patch.evaluate_grid_with_normals(u, v)
    assert np.array_equal(patch.to_nurbs().evaluate_grid(u, v), patch.evaluate_grid(u, v))
    assert np.abs(patch.to_nurbs().to_hermite().evaluate_grid(u, v) - points).max() <= 2e-14
    assert [len(row) for row in patch.to_bezier()] == [1, 1]
    assert np.abs(np.linalg.norm(normals, axis=-1) - 1).max() <= 4e-16


def test_split_reversed_and_swapped_keep_the_surface():
    patch = hermite_net()
    before, after = patch.split("u", 2.0)
    assert before.domain[0] == (0, 2) and after.domain[0] == (2, 3)
    assert np.abs(before.evaluate(1.5, 1) - patch.evaluate(1.5, 1)).max() <= 4e-15
    assert np.abs(after.evaluate(2.5, 1) - patch.evaluate(2.5, 1)).max() <= 4e-15
    assert np.abs(patch.reversed("v").evaluate(1.5, 0.5) - patch.evaluate(1.5, 1.5)).max() <= 4e-15
    assert np.abs(patch.swapped().evaluate(0.5, 1.5) - patch.evaluate(1.5, 0.5)).max() <= 4e-15
