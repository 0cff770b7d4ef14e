"""Patches that go on from others as smoothly as G3 do not shoot out beyond both, however sharply these bend."""

import numpy as np

import splinecore as sc
from splinecore import build
from test_many_surfaces import hill


def wild_hill(rng):
    """Of any height and width, so that it may bend within much less than another one's first span."""
    patch = hill(rng)
    points = np.array(patch.points)
    points[..., 2] = rng.uniform(-1, 1, points.shape[:2]) * 10**rng.uniform(-2, 0.5)
    points[..., 0] *= 10**rng.uniform(-1, 0.5)
    return patch.with_points(points)


def neighbors(rng):
    a, b = wild_hill(rng), wild_hill(rng)
    far = np.array(a.points)[..., 0].max() + 10**rng.uniform(-0.5, 1)
    return a, b.transformed(np.array([[1, 0, 0, far], [0, 1, 0, 0], [0, 0, 1, rng.uniform(-1, 1)]]))


def beyond(made, patches):
    """How far points are outside the box of other patches, by its diagonal."""
    points = made.evaluate_grid(*(np.linspace(*domain, 25) for domain in made.domain)).reshape(-1, 3)
    nets = np.concatenate([np.asarray(patch.points).reshape(-1, 3) for patch in patches])
    low, high = nets.min(0), nets.max(0)
    return np.maximum(low - points, points - high).max() / np.linalg.norm(high - low)


def test_matched_and_blended_patches_stay_near(inputs):
    made_count = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([5, seed])
        a, b = neighbors(rng)
        continuity = str(rng.choice(["G1", "G2", "G3"]))
        scale = 10**rng.uniform(-12, 9)
        matched = build.match_patch(b, 'u_start', a, 'u_end', continuity)
        assert beyond(matched.value, [a, b]) <= 1.0, seed
        larger = build.match_patch(b.transformed(np.eye(3) * scale), 'u_start', a.transformed(np.eye(3) * scale), 'u_end', continuity)
        assert abs(larger.error / scale - matched.error) <= 1e-6 * matched.error, seed
        seam = sc.seam_continuity(a, 'u_end', matched.value, 'u_start')
        assert seam.gap <= 1e-9 and seam.angle <= 1e-4, seed
        try:
            blend = build.blend_patches(a, 'u_end', b, 'u_start', continuity)
        except sc.InvalidShape as error:
            assert "weights" in str(error), seed
            continue
        made_count += 1
        assert beyond(blend, [a, b]) <= 1.5, seed
    assert made_count > 0.6 * inputs(1000)


def test_a_long_patch_goes_on_from_a_short_sharp_one():
    """Its rows come nearer to the side instead: at its own speed they would shoot far out."""
    bend = [(0, 0), (0.1, 0.1), (0.2, -0.1), (0.3, 0.1), (0.4, 0)]
    short = sc.BezierPatch([[(x, y, z) for y in (0, 1)] for x, z in bend])
    long = sc.BezierPatch([[(x, y, 0) for y in (0, 1)] for x in (0.4, 4, 8, 12)])
    for continuity in ("G2", "G3"):
        made = build.match_patch(long, 'u_start', short, 'u_end', continuity).value
        assert np.abs(made.evaluate_grid(np.linspace(0, 1, 101), [0, 1])[..., 2]).max() <= 2
        assert sc.seam_continuity(short, 'u_end', made, 'u_start').curvature_difference <= 1e-6
