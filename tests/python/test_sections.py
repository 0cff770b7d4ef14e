"""Curves that surfaces have in common: Villarceau, Viviani, cylinders, small loops, dense samples, and bad calls."""

import itertools

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SPHERE = build.sphere((0, 0, 0), 1)
TORUS = build.torus((0, 0, 0), (0, 0, 1), 3, 1)
CYLINDER = build.cylinder((0, 0, -3), (0, 0, 1), 1, 6)
TILT = np.array([1, 2, 3]) / np.sqrt(14)


def wavy(seed, count=10, height=0.2, degree=3, rational=False):
    rng = np.random.default_rng(seed)
    knots = np.r_[[0] * (degree + 1), np.arange(1, count - degree), [count - degree] * (degree + 1)].astype(float)
    x, y = np.meshgrid(np.linspace(0, 1, count), np.linspace(0, 1, count), indexing="ij")
    points = np.stack([x, y, height * rng.uniform(-1, 1, x.shape)], -1)
    weights = rng.uniform(0.5, 2, x.shape) if rational else None
    return sc.NurbsPatch((degree, degree), (knots, knots), points, weights)


def wrapped(patch, image):
    """Parameters of an image, which goes on over seams, in the domain; by a rounding beyond a border it is on that."""
    def inside(p, d):
        rest = 1e-12 * (d[1] - d[0])
        over = np.where((p < d[0] - rest) | (p > d[1] + rest), d[0] + (p - d[0]) % (d[1] - d[0]), p)
        return np.clip(over, *d)
    return tuple(inside(p, d) for p, d in zip(image[:, :2].T, patch.domain))


def check(a, b, found, tolerance, each=2000):
    """Every point lies on both surfaces, at the parameters of its images; b is a patch or a plane's origin and normal."""
    for curve, on_a, on_b, closed in zip(found.curves, found.on_a, found.on_b, found.closed):
        t = np.linspace(*curve.domain, each)
        points = curve.evaluate(t)
        assert np.array_equal(curve.knots, on_a.knots) and np.array_equal(curve.knots, on_b.knots)
        assert np.linalg.norm(a.evaluate(*wrapped(a, on_a.evaluate(t))) - points, axis=1).max() <= tolerance
        if isinstance(b, tuple):
            assert np.abs((points - b[0]) @ b[1] / np.linalg.norm(b[1])).max() <= tolerance
        else:
            assert np.linalg.norm(b.evaluate(*wrapped(b, on_b.evaluate(t))) - points, axis=1).max() <= tolerance
        ends = curve.evaluate(np.array(curve.domain))
        assert (np.linalg.norm(ends[1] - ends[0]) <= tolerance) >= closed
        assert np.diff(np.unique(curve.knots)).min() > 0


def lengths(found):
    return np.sort([curve.length(tolerance=1e-9) for curve in found.curves])


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("height", [0.0, 0.3, -0.7, 0.999])
def test_planes_cut_a_sphere_in_circles(height, tolerance):
    for normal in (TILT, np.array([0, 0, 1.0]), np.array([1.0, 0, 0.2])):
        normal = normal / np.linalg.norm(normal)
        found = SPHERE.plane_sections(height * normal, normal, tolerance)
        check(SPHERE, (height * normal, normal), found, tolerance)
        radius = np.sqrt(1 - height**2)
        assert lengths(found).sum() == pytest.approx(2 * np.pi * radius, abs=20 * tolerance / radius)
        assert len(found.curves) == 1 and found.closed.all() and not len(found.points)


def test_curves_end_at_poles():
    found = SPHERE.plane_sections((0, 0, 0), (1, 2, 0), 1e-7)
    check(SPHERE, (np.zeros(3), np.array([1, 2, 0])), found, 1e-7)
    assert lengths(found) == pytest.approx([np.pi, np.pi], abs=1e-5) and not found.closed.any()
    along_seam = SPHERE.plane_sections((0, 0, 0), (0, 1, 0), 1e-7)
    assert lengths(along_seam) == pytest.approx([np.pi, np.pi], abs=1e-5)


def test_planes_that_touch_a_sphere():
    for normal in (TILT, np.array([0, 0, 1.0]), np.array([0, 1.0, 0])):
        found = SPHERE.plane_sections(normal, normal)
        assert len(found.curves) == 0 and found.points == pytest.approx(normal[None], abs=2e-6)
        assert SPHERE.evaluate(*found.parameters[0, 0]) == pytest.approx(normal, abs=2e-6)
        assert len(SPHERE.plane_sections(1.01 * normal, normal).points) == 0


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-7])
def test_loops_as_small_as_ten_tolerances(tolerance):
    radius = 10 * tolerance
    for normal in (TILT, np.array([0.3, -1, 0.2]) / np.linalg.norm([0.3, -1, 0.2])):
        origin = np.sqrt(1 - radius**2) * normal
        found = SPHERE.plane_sections(origin, normal, tolerance)
        assert found.closed.tolist() == [True] and len(found.points) == 0
        points = found.curves[0].evaluate(np.linspace(*found.curves[0].domain, 500))
        assert np.linalg.norm(points - origin, axis=1) == pytest.approx(radius, rel=0.05)


def test_circles_of_a_torus():
    for origin, normal, want in (((0, 0, 0), (0, 0, 1), [4 * np.pi, 8 * np.pi]), ((0, 0, 0), (1, 0, 0), [2 * np.pi] * 2),
                                 ((0, 0, 0.6), (0, 0, 1), [2 * np.pi * 2.2, 2 * np.pi * 3.8])):
        found = TORUS.plane_sections(origin, normal, 1e-8)
        check(TORUS, (np.array(origin), np.array(normal)), found, 1e-8)
        assert lengths(found) == pytest.approx(want, abs=1e-5) and found.closed.all()


def test_villarceau_circles():
    """The plane that touches the torus twice cuts it in two circles of the ring's radius, here in two arcs each."""
    angle = np.arcsin(1 / 3)
    normal = np.array([-np.sin(angle), 0, np.cos(angle)])
    found = TORUS.plane_sections((0, 0, 0), normal, 1e-8)
    check(TORUS, (np.zeros(3), normal), found, 1e-8)
    assert len(found.curves) == 4 and lengths(found).sum() == pytest.approx(2 * 2 * np.pi * 3, abs=1e-4)
    for curve in found.curves:
        points = curve.evaluate(np.linspace(*curve.domain, 500))
        off = [np.abs(np.linalg.norm(points - center, axis=1) - 3).max() for center in ((0, 1, 0), (0, -1, 0))]
        assert min(off) < 1e-6


def test_viviani():
    """x² + y² = x and the unit sphere; four arcs from the poles to where both touch."""
    cylinder = build.cylinder((0.5, 0, -2), (0, 0, 1), 0.5, 4)
    for sphere in (SPHERE, build.sphere((0, 0, 0), 1, axis=(0, 1, 0.3))):
        found = sphere.sections(cylinder, 1e-8)
        check(sphere, cylinder, found, 1e-8)
        assert lengths(found).sum() == pytest.approx(7.640395578, abs=1e-4)
        for curve in found.curves:
            p = curve.evaluate(np.linspace(*curve.domain, 400))
            assert np.abs(np.hypot(p[:, 0] - 0.5, p[:, 1]) - 0.5).max() < 1e-7


@pytest.mark.parametrize("radius", [0.2, 0.6, 0.95, 0.9999])
def test_a_thinner_cylinder_through_a_cylinder(radius):
    other = build.cylinder((-3, 0, 0), (1, 0, 0), radius, 6)
    found = CYLINDER.sections(other, 1e-7)
    check(CYLINDER, other, found, 1e-7)
    assert found.closed.tolist() == [True, True] and len(found.points) == 0
    for curve in found.curves:
        p = curve.evaluate(np.linspace(*curve.domain, 500))
        assert np.abs(np.hypot(p[:, 0], p[:, 1]) - 1).max() <= 1e-7
        assert np.abs(np.hypot(p[:, 1], p[:, 2]) - radius).max() <= 1e-7
        assert np.all(p[:, 0] > 0) or np.all(p[:, 0] < 0)


def test_equal_cylinders_cross_in_two_ellipses():
    found = CYLINDER.sections(build.cylinder((-3, 0, 0), (1, 0, 0), 1, 6), 1e-7)
    assert len(found.curves) == 4
    assert lengths(found) == pytest.approx([3.820197789] * 4, abs=1e-4)
    for curve in found.curves:
        p = curve.evaluate(np.linspace(*curve.domain, 400))
        assert np.abs(np.abs(p[:, 0]) - np.abs(p[:, 2])).max() < 1e-5


def grid_crossings(a, b, lines, each=4001):
    """Where the graphs of two functions of one (x, y) cross on lines of constant u and of constant v: points (x, y)."""
    places = []
    for axis, at in itertools.product((0, 1), lines):
        along = np.linspace(*a.domain[1 - axis], each)
        pair = (np.full(each, at), along) if axis == 0 else (along, np.full(each, at))
        gap = a.evaluate(*pair)[:, 2] - b.evaluate(*pair)[:, 2]
        places.extend(a.evaluate(*pair)[np.flatnonzero(np.diff(np.sign(gap))), :2])
    return np.array(places)


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
@pytest.mark.parametrize("rational", [False, True])
def test_every_branch_of_wavy_surfaces(degree, rational):
    for seed in range(6):
        a, b = (wavy(2 * seed + k, degree=degree, rational=False) for k in range(2))
        if rational:
            weights = np.random.default_rng(seed).uniform(0.5, 2, a.points.shape[:2])
            a, b = a.with_weights(weights), b.with_weights(weights)
        found = a.sections(b, 1e-6)
        check(a, b, found, 1e-6, 500)
        places = grid_crossings(a, b, np.linspace(0.05, 0.95, 13) * a.domain[0][1])
        points = np.concatenate([curve.evaluate(np.linspace(*curve.domain, 4000)) for curve in found.curves])[:, :2]
        assert max(np.linalg.norm(points - place, axis=1).min() for place in places) < 3e-3
        # None is there twice: middles of curves are on no other one.
        for one, other in itertools.permutations(found.curves, 2):
            middle = one.evaluate(np.mean(one.domain))
            assert other.nearest(middle).distances.min() > 1e-7


def test_some_curves_are_closed_and_others_are_not():
    x, y = np.meshgrid(np.arange(12), np.arange(12), indexing="ij")
    knots = np.r_[[0] * 4, np.arange(1, 9), [9] * 4].astype(float)
    egg_box = sc.NurbsPatch((3, 3), (knots, knots),
                            np.stack([x / 11, y / 11, 0.3 * np.cos(1.2 * x) * np.cos(1.1 * y) - 0.03], -1))
    found = egg_box.plane_sections((0, 0, 0), (0, 0, 1))
    ends = [curve.evaluate(np.array(curve.domain)) for curve in found.curves]
    assert found.closed.tolist() == [bool(np.linalg.norm(end - start) < 1e-9) for start, end in ends]
    assert 0 < found.closed.sum() < len(ends) and found.closed.strides == (1,)


@pytest.mark.parametrize("seed", range(8))
def test_open_curves_end_at_borders_and_none_is_part_of_another(seed):
    a, b = wavy(2 * seed), wavy(2 * seed + 1)
    found = a.sections(b, 1e-7)
    for curve, on_a, closed in zip(found.curves, found.on_a, found.closed):
        ends = on_a.evaluate(np.array(on_a.domain))[:, :2]
        at_border = [(np.abs(end - 0) < 1e-9).any() or (np.abs(end - a.domain[0][1]) < 1e-9).any() for end in ends]
        assert closed or all(at_border)


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e4])
def test_sections_stay_where_shapes_are_scaled_and_moved(scale, far):
    near = TORUS.plane_sections((0.3, 0.2, 0.1), TILT, 1e-6)
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = far * scale
    origin = (np.array([0.3, 0.2, 0.1]) + far) * scale
    found = TORUS.transformed(matrix).plane_sections(origin, TILT, 1e-6 * scale)
    assert len(found.curves) == len(near.curves)
    points = found.curves[0].evaluate(np.linspace(*found.curves[0].domain, 300)) / scale - far
    assert near.curves[0].nearest(points).distances.max() < 1e-5


def test_a_crease_is_a_corner():
    profile = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[0, 0, 0], [1, 0, 1], [2, 0, 0]])
    roof = build.extrude(profile, (0, 2, 0))
    found = roof.plane_sections((0, 1, 0), (0.2, 1, 0))
    check(roof, (np.array([0, 1.0, 0]), np.array([0.2, 1, 0])), found, 1e-6)
    assert len(found.curves) == 1
    knots, counts = np.unique(found.curves[0].knots, return_counts=True)
    corner = found.curves[0].evaluate(knots[counts == 3])
    assert corner == pytest.approx(np.array([[1, 0.8, 1]]), abs=1e-9)


def test_surfaces_that_do_not_meet():
    assert len(SPHERE.sections(build.sphere((5, 0, 0), 1)).curves) == 0
    assert len(SPHERE.sections(build.sphere((0, 0, 0), 2)).curves) == 0
    found = SPHERE.plane_sections((0, 0, 2), (0, 0, 1))
    assert isinstance(found, sc.Sections) and "curves=0, points=0" in repr(found)


def test_every_kind_of_patch_answers():
    flat = np.array([[(i, j, i * j / 4) for j in range(3)] for i in range(3)], dtype=float)
    bezier = sc.BezierPatch(flat)
    for patch in (bezier, bezier.to_nurbs()):
        found = patch.plane_sections((0, 0, 0.3), (0, 0, 1))
        assert len(found.curves) == 1
        assert len(patch.sections(build.plane((-1, -1, 0.3), (4, 0, 0), (0, 4, 0))).curves) == 1


def test_bad_calls():
    for tolerance in (-1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            SPHERE.sections(TORUS, tolerance)
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            SPHERE.plane_sections((0, 0, 0), (0, 0, 1), tolerance)
    for other in (None, 3, SPHERE.points):
        with pytest.raises(sc.InvalidShape, match="other is .*, a patch is expected"):
            SPHERE.sections(other)
    for normal in ((0, 0, 0), (0, np.inf, 1)):
        with pytest.raises(sc.InvalidShape, match="normal"):
            SPHERE.plane_sections((0, 0, 0), normal)
    with pytest.raises(sc.Cancelled):
        SPHERE.sections(SPHERE.transformed(np.eye(4)), cancel=lambda: True)
