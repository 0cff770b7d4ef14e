"""Frames of curves that stand still, have near-equal knots or wild weights: true tangents, and the same after motions."""

import numpy as np

import splinecore as sc

ENDS = ["plain", "first points are one", "three first points are one", "last points are one", "first points are near",
        "inner points are one"]


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q * np.sign(np.linalg.det(q))


def hard_curve(rng, kind):
    degree, more = int(rng.integers(2, 10)), int(rng.integers(0, 8))
    inner = np.sort(rng.uniform(0, 1, more))
    if more > 1 and rng.random() < 0.3:
        inner[1] = inner[0] + 10 ** rng.uniform(-12, -4)
    if more > 1 and rng.random() < 0.3:
        inner[0] = 10 ** rng.uniform(-10, -3)
    count = degree + 1 + more
    points = rng.uniform(-1, 1, (count, 3))
    if kind == "first points are one":
        points[1] = points[0]
    elif kind == "three first points are one" and count > 4:
        points[1] = points[2] = points[0]
    elif kind == "last points are one":
        points[-2] = points[-1]
    elif kind == "first points are near":
        points[1] = points[0] + 1e-9 * rng.normal(size=3)
    elif kind == "inner points are one" and count > 5:
        points[count // 2] = points[count // 2 - 1]
    weights = 10 ** rng.uniform(-3, 3, count) if rng.random() < 0.5 else None
    return sc.NurbsCurve(degree, np.r_[[0] * (degree + 1), np.sort(inner), [1] * (degree + 1)], points, weights)


def leaving(points):
    """From the first point to the first other one."""
    ways = points - points[0]
    way = ways[np.flatnonzero(np.any(ways != 0, axis=1))[0]]
    return way / np.linalg.norm(way)


def random_task(seed):
    rng = np.random.default_rng([73, seed])
    kind = ENDS[seed % len(ENDS)]
    curve = hard_curve(rng, kind)
    return rng, kind, curve, np.r_[0, np.sort(rng.uniform(0, 1, 30)), 1]


def test_tangents_are_true(inputs):
    for seed in range(inputs(1000)):
        _, _, curve, u = random_task(seed)
        tangents = np.array(curve.frames(u))[:, 0]
        assert np.abs(tangents[0] - leaving(curve.points)).max() <= 1e-12, seed
        assert np.abs(tangents[-1] + leaving(curve.points[::-1])).max() <= 1e-12, seed
        slopes = curve.derivatives(u, 1)[:, 1]
        knots = np.unique(curve.knots)
        spans = np.diff(knots)[np.clip(np.searchsorted(knots, u, side="right") - 1, 0, len(knots) - 2)]
        speeds = np.linalg.norm(slopes, axis=1)
        moves = speeds * spans > 1e-2
        assert np.abs(tangents[moves] - slopes[moves] / speeds[moves, None]).max(initial=0) <= 1e-9, seed


def test_frames_move_with_the_curve(inputs):
    """Points that are near are rounded by a motion: their direction moves by as much."""
    for seed in range(inputs(1000)):
        rng, kind, curve, u = random_task(seed)
        start = rng.normal(size=3)
        before = np.array(curve.frames(u, start=start))
        turn, scale = rotation(rng), 10 ** rng.uniform(-12, 9)
        matrix = np.column_stack([scale * turn, scale * rng.uniform(-1, 1, 3)])
        after = np.array(curve.transformed(matrix).frames(u, start=turn @ start))
        off = np.linalg.norm(after - before @ turn.T, axis=-1)
        slack = 1e-15 / np.linalg.norm(curve.points[1] - curve.points[0]) if kind == "first points are near" else 0.0
        assert off[:, 0].max() <= 1e-9 + 4 * slack, seed
        assert off[:, 1:].max() <= 1e-7 + 8 * slack, seed


def test_frames_stay_orthonormal(inputs):
    for seed in range(inputs(200)):
        _, _, curve, u = random_task(50_000 + seed)
        frames = np.array(curve.frames(u))
        assert np.abs(frames @ frames.transpose(0, 2, 1) - np.eye(3)).max() <= 1e-12, seed
        assert np.abs(np.linalg.det(frames) - 1).max() <= 1e-12, seed
