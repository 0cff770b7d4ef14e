"""Crossings that no look at parts may lose: tiny loops, folds, slanted lines, poles, knot lines; and random moved, scaled, reversed, refined and split, with polylines and polynomials as second judges."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, random_knots
from splinecore import build

SPHERE = build.sphere((0, 0, 0), 1)
CORNER = np.sqrt(0.5)
HALF_CIRCLE = np.array([(1, 0, 0), (1, 0, 1), (0, 0, 1), (-1, 0, 1), (-1, 0, 0)], float)


def line(*points):
    return sc.BezierCurve([[*point, 0][:3] for point in points]).to_nurbs()


def polyline(*points):
    return sc.NurbsCurve(1, np.r_[0, np.arange(len(points)), len(points) - 1], [[*point, 0][:3] for point in points])


def turned(angle):
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return matrix


def half_circle(angle=0.0):
    knots = [0, 0, 0, 1, 1, 2, 2, 2]
    return sc.NurbsCurve(2, knots, HALF_CIRCLE, [1, CORNER, 1, CORNER, 1]).transformed(turned(angle))


def looped(gap):
    """The cubic (s^3 - (gap / 2)^2 s, -s^2) of s = t - 1/2 crosses itself at parameters that are `gap` apart."""
    square = gap**2 / 4
    power = [[-0.125 + square / 2, -0.25, 0], [0.75 - square, 1, 0], [-1.5, -1, 0], [1, 0, 0]]
    return sc.PowerCurve(power).to_nurbs()


@pytest.mark.parametrize("way", [(3, 3, 0), (1, 0.3, 0), (0.1, 7, 3), (-1, 1, 1e-3), (1, 0, 0)])
def test_slanted_segments_overlap(way):
    way = np.array(way, float)
    found = line(0 * way, way).intersections(line(way / 3, 5 * way / 3))
    assert len(found.parameters) == 0 and found.reversed.tolist() == [False]
    assert found.overlaps == pytest.approx(np.array([[[1 / 3, 1], [0, 0.5]]]), abs=1e-9)
    back = line(5 * way / 3, way / 3).intersections(line(0 * way, way))
    assert back.overlaps == pytest.approx(np.array([[[0.5, 1], [1 / 3, 1]]]), abs=1e-9)
    assert back.reversed.tolist() == [True]
    end = line(0 * way, way).intersections(line(way, 2 * way))
    assert end.parameters == pytest.approx(np.array([[1, 0]])) and not len(end.overlaps)


@pytest.mark.parametrize("gap", [0.9, 0.3, 0.24, 0.1, 0.03, 0.01, 3e-3])
def test_a_loop_is_found_however_near_its_parameters_are(gap):
    curve = looped(gap)
    want = [0.5 - gap / 2, 0.5 + gap / 2]
    found = curve.self_intersections()
    assert found.parameters == pytest.approx(np.array([want]), abs=1e-9)
    assert len(curve.intersections(curve).parameters) == 2
    at = found.points[0]
    through = curve.intersections(line(at - [0.1, 0.02, 0], at + [0.2, 0.04, 0]))
    assert through.parameters[:, 0] == pytest.approx(want, abs=1e-9)


def test_the_loop_that_was_missed():
    loop = sc.BezierCurve([[0, 0, 0], [1.04, 1, 0], [-0.04, 1, 0], [1, 0, 0]])
    found = loop.self_intersections()
    assert len(found.parameters) == 1 and np.diff(found.parameters[0]) == pytest.approx(0.2379155, abs=1e-6)
    assert loop.evaluate(found.parameters[0]) == pytest.approx(np.repeat(found.points, 2, axis=0), abs=1e-12)


def test_what_folds_lies_on_itself():
    for fold in (polyline((0, 0), (1, 0.7), (0, 0)), sc.BezierCurve([[0, 0, 0], [2, 1.4, 0], [0, 0, 0]])):
        start, end = fold.domain
        middle = (start + end) / 2
        found = fold.self_intersections()
        assert found.overlaps == pytest.approx(np.array([[[start, middle], [middle, end]]]), abs=1e-7)
        assert found.reversed.tolist() == [True] and not len(found.parameters)
        on_line = fold.intersections(line((-1, -0.7), (2, 1.4)))
        assert len(on_line.overlaps) == 2 and sorted(on_line.reversed.tolist()) == [False, True]


def test_a_closed_curve_that_is_but_a_segment_crosses_each_line_twice():
    way = np.array([2 / 3, 1 / 3, 0])
    there_and_back = sc.NurbsCurve(2, [0, 1, 2], [[0, 0, 0], way], periodic=True)
    for share in (0.3, 0.5, 0.6):
        at = share * way
        for out in ([0.1, 1, 0], [1, -1, 0], [0.3, 0.2, 0.5]):
            out = np.array(out)
            for other in (line(at - out, at + out), sc.BezierCurve([at - out, at - out / 3, at + out / 3, at + out])):
                found = there_and_back.intersections(other)
                assert len(found.parameters) == 2 and np.abs(found.points - at).max() < 1e-12
    assert len(there_and_back.self_intersections().overlaps) > 0


def test_a_curve_and_itself_are_one_and_cross_at_its_double_points():
    around = np.arange(16) * np.pi / 8
    eight = sc.NurbsCurve(3, np.arange(17.0), np.c_[np.sin(around), np.sin(2 * around), np.zeros(16)], periodic=True)
    found = eight.intersections(eight)
    assert len(found.overlaps) == 1
    assert found.parameters == pytest.approx(np.array([[7, 15], [15, 7]]), abs=1e-9)


def test_a_jump_joins_nothing():
    jump = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [1.1, 0, 0], [2, 0, 0]])
    found = jump.intersections(line((0.5, 0), (1.5, 0)))
    assert found.overlaps == pytest.approx(np.array([[[0.5, 1], [0, 0.5]], [[1, 13 / 9], [0.6, 1]]]), abs=1e-9)


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 1, 1), (-0.3, 1, 0.2)])
def test_lines_through_poles_and_meridians_over_them(axis):
    for way in ((0, 0, 2), (1, 1, 2), (0.1, -1, 0.5)):
        way = np.array(way, float)
        found = line((0, 0, 1) - way, (0, 0, 1) + 0.25 * way).patch_intersections(SPHERE)
        assert np.linalg.norm(found.points - [0, 0, 1], axis=1).min() < 1e-9
        assert len(found.parameters) == 2 and not found.touches.any()
    for angle in (0.0, 0.3, np.pi / 4, np.pi / 2, 2.0):
        found = half_circle(angle).patch_intersections(SPHERE)
        assert found.overlaps == pytest.approx(np.array([[0, 2]]), abs=1e-9) and not len(found.parameters)
    cone = build.cone((0, 0, 0), axis, 1, 2)
    u, v = (np.array(domain) for domain in cone.domain)
    for share in (0.0, 0.1, 0.25, 0.7):
        generator = cone.isocurve("u", u[0] + share * np.diff(u)[0])
        if np.ptp(generator.points, axis=0).max() < 1e-9 or generator.degree > 1:
            generator = cone.isocurve("v", v[0] + share * np.diff(v)[0])
        found = generator.patch_intersections(cone)
        assert found.overlaps == pytest.approx(np.array([generator.domain]), abs=1e-9)


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_line_on_a_knot_line_is_one_piece(degree):
    knots = np.r_[[0] * (degree + 1), 0.37, 0.5, 0.81, [1] * (degree + 1)]
    count = len(knots) - degree - 1
    rng = np.random.default_rng(degree)
    patch = sc.NurbsPatch((degree, degree), (knots, knots), rng.uniform(-1, 1, (count, count, 3)))
    for axis in "uv":
        for at in (0.37, 0.6, 1.0):
            curve = patch.isocurve(axis, at)
            for same in (curve, curve.insert_knot(0.123).insert_knot(0.77), curve.reversed(), curve.elevate()):
                found = same.patch_intersections(patch)
                assert found.overlaps == pytest.approx(np.array([[0, 1]]), abs=1e-7)


def random_curve(rng, plane):
    degree = int(rng.choice([1, 2, 3, 3, 3, 4, 5, 7, 9, 12, 15]))
    ends = ENDS[rng.integers(3)]
    knots = random_knots(rng, degree, int(rng.choice([1, 2, 3, 8])), ends)
    count = len(knots) - 1 if ends == "periodic" else len(knots) - degree - 1
    points = rng.uniform(-1, 1, (count, 3))
    if rng.random() < 0.3 and count > 3:
        twice = int(rng.integers(0, count - 1))
        points[twice + 1] = points[twice]
    points[:, 2] *= not plane
    weights = 10 ** rng.uniform(-1, 1, count) if rng.random() < 0.5 else None
    return sc.NurbsCurve(degree, knots, points, weights, periodic=ends == "periodic")


def motion(rng):
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.linalg.det(turn)
    matrix[:3, 3] = rng.uniform(-3, 3, 3)
    return matrix


def refined(rng, curve):
    for u in rng.uniform(*curve.domain, 3):
        curve = curve.insert_knot(u)
    return curve


def are_same(found, other, size, matrix):
    points = found.points @ matrix[:3, :3].T + matrix[:3, 3]
    if len(points) != len(other.points) or len(found.overlaps) != len(other.overlaps):
        return False
    return all(np.linalg.norm(other.points - point, axis=1).min() < 1e-6 * size for point in points)


def ways_to_say(rng, curves):
    """The same curves otherwise, and where points then lie, and how large they are."""
    moved = motion(rng)
    yield [curve.transformed(moved) for curve in curves], moved, 1.0
    for scale in (1e-12, 1e9):
        matrix = np.diag([scale, scale, scale, 1.0])
        yield [curve.transformed(matrix) for curve in curves], matrix, scale
    for said in ([curves[0].reversed(), *curves[1:]], [refined(rng, curve) for curve in curves], curves[::-1],
                 [curves[0].elevate(), *curves[1:]]):
        yield said, np.eye(4), 1.0


def sampled(curve, each):
    """Parameters and points of a polyline on a plane curve, span after span."""
    start, end = curve.domain
    knots = np.unique(np.clip(curve.knots, start, end))
    u = [np.linspace(p, q, each) for p, q in zip(knots[:-1], knots[1:])]
    points = [np.r_[curve.evaluate(t[:-1]), curve.evaluate(t[-1:], side="left"), [[np.nan] * 3]] for t in u]
    return np.concatenate([np.r_[t, t[-1]] for t in u]), np.concatenate(points)[:, :2]


def polylines_cross(a, b, each=60):
    """Parameters at which they do, at angles that nobody doubts."""
    (u, p), (v, q) = sampled(a, each), sampled(b, each)
    r, s = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
    gap = q[None, :-1] - p[:-1, None]
    cross = r[..., 0] * s[..., 1] - r[..., 1] * s[..., 0]
    with np.errstate(all="ignore"):
        t = (gap[..., 0] * s[..., 1] - gap[..., 1] * s[..., 0]) / cross
        w = (gap[..., 0] * r[..., 1] - gap[..., 1] * r[..., 0]) / cross
        sine = np.abs(cross) / (np.linalg.norm(r, axis=-1) * np.linalg.norm(s, axis=-1))
    is_pair = (a is not b) | (u[:-1, None] < v[None, :-1])
    i, j = np.nonzero((t >= 0) & (t < 1) & (w >= 0) & (w < 1) & (sine > 0.05) & is_pair)
    return np.c_[u[i] + t[i, j] * np.diff(u)[i], v[j] + w[i, j] * np.diff(v)[j]]


def settled(a, b, place):
    """The crossing next to that of two polylines, by Newton's method; none where it leaves the curves."""
    place = np.array(place)
    for _ in range(30):
        place = np.clip(place, [a.domain[0], b.domain[0]], [a.domain[1], b.domain[1]])
        slopes = np.c_[a.derivatives(place[0], 1)[1], -b.derivatives(place[1], 1)[1]]
        step = np.linalg.lstsq(slopes, b.evaluate(place[1]) - a.evaluate(place[0]), rcond=None)[0]
        place = place + step
        if not np.abs(step).max() > 1e-15:
            break
    place = np.clip(place, [a.domain[0], b.domain[0]], [a.domain[1], b.domain[1]])
    return place if np.linalg.norm(a.evaluate(place[0]) - b.evaluate(place[1])) < 1e-13 else None


def leaves(curve, place):
    """Whether the curve is elsewhere between two of its parameters, and around them."""
    start, end = curve.domain
    low, high = sorted(place)
    at = curve.evaluate(low)
    inner = np.linalg.norm(curve.evaluate(np.linspace(low, high, 200)) - at, axis=1).max()
    if np.linalg.norm(curve.evaluate(start) - curve.evaluate(end)) < 1e-12:
        outer = np.concatenate([np.linspace(start, low, 100), np.linspace(high, end, 100)])
        inner = min(inner, np.linalg.norm(curve.evaluate(outer) - at, axis=1).max())
    return inner > 1e-8


def check_against_polylines(a, b, found, size):
    for place in polylines_cross(a, b):
        place = settled(a, b, place)
        if place is None or (a is b and not leaves(a, place)):
            continue
        if any(low - 1e-9 <= place[0] <= high + 1e-9 for low, high in found.overlaps[:, 0]):
            continue
        assert np.linalg.norm(found.points - a.evaluate(place[0]), axis=1).min(initial=np.inf) < 1e-6 * size


@pytest.mark.parametrize("plane", [True, False])
def test_two_curves_meet_at_the_same_places_however_they_are_said(plane, inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, plane, 2])
        curves = [random_curve(rng, plane) for _ in range(2)]
        size = np.ptp(np.concatenate([curve.points for curve in curves]), axis=0).max()
        found = curves[0].intersections(curves[1])
        if plane:
            check_against_polylines(*curves, found, size)
        for (a, b), matrix, scale in ways_to_say(rng, curves):
            assert are_same(found, a.intersections(b), size * scale, matrix), index


@pytest.mark.parametrize("plane", [True, False])
def test_a_curve_meets_itself_at_the_same_places_however_it_is_said(plane, inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, plane, 3])
        curve = random_curve(rng, plane)
        if len(np.unique(curve.points, axis=0)) < 3:
            continue  # there and back on one line
        size = np.ptp(curve.points, axis=0).max()
        found = curve.self_intersections()
        if plane:
            check_against_polylines(curve, curve, found, size)
        for (said,), matrix, scale in ways_to_say(rng, [curve]):
            assert are_same(found, said.self_intersections(), size * scale, matrix), index


def test_parts_of_a_curve_have_its_places(inputs):
    """Crossings of a curve are those of what it is split into; one where it is split is one of both."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 4])
        a, b = (random_curve(rng, True) for _ in range(2))
        cut = a.domain[0] + rng.uniform(0.2, 0.8) * np.diff(a.domain)[0]
        found = a.intersections(b)
        if len(found.overlaps):
            continue
        parts = [part.intersections(b) for part in a.split(cut)]
        apart = np.abs(found.parameters[:, 0] - cut) > 1e-9
        assert sum(len(part.parameters) for part in parts) - len(found.parameters) in (0, (~apart).sum())
        points = np.concatenate([part.points for part in parts])
        for point in found.points[apart]:
            assert np.linalg.norm(points - point, axis=1).min() < 1e-6


def test_lines_meet_curves_at_the_roots_of_a_polynomial(inputs):
    """A line is a linear form, which is a polynomial of a Bézier curve's parameter: its companion matrix has the roots."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 5])
        degree = int(rng.integers(1, 10))
        points = np.c_[rng.uniform(-1, 1, (degree + 1, 2)), np.zeros(degree + 1)]
        curve = sc.BezierCurve(points, 10 ** rng.uniform(-1, 1, degree + 1) if index % 2 else None)
        angle, away = rng.uniform(0, np.pi), rng.uniform(-0.5, 0.5)
        normal = np.array([np.cos(angle), np.sin(angle), 0])
        along = 40 * np.array([-normal[1], normal[0], 0])
        weights = np.ones(degree + 1) if curve.weights is None else np.asarray(curve.weights)
        values = weights * (points @ normal - away)
        power = np.polynomial.polynomial.Polynomial([0])
        t = np.polynomial.polynomial.Polynomial([0, 1])
        choose = 1.0
        for i, value in enumerate(values):
            power = power + value * choose * t**i * (1 - t) ** (degree - i)
            choose = choose * (degree - i) / (i + 1)
        roots = power.roots()
        real = np.sort(roots[(np.abs(roots.imag) < 1e-9) & (roots.real >= 0) & (roots.real <= 1)].real)
        if (np.abs(roots.imag) < 1e-4).sum() != len(roots[np.abs(roots.imag) < 1e-9]) or (np.diff(real) < 1e-3).any():
            continue  # nearly double ones
        found = curve.intersections(line(away * normal - along, away * normal + along))
        assert found.parameters[:, 0] == pytest.approx(real, abs=1e-7)


def random_patch(rng):
    kind = rng.integers(6)
    where, way = rng.uniform(-0.3, 0.3, 3), rng.normal(size=3)
    if kind == 0:
        return build.sphere(where, rng.uniform(0.3, 1))
    if kind == 1:
        return build.torus(where, way, rng.uniform(0.5, 1), rng.uniform(0.1, 0.4))
    if kind == 2:
        return build.cone(where, way, rng.uniform(0.2, 1), rng.uniform(0.5, 2))
    degrees = rng.integers(1, 4, 2).tolist()
    knots = [random_knots(rng, degree, int(rng.choice([1, 2])), "clamped") for degree in degrees]
    count = [len(k) - d - 1 for k, d in zip(knots, degrees)]
    points = rng.uniform(-1, 1, (*count, 3))
    if kind == 3:
        points[:, 0] = points[0, 0]
    return sc.NurbsPatch(degrees, knots, points, 2 ** rng.uniform(-1, 1, count) if kind == 4 else None)


def test_curves_pierce_patches_at_the_same_places_however_they_are_said(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 6])
        patch = random_patch(rng)
        ends = [[*domain, rng.uniform(*domain)] for domain in patch.domain]
        at = patch.evaluate(rng.choice(ends[0]), rng.choice(ends[1]))
        way = rng.normal(size=3)
        curve = line(at - way, at + 0.7 * way) if index % 2 else random_curve(rng, False)
        size = np.ptp(np.r_[curve.points, patch.points.reshape(-1, 3)], axis=0).max()
        found = curve.patch_intersections(patch)
        if index % 2 and not len(found.overlaps):
            assert np.linalg.norm(found.points - at, axis=1).min(initial=np.inf) < 1e-6 * size
        for (said,), matrix, scale in ways_to_say(rng, [curve]):
            other = said.patch_intersections(patch.transformed(matrix))
            assert are_same(found, other, size * scale, matrix), index
