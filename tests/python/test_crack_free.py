"""Meshes of several patches hold together, whatever the knots, degrees and directions of their sides (row S22)."""

import numpy as np
import pytest

import splinecore as sc
from meshes import counts_of, edges_of, faces_of
from sheets import halves, random_sheet, set_of

MESHES = {**{f"count {n}": lambda patch_set, n=n: sc.Tessellation(patch_set, n) for n in (1, 3, (2, 5), (7, 2))},
          **{f"tolerance {t}": lambda patch_set, t=t: sc.Tessellation.adaptive(patch_set, tolerance=t)
             for t in (0.3, 0.01)}}
CHANGES = {'finer': lambda p: p.refine('v', np.linspace(*p.domain[1], 9)[1:-1]),
           'against': lambda p: p.reversed('v'), 'across': lambda p: p.swapped(),
           'a knot': lambda p: p.insert_knot('v', np.mean(p.domain[1])),
           'an uneven knot': lambda p: p.insert_knot('v', 0.9 * p.domain[1][0] + 0.1 * p.domain[1][1]),
           'raised': lambda p: p.elevate('v'), 'other domain': lambda p: p.with_domain('v', (3, 8)),
           'raised across': lambda p: p.swapped().elevate('u', 2).reversed('u').refine('u', [0.7, 0.8])}


def border_of(mesh):
    """The rings of edges with one face, as lists of vertices."""
    neighbors = {}
    for a, b in (edge for edge, faces in edges_of(mesh).items() if len(faces) == 1):
        neighbors.setdefault(a, []).append(b)
        neighbors.setdefault(b, []).append(a)
    assert all(len(found) == 2 for found in neighbors.values())
    rings, left = [], set(neighbors)
    while left:
        ring, waiting = [], [min(left)]
        while waiting:
            vertex = waiting.pop()
            if vertex in left:
                left.remove(vertex)
                ring.append(vertex)
                waiting += neighbors[vertex]
        rings.append(ring)
    return rings


def areas_in_parameters(mesh):
    """Of each face, in units of its patch's domain."""
    areas = []
    for corners in faces_of(mesh):
        u, v = mesh.corner_uvs[corners].astype(float).T
        areas.append(0.5 * (u * np.roll(v, -1) - np.roll(u, -1) * v).sum())
    return np.array(areas)


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
@pytest.mark.parametrize('change', CHANGES.values(), ids=CHANGES)
def test_two_halves_of_a_sheet_have_one_border(change, make):
    before, after = halves(0.4)
    patch_set = set_of(before, change(after))
    mesh = make(patch_set)
    positions, _ = mesh.evaluate(patch_set)
    assert len(border_of(mesh)) == 1
    assert len(np.unique(np.round(positions, 6), axis=0)) == mesh.vertex_count
    assert counts_of(mesh)[1] == 0


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
@pytest.mark.parametrize('change', CHANGES.values(), ids=CHANGES)
def test_faces_fill_the_domain_of_every_patch_and_none_is_turned(change, make):
    before, after = halves(0.4)
    mesh = make(set_of(before, change(after)))
    areas = areas_in_parameters(mesh)
    assert areas.min() > 0
    for patch in (0, 1):
        assert abs(areas[mesh.face_patches == patch].sum() - 1) < 1e-5


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
def test_four_patches_of_different_resolution_around_a_point_have_one_border(make):
    low, high = halves(0.6, seed=12)
    middle = np.mean(low.domain[1])
    (a, b), (c, d) = low.split('v', middle), high.split('v', middle)
    parts = a.refine('u', np.linspace(*a.domain[0], 6)[1:-1]), b.swapped(), c.elevate('v'), d.reversed('u').elevate('u')
    mesh = make(set_of(*parts))
    assert len(border_of(mesh)) == 1 and counts_of(mesh)[1] == 0


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
@pytest.mark.parametrize('turned', (False, True))
def test_a_can_whose_lids_have_other_knots_is_closed(turned, make):
    low, high, up = (0, 0, 0), (0, 0, 2), (0, 0, 1)
    mantle = sc.build.cylinder(low, up, 1.0, 2.0)
    lid = sc.build.disc(high, up, 1.0).insert_knot('u', 0.1)
    bottom = sc.build.disc(low, up, 1.0).elevate('u', 2).reversed('v')
    if turned:
        lid, bottom = lid.reversed('u').reversed('v'), bottom.swapped().reversed('u').reversed('v')
    mesh = make(set_of(mantle, lid, bottom))
    assert counts_of(mesh)[:2] == (0, 0)
    assert mesh.vertex_count - len(edges_of(mesh)) + len(faces_of(mesh)) == 2


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
def test_a_periodic_tube_and_its_plain_continuation_are_one(make):
    ring = np.array([(np.cos(a), np.sin(a), 0) for a in 2 * np.pi * np.arange(7) / 7])
    net = np.stack([ring, ring + (0, 0, 1), 2 * ring + (0, 0, 2)], 1)
    tube = sc.NurbsPatch((3, 2), (np.arange(8.0), [0, 0, 0, 1, 1, 1]), net, periodic=(True, False))
    part, rest = tube.split('v', 0.3)
    plain = rest.clamped('u').refine('u', [0.5, 2.5])
    mesh = make(set_of(part, plain.reversed('u')))
    assert len(border_of(mesh)) == 2 and counts_of(mesh)[1] == 0


@pytest.mark.parametrize('resolution', ((1, 1), (2, 3), (5, 4), (3, 16)))
@pytest.mark.parametrize('seed', range(12))
def test_random_halves_hold_together(seed, resolution):
    random = np.random.default_rng(seed)
    before, after = halves(random.uniform(0.1, 0.9), seed)
    low, high = after.domain[1]
    after = after.refine('v', np.sort(random.uniform(low, high, random.integers(1, 6))))
    after = after if seed % 2 else after.reversed('v')
    mesh = sc.Tessellation(set_of(before, after if seed % 3 else after.swapped()), resolution)
    assert len(border_of(mesh)) == 1 and areas_in_parameters(mesh).min() > 0


def test_normals_beside_an_edge_are_those_of_the_patch_they_belong_to():
    before, after = halves(0.4)
    patch_set = set_of(before, after.refine('v', np.linspace(*after.domain[1], 9)[1:-1]))
    mesh = sc.Tessellation(patch_set, (3, 2))
    positions, normals = mesh.evaluate(patch_set)
    of_face = np.repeat(mesh.face_patches, np.diff([*mesh.face_starts, len(mesh.corner_vertices)]))
    for i in (0, 1):
        corners = np.flatnonzero(of_face == i)
        (a, b), (c, d) = patch_set[i].domain
        u, v = mesh.corner_uvs[corners].astype(float).T
        inside = (u > 0) & (u < 1) & (v > 0) & (v < 1)
        points = patch_set[i].evaluate(np.clip(a + u * (b - a), a, b), np.clip(c + v * (d - c), c, d))
        assert np.abs(points - positions[mesh.corner_vertices[corners]]).max() < 1e-5
        assert inside.any()
    assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-6


def test_a_seam_that_comes_apart_does_not_fit_any_more():
    before, after = halves(0.4)
    mesh = sc.Tessellation(set_of(before, after), 3)
    assert mesh.fits(set_of(before, after))
    moved = set_of(before, after.with_points(after.points + (0, 0, 0.01)))
    assert not mesh.fits(moved)
    assert not mesh.fits(moved, set_of(before, after)) and mesh.fits(set_of(before, after), moved)
    assert np.isfinite(mesh.evaluate_positions(moved)).all(), "whether it fits is for the caller to ask"
    assert not sc.Tessellation(moved, 3).fits(set_of(before, after))


def test_bad_sets_are_refused():
    with pytest.raises(sc.InvalidShape, match="resolution"):
        sc.Tessellation(set_of(random_sheet(1)), 0)
    with pytest.raises(sc.InvalidShape, match="no face"):
        sc.Tessellation(set_of(sc.BezierPatch(np.zeros((2, 2, 3)))), 2)


@pytest.mark.parametrize('make', MESHES.values(), ids=MESHES)
@pytest.mark.parametrize('degree', (1, 2, 3))
def test_knots_a_rounding_apart_are_one_crease_without_faces_between(degree, make):
    near = np.nextafter(1.0, 2.0)
    knots = [*[0.0] * (degree + 1), *[1.0] * degree, near, *[3.0] * (degree + 1)]
    net = np.random.default_rng(5).uniform(-0.2, 0.2, (2 * degree + 2, 2, 3))
    net[..., 0] += np.arange(2 * degree + 2)[:, None]
    net[degree + 1:, :, 0] -= 1
    net[degree + 1] = net[degree]
    net[..., 1] += np.arange(2)
    patch_set = set_of(sc.NurbsPatch((degree, 1), (knots, [0, 0, 1, 1]), net))
    mesh = make(patch_set)
    positions, normals = mesh.evaluate(patch_set)
    assert len(border_of(mesh)) == 1 and areas_in_parameters(mesh).min() > 1e-6
    assert len(mesh.sharp_edges(normals, 0.01)) > 0


@pytest.mark.parametrize('counts', ((2, 3), (64, 96), (100, 101), (64, 65)))
def test_knots_that_never_meet_do_not_refine_one_another_without_end(counts):
    parts = [sc.build.plane((x, 0, 0), (1, 0, 0), (0, 4, 0)).to_nurbs().refine('v', np.arange(1, n) / n)
             for x, n in enumerate(counts)]
    mesh = sc.Tessellation.adaptive(set_of(*parts), tolerance=0.01)
    assert len(mesh.face_starts) <= 4 * sum(counts) and len(border_of(mesh)) == 1
