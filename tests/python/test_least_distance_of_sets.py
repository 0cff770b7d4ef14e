"""Where sets of patches are nearest to shapes and to each other: every pair one by one, closed forms, and which patches."""

import pickle

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from splinecore import build


def ball(center, radius, pieces=True):
    """A sphere as a set of patches."""
    sphere = build.sphere(center, radius)
    return sc.PatchSet.from_patches([one for row in sphere.to_bezier() for one in row] if pieces else [sphere])


def members(shape):
    return list(shape) if isinstance(shape, sc.PatchSet) else [shape]


def at(shape, parameters, side="right"):
    """Of a shape with a jump there, before or behind it."""
    return shape.evaluate(*(parameters if isinstance(parameters, tuple) else (parameters,)), side=side)


def size_of(shape):
    return max(np.abs(at(one, tuple(np.meshgrid(*(np.linspace(*d, 5) for d in one.domain))) if np.ndim(one.domain) == 2
                         else np.linspace(*one.domain, 25))).max() for one in members(shape))


def check(a, b, tolerance):
    """Both points lie where they are said to, as far from each other as said, and no pair of members is nearer."""
    found = a.least_distance(b, tolerance)
    size = max(size_of(a), size_of(b))
    for shape, patch, parameters, point in zip((a, b), found.patches, found.parameters, found.points):
        assert (patch is None) == (not isinstance(shape, sc.PatchSet))
        member = shape if patch is None else shape[patch]
        assert min(np.linalg.norm(at(member, parameters, side) - point) for side in ("left", "right")) <= 1e-12 * size
    assert np.linalg.norm(found.points[0] - found.points[1]) == pytest.approx(found.distance, abs=1e-14 * size)
    least = min(one.least_distance(other, tolerance).distance for one in members(a) for other in members(b))
    assert abs(found.distance - least) <= tolerance
    turned = b.least_distance(a, tolerance)
    assert abs(turned.distance - least) <= tolerance
    return found.distance


@pytest.mark.parametrize("pieces", [True, False])
def test_balls_apart_touching_crossing_and_within(pieces):
    one = ball((0, 0, 0), 1, pieces)
    for center, radius in (((3, 1, 0.5), 0.7), ((0, 0, 2.5), 1), ((-4, 5, 6), 2)):
        found = one.least_distance(ball(center, radius, pieces))
        assert found.distance == pytest.approx(np.linalg.norm(center) - 1 - radius, abs=1e-9)
    assert one.least_distance(ball((1, 0, 0), 3, pieces), 1e-3).distance == pytest.approx(1, abs=1e-3)
    assert one.least_distance(ball((2, 0, 0), 1, pieces), 1e-6).distance <= 1e-6, "they touch"
    assert one.least_distance(ball((1.2, 0.3, 0), 1, pieces)).distance <= 1e-9, "they cross"
    assert one.least_distance(one).distance == 0


def test_lines_and_planes_beside_a_ball():
    one = ball((0, 0, 0), 1)
    line = sc.BezierCurve([(-5, 0, 2), (5, 1, 2)])
    exact = np.hypot(2, 5 / np.sqrt(101)) - 1
    found = line.least_distance(one)
    assert found.distance == pytest.approx(exact, abs=1e-9) and found.patches[0] is None and found.patches[1] in range(len(one))
    assert one.least_distance(line).patches[::-1] == found.patches
    flat = build.plane((-2, -2, -3), (4, 0, 0), (0, 4, 0))
    found = one.least_distance(flat)
    assert found.distance == pytest.approx(2, abs=1e-9) and found.patches[1] is None
    assert found.points == pytest.approx(np.array([(0, 0, -1), (0, 0, -3)]), abs=1e-4)
    assert flat.least_distance(one).distance == pytest.approx(2, abs=1e-9)
    same = pickle.loads(pickle.dumps(found))
    assert same.patches == found.patches and same.distance == found.distance


def test_the_nearest_of_many_patches_is_named():
    steps = [build.plane((3 * i, 0, abs(i - 3) + 1), (1, 0, 0), (0, 1, 0)) for i in range(8)]
    stairs = sc.PatchSet.from_patches(steps)
    floor = sc.PatchSet.from_patches([build.plane((3 * i, 0, 0), (3, 0, 0), (0, 1, 0)) for i in range(8)])
    found = stairs.least_distance(floor)
    assert found.distance == 1 and found.patches[0] == 3 and found.patches[1] in (2, 3), "the floor has a joint below"


def test_of_wild_sets_no_pair_is_nearer(inputs):
    """Few that meet in much are refused."""
    apart, refused, count = 0, 0, inputs(40)
    for seed in range(count):
        rng = np.random.default_rng([3, seed])
        one = sc.PatchSet.from_patches([random_patch(rng).translated(rng.normal(size=3)) for _ in range(rng.integers(1, 4))])
        kind = seed % 3
        other = random_curve(rng) if kind == 0 else random_patch(rng) if kind == 1 else sc.PatchSet.from_patches(
            [random_patch(rng).translated(rng.normal(size=3)) for _ in range(rng.integers(1, 4))])
        size = max(size_of(one), size_of(other))
        other = other.translated(rng.normal(size=3) * size * rng.choice([0, 1, 3]))
        try:
            apart += check(one, other, 1e-6 * size) > 0
        except sc.InvalidShape as error:
            assert "as near all along" in str(error)
            refused += 1
    assert apart > count / 4 and refused <= 0.1 * count


def test_many_balls_above_many():
    balls = sc.PatchSet.from_patches([build.sphere((x, y, 0), 0.4) for x in range(4) for y in range(4)])
    found = balls.least_distance(balls.translated((0, 0, 3)), 1e-4)
    assert found.distance == pytest.approx(2.2, abs=1e-4)


def test_bad_calls_say_what_is_wrong():
    one = ball((0, 0, 0), 1)
    for other in (3, None, "sphere", [one]):
        with pytest.raises((sc.InvalidShape, TypeError)):
            one.least_distance(other)
    with pytest.raises(sc.InvalidShape):
        one.least_distance(one, -1)
    with pytest.raises(sc.Cancelled):
        one.least_distance(ball((0, 0, 0), 2), cancel=lambda: True)
