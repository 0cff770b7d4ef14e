"""Crossings of offsets that are not exact: arcs that touch both curves are found, or there is none; cusps of offsets near each other."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def bezier(*points):
    degree = len(points) - 1
    return sc.NurbsCurve(degree, [0] * (degree + 1) + [1] * (degree + 1), np.c_[np.array(points, float), np.zeros(degree + 1)])


def line(start, end):
    return bezier(start, end)


def touch(curve, u, center):
    """(distance from the center, cosine of the angle between the way there and the tangent)."""
    point, along = curve.derivatives(u, 1)
    away = center - point
    return np.linalg.norm(away), (away @ along) / np.linalg.norm(away) / np.linalg.norm(along)


def center_of(arc):
    a, b, c = arc.evaluate(np.array([arc.domain[0], np.mean(arc.domain), arc.domain[1]]))
    u, v = b - a, c - a
    normal = np.cross(u, v)
    return a + (np.cross(normal, u) * (v @ v) + np.cross(v, normal) * (u @ u)) / (2 * normal @ normal)


def require_touching(a, b, radius, found, seed=None):
    for arc, u, v, *_ in found:
        for curve, at in ((a, u), (b, v)):
            distance, cosine = touch(curve, at, center_of(arc))
            assert abs(distance - radius) <= 1e-7 * radius and abs(cosine) <= 1e-6, (seed, distance, cosine)


def nearly_touching(rng):
    """A parabola over a line: its offset comes as near to that of the line as is said, or crosses it twice."""
    bend, radius = rng.uniform(0.1, 0.4), rng.uniform(0.3, 1.0)
    apart = rng.choice([-1, 1]) * 10**rng.uniform(-8, -2)
    a = bezier((-2, 4 * bend), (0, -4 * bend), (2, 4 * bend))   # y = bend x²
    height = -2 * radius - apart
    return a, line((-3, height), (3, height)), radius, apart


def test_offsets_that_nearly_touch(inputs):
    """Two arcs where they cross, none where they do not, however near that."""
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 301])
        a, b, radius, apart = nearly_touching(rng)
        turn, size = rng.uniform(0, 2 * np.pi), 10**rng.uniform(-6, 6)
        matrix = np.eye(4)
        matrix[:2, :2] = size * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        matrix[:2, 3] = size * rng.uniform(-3, 3, 2)
        a, b = a.transformed(matrix), b.transformed(matrix)
        found = [one for one in build.fillets(a, b, size * radius)
                 if np.pi * 0.9 * size * radius < one[0].length(tolerance=1e-9) < np.pi * 1.1 * size * radius]
        require_touching(a, b, size * radius, found, seed)
        assert len(found) == (0 if apart > 0 else 2), (seed, apart, len(found))


def polyline(rng, count):
    return sc.NurbsCurve(1, np.r_[0, np.arange(count), count - 1.0], np.c_[rng.uniform(-2, 2, (count, 2)), np.zeros(count)])


def arcs_of_lines(a, b, radius):
    """Of two segments, by hand: centers beside both."""
    (p, q), (r, s) = ((np.array(c.points)[0, :2], np.array(c.points)[-1, :2]) for c in (a, b))
    d, e = (q - p) / np.linalg.norm(q - p), (s - r) / np.linalg.norm(s - r)
    count = 0
    for side in (radius, -radius):
        for other in (radius, -radius):
            x, y = p + side * np.array([-d[1], d[0]]), r + other * np.array([-e[1], e[0]])
            u, v = np.linalg.solve(np.c_[d, -e], y - x)
            count += 0 <= u <= np.linalg.norm(q - p) and 0 <= v <= np.linalg.norm(s - r)
    return count


def test_corners_stand_for_no_arc(inputs):
    """Offsets of polylines have arcs about their corners; where these cross nothing touches both."""
    for seed in range(inputs(300)):
        rng = np.random.default_rng([seed, 302])
        a, b, radius = polyline(rng, int(rng.integers(2, 7))), polyline(rng, int(rng.integers(2, 7))), 10**rng.uniform(-1.3, 0.3)
        pieces = [[line(*np.array(curve.points)[i:i + 2, :2]) for i in range(len(curve.points) - 1)] for curve in (a, b)]
        wanted = sum(arcs_of_lines(one, two, radius) for one in pieces[0] for two in pieces[1])
        found = build.fillets(a, b, radius)
        require_touching(a, b, radius, found, seed)
        assert len(found) == wanted, (seed, len(found), wanted)


def test_lines_beside_each_other_have_arcs_at_the_ends_of_what_they_share():
    """Offsets that are one along a stretch: half turns, of which those at the ends are given."""
    found = build.fillets(line((0, 0), (4, 0)), line((1, 2), (6, 2)), 1.0)
    assert sorted(round(4 * u, 9) for _, u, *_ in found) == [1.0, 4.0]
    assert all(arc.length(tolerance=1e-12) == pytest.approx(np.pi) for arc, *_ in found)


def two_cusps(apart, degree):
    """A plane curve that stands still at two places, so far apart about the middle of [0, 1]: x' = (t - p)(t - q), y' = t x'."""
    p, q = 0.5 - apart / 2, 0.5 + apart / 2
    slope = np.polynomial.Polynomial.fromroots([p, q])
    x = slope.integ()
    y = (slope * np.polynomial.Polynomial([0.0, 1.0])**(degree - 3)).integ()
    at = np.linspace(0, 1, degree + 1)
    return build.polynomial_through(np.c_[x(at), y(at), 0 * at], at), (p, q)


@pytest.mark.parametrize("apart", [0.3, 0.05, 0.01, 0.002])
@pytest.mark.parametrize("degree", [4, 6])
def test_both_of_two_cusps_near_each_other_are_gone_round(apart, degree):
    curve, (p, q) = two_cusps(apart, degree)
    size = np.ptp(np.array(curve.points), axis=0).max()
    distance = 0.05 * size
    made, = curve.offset(distance)
    for at in (p, q):
        tip = curve.evaluate(at)
        ring = made.evaluate(np.linspace(*made.domain, 20001))
        away = np.linalg.norm(ring - tip, axis=1)
        assert abs(away.min() - distance) <= 1e-4 * size
        near = np.abs(away - distance) < 1e-5 * size
        # half a turn about each tip
        assert np.ptp(np.unwrap(np.arctan2(*(ring - tip)[near][:, 1::-1].T))) > 2.5


@pytest.mark.parametrize("beyond", [1e-1, 1e-2, 1e-3])
@pytest.mark.parametrize("start", [-2.0, -1.93, -0.71])
def test_both_cusps_of_an_offset_are_had_however_near_each_other(start, beyond):
    """y = x² / 2 bends most at 0, with a radius of 1: beyond that its offset has two cusps, where (1 + x²)^1.5 is the distance."""
    end = start + 4
    curve = bezier((start, start**2 / 2), ((start + end) / 2, start * end / 2), (end, end**2 / 2))
    distance = 1 + beyond
    made, = curve.offset(distance)
    corners = [u for u, joint in made.joints(1e-6) if joint.angle > 3]
    at = np.sqrt(distance**(2 / 3) - 1)
    wanted = [(x - distance * x / np.sqrt(1 + x * x), x * x / 2 + distance / np.sqrt(1 + x * x), 0) for x in (-at, at)]
    assert made.evaluate(np.array(corners)) == pytest.approx(np.array(wanted), abs=1e-9)
