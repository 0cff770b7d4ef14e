"""Offsets of patches: exact where the house says so, dense samples elsewhere, closed sets, and what is refused."""

import numpy as np
import pytest

import splinecore as sc
from random_patches import random_patches
from splinecore import build

AXIS = (0, 0, 1)


def grid(patch, count=41):
    return np.linspace(*patch.domain[0], count), np.linspace(*patch.domain[1], count)


def off(patch, made, distance):
    """How far places of the offset are from where the normal leads to."""
    u, v = grid(patch)
    points, normals = patch.evaluate_grid_with_normals(u, v)
    want = points + distance * normals
    return np.linalg.norm(made.evaluate_grid(u, v) - want, axis=-1).max()


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
@pytest.mark.parametrize("shape", [
    lambda s: build.plane((s, 0, 0), (s, 0, 0), (0, s, 0.5 * s)),
    lambda s: build.cylinder((s, 0, 0), AXIS, s, 2 * s),
    lambda s: build.cone((s, 0, 0), AXIS, 2 * s, 3 * s, s),
    lambda s: build.sphere((s, 2 * s, 0), s),
    lambda s: build.torus((s, 0, s), AXIS, 3 * s, s),
], ids=["plane", "cylinder", "cone", "sphere", "torus"])
def test_the_usual_shapes_are_exact(shape, size):
    patch = shape(size)
    for distance in (0.3 * size, -0.2 * size):
        made, error = build.offset_patch(patch, distance)
        assert made.points.shape == patch.points.shape and np.array_equal(made.weights, patch.weights)
        assert error <= 1e-13 * size
        assert off(patch, made, distance) <= 1e-12 * size


def bumpy(seed, rational, degree=3, count=6):
    rng = np.random.default_rng(seed)
    net = np.dstack([*np.meshgrid(np.arange(float(count)), np.arange(float(count)), indexing="ij"), rng.normal(0, .3, (count, count))])
    knots = [0.0] * (degree + 1) + list(np.linspace(0, 1, count - degree + 1)[1:-1]) + [1.0] * (degree + 1)
    return sc.NurbsPatch((degree, degree), (knots, knots), net, rng.uniform(.7, 1.4, (count, count)) if rational else None)


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_others_within_the_tolerance(rational, tolerance):
    for seed in range(3):
        patch = bumpy(seed, rational)
        made, error = build.offset_patch(patch, 0.1, tolerance=tolerance)
        assert error <= tolerance
        assert off(patch, made, 0.1) <= tolerance


def test_a_closed_patch_stays_closed():
    patch = build.revolve(sc.BezierCurve([(1, 0, 0), (1.5, 0, 1), (1, 0, 2)]), (0, 0, 0), AXIS)
    made, _ = build.offset_patch(patch, 0.1, tolerance=1e-6)
    assert made.periodic[0]
    assert off(patch, made, 0.1) <= 1e-6


def test_random_patches_are_offset_or_refused(inputs):
    made, count = 0, inputs(150)
    for patch in random_patches(5, count, ends="clamped"):
        try:
            offset, error = build.offset_patch(patch, 1e-3, tolerance=1e-2)
        except (sc.InvalidShape, sc.ToleranceNotReached, sc.PointAtInfinity):
            continue
        made += 1
        assert error <= 1e-2 and np.isfinite(offset.points).all()
    assert made > 0.1 * count


@pytest.mark.parametrize("noise", [1e-16, 1e-13, 1e-10, 1e-8])
@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_a_pole_that_rounding_has_spread_is_one(noise, size):
    dome = build.sphere((0, 0, 0), 1.0).split("v", 0.5)[1]
    points = np.array(dome.points) * size
    points[:, -1] += size * noise * np.random.default_rng(2).normal(size=(len(points), 3))
    made, error = build.offset_patch(dome.with_points(points), 0.1 * size, tolerance=1e-4 * size)
    assert made.points.shape == dome.points.shape and error <= 10 * size * noise + 1e-14 * size
    at = made.evaluate_grid(*(np.linspace(*domain, 33) for domain in made.domain)) / size
    assert np.abs(np.linalg.norm(at, axis=-1) - 1.1).max() <= 10 * noise + 1e-14


def test_an_exact_pole_keeps_every_digit():
    dome = build.sphere((0.3, 0.1, 0.7), 1.3).split("v", 0.5)[1]
    shell, _ = build.thicken(dome, 0.0, 0.1)
    assert np.array_equal(shell[1].reversed("u").points, dome.points)


@pytest.mark.parametrize("axis", ["u", "v"])
def test_spread_poles_of_any_side(axis):
    """Also where the outermost knot, which decides nothing, lies elsewhere."""
    dome = build.sphere((0, 0, 0), 1.0).split("v", 0.5)[1].reversed("v")
    knots = dome.knots[1].copy()
    knots[0] -= 1
    points = dome.points.copy()
    points[:, 0] += 1e-12 * np.random.default_rng(2).normal(size=(len(points), 3))
    noisy = sc.NurbsPatch(dome.degree, (dome.knots[0], knots), points, dome.weights, periodic=(True, False))
    made, error = build.offset_patch(noisy if axis == "v" else noisy.swapped(), 0.1, tolerance=1e-4)
    assert error <= 1e-9 and made.points.shape[0] * made.points.shape[1] <= 100


def test_a_spread_pole_has_no_wall():
    dome = build.sphere((0, 0, 0), 1.0).split("v", 0.5)[1]
    points = np.array(dome.points)
    points[:, -1] += 1e-10 * np.random.default_rng(2).normal(size=(len(points), 3))
    shell, error = build.thicken(dome.with_points(points), 0.0, 0.1)
    assert len(shell) == 3 and error <= 1e-9


def test_thickness_is_closed():
    patch = bumpy(1, False)
    parts, error = build.thicken(patch, -0.05, 0.1, tolerance=1e-4)
    assert len(parts) == 6 and error <= 1e-4
    pool = sc.PatchSet.from_patches(parts)
    assert pool.volume() == pytest.approx(0.15 * patch.area(), rel=0.05)
    outer, inner = parts[0], parts[1].reversed("u")
    for side in ("u_start", "u_end", "v_start", "v_end"):
        border = outer.boundary(side).points
        assert any(np.array_equal(border, wall.points[:, -1]) or np.array_equal(border[::-1], wall.points[:, -1]) for wall in parts[2:])
        border = inner.boundary(side).points
        assert any(np.array_equal(border, wall.points[:, 0]) or np.array_equal(border[::-1], wall.points[:, 0]) for wall in parts[2:])


def test_what_closes_has_no_walls():
    assert len(build.thicken(build.sphere((0, 0, 0), 1), 0, .1).value) == 2
    assert len(build.thicken(build.torus((0, 0, 0), AXIS, 3, 1), 0, .1).value) == 2
    assert len(build.thicken(build.cylinder((0, 0, 0), AXIS, 1, 1), 0, .1).value) == 4
    shell = sc.PatchSet.from_patches(build.thicken(build.sphere((0, 0, 0), 1), 0, .1).value)
    assert shell.volume() == pytest.approx(4 / 3 * np.pi * (1.1 ** 3 - 1), rel=1e-9)


def folded():
    points = np.array([[(x, y, z) for y in (0, 1)] for x, z in ((0, 0), (1, 1), (2, 0))], float)
    return sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]), points)


@pytest.mark.parametrize("patch, distance, words", [
    (build.sphere((0, 0, 0), 1), -1.0, "radius of (1|0.99)"),
    (build.cylinder((0, 0, 0), AXIS, 1, 1), -2.0, "fold"),
    (folded(), 0.1, "crease at u = 1"),
    (build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), np.inf, "finite"),
    (sc.BezierPatch(np.zeros((2, 2, 3))), 1.0, "normal"),
])
def test_what_cannot_be_offset_is_refused(patch, distance, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.offset_patch(patch, distance)


def test_no_thickness_is_refused():
    with pytest.raises(sc.InvalidShape, match="no thickness"):
        build.thicken(build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), 0.1, 0.1)
    with pytest.raises(sc.InvalidShape, match="tolerance"):
        build.offset_patch(bumpy(0, False), 0.1, tolerance=0.0)
