"""Surfaces from curves and from surfaces where little is needed to miss, fold or refuse them: what is said is what is there."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

RING = sc.conics.circle((0, 0, 0), 0.1)
UP = sc.BezierCurve([(0, 0, 0), (0, 0, 1)])


def line(*points):
    return sc.BezierCurve(points)


def scaled(curve, size):
    return curve.transformed(np.c_[size * np.eye(3), np.zeros(3)])


def dense(patch, count=201):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def polyline(points):
    return sc.NurbsCurve(1, np.r_[0, np.arange(len(points)), len(points) - 1.0], np.array(points, float))


@pytest.mark.parametrize("radii", [[(0, 0.1), (0.2, 0.1), (0.25, 0.3), (0.3, 0.1), (1, 0.1)],
                                   [(0, 0.1), (0.495, 0.1), (0.5, 0.3), (0.505, 0.1), (1, 0.1)]])
def test_a_pipe_has_every_bump(radii):
    made, _ = build.pipe(UP, radii)
    assert np.hypot(*dense(made[0], 2001)[..., :2].reshape(-1, 2).T).max() == pytest.approx(0.3, abs=1e-6)


def test_a_sweep_has_each_of_many_sections():
    sections = [RING] * 81
    sections[40] = scaled(RING, 3)
    made, error = build.sweep(scaled(UP.to_nurbs(), 4), sections)
    assert np.hypot(*made.evaluate(np.linspace(*made.domain[0], 9), np.full(9, 2.0 / 4)).T[:2]) == pytest.approx(0.3, abs=1e-5)
    assert error <= 4e-6


@pytest.mark.parametrize("turns", [0.5, 7, 120])
def test_a_twist_turns_as_often_as_it_is_to(turns):
    made, _ = build.sweep(UP, line((-0.5, 0, 0), (0.5, 0, 0)), twist=2 * math.pi * turns)
    v = np.linspace(0, 1, int(40 * turns) + 1)
    ends = made.evaluate(np.full(v.size, made.domain[0][1]), v)
    angles = np.unwrap(np.arctan2(ends[:, 1], ends[:, 0]))
    assert abs(angles[-1] - angles[0]) == pytest.approx(2 * math.pi * turns, abs=1e-4)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_sections_go_round_a_closed_rail(count):
    """By even places of which the start is one, and no last one at the end, which is the start."""
    big = sc.conics.circle((0, 0, 0), 3)
    made, error = build.sweep(big, [scaled(RING, 1 + i % 2) for i in range(count)], tolerance=1e-5)
    points = dense(made)
    assert np.abs(points[:, 0] - points[:, -1]).max() <= 1e-9 and error <= 1e-5
    assert made.periodic[1]
    with pytest.raises(sc.InvalidShape, match="one section too many"):
        build.sweep(big, [RING] * 3, at=[0.0, 1.0, big.domain[1]])


def test_a_closed_rail_that_begins_beside_its_corners_takes_numbers_for_both_its_ends():
    rail = polyline([(1, 0, 0), (2, 0, 0), (1, 2, 0), (0, 0, 0), (1, 0, 0)])
    made, _ = build.pipe(rail, [(0, 0.1), (2, 0.2), (4, 0.1)])
    assert np.isfinite(made[0].points).all()
    build.sweep(rail, [RING] * 2, at=[0, 4])
    with pytest.raises(sc.InvalidShape, match="the same values as its start"):
        build.sweep(rail, RING, scales=[(0, 1), (4, 2)])


def test_the_error_of_a_network_is_from_the_curves_as_they_are_given():
    points = np.array([(0, 0, 0), (1, 0, 1), (2, 0, -1), (3, 0, 0)])
    along = [sc.BezierCurve(points), sc.BezierCurve(points + [0, 1, 0], [1, 2, 4, 8]), sc.BezierCurve(points + [0, 2, 0])]
    across = [line(*(tuple(along[0].evaluate(t) + [0, y, 0]) for y in (0, 2))) for t in (0, 0.4, 1)]
    for tolerance in (1e-5, 1e-2):
        made, error = build.network(along, across, tolerance=tolerance)
        off = max(made.nearest(curve.evaluate(np.linspace(*curve.domain, 301))).distances.max() for curve in along + across)
        assert off <= 1.01 * error + 1e-12 <= 1.02 * tolerance + 1e-12


def test_near_curves_that_no_surface_has_are_refused():
    along = [line((0, y, 0), (1, y, 0)) for y in (0, 1, 2)]
    across = [line((x, 0, z), (x, 2, z)) for x, z in ((0, 0), (0.5, 0), (0.5001, 2e-5), (1, 0))]
    with pytest.raises(sc.ToleranceNotReached, match="0.01924"):
        build.network(along, across, tolerance=1e-4)


@pytest.mark.parametrize("weight", [2, 5, 10])
def test_weights_of_a_network_stay_positive(weight):
    along = [sc.BezierCurve([(0, y, 0), (1, y, 1), (2, y, 0)], [1, weight if i % 2 else 1, 1]) for i, y in enumerate((0, 1, 2, 3))]
    made, error = build.network(along, [line((0, 0, 0), (0, 3, 0)), line((2, 0, 0), (2, 3, 0))])
    assert np.min(made.weights) > 0 and dense(made)[..., 1].max() <= 3 + 1e-6 and error <= 1e-5


def test_weights_of_a_sweep_stay_positive():
    bow = sc.BezierCurve([(0, 0, 0), (0.5, 0.5, 0), (1, 0, 0)])
    sections = [sc.BezierCurve(bow.points, [1, weight, 1]) for weight in (1, 100, 1, 0.01, 1)]
    with pytest.raises(sc.InvalidShape, match="would not stay positive"):
        build.sweep(UP, sections)


def test_a_side_whose_weights_fall_is_made_longer():
    patch = sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 0, 0, 1, 1, 1]), [[(0, i, 0), (1, i, 1), (2, i, 0)] for i in (0, 1)],
                          [[1, 0.6, 0.2]] * 2)
    longer = build.extend_patch(patch, "v_end", 1e-3)
    assert np.linalg.norm(dense(longer)[:, -1] - dense(patch)[:, -1], axis=1) == pytest.approx(1e-3, rel=0.01)


def test_an_offset_that_folds_between_places_is_refused():
    profile = sc.BezierCurve([(0, 0, 0), (3, 0, 2), (-0.8, 0, 1), (3, 0, 0)])
    with pytest.raises(sc.InvalidShape, match="fold"):
        build.offset_patch(build.extrude(profile, (0, 1, 0)), 0.1)


def test_the_error_of_an_offset_of_high_degree_is_true():
    rng = np.random.default_rng(2)
    net = np.dstack([*np.meshgrid(np.arange(10.0), np.arange(10.0), indexing="ij"), rng.normal(0, 0.1, (10, 10))])
    patch = sc.BezierPatch(net)
    made, error = build.offset_patch(patch, 0.05, tolerance=1e-4)
    u = np.linspace(0, 1, 201)
    points, normals = patch.evaluate_grid_with_normals(u, u)
    off = np.linalg.norm(made.evaluate_grid(u, u) - points - 0.05 * normals, axis=-1).max()
    assert off <= 1e-4 and off <= 1.3 * error


@pytest.mark.parametrize("patch, start, end, count", [
    (build.extrude(sc.BezierCurve([(0, 0, 0), (2, 1.5, 0), (2, -1.5, 0), (0, 0, 0)]), (0, 0, 1)), 0, 0.1, 6),
    (build.cone((0, 0, 0), (0, 0, 1), 1, 2), 0, 0.1, 4),
    (build.sphere((0, 0, 0), 1), -0.1, 0.1, 2),
])
def test_what_is_thick_is_closed_where_one_side_alone_is(patch, start, end, count):
    assert len(build.thicken(patch, start, end).value) == count


@pytest.mark.parametrize("radii", [[(0, 0.1), (1, 0.4)], [(0, 0.4), (1, 0.1)]])
def test_radii_grow_either_way(radii):
    ground, wall = build.plane((0, 0, 0), (3, 0, 0), (1, 2, 0)), build.plane((0, 0, 0), (3, 0, 0), (0, 0, 2))
    build.fillet_patches(ground, "v_start", wall, "v_start", radii)
    with pytest.raises(sc.InvalidShape, match="a radius of -1:"):
        build.fillet_patches(ground, "v_start", wall, "v_start", -1.0)


def test_points_of_no_face_do_not_move_a_subdivided_mesh():
    cube = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    for a, b in zip(build.catmull_clark(cube, faces).patches, build.catmull_clark(cube + [(1e12, 0, 0)], faces).patches):
        assert np.array_equal(a.points, b.points)


def flat(xs):
    """A plane over these x, four rows wide."""
    net = np.dstack([*np.meshgrid(np.array(xs, float), np.arange(4.0), indexing="ij"), np.zeros((len(xs), 4))])
    return sc.NurbsPatch((3, 3), ([0] * 4 + [1 / 3, 2 / 3] + [1] * 4, [0] * 4 + [1] * 4), net)


@pytest.mark.parametrize("last", [1.0, 0.1, 0.01, 1e-3, 1e-4])
def test_curvatures_go_on_from_rows_of_any_spacing(last):
    """A plane that nearly stands still at its side: another one goes on from it, and what blends them, without a fold."""
    onto = flat([0, 1, 2, 3, 4 - last, 4])
    moved = build.match_patch(flat([4, 5, 6, 7, 8, 9]), "u_start", onto, "u_end", "G2").value
    blended = build.blend_patches(onto, "u_end", flat([6, 7, 8, 9, 10, 11]), "u_start", "G2")
    for patch, end in ((moved, 9), (blended, 6)):
        x = dense(patch)[..., 0]
        assert x.min() >= 4 - 1e-9 and x.max() <= end + 1e-9
    assert sc.seam_continuity(onto, "u_end", moved, "u_start").g >= 2
    assert (np.diff(dense(blended)[..., 0], axis=1) >= -1e-9).all()


@pytest.mark.parametrize("sizes, places", [((1, 1, 3, 1, 1), (0, 0.2, 0.25, 0.3, 1)), ((1, 1.1, 1), (0, 1e-6, 1)), ((1, 2, 1, 2), (0, 0.4, 0.45, 1))])
def test_sections_at_uneven_places_swing_out_nowhere(sizes, places):
    made, error = build.sweep(UP, [scaled(RING, size) for size in sizes], at=list(places))
    radii = np.hypot(*np.moveaxis(dense(made, 1001)[..., :2], -1, 0))
    assert radii.max() <= 0.1 * max(sizes) + 2 * error + 1e-9 and radii.min() >= 0.1 * min(sizes) - 2 * error - 1e-9
    for size, place in zip(sizes, places):
        ring = made.evaluate(np.linspace(*made.domain[0], 9), np.full(9, place))
        assert np.hypot(*ring.T[:2]) == pytest.approx(0.1 * size, abs=2 * error + 1e-9)


def test_uneven_sections_go_round_a_closed_rail():
    big = sc.conics.circle((0, 0, 0), 3)
    made, error = build.sweep(big, [scaled(RING, size) for size in (1, 3, 1)], at=[0.1, 0.2, 2.0], tolerance=1e-4)
    points = dense(made)
    assert np.abs(points[:, 0] - points[:, -1]).max() <= 1e-9 and error <= 1e-4
    assert np.abs(np.linalg.norm(points, axis=-1) - 3).max() <= 0.3 + 1e-4


def noisy(curve, size, seed):
    points = np.array(curve.points)
    noise = size * np.random.default_rng(seed).normal(size=points.shape)
    noise[-1] = noise[0]
    return curve.with_points(points + noise)


@pytest.mark.parametrize("size", [0.0, 1e-9, 1e-7, 1e-5])
def test_kinks_that_nobody_sees_align_no_sections(size):
    """A circle, and one turned by 45 degrees: the straight way between them, not from knot to knot."""
    circle = sc.conics.circle((0, 0, 0), 1)
    turn = math.sqrt(0.5)
    other = circle.transformed(np.array([[turn, -turn, 0, 0], [turn, turn, 0, 0], [0, 0, 1, 1]]))
    made = build.loft([noisy(circle, size, 1), noisy(other, size, 2)]).value
    assert np.hypot(*np.moveaxis(dense(made)[..., :2], -1, 0)).min() >= 0.999


@pytest.mark.parametrize("noise", [0.0, 1e-13, 1e-10, 1e-7])
def test_noise_on_a_straight_rail_turns_no_section(noise):
    points = np.array([(0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 0, 3.0)])
    rail = sc.BezierCurve(points + noise * np.random.default_rng(0).normal(size=(4, 3)))
    made, _ = build.sweep(rail, line((0, 0, 0), (1, 0, 0)))
    straight, _ = build.sweep(sc.BezierCurve(points), line((0, 0, 0), (1, 0, 0)))
    assert np.abs(dense(made, 9) - dense(straight, 9)).max() <= 1e-5


@pytest.mark.parametrize("start", [0.0, 0.4, math.pi / 2, 2.0, math.pi])
def test_closed_sides_are_matched_wherever_their_seams_are(start):
    """A cylinder onto a narrower one: no waist."""
    onto = build.cylinder((0, 0, 0), (0, 0, 1), 1, 2)
    made = build.match_patch(build.cylinder((0, 0, 3), (0, 0, 1), 1.5, 2, start), "v_start", onto, "v_end", "G1").value
    radii = np.hypot(*np.moveaxis(dense(made)[..., :2], -1, 0))
    ends = made.evaluate(np.linspace(*made.domain[0], 33), np.full(33, made.domain[1][0]))
    assert radii.min() >= 0.97
    assert np.abs(np.hypot(ends[:, 0], ends[:, 1]) - 1).max() <= 1e-12 and np.abs(ends[:, 2] - 2).max() <= 1e-12


@pytest.mark.parametrize("noise", [0.0, 1e-10, 1e-8, 1e-7])
def test_kinks_that_nobody_sees_stop_no_sweep(noise):
    """A line that goes over into an arc: where the corner's angle times the section is below the tolerance, there is none."""
    h = math.sqrt(0.5)
    knots = [0, 0, 0, 1, 1, 2, 2, 2]
    points = np.array([(-2, 0, 0), (-1, 0, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0)], float)
    points[3, 1] += noise
    rail = sc.NurbsCurve(2, knots, points, [1, 1, 1, h, 1])
    made, error = build.sweep(rail, RING, tolerance=1e-5)
    assert error <= 1e-5
    two, _ = build.sweep_two_rails(rail, rail.with_points(points + [0, 0, 1]), line((0, 0, 0), (0.5, 0.2, 0), (1, 0, 0)), tolerance=1e-5)
    assert np.isfinite(two.points).all()


def test_an_edge_that_turns_over_is_no_edge_of_one_fillet():
    ground = build.plane((0, 0, 0), (3, 0, 0), (0, -2, 0))
    wall = build.ruled(line((0, 0, 0), (3, 0, 0)), line((0, 2, 1.0), (3, 2, -1.0)))
    with pytest.raises(sc.InvalidShape, match="from an inner one to an outer one"):
        build.fillet_patches(ground, "v_start", wall, "v_start", 0.1)
