"""Curves that fold, go round twice, share pieces or wind in spirals, and what touches poles: the same however it is said."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_nothing_is_missed import line, looped, motion, polyline

SPHERE = build.sphere((0, 0, 0), 1)


def clamped(degree, spans):
    return np.r_[[0] * degree, np.arange(spans + 1), [spans] * degree].astype(float)


def circle():
    corner = np.sqrt(0.5)
    net = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    return sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], np.c_[net, np.zeros(9)], [1, corner] * 4 + [1])


def is_in(interval, u, domain):
    """On a closed curve the end may be a turn further."""
    margin = 2e-3 * (domain[1] - domain[0])
    return any(interval[0] - margin <= at <= interval[1] + margin for at in (u, u + domain[1] - domain[0]))


def is_said(found, a, b, u, v):
    return any(is_in(of_a, u, a.domain) and is_in(of_b, v, b.domain) for of_a, of_b in found.overlaps)


def check_all_said(a, b, found, pairs):
    for (of_a, of_b) in found.overlaps:
        assert of_a[0] < of_a[1] and of_b[0] < of_b[1]
    for u, v in pairs:
        assert is_said(found, a, b, u, v), (u, v)


def walk(rng):
    """A polyline among few corners, and the pairs of places of its legs that are one."""
    corners = rng.uniform(-1, 1, (int(rng.integers(2, 5)), 3))
    steps = [0]
    for _ in range(int(rng.integers(3, 9))):
        steps.append(int(rng.choice([i for i in range(len(corners)) if i != steps[-1]])))
    knots = np.r_[0, np.arange(len(steps)), len(steps) - 1].astype(float)
    legs = list(zip(steps[:-1], steps[1:]))
    pairs = []
    for i, leg in enumerate(legs):
        pairs += [(i + 0.3, j + 0.3) for j, other in enumerate(legs) if other == leg]
        pairs += [(i + 0.3, j + 0.7) for j, other in enumerate(legs) if other == leg[::-1]]
    return sc.NurbsCurve(1, knots, corners[steps]), pairs


def test_polylines_that_retrace_their_legs_say_all(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 11])
        curve, pairs = walk(rng)
        check_all_said(curve, curve, curve.intersections(curve), pairs)
        end = curve.domain[1]
        back = curve.reversed()
        check_all_said(curve, back, curve.intersections(back), [(u, end - v) for u, v in pairs])
        own = curve.self_intersections()
        for u, v in pairs:
            apart = abs(u - v)
            if 0 < apart and (apart > 0.5 or u < v):
                assert is_said(own, curve, curve, u, v) or is_said(own, curve, curve, v, u), (index, u, v)


def there_and_back(rng, index):
    """A curve on a segment, closed, open or in one span."""
    way = rng.normal(size=3)
    degree = int(rng.integers(2, 5))
    if index % 3 == 0:
        count = int(rng.integers(degree, 8))
        return sc.NurbsCurve(degree, np.arange(count + 1.0), rng.uniform(0, 1, (count, 1)) * way, periodic=True)
    if index % 3 == 1:
        return sc.BezierCurve(rng.uniform(0, 1, (degree + 1, 1)) * way).to_nurbs()
    knots = clamped(degree, int(rng.integers(2, 6)))
    return sc.NurbsCurve(degree, knots, rng.uniform(0, 1, (len(knots) - degree - 1, 1)) * way)


def pairs_on_segment(curve):
    """Places that are one, as sign changes between many; none near folds."""
    start, end = curve.domain
    v = np.linspace(start, end, 600)
    points = curve.evaluate(v)
    axis = points[np.argmax(np.linalg.norm(points - points[0], axis=1))] - points[0]
    height = points @ axis / (axis @ axis)
    for u in start + (end - start) * np.array([0.11, 0.37, 0.52, 0.83]):
        beside = height - (curve.evaluate(u) @ axis) / (axis @ axis)
        for i in np.nonzero(beside[:-1] * beside[1:] < 0)[0]:
            yield u, v[i] + (v[i + 1] - v[i]) * beside[i] / (beside[i] - beside[i + 1])


def test_curves_that_run_there_and_back_on_a_segment_say_all(inputs):
    for index in range(inputs(400)):
        rng = np.random.default_rng([index, 12])
        curve = there_and_back(rng, index)
        length = curve.domain[1] - curve.domain[0]
        pairs = list(pairs_on_segment(curve))
        check_all_said(curve, curve, curve.intersections(curve), pairs)
        own = curve.self_intersections()
        for u, v in pairs:
            apart = min(abs(u - v), length - abs(u - v)) / length
            if apart > 0.02:
                assert is_said(own, curve, curve, u, v) or is_said(own, curve, curve, v, u), (index, u, v)
        points = curve.evaluate(np.linspace(*curve.domain, 50))
        far = points[np.argmax(np.linalg.norm(points - points[0], axis=1))]
        along = line(points[0] - 1.3 * (far - points[0]), points[0] + 2.1 * (far - points[0]))
        found = curve.intersections(along)
        for u in np.linspace(*curve.domain, 20):
            assert any(is_in(of_curve, u, curve.domain) for of_curve in found.overlaps[:, 0]), index


def test_pieces_that_are_shared_are_one_whatever_the_weights(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 13])
        degree = int(rng.integers(1, 8))
        knots = clamped(degree, int(rng.integers(1, 5)))
        count = len(knots) - degree - 1
        curve = sc.NurbsCurve(degree, knots, rng.uniform(-1, 1, (count, 3)), 10 ** rng.uniform(-3, 3, count))
        part = curve.split(curve.domain[0] + rng.uniform(0.2, 0.8) * np.diff(curve.domain)[0])[index % 2]
        matrix = motion(rng)
        for a, b in ((curve, part), (part, curve), (curve.transformed(matrix), part.transformed(matrix))):
            found = a.intersections(b)
            assert len(found.overlaps) == 1, index
            assert found.overlaps[0] == pytest.approx(np.array([part.domain] * 2), abs=1e-3), index


def spiral(spans, each, phase=0.0):
    """An unclamped cubic, so many spans a turn: turns are one tenth apart."""
    angle = 2 * np.pi * np.arange(spans + 3) / each + phase
    radius = 1 + 0.1 * angle / (2 * np.pi)
    points = np.c_[radius * np.cos(angle), radius * np.sin(angle), np.zeros(spans + 3)]
    return sc.NurbsCurve(3, np.arange(spans + 7) - 3.0, points)


@pytest.mark.parametrize("each", [6, 8, 16, 64])
def test_long_spirals_do_not_cross_themselves(each):
    long = spiral(8000, each)
    found = long.self_intersections()
    assert not len(found.parameters) and not len(found.overlaps)
    tilted = np.eye(4)
    tilted[:3, :3] = motion(np.random.default_rng(each))[:3, :3]
    assert not len(long.transformed(tilted).self_intersections().parameters)


@pytest.mark.parametrize("each", [6, 8, 16])
def test_spirals_cross_a_moved_copy_as_their_parts_do(each):
    one = spiral(900, each)
    moved = np.eye(4)
    moved[:2, 3] = 0.33, 0.17
    other = one.transformed(moved)
    found = one.intersections(other)
    parts = [part.intersections(other) for first in one.split(430.4) for part in first.split(np.mean(first.domain))]
    assert len(found.parameters) == sum(len(part.parameters) for part in parts) > 900 / each
    assert np.abs(one.evaluate(found.parameters[:, 0]) - other.evaluate(found.parameters[:, 1])).max() < 1e-8


def test_lines_that_touch_at_a_pole_do_so_there_however_moved(inputs):
    pole = np.array([0, 0, 1.0])
    for index in range(inputs(200)):
        rng = np.random.default_rng([index, 14])
        angle = rng.choice([0, np.pi / 2, rng.uniform(0, 7)])
        way = np.array([np.cos(angle), np.sin(angle), 0])
        matrix = motion(rng)
        bend = rng.uniform(0, 2) * (index % 2) * pole
        over = sc.BezierCurve([pole - 1.1 * way + bend, pole - bend, pole + 1.1 * way + bend])
        for curve in (sc.BezierCurve([pole - 1.1 * way, pole + 0.9 * way]), over if index % 2 else over.split(0.7)[0]):
            found = curve.to_nurbs().transformed(matrix).patch_intersections(SPHERE.transformed(matrix))
            there = np.linalg.norm(found.points - (matrix[:3, :3] @ pole + matrix[:3, 3]), axis=1)
            assert (there < 1e-4).sum() == 1 and there.min() < 1e-12, index


def test_the_default_tolerance_is_the_same_however_moved(inputs):
    for index in range(inputs(300)):
        rng = np.random.default_rng([index, 15])
        size, aside = 10 ** rng.uniform(-9, 9), rng.normal(size=3)
        points = size * rng.uniform(-1, 1, (3, 1)) * np.array([1, 0, 0]) + size * np.array([[-2, 0, 0]])
        ends = np.array([points[0], points[0] + [3 * size, 0, 0]])
        way = np.cross([1, 0, 0], aside)
        way /= np.linalg.norm(way)
        reach = np.linalg.norm(ends - ends.mean(axis=0), axis=1).max() * 2.0**-33
        matrix = motion(rng)
        matrix[:3, 3] *= size / 3
        for share, is_near in ((0.9, True), (1.1, False)):
            a, b = (sc.BezierCurve(p).to_nurbs().transformed(matrix) for p in (ends, ends + share * reach * way))
            found = a.intersections(b)
            assert (len(found.parameters) + len(found.overlaps) > 0) == is_near, index


def test_a_stretch_on_a_patch_over_the_end_of_a_closed_curve_is_one():
    strip = sc.BezierPatch([[(0.3, -2, 0), (0.3, 2, 0)], [(2, -2, 0), (2, 2, 0)]])
    around = np.arange(7) * 2 * np.pi / 7
    periodic = sc.NurbsCurve(3, np.arange(8.0), np.c_[np.cos(around), np.sin(around), 0 * around], periodic=True)
    for curve in (circle(), circle().reversed(), periodic, periodic.reversed()):
        found = curve.patch_intersections(strip)
        (start, end), = found.overlaps
        low, high = curve.domain
        assert low < start < high < end < start + high - low and not len(found.parameters)
        ends = curve.evaluate([start, end - (high - low)])
        assert ends[:, 0] == pytest.approx([0.3, 0.3], abs=1e-8)
    whole = circle().patch_intersections(sc.BezierPatch([[(-2, -2, 0), (-2, 2, 0)], [(2, -2, 0), (2, 2, 0)]]))
    assert whole.overlaps.tolist() == [[0, 4]]


@pytest.mark.parametrize("gap", [0.9, 0.6, 0.24, 0.05])
def test_through_the_double_line_of_a_patch_there_are_both_places(gap):
    curve = looped(gap)
    points = curve.points[:, :3]
    patch = sc.BezierPatch(np.stack([points, points + [0, 0, 1]], axis=1))
    double = curve.self_intersections().points[0]
    for index in range(20):
        rng = np.random.default_rng([index, 16])
        way, matrix = rng.normal(size=3), motion(rng)
        at = double + [0, 0, rng.uniform(0.2, 0.8)]
        through = line(at - 0.1 * gap**2 * way, at + 0.07 * gap**2 * way)
        found = through.transformed(matrix).patch_intersections(patch.transformed(matrix))
        here = np.abs(found.parameters[:, 0] - 10 / 17) < 1e-6
        assert np.sort(found.parameters[here, 1]) == pytest.approx([0.5 - gap / 2, 0.5 + gap / 2], abs=1e-7)
    edge = line(double + [0, 0, 0.2], double + [0, 0, 0.7])
    assert edge.patch_intersections(patch).overlaps == pytest.approx(np.array([[0, 1]]))


def test_a_polyline_that_goes_again_over_its_legs_has_an_overlap_for_each_pair():
    again = polyline((0, 0), (1, 0.7), (0, 0), (1, 0.7))
    found = again.intersections(again)
    want = [[[0, 1], [2, 3]], [[0, 2], [0, 2]], [[0, 3], [0, 3]], [[1, 3], [1, 3]], [[2, 3], [0, 1]]]
    assert sorted(found.overlaps.round(7).tolist()) == want and found.reversed.sum() == 2
