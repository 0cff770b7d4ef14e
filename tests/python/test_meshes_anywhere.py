"""Meshes do not depend on how large or how far a shape is, nor on what else is in the set, and lose no span."""

import time

import numpy as np
import pytest

import mesh_checks
import splinecore as sc
from sheets import set_of
from test_adaptive_tessellation import SHAPES, sphere, teapot

ADAPTIVE = lambda patch_set: sc.Tessellation.adaptive(patch_set, tolerance=1e-6)
BY_COUNT = lambda patch_set: sc.Tessellation(patch_set, 1)


def stair(gap, degree_v=1, start=0.0):
    """Along u it runs flat, rises by 7 within a span as short as `gap`, and comes down again."""
    profile = np.array([(0, 0, 0), (1, 0, 0), (1, 0, 7), (2, 0, 0)], dtype=float)
    net = profile[:, None] + np.linspace((0, 0, 0), (0, 1, 0), degree_v + 1)
    knots = [start, start, start + 1, start + 1 + gap, start + 2, start + 2]
    return sc.NurbsPatch((1, degree_v), (knots, [0] * (degree_v + 1) + [1] * (degree_v + 1)), net)


@pytest.mark.parametrize('make', (ADAPTIVE, BY_COUNT))
@pytest.mark.parametrize('gap', (1e-6, 2e-10, 1e-13, *(ulps * np.spacing(1.0) for ulps in range(1, 10))))
def test_a_span_however_short_keeps_its_corners(make, gap):
    far = gap * np.spacing(2.0**10) / np.spacing(1.0)
    for patch in (stair(gap), stair(gap).swapped(), stair(gap).reversed('u'), stair(gap, degree_v=2),
                  stair(far, start=2.0**10), stair(far, start=-2.0**10)):
        mesh = make(set_of(patch))
        positions, _ = mesh.evaluate(set_of(patch))
        for x, z in ((0, 0), (1, 0), (1, 7), (2, 0)):
            for y in (0, 1):
                assert np.linalg.norm(positions - (x, y, z), axis=1).min() < 1e-6
        mesh_checks.check_borders(mesh_checks.mesh_of(set_of(patch), mesh), [dict.fromkeys(mesh_checks.SIDES, 'free')])


@pytest.mark.parametrize('make', (ADAPTIVE, BY_COUNT))
@pytest.mark.parametrize('gap', (2e-10, *(ulps * np.spacing(1.0) for ulps in range(1, 10))))
@pytest.mark.parametrize('turn', (lambda patch: patch, lambda patch: patch.reversed('u').reversed('v'),
                                  lambda patch: patch.swapped().reversed('v')))
def test_patches_side_by_side_keep_their_short_spans_together(make, gap, turn):
    one = stair(gap)
    beside = turn(sc.NurbsPatch(one.degree, one.knots, one.points + (0, 1, 0)))
    mesh = make(set_of(one, beside))
    alone = make(set_of(one))
    assert set_of(one, beside).edge_counts()['shared'] == 1
    assert len(mesh.face_starts) == 2 * len(alone.face_starts)
    assert mesh.vertex_count < 2 * alone.vertex_count


def ridge(gap, peak, start=0.0, length=2.0):
    """Along u it runs flat but for a peak inside a span as short as `gap`."""
    net = np.array([(0, 0, 0), (1, 0, 0), (1, 1, peak), (1, 0, 0), (2, 0, 0)], float)[:, None] + [(0, 0, 0), (0, 1, 0)]
    net[:, :, 1] = (0, 1)
    knots = start + length / 2 * np.array([0, 0, 1, 1 + gap / 2, 1 + gap, 2, 2])
    return sc.NurbsPatch((1, 1), (knots, [0, 0, 1, 1]), net)


@pytest.mark.parametrize('gap', (1e-6, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15))
@pytest.mark.parametrize('turn', (lambda patch: patch, lambda patch: patch.reversed('u'),
                                  lambda patch: patch.elevate('u')))
def test_a_peak_on_a_short_span_is_not_taken_for_a_flat_side(gap, turn):
    flat = ridge(gap, 0)
    beside = turn(sc.NurbsPatch(flat.degree, flat.knots, flat.points - (0, 1, 0)))
    plain = turn(sc.BezierPatch([[(0, -1, 0), (0, 0, 0)], [(2, -1, 0), (2, 0, 0)]]).to_nurbs())
    for other in (beside, plain):
        for patch_set in (set_of(ridge(gap, 7), other), set_of(other, ridge(gap, 7))):
            assert patch_set.edge_counts()['shared'] == 0
            positions, _ = ADAPTIVE(patch_set).evaluate(patch_set)
            for y in (0, 1):
                assert np.linalg.norm(positions - (1, y, 7), axis=1).min() < 1e-6


@pytest.mark.parametrize('gap', (1e-6, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15))
@pytest.mark.parametrize('start, length', ((0.0, 2.0), (0.0, 2 / 3), (0.1, 0.7), (-1.0, 2.0), (3.0, 1.0)))
@pytest.mark.parametrize('turn', (lambda patch: patch, lambda patch: patch.reversed('u'),
                                  lambda patch: patch.elevate('u')))
def test_sides_that_are_equal_but_for_the_rounding_of_their_knots_are_one_edge(gap, start, length, turn):
    gap = max(gap, 8 * np.spacing(abs(start) + length) / length)
    one, other = ridge(gap, 7), ridge(gap, 7, start, length)
    beside = turn(sc.NurbsPatch(other.degree, other.knots, other.points + (0, 1, 0)))
    patch_set = set_of(one, beside)
    assert patch_set.edge_counts() == {'shared': 1, 'free': 6, 'pole': 0}
    positions, _ = ADAPTIVE(patch_set).evaluate(patch_set)
    for y in (0, 1, 2):
        assert np.linalg.norm(positions - (1, y, 7), axis=1).min() < 1e-6


def near_knots(random, degree):
    """Spans of very different lengths; some knots let the patch fall apart."""
    knots, at = [0.0] * (degree + 1), 0.0
    for _ in range(random.integers(0, 5)):
        at += random.choice([1.0, 0.3, 1e-6, 1e-12, 2.0**-45])
        knots += [at] * random.integers(1, degree + 2)
    return knots + [at + 1.0] * (degree + 1)


@pytest.mark.parametrize('turn', (lambda patch: patch, lambda patch: patch.swapped(),
                                  lambda patch: patch.reversed('u'), lambda patch: patch.elevate('u'),
                                  lambda patch: patch.elevate('v').reversed('v').swapped()))
def test_a_patch_has_all_sides_in_common_with_itself_however_near_its_knots_are(turn):
    random = np.random.default_rng(2)
    for _ in range(300):
        degree = tuple(random.integers(1, 4, 2))
        knots = [near_knots(random, d) for d in degree]
        size = tuple(len(k) - d - 1 for k, d in zip(knots, degree))
        patch = sc.NurbsPatch(degree, knots, random.normal(size=(*size, 3)), random.uniform(0.5, 2, size))
        assert set_of(patch, turn(patch)).edge_counts()['free'] == 0


def test_several_knots_one_rounding_apart_keep_all_corners():
    profile = [(0, 0, 0), (1, 0, 0), (1, 0, 7), (3, 0, 7), (3, 0, 2), (4, 0, 0)]
    net = np.array(profile, float)[:, None] + [(0, 0, 0), (0, 1, 0)]
    steps = 1 + np.spacing(1.0) * np.arange(4)
    for inner in (steps, steps / 3):            # a third of them has fewer numbers between
        for ends in ((0, 1.5), (inner[0], 1.5), (0, inner[-1])):
            knots = np.array([ends[0], *inner, ends[1]])
            knots = knots[(knots > ends[0]) & (knots < ends[1])]
            rows = net[:len(knots) + 2]
            patch = sc.NurbsPatch((1, 1), ([ends[0]] * 2 + [*knots] + [ends[1]] * 2, [0, 0, 1, 1]), rows)
            positions, _ = ADAPTIVE(set_of(patch)).evaluate(set_of(patch))
            away = np.linalg.norm(positions[:, None] - rows.reshape(-1, 3), axis=2).min(axis=0)
            assert away.max() < 1e-6


@pytest.mark.parametrize('make', (ADAPTIVE, BY_COUNT))
def test_nothing_is_drawn_between_knots_that_should_have_been_one(make):
    ramp = sc.NurbsPatch((1, 1), ([0, 0, 1, 1 + 2e-10, 2, 2], [0, 0, 1, 1]),
                         [[(x, y, z) for y in (0, 1)] for x, z in ((0, 0), (1, 1), (1, 1), (2, 0))])
    assert make(set_of(ramp)).vertex_count == 6


def test_weights_below_zero_mesh_as_those_above():
    patch = sphere()
    other = sc.NurbsPatch(patch.degree, patch.knots, patch.points, -patch.weights)
    mesh, expected = (sc.Tessellation.adaptive(set_of(p), tolerance=0.01) for p in (other, patch))
    assert np.array_equal(mesh.corner_vertices, expected.corner_vertices)
    assert np.array_equal(mesh.evaluate(set_of(other))[0], expected.evaluate(set_of(patch))[0])


@pytest.mark.parametrize('scale', (1e-150, 1e-80, 1e-20, 1e20, 1e80, 1e150))
@pytest.mark.parametrize('settings', ({'tolerance': 0.01}, {'tolerance': 0.05, 'angle': 0.4}))
def test_a_mesh_is_the_same_at_every_scale(scale, settings):
    scale = 2.0**round(np.log2(scale))
    for patch_set in (set_of(sphere()), teapot()):
        larger = patch_set.with_points(patch_set.points * scale)
        given = dict(settings, tolerance=settings['tolerance'] * scale)
        mesh, expected = sc.Tessellation.adaptive(larger, **given), sc.Tessellation.adaptive(patch_set, **settings)
        assert larger.edge_counts() == patch_set.edge_counts()
        assert np.array_equal(mesh.corner_vertices, expected.corner_vertices)


@pytest.mark.parametrize('settings', ({'tolerance': 0.01}, {'tolerance': 0.05, 'angle': 0.1}))
def test_a_mesh_is_the_same_far_from_the_origin(settings):
    random = np.random.default_rng(5)
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0), indexing='ij')
    # Numbers that a shift by a power of two leaves as they are.
    points = np.stack([x, y, np.round(64 * random.uniform(-1, 1, (5, 5))) / 64], -1)
    weights = 2.0 ** random.integers(-2, 3, (5, 5))
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2]

    def mesh(shift):
        return sc.Tessellation.adaptive(set_of(sc.NurbsPatch((3, 3), (knots, knots), points + shift, weights)),
                                        **settings)
    near, far = mesh(0.0), mesh(2.0**34)
    assert len(near.face_patches) > 50
    assert (near.corner_vertices == far.corner_vertices).all() and (near.corner_uvs == far.corner_uvs).all()


@pytest.mark.parametrize('far', (1e6, 1e11, 1e15))
def test_a_second_patch_far_away_changes_nothing(far):
    near = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    beside = sc.BezierPatch([[(1, 0, 0), (1, 1, 0)], [(2, 0, 0), (2, 1, 0)]])
    away = sc.BezierPatch([[(far, 0, 0), (far, far, 0)], [(2 * far, 0, 0), (2 * far, far, 0)]])
    assert set_of(near, beside, away).edge_counts() == {'shared': 1, 'free': 10, 'pole': 0}
    mesh = sc.Tessellation.adaptive(set_of(near, away), tolerance=0.1)
    assert mesh.vertex_count == 8


def test_a_side_that_is_a_point_on_one_part_of_a_patch_alone_is_a_pole_there():
    net = [[(0, 0, 0), (0, 1, 0)], [(0, 0, 0), (1, 1, 0)], [(3, 0, 0), (3, 1, 0)], [(4, 0, 0), (4, 1, 0)]]
    patch = sc.NurbsPatch((1, 1), ([0, 0, 1, 1, 2, 2], [0, 0, 1, 1]), net)
    assert set_of(patch).edge_counts() == {'shared': 0, 'free': 7, 'pole': 1}
    assert ADAPTIVE(set_of(patch)).vertex_count == 7


def test_a_side_that_lies_at_infinity_altogether_is_free():
    net = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 1), (1, 1, 1)], [(1, 0, 0), (1, 1, 0)]]
    patch = sc.BezierPatch(net, [[1, 1], [1, 1], [0, 0]])
    assert set_of(patch).edge_counts() == {'shared': 0, 'free': 4, 'pole': 0}
    with pytest.raises(sc.InvalidShape, match="runs to infinity"):
        ADAPTIVE(set_of(patch))


def seconds(work):
    start = time.process_time()
    work()
    return time.process_time() - start


def quilt(count):
    side = round(count**0.5)
    corners = [(i, j) for i in range(side) for j in range(side)]
    return set_of(*(sc.BezierPatch([[(i, j, 0), (i, j + 1, 0)], [(i + 1, j, 0), (i + 1, j + 1, 0)]])
                    for i, j in corners))


def long_sheet(count):
    knots = [0.0] * 4 + list(range(1, count - 3)) + [count - 3.0] * 4
    net = np.zeros((count, 2, 3))
    net[..., 0], net[:, 1, 1], net[..., 2] = np.arange(count)[:, None], 1, np.sin(np.arange(count))[:, None]
    return set_of(sc.NurbsPatch((3, 1), (knots, [0, 0, 1, 1]), net))


def row_of_panels(count):
    """One patch that falls apart at every knot, and whose parts lie side by side."""
    knots = np.repeat(np.arange(count + 1.0), 2)
    net = np.zeros((2 * count, 2, 3))
    net[..., 0], net[:, 1, 1] = knots[1:-1, None], 1
    return set_of(sc.NurbsPatch((1, 1), (knots, [0, 0, 1, 1]), net))


def test_parts_of_a_patch_that_lie_side_by_side_have_an_edge_in_common():
    assert row_of_panels(30).edge_counts() == {'shared': 29, 'free': 62, 'pole': 0}


@pytest.mark.parametrize('make', (ADAPTIVE, BY_COUNT, lambda patch_set: patch_set.edge_counts()))
@pytest.mark.parametrize('shape, few, many', ((quilt, 400, 10000), (long_sheet, 2000, 50000),
                                              (row_of_panels, 2000, 50000)))
def test_work_grows_with_patches_and_knots_and_not_with_their_square(make, shape, few, many):
    if make is ADAPTIVE and shape is long_sheet:
        make = lambda patch_set: sc.Tessellation.adaptive(patch_set, tolerance=10.0)
    small, large = shape(few), shape(many)
    once = min(seconds(lambda: make(small)) for _ in range(3))
    assert seconds(lambda: make(large)) < 8 * (many / few) * max(once, 1e-3)


def test_a_large_patch_among_many_small_ones_does_not_make_them_all_neighbors():
    small = quilt(2500)
    patches = [small[i] for i in range(len(small))]
    large = sc.BezierPatch([[(-1e12, 0, -1e12), (-1e12, 0, 1e12)], [(1e12, 0, -1e12), (1e12, 0, 1e12)]])
    expected = small.edge_counts()
    found = set_of(*patches, large).edge_counts()
    assert (found['shared'], found['free'], found['pole']) == (expected['shared'], expected['free'] + 4, 0)


@pytest.mark.parametrize('resolution', (1, 8))
def test_the_check_of_faces_finds_every_one_that_is_turned_over(resolution):
    """Also where normals turn by a quarter on a face, as on a sphere of few faces."""
    patch_set = set_of(sphere())
    mesh = mesh_checks.mesh_of(patch_set, sc.Tessellation(patch_set, resolution))
    turning = mesh_checks.turning(mesh, mesh_checks.surface_normals(mesh, patch_set))
    assert (turning.max() > np.radians(60)) == (resolution == 1)
    mesh_checks.check_faces(mesh, patch_set)
    ends = np.append(mesh.starts[1:], len(mesh.vertex))
    for face in (3, 0, len(mesh.starts) // 2, len(mesh.starts) - 1):
        vertex, corners = mesh.vertex.copy(), slice(mesh.starts[face], ends[face])
        vertex[corners] = vertex[corners][::-1]
        with pytest.raises(AssertionError, match="turned from the surface"):
            mesh_checks.check_faces(mesh._replace(vertex=vertex), patch_set)


def test_the_check_of_faces_finds_one_turned_over_that_the_mean_of_its_corners_excuses():
    """A strip that turns by more than a half on one face: its normals at the corners nearly cancel."""
    points = [(0, 0, 0), (0, 0, 4), (3, 0, 4), (3, 0, -1)]
    patch = sc.BezierPatch([[(x, y, z) for y in (0, 1)] for x, _, z in points])
    patch_set = set_of(patch)
    mesh = mesh_checks.mesh_of(patch_set, sc.Tessellation(patch_set, 1))
    mesh_checks.check_faces(mesh, patch_set)
    assert np.abs(mesh_checks.corner_normals(mesh) * mesh.normal).sum(axis=1).max() < 0.4
    with pytest.raises(AssertionError, match="turned from the surface"):
        mesh_checks.check_faces(mesh._replace(vertex=mesh.vertex[::-1]), patch_set)


@pytest.mark.parametrize('name', ('torus', 'sphere', 'teapot'))
@pytest.mark.parametrize('make', (lambda patch_set: sc.Tessellation(patch_set, 2),
                                  lambda patch_set: sc.Tessellation.adaptive(patch_set, tolerance=0.1)))
@pytest.mark.parametrize('wrong', (-1, np.nan, 0, (1, np.nan, 1)))
def test_the_check_of_faces_finds_every_normal_that_is_turned_over_or_none(name, make, wrong):
    patch_set = SHAPES[name]()
    mesh = mesh_checks.mesh_of(patch_set, make(patch_set))
    mesh_checks.check_faces(mesh, patch_set)
    for corner in range(0, len(mesh.vertex), len(mesh.vertex) // 12):
        normal = mesh.normal.copy()
        normal[corner] *= wrong
        with pytest.raises(AssertionError, match="1 normals are not those of the surface"):
            mesh_checks.check_faces(mesh._replace(normal=normal), patch_set)
