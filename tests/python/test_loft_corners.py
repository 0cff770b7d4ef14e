"""Lofts of sections with corners: each corner is an edge of the surface, wherever the sections have their parameters."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def polyline(points, weights=None, knots=None):
    points = np.array(points, dtype=np.float64)
    if knots is None:
        knots = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points[:, :3], axis=0), axis=1))]
    return sc.NurbsCurve(1, np.r_[knots[0], knots, knots[-1]], points)


def hull(x, bulge=0.0):
    """A frame: keel, chine, sheer."""
    return polyline([(x, 0, -1 + 0.1 * x), (x, 1 + 0.2 * x + bulge, -0.5), (x, 1.5, 1 + 0.3 * x)])


def inner(knots, degree):
    """{knot: how often}, inside."""
    at, times = np.unique(np.asarray(knots)[degree + 1:-degree - 1], return_counts=True)
    return dict(zip(at.tolist(), times.tolist()))


def test_a_chine_is_one_edge_of_the_hull():
    frames = [hull(x, 0.1 * x * x) for x in (0.0, 1.0, 2.5, 4.0)]
    free = build.loft(frames).value
    assert len(inner(free.knots[0], free.degree[0])) == 4
    made, error = build.loft(frames, corners="matched")
    (chine, times), = inner(made.knots[0], made.degree[0]).items()
    assert error == 0.0 and made.degree[0] == 1 and times == 1
    for v, frame in zip(np.linspace(0, 1, 4)[[0, -1]], (frames[0], frames[-1])):
        assert np.abs(made.evaluate(chine, v) - frame.points[1, :3]).max() <= 1e-12
    assert build.corner_counts(frames) == [1, 1, 1, 1]


def test_degrees_may_differ_and_the_knot_has_all_copies():
    a = sc.NurbsCurve(2, [0, 0, 0, 0.7, 0.7, 1, 1, 1], [(0, 0, 0), (0, 1, 1), (0, 2, 0), (0, 3, 1), (0, 4, 2)])
    b = polyline([(1, 0, 0), (1, 2, 0.5), (1, 4, 3)], knots=[2.0, 2.1, 9.0])
    made = build.loft([a, b], corners="matched").value
    assert made.degree[0] == 2 and list(inner(made.knots[0], 2).values()) == [2]


def test_other_numbers_of_corners_are_said_and_change_nothing():
    frames = [hull(0), hull(1), polyline([(2, 0, 0), (2, 1, 0), (2, 2, 1), (2, 2, 2)])]
    assert build.corner_counts(frames) == [1, 1, 2]
    assert build.loft(frames, corners="matched").value == build.loft(frames).value


def test_kinks_that_no_one_sees_are_left_out_where_numbers_differ():
    """A chine that fades out is one while all frames have it; rounding of an import is none where only some have it."""
    fading = [polyline([(x, -1, 0), (x, 0, h), (x, 1.5, 0)]) for x, h in ((0, 0.5), (1, 0.01), (2, 0.002))]
    assert build.corner_counts(fading) == [1, 1, 1]
    noisy = polyline([(3, -1, 0), (3, 0, 0.5), (3, 0.7, 0.2668), (3, 1.5, 0)])
    assert build.corner_counts([fading[0], noisy]) == [1, 1]


def test_squares_begin_at_corners_that_lie_beside_each_other():
    """Of each another corner is its beginning, at other paces, every second one runs the other way: no twist."""
    rng = np.random.default_rng(5)
    square = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)], dtype=float)
    sections = []
    for i in range(6):
        points = np.roll(square, i, axis=0)[::1 if i % 2 else -1]
        points = np.c_[np.r_[points, points[:1]], np.full(5, float(i))]
        sections.append(polyline(points, knots=np.r_[0, np.cumsum(rng.uniform(0.05, 1, 4))]))
    made = build.loft(sections, corners="matched").value
    assert made.periodic == (True, False) and build.corner_counts(sections) == [4] * 6
    points = made.evaluate_grid(np.linspace(*made.domain[0], 65), np.linspace(*made.domain[1], 9))
    assert np.abs(np.abs(points[..., :2]).max(axis=-1) - 1).max() <= 1e-12
    assert len(np.unique(made.knots[0])) == 5


def test_a_square_that_begins_in_the_middle_of_a_side_is_no_exception():
    begun = polyline([(0, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (1, 1, 0), (0, 1, 0)])
    other = polyline([(1, -1, 2), (1, 1, 2), (-1, 1, 2), (-1, -1, 2), (1, -1, 2)])
    made = build.loft([begun, other], corners="matched").value
    points = made.evaluate_grid(np.linspace(*made.domain[0], 65), np.linspace(*made.domain[1], 5))
    assert np.abs(np.abs(points[..., :2]).max(axis=-1) - 1).max() <= 1e-12


def test_without_alignment_seams_stay():
    square = polyline([(0, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (1, 1, 0), (0, 1, 0)], knots=[0, 1, 2, 3, 4, 9])
    other = square.transformed(np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2.0]]))
    made = build.loft([square, other], corners="matched", align=False).value
    assert np.allclose(made.evaluate(made.domain[0][0], made.domain[1][0]), (0, 1, 0))


def random_section(rng, corners, closed, x):
    """Cubic pieces between corners of any angles, at any pace, from 1e-3 to 1e3 of their length."""
    degree = int(rng.integers(1, 5))
    angles = np.sort(rng.uniform(0.0, 2 * np.pi, corners)) if closed else np.linspace(0, np.pi, corners + 2)
    places = np.c_[np.cos(angles), np.sin(angles)] * rng.uniform(0.6, 1.4, (len(angles), 1))
    if closed:
        places = np.r_[places, places[:1]]
    points = [places[0]]
    for a, b in zip(places, places[1:]):
        steps = a + (b - a) * (np.arange(1, degree + 1) / degree)[:, None]
        steps[:-1] += rng.normal(0, 0.1, steps[:-1].shape)
        points += list(steps)
    breaks = np.r_[0, np.cumsum(10.0 ** rng.uniform(-3, 3, len(places) - 1))]
    knots = np.r_[breaks[0], np.repeat(breaks, degree), breaks[-1]]
    weights = 2.0 ** rng.uniform(-1, 1, len(points)) if rng.random() < 0.3 else np.ones(len(points))
    if closed:
        weights[-1] = weights[0]
    curve = sc.NurbsCurve(degree, knots, np.c_[np.full(len(points), x), points], weights)
    return curve.reversed() if rng.random() < 0.3 else curve


def test_random_sections_keep_their_shapes_and_share_their_corners(inputs):
    rng = np.random.default_rng(411)
    count, refused = inputs(1000), 0
    for number in range(count):
        corners, closed = int(rng.integers(1, 6)), bool(rng.random() < 0.4)
        corners = max(corners, 3) if closed else corners
        sections = [random_section(rng, corners, closed, 3.0 * x) for x in range(int(rng.integers(2, 5)))]
        counts = build.corner_counts(sections)
        try:
            made, error = build.loft(sections, corners="matched", style="straight")
        except sc.InvalidShape as problem:
            assert "weights" in str(problem)
            refused += 1
            continue
        if len(set(counts)) > 1:
            assert made == build.loft(sections, style="straight").value
            continue
        knots = made.knots[0][:-1] if made.periodic[0] else made.knots[0]
        kinks = [at for at, times in zip(*np.unique(knots, return_counts=True)) if times >= made.degree[0]]
        assert len(kinks) == counts[0] + (0 if closed else 2), number
        for v, section in zip(np.unique(made.knots[1]), sections):
            on = made.isocurve("v", v).evaluate(np.linspace(*made.domain[0], 40)[:-1])
            assert section.nearest(on).distances.max() <= 1e-7, number
            assert error <= 1e-12
    assert refused < count / 10


def test_scaling_moving_and_reversing_all_gives_the_same():
    rng = np.random.default_rng(3)
    sections = [random_section(rng, 3, False, float(x)) for x in range(3)]
    made = build.loft(sections, corners="matched").value
    matrix = np.array([[0, -1e3, 0, 1e5], [1e3, 0, 0, -7e4], [0, 0, 1e3, 3.0]])
    moved = build.loft([section.transformed(matrix) for section in sections], corners="matched").value
    wanted = made.transformed(matrix)
    assert np.abs(moved.points - wanted.points).max() <= 1e-9 * 1e3 and np.allclose(moved.knots[0], wanted.knots[0], rtol=1e-12)


def test_a_neighbor_has_its_corners_matched_too():
    wall = build.extrude(hull(0), (-1, 0, 0))
    sections = [hull(1, 0.2), hull(2, 0.3)]
    made = build.loft(sections, corners="matched", start_neighbor=(wall, "v_start", "G1")).value
    assert list(inner(made.knots[0], made.degree[0]).values()) == [made.degree[0]]
    points, normals = made.evaluate_grid_with_normals(np.linspace(*made.domain[0], 41), [made.domain[1][0]])
    assert wall.boundary("v_start").nearest(points.reshape(-1, 3)).distances.max() <= 1e-12
    assert np.abs(normals[..., 0]).max() <= 1e-9


def test_a_point_is_round_as_far_as_asked():
    ring = sc.conics.circle((0, 0, 1), 1.0)
    near, far = (build.loft([(0, 0, 0), ring], start_flat=((0, 0, 1), speed)).value for speed in (0.5, 2.0))
    assert build.loft([(0, 0, 0), ring], start_flat=((0, 0, 1), 1.0)).value == build.loft([(0, 0, 0), ring], start_flat=(0, 0, 1)).value
    heights = [np.abs(one.evaluate_grid(np.linspace(*one.domain[0], 9), [0.2])[..., 2]).max() for one in (near, far)]
    widths = [np.hypot(*one.evaluate_grid([0.0], [0.2])[0, 0, :2]) for one in (near, far)]
    assert widths[0] < widths[1] and heights[0] > 0
    with pytest.raises(sc.InvalidShape, match="flat_speed = 0"):
        build.loft([(0, 0, 0), ring], start_flat=((0, 0, 1), 0.0))
