"""Where two shapes are nearest: closed forms, nothing nearer on dense samples, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from splinecore import build

SPHERE = build.sphere((0, 0, 0), 1)
FLAT = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])


def places(shape, count):
    if np.ndim(shape.domain) == 1:
        return shape.evaluate(np.linspace(*shape.domain, count**2))
    return shape.evaluate_grid(*(np.linspace(*domain, count) for domain in shape.domain)).reshape(-1, 3)


def at(shape, parameters):
    return shape.evaluate(*parameters) if isinstance(parameters, tuple) else shape.evaluate(parameters)


def check(a, b, tolerance=None):
    """The distance of both points, which lie on both shapes; no samples are nearer; seen from b it is the same."""
    found = a.least_distance(b, tolerance)
    size = max(np.abs(places(one, 5)).max() for one in (a, b))
    for shape, parameters, point in zip((a, b), found.parameters, found.points):
        assert np.linalg.norm(at(shape, parameters) - point) <= 1e-12 * size
    assert np.linalg.norm(found.points[0] - found.points[1]) == pytest.approx(found.distance, abs=1e-14 * size)
    samples = np.array([a.nearest(places(b, 12)).distances.min(), b.nearest(places(a, 12)).distances.min()])
    allowed = 2.0**-32 * size if tolerance is None else tolerance
    assert np.all(samples >= found.distance - allowed)
    assert abs(b.least_distance(a, tolerance).distance - found.distance) <= 2 * allowed
    return found.distance


def test_spheres_lines_and_planes():
    for center, radius in (((3, 1, 0.5), 0.7), ((0, 0, 2.5), 1), ((0.1, 0, 0), 3)):
        other, apart = build.sphere(center, radius), np.linalg.norm(center)
        assert check(SPHERE, other) == pytest.approx(max(apart - 1 - radius, radius - 1 - apart), abs=1e-9)
    assert check(SPHERE, build.sphere((1.5, 0, 0), 1)) <= 1e-9
    line = sc.BezierCurve([(-5, 0, 2), (5, 1, 2)])
    assert check(line, SPHERE) == pytest.approx(np.hypot(2, 5 / np.sqrt(101)) - 1, abs=1e-9)
    assert check(line, sc.BezierCurve([(-5, 0, 2), (-5, 3, 4)])) == 0
    assert check(line, sc.BezierCurve([(0, -5, 0), (0, 5, 0)])) == pytest.approx(2, abs=1e-12)
    assert check(FLAT, FLAT.translated((0.3, 0.2, 1))) == 1
    assert check(FLAT, FLAT.translated((3, 0.2, 0))) == pytest.approx(2)
    assert check(FLAT, FLAT.translated((4, 5, 0))) == pytest.approx(5)


def test_of_wild_shapes_no_samples_are_nearer(inputs):
    """Few that meet in much are refused."""
    apart, refused, count = 0, 0, inputs(60)
    for seed in range(count):
        rng = np.random.default_rng([1, seed])
        shapes = [random_curve(rng) if kind else random_patch(rng) for kind in (seed % 3 > 0, seed % 3 > 1)]
        size = max(np.abs(places(one, 5)).max() for one in shapes)
        shapes[1] = shapes[1].translated(rng.normal(size=3) * size * rng.choice([0, 1, 3]))
        try:
            apart += check(*shapes) > 0
        except sc.InvalidShape as error:
            assert "as near all along" in str(error)
            refused += 1
    assert apart > count / 4 and refused <= 0.1 * count


def test_shapes_that_meet_are_at_no_distance(inputs):
    for seed in range(inputs(40)):
        rng = np.random.default_rng([2, seed])
        patch = random_patch(rng)
        u, v = (rng.uniform(*domain) for domain in patch.domain)
        aim, way = patch.evaluate(u, v), rng.normal(size=3)
        size = np.abs(patch.points).max()
        assert sc.BezierCurve([aim - way * size, aim + 2 * way * size]).least_distance(patch).distance <= 2.0**-30 * size


def test_where_shapes_are_as_near_all_along_a_tolerance_is_asked_for():
    around = build.sphere((0, 0, 0), 2)
    with pytest.raises(sc.InvalidShape, match="as near all along"):
        SPHERE.least_distance(around)
    assert SPHERE.least_distance(around, 1e-2).distance == pytest.approx(1, abs=1e-2)


@pytest.mark.parametrize("scale", [1e-140, 1e-6, 1e6, 1e140])
def test_sizes_change_nothing(scale):
    a, b = SPHERE.scaled(scale), build.sphere((3, 1, 0.5), 0.7).scaled(scale)
    assert a.least_distance(b).distance == pytest.approx(scale * (np.sqrt(10.25) - 1.7), rel=1e-9)


def test_bad_calls_say_what_is_wrong():
    for other in (3, None, "sphere"):
        with pytest.raises((sc.InvalidShape, TypeError)):
            SPHERE.least_distance(other)
        with pytest.raises((sc.InvalidShape, TypeError)):
            sc.BezierCurve([(0, 0), (1, 1)]).least_distance(other)
    with pytest.raises(sc.InvalidShape):
        SPHERE.least_distance(FLAT, -1)
    with pytest.raises(sc.Cancelled):
        SPHERE.least_distance(build.sphere((0, 0, 0), 2), cancel=lambda: True)
