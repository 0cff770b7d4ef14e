"""Random wild holes: what is made meets its borders, does not fold, and is the same from any side on; or a sentence says why not."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_fill import off_quadric, polygon_hole
from test_honest_fillings import found_at, moved, random_sides
from test_wide_holes import corners_at, hole

REFUSALS = ("back over", "reach its sides", "without a corner", "zero derivative", "not seen whole", "too short beside", "lies over no plane", "3 to 8 are expected")


def filled(sides, tolerance):
    """None where a sentence says why not."""
    try:
        return build.fill(sides, tolerance=tolerance)
    except (sc.InvalidShape, sc.ToleranceNotReached) as refusal:
        assert any(word in str(refusal) for word in REFUSALS), refusal
        return None


def a_motion(rng):
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.c_[turn * np.sign(np.linalg.det(turn)), rng.normal(0, 3, 3)]


def places_in_spans(knots, rng):
    """Places in some spans, and which span each is of."""
    knots = np.unique(knots)
    spans = np.sort(rng.permutation(len(knots) - 1)[:12])
    count = max(6, 128 // len(spans))
    shares = 0.002 + 0.996 * np.linspace(0, 1, count)
    return np.concatenate([knots[i] + (knots[i + 1] - knots[i]) * shares for i in spans]), np.repeat(spans, count)


def normals_at(patch, u, v):
    d = np.asarray(patch.first_derivatives(u, v)).reshape(-1, 3, 3)
    return np.cross(d[:, 1], d[:, 2])


def turns_between(patch, one, other, closer=3):
    """The least cosine between normals one after the other on the line between two places, looked at closer where it is below 0: what
    only turns sharply is no fold."""
    t = np.linspace(0, 1, 65)
    places = [a + t * (b - a) for a, b in zip(one, other)]
    normals = normals_at(patch, *places)
    lengths = np.linalg.norm(normals, axis=1)
    kept = lengths > 1e-9 * lengths.max()
    turns = np.cos(angles_within(normals[kept][1:], normals[kept][:-1]))
    least = int(turns.argmin())
    if turns[least] >= 0 or not closer:
        return turns[least]
    u, v = (place[kept] for place in places)
    return turns_between(patch, (u[least], v[least]), (u[least + 1], v[least + 1]), closer - 1)


def angles_within(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1))


def folds(filling, rng):
    """Whether normals turn round between places beside each other, looked at closer where they turn far."""
    for patch in filling.patches:
        (u, of_u), (v, of_v) = (places_in_spans(knots, rng) for knots in patch.knots)
        grid = normals_at(patch, np.repeat(u, len(v)), np.tile(v, len(u))).reshape(len(u), len(v), 3)
        grid = grid / np.maximum(np.linalg.norm(grid, axis=-1), 1e-300)[..., None]
        for step in ((1, 0), (0, 1)):
            a, b = (grid[1:], grid[:-1]) if step[0] else (grid[:, 1:], grid[:, :-1])
            same = (np.diff(of_u) == 0)[:, None] if step[0] else (np.diff(of_v) == 0)[None]
            for i, k in np.argwhere(((a * b).sum(-1) < 0.3) & same)[:20]:
                if turns_between(patch, (u[i], v[k]), (u[i + step[0]], v[k + step[1]])) < 0:
                    return True
    return False


def test_wild_holes_are_filled_as_it_says_or_refused(inputs):
    rng = np.random.default_rng(405)
    wanted, made = inputs(1000), 0
    for _ in range(wanted):
        size, tolerance = 10.0 ** rng.integers(-6, 7), rng.choice([1e-2, 1e-3])
        motion = a_motion(rng)
        sides = [moved(side, size * motion) for side in random_sides(rng)]
        filling = filled(sides, tolerance * size)
        if filling is None:
            continue
        made += 1
        gap, angle = found_at(sides, filling)
        assert filling.gap <= tolerance * size and filling.gap >= 0.98 * gap - 1e-10 * size
        assert filling.angle >= 0.98 * angle - 1e-4
        assert not folds(filling, rng)
    assert made >= 0.3 * wanted


def test_two_and_nine_sides_are_refused():
    rng = np.random.default_rng(2)
    sides = random_sides(rng)
    for wrong in (sides[:2], (3 * sides)[:9]):
        with pytest.raises(sc.InvalidShape, match="3 to 8 are expected"):
            build.fill(wrong)


def grids(filling):
    t = np.linspace(0, 1, 17)
    return [patch.evaluate_grid(*(a + t * (b - a) for a, b in patch.domain)) for patch in filling.patches]


def apart(these, those):
    """How far patches are from those that are the same but for where they begin and how they run."""
    def all_ways(grid):
        return [np.rot90(one, k) for one in (grid, grid.swapaxes(0, 1)) for k in range(4)]
    return max(min(np.abs(one - way).max() for other in those for way in all_ways(other)) for one in these)


def test_the_surface_is_the_same_from_any_side_on_reversed_and_moved(inputs):
    rng = np.random.default_rng(406)
    wanted, differences, parted = inputs(60), [], 0
    for _ in range(wanted):
        sides = random_sides(rng)
        motion, first = a_motion(rng), int(rng.integers(1, len(sides)))
        here = filled(sides, 1e-3)
        for other, matrix in ((sides[first:] + sides[:first], None), (sides[::-1], None), ([moved(side, motion) for side in sides], motion)):
            there = filled(other, 1e-3)
            if here is None or there is None:
                parted += (here is None) != (there is None)
                continue
            wants = grids(here) if matrix is None else [one @ matrix[:, :3].T + matrix[:, 3] for one in grids(here)]
            differences.append(apart(wants, grids(there)))
    differences = np.array(differences)
    assert parted <= 0.02 * wanted and differences.max() <= 1e-4


def crossed_strip(depth):
    """Four sides of which two opposite ones come nearer than nothing in their middle, by a narrow part: a fold there is small."""
    x = np.linspace(0, 1, 8)
    low = np.c_[x, 0.5 * (1 + depth) * np.array([0, 0, 0, 1, 1, 0, 0, 0.0]), 0 * x]
    high = np.c_[x, 1 - 0.5 * (1 + depth) * np.array([0, 0, 0, 1, 1, 0, 0, 0.0]), 0 * x]
    knots = [0] * 4 + [0.2, 0.4, 0.6, 0.8] + [1] * 4
    low, high = (sc.NurbsCurve(3, knots, points) for points in (low, high))
    ends = [sc.BezierCurve([tuple(low.points[k]), tuple(high.points[k])]) for k in (-1, 0)]
    return [low, ends[0], high, ends[1]]


@pytest.mark.parametrize("depth", [0.3, 0.45, 0.7])
def test_a_small_fold_is_found_and_its_place_said(depth):
    """Sides that cross each other in their middle: between the crossings the filling is turned over."""
    with pytest.raises(sc.InvalidShape, match=r"turns back over itself at \(0\.[2-8]"):
        build.fill(crossed_strip(depth))


def test_sides_beside_each_other_are_no_fold():
    build.fill(crossed_strip(-0.5))


@pytest.mark.parametrize("word", ["G1", "G2"])
def test_a_corner_of_more_than_180_degrees_is_refused_by_name(word):
    corners = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], float)
    sides = []
    for a, b in zip(corners, np.roll(corners, -1, 0)):
        out = np.array([(b - a)[1], -(b - a)[0]]) / np.linalg.norm(b - a)
        sides.append((sc.BezierPatch([[(*a, 0), (*(a + 0.3 * out), 0)], [(*b, 0), (*(b + 0.3 * out), 0)]]), "v_start", word))
    with pytest.raises(sc.InvalidShape, match=r"what leaves sides\[[23]\] turns back over its neighbor at its (start|end)"):
        build.fill(sides)


def test_a_side_that_is_missed_is_named():
    rng = np.random.default_rng(5)
    sides = [sc.BezierCurve(points) for points in ([(0, 0, 0), (1, 0, 0)], [(1, 0, 0), (0.5, 1, 0)], [(0.5, 1, 0), (0, 0, 0)])]
    knots = np.r_[[0] * 10, np.repeat(np.sort(rng.uniform(0.05, 0.95, 120)), 9), [1] * 10]
    t = np.linspace(0, 1, len(knots) - 10)
    jagged = sc.NurbsCurve(9, knots, np.c_[1 - 0.5 * t, t, 0.05 * rng.normal(size=len(t)) * (t > 0) * (t < 1)])
    try:
        filling = build.fill([sides[0], jagged, sides[2]], tolerance=1e-9)
    except (sc.InvalidShape, sc.ToleranceNotReached) as refusal:
        assert "sides[1] is missed" in str(refusal) or "back over itself at" in str(refusal)
    else:
        assert filling.gap <= 1e-9


@pytest.mark.parametrize("degrees", [57, 69, 80, 85])
def test_curvatures_go_on_in_wide_holes(degrees):
    """Of a sphere, whose curvatures are 1."""
    for count in (3, 4, 5, 8):
        filling = build.fill(hole(corners_at(count, np.radians(degrees), 0.3), "G2"))
        off = max(np.abs(np.linalg.norm(grid, axis=-1) - 1).max() for grid in grids(filling))
        assert off <= 0.08 * np.radians(degrees) and filling.curvature_difference <= 0.1


def as_nurbs(side):
    return (side[0].to_nurbs(), *side[1:]) if isinstance(side, tuple) else side.to_nurbs()


def checked(sides, tolerance=None):
    """None where a sentence names a side or a place."""
    try:
        filling = build.fill(sides, tolerance=tolerance)
    except (sc.InvalidShape, sc.ToleranceNotReached) as refusal:
        assert any(word in str(refusal) for word in ("sides[", "back over itself at (")), refusal
        return None
    gap, angle = found_at([as_nurbs(side) for side in sides], filling)
    assert filling.gap >= 0.98 * gap - 1e-11 and filling.angle >= 0.98 * angle - 1e-5
    assert not folds(filling, np.random.default_rng(0))
    return filling


@pytest.mark.parametrize("word", ["G0", "G1", "G2"])
@pytest.mark.parametrize("count", [3, 4, 5])
def test_sides_of_uneven_pace_are_filled(count, word):
    """Eight times as fast at one end as at the other."""
    around = polygon_hole(count, word, 0.3)
    filling = checked([(around[0][0].to_nurbs().moebius("u", 8 ** 0.5), "v_start", word), *around[1:]])
    assert filling is not None and filling.angle <= 1e-4 and filling.inner_angle <= 1e-4
    assert off_quadric(filling) <= (0.1 if word == "G0" else 0.05)


@pytest.mark.parametrize("weight", [30, 1 / 30, 100, 1000])
@pytest.mark.parametrize("count", [3, 4, 5])
def test_weights_that_differ_much_are_followed_or_refused(count, weight):
    around = polygon_hole(count, "G1", 0.3)
    patch = around[0][0]
    weights = np.ones(patch.points.shape[:2])
    weights[1:-1] = weight
    checked([(patch.with_weights(weights), "v_start", "G1"), *around[1:]], 1e-3)
    checked([patch.with_weights(weights).boundary("v_start"), *(one.boundary(side) for one, side, _ in around[1:])], 1e-3)


@pytest.mark.parametrize("bulge", [0.5, 1.0, 2.0, 4.0])
@pytest.mark.parametrize("count", [3, 4, 5])
def test_bulging_sides_are_filled_or_refused(count, bulge):
    angles = 2 * np.pi * np.arange(count) / count
    corners = np.c_[np.cos(angles), np.sin(angles), 0 * angles]
    sides = []
    for start, end in zip(corners, np.roll(corners, -1, 0)):
        out = (start + end) / np.linalg.norm(start + end)
        sides.append(sc.BezierCurve([start, start + bulge * out, end + bulge * out, end]))
    checked(sides)


@pytest.mark.parametrize("kink", [0.01, 0.1, 0.5, 1.0])
@pytest.mark.parametrize("count", [3, 4, 5])
def test_kinks_within_a_side_are_followed_or_refused(count, kink):
    around = polygon_hole(count, "G1", 0.3)
    patch = around[0][0].to_nurbs().insert_knot("u", 0.4, 4)
    points = np.array(patch.points)
    way = points[-1, 0] - points[0, 0]
    points += 0.3 * kink * (1 - np.abs(np.linspace(-1, 1, len(points))))[:, None, None] * np.array([-way[1], way[0], 0])
    for word in ("G0", "G1"):
        checked([(patch.with_points(points), "v_start", word), *((one, side, word) for one, side, _ in around[1:])])


@pytest.mark.parametrize("lift", [0, 1e-8, 1e-7, 5e-7])
@pytest.mark.parametrize("size", [1e-6, 1, 1e6])
def test_a_twist_within_the_tolerance_is_a_fold(lift, size):
    """Two sides that cross above one another: normals turn round between them, without a place that has none, or all along a line."""
    corners = size * np.array([(0, 0, 0), (1, 1, 0), (1, 0, lift), (0, 1, lift)])
    sides = [sc.BezierCurve([a, b]) for a, b in zip(corners, np.roll(corners, -1, 0))]
    with pytest.raises(sc.InvalidShape, match="turns back over itself at"):
        build.fill(sides)
    with pytest.raises(sc.InvalidShape, match="turns back over itself at"):
        build.fill([sc.NurbsCurve(1, [0, 0, 0.5, 1, 1], [a, (a + b) / 2, b]) for a, b in zip(corners, np.roll(corners, -1, 0))])


def test_a_twist_far_wider_than_the_tolerance_is_none():
    corners = np.array([(0, 0, 0), (1, 1, 0), (1, 0, 1e-3), (0, 1, 1e-3)])
    build.fill([sc.BezierCurve([a, b]) for a, b in zip(corners, np.roll(corners, -1, 0))])


@pytest.mark.parametrize("bow", [0, 0.1, 0.3])
@pytest.mark.parametrize("weight", [1000, 300, 30, 1 / 30, 1 / 300])
@pytest.mark.parametrize("count", [1, 2, 4])
def test_four_curves_of_steep_weights_are_filled(count, weight, bow):
    corners, sides = np.array([(0, 0, 0), (1, 0, 0.1), (1, 1, 0), (0, 1, 0.2)]), []
    for start, end in zip(corners, np.roll(corners, -1, 0)):
        out = bow * np.array([(end - start)[1], (start - end)[0], 0])
        weights = [1, weight, weight, 1] if len(sides) < count else None
        sides.append(sc.BezierCurve([start, start + (end - start) / 3 + out, end - (end - start) / 3 + out, end], weights))
    assert checked(sides) is not None


def test_a_kink_of_a_neighbor_is_followed_alike_from_either_end():
    """Derivatives jump there: what leaves it is the mean of both. At the middle, where patches meet, those have no common tangent plane."""
    around = polygon_hole(5, "G2", 0.3)
    for at, most in ((0.3, 1e-6), (0.5, 2e-3), (0.726, 1e-6)):
        sides = [patch.boundary(side) for patch, side, _ in around]
        patch = around[0][0].to_nurbs()
        ends = np.array(patch.points)[[0, -1], :, :]
        kinked = np.stack([ends[0], (1 - at) * ends[0] + at * ends[1] + (0, 0, 0.05), ends[1]])
        sides[0] = (sc.NurbsPatch((1, patch.degree[1]), ([0, 0, at, 1, 1], patch.knots[1]), kinked), "v_start", "G2")
        here, there = filled(sides, 1e-3), filled(sides[::-1], 1e-3)
        assert here is not None and apart(grids(here), grids(there)) <= most
