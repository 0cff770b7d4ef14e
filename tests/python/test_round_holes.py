"""Holes whose sides go on into each other all round: domes of patches that run together in a point."""

import math

import numpy as np
import pytest

import splinecore as sc
from shapes import circle
from splinecore import build

UP = (0, 0, 1)
BORDERS = ("u_start", "u_end", "v_start", "v_end")


def sectors(profile, count, word, turn=0.0):
    """So many equal parts of a surface of revolution about z, and of each the side that lies highest."""
    sweep = 2 * math.pi / count
    patches = [build.revolve(profile, (0, 0, 0), UP, turn + i * sweep, sweep) for i in range(count)]
    return [(patch, max(BORDERS, key=lambda name: dense_curve(patch.boundary(name))[:, 2].mean()), word) for patch in patches]


def sphere_arc(low, high):
    """Of the unit sphere, from one latitude to another."""
    return sc.conics.arc((0, 0, 0), (1, 0, 0), UP, low, high - low)


def dense(patch, count=33):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain)).reshape(-1, 3)


def off_sphere(filling):
    return max(np.abs(np.linalg.norm(dense(patch), axis=1) - 1).max() for patch in filling.patches)


def dense_curve(curve):
    return curve.evaluate(np.linspace(*curve.domain, 33))


def sphere_hole(count, word, latitude, turn=0.0):
    return sectors(sphere_arc(latitude - 0.5, latitude), count, word, turn)


@pytest.mark.parametrize("count", range(3, 9))
@pytest.mark.parametrize("word", ["G1", "G2"])
def test_a_sphere_is_closed(count, word):
    filling = build.fill(sphere_hole(count, word, 0.8, 0.3))
    assert len(filling.patches) == count
    assert filling.gap <= 1e-14 and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4
    assert off_sphere(filling) <= 2e-3
    assert word == "G1" or filling.curvature_difference <= 1e-3


@pytest.mark.parametrize("latitude, most", [(-0.6, 0.02), (0.0, 4e-3), (0.5, 3e-4), (1.2, 1e-4)])
def test_a_dome_of_any_width(latitude, most):
    """The more than half of a sphere, a half, and less."""
    filling = build.fill(sphere_hole(4, "G1", latitude))
    assert filling.angle <= 1e-4 and off_sphere(filling) <= most


def test_sides_are_what_they_are():
    around = sphere_hole(4, "G1", 0.5)
    filling = build.fill(around)
    for (patch, name, _), dome in zip(around, filling.patches):
        wanted, found = patch.boundary(name), dome.boundary("v_start")
        assert np.ptp(found.weights) > 0.1
        s = np.linspace(0, 1, 65)
        points = wanted.evaluate(wanted.domain[0] + s * (wanted.domain[1] - wanted.domain[0]))
        there = found.evaluate(found.domain[0] + s * (found.domain[1] - found.domain[0]))
        assert min(np.abs(points - there).max(), np.abs(points[::-1] - there).max()) <= 1e-14


def cylinder_hole(count, word, turn=0.0, matrix=np.eye(3, 4)):
    wall = sc.BezierCurve([(1, 0, -1), (1, 0, 0)])
    return [(patch.transformed(matrix), name, word) for patch, name, word in sectors(wall, count, word, turn)]


@pytest.mark.parametrize("word", ["G1", "G2"])
def test_a_wall_is_closed_with_a_dome(word):
    """It stands upright on the plane that the hole lies in: nothing over that plane is a function."""
    filling = build.fill(cylinder_hole(4, word))
    points = np.concatenate([dense(patch) for patch in filling.patches])
    assert filling.angle <= 1e-4 and filling.inner_angle <= 1e-9
    assert np.abs(np.hypot(points[:, 0], points[:, 1])).max() <= 1 + 1e-9
    assert points[:, 2].max() == pytest.approx(1.0, abs=0.05) and points[:, 2].min() >= -1e-12


def split_at(degrees, word="G1"):
    """A cylinder's wall in parts that end at these angles."""
    wall = sc.BezierCurve([(1, 0, -1), (1, 0, 0)])
    places = np.radians([*degrees, degrees[0] + 360])
    patches = [build.revolve(wall, (0, 0, 0), UP, start, end - start) for start, end in zip(places[:-1], places[1:])]
    return [(patch, max(BORDERS, key=lambda name: dense_curve(patch.boundary(name))[:, 2].mean()), word) for patch in patches]


@pytest.mark.parametrize("degrees", [(0, 10, 20), (0, 10, 20, 30), (0, 5, 10, 15, 20, 25, 30, 35), (0, 90, 170, 300)])
def test_where_the_rim_is_split_does_not_move_the_point(degrees):
    filling = build.fill(split_at(degrees))
    assert np.abs(filling.patches[0].points[0, -1] - (0, 0, 1)).max() <= 1e-3 and filling.angle <= 1e-4


@pytest.mark.parametrize("word", ["G1", "G2"])
@pytest.mark.parametrize("stretch", [1.0, 2.0, 5.0, 20.0])
@pytest.mark.parametrize("profile, height", [(sphere_arc(-0.3, 0.0), 1.0), (sphere_arc(0.3, 0.7), 1.0),
                                             (sc.BezierCurve([(1.5, 0, -0.5), (1, 0, 0)]), math.tan(math.pi / 8))])
def test_a_long_hole_is_closed_as_its_near_sides_let_expect(profile, height, stretch, word):
    """Of an ellipsoid, of a sphere's cap drawn out, of a cone: about as high as the round one, and without a fold."""
    matrix = np.c_[np.diag([stretch, 1, 1]), np.zeros(3)]
    filling = build.fill([(patch.transformed(matrix), name, word) for patch, name, _ in sectors(profile, 4, word)])
    assert height * (1 - 1e-6) <= filling.patches[0].points[0, -1, 2] <= 1.3 * height
    for patch in filling.patches:
        (u, v), inner = patch.domain, np.linspace(0.02, 1, 33)
        normals = patch.evaluate_grid_with_normals(np.linspace(*u, 33), v[0] + inner * (v[1] - v[0]))[1]
        assert (normals[..., 2] * np.sign(normals[0, -1, 2]) > 0).all()


@pytest.mark.parametrize("words", [("G2", "G1", "G2", "G1"), ("G2", "G0", "G2", "G1"), ("G1", "G2", "G0", "G1")])
def test_continuities_beside_each_other_leave_no_crease(words):
    filling = build.fill([(patch, name, word) for (patch, name, _), word in zip(split_at((0, 90, 180, 270)), words)])
    assert filling.angle <= 1e-10 and filling.inner_angle <= 1e-10 and filling.curvature_difference <= 1e-10


def test_neighbors_that_agree_only_nearly_do_no_harm(inputs):
    rng = np.random.default_rng(3)
    for noise in np.geomspace(1e-8, 1e-3, inputs(60)):
        around = sphere_hole(int(rng.integers(3, 9)), str(rng.choice(["G1", "G2"])), 0.5, rng.uniform(0, 6))
        moved = []
        for patch, name, word in around:
            points = np.array(patch.points)
            edge = {"u_start": points[0], "u_end": points[-1], "v_start": points[:, 0], "v_end": points[:, -1]}[name].copy()
            points += rng.normal(0, noise, points.shape)
            {"u_start": points[0], "u_end": points[-1], "v_start": points[:, 0], "v_end": points[:, -1]}[name][:] = edge
            moved.append((patch.with_points(points), name, word))
        filling = build.fill(moved, tolerance=1e-6)
        assert off_sphere(filling) <= 2e-3 + 20 * noise and filling.angle <= 1e-4 + 20 * noise


def nearly_round(opening, word="G1"):
    """Four flat sides about a hole, whose corners are more than 180 degrees by so many radians."""
    k = 0.5522847
    sides = []
    for i in range(4):
        turn = np.array([[math.cos(i * math.pi / 2), -math.sin(i * math.pi / 2), 0], [math.sin(i * math.pi / 2), math.cos(i * math.pi / 2), 0], [0, 0, 1]])
        side = np.array([(1, 0, 0), (1 - k * opening / 2, k, 0), (k, 1 - k * opening / 2, 0), (0, 1, 0)]) @ turn.T
        sides.append((sc.BezierPatch(np.stack([side, 1.5 * side], 1)), "v_start", word))
    return sides


@pytest.mark.parametrize("opening", [-1e-2, -1.1e-3, -1e-4, 1e-4, 1.1e-3, 1e-2])
def test_corners_of_nearly_180_degrees_are_none(opening):
    filling = build.fill(nearly_round(opening))
    assert len(filling.patches) == 4 and filling.angle <= 1e-9 and filling.inner_angle <= 1e-9


def test_a_disc_in_a_plane_is_flat():
    ring = sc.BezierCurve([(2, 0, 0), (1, 0, 0)])
    sides = [(patch, min(BORDERS, key=lambda name: np.hypot(*dense_curve(patch.boundary(name))[:, :2].T).mean()), word)
             for patch, _, word in sectors(ring, 4, "G2")]
    filling = build.fill(sides)
    points = np.concatenate([dense(patch) for patch in filling.patches])
    assert np.abs(points[:, 2]).max() <= 1e-14 and filling.angle <= 1e-7
    assert np.hypot(points[:, 0], points[:, 1]).max() <= 1 + 1e-14


def test_the_point_is_one_and_the_surface_smooth_there():
    filling = build.fill(cylinder_hole(5, "G1", 0.2, np.c_[[[1, 0.2, 0], [0, 1.3, 0.1], [0.1, 0, 1]], (3, 4, 5)]))
    tips = {tuple(patch.points[i, -1]) for patch in filling.patches for i in range(patch.points.shape[0])}
    assert len(tips) == 1
    normals = [patch.evaluate_grid_with_normals(np.linspace(*patch.domain[0], 9), [patch.domain[1][1]])[1].reshape(-1, 3)
               for patch in filling.patches]
    normals = np.concatenate(normals)
    assert np.abs(normals - normals[0]).max() <= 1e-9 and filling.inner_angle <= 1e-4


def test_patches_of_a_dome_share_their_control_points():
    filling = build.fill(sphere_hole(6, "G2", 0.4))
    for patch, following in zip(filling.patches, filling.patches[1:] + filling.patches[:1]):
        assert np.array_equal(patch.points[-1], following.points[0])


def test_what_it_says_is_what_is_measured():
    around = sphere_hole(5, "G1", 0.6)
    filling = build.fill(around)
    angles = [sc.seam_continuity(dome, "v_start", patch, name).angle for dome, (patch, name, _) in zip(filling.patches, around)]
    assert max(angles) == pytest.approx(filling.angle, abs=1e-12)


def test_sides_that_go_on_with_a_curve_among_them():
    around = cylinder_hole(4, "G1")
    sides = [around[0], around[1][0].boundary(around[1][1]), around[2], (around[3][0], around[3][1], "G0")]
    filling = build.fill(sides)
    assert filling.gap <= 1e-14 and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4


@pytest.mark.parametrize("size", [1e-150, 1e-6, 1e6, 1e150])
def test_any_size_and_place(size):
    matrix = np.c_[np.eye(3) * size, np.array([3.0, -2.0, 1.0]) * size]
    there, here = build.fill(cylinder_hole(4, "G1", matrix=matrix)), build.fill(cylinder_hole(4, "G1"))
    for a, b in zip(there.patches, here.patches):
        assert np.abs(np.asarray(a.points) - b.transformed(matrix).points).max() <= 1e-9 * size


def test_random_round_holes_are_followed(inputs):
    """Walls of revolution that are bent by affine maps, of any slope, split anywhere round."""
    rng = np.random.default_rng(11)
    wanted = inputs(1000)
    followed = 0
    for _ in range(wanted):
        profile = sc.BezierCurve(np.c_[1 + rng.uniform(-0.5, 0.5, 3), np.zeros(3), np.sort(rng.uniform(-1, 0, 3))])
        word = str(rng.choice(["G1", "G2"]))
        matrix = np.c_[np.eye(3) + rng.uniform(-0.3, 0.3, (3, 3)), rng.uniform(-5, 5, 3)]
        around = [(patch.transformed(matrix), name, word)
                  for patch, name, _ in sectors(profile, int(rng.integers(3, 9)), word, rng.uniform(0, 6))]
        try:
            filling = build.fill(around)
        except sc.InvalidShape as error:
            assert "turns back" in str(error)
            continue
        followed += 1
        assert filling.gap <= 1e-13 and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4
        assert all(np.isfinite(patch.points).all() for patch in filling.patches)
    assert followed >= 0.9 * wanted


def test_a_round_hole_that_its_middle_does_not_see_is_refused():
    angles = 2 * np.pi * np.arange(12) / 12
    radius = np.where(np.arange(12) % 6 < 2, 3.0, 0.4)
    points = np.c_[radius * np.cos(angles) + 2 * np.sin(angles) ** 2, radius * np.sin(angles), np.zeros(12)]
    edge = sc.fit.interpolate(points, degree=3, closed=True).value
    places = np.linspace(*edge.domain, 5)
    parts = [build.extrude(edge.part(*ends), UP) for ends in zip(places[:-1], places[1:])]
    with pytest.raises(sc.InvalidShape, match="not seen whole"):
        build.fill([(part, "v_end", "G1") for part in parts])


def test_a_weight_below_zero_is_refused():
    around = cylinder_hole(4, "G1")
    patch = around[0][0]
    weights = np.array(patch.weights)
    weights[(slice(1, -1), slice(None))[::1 if weights.shape[0] == 3 else -1]] *= -1
    with pytest.raises(sc.InvalidShape):
        build.fill([(patch.with_weights(weights), around[0][1], "G1"), *around[1:]])


def test_neighbors_from_which_nothing_goes_on_are_as_curves():
    around = sphere_hole(4, "G1", 0.5)
    mixed = [around[0], *((patch, name, "G0") for patch, name, _ in around[1:])]
    curves = [around[0], *(patch.boundary(name) for patch, name, _ in around[1:])]
    for a, b in zip(build.fill(mixed).patches, build.fill(curves).patches):
        assert np.abs(np.asarray(a.points) - b.points).max() <= 1e-12


def test_a_rational_circle_of_curves_alone_is_flat_as_before():
    arc = circle()
    places = np.linspace(*arc.domain, 5)
    filling = build.fill([arc.part(*ends) for ends in zip(places[:-1], places[1:])], tolerance=1e-5)
    assert len(filling.patches) == 1 and filling.gap <= 1e-5
