"""A shape and its image in a plane are one shape, smooth across it. Judged by the plane's symmetry and by seam_continuity()."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

mirroring, definitions, recipes, verbs = (core(name) for name in ('deform.mirroring', 'shape.definition', 'recipes.table', 'verbs.verbs'))
MIRROR = recipes.RECIPES['mirror']
RANDOM = np.random.default_rng(20261128)


def knots(count, degree, jitter):
    inner = np.linspace(0.0, 1.0, count - degree + 1)[1:-1]
    return np.r_[[0.0] * (degree + 1), inner + jitter * RANDOM.uniform(-0.3, 0.3, len(inner)) / (count - degree), [1.0] * (degree + 1)]


def random_patch(size, roughness):
    """Over x and y from 0 on, the border x = 0 about on the plane; weights in rows of their own."""
    degree = RANDOM.integers(1, 6, 2)
    count = degree + 1 + RANDOM.integers(0, 6, 2)
    u, v = (np.linspace(0.0, 1.0, n) for n in count)
    points = np.stack([*np.meshgrid(u, v, indexing='ij'), np.zeros(count)], -1)
    points += roughness * RANDOM.normal(size=points.shape) / count.max()
    points[0, :, 0] = 1e-4 * RANDOM.uniform(-1.0, 1.0, count[1])
    points[1:, :, 0] = np.abs(points[1:, :, 0]) + 0.3 / count[0]
    weights = np.outer(RANDOM.uniform(0.3, 3.0, count[0]), RANDOM.uniform(0.3, 3.0, count[1]))
    return sc.NurbsPatch(tuple(map(int, degree)), tuple(knots(n, d, 1.0) for n, d in zip(count, degree)), size * points, weights)


def random_place():
    turn, _ = np.linalg.qr(RANDOM.normal(size=(3, 3)))
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn * np.sign(np.linalg.det(turn)), RANDOM.normal(size=3) * 10.0 ** RANDOM.uniform(-2, 3)
    return matrix


def mirrored(value, **values):
    given = {'axis': 'x', 'gap': 1e-3, 'smooth': True, **values}
    return MIRROR.make([definitions.from_value(value)], **given)


def test_random_patches_go_on_across_a_random_plane(inputs):
    for _ in range(inputs(1000)):
        size, place = 10.0 ** RANDOM.uniform(-5, 5), random_place()
        place[:3, 3] *= size
        patch = random_patch(size, RANDOM.choice([0.0, 0.3, 1.0])).transformed(place)
        made = mirrored(sc.PatchSet.from_patches([patch]), gap=1e-3 * size, frame=place)
        half, image = verbs.pieces_of(made.definition)
        assert "1 border on the plane" in made.said
        seam = sc.seam_continuity(half, 'u_start', image, 'v_start')
        assert seam.gap == 0.0 and seam.angle < 1e-6
        assert seam.curvature_difference * size < 1e-4 * max(1.0, size * largest_curvature(half))
        uv = RANDOM.uniform(0.0, 1.0, (2, 50))
        there = half.evaluate(*uv) - place[:3, 3]
        expected = half.evaluate(*uv) - 2.0 * np.outer(there @ place[:3, 0], place[:3, 0])
        assert np.abs(image.evaluate(*uv[::-1]) - expected).max() <= 1e-9 * size + 1e-13 * np.abs(place).max()


def largest_curvature(patch):
    seam = sc.seam_continuity(patch, 'u_start', patch, 'u_start')
    at = seam.parameters * (patch.domain[1][1] - patch.domain[1][0]) + patch.domain[1][0]
    steps = 1e-4 * (patch.domain[0][1] - patch.domain[0][0]) * np.arange(3)
    a, b, c = (patch.evaluate(np.full(len(at), patch.domain[0][0] + step), at) for step in steps)
    bends = np.linalg.norm(a - 2.0 * b + c, axis=1) / np.maximum(np.linalg.norm(b - a, axis=1), 1e-300) ** 2
    return float(bends.max())


def test_the_half_keeps_all_points_but_those_beside_the_plane():
    patch = random_patch(1.0, 0.3)
    half, _ = verbs.pieces_of(mirrored(sc.PatchSet.from_patches([patch])).definition)
    assert (half.points[2:] == patch.points[2:]).all() and (half.points[1, :, 0] == patch.points[1, :, 0]).all()
    assert (half.points[0, :, 0] == 0.0).all()


def test_joined_patches_stay_joined_and_share_the_border():
    patch = random_patch(1.0, 0.3)
    parts = patch.split('v', 0.4)
    made = mirrored(sc.PatchSet.from_patches(list(parts)))
    assert "2 borders on the plane" in made.said
    tessellation = sc.Tessellation(made.value, 5)
    edges = open_edges(tessellation)
    once = open_edges(sc.Tessellation(sc.PatchSet.from_patches(list(parts)), 5))
    rows = len(np.unique(np.concatenate([part.knots[1] for part in parts]))) - 1
    assert edges == 2 * once - 2 * 5 * rows


def open_edges(tessellation):
    starts, corners = tessellation.face_starts, tessellation.corner_vertices
    count = {}
    for a, b in zip(starts, [*starts[1:], len(corners)]):
        face = corners[a:b]
        for one in zip(face, np.roll(face, -1)):
            count[frozenset(map(int, one))] = count.get(frozenset(map(int, one)), 0) + 1
    return sum(times == 1 for times in count.values())


def test_a_curve_is_closed_by_its_image():
    curve = sc.NurbsCurve(3, knots(7, 3, 0.0), [(0, 0, 0), (1, 0.2, 0), (2, 1, 0), (2, 2, 1), (2, 3, 0), (1, 4, 0), (0, 4, 0)])
    made = mirrored(curve).value
    assert (made.evaluate(made.domain[0]) == made.evaluate(made.domain[1])).all()
    points = made.evaluate(np.linspace(*made.domain, 200))
    assert made.nearest(points * [-1, 1, 1]).distances.max() < 1e-12
    start, end = (made.derivatives(at, 1)[1] for at in made.domain)
    assert abs(start[1:]).max() < 1e-12 and abs(end[1:]).max() < 1e-12 and start[0] * end[0] > 0


def test_two_axes_of_symmetry_are_two_mirrors():
    quarter = sc.NurbsPatch((2, 2), (knots(4, 2, 0.0), knots(4, 2, 0.0)),
                            [[(i / 3, j / 3, 0.2 * (2 - i) * (2 - j)) for j in range(4)] for i in range(4)])
    half = mirrored(sc.PatchSet.from_patches([quarter])).definition
    whole = MIRROR.make([half], axis='y', gap=1e-3, smooth=True)
    assert len(verbs.pieces_of(whole.definition)) == 4 and "2 borders on the plane" in whole.said


def test_without_smoothness_only_the_border_moves():
    patch = random_patch(1.0, 0.3)
    half, _ = verbs.pieces_of(mirrored(sc.PatchSet.from_patches([patch]), smooth=False).definition)
    assert (half.points[1:] == patch.points[1:]).all()


def test_what_does_not_reach_the_plane_is_said():
    patch = random_patch(1.0, 0.0).transformed([[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    made = mirrored(sc.PatchSet.from_patches([patch]))
    assert "no border lies on the plane within 0.001: the halves are apart" in made.said
    across = mirrored(sc.PatchSet.from_patches([patch.transformed(np.diag([1, 1, 1, 1]) + np.eye(4, k=3) * -1.0)]))
    assert across.said.endswith("it crosses the plane")


def test_weights_that_differ_across_are_refused():
    patch = random_patch(1.0, 0.0)
    weights = patch.weights.copy()
    weights[1, 0] *= 2.0
    with pytest.raises(ValueError, match="tangent planes cannot be held"):
        mirrored(sc.PatchSet.from_patches([patch.with_weights(weights)]))
    assert mirrored(sc.PatchSet.from_patches([patch.with_weights(weights)]), smooth=False).said.startswith("1 border")


@pytest.mark.parametrize('axis', 'xyz')
def test_the_axis_is_that_on_whose_plane_a_border_lies(axis):
    patch = random_patch(1.0, 0.0)
    points = np.roll(patch.points + [0, 5, 7], 'xyz'.index(axis), axis=-1)
    turned = sc.PatchSet.from_patches([patch.with_points(points)])
    assert MIRROR.first_values([definitions.from_value(turned)]) == {'axis': axis}


@pytest.mark.parametrize('exponent', (-150, -30, 0, 30, 150))
def test_any_size_is_mirrored_alike(exponent):
    size = 10.0 ** exponent
    patch = random_patch(1.0, 0.3)
    made = mirrored(sc.PatchSet.from_patches([patch.with_points(size * patch.points)]), gap=1e-3 * size)
    half, image = verbs.pieces_of(made.definition)
    assert made.said.startswith("1 border on the plane") and not made.said.endswith("crosses the plane")
    assert (image.points == half.points.swapaxes(0, 1) * [-1, 1, 1]).all()
    assert MIRROR.first_values([definitions.from_value(sc.PatchSet.from_patches([half]))]) == {'axis': 'x'}


def smooth_across(half, image, side, image_side):
    seam = sc.seam_continuity(half, side, image, image_side)
    return seam.gap == 0.0 and seam.g >= 2


def test_the_far_border_of_a_ruled_surface_stays():
    ruled = sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 0, 0, 1, 1, 1]), [[(0, 0, 0), (0, 1, 1), (0, 2, 0)], [(1, 0.5, 2), (2, 1, 3), (1, 3, 2)]])
    half, image = verbs.pieces_of(mirrored(sc.PatchSet.from_patches([ruled])).definition)
    v = np.linspace(0, 1, 30)
    assert half.boundary('u_end').nearest(ruled.evaluate(np.ones(30), v)).distances.max() < 1e-12
    assert smooth_across(half, image, 'u_start', 'v_start')


def test_a_surface_between_two_borders_on_the_plane_is_smooth_at_both():
    bridge = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]), [[(0, 0, 0), (0, 0, 2)], [(2, 1, 0.5), (2, 1.5, 2)], [(0, 3, 0), (0, 3.5, 2)]])
    made = mirrored(sc.PatchSet.from_patches([bridge]))
    half, image = verbs.pieces_of(made.definition)
    assert made.said.startswith("2 borders on the plane")
    assert smooth_across(half, image, 'u_start', 'v_start') and smooth_across(half, image, 'u_end', 'v_end')


def test_a_parabola_between_two_ends_on_the_plane_is_closed_smoothly():
    made = mirrored(sc.BezierCurve([(0, 0, 0), (2, 1, 0), (0, 2, 0)])).value
    ends = [made.derivatives(at, 1)[1] for at in made.domain]
    assert all(abs(slope[1:]).max() < 1e-12 * abs(slope[0]) for slope in ends)


def test_a_plane_that_the_shape_does_not_cross_is_suggested_before_others():
    """A loft of waves that stand on the floor: its first one lies in the plane, the ends of all on the floor, which they cross."""
    waves = [sc.BezierCurve([(-1, y, 0), (-0.3, y, -1.5), (0.3, y, 1.5), (1, y, 0)]) for y in (0.0, 1.0, 2.0)]
    loft = core("shape.definition").from_value(sc.build.loft(waves).value)
    assert core("deform.mirroring").suggested_axis(loft, 0.01) == 'y'


def suggested(value):
    return core("deform.mirroring").suggested_axis(definitions.from_value(value), 0.01)


def test_the_plane_in_which_a_border_lies_is_suggested_and_else_the_nearest_one():
    """A border on XZ; one nearest to XZ; a closed surface has none, and is nearest to XY itself."""
    def strip(near):
        return sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), [[(1, near, 3), (3, near, 4)], [(1, 2, 3), (3, 2, 5)]])
    assert suggested(strip(0.0)) == 'y' and suggested(strip(0.4)) == 'y' and suggested(strip(0.4).swapped()) == 'y'
    assert suggested(sc.BezierCurve([(2, 5, 0.3), (3, 4, 7), (5, 9, 8)])) == 'z'
    assert suggested(sc.build.torus((4, 5, 1), (0, 0, 1), 2.0, 0.4)) == 'z'


def test_what_was_mirrored_across_is_said():
    patch = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), [[(1, 0, 3), (3, 0, 4)], [(1, 2, 3), (3, 2, 5)]])
    assert mirrored(sc.PatchSet.from_patches([patch]), axis='y').said.endswith("across the XZ plane of its origin")
    assert mirrored(sc.PatchSet.from_patches([patch]), axis='y', frame=np.eye(4)).said.endswith("across the XZ plane of the plane object")
