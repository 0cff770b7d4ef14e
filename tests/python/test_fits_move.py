"""Interpolants, rebuilt and faired curves of wild curves: moved, turned, scaled, far away and reversed they are the same, up to
what rounding of the points is, and what is refused one way is refused the other."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit
from test_frames_anywhere import ENDS, hard_curve, rotation

REFUSED = (sc.InvalidShape, sc.ToleranceNotReached, sc.PointAtInfinity)
SHARES = np.linspace(0, 1, 301)


def task(seed, kind, farthest=1e7):
    """(rng, curve, its size, how far away, motion)."""
    rng = np.random.default_rng([101, kind, seed])
    curve = hard_curve(rng, ENDS[seed % len(ENDS)])
    scale, far = 10 ** rng.uniform(-12, 9), float(rng.choice([0, 1, 1e3, farthest]))
    motion = np.column_stack([scale * rotation(rng), scale * far * rng.uniform(-1, 1, 3)])
    return rng, curve, np.ptp(curve.points, axis=0).max(), far, motion


def moved_back(points, motion):
    scale = np.linalg.norm(motion[:, 0])
    return (points / scale - motion[:, 3] / scale) @ (motion[:, :3] / scale)


def at_shares(curve, is_reversed=False):
    start, end = curve.domain
    return curve.evaluate(start + (end - start) * (1 - SHARES if is_reversed else SHARES))


def made_or_none(make):
    try:
        return make()
    except REFUSED:
        return None


def all_or_none(ways, seed):
    made = [made_or_none(way) for way in ways]
    assert all(one is None for one in made) or None not in made, (seed, [one is None for one in made])
    return None if None in made else made


def off(plain, other):
    return np.linalg.norm(plain - other, axis=1).max()


def test_rebuilt_curves(inputs):
    for seed in range(inputs(1000)):
        rng, curve, size, far, motion = task(seed, 1)
        count, degree, ends = int(rng.integers(12, 40)), int(rng.integers(1, 10)), str(rng.choice(["points", "tangents"]))
        scale = np.linalg.norm(motion[:, 0])
        rounded = curve.with_points(curve.points + 2e-16 * (1 + far) * size * rng.normal(size=curve.points.shape))
        made = all_or_none([lambda one=one: one.rebuild(count, degree, ends=ends)
                            for one in (curve, curve.transformed(motion), curve.reversed(), rounded)], seed)
        if made is None:
            continue
        plain, moved, back, rounded = made
        points = at_shares(plain.value)
        assert off(points, at_shares(curve)) <= plain.error * (1 + 1e-9) + 1e-13 * size, seed
        # First points that are near have a rounded tangent, which may be so long that the curve runs far out.
        slack = 200 * off(points, at_shares(rounded.value)) + 1e-9 * np.ptp(plain.value.points, axis=0).max()
        assert off(points, moved_back(at_shares(moved.value), motion)) <= slack, seed
        assert off(points, at_shares(back.value, True)) <= slack, seed
        assert abs(plain.error - moved.error / scale) <= 0.02 * plain.error + slack, seed
        assert abs(plain.error - back.error) <= 0.02 * plain.error + slack, seed


def test_faired_curves(inputs):
    """Up to how far the largest multiple of the energy is found."""
    made_count = 0
    for seed in range(inputs(1000)):
        rng, curve, size, far, motion = task(seed, 2, 1e4)
        tolerance = size * 10 ** rng.uniform(-5, -1)
        scale = np.linalg.norm(motion[:, 0])
        made = all_or_none([lambda: curve.fair(tolerance), lambda: curve.transformed(motion).fair(tolerance * scale),
                            lambda: curve.reversed().fair(tolerance)], seed)
        if made is None:
            continue
        made_count += 1
        plain, moved, back = made
        points = at_shares(plain.value)
        assert off(points, at_shares(curve)) <= plain.error * (1 + 1e-9) + 1e-13 * size <= tolerance + 1e-13 * size, seed
        slack = 0.01 * tolerance + 1e-13 * far * size
        assert off(points, moved_back(at_shares(moved.value), motion)) <= slack, seed
        assert off(points, at_shares(back.value, True)) <= slack, seed
        assert abs(plain.error - moved.error / scale) <= slack and abs(plain.error - back.error) <= slack, seed
    assert made_count > 0.9 * inputs(1000)


@pytest.mark.parametrize("closed", [False, True])
def test_interpolants(closed, inputs):
    """Of points of wild curves, some of which nearly are one: a motion changes no more than rounding the points does."""
    made_count = 0
    for seed in range(inputs(1000)):
        rng, curve, _, far, motion = task(seed, 3)
        points = curve.evaluate(np.sort(rng.uniform(0, 1, int(rng.integers(5, 40)))))
        size, scale = np.ptp(points, axis=0).max(), np.linalg.norm(motion[:, 0])
        degree = min(int(rng.integers(1, 8)), len(points) - 1)
        way = {"degree": degree, "parameters": str(rng.choice(["chordal", "centripetal", "uniform"])), "closed": closed}
        ways = [points, points @ motion[:, :3].T + motion[:, 3], np.r_[points[:1], points[:0:-1]] if closed else points[::-1],
                points + 2e-16 * (1 + far) * size * rng.normal(size=points.shape)]
        made = [made_or_none(lambda one=one: fit.interpolate(one, **way)) for one in ways]
        if None in made:
            continue
        made_count += 1
        plain, moved, back, rounded = made
        at = at_shares(plain.value)
        net = np.ptp(plain.value.points, axis=0).max()
        assert plain.value.nearest(points).distances.max() <= plain.error + 1e-12 * size + 1e-14 * net, seed
        slack = 200 * off(at, at_shares(rounded.value)) + 1e-9 * size
        assert off(at, moved_back(at_shares(moved.value), motion)) <= slack, seed
        # Of even degrees closed ones do not begin in a point.
        assert back.value.nearest(at).distances.max() <= slack, seed
    assert made_count > 0.9 * inputs(1000)
