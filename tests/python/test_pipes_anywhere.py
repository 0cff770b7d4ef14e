"""Pipes about wild curves: moved, turned, scaled and reversed they are the same, within the tolerance."""

import numpy as np

import splinecore as sc
from splinecore import build
from test_frames_anywhere import hard_curve, rotation

KINDS = ["plain", "first points are one", "last points are one", "plain"]


def made_or_refused(curve, radius, tolerance):
    try:
        return build.pipe(curve, radius, tolerance=tolerance).value[0]
    except (sc.InvalidShape, sc.ToleranceNotReached):
        return None


def test_pipes_move_with_their_axes(inputs):
    """What can be made can be made however it lies and whichever way it runs."""
    compared = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([67, seed])
        curve = hard_curve(rng, KINDS[seed % len(KINDS)])
        size = np.ptp(curve.points, axis=0).max()
        tolerance, radius = size * 10 ** rng.uniform(-3, -2), size * 10 ** rng.uniform(-3, -1)
        pipe = made_or_refused(curve, radius, tolerance)
        scale = 10 ** rng.uniform(-12, 9)
        matrix = np.column_stack([scale * rotation(rng), scale * rng.uniform(-1, 1, 3)])
        moved = made_or_refused(curve.transformed(matrix), radius * scale, tolerance * scale)
        back = made_or_refused(curve.reversed(), radius, tolerance)
        assert (moved is None) == (back is None) == (pipe is None), seed
        if pipe is None:
            continue
        compared += 1
        knots = np.unique(np.clip(pipe.knots[1], *pipe.domain[1]))
        along = np.concatenate([np.linspace(a, b, 3) for a, b in zip(knots[:-1], knots[1:])])
        along = rng.choice(along, 30)
        points = pipe.evaluate_grid(np.linspace(*pipe.domain[0], 6)[:-1], along).reshape(-1, 3)
        assert moved.nearest(points @ matrix[:, :3].T + matrix[:, 3]).distances.max() <= 2.2 * tolerance * scale, seed
        assert back.nearest(points).distances.max() <= 2.2 * tolerance, seed
    assert compared > 0.9 * inputs(1000)
