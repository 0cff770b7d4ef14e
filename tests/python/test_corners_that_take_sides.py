"""Arcs and lines at corners that are as long as a side: what takes it whole is taken; a little more is refused."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SEEDS = range(1000)


def turned_and_scaled(rng, points):
    """Anywhere, at any size."""
    flat = np.c_[np.asarray(points, float), np.zeros(len(points))]
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return 10.0**rng.uniform(-6, 6) * (flat @ axes.T + rng.normal(size=3) * rng.choice([0.0, 1.0, 100.0])), axes[:, 2]


def corner(rng):
    """(start, corner, end) in a plane, and the angle between the sides, of which the first is the shorter one or as long."""
    angle = rng.uniform(0.2, np.pi - 0.2)
    short, more = rng.uniform(0.1, 5), rng.choice([0.0, rng.uniform(0, 5)])
    return [(short, 0), (0, 0), ((short + more) * np.cos(angle), (short + more) * np.sin(angle))], angle, short, more


def lines_of(points):
    return [sc.BezierCurve(points[i:i + 2]) for i in range(len(points) - 1)]


def test_an_arc_or_a_line_takes_a_side_whole(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        plain, angle, short, more = corner(rng)
        points, normal = turned_and_scaled(rng, plain)
        size = np.linalg.norm(points[0] - points[1])
        radius = size * np.tan(0.5 * angle)
        bent = build.contour(points)
        a, b = lines_of(points)
        rest = (np.linalg.norm(points[2] - points[1]) - size) if more else 0.0
        arc = radius * (np.pi - angle)
        near = 1e-7 * np.abs(points).max()
        assert bent.rounded(radius).length() == pytest.approx(arc + rest, abs=near)
        chord = 2 * size * np.sin(0.5 * angle)
        assert bent.chamfered(size).length() == pytest.approx(chord + rest, abs=near)
        assert len(build.fillets(a, b, radius, normal)) == 1
        kept = (rng.choice([0.0, 1e-6, 0.5]), rng.choice([1.0, 1 - 1e-6]))
        for first, bridge, second in (build.filleted(a, b, radius, kept, normal), build.chamfered(a, b, (size, size), kept)):
            assert first is None and (second is None) == (more == 0.0)
            assert not more or second.length() == pytest.approx(rest, abs=near)
            assert np.linalg.norm(bridge.evaluate(bridge.domain[0]) - points[0]) < near
        if rng.random() < 0.2:
            with pytest.raises(sc.InvalidShape):
                bent.rounded(1.001 * radius)
            with pytest.raises(sc.InvalidShape):
                build.chamfered(a, b, (1.001 * size, size), kept)


def test_a_line_takes_a_curved_side_whole(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        plain = np.r_[rng.uniform(-1, 0, (3, 2)) - (1, 0), [(0, 0)]]
        behind = np.r_[[(0, 0)], rng.uniform(0, 2, (3, 2)) + (0, 3)]
        points, _ = turned_and_scaled(rng, np.r_[plain, behind])
        a, b = sc.BezierCurve(points[:4]), sc.BezierCurve(points[4:])
        length = a.length()
        near = 1e-7 * np.abs(points).max()
        first, bridge, second = build.chamfered(a, b, (length, 0.1 * length), (0.0, 1.0))
        assert first is None and np.linalg.norm(bridge.evaluate(0.0) - points[0]) < near
        both = build.join_curves([a, b], 0.0)[0]
        if length < b.length():
            made = both.chamfered(length)
            assert np.linalg.norm(made.evaluate(made.domain[0]) - points[0]) < near


@pytest.mark.parametrize("count", range(3, 40))
def test_a_polygon_becomes_its_inner_circle(count):
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    polygon = build.contour(np.c_[np.cos(turn), np.sin(turn)], closed=True)
    inner = np.cos(np.pi / count)
    circle = polygon.rounded(inner)
    points = circle.evaluate(np.linspace(*circle.domain, 100))
    assert np.abs(np.linalg.norm(points, axis=1) - inner).max() < 1e-9
    assert circle.length() == pytest.approx(2 * np.pi * inner)
