"""Blends of closed sides that begin in different places: both stay edges, and nothing is twisted."""

import numpy as np
import pytest
import splinecore as sc
from splinecore import build
from test_shared_fillets import spline_rim


def turned(patch, angle):
    c, s = np.cos(angle), np.sin(angle)
    return patch.transformed(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]))


def require_edges(a, made, b):
    pairs = {frozenset((one[0], other[0])) for one, other in sc.PatchSet.from_patches([a, made, b]).seams()}
    assert {frozenset((0, 1)), frozenset((1, 2))} <= pairs


@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 2, 2.5, np.pi, 4.0])
@pytest.mark.parametrize("continuity, least", [('G0', 0), ('G1', 1), ('G2', 2), ('G3', 2)])
def test_tubes_that_are_turned(angle, continuity, least):
    a, straight = build.cylinder((0, 0, 0), (0, 0, 1), 2, 3), build.cylinder((0, 0, 5), (0, 0, 1), 1, 2)
    wanted = build.blend_patches(a, 'v_end', straight, 'v_start', continuity)
    for b in (turned(straight, angle), turned(straight, angle).reversed('u')):
        made = build.blend_patches(a, 'v_end', b, 'v_start', continuity)
        require_edges(a, made, b)
        for patch, side, own in ((a, 'v_end', 'v_start'), (b, 'v_start', 'v_end')):
            assert sc.seam_continuity(patch, side, made, own).g >= least
        points = made.evaluate_grid(*(np.linspace(*domain, 33) for domain in made.domain)).reshape(-1, 3)
        assert wanted.nearest(points).distances.max() <= 0.02


def test_tubes_of_splines(inputs):
    """Nothing is pinched: sections between stay about as wide as the sides."""
    for seed in range(inputs(200)):
        rng = np.random.default_rng([seed, 71])
        tubes = []
        for height, way in ((0, -1), (4, 1)):
            points = spline_rim(rng, int(rng.integers(6, 12)))
            points = np.roll(points, int(rng.integers(0, len(points))), axis=0) + (0, 0, height)
            knots = np.r_[0, np.cumsum(rng.uniform(0.7, 1.3, len(points)))]
            weights = 10**rng.uniform(-0.1, 0.1, len(points)) if rng.random() < 0.3 else None
            tube = build.extrude(sc.NurbsCurve(3, knots, points, weights, periodic=True), (0, 0, 2 * way))
            tubes.append(tube.reversed('u') if rng.random() < 0.5 else tube)
        size = 10**rng.uniform(-6, 6)
        a, b = (tube.transformed(size * np.eye(3)) for tube in tubes)
        try:
            made = build.blend_patches(a, 'v_start', b, 'v_start', str(rng.choice(['G1', 'G2'])))
        except sc.ToleranceNotReached as refused:
            assert "patch" in str(refused)
            continue
        require_edges(a, made, b)
        grid = made.evaluate_grid(*(np.linspace(*domain, 33) for domain in made.domain)) / size
        width = np.hypot(grid[..., 0], grid[..., 1])
        assert width.min() > 2.0 and width.max() < 4.2, (seed, width.min(), width.max())
