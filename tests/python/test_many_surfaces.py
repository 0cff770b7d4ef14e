"""A thousand random inputs for each way to make a surface, rational, periodic, closed, unclamped and with gaps among them: what is
made is what it should be, the rest is refused with a sentence."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve, random_weights
from splinecore import build

COUNT = 1000
REFUSED = (sc.InvalidShape, sc.ToleranceNotReached, sc.PointAtInfinity)


@pytest.fixture
def made_of(inputs):
    """Makes so many; at least such a part of them is made, and each is checked."""
    def make_all(seed, make, check, least, count=COUNT):
        rng, made, count = np.random.default_rng(seed), 0, inputs(count)
        for index in range(count):
            given = make(rng, index)
            try:
                found = check(*given)
            except REFUSED as error:
                assert len(str(error)) > 10
                continue
            assert found, (seed, index)
            made += 1
        assert made >= least * count, made
    return make_all


def smooth_curve(rng, size=10.0, degree=None, closed=False, rational=None):
    """Without corners or gaps, clamped or periodic."""
    degree = degree or int(rng.integers(2, 6))
    spans = int(rng.integers(1, 4)) if not closed else int(rng.integers(degree + 1, degree + 4))
    count = spans if closed else spans + degree
    inner = np.cumsum(rng.uniform(0.5, 1.5, spans))
    knots = np.r_[0.0, inner] if closed else np.r_[[0.0] * degree, 0.0, inner[:-1], [inner[-1]] * (degree + 1)]
    points = rng.uniform(-size, size, (count, 3))
    is_rational = rng.random() < 0.5 if rational is None else rational
    weights = 2 ** rng.uniform(-1, 1, count) if is_rational else None
    return sc.NurbsCurve(degree, knots, points, weights, periodic=closed)


def arm(rng, rational=None, length=10.0):
    """A curve that goes on along x and turns by less than a right angle."""
    curve = smooth_curve(rng, 0.8, rational=rational)
    points = curve.points * 1.0
    points[:, 0] = np.linspace(0, length, len(points))
    return curve.with_points(points)


def hill(rng, rational=None):
    """A patch over a square, no steeper than it is wide."""
    degree = rng.integers(2, 5, 2)
    spans = rng.integers(1, 3, 2)
    knots = [np.r_[[0.0] * (p + 1), np.arange(1, n), [float(n)] * (p + 1)] for p, n in zip(degree, spans)]
    counts = [int(p + n) for p, n in zip(degree, spans)]
    x, y = np.meshgrid(np.linspace(0, 4, counts[0]), np.linspace(0, 4, counts[1]), indexing='ij')
    points = np.dstack([x, y, rng.uniform(-0.4, 0.4, counts)])
    is_rational = rng.random() < 0.5 if rational is None else rational
    return sc.NurbsPatch(tuple(map(int, degree)), knots, points, 2 ** rng.uniform(-0.4, 0.4, counts) if is_rational else None)


def grid(patch, count=5):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain)).reshape(-1, 3)


def test_lofts_go_through_their_sections(made_of):
    """Of any kinds: with gaps, through infinity and with weights of both signs, too."""
    def make(rng, index):
        if index % 2:
            return [random_curve(rng, positive=index % 4 == 1, degree=int(rng.integers(1, 6))) for _ in range(rng.integers(2, 5))],
        closed = rng.random() < 0.5
        return [smooth_curve(rng, closed=closed) for _ in range(rng.integers(2, 6))],

    def check(curves):
        at = np.arange(len(curves), dtype=float)
        patch = build.loft(curves, parameters=at).value
        size = max(np.abs(curve.points).max() for curve in curves)
        found = []
        for curve, v in zip(curves, at):
            row = patch.isocurve('v', v)
            u = row.domain[0] + np.diff(row.domain) * np.linspace(0.03, 0.97, 5)
            found.append(curve.nearest(row.evaluate(u)).distances.max())
        return max(found) <= 1e-6 * size

    made_of(1, make, check, 0.5)


def test_pipes_keep_their_distance(made_of):
    def check(axis, radius):
        patch, = build.pipe(axis, radius, tolerance=1e-4).value
        return np.abs(axis.nearest(grid(patch, 9)).distances - radius).max() <= 1e-4

    made_of(2, lambda rng, index: (arm(rng), float(rng.uniform(0.02, 0.2))), check, 0.9)


def test_sweeps_begin_and_end_with_their_section(made_of):
    def given(rng, index):
        section = smooth_curve(rng, 0.5, closed=bool(rng.random() < 0.5))
        flat = section.points * (1, 1, 0)
        return arm(rng), section.with_points(flat), str(rng.choice(['minimal', 'upright', 'parallel']))

    def check(rail, section, frame):
        patch = build.sweep(rail, section, frame=frame, tolerance=1e-4).value
        for u in rail.domain:
            row = patch.isocurve('v', u)
            length = row.length(tolerance=1e-6)
            if abs(length - section.length(tolerance=1e-6)) > 1e-3 * length:
                return False
        return True

    made_of(3, given, check, 0.9)


def test_isocurves_of_a_patch_give_it_back_as_a_network(made_of):
    def check(patch):
        along_u = [patch.isocurve('v', v) for v in np.linspace(*patch.domain[1], 4)]
        along_v = [patch.isocurve('u', u) for u in np.linspace(*patch.domain[0], 4)]
        made = build.network(along_u, along_v, tolerance=1e-6).value
        return np.abs(patch.nearest(grid(made, 4)).distances).max() <= 0.05

    made_of(4, lambda rng, index: (hill(rng),), check, 0.7)


def test_coons_patches_have_their_sides(made_of):
    def check(patch):
        sides = [patch.boundary(side) for side in ('v_start', 'u_end', 'v_end', 'u_start')]
        made = build.coons(sides).value
        return all(made.boundary(side).nearest(curve.evaluate(np.linspace(*curve.domain, 7))).distances.max() <= 1e-9
                   for side, curve in zip(('v_start', 'u_end', 'v_end', 'u_start'), sides))

    made_of(5, lambda rng, index: (hill(rng),), check, 0.99)


def test_blends_go_on_from_both(made_of):
    def check(first, second, continuity):
        far = second.transformed(np.array([[1, 0, 0, 7.0], [0, 1, 0, 0], [0, 0, 1, 1.0]]))
        made = build.blend_patches(first, 'u_end', far, 'u_start', continuity)
        seams = (sc.seam_continuity(first, 'u_end', made, 'v_start'), sc.seam_continuity(made, 'v_end', far, 'u_start'))
        return all(seam.gap <= 1e-9 and (continuity == 'G0' or seam.angle <= 1e-6) for seam in seams)

    made_of(6, lambda rng, index: (hill(rng), hill(rng), str(rng.choice(['G0', 'G1', 'G2', 'G3']))), check, 0.9)


def test_matched_sides_go_on(made_of):
    def check(first, second, continuity):
        far = second.transformed(np.array([[1, 0, 0, 4.2], [0, 1, 0, 0], [0, 0, 1, 0.1]]))
        made = build.match_patch(first, 'u_end', far, 'u_start', continuity).value
        seam = sc.seam_continuity(made, 'u_end', far, 'u_start')
        return seam.gap <= 1e-9 and (continuity == 'G0' or seam.angle <= 1e-6)

    made_of(7, lambda rng, index: (hill(rng), hill(rng), str(rng.choice(['G0', 'G1', 'G2']))), check, 0.4)


def test_longer_patches_are_the_same_where_they_were(made_of):
    def check(patch, side, how):
        made = build.extend_patch(patch, side, 0.3, how)
        u, v = (np.linspace(*domain, 5) for domain in patch.domain)
        return np.abs(made.evaluate_grid(u, v) - patch.evaluate_grid(u, v)).max() <= 1e-9 and made.domain != patch.domain

    made_of(8, lambda rng, index: (hill(rng), ('u_start', 'u_end', 'v_start', 'v_end')[index % 4],
                                   ('natural', 'straight')[index % 2]), check, 0.9)


def test_offsets_keep_their_distance(made_of):
    def check(patch, distance):
        made = build.offset_patch(patch, distance, tolerance=1e-3).value
        points, normals = patch.evaluate_grid_with_normals(*(np.linspace(*domain, 15) for domain in patch.domain))
        u, v = (np.linspace(*domain, 15) for domain in made.domain)
        return np.abs(made.evaluate_grid(u, v) - points - distance * normals).max() <= 1e-3

    made_of(9, lambda rng, index: (hill(rng), float(rng.uniform(-0.1, 0.1))), check, 0.8)


def test_thick_ones_are_closed(made_of):
    def check(patch, distance):
        made = build.thicken(patch, 0.0, distance, tolerance=1e-3).value
        return sc.PatchSet.from_patches(list(made)).edge_counts()['free'] == 0

    made_of(10, lambda rng, index: (hill(rng), float(rng.uniform(0.01, 0.1))), check, 0.8)


def test_rounded_edges_touch_both(made_of):
    def check(length, opening, radius):
        floor = build.plane((0, 0, 0), (length, 0, 0), (0, 3, 0))
        wall = build.plane((0, 0, 0), (length, 0, 0), (0, 3 * np.cos(opening), 3 * np.sin(opening)))
        made = build.fillet_patches(floor, 'v_start', wall, 'v_start', radius)
        center = np.array([radius / np.tan(opening / 2), radius])
        points = grid(made.fillet)[:, 1:]
        return np.abs(np.linalg.norm(points - center, axis=1) - radius).max() <= 1e-5

    made_of(11, lambda rng, index: (float(rng.uniform(1, 9)), float(rng.uniform(0.6, 2.6)), float(rng.uniform(0.05, 0.5))),
            check, 0.95)


def test_meshes_become_smooth_patches(made_of):
    def make(rng, index):
        rows, columns = rng.integers(2, 5, 2)
        points = [(i + rng.uniform(-.2, .2), j + rng.uniform(-.2, .2), rng.normal(0, 0.2)) for i in range(rows) for j in range(columns)]
        faces = [(i * columns + j, (i + 1) * columns + j, (i + 1) * columns + j + 1, i * columns + j + 1)
                 for i in range(rows - 1) for j in range(columns - 1)]
        split = [part for face in faces for part in (((face[0], face[1], face[2]), (face[0], face[2], face[3]))
                                                     if rng.random() < 0.2 else (face,))]
        return points, split

    def check(points, faces):
        return build.catmull_clark(points, faces).angle <= 1e-6

    made_of(12, make, check, 0.99)


@pytest.mark.parametrize("count", range(3, 9))
def test_holes_are_filled_to_their_sides(made_of, count):
    def make(rng, index):
        corners = [3 * np.array([np.cos(a), np.sin(a), 0]) + rng.uniform(-0.4, 0.4, 3)
                   for a in 2 * np.pi * np.arange(count) / count]
        sides = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            middle = [a + (b - a) * t + rng.uniform(-0.3, 0.3, 3) for t in (1 / 3, 2 / 3)]
            weights = [1, *2 ** rng.uniform(-0.5, 0.5, 2), 1] if rng.random() < 0.5 else None
            sides.append(sc.BezierCurve([a, *middle, b], weights))
        return sides,

    def check(sides):
        found = build.fill(sides, tolerance=1e-3)
        return found.gap <= 1e-3 and found.inner_angle <= 1e-3

    made_of(13 + count, make, check, 0.9, COUNT // 5)


def test_weights_of_any_sign_are_refused_or_right(made_of):
    """Rows that run through infinity have no size: nothing but sentences may come of them."""
    def check(curve):
        build.loft([curve, curve.transformed(np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3.0]]))])
        build.extrude(curve, (0, 0, 1))
        return True

    def make(rng, index):
        curve = smooth_curve(rng, rational=False)
        return curve.with_weights(random_weights(rng, len(curve.points), False)),

    made_of(20, make, check, 0.05)
