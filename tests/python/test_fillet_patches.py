"""Balls that roll along the edge of two patches: cylinders and tori in closed form, contacts and planes measured, refusals."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

AXIS = (0, 0, 1)


def grid(patch, count=33):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain)).reshape(-1, 3)


def wedge(angle, length=3.0):
    """Two planes with the x axis in common: the ground, and one that rises from it by an angle."""
    ground = build.plane((0, 0, 0), (length, 0, 0), (0, 2, 0))
    wall = build.plane((0, 0, 0), (length, 0, 0), (0, 2 * np.cos(angle), 2 * np.sin(angle)))
    return ground, wall


@pytest.mark.parametrize("angle", [0.3, np.pi / 2, 2.0, 3.0])
def test_between_planes_it_is_a_cylinder(angle):
    ground, wall = wedge(angle)
    away = 0.2
    radius = away * np.tan(angle / 2)
    made = build.fillet_patches(ground, "v_start", wall, "v_start", radius)
    center = np.array([away, radius])
    points = grid(made.fillet)
    assert np.abs(np.hypot(*(points[:, 1:] - center).T) - radius).max() <= 1e-12 * max(1, radius)
    assert made.error <= 1e-12 and made.fillet.degree == (1, 2)
    assert np.abs(grid(made.first)[:, 1].min() - away) <= 1e-13
    assert made.first.degree == ground.degree and made.second.degree == wall.degree


@pytest.mark.parametrize("first", ["u_start", "u_end", "v_start", "v_end"])
@pytest.mark.parametrize("second", ["u_start", "u_end", "v_start", "v_end"])
@pytest.mark.parametrize("reversed", [False, True])
def test_any_sides_in_any_direction(first, second, reversed):
    def turned(patch, side, back):
        if side.endswith("end"):
            patch = patch.reversed("v")
        if back:
            patch = patch.reversed("u")
        return patch.swapped() if side[0] == "u" else patch

    ground, wall = wedge(np.pi / 2)
    a, b = turned(ground, first, False), turned(wall, second, reversed)
    made = build.fillet_patches(a, first, b, second, 0.25)
    for patch, side, border in ((made.first, first, "v_start"), (made.second, second, "v_end")):
        seam = sc.seam_continuity(made.fillet, border, patch, side)
        assert seam.gap <= 1e-12 and seam.angle <= 1e-9


def test_a_cylinder_on_a_plane_has_a_torus_at_its_foot():
    wall = build.cylinder((0, 0, 0), AXIS, 1.0, 2.0)
    ring = wall.boundary("v_start")
    ground = build.ruled(ring, ring.transformed(3 * np.eye(3)))
    made = build.fillet_patches(wall, "v_start", ground, "v_start", 0.3, tolerance=1e-6)
    points = grid(made.fillet, 65)
    off = np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 1.3, points[:, 2] - 0.3) - 0.3)
    assert off.max() <= 1e-6 and made.fillet.periodic[0]
    assert np.abs(grid(made.first)[:, 2].min() - 0.3) <= 1e-12
    assert np.abs(np.hypot(*grid(made.second)[:, :2].T).min() - 1.3) <= 1e-12


def bent(seed, height):
    """A patch over the ground, or beside it, with a common border."""
    rng = np.random.default_rng(seed)
    border = np.array([(k, 0, 0.2 * np.sin(k)) for k in range(4)])
    rows = [border + (np.array([0, j, 0.0]) if height == 0 else np.array([0, -0.1 * j, j])) + (rng.normal(0, 0.1, (4, 3)) if j > 1 else 0)
            for j in range(4)]
    return sc.BezierPatch(np.array(rows).transpose(1, 0, 2))


@pytest.mark.parametrize("radius", [0.3, [(0, 0.1), (0.6, 0.35), (1, 0.2)]])
@pytest.mark.parametrize("seed", range(4))
def test_it_touches_both_and_goes_on(seed, radius):
    a, b = bent(seed, 0), bent(seed + 50, 1)
    made = build.fillet_patches(a, "v_start", b, "v_start", radius, tolerance=1e-5)
    assert made.error <= 1e-5
    for side, patch in (("v_start", a), ("v_end", b)):
        edge = made.fillet.boundary(side)
        inner = edge.evaluate(np.linspace(0.1, 0.9, 41) * (edge.domain[1] - edge.domain[0]) + edge.domain[0])
        assert patch.nearest(inner).distances.max() <= 2e-5
    seam = sc.seam_continuity(made.fillet, "v_start", made.first, "v_start")
    assert seam.gap <= 1e-4 and seam.angle <= (0.02 if isinstance(radius, float) else 0.3)
    assert a.nearest(grid(made.first, 17)).distances.max() <= 1e-5 and b.nearest(grid(made.second, 17)).distances.max() <= 1e-5


@pytest.mark.parametrize("size", [1e-150, 1e150])
def test_any_size(size):
    ground, wall = (patch.transformed(size * np.eye(3)) for patch in wedge(np.pi / 2))
    made = build.fillet_patches(ground, "v_start", wall, "v_start", 0.25 * size)
    points = grid(made.fillet) / size
    assert np.abs(np.hypot(points[:, 1] - 0.25, points[:, 2] - 0.25) - 0.25).max() <= 1e-12


GROUND, WALL = wedge(np.pi / 2)


@pytest.mark.parametrize("first, second, radius, words", [
    (GROUND, WALL, 0.0, "above 0"),
    (GROUND, WALL, -1.0, "above 0"),
    (GROUND, WALL, 5.0, "too large"),
    (GROUND, WALL, [(0, 0.1), (2, 0.1)], "off the edge"),
    (GROUND, WALL.transformed(np.c_[np.eye(3), [0, 0, 1]]), 0.1, "not one edge"),
    (GROUND, build.plane((0, 0, 0), (3, 0, 0), (0, -1, 0)), 0.1, "nothing to round"),
    (build.cylinder((0, 0, 0), AXIS, 1, 1).swapped(), GROUND, 0.1, "seam"),
])
def test_what_cannot_be_rounded_is_refused(first, second, radius, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.fillet_patches(first, "v_start", second, "v_start", radius)
