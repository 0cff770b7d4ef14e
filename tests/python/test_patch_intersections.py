"""Where curves meet patches and planes: closed forms, places that were planted, dense samples, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from splinecore import build

SPHERE = build.sphere((0, 0, 0), 1)
TORUS = build.torus((0, 0, 0), (0, 0, 1), 3, 1)
CYLINDER = build.cylinder((0, 0, -3), (0, 0, 1), 1, 6)


def line(start, end):
    return sc.BezierCurve([start, end])


def circle(radius=1.0, z=0.0):
    corners = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], float)
    weights = np.array([1, np.sqrt(0.5)] * 4 + [1])
    return sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], np.c_[radius * corners, np.full(9, z)], weights)


def check(curve, patch, found):
    """Every place is one of both."""
    size = max(np.ptp(curve.to_nurbs().points, axis=0).max(), np.ptp(patch.points.reshape(-1, 3), axis=0).max())
    for (t, u, v), point, distance in zip(found.parameters, found.points, found.distances):
        both = np.array([curve.evaluate(t), patch.evaluate(u, v)])
        apart = np.linalg.norm(both[0] - both[1])
        assert apart <= 2.0**-32 * size
        assert distance == pytest.approx(apart, abs=1e-12 * size)
        assert point == pytest.approx(both.mean(0), abs=1e-12 * size)
    assert len(np.unique(found.parameters[:, 0])) == len(found.parameters)


def test_lines_through_a_sphere():
    rng = np.random.default_rng(1)
    for _ in range(60):
        start, end = rng.uniform(-3, 3, (2, 3))
        found = line(start, end).patch_intersections(SPHERE)
        check(line(start, end), SPHERE, found)
        way = end - start
        roots = np.roots([way @ way, 2 * start @ way, start @ start - 1])
        want = np.sort([t.real for t in roots if abs(t.imag) < 1e-12 and 0 <= t.real <= 1])
        assert found.parameters[:, 0] == pytest.approx(want, abs=1e-9)
        assert not found.touches.any() and not len(found.overlaps)


def test_lines_through_the_poles_and_along_the_seam():
    found = line((0, 0, -2), (0, 0, 2)).patch_intersections(SPHERE)
    assert found.parameters[:, 0] == pytest.approx([0.25, 0.75]) and not found.touches.any()
    found = line((-2, 0, 0.3), (2, 0, 0.3)).patch_intersections(SPHERE)
    assert found.points[:, 0] == pytest.approx([-np.sqrt(0.91), np.sqrt(0.91)])


def test_lines_that_touch():
    for angle in (0.0, 0.4, 2.0):
        out = np.array([np.cos(angle), np.sin(angle), 0.0])
        along = np.array([-np.sin(angle), np.cos(angle), 0.3])
        found = line(out - 2 * along, out + 1.5 * along).patch_intersections(SPHERE)
        assert found.touches.tolist() == [True]
        assert found.points[0] == pytest.approx(out, abs=1e-9)
        near = line(1.001 * out - 2 * along, 1.001 * out + 1.5 * along)
        assert len(near.patch_intersections(SPHERE).parameters) == 0
        assert len(near.patch_intersections(SPHERE, 0.002).parameters) == 1


def test_each_place_has_its_own_distance_and_touch():
    bend = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[-2, 1, 0], [2, 1, 0], [2, 0, 0.2]])
    ends = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[1.01, 0, 0], [5, 0, 0], [5, 5, 0]])
    found = ends.patch_intersections(SPHERE, 0.05)
    assert found.distances == pytest.approx([0.01], abs=1e-9)
    through = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], [[-2, 1, 0], [2, 1, 0], [2, 0, 0.2], [0, 0, 0.2]]).patch_intersections(SPHERE)
    assert bend.patch_intersections(SPHERE).touches.tolist() == [True] and through.touches.tolist() == [True, False]
    both = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[1.01, 0, 0], [5, 5, 0], [0, 1.03, 0]]).patch_intersections(SPHERE, 0.05)
    assert both.distances == pytest.approx([0.01, 0.03], abs=1e-9)
    assert both.distances.strides == (8,) and both.touches.strides == (1,)


def test_a_line_meets_a_torus_four_times():
    found = line((-5, 0.2, 0.1), (5, 0.3, -0.2)).patch_intersections(TORUS)
    check(line((-5, 0.2, 0.1), (5, 0.3, -0.2)), TORUS, found)
    ring = np.hypot(found.points[:, 0], found.points[:, 1])
    assert len(ring) == 4 and np.hypot(ring - 3, found.points[:, 2]) == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize("positive", [True, False])
def test_planted_places_on_patches_of_every_kind(positive):
    rng = np.random.default_rng(positive)
    met = 0
    for _ in range(60):
        patch = random_patch(rng, positive=positive)
        (u0, u1), (v0, v1) = patch.domain
        u, v = u0 + (u1 - u0) * rng.uniform(0.1, 0.9), v0 + (v1 - v0) * rng.uniform(0.1, 0.9)
        at = patch.evaluate(u, v, at_infinity="nan")
        if not np.isfinite(at).all() or np.linalg.norm(at) > 1e3:
            continue
        curve = random_curve(rng, degree=int(rng.integers(1, 6)), ends="clamped", spans=2)
        t = curve.domain[0] + 0.37 * np.diff(curve.domain)[0]
        matrix = np.eye(4)
        matrix[:3, 3] = at - curve.evaluate(t)
        through = curve.transformed(matrix)
        found = through.patch_intersections(patch)
        assert np.abs(found.points - at).max(1).min() < 1e-6
        met += len(found.parameters) > 0
    assert met > 30


def test_no_crossing_of_a_wavy_surface_is_missed():
    rng = np.random.default_rng(5)
    knots = np.r_[[0] * 4, np.arange(1, 7), [7] * 4].astype(float)
    x, y = np.meshgrid(np.linspace(0, 1, 10), np.linspace(0, 1, 10), indexing="ij")
    wavy = sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, rng.uniform(-1, 1, x.shape)], -1))
    for _ in range(20):
        y0, y1, z0, z1 = rng.uniform(0.1, 0.9, 2).tolist() + rng.uniform(-0.3, 0.3, 2).tolist()
        flat = line((0, y0, z0), (1, y1, z1))
        found = flat.patch_intersections(wavy)
        check(flat, wavy, found)
        t = np.linspace(0, 1, 400)
        p = flat.evaluate(t)
        # The surface is the graph of a height over (x, y), each a function of one parameter.
        grid = np.linspace(0, 7, 2001)
        u = np.interp(p[:, 0], wavy.evaluate(grid, 0 * grid)[:, 0], grid)
        v = np.interp(p[:, 1], wavy.evaluate(0 * grid, grid)[:, 1], grid)
        height = wavy.evaluate(u, v)[:, 2] - p[:, 2]
        assert len(found.parameters) >= np.count_nonzero(np.diff(np.sign(height)))


def test_curves_that_lie_on_patches():
    for curve, patch in ((circle(4), TORUS), (circle(np.sqrt(0.75), 0.5), SPHERE), (circle(), CYLINDER),
                         (line((1, 0, -2), (1, 0, 2)), CYLINDER)):
        found = curve.patch_intersections(patch)
        assert found.overlaps == pytest.approx(np.array([curve.domain]))
        assert len(found.parameters) == 0
    found = line((1, 0, -5), (1, 0, 2)).patch_intersections(CYLINDER)
    assert found.overlaps == pytest.approx(np.array([[2 / 7, 1]]), abs=1e-8)


def test_circles_and_planes():
    found = circle().plane_intersections((0.5, 0, 0), (1, 0, 0))
    assert np.sort(found.points[:, 1]) == pytest.approx([-np.sqrt(0.75), np.sqrt(0.75)])
    touching = circle().plane_intersections((1, 0, 0), (1, 0, 0))
    assert touching.touches.tolist() == [True] and touching.points[0] == pytest.approx([1, 0, 0], abs=1e-9)
    flat = circle().plane_intersections((3, 1, 0), (0, 0, 2))
    assert flat.overlaps.tolist() == [[0, 4]] and len(flat.parameters) == 0
    assert len(circle().plane_intersections((2, 0, 0), (1, 0, 0)).parameters) == 0
    raised = circle(z=2.0).plane_intersections((0.2, 0, 0), (1, 1, 0))
    assert raised.points[:, 2] == pytest.approx([2, 2])


@pytest.mark.parametrize("degree", [1, 2, 3, 5, 9, 25])
def test_planes_meet_curves_where_their_polynomial_is_zero(degree):
    rng = np.random.default_rng(degree)
    curve = sc.BezierCurve(rng.uniform(-1, 1, (degree + 1, 3)))
    normal, origin = rng.uniform(-1, 1, 3), curve.evaluate(0.4)
    found = curve.plane_intersections(origin, normal)
    values = (curve.evaluate(np.linspace(0, 1, 20001)) - origin) @ normal
    assert len(found.parameters) == np.count_nonzero(np.diff(np.sign(values + 1e-15)))
    assert np.abs((found.points - origin) @ normal).max() < 1e-12
    assert np.abs(found.parameters[:, 0] - 0.4).min() < 1e-10


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e5])
def test_places_stay_where_shapes_are_scaled_and_moved(scale, far):
    flat = line((-5, 0.2, 0.1), (5, 0.3, -0.2)).to_nurbs()
    near = flat.patch_intersections(TORUS)
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = far * scale
    moved = flat.transformed(matrix).patch_intersections(TORUS.transformed(matrix))
    assert moved.parameters == pytest.approx(near.parameters, abs=1e-9 if far else 1e-12)


def test_bad_calls():
    flat = line((0, 0, 0), (1, 0, 0))
    for tolerance in (-1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            flat.patch_intersections(SPHERE, tolerance)
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            flat.plane_intersections((0, 0, 0), (0, 0, 1), tolerance)
    for patch in (None, flat, [1, 2]):
        with pytest.raises(sc.InvalidShape, match="patch is .*, a patch is expected"):
            flat.patch_intersections(patch)
    for normal in ((0, 0, 0), (np.nan, 0, 1)):
        with pytest.raises(sc.InvalidShape, match="normal"):
            flat.plane_intersections((0, 0, 0), normal)
    with pytest.raises(sc.Cancelled):
        circle(4).patch_intersections(TORUS, 1e-13, cancel=lambda: True)


def test_a_patch_that_is_but_a_line():
    flat = sc.BezierPatch([[[x, x * x / 4, 0.1]] * 3 for x in range(3)])
    at = flat.evaluate(0.3, 0.7)
    through = line(at - [0.3, 0.1, 1], at + [0.6, 0.2, 2])
    found = through.patch_intersections(flat)
    assert found.points == pytest.approx(at[None], abs=1e-8) and found.parameters[0, 0] == pytest.approx(1 / 3, abs=1e-7)
    assert len(through.to_nurbs().transformed(np.diag([1, 1, 1.5, 1])).patch_intersections(flat).parameters) == 0


def test_a_curve_that_is_a_point():
    point = sc.BezierCurve([[1, 0, 0]] * 3)
    assert len(point.patch_intersections(SPHERE).parameters) == 1
    assert len(point.plane_intersections((1, 5, 5), (1, 0, 0)).parameters) == 1
    assert len(point.plane_intersections((2, 5, 5), (1, 0, 0)).parameters) == 0
    found = point.plane_intersections((1, 0, 0), (1, 0, 0))
    assert isinstance(found, sc.PatchIntersections) and "count=1" in repr(found)
