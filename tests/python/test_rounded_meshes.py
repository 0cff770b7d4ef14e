"""Edges of every kind rounded, as meshes: the fillet's outer rows are its neighbors' borders to the last bit, faces share the vertices
along both seams, and nothing but the outer sides is open."""

import numpy as np
import splinecore as sc
from splinecore import build

SLIM = 1e-3


def clamped_knots(rng, degree, count):
    return np.r_[np.zeros(degree + 1), np.sort(rng.uniform(0.1, 0.9, count - degree - 1)), np.ones(degree + 1)]


def straight(rng):
    degree = int(rng.integers(1, 5))
    return sc.NurbsCurve(degree, np.r_[np.zeros(degree + 1), np.ones(degree + 1)],
                         np.c_[np.linspace(0, 10, degree + 1), np.zeros((degree + 1, 2))])


def parabola(rng):
    return build.polynomial_through([(0, 0, 0), (5, rng.uniform(-2, 2), 0), (10, 0, 0)])


def spline(rng):
    degree = int(rng.integers(2, 6))
    count = degree + 1 + int(rng.integers(0, 6))
    points = np.c_[np.linspace(0, 10, count), rng.normal(0, 0.4, count), np.zeros(count)]
    return sc.NurbsCurve(degree, clamped_knots(rng, degree, count), points, 10**rng.uniform(-0.3, 0.3, count) if rng.random() < 0.4 else None)


def s_curve(rng):
    height = rng.uniform(0.5, 2.5)
    return sc.BezierCurve([(0, 0, 0), (4, -height, 0), (6, height, 0), (10, 0, 0)])


def smooth_chain(rng):
    """Several cubics in one curve, with joints that are C1, or of other lengths of the same tangent."""
    joints = int(rng.integers(1, 4))
    points, way = [np.array((0.0, 0, 0))], np.array((1.0, rng.uniform(-0.2, 0.2), 0))
    for _ in range(joints + 1):
        before, after = rng.uniform(0.5, 1.5, 2)
        next_way = np.array((1.0, rng.uniform(-0.2, 0.2), 0))
        end = points[-1] + (4.0, rng.uniform(-0.3, 0.3), 0)
        points += [points[-1] + before * way, end - after * next_way, end]
        way = next_way
    at = np.arange(joints + 2.0)
    return sc.NurbsCurve(3, np.r_[0, np.repeat(at, 3), at[-1]], points)


def wall_and_floor(rng, edge):
    return (build.extrude(edge, (rng.uniform(-0.4, 0.4) if rng.random() < 0.5 else 0, 0, 4)), 'v_start',
            build.extrude(edge, (rng.uniform(-0.8, 0.8) if rng.random() < 0.5 else 0, -8 * rng.choice([-1, 1]), 0)), 'v_start')


def ring_and_lid(rng):
    count = int(rng.integers(7, 12))
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    size = 5 + rng.uniform(-0.4, 0.4, count) * (rng.random() < 0.7)
    rim = sc.NurbsCurve(3, np.arange(count + 1.0), np.c_[size * np.cos(turn), size * np.sin(turn), np.zeros(count)], periodic=True)
    return build.extrude(rim, (0, 0, 6)), 'v_start', build.ruled(rim, rim.with_points(0.2 * rim.points)), 'v_start'


def tube_and_lid(rng):
    size = rng.uniform(3, 6)
    return build.cylinder((0, 0, 0), (0, 0, 1), size, 10), 'v_end', build.disc((0, 0, 10), (0, 0, 1), size), 'v_start'


def pair_of(rng):
    kind = rng.choice([straight, parabola, spline, s_curve, smooth_chain, ring_and_lid, tube_and_lid])
    return kind(rng) if kind in (ring_and_lid, tube_and_lid) else wall_and_floor(rng, kind(rng))


def turned_about(rng, first, first_side, second, second_side):
    size = 10**rng.uniform(-3, 3)
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix = np.c_[size * axes, size * rng.uniform(-5, 5, 3)]
    sides = []
    for patch, side in ((first, first_side), (second, second_side)):
        patch = patch.transformed(matrix)
        if rng.random() < 0.3:
            patch, side = patch.reversed('v'), {'v_start': 'v_end', 'v_end': 'v_start'}[side]
        if rng.random() < 0.3:
            patch, side = patch.swapped(), side.replace('v', 'u')
        sides += [patch, side]
    return sides, size


def row_of(patch, side):
    points, weights = (np.moveaxis(a, 1 if side[0] == 'v' else 0, 0) for a in (np.array(patch.points), np.array(patch.weights)))
    at = -1 if side.endswith('end') else 0
    return np.c_[points[at], weights[at]]


def require_same_row(fillet, own, patch, side):
    a, b = row_of(fillet, own), row_of(patch, side)
    assert np.array_equal(a, b) or np.array_equal(a, b[::-1])


def open_edges(tessellation):
    """Rows of (face, first corner, second corner) of the edges that one face alone has, by corners."""
    corners = np.array(tessellation.corner_vertices)
    starts = np.array(tessellation.face_starts)
    ends = np.append(starts[1:], len(corners))
    following = np.arange(1, len(corners) + 1)
    following[ends - 1] = starts
    pairs = np.sort(np.c_[corners, corners[following]], axis=1)
    whole = pairs[:, 0] != pairs[:, 1]
    faces = np.repeat(np.arange(len(starts)), ends - starts)
    _, back, counts = np.unique(pairs, axis=0, return_inverse=True, return_counts=True)
    alone = whole & (counts[back.ravel()] == 1)
    assert counts.max() <= 2
    return np.c_[faces, np.arange(len(corners)), following][alone]


OPPOSITE = {'u_start': 'u_end', 'u_end': 'u_start', 'v_start': 'v_end', 'v_end': 'v_start'}


def open_along(tessellation, found, index, side):
    """How many of the open edges run along a side of a patch: both ends at the parameter of the side."""
    uvs, patches = np.array(tessellation.corner_uvs), np.array(tessellation.face_patches)
    axis, limit = 0 if side[0] == 'u' else 1, 1.0 if side.endswith('end') else 0.0
    found = found[patches[found[:, 0]] == index]
    return np.count_nonzero((np.abs(uvs[found[:, 1:], axis] - limit) <= 1e-6).all(axis=1))


def require_no_open_seam(tessellation, first_side, second_side, is_lid):
    found = open_edges(tessellation)
    for index, side in ((0, first_side), (1, 'v_start'), (1, 'v_end'), (2, second_side)):
        assert open_along(tessellation, found, index, side) == 0, (index, side)
    assert open_along(tessellation, found, 0, OPPOSITE[first_side]) > 0
    assert is_lid or open_along(tessellation, found, 2, OPPOSITE[second_side]) > 0


def test_meshes_of_rounded_edges_have_no_open_seams(inputs):
    made_count = refused = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 331])
        (first, first_side, second, second_side), size = turned_about(rng, *pair_of(rng))
        try:
            made = build.fillet_patches(first, first_side, second, second_side, rng.uniform(0.1, 0.5) * size, tolerance=SLIM * size)
        except sc.InvalidShape as error:
            assert "ball" in str(error), (seed, error)
            refused += 1
            continue
        made_count += 1
        require_same_row(made.fillet, 'v_start', made.first, first_side)
        require_same_row(made.fillet, 'v_end', made.second, second_side)
        together = sc.PatchSet.from_patches([made.first, made.fillet, made.second])
        is_lid = np.ptp(row_of(second, OPPOSITE[second_side])[:, :3], axis=0).max() <= 1e-9 * size
        for faces in (sc.Tessellation(together, (3, 3)), sc.Tessellation.adaptive(together, tolerance=0.01 * size)):
            require_no_open_seam(faces, first_side, second_side, is_lid)
    assert made_count > 0.8 * (made_count + refused)
