"""Holes of three to eight sides: quadrics come back, planes and curvatures go on, what cannot be filled is refused."""

import math

import numpy as np
import pytest

import splinecore as sc
from shapes import circle
from splinecore import build

QUADRIC = (0.3, 0.2, -0.4)


def height(x, y):
    a, b, c = QUADRIC
    return a * x * x + b * x * y + c * y * y


def quadric_over(corners, degree=4):
    """The part of z = height(x, y) over a quadrilateral, as a Bezier patch by interpolation."""
    corners = np.array(corners, float)
    t = np.linspace(0, 1, degree + 1)
    u, v = np.meshgrid(t, t, indexing="ij")
    shares = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], -1)
    x, y = np.moveaxis(shares @ corners, -1, 0)
    basis = np.array([[math.comb(degree, k) * s ** k * (1 - s) ** (degree - k) for k in range(degree + 1)] for s in t])
    inverse = np.linalg.inv(basis)
    return sc.BezierPatch(np.einsum("ia,jb,abk->ijk", inverse, inverse, np.stack([x, y, height(x, y)], -1)))


def polygon_hole(count, word, turn=0.0, stretch=1.0):
    """A hole in the quadric with so many sides, and patches beyond each."""
    angles = 2 * np.pi * np.arange(count) / count + turn
    inner = np.c_[np.cos(angles) * stretch, np.sin(angles)]
    outer = 2 * inner
    return [(quadric_over([inner[i], inner[(i + 1) % count], outer[(i + 1) % count], outer[i]]), "v_start", word)
            for i in range(count)]


def grid(patch, count=33):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain)).reshape(-1, 3)


def off_quadric(filling):
    points = np.concatenate([grid(patch) for patch in filling.patches])
    return np.abs(points[:, 2] - height(points[:, 0], points[:, 1])).max()


@pytest.mark.parametrize("word", ["G0", "G1", "G2"])
@pytest.mark.parametrize("count", range(3, 9))
def test_a_hole_in_a_quadric_is_filled(count, word):
    """Tangent planes, curvatures and tangent planes of the filling itself but for rounding: all round about is one surface."""
    filling = build.fill(polygon_hole(count, word, turn=0.3, stretch=1.2))
    assert len(filling.patches) == (1 if count == 4 else count)
    assert filling.gap <= 1e-12 and filling.angle <= 1e-11 and filling.inner_angle <= 1e-11
    assert filling.curvature_difference <= 1e-9
    assert off_quadric(filling) <= (0.1 if word == "G0" else 4e-3)


@pytest.mark.parametrize("word", ["G0", "G1", "G2"])
def test_four_sides_of_a_quadric_give_it_back(word):
    """It has no third derivatives: nothing bends less."""
    filling = build.fill(polygon_hole(4, word))
    assert off_quadric(filling) <= 1e-12


def test_what_it_says_is_what_is_measured():
    around = polygon_hole(5, "G1")
    filling = build.fill(around)
    angles = []
    for i, (neighbor, side, _) in enumerate(around):
        before, behind = neighbor.split("u", 0.5)
        angles.append(sc.seam_continuity(filling.patches[i], "v_start", before, side).angle)
        angles.append(sc.seam_continuity(filling.patches[(i + 1) % 5], "u_start", behind, side).angle)
    assert max(angles) == pytest.approx(filling.angle, abs=1e-12)
    inner = max(sc.seam_continuity(filling.patches[i], "u_end", filling.patches[(i + 1) % 5], "v_end").angle for i in range(5))
    assert inner == pytest.approx(filling.inner_angle, abs=1e-12)


def test_patches_share_their_control_points():
    filling = build.fill(polygon_hole(6, "G1"))
    for i, patch in enumerate(filling.patches):
        other = filling.patches[(i + 1) % 6]
        assert np.array_equal(patch.points[-1], other.points[:, -1])


def test_normals_lie_on_one_side():
    filling = build.fill(polygon_hole(7, "G1"))
    signs = set()
    for patch in filling.patches:
        normals = patch.evaluate_grid_with_normals(np.linspace(0.05, 0.95, 7), np.linspace(0.05, 0.95, 7))[1]
        signs.update(np.sign(normals[..., 2]).ravel())
    assert len(signs) == 1


@pytest.mark.parametrize("size", [1e-150, 1e-6, 1e6, 1e150])
def test_any_size_and_place(size):
    matrix = np.c_[np.eye(3) * size, np.array([3.0, -2.0, 1.0]) * size]
    around = [(patch.transformed(matrix), side, word) for patch, side, word in polygon_hole(5, "G1")]
    there, here = build.fill(around), build.fill(polygon_hole(5, "G1"))
    for a, b in zip(there.patches, here.patches):
        want = b.transformed(matrix).points
        assert np.abs(np.asarray(a.points) - want).max() <= 1e-6 * size
    assert there.angle <= 1e-4


def test_directions_of_sides_are_of_no_matter():
    sides = [sc.BezierCurve(p) for p in ([(0, 0, 0), (1, 0, .5), (2, 0, 0)], [(2, 0, 0), (2, 1, .5), (1, 2, 0)], [(1, 2, 0), (0, 1, -.5), (0, 0, 0)])]
    one = build.fill(sides)
    other = build.fill([sides[0], sides[1].reversed(), sides[2].reversed()])
    for a, b in zip(one.patches, other.patches):
        assert np.abs(np.asarray(a.points) - b.points).max() <= 1e-12


def test_rational_sides_are_reached_within_the_tolerance():
    arc = circle()
    places = np.linspace(*arc.domain, 4)
    filling = build.fill([arc.part(*ends) for ends in zip(places[:-1], places[1:])], tolerance=1e-5)
    assert filling.gap <= 1e-5
    points = np.concatenate([grid(p) for p in filling.patches])
    assert np.abs(points[:, 2]).max() <= 1e-12 and np.hypot(points[:, 0], points[:, 1]).max() <= 1 + 1e-5


def test_random_neighbors_are_followed_or_refused(inputs):
    rng = np.random.default_rng(7)
    followed, wanted = 0, inputs(240)
    for _ in range(wanted):
        count = int(rng.integers(3, 9))
        around = polygon_hole(count, str(rng.choice(["G0", "G1", "G2"])), rng.uniform(0, 6), rng.uniform(0.5, 2))
        bent = []
        for patch, side, word in around:
            points = np.array(patch.points)
            points[1:-1, 1:] += rng.normal(0, 0.05, points[1:-1, 1:].shape)
            bent.append((sc.BezierPatch(points), side, word))
        try:
            filling = build.fill(bent, tolerance=1e-3)
        except (sc.InvalidShape, sc.ToleranceNotReached):
            continue
        followed += 1
        assert filling.gap <= 1e-3 and filling.inner_angle <= 0.05
        assert all(np.isfinite(patch.points).all() for patch in filling.patches)
    assert followed >= 0.9 * wanted


SQUARE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
OUTWARDS = np.array([(0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0)], float)


def flat_about(i, tilt=0.0, twist=0.0, word="G1"):
    """A strip beside a side of the square, quadratic along it, tilted at the side's start and in its middle."""
    rows = np.linspace(SQUARE[i], SQUARE[(i + 1) % 4], 3)[:, None] + np.array([0, 1])[None, :, None] * OUTWARDS[i]
    rows[0, 1, 2] += tilt
    rows[1, 1, 2] += twist
    return sc.BezierPatch(rows), "v_start", word


@pytest.mark.parametrize("word", ["G1", "G2"])
@pytest.mark.parametrize("tilt", [0.0, 1e-6, 3e-6, 1e-5, 1e-3, 1e-2])
def test_planes_that_agree_only_nearly_at_a_corner_do_no_harm(word, tilt):
    """What they differ by is not divided by how little it is."""
    filling = build.fill([flat_about(0, tilt, word=word), *(flat_about(i, word=word) for i in (1, 2)), flat_about(3, 0.0, 1e-2, word)],
                         tolerance=1e-3)
    points = grid(filling.patches[0])
    assert points[:, :2].max() <= 1 + 1e-9 and points[:, :2].min() >= -1e-9 and np.abs(points[:, 2]).max() <= 3e-2
    assert filling.angle <= max(1.5e-4, 1.01 * tilt)


def wavy_side():
    y = 0.05 * np.array([0, 1, -1, 1, -1, 1, -1, 1, -1, 0])
    return sc.NurbsCurve(3, [0] * 4 + [k / 7 for k in range(1, 7)] + [1] * 4, np.c_[np.linspace(0, 1, 10), y, 0 * y])


def test_sides_are_kept_where_neighbors_let_no_angle_be_reached():
    """A tilted strip beside flat ones: what is off at a corner is said, and a side with many knots is there exactly."""
    filling = build.fill([wavy_side(), flat_about(1), flat_about(2, 1e-3), flat_about(3)])
    assert filling.gap <= 1e-14 and filling.angle == pytest.approx(1e-3, rel=0.05)


@pytest.mark.parametrize("degree", [8, 9])
def test_sides_of_high_degrees_are_kept(degree):
    x = np.linspace(0, 1, degree + 1)
    side = sc.BezierCurve(np.c_[x, 0.1 * np.sin(7 * np.pi * x), 0 * x])
    filling = build.fill([side, flat_about(1), flat_about(2), flat_about(3)])
    assert filling.gap <= 1e-14 and filling.angle <= 1e-9


def bent_quadric_hole(weights):
    """Neighbors in a quadric, bent behind their sides, with weights."""
    rng = np.random.default_rng(5)
    around = []
    for patch, side, word in polygon_hole(4, "G1", 0.3, 1.2):
        points = np.array(patch.points)
        points[1:-1, 1:] += rng.normal(0, 0.05, points[1:-1, 1:].shape)
        around.append((sc.BezierPatch(points, np.exp(rng.normal(0, weights, points.shape[:2]))), side, word))
    return around


@pytest.mark.parametrize("weights", [0.0, 0.1])
def test_it_is_of_no_matter_where_the_list_begins(weights):
    around = bent_quadric_hole(weights)
    first = build.fill(around)
    u, v = np.linspace(0, 1, 9), np.linspace(0, 1, 9)
    here = first.patches[0].evaluate_grid(u, v)
    for order in (around[1:] + around[:1], around[2:] + around[:2], around[::-1]):
        other = build.fill(order)
        there = other.patches[0].evaluate_grid(u, v)
        turned = [np.rot90(there, k) for k in range(4)] + [np.rot90(there.swapaxes(0, 1), k) for k in range(4)]
        assert min(np.abs(here - one).max() for one in turned) <= 1e-12


def rational_sphere_patch(corners):
    """A quadrilateral of the plane on the unit sphere, stereographically: exact, biquadratic."""
    corners = np.array(corners, float)
    u, v = np.meshgrid(*[np.linspace(0, 1, 3)] * 2, indexing="ij")
    x, y = np.moveaxis(np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], -1) @ corners, -1, 0)
    values = np.stack([2 * x, 2 * y, 1 - x * x - y * y, 1 + x * x + y * y], -1)
    inverse = np.linalg.inv([[1, 0, 0], [0.25, 0.5, 0.25], [0, 0, 1]])
    points = np.einsum("ia,jb,abk->ijk", inverse, inverse, values)
    return sc.BezierPatch(points[..., :3] / points[..., 3:], points[..., 3])


@pytest.mark.parametrize("stretch", [1.0, 0.7])
def test_rational_borders_are_those_of_the_neighbors(stretch):
    """With fewer points than polynomials have that come as close."""
    angles = 2 * np.pi * np.arange(4) / 4 + 0.3
    inner = 0.4 * np.c_[np.cos(angles), stretch * np.sin(angles)]
    around = [(rational_sphere_patch([inner[i], inner[(i + 1) % 4], 2 * inner[(i + 1) % 4], 2 * inner[i]]), "v_start", "G1")
              for i in range(4)]
    filling = build.fill(around)
    t = np.linspace(0, 1, 65)
    dome, patch = filling.patches[0], around[0][0]
    assert np.abs(dome.boundary("v_start").evaluate(t) - patch.boundary("v_start").evaluate(t)).max() <= 1e-14
    assert filling.gap <= 1e-14 and filling.angle <= 1e-4 and dome.points.size <= 3 * 49
    assert np.abs(np.linalg.norm(grid(dome), axis=1) - 1).max() <= 4e-3


def test_tolerances_are_by_the_sides_and_not_by_what_lies_beyond():
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0.2, 1, 0)]
    around = [(build.extrude(sc.BezierCurve([SQUARE[i], corners[(i + 1) % 4]]), (0, 0, -1e6)), "v_start", "G0") for i in range(4)]
    with pytest.raises(sc.ToleranceNotReached, match="gap"):
        build.fill(around)


LINES = [sc.BezierCurve(p) for p in ([(0, 0, 0), (1, 0, 0)], [(1, 0, 0), (0, 1, 0)], [(0, 1, 0), (0, 0, 0)])]


@pytest.mark.parametrize("sides, more, words", [
    (LINES[:2], {}, "3 to 8"),
    (LINES * 3, {}, "3 to 8"),
    (LINES[:2] + [sc.BezierCurve([(0, 1, 1), (0, 0, 0)])], {}, "gap"),
    (LINES, {"angle": 0.0}, "angle"),
    (LINES[:2] + [(build.plane((0, 0, 0), (0, 1, 0), (1, 0, 0)), "v_start", "G1")], {}, "turns back|fold"),
    (LINES[:2] + [(build.plane((0, 0, 0), (0, 1, 0), (-1, 0, 0)), "v_start", "G3")], {}, "continuity 3"),
    (LINES[:2] + [(build.cylinder((0, 0, 0), (0, 0, 1), 1, 1), "u_start", "G1")], {}, "seam"),
])
def test_what_cannot_be_filled_is_refused(sides, more, words):
    with pytest.raises((sc.InvalidShape, sc.ToleranceNotReached), match=words):
        build.fill(sides, **more)


@pytest.mark.parametrize("sides", [3, LINES[0], [(1, 2), LINES[0], LINES[1]]])
def test_what_is_no_side_is_a_type_error(sides):
    with pytest.raises(TypeError):
        build.fill(sides)


@pytest.mark.parametrize("word", ["G1", "G2"])
@pytest.mark.parametrize("knot", [0.5, 0.3, 0.1])
def test_knots_that_are_not_even_are_as_good_on_either_side(knot, word):
    """Two like neighbors, mirrored, with a knot that is not in the middle."""
    knots = [0, 0, 0, 0, knot, 1, 1, 1, 1]
    side = sc.NurbsCurve(3, knots, [(0, 0, 0), (0.1, 0.2, 0.3), (0, 0.5, 0.5), (0.1, 0.8, 0.2), (0, 1, 0)])
    behind = side.with_points([(-0.5, 0, 0), (-0.5, 0.2, 0), (-0.6, 0.5, 0.2), (-0.5, 0.8, 0.1), (-0.5, 1, 0)])
    first = build.loft([behind.with_points(behind.points - (0.5, 0, 0)), behind, side]).value
    other = first.transformed(np.array([[-1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]], float))
    low, high = (build.blend(first.boundary(end), other.boundary(end).reversed(), 2) for end in ("u_start", "u_end"))
    filling = build.fill([(first, "v_end", word), high, (other, "v_end", word), low])
    angles = [sc.seam_continuity(neighbor, "v_end", filling.patches[0], end).angle
              for neighbor, end in ((first, "v_start"), (other, "v_end"))]
    assert max(angles) <= 1.01e-4 and filling.angle <= 1.01e-4


def sphere_patch(corners):
    """The bilinear patch of corners, put on the unit sphere at many places: nearly a part of it."""
    corners = np.array(corners, float)
    u, v = np.meshgrid(*[np.linspace(0, 1, 25)] * 2, indexing="ij")
    shares = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], -1)
    flat = shares @ corners
    points = np.concatenate([flat, np.ones((*u.shape, 1))], -1)
    points = points / np.linalg.norm(points, axis=-1, keepdims=True)
    return sc.fit.interpolate_patch(points, degrees=(5, 5), parameters="chordal").value


@pytest.mark.parametrize("word, count, most", [("G1", 4, 2e-3), ("G2", 4, 2e-3), ("G1", 5, 6e-3), ("G2", 5, 6e-3), ("G1", 6, 8e-3)])
def test_a_hole_in_a_sphere_is_filled_with_a_dome(word, count, most):
    """Half a radius wide: what is flat, as least third derivatives alone are, is farther off by ten times."""
    angles = 2 * np.pi * np.arange(count) / count + 0.2
    inner = 0.6 * np.c_[np.cos(angles), np.sin(angles)]
    outer = 2 * inner
    sides = [(sphere_patch([inner[i], inner[(i + 1) % count], outer[(i + 1) % count], outer[i]]), "v_start", word)
             for i in range(count)]
    filling = build.fill(sides, tolerance=1e-4)
    assert max(np.abs(np.linalg.norm(grid(patch), axis=1) - 1).max() for patch in filling.patches) <= most


@pytest.mark.parametrize("word", ["G0", "G1", "G2"])
@pytest.mark.parametrize("count, knots", [(3, 12), (5, 5), (5, 20), (8, 5)])
def test_sides_with_many_knots_are_followed(count, knots, word):
    """Also where knots of one side come near those of another one on the same patch."""
    around = []
    for patch, border, _ in polygon_hole(count, word, 0.3, 1.2):
        patch = patch.to_nurbs().refine("u", np.linspace(0, 1, knots + 2)[1:-1] * 0.97 + 0.01)
        points = patch.points.copy()
        height = 2e-4 if word == "G2" else 2e-3  # curvatures of more would go on until what fills the hole folds
        points[2:-2, 0, 2] += height * np.sin(2.1 * np.arange(len(points)))[2:-2]
        around.append((patch.with_points(points), border, word))
    filling = build.fill(around)
    assert filling.gap <= 2e-6 and filling.angle <= 2e-2 and filling.inner_angle <= 2e-4


@pytest.mark.parametrize("degree", [9, 60, 200])
def test_sides_of_high_degree_are_followed(degree):
    t = np.linspace(0, 1, degree + 1)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    bumps = np.sin(np.pi * t) ** 3 / 3
    sides = [sc.BezierCurve(np.outer(1 - t, a) + np.outer(t, b) + np.outer(bumps, (0, 0, 1)))
             for a, b in zip(np.array(corners, float), np.roll(corners, -1, 0))]
    filling = build.fill(sides)
    assert filling.gap <= 2e-6
    points = filling.patches[0].evaluate_grid(np.linspace(0, 1, 33), np.linspace(0, 1, 33))
    assert np.abs(points).max() <= 1 + 1e-6


def filled_or_folded(curve):
    """What fills the triangle on a curve; none where it would fold, which is said."""
    try:
        return build.fill([curve, sc.BezierCurve([(1, 0, 0), (0.5, 1, 0)]), sc.BezierCurve([(0.5, 1, 0), (0, 0, 0)])],
                          tolerance=1e-3)
    except sc.InvalidShape as refusal:
        assert "turns back over itself" in str(refusal)
        return None


def test_the_gap_is_the_largest_one():
    """Also where a rational side is fast at its ends."""
    filled = 0
    for seed in range(10):
        rng = np.random.default_rng(seed)
        x = np.linspace(0, 1, 8)
        points = np.c_[x, 0.05 * rng.normal(size=8) * 4 * x * (1 - x), 0 * x]
        knots = [0.0] * 4 + list(np.sort(rng.uniform(0.02, 0.98, 4))) + [1.0] * 4
        curve = sc.NurbsCurve(3, knots, points, np.exp(rng.normal(0, 1, 8)))
        filling = filled_or_folded(curve)
        if filling is None:
            continue
        filled += 1
        t = np.linspace(0, 1, 2001) ** 2
        wanted = curve.evaluate(np.r_[t / 2, 1 - t / 2])
        near = [filling.patches[0].boundary("v_start"), filling.patches[1].boundary("u_start")]
        off = np.min([np.linalg.norm(border.nearest(wanted).points - wanted, axis=1) for border in near], axis=0)
        assert off.max() <= filling.gap * (1 + 1e-3) + 1e-12 and filling.gap <= 1e-3
    assert filled >= 2
