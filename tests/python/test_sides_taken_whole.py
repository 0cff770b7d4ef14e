"""Fillets, chamfers and rounded corners whose length is exactly that of a side take it whole, however small, large or far away."""

import numpy as np

import splinecore as sc
from splinecore import build


def corner_of(rng):
    """(scale, corner, ends of a side and of a longer one, angle)."""
    scale = 10 ** rng.uniform(-12, 9)
    corner = rng.uniform(-1, 1, 2) * scale * rng.choice([0, 1, 1e3])
    turn, angle = rng.uniform(0, 2 * np.pi), rng.uniform(0.2, 2.9)
    ways = [np.array([np.cos(at), np.sin(at)]) for at in (turn, turn + angle)]
    ends = corner + scale * rng.uniform(0.3, 1) * ways[0], corner + scale * rng.uniform(1, 3) * ways[1]
    return scale, [np.r_[point, 0] for point in (corner, *ends)], angle


def test_a_side_is_taken_whole(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 91])
        scale, (corner, end, other), angle = corner_of(rng)
        a, b = sc.BezierCurve([corner, end]), sc.BezierCurve([corner, other])
        kept = 1.0
        if rng.random() < 0.5:
            a, kept = a.reversed(), 0.0
        length = float(np.linalg.norm(end - corner))
        radius = length * np.tan(angle / 2)
        rounding = 1e-9 * length + 1e-15 * np.abs(corner).max()
        first, bridge, _ = build.chamfered(a, b, (length, 0.5 * length), (0.5, 1.0))
        assert first is None or first.length() <= rounding, index
        assert np.linalg.norm(bridge.evaluate(bridge.domain) - end, axis=1).min() <= rounding, index
        first, arc, _ = build.filleted(a, b, radius, (kept, 1.0))
        assert first is None or first.length() <= 1e-6 * length, index
        assert np.linalg.norm(arc.evaluate(arc.domain) - end, axis=1).min() <= 1e-6 * length, index
        contour = build.contour([end, corner, other])
        for cut in (contour.rounded(radius), contour.chamfered(length)):
            assert np.linalg.norm(cut.evaluate(cut.domain) - [end, other], axis=1).max() <= rounding, index
            assert cut.length() < length + np.linalg.norm(other - corner), index
