"""Faired patches of wild patches: moved, turned, scaled, far away and reversed they are the same, up to what rounding of the points is;
the tolerance is kept, and what is refused one way is refused the other."""

import numpy as np
import splinecore as sc
from random_patches import random_patch, sampled_distance
from test_fits_move import moved_back
from test_frames_anywhere import rotation

SHARES = np.linspace(0, 1, 31)


def wild_patch(rng):
    """Sometimes with knots or rows that nearly are one, or far longer than wide."""
    patch = random_patch(rng, degree=int(rng.integers(2, 6)), spans=int(rng.integers(1, 5)))
    points = np.array(patch.points)
    if rng.random() < 0.3 and len(points) > 1:
        row = int(rng.integers(1, len(points)))
        points[row] = points[row - 1] + 10 ** rng.uniform(-9, -2) * rng.normal(size=points[row].shape)
    points[..., int(rng.integers(3))] *= 10 ** rng.uniform(-6, 0)
    return patch.with_points(points)


def grid_of(patch, reversed_u=False):
    u, v = (a + (b - a) * SHARES for a, b in patch.domain)
    return patch.evaluate_grid(u[::-1] if reversed_u else u, v)


def made_or_none(make):
    try:
        return make()
    except (sc.InvalidShape, sc.ToleranceNotReached):
        return None


def test_faired_patches(inputs):
    made_count = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 611])
        patch = wild_patch(rng)
        size = np.ptp(patch.points.reshape(-1, 3), axis=0).max()
        tolerance, ends = size * 10 ** rng.uniform(-5, -1), str(rng.choice(["points", "tangents"]))
        scale, far = 10 ** rng.uniform(-12, 9), float(rng.choice([0, 1, 1e3, 1e4]))
        motion = np.column_stack([scale * rotation(rng), scale * far * size * rng.uniform(-1, 1, 3)])
        ways = [made_or_none(lambda one=one, by=by: one.fair(tolerance * by, ends=ends))
                for one, by in ((patch, 1.0), (patch.transformed(motion), scale), (patch.reversed("u"), 1.0), (patch.swapped(), 1.0))]
        assert all(way is None for way in ways) or None not in ways, (seed, [way is None for way in ways])
        if None in ways:
            continue
        made_count += 1
        plain, moved, back, swapped = ways
        assert sampled_distance(patch, plain.value) <= plain.error * (1 + 1e-9) + 1e-13 * size <= tolerance + 2e-13 * size, seed
        grid, slack = grid_of(plain.value), 0.1 * tolerance + 1e-12 * (1 + far) * size
        for other in (moved_back(grid_of(moved.value).reshape(-1, 3), motion).reshape(grid.shape), grid_of(back.value, True),
                      grid_of(swapped.value).swapaxes(0, 1)):
            assert np.linalg.norm(grid - other, axis=-1).max() <= slack, seed
        assert abs(plain.error - moved.error / scale) <= slack and abs(plain.error - back.error) <= slack, seed
    assert made_count > 0.9 * inputs(1000)
