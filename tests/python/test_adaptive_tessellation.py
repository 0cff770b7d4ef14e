"""Meshes with as many faces as the shape asks for: their promise, and that they hold together (lecture row S22)."""

import json
from pathlib import Path

import numpy as np
import pytest

import splinecore as sc
from meshes import counts_of, edges_of, faces_of, largest_distance, smallest_angle, triangles_of
from sheets import random_sheet, set_of

TEAPOT = json.loads((Path(__file__).resolve().parents[2] / "addon/splinewright/core/shape/teapot.json").read_text())


def teapot():
    points = np.array(TEAPOT['points']) / TEAPOT['body_radius']
    return sc.PatchSet(points, [np.array(rows, dtype=np.int32).reshape(4, 4) for rows in TEAPOT['patches']])


def around_z(points, weights):
    """Revolved: a circle of nine points for each point of a profile (n, 2) in the half plane x >= 0."""
    ring = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], dtype=float)
    ring_weights = np.where(np.arange(9) % 2, np.sqrt(0.5), 1.0)
    knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    net = np.zeros((9, len(points), 3))
    net[..., :2] = ring[:, None] * points[None, :, :1]
    net[..., 2] = points[:, 1]
    degree = 2
    profile = [0, 0, 0, 1, 1, 1] if len(points) == 3 else [0, 0, 0, 1, 1, 2, 2, 2] if len(points) == 5 else None
    profile = profile or [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    return sc.NurbsPatch((2, degree), (knots, profile), net, np.outer(ring_weights, weights))


def sphere():
    s = np.sqrt(0.5)
    return around_z(np.array([(0, -1), (1, -1), (1, 0), (1, 1), (0, 1)]), [1, s, 1, s, 1])


def torus():
    ring = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)])
    return around_z(2 + 0.5 * ring * (1, 1) - (0, 2), np.where(np.arange(9) % 2, np.sqrt(0.5), 1.0))


def hill():
    """Flat but for its middle."""
    net = np.zeros((14, 14, 3))
    net[..., 0], net[..., 1] = np.meshgrid(np.arange(14.0), np.arange(14.0), indexing='ij')
    net[6:8, 6:8, 2] = 3.0
    knots = [0, 0, 0, *range(12), 11, 11, 11]
    return sc.NurbsPatch((3, 3), (knots, knots), net)


SHAPES = {'teapot': teapot, 'sphere': lambda: set_of(sphere()), 'torus': lambda: set_of(torus()),
          'hill': lambda: set_of(hill()), **{f"random {i}": lambda i=i: set_of(random_sheet(i)) for i in range(8)}}


@pytest.mark.parametrize('tolerance', (0.1, 0.01, 0.003))
@pytest.mark.parametrize('name', SHAPES)
def test_no_point_of_the_surface_is_farther_from_the_mesh_than_the_tolerance(name, tolerance):
    patch_set = SHAPES[name]()
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=tolerance)
    positions, _ = mesh.evaluate(patch_set)
    assert largest_distance(mesh, patch_set, positions) <= tolerance * (1 + 1e-4)


@pytest.mark.parametrize('angle', (0.5, 0.2))
@pytest.mark.parametrize('name', ['sphere', 'torus', 'hill', 'random 3'])
def test_normals_on_a_face_turn_no_more_than_the_angle(name, angle):
    patch_set = SHAPES[name]()
    mesh = sc.Tessellation.adaptive(patch_set, angle=angle)
    _, normals = mesh.evaluate(patch_set)
    for corners in faces_of(mesh):
        cosines = normals[corners].astype(float) @ normals[corners].astype(float).T
        assert np.arccos(np.clip(cosines, -1, 1)).max() <= angle + 1e-3


@pytest.mark.parametrize('smallest', (0.02, 0.1, 0.3))
@pytest.mark.parametrize('name', ['sphere', 'torus', 'teapot', 'random 3'])
def test_sides_turn_more_than_the_angle_only_where_they_are_no_longer_than_the_smallest(name, smallest):
    """A face beside smaller ones has diagonals of its cell for sides, too."""
    patch_set, angle = SHAPES[name](), 0.1
    mesh = sc.Tessellation.adaptive(patch_set, angle=angle, smallest=smallest)
    positions, normals = mesh.evaluate(patch_set)
    for corners in (corners for corners in faces_of(mesh) if len(corners) == 4):
        after = np.roll(corners, -1)
        cosines = np.einsum('ij,ij->i', normals[corners].astype(float), normals[after].astype(float))
        lengths = np.linalg.norm(positions[mesh.corner_vertices[corners]] - positions[mesh.corner_vertices[after]], axis=1)
        assert ((np.arccos(np.clip(cosines, -1, 1)) <= angle + 1e-3) | (lengths <= 1.5 * smallest)).all()
    whole = sc.Tessellation.adaptive(patch_set, angle=angle).vertex_count
    assert mesh.vertex_count < 0.3 * whole if smallest == 0.3 else mesh.vertex_count <= whole


@pytest.mark.parametrize('radius', (0.02, 0.3, 1.0, 3.0))
def test_pipes_that_fold_have_as_many_faces_as_the_smallest_allows(radius):
    """In the folds normals turn at once: by angle alone there would be millions."""
    axis = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3],
                         [(-1.5, 0, 0), (-1, 1, 0.3), (-0.3, -1, 0), (0.4, 1, 0.5), (1, -1, 0), (1.5, 0.3, 0)])
    patch_set = set_of(*sc.build.pipe(axis, radius).value)
    size = np.linalg.norm(np.ptp(patch_set.points, axis=0))
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=1e-3 * size, angle=np.radians(15), smallest=size / 200)
    assert mesh.vertex_count < 60_000


@pytest.mark.parametrize('settings', ({'tolerance': 0.2}, {'tolerance': 0.01}, {'angle': 0.3}, {'tolerance': 5.0}))
@pytest.mark.parametrize('name, free, euler', (('sphere', 0, 2), ('torus', 0, 0)))
def test_closed_shapes_are_closed_and_have_their_genus(name, free, euler, settings):
    patch_set = SHAPES[name]()
    mesh = sc.Tessellation.adaptive(patch_set, **settings)
    assert counts_of(mesh) == (free, 0, 0)
    assert mesh.vertex_count - len(edges_of(mesh)) + len(faces_of(mesh)) == euler


@pytest.mark.parametrize('settings', ({'tolerance': 0.1}, {'tolerance': 0.002}, {'angle': 0.3}))
def test_the_teapot_is_open_at_its_rims_only(settings):
    mesh = sc.Tessellation.adaptive(teapot(), **settings)
    free, many, against = counts_of(mesh)
    assert many == against == 0
    positions, _ = mesh.evaluate(teapot())
    free_edges = [edge for edge, faces in edges_of(mesh).items() if len(faces) == 1]
    assert len(free_edges) == free > 0
    # The rims of body and lid, the ends of handle and spout, as the mesh by count has them.
    fine = sc.Tessellation(teapot(), 64)
    rims = fine.evaluate(teapot())[0][[v for edge, faces in edges_of(fine).items() if len(faces) == 1 for v in edge]]
    for vertex in {v for edge in free_edges for v in edge}:
        assert np.linalg.norm(rims - positions[vertex], axis=1).min() < 0.02


def test_sides_that_are_not_one_curve_stay_apart():
    flat = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    bent = sc.BezierPatch([[(1, 0, 0), (1, 0.5, 0.2), (1, 1, 0)], [(2, 0, 0), (2, 0.5, 0), (2, 1, 0)]])
    mesh = sc.Tessellation.adaptive(set_of(flat, bent), tolerance=0.01)
    ends = [(1, 0, 0), (1, 1, 0)]
    positions, _ = mesh.evaluate(set_of(flat, bent))
    apart = [edge for edge, faces in edges_of(mesh).items() if len(faces) == 1 and (positions[list(edge), 0] == 1).all()]
    assert len(apart) > 2 and all(any(np.array_equal(p, end) for p in positions) for end in ends)


def test_flat_parts_get_few_faces_and_the_uniform_grid_that_keeps_the_promise_many():
    patch_set = set_of(hill())
    for tolerance in (0.05, 0.005):
        mesh = sc.Tessellation.adaptive(patch_set, tolerance=tolerance)
        resolution = 1
        while True:
            grid = sc.Tessellation(patch_set, resolution)
            if largest_distance(grid, patch_set, grid.evaluate(patch_set)[0]) <= tolerance:
                break
            resolution += 1
        assert len(mesh.face_starts) < 0.5 * len(grid.face_starts)


@pytest.mark.parametrize('name', ['teapot', 'sphere', 'torus', 'hill'])
def test_no_triangle_is_a_sliver_or_empty(name):
    patch_set = SHAPES[name]()
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=0.02)
    positions, _ = mesh.evaluate(patch_set)
    assert smallest_angle(mesh, positions) > np.radians(0.5)


def test_faces_are_quads_where_cells_have_one_size():
    mesh = sc.Tessellation.adaptive(set_of(torus()), tolerance=0.01)
    sizes = np.array([len(corners) for corners in faces_of(mesh)])
    assert (sizes == 4).mean() > 0.7 and set(sizes) <= {3, 4}
    plane = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    assert [len(c) for c in faces_of(sc.Tessellation.adaptive(set_of(plane), tolerance=1e-9))] == [4]


def test_evaluation_follows_moved_points_on_the_same_faces():
    patch_set = teapot()
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=0.05)
    moved = patch_set.with_points(patch_set.points + (1, 2, 3))
    assert mesh.fits(moved)
    assert np.allclose(mesh.evaluate(moved)[0], mesh.evaluate(patch_set)[0] + (1, 2, 3), atol=1e-6)
    assert np.array_equal(mesh.evaluate_positions(moved), mesh.evaluate(moved)[0])


def test_corner_normals_are_exact_and_creases_sharp():
    patch_set = set_of(sphere())
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=0.05)
    positions, normals = mesh.evaluate(patch_set)
    outward = positions[mesh.corner_vertices]
    assert np.abs((normals * outward).sum(1) - 1).max() < 1e-6
    assert len(mesh.sharp_edges(normals, 0.1)) == 0
    roof = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]),
                         [[(0, 0, 0), (0, 1, 0)], [(1, 0, 1), (1, 1, 1)], [(2, 0, 0), (2, 1, 0)]])
    mesh = sc.Tessellation.adaptive(set_of(roof), tolerance=0.1)
    assert len(mesh.sharp_edges(mesh.evaluate(set_of(roof))[1], 0.5)) == 1


def test_triangles_cover_the_parameters_of_every_patch():
    patch_set = teapot()
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=0.02)
    area = np.zeros(len(patch_set))
    for corners in faces_of(mesh):
        u, v = mesh.corner_uvs[corners].astype(float).T
        area[mesh.face_patches[np.searchsorted(mesh.face_starts, corners[0])]] += 0.5 * (
            u * np.roll(v, -1) - np.roll(u, -1) * v).sum()
    assert (area > 0.9).all() and (area <= 1 + 1e-6).all()


@pytest.mark.parametrize('settings, word', (
    ({'tolerance': 0.0}, "above 0"), ({'tolerance': -1.0}, "above 0"), ({'angle': 0.0}, "above 0"), ({'smallest': -1.0}, "below 0"),
    ({'tolerance': np.nan}, "finite"), ({'tolerance': 1e-12}, "more than 2\\^21")))
def test_bad_numbers_are_refused_with_a_word(settings, word):
    with pytest.raises(sc.InvalidShape, match=word):
        sc.Tessellation.adaptive(set_of(sphere()), **settings)


def test_a_patch_that_runs_to_infinity_is_refused():
    patch = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]], [[1, 1], [-1, 1]])
    with pytest.raises((sc.InvalidShape, sc.PointAtInfinity), match="infinity"):
        sc.Tessellation.adaptive(set_of(patch), tolerance=0.1)


def test_without_a_tolerance_there_are_as_few_cells_as_knots_allow():
    mesh = sc.Tessellation.adaptive(set_of(hill()))
    assert len(triangles_of(mesh)) >= 2 and largest_distance(mesh, set_of(hill()), mesh.evaluate(set_of(hill()))[0]) > 0


def test_a_surface_that_folds_over_is_not_refined_without_end():
    """Around the pole the second row bends back, so that normals jump along a line that ends there."""
    ring = np.array([(0.2, 0.0), (0.173, -0.015), (0.1, -0.032), (0, -0.04), (-0.1, -0.032), (-0.173, -0.015), (-0.2, 0.0),
                     (-0.173, 0.005), (-0.1, 0.002), (0, 0.0), (0.1, 0.002), (0.173, 0.005)])
    rows = [0 * ring, ring, 1.5 * ring, 2 * ring]
    net = np.array([np.column_stack([np.full(12, 0.2 * max(i - 1, 0)), row]) for i, row in enumerate(rows)])
    tip = sc.NurbsPatch((3, 3), ([0, 0, 0, 0, 1, 1, 1, 1], np.arange(13.0)), net, periodic=(False, True))
    mesh = sc.Tessellation.adaptive(set_of(tip), angle=0.5)
    assert 100 < len(mesh.face_starts) < 2**20
    assert counts_of(mesh)[1:] == (0, 0)


@pytest.mark.parametrize('rows', (1, 2, 3))
def test_poles_of_several_rows_have_few_faces(rows):
    """Lines to such a pole are straight, and slow at its end: they are no reason for a cut."""
    fan = np.array([(np.cos(t), np.sin(t), 0.1) for t in np.linspace(0, np.pi / 2, 4)])
    net = np.array([s * fan for s in np.r_[np.zeros(rows), np.linspace(0, 1, 5 - rows)[1:]]])
    patch_set = set_of(sc.BezierPatch(net))
    mesh = sc.Tessellation.adaptive(patch_set, tolerance=1e-3)
    assert largest_distance(mesh, patch_set, mesh.evaluate(patch_set)[0]) <= 1e-3 * (1 + 1e-4)
    assert mesh.vertex_count < 300


def test_a_pole_inside_a_cell_takes_few_faces(inputs):
    """A profile that crosses the axis where no knot is: triangles about the pole are as long however often they are cut."""
    for seed in range(inputs(300)):
        rng = np.random.default_rng([77, seed])
        points = np.array([(-1.0, -1, 0), (-0.6, -0.475, 0), (-0.2, -0.3, 0), (0.2, 0.3, 0), (0.6, 0.475, 0), (1, 1, 0)])
        points = points * (1, 10 ** rng.uniform(-1, 1), 1) + (rng.choice([-1, 1]) * 10 ** rng.uniform(-14, -0.5), 0, 0)
        profile = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], points)
        made = sc.PatchSet.from_patches([sc.build.revolve(profile, (0, 0, 0), (0, 1, 0), rng.choice([1.0, 4.0, 2 * np.pi]))])
        size = np.linalg.norm(np.ptp(made.points, axis=0))
        share = 10 ** rng.uniform(-4, -2)
        angle = rng.choice([None, np.radians(15)])
        mesh = sc.Tessellation.adaptive(made, tolerance=share * size, angle=angle, smallest=size / 200 if angle else 0.0)
        assert mesh.vertex_count < 60 / share + 40000 * (angle is not None), (seed, mesh.vertex_count, share, angle)
