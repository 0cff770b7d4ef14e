"""What holds for every patch, on examples that Hypothesis invents."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import inside, knot_vectors, positive, size_of

fractions = st.floats(0.02, 0.98)


@st.composite
def nurbs_patches(draw):
    degree = draw(st.tuples(st.integers(1, 4), st.integers(1, 4)))
    count = tuple(p + 1 + draw(st.integers(0, 3)) for p in degree)
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    knots = [draw(knot_vectors(n, p)) for n, p in zip(count, degree)]
    return sc.NurbsPatch(degree, knots, rng.uniform(-50, 50, (*count, 3)), rng.uniform(0.1, 5, count))


def grid_of(patch, count=9):
    return [inside(domain, count) for domain in patch.domain]


def gap(one, other, patch):
    return np.abs(np.asarray(one) - other).max() / size_of(patch)


def within(domain, fraction):
    start, end = domain
    return start + fraction * (end - start)


@given(nurbs_patches())
def test_every_point_lies_in_the_box_of_the_net(patch):
    slack = 1e-13 * size_of(patch)
    points = patch.evaluate_grid(*grid_of(patch)).reshape(-1, 3)
    net = patch.points.reshape(-1, 3)
    assert (points >= net.min(axis=0) - slack).all() and (points <= net.max(axis=0) + slack).all()


@given(nurbs_patches(), st.integers(0, 2**32))
def test_affine_maps_of_the_net_are_affine_maps_of_the_surface(patch, seed):
    rng = np.random.default_rng(seed)
    matrix, shift = rng.uniform(-1, 1, (3, 3)), rng.uniform(-10, 10, 3)
    moved = patch.with_points(patch.points @ matrix.T + shift)
    expected = patch.evaluate_grid(*grid_of(patch)) @ matrix.T + shift
    assert gap(moved.evaluate_grid(*grid_of(patch)), expected, patch) <= 1e-12


@given(nurbs_patches(), positive)
def test_scaling_all_weights_changes_nothing(patch, factor):
    scaled = patch.with_weights(patch.weights * factor)
    assert gap(scaled.evaluate_grid(*grid_of(patch)), patch.evaluate_grid(*grid_of(patch)), patch) <= 1e-12


@given(nurbs_patches(), st.sampled_from("uv"), st.lists(fractions, min_size=1, max_size=3, unique=True))
def test_refining_keeps_the_surface(patch, axis, at):
    new = [within(patch.domain["uv".index(axis)], fraction) for fraction in at]
    refined = patch.refine(axis, new)
    assert gap(refined.evaluate_grid(*grid_of(patch)), patch.evaluate_grid(*grid_of(patch)), patch) <= 1e-12


@given(nurbs_patches(), st.sampled_from("uv"), fractions)
def test_splitting_keeps_the_surface(patch, axis, at):
    middle = within(patch.domain["uv".index(axis)], at)
    for part in patch.split(axis, middle):
        u, v = grid_of(part)
        u, v = u[1:-1], v[1:-1]
        assert gap(part.evaluate_grid(u, v), patch.evaluate_grid(u, v), patch) <= 1e-12


@given(nurbs_patches(), st.sampled_from("uv"))
def test_turned_surfaces_are_the_same_surface(patch, axis):
    u, v = grid_of(patch)
    expected = patch.evaluate_grid(u, v)
    turned = patch.reversed(axis).evaluate_grid(u, v)
    assert gap(np.flip(turned, "uv".index(axis)), expected, patch) <= 1e-10
    assert gap(patch.swapped().evaluate_grid(v, u).swapaxes(0, 1), expected, patch) <= 1e-13
    assert patch.swapped().swapped() == patch


@given(nurbs_patches())
def test_normals_are_unit_and_across_both_derivatives(patch):
    u, v = (values[1:-1] for values in grid_of(patch))
    _, normals = patch.evaluate_grid_with_normals(u, v)
    first = patch.derivatives(u[:, None], v, 1)
    cross = np.cross(first[..., 1, 0, :], first[..., 0, 1, :])
    length = np.linalg.norm(cross, axis=-1, keepdims=True)
    lengths = [np.linalg.norm(first[..., k, 1 - k, :], axis=-1, keepdims=True) for k in (0, 1)]
    steady = (length > 1e-3 * lengths[0] * lengths[1])[..., 0]
    assert np.abs(np.linalg.norm(normals, axis=-1) - 1)[steady].max(initial=0) <= 1e-14
    assert np.abs(normals - cross / length)[steady].max(initial=0) <= 1e-9


@given(nurbs_patches())
def test_a_line_of_the_surface_is_a_curve(patch):
    v = patch.domain[1][0]
    u = inside(patch.domain[0], 9)
    weights = patch.knot_vectors[1].functions(v)
    homogeneous = np.einsum("ijc,j->ic", patch.homogeneous_points, weights)
    curve = sc.NurbsCurve.from_homogeneous(patch.degree[0], patch.knots[0], homogeneous)
    assert gap(curve.evaluate(u), patch.evaluate(u, v), patch) <= 1e-12


@given(nurbs_patches())
def test_bezier_patches_cover_the_surface(patch):
    spans = [np.unique(np.clip(knots, *domain)) for knots, domain in zip(patch.knots, patch.domain)]
    t = np.array([0.25, 0.75])
    for row, u0, u1 in zip(patch.to_bezier(), spans[0], spans[0][1:]):
        assert len(row) == len(spans[1]) - 1
        for piece, v0, v1 in zip(row, spans[1], spans[1][1:]):
            expected = patch.evaluate_grid(u0 + t * (u1 - u0), v0 + t * (v1 - v0))
            assert gap(piece.evaluate_grid(t, t), expected, patch) <= 1e-12


@given(nurbs_patches())
def test_json_gives_back_every_bit(patch):
    again = sc.loads(patch.dumps())
    assert again == patch and again.points.tobytes() == patch.points.tobytes()
    assert again.weights.tobytes() == patch.weights.tobytes()
