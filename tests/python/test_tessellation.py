"""Tessellation: shared vertices, poles, normals, sharp edges (row S22)."""

import numpy as np
import pytest

import splinecore as sc
from shapes import cylinder, patches, sphere_octant, torus, wavy_patch
from test_patch_set import POOL, SQUARES


def faces_of(mesh):
    starts = [*mesh.face_starts, len(mesh.corner_vertices)]
    return [mesh.corner_vertices[start:end].tolist() for start, end in zip(starts, starts[1:])]


def edges_of(mesh):
    edges = {}
    for face in faces_of(mesh):
        for a, b in zip(face, face[1:] + face[:1]):
            edges.setdefault(frozenset((a, b)), []).append((a, b))
    return edges


def cube():
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    return sc.PatchSet(corners, [[[0, 1], [2, 3]], [[4, 6], [5, 7]], [[0, 4], [1, 5]], [[2, 3], [6, 7]],
                                 [[0, 2], [4, 6]], [[1, 5], [3, 7]]])


def test_neighbors_share_the_vertices_of_their_edge():
    mesh = sc.Tessellation(sc.PatchSet(POOL, SQUARES), 4)
    assert mesh.vertex_count == 9 * 5 and len(mesh.face_starts) == 32
    assert mesh.face_patches.tolist() == [0] * 16 + [1] * 16
    assert max(map(len, edges_of(mesh).values())) == 2


def test_resolution_may_differ_along_u_and_v():
    one = sc.PatchSet(POOL, SQUARES[:1])
    assert len(sc.Tessellation(one, (2, 5)).face_starts) == 10
    assert sc.Tessellation(one, [2, 5]).vertex_count == 18
    assert sc.Tessellation(one, np.int32(3)).vertex_count == 16


def plain_patch():
    return sc.BezierPatch(np.random.default_rng(5).uniform(-1, 1, (5, 4, 3)))


@pytest.mark.parametrize("make", [torus, cylinder, wavy_patch, sphere_octant, plain_patch])
def test_positions_alone_are_those_of_evaluate_in_every_bit(make):
    one = sc.PatchSet.from_patches([make()])
    mesh = sc.Tessellation(one, 5)
    moved = one.with_points(one.points * 1.5 + 0.25)
    positions = mesh.evaluate_positions(moved)
    assert positions.dtype == np.float32 and np.array_equal(positions, mesh.evaluate(moved)[0])
    with pytest.raises(sc.InvalidShape, match="does not fit"):
        mesh.evaluate_positions(cube())
    with pytest.raises(TypeError, match="PatchSet"):
        mesh.evaluate_positions(make())


@pytest.mark.parametrize("patch, euler", [(torus(), 0), (cylinder(), 0)])
def test_closed_directions_close_the_mesh(patch, euler):
    mesh = sc.Tessellation(sc.PatchSet.from_patches([patch]), 3)
    edges, faces = edges_of(mesh), faces_of(mesh)
    assert mesh.vertex_count - len(edges) + len(faces) == euler
    assert all(len(set(way)) == len(way) for way in edges.values())


def test_a_cube_is_closed_and_wound_outwards():
    mesh = sc.Tessellation(cube(), 3)
    edges = edges_of(mesh)
    assert mesh.vertex_count - len(edges) + len(faces_of(mesh)) == 2
    assert all(len(way) == 2 and way[0] == way[1][::-1] for way in edges.values())
    positions, normals = mesh.evaluate(cube())
    outwards = positions[mesh.corner_vertices] - 0.5
    signs = np.sign((outwards * normals).sum(axis=1))
    assert len(set(signs)) == 1


def test_a_pole_is_one_vertex_with_triangles_around_it():
    octant = sc.PatchSet.from_patches([sphere_octant()])
    mesh = sc.Tessellation(octant, 8)
    sizes = [len(face) for face in faces_of(mesh)]
    assert sizes.count(3) == 8 and sizes.count(4) == 56
    assert mesh.vertex_count == 9 * 8 + 1
    positions, normals = mesh.evaluate(octant)
    assert np.abs(np.linalg.norm(positions, axis=1) - 1).max() <= 1e-7
    assert np.abs(normals - positions[mesh.corner_vertices]).max() <= 2e-7
    assert (np.abs(positions - (0, 0, 1)).max(axis=1) < 1e-12).sum() == 1


def test_positions_are_the_points_of_the_surface():
    for patch in patches():
        pool = sc.PatchSet.from_patches([patch])
        mesh = sc.Tessellation(pool, 3)
        positions, normals = mesh.evaluate(pool)
        assert positions.shape == (mesh.vertex_count, 3) and positions.dtype == normals.dtype == np.float32
        (u0, u1), (v0, v1) = patch.domain
        u, v = np.float64(mesh.corner_uvs).T
        expected = patch.evaluate(np.clip(u0 + u * (u1 - u0), u0, u1), np.clip(v0 + v * (v1 - v0), v0, v1))
        assert np.abs(positions[mesh.corner_vertices] - expected).max() <= 1e-4
        assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() <= 1e-6


def test_faces_are_wound_along_their_normals():
    pool = sc.PatchSet.from_patches([torus(), sphere_octant()])
    mesh = sc.Tessellation(pool, 6)
    positions, normals = mesh.evaluate(pool)
    for start, face in zip(mesh.face_starts, faces_of(mesh)):
        a, b, c = positions[face[:3]]
        assert np.cross(b - a, c - a) @ normals[start] > 0


def test_one_tessellation_serves_every_position():
    pool = sc.PatchSet.from_patches([torus()])
    mesh = sc.Tessellation(pool, 4)
    moved = pool.with_points(pool.points + (5, 0, 0))
    assert mesh.fits(pool) and mesh.fits(moved)
    there, normals = mesh.evaluate(moved)
    here, same = mesh.evaluate(pool)
    assert np.abs(there - here - (5, 0, 0)).max() <= 1e-6 and np.abs(normals - same).max() <= 1e-6
    other = sc.PatchSet.from_patches([wavy_patch()])
    assert not mesh.fits(other)
    with pytest.raises(sc.InvalidShape, match="patch_set"):
        mesh.evaluate(other)


def test_edges_of_a_cube_are_sharp_and_those_of_a_torus_are_not():
    mesh = sc.Tessellation(cube(), 3)
    sharp = mesh.sharp_edges(mesh.evaluate(cube())[1], 0.5)
    assert sharp.shape == (36, 2) and sharp.dtype == np.int32
    assert {frozenset(pair) for pair in sharp.tolist()} <= set(edges_of(mesh))
    assert len(mesh.sharp_edges(mesh.evaluate(cube())[1], 1.6)) == 0
    ring = sc.PatchSet.from_patches([torus()])
    round_mesh = sc.Tessellation(ring, 4)
    assert round_mesh.sharp_edges(round_mesh.evaluate(ring)[1], 0.01).shape == (0, 2)


def test_a_flipped_set_has_the_same_points_and_turned_normals():
    pool = sc.PatchSet.from_patches([sphere_octant()])
    mesh = sc.Tessellation(pool.flipped(), 4)
    positions, normals = mesh.evaluate(pool.flipped())
    assert np.abs(normals + positions[mesh.corner_vertices]).max() <= 2e-7


def test_results_are_the_same_bits_every_time():
    pool = sc.PatchSet.from_patches(patches())
    one, other = (sc.Tessellation(pool, 3) for _ in range(2))
    for a, b in zip(one.evaluate(pool), other.evaluate(pool)):
        assert a.tobytes() == b.tobytes()
    assert one.corner_uvs.tobytes() == other.corner_uvs.tobytes()


@pytest.mark.parametrize("resolution, error", [
    (0, sc.InvalidShape), (-1, sc.InvalidShape), (4097, sc.InvalidShape), (10**30, sc.InvalidShape),
    ((1, 0), sc.InvalidShape), ((3, 10**9), sc.InvalidShape), (None, TypeError), (2.0, TypeError), ("2", TypeError),
    ("22", TypeError), ((1, 2, 3), TypeError), ((1,), TypeError), (True, TypeError), ((2, 2.5), TypeError)])
def test_a_bad_resolution_is_named(resolution, error):
    with pytest.raises(error, match="^resolution"):
        sc.Tessellation(sc.PatchSet(POOL, SQUARES), resolution)


def test_more_samples_than_memory_are_refused():
    many = sc.PatchSet(POOL, SQUARES[:1] * 20)
    with pytest.raises(sc.InvalidShape, match="samples|resolution"):
        sc.Tessellation(many, 4096)


def test_bad_arguments_are_named():
    mesh = sc.Tessellation(cube(), 1)
    normals = mesh.evaluate(cube())[1]
    for call in (lambda: sc.Tessellation(torus(), 2), lambda: mesh.evaluate(None), lambda: mesh.fits(3)):
        with pytest.raises(TypeError, match="patch_set must be a PatchSet"):
            call()
    with pytest.raises(sc.InvalidShape, match=r"normals has shape \(72,\), \(24, 3\)"):
        mesh.sharp_edges(normals.ravel(), 0.5)
    with pytest.raises(sc.InvalidShape, match="angle = nan"):
        mesh.sharp_edges(normals, np.nan)
    with pytest.raises(TypeError, match="angle"):
        mesh.sharp_edges(normals, "1")
