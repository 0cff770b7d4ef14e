"""No branch of a section is missed: contours of waves against marching squares, strips of every shape against the closed
form, random patches said in other ways, and surfaces that touch more closely at some points of a curve."""

import numpy as np
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import splinecore as sc
from given_otherwise import sections_otherwise
from splinecore import build, fit


def wave(spans):
    """A bicubic through samples of cos 3u cos 2v over [-3, 3]²."""
    x, y = np.meshgrid(*[np.linspace(-3, 3, spans + 3)] * 2, indexing="ij")
    return fit.interpolate_patch(np.stack([x, y, np.cos(3 * x) * np.cos(2 * y)], -1)).value


def grid(patch, count):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def contour_length(points, height):
    """Of the level lines of triangles (marching squares)."""
    total = 0.0
    corners = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    for picked in ((0, 1, 2), (0, 2, 3)):
        triangles = np.stack([corners[k] for k in picked], -2).reshape(-1, 3, 3)
        z = triangles[..., 2] - height
        above = z > 0
        cut = above.any(1) & ~above.all(1)
        triangles, z, above = triangles[cut], z[cut], above[cut]
        ends = np.zeros((len(z), 2, 3))
        found = np.zeros(len(z), int)
        for i, j in ((0, 1), (1, 2), (2, 0)):
            crosses = np.flatnonzero(above[:, i] != above[:, j])
            share = (z[crosses, i] / (z[crosses, i] - z[crosses, j]))[:, None]
            ends[crosses, found[crosses]] = triangles[crosses, i] * (1 - share) + triangles[crosses, j] * share
            found[crosses] += 1
        total += np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()
    return total


def total_length(found):
    return sum(curve.length(tolerance=1e-7) for curve in found.curves)


@pytest.mark.parametrize("spans", [5, 12, 30, 58, 118, 200])
def test_contours_of_waves(spans):
    patch = wave(spans)
    points = grid(patch, 1200)
    for height in np.linspace(-1.03, 1.07, 12):
        found = patch.plane_sections((0, 0, height), (0, 0, 1))
        assert total_length(found) == pytest.approx(contour_length(points, height), rel=2e-3, abs=2e-3)
        assert not found.are_one


def test_the_named_wave():
    patch = wave(58)
    for height, count, length in ((0.5, 17, 31.36), (0.2, 17, 43.95)):
        found = patch.plane_sections((0, 0, height), (0, 0, 1))
        with_patch = patch.sections(build.plane((-10, -10, height), (20, 0, 0), (0, 20, 0)))
        for sections in (found, with_patch):
            assert len(sections.curves) == count
            assert total_length(sections) == pytest.approx(length, abs=0.01)


def missed_roots(patch, found, distance_to_other, lines=41, each=2000):
    """Of places where lines of constant u and v cross the other surface those that no curve is near."""
    (u0, u1), (v0, v1) = patch.domain
    across, along = np.linspace(0, 1, lines)[1:-1], np.linspace(0, 1, each)
    roots = []
    for points in (patch.evaluate_grid(u0 + (u1 - u0) * along, v0 + (v1 - v0) * across),
                   patch.evaluate_grid(u0 + (u1 - u0) * across, v0 + (v1 - v0) * along).transpose(1, 0, 2)):
        far = distance_to_other(points)
        i, j = np.nonzero(np.diff(np.sign(far), axis=0))
        share = (far[i, j] / (far[i, j] - far[i + 1, j]))[:, None]
        roots.append(points[i, j] * (1 - share) + points[i + 1, j] * share)
    roots = np.concatenate(roots)
    if not len(roots):
        return roots
    on_curves = [curve.evaluate(np.linspace(*curve.domain, 8000)) for curve in found.curves] or [np.full((1, 3), 1e9)]
    return roots[cKDTree(np.concatenate(on_curves)).query(roots)[0] > 0.01]


@pytest.mark.parametrize("spans", [6, 18, 58, 118])
def test_tubes_and_balls_through_waves(spans):
    rng = np.random.default_rng(spans)
    patch = wave(spans)
    for k in range(6):
        radius = 10**rng.uniform(-0.3, 1.3)
        center = np.array([*rng.uniform(-2, 2, 2), radius * rng.choice([-1, 1]) + rng.uniform(-0.8, 0.8)])
        if k % 2:
            other = build.sphere(center, radius)
            far = lambda points: np.linalg.norm(points - center, axis=-1) - radius
        else:
            axis = rng.normal(size=3)
            axis /= np.linalg.norm(axis)
            other = build.cylinder(center - 60 * axis, axis, radius, 120)
            far = lambda points: np.linalg.norm(np.cross(points - center, axis), axis=-1) - radius
        found = patch.sections(other)
        assert not len(missed_roots(patch, found, far))
        for one, curve in enumerate(found.curves):
            middle = curve.evaluate(np.mean(curve.domain))
            assert all(other.nearest(middle).distances > 1e-6 for k, other in enumerate(found.curves) if k != one)


def test_a_tube_over_many_spans():
    found = wave(118).sections(build.cylinder((0, -20, -14.5), (0, 1, 0), 15, 40))
    assert len(found.curves) == 17


def parallelogram(corner, e, f):
    return sc.BezierPatch([[corner, corner + f], [corner + e, corner + e + f]])


def common_length(one, other):
    """Of two parallelograms, each a corner and two edges, the length of the segment that they share."""
    normals = [np.cross(e, f) for _, e, f in (one, other)]
    way = np.cross(*normals)
    through = np.linalg.solve(np.array([*normals, way]),
                              [normals[0] @ one[0], normals[1] @ other[0], way @ (one[0] + other[0]) / 2])
    low, high = -np.inf, np.inf
    for corner, e, f in (one, other):
        edges = np.stack([e, f], 1)
        at, slope = (np.linalg.lstsq(edges, v, rcond=None)[0] for v in (through - corner, way))
        with np.errstate(divide="ignore"):
            ends = np.sort([-at / slope, (1 - at) / slope], axis=0)
        low, high = max(low, ends[0].max()), min(high, ends[1].min())
    return max(0.0, high - low) * np.linalg.norm(way)


def test_the_named_strips():
    a = sc.BezierPatch([[(0, 0, 0), (315, 0, 0)], [(0, 0, 225), (315, 0, 225)]])
    b = sc.BezierPatch([[(290, -14.4, 29.5), (252, 51.5, 52.8)], [(322, 7.9, 18.7), (283.5, 73.9, 42.0)]])
    for one, other in ((a, b), (b, a)):
        found = one.sections(other)
        assert [curve.length() for curve in found.curves] == pytest.approx([31.38], abs=0.01)


def test_strips_of_every_shape(inputs):
    rng = np.random.default_rng(1)

    def strip():
        e = rng.normal(size=3)
        f = np.cross(e, rng.normal(size=3))
        e *= 10**rng.uniform(-1, 2) / np.linalg.norm(e)
        f *= 10**rng.uniform(-2, 1) / np.linalg.norm(f)
        return rng.normal(size=3) - e / 2 - f / 2, e, f

    for _ in range(inputs(2000)):
        one, other = strip(), strip()
        found = parallelogram(*one).sections(parallelogram(*other))
        size = max(np.linalg.norm(edge) for edge in (*one[1:], *other[1:]))
        assert total_length(found) == pytest.approx(common_length(one, other), abs=1e-5 * size)
        assert len(found.curves) <= 1


def wild_patch(rng):
    degrees = rng.integers(1, 6, 2)
    counts = degrees + 1 + rng.integers(0, 6, 2)
    knots = [np.r_[[0.0] * (p + 1), np.sort(rng.uniform(0, 1, n - p - 1))**rng.choice([1, 3]), [1.0] * (p + 1)]
             for p, n in zip(degrees, counts)]
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in counts), indexing="ij")
    points = np.stack([x * 10**rng.uniform(-1, 0.5), y * 10**rng.uniform(-1, 0.5),
                       rng.normal(size=x.shape) * 10**rng.uniform(-1.5, 0.3)], -1)
    points += 0.15 * rng.integers(2) * rng.normal(size=points.shape)
    turn = Rotation.from_quat(rng.normal(size=4)).as_matrix()
    weights = np.exp(0.7 * rng.normal(size=x.shape)) if rng.integers(2) else None
    return sc.NurbsPatch([int(p) for p in degrees], knots, points @ turn.T + 0.2 * rng.normal(size=3), weights)


def test_sections_are_the_same_however_patches_are_given(inputs):
    rng = np.random.default_rng(7)
    for _ in range(inputs(400)):
        a, b = wild_patch(rng), wild_patch(rng)
        found = a.sections(b, 1e-6)
        length = total_length(found)
        for other, unit in sections_otherwise(rng, a, b, 1e-6, far=5, magnitudes=9, cuts=3):
            assert len(other.curves) == len(found.curves) and len(other.points) == len(found.points)
            lengths = sum(curve.length(tolerance=1e-7 * unit) for curve in other.curves) / unit
            assert lengths == pytest.approx(length, abs=1e-4 * max(1, length))


def short_span_patch(rng):
    """Its first span along u is up to a billion times as short as the next one."""
    degrees = [int(p) for p in rng.integers(2, 5, 2)]
    inner = np.r_[10**rng.uniform(-9, -3), rng.uniform(0.2, 0.8, rng.integers(0, 2))]
    knots = [np.r_[[0.0] * (p + 1), cuts, [1.0] * (p + 1)] for p, cuts in zip(degrees, (inner, []))]
    x, y = np.meshgrid(*(np.linspace(-1, 1, len(k) - p - 1) for k, p in zip(knots, degrees)), indexing="ij")
    points = np.stack([x, y, 0.5 * rng.normal(size=x.shape)], -1)
    turn = Rotation.from_quat(rng.normal(size=4)).as_matrix()
    return sc.NurbsPatch(degrees, knots, points @ turn.T + 0.2 * rng.normal(size=3))


def ends_inside(found):
    """Of open curves of patches over the unit square, that end in no border."""
    ends = [np.r_[on_a.evaluate(t)[:2], on_b.evaluate(t)[:2]]
            for curve, on_a, on_b, closed in zip(found.curves, found.on_a, found.on_b, found.closed) if not closed
            for t in curve.domain]
    return [end for end in ends if ((end > 1e-11) & (end < 1 - 1e-11)).all()]


def test_curves_go_on_through_short_spans(inputs):
    rng = np.random.default_rng(2)
    for _ in range(inputs(2000)):
        a, b = short_span_patch(rng), short_span_patch(rng)
        found = a.sections(b, 1e-6)
        others = b.sections(a, 1e-6), a.reversed("u").sections(b.swapped(), 1e-6)
        assert not ends_inside(found) and not ends_inside(others[0])
        for other in others:
            assert len(other.curves) == len(found.curves)
            assert total_length(other) == pytest.approx(total_length(found), abs=1e-3)


@pytest.mark.parametrize("heights, corners, count, length", [
    ([[-1, 3, 5], [7, -5, 2], [6, -5, -3], [6, 2, 0]], (2, 0, 5, 3), 2, 4.547984),
    ([[-8, 3, -4], [-5, 3, 5], [7, -5, 7], [6, -4, -8]], (3, 4, 0, -4), 2, 4.810026),
    ([[-7, -2, 5], [-3, -9, 4], [5, -6, 1], [-2, 0, -9]], (1, -3, 1, -1), 2, 3.408472),
    ([[4, -4, 3], [7, 6, -7], [9, 4, 4], [-6, 8, -2]], (5, -3, -4, 4), 3, 5.052872)])
def test_a_short_span_has_no_curve_twice(heights, corners, count, length):
    x, y = np.meshgrid(np.arange(4.0), np.arange(3.0), indexing="ij")
    points = np.stack([x, y, np.array(heights) / 10], -1)
    a = sc.NurbsPatch((2, 2), ([0, 0, 0, 1e-6, 1, 1, 1], [0, 0, 0, 1, 1, 1]), points)
    h = np.array(corners) / 10
    b = sc.BezierPatch([[(-1, -1, h[0]), (-1, 3, h[1])], [(4, -1, h[2]), (4, 3, h[3])]])
    for found in (a.sections(b, 1e-6), b.sections(a, 1e-6), a.reversed("u").sections(b.swapped(), 1e-6)):
        assert len(found.curves) == count and total_length(found) == pytest.approx(length, abs=1e-4)


def terrain(seed, kind):
    """Whole heights."""
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0), indexing="ij")
    points = np.stack([x, y, np.random.default_rng(seed).integers(0, 6, x.shape)], -1)
    if kind == "interpolated":
        return fit.interpolate_patch(points).value
    degree = {"bilinear": 1, "quadratic": 2, "cubic": 3}[kind]
    knots = np.r_[[0.0] * (degree + 1), np.arange(1.0, 12 - degree), [12.0 - degree] * (degree + 1)]
    return sc.NurbsPatch((degree, degree), (knots, knots), points)


@pytest.mark.parametrize("kind", ["interpolated", "bilinear", "quadratic", "cubic"])
def test_contours_at_the_heights_of_points(kind, inputs):
    """Through saddles, peaks, level edges and level faces."""
    for seed in range(inputs(24)):
        patch = terrain(seed, kind)
        points = grid(patch, 500)
        for height in range(6):
            found = patch.plane_sections((0, 0, height), (0, 0, 1))
            least = min(contour_length(points, height - 1e-4), contour_length(points, height + 1e-4))
            assert total_length(found) > 0.99 * least - 0.05
            for curve, on_a in zip(found.curves, found.on_a):
                t = np.linspace(*curve.domain, 200)
                u, v = (np.clip(on_a.evaluate(t)[:, k], *patch.domain[k]) for k in range(2))
                assert np.abs(patch.evaluate(u, v)[:, 2] - height).max() < 1e-4


@pytest.mark.parametrize("turn", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("sweep", [np.pi / 2, -np.pi / 2])
def test_a_tube_that_goes_on_as_a_bend_has_one_circle_with_it(turn, sweep):
    """Along the circle they touch, more closely at the two points where the bend does not curve; a bend that goes back
    crosses the tube as well."""
    tube = build.cylinder((0, 0, 0), (0, 0, 1), 1, 6)
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    for one, rim in ((tube, tube.transformed(matrix)), (tube.transformed(matrix), tube)):
        bend = build.revolve(rim.boundary("v_end"), (4, 0, 6), (0, 1, 0), sweep=sweep)
        found = one.sections(bend)
        touching = [curve for curve, kind in zip(found.curves, found.kinds) if kind == "touching"]
        assert [curve.length() for curve in touching] == pytest.approx([2 * np.pi], abs=1e-4)
        assert found.kinds == ("crossing",) * (sweep < 0) + ("touching",) and not found.are_one
        assert found.closed[-1] and not len(found.points)


@pytest.mark.parametrize("depth", [1e-2, 1e-4, 1e-6])
def test_what_goes_in_a_little_crosses_twice(depth):
    tube = build.cylinder((0, 0, 0), (0, 0, 1), 1, 6)
    beside = tube.sections(build.cylinder((2 - depth, 0, 1), (0, 0, 1), 1, 4), depth / 100)
    plane = tube.plane_sections((1 - depth, 0, 0), (1, 0, 0), depth / 100)
    for found, length in ((beside, 4), (plane, 6)):
        assert found.kinds == ("crossing", "crossing")
        assert [curve.length() for curve in found.curves] == pytest.approx([length] * 2, abs=1e-6)


def bowl(middle, radii):
    """The graph of ((x - a) / r)² + ((y - b) / s)² over the unit square."""
    squares = [np.array([c * c, c * c - c, 1 - 2 * c + c * c]) / r**2 for c, r in zip(middle, radii)]
    x = np.array([0.0, 0.5, 1.0])
    points = np.stack([*np.meshgrid(x, x, indexing="ij"), squares[0][:, None] + squares[1]], -1)
    return sc.NurbsPatch((2, 2), ([0, 0, 0, 1, 1, 1],) * 2, points)


def around_ellipse(radii):
    t = np.linspace(0, 2 * np.pi, 20001)
    return np.linalg.norm(np.diff(np.c_[radii[0] * np.cos(t), radii[1] * np.sin(t)], axis=0), axis=1).sum()


@pytest.mark.parametrize("as_patch", [False, True])
def test_loops_that_touch_knot_lines_are_gone_round_once(inputs, as_patch):
    """Of one to four knot lines, from within, through them or beside them by less than the tolerance and by more."""
    rng = np.random.default_rng(20261129)
    beside = [0, 0] + [sign * 10.0**power for power in (-16, -12, -9, -6, -3) for sign in (1, -1)]
    plane = sc.BezierPatch([[(-1, -1, 1), (-1, 2, 1)], [(2, -1, 1), (2, 2, 1)]])
    for index in range(inputs(1000)):
        middle, radii = rng.uniform(0.4, 0.6, 2), rng.uniform(0.05, 0.35, 2)
        patch = bowl(middle, radii)
        sides = [("uv"[axis], middle[axis] + sign * radii[axis]) for axis in (0, 1) for sign in (-1, 1)]
        for k in rng.permutation(4)[: int(rng.integers(1, 5))]:
            axis, at = sides[k]
            patch = patch.insert_knot(axis, at + rng.choice(beside))
        found = patch.sections(plane) if as_patch else patch.plane_sections((0, 0, 1), (0, 0, 1))
        assert len(found.curves) == 1 and not len(found.points), index
        assert found.curves[0].length() == pytest.approx(around_ellipse(radii), rel=3e-5), index
