"""What is fitted within a tolerance has its knots where curves bend sharply or crease, so that few are enough and it takes little time."""

import time

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def creased_section(rng, height, times):
    """A cubic with knots of its own, so many copies of each."""
    inner = np.repeat(np.sort(rng.uniform(0.1, 0.9, 3)), times)
    knots = np.r_[[0] * 4, inner, [1] * 4]
    across = np.array([knots[i + 1:i + 4].mean() for i in range(len(knots) - 4)])
    return sc.NurbsCurve(3, knots, np.c_[across, 0.3 * rng.normal(size=len(across)), np.full(len(across), height)])


@pytest.mark.parametrize("times", [1, 2])
def test_a_loft_within_a_tolerance_has_no_more_points_than_without(times, inputs):
    """Even spans would be 4096 and more for a crease."""
    for seed in range(inputs(60)):
        rng = np.random.default_rng([seed, times, 71])
        size = 10**rng.uniform(-9, 6)
        sections = [creased_section(rng, z, times).transformed(size * np.eye(3)) for z in range(4)]
        exact = build.loft(sections).value.points.shape[0]
        for tolerance in (1e-2, 1e-4, 1e-7):
            made, error = build.loft(sections, tolerance=tolerance * size)
            assert made.points.shape[0] <= exact and error <= tolerance * size, seed
            for section, v in zip((sections[0], sections[-1]), made.domain[1]):
                t = np.linspace(0, 1, 301)
                apart = made.isocurve("v", v).evaluate(t) - section.evaluate(t)
                assert np.linalg.norm(apart, axis=1).max() <= error / 0.98 + 1e-13 * size, seed


def rational_net(rng, degree, reach):
    """A patch with weights from 10^-reach to 10^reach, knots near each other and nearly one among them."""
    def knots():
        inner = np.sort(rng.uniform(0.15, 0.85, 3))
        inner = np.sort(np.r_[inner, inner[0] + 10.0**rng.uniform(-12, -5)])
        return np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)], degree + 5
    (along, n), (across, m) = knots(), knots()
    net = np.stack([*np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, m), indexing="ij"), rng.normal(0, 0.05, (n, m))], -1)
    return sc.NurbsPatch((degree, degree), (along, across), net, 10**rng.uniform(-reach, reach, (n, m)))


@pytest.mark.parametrize("degree", [2, 3, 5])
def test_rational_networks_take_few_knots_and_little_time(degree, inputs):
    """Weights of a ratio of 6: 2817 knots in 10 seconds where spans are even."""
    counts = []
    for seed in range(inputs(60)):
        rng = np.random.default_rng([seed, degree, 61])
        patch = rational_net(rng, degree, 0.4)
        shares = [np.linspace(0, 1, count)**rng.uniform(0.7, 1.4) for count in rng.integers(2, 6, 2)]
        along_u, along_v = [patch.isocurve("v", v) for v in shares[1]], [patch.isocurve("u", u) for u in shares[0]]
        before = time.process_time()
        made = build.network(along_u, along_v)
        assert time.process_time() - before < 2, seed
        counts += made.value.points.shape[:2]
        for curve in [*along_u, *along_v]:
            points = curve.evaluate(np.linspace(*curve.domain, 41))
            assert made.value.nearest(points).distances.max() <= made.error / 0.98 + 1e-12, seed
    assert max(counts) <= 300


def test_crossings_are_met_where_they_are_also_within_a_wide_tolerance():
    """Curves that cross at the same parameters keep their pace, however far the others may be from the surface."""
    rng = np.random.default_rng(72)
    for _ in range(40):
        low = sc.BezierCurve(np.c_[np.linspace(0, 6, 5), 0.3 * rng.normal(size=(5, 2))])
        high = low.with_points(low.points + (0, 4, 0))
        shares = np.r_[0, np.sort(rng.uniform(0.1, 0.9, 3)), 1]
        ribs = [sc.BezierCurve([a, 0.5 * (a + b) + 0.3 * rng.normal(size=3), b]) for a, b in zip(low.evaluate(shares), high.evaluate(shares))]
        if np.diff(shares).min() < 0.05:
            continue
        made = build.network([low, high], ribs, tolerance=6e-3)
        assert max(made.paces) <= 1e-13
