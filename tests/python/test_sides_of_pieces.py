"""Holes in which patches follow one another along a side: they are one side, and what fills the hole goes on from each."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_fill import grid, off_quadric, polygon_hole, quadric_over


def parted(side, *places):
    """A neighbor cut there, in the order of its pieces."""
    patch, border, word = side
    low, high = patch.domain[0]
    pieces = []
    for place in places:
        first, patch = patch.split("u", low + place * (high - low))
        pieces.append((first, border, word))
    return [*pieces, (patch, border, word)]


def fanned(corners, outer, word="G1"):
    """A patch of the quadric beyond a piece of a side, its other corners anywhere."""
    return quadric_over([*corners, *outer]), "v_start", word


def test_pieces_of_one_neighbor_are_as_that_neighbor():
    for word in ("G1", "G2"):
        around = polygon_hole(4, word, 0.3, 1.2)
        for places in ([0.5], [0.3], [0.2, 0.7], [1e-3]):
            filling = build.fill(parted(around[0], *places) + around[1:])
            assert len(filling.patches) == 1 and filling.gap <= 1e-12 and filling.angle <= 1e-9
            assert off_quadric(filling) <= 1e-9


@pytest.mark.parametrize("turned", range(5))
def test_the_list_may_begin_at_any_piece(turned):
    around = polygon_hole(4, "G1", 0.3)
    sides = parted(around[0], 0.4) + around[1:]
    filling = build.fill(sides[turned:] + sides[:turned])
    assert len(filling.patches) == 1 and off_quadric(filling) <= 1e-12


@pytest.mark.parametrize("count", [3, 5, 6, 7])
@pytest.mark.parametrize("word", ["G1", "G2"])
def test_other_numbers_of_sides(count, word):
    around = polygon_hole(count, word, 0.3, 1.2)
    filling = build.fill(around[:2] + parted(around[2], 0.4) + around[3:])
    assert len(filling.patches) == count
    assert filling.gap <= 1e-12 and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4
    assert off_quadric(filling) <= 0.2


@pytest.mark.parametrize("word", ["G1", "G2"])
def test_neighbors_that_have_only_their_planes_in_common(word):
    """Lines of one run away from the hole in another way than those of the other one."""
    a, b, c, d = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    middle = np.array([0.2, -1.0])
    beyond = np.array([0.3, -2.5])
    around = [fanned([a, middle], [beyond, (-3, -3)], word), fanned([middle, b], [(1.2, -1.4), beyond], word),
              fanned([b, c], [(2, 2), (2, -2)], word), fanned([c, d], [(-2, 2), (2, 2)], word), fanned([d, a], [(-2, -2), (-2, 2)], word)]
    filling = build.fill(around)
    assert len(filling.patches) == 1 and filling.gap <= 1e-12 and filling.angle <= 1e-3
    assert off_quadric(filling) <= 0.2


def strips_along(xs, word, make=lambda corners: quadric_over(corners)):
    """Neighbors below y = -1 between these x, whose seams lean, and the other three sides of a square."""
    a, b, c, d = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    words = [word] * (len(xs) - 1) if isinstance(word, str) else word
    beyond = [np.array([x + 0.2 * k * x, -2.2]) for k, x in enumerate(xs)]
    strips = [(make([(x, -1), (y, -1), beyond[k + 1], beyond[k]]), "v_start", words[k]) for k, (x, y) in enumerate(zip(xs, xs[1:]))]
    last = words[-1]
    return strips + [fanned([b, c], [(2, 2), (2, -2)], last), fanned([c, d], [(-2, 2), (2, 2)], last), fanned([d, a], [(-2, -2), (-2, 2)], last)]


@pytest.mark.parametrize("xs", [(-1, 0, 1), (-1, -0.3, 0.5, 1), (-1, -0.7, -0.2, 0.1, 1), (-1, 0.2 + 1e-9, 1)])
@pytest.mark.parametrize("word", ["G1", "G2"])
def test_any_number_of_pieces(xs, word):
    filling = build.fill(strips_along(xs, word))
    assert len(filling.patches) == 1 and filling.gap <= 1e-12 and filling.angle <= 1e-3
    assert off_quadric(filling) <= 0.1


@pytest.mark.parametrize("word", ["G1", "G2"])
def test_rational_pieces_with_more_knots_in_any_direction(word):
    rng = np.random.default_rng(8)

    def make(corners):
        patch = quadric_over(corners).to_nurbs().moebius("u", rng.uniform(0.7, 1.4)).moebius("v", rng.uniform(0.7, 1.4))
        return patch.refine("u", [0.4, 0.4]).refine("v", [0.6]).elevate("v")

    sides = strips_along((-1, -0.2, 1), word, make)
    turned = [(sides[0][0].swapped(), "u_start", word), (sides[1][0].reversed("v").unclamped("v").reversed("u"), "v_end", word)]
    filling = build.fill(turned + sides[2:], angle=1e-3)
    assert len(filling.patches) == 1 and filling.gap <= 2e-6 and filling.angle <= 5e-3
    assert off_quadric(filling) <= 0.1


def test_each_piece_goes_on_as_it_is_asked_to():
    """Curvatures count beside the pieces that are to go on with curvatures."""
    around = strips_along((-1, 0.2, 1), ["G1", "G2"])
    bent = around[0][0].points + np.array([0, 0, 0.5]) * np.array([0, 0, 1, 3, 6])[None, :, None]
    filling = build.fill([(around[0][0].with_points(bent), "v_start", "G1"), *around[1:]])
    first, second = filling.patches[0].split("u", 0.6)
    of_second = sc.seam_continuity(second, "v_start", around[1][0], "v_start").curvature_difference
    others = [sc.seam_continuity(filling.patches[0], name, neighbor, "v_start").curvature_difference
              for name, (neighbor, _, _) in zip(("u_end", "v_end", "u_start"), around[2:])]
    assert filling.curvature_difference == pytest.approx(max(of_second, *others), rel=1e-6)
    assert sc.seam_continuity(first, "v_start", around[0][0].with_points(bent), "v_start").curvature_difference > 0.5


def test_what_it_says_is_what_is_measured():
    around = polygon_hole(4, "G1", 0.3)
    strip = parted(around[0], 0.4)
    bent = strip[1][0].with_points(strip[1][0].points + np.array([0, 0, 0.05]) * np.linspace(0, 1, 5)[None, :, None])
    filling = build.fill([strip[0], (bent, "v_start", "G1"), *around[1:]])
    patch, = filling.patches
    first, second = patch.split("u", 0.4)
    angles = [sc.seam_continuity(first, "v_start", strip[0][0], "v_start").angle, sc.seam_continuity(second, "v_start", bent, "v_start").angle]
    angles += [sc.seam_continuity(patch, name, neighbor, "v_start").angle
               for name, (neighbor, _, _) in zip(("u_end", "v_end", "u_start"), around[1:])]
    assert filling.angle > 1e-3
    assert max(angles) == pytest.approx(filling.angle, rel=1e-9)


def ring_sector(start, end, word):
    """A flat piece beyond an arc of the unit circle, exact."""
    half = (end - start) / 2
    arc = [(math.cos(start), math.sin(start)), (math.cos(start + half) / math.cos(half), math.sin(start + half) / math.cos(half)),
           (math.cos(end), math.sin(end))]
    points = np.array([[(x * r, y * r, 0) for r in (1, 2)] for x, y in arc])
    weights = np.array([[1, 1], [math.cos(half)] * 2, [1, 1]])
    return sc.BezierPatch(points, weights), "v_start", word


def test_arcs_that_make_one_side():
    """A flat quarter of a disc, its arc in two pieces of different size, is flat."""
    strips = [sc.BezierPatch(np.array([[(0, 1, 0), (-1, 1, 0)], [(0, 0, 0), (-1, 0, 0)]], float)),
              sc.BezierPatch(np.array([[(0, 0, 0), (0, -1, 0)], [(1, 0, 0), (1, -1, 0)]], float))]
    sides = [ring_sector(0, 0.5, "G1"), ring_sector(0.5, math.pi / 2, "G1")] + [(strip, "v_start", "G1") for strip in strips]
    filling = build.fill(sides)
    points = np.concatenate([grid(patch) for patch in filling.patches])
    assert len(filling.patches) == 3 and filling.gap <= 1e-6
    assert np.abs(points[:, 2]).max() <= 1e-12 and np.hypot(points[:, 0], points[:, 1]).max() <= 1 + 1e-6


@pytest.mark.parametrize("size", [1e-150, 1e-30, 1e6, 1e150])
def test_any_size_and_place(size):
    matrix = np.c_[np.eye(3) * size, np.array([3.0, -2.0, 1.0]) * size]
    around = polygon_hole(5, "G1", 0.3)
    sides = parted(around[0], 0.4) + around[1:]
    here = build.fill(sides)
    there = build.fill([(patch.transformed(matrix), border, word) for patch, border, word in sides])
    for a, b in zip(there.patches, here.patches):
        assert np.abs(np.asarray(a.points) - b.transformed(matrix).points).max() <= 1e-9 * size


def test_random_pieces_are_followed(inputs):
    rng = np.random.default_rng(5)
    wanted = inputs(1000)
    for _ in range(wanted):
        count = int(rng.integers(3, 7))
        word = str(rng.choice(["G1", "G2"]))
        around = polygon_hole(count, word, rng.uniform(0, 6), rng.uniform(0.7, 1.4))
        cut = int(rng.integers(count))
        sides = around[:cut] + parted(around[cut], *np.sort(rng.choice(np.arange(1, 10), int(rng.integers(1, 3)), False)) / 10) + around[cut + 1:]
        sides = [(patch.reversed("u") if rng.random() < 0.5 else patch, border, kind) for patch, border, kind in sides]
        filling = build.fill(sides)
        assert len(filling.patches) == (1 if count == 4 else count)
        assert filling.gap <= 1e-9 and filling.angle <= 1e-3 and filling.inner_angle <= 1e-3


def joint_in_quadric(count, word, at, kink=0.0):
    """A hole in the quadric with a joint on its first side, whose neighbors' seam leans, and a kink in plan there."""
    angles = 2 * np.pi * np.arange(count) / count + 0.3
    inner = list(np.c_[np.cos(angles), np.sin(angles)])
    way = inner[1] - inner[0]
    middle = inner[0] + at * way + kink * at * (1 - at) * np.array([way[1], -way[0]])
    loop = [inner[0], middle, *inner[1:]]
    beyond = [2 * point for point in loop]
    beyond[1] = 2 * middle + 0.3 * way
    return [(quadric_over([loop[i], loop[(i + 1) % len(loop)], beyond[(i + 1) % len(loop)], beyond[i]]), "v_start", word)
            for i in range(len(loop))]


@pytest.mark.parametrize("at", [0.51, 0.501, 0.5001, 0.50001, 0.500001, 0.5000001])
@pytest.mark.parametrize("count, word", [(5, "G1"), (3, "G2"), (4, "G2")])
def test_joints_near_knots_of_the_filling(count, word, at):
    filling = build.fill(joint_in_quadric(count, word, at))
    assert filling.gap <= 1e-12 and filling.angle <= 1e-6 and filling.inner_angle <= 1e-4
    assert off_quadric(filling) <= 0.1


@pytest.mark.parametrize("off", [1e-2, 1e-3, 1e-4, 1e-5])
def test_knots_near_the_middle_of_a_side(off):
    around = polygon_hole(5, "G1", 0.3)
    sides = [(around[0][0].to_nurbs().insert_knot("u", 0.5 + off), "v_start", "G1"), *around[1:]]
    assert off_quadric(build.fill(sides)) <= 1e-3


@pytest.mark.parametrize("kink", [1e-9, 1e-6, 1e-3, 0.01])
@pytest.mark.parametrize("count, word, at", [(5, "G1", 0.2), (5, "G1", 0.35), (4, "G1", 0.35), (4, "G2", 0.2), (5, "G2", 0.35)])
def test_kinks_at_joints_are_in_the_filling(count, word, at, kink):
    filling = build.fill(joint_in_quadric(count, word, at, kink))
    assert len(filling.patches) == (1 if count == 4 else count)
    assert filling.gap <= 1e-10 and filling.angle <= 1e-6 and filling.inner_angle <= 1e-3 and off_quadric(filling) <= 0.1


@pytest.mark.parametrize("pace", [2, 4, 16, 50])
def test_paces_that_change_fast_are_followed_or_refused(pace):
    sides = joint_in_quadric(4, "G1", 0.5)
    try:
        filling = build.fill([(sides[0][0].to_nurbs().moebius("u", pace), "v_start", "G1"), *sides[1:]])
    except sc.InvalidShape as error:
        assert pace > 4 and "turn" in str(error)
        return
    assert off_quadric(filling) <= 0.5 and filling.angle <= 1e-3


@pytest.mark.parametrize("kink", [0.01, 0.019, 0.021, 0.03, 0.1])
def test_joints_that_stand_up_a_little_are_no_corners(kink):
    """Planes beside them cannot both be a corner's: from there a surface would turn back. It is off by the kink, more or less."""
    around = polygon_hole(4, "G1", 0.3)
    first, second = parted(around[0], 0.5)
    points = second[0].points + np.array([0, 0, kink]) * (np.linspace(0, 1, 5) * np.linspace(1, 0, 5))[:, None, None]
    filling = build.fill([first, (second[0].with_points(points), "v_start", "G1"), *around[1:]])
    assert len(filling.patches) == 1 and filling.angle <= 2 * kink


def test_a_piece_without_a_neighbor_is_refused():
    around = polygon_hole(4, "G1")
    first, second = parted(around[0], 0.5)
    for bare in ((second[0], "v_start", "G0"), second[0].boundary("v_start")):
        with pytest.raises(sc.InvalidShape, match=r"sides\[0\] and sides\[1\] join without a corner, one from a neighbor"):
            build.fill([first, bare, *around[1:]])
    third, fourth = parted(around[2], 0.5)
    with pytest.raises(sc.InvalidShape, match=r"sides\[3\] and sides\[4\] join without a corner, one from a neighbor"):
        build.fill([around[0], *parted(around[1], 0.5), third, fourth[0].boundary("v_start"), around[3]])


def test_pieces_that_are_curves_are_sides_of_their_own():
    around = polygon_hole(4, "G1", 0.3)
    curves = [patch.boundary(side) for patch, side, _ in parted(around[0], 0.5) + around[1:]]
    filling = build.fill(curves, tolerance=1e-4)
    assert len(filling.patches) == 5 and filling.gap <= 1e-4


def test_fewer_than_three_corners_are_refused():
    lens = [sc.BezierPatch(np.array([[(0, 0, 0), (0, -1, 0)], [(0.5, 0, 0), (0.5, -1, 0)]])),
            sc.BezierPatch(np.array([[(0.5, 0, 0), (0.5, -1, 0)], [(1, 0, 0), (1, -1, 0)]])),
            sc.BezierPatch(np.array([[(1, 0, 0), (1.5, 1, 0)], [(0.5, 1, 0), (0.5, 2, 0)], [(0, 0, 0), (-0.5, 1, 0)]]))]
    with pytest.raises(sc.InvalidShape, match="fewer than three corners"):
        build.fill([(patch, "v_start", "G1") for patch in lens])
