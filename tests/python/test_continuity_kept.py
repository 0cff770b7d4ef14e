"""Blends and matches of any patches, knots, degrees, weights and sizes go on as they say, and alike after a motion, or are refused."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SIDES = ("u_start", "u_end", "v_start", "v_end")


def knots_of(rng, degree):
    inner = np.sort(rng.uniform(0.01, 0.99, int(rng.integers(0, 4))))
    if len(inner) > 1 and rng.random() < 0.4:
        inner[1] = inner[0] + 10.0 ** rng.uniform(-12, -3)
    return np.r_[[0] * (degree + 1), np.sort(np.minimum(inner, 0.99)), [1] * (degree + 1)], len(inner) + degree + 1


def wild_patch(rng, size):
    degrees = [int(rng.integers(1, rng.choice([4, 16]))) for _ in range(2)]
    (along, n), (across, m) = (knots_of(rng, degree) for degree in degrees)
    flat = np.stack([*np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, m), indexing="ij"), np.zeros((n, m))], -1)
    points = flat + rng.normal(0, rng.choice([0, 0.05, 0.3]), flat.shape)
    points = (points @ np.linalg.qr(rng.normal(size=(3, 3)))[0] + rng.normal(0, 2, 3)) * size
    kind = int(rng.integers(3))
    weights = (None, np.exp(rng.normal(0, rng.choice([0.3, 2]), (n, m))), np.full((n, m), 10.0 ** rng.uniform(-3, 3)))[kind]
    return sc.NurbsPatch(degrees, (along, across), points, weights)


def blended(a, side_a, b, side_b, word):
    return build.blend_patches(a, side_a, b, side_b, word), ((a, side_a, "v_start"), (b, side_b, "v_end"))


def matched(a, side_a, b, side_b, word):
    return build.match_patch(a, side_a, b, side_b, word).value, ((b, side_b, side_a),)


def grid(patch):
    return patch.evaluate_grid(*(np.linspace(*domain, 9) for domain in patch.domain)).reshape(-1, 3)


@pytest.mark.parametrize("made_of", [blended, matched])
def test_what_is_said_is_kept(made_of, inputs):
    rng = np.random.default_rng(31)
    wanted = inputs(1000)
    kept = 0
    for _ in range(wanted):
        size = 10.0 ** rng.uniform(-12, 9)
        a, b = wild_patch(rng, size), wild_patch(rng, size)
        side_a, side_b, word = str(rng.choice(SIDES)), str(rng.choice(SIDES)), str(rng.choice(["G1", "G2"]))
        motion = np.c_[np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.normal(size=3) * size]
        try:
            made, seams = made_of(a, side_a, b, side_b, word)
        except sc.InvalidShape as error:
            assert "weights" in str(error) or "stands still" in str(error)
            continue
        except sc.ToleranceNotReached as error:
            assert "so exactly" in str(error)
            continue
        kept += 1
        for other, side, own in seams:
            seam = sc.seam_continuity(made, own, other, side, tolerance=2e-3)
            assert seam.gap <= 1e-6 * size and seam.angle <= 1e-4
            assert word == "G1" or seam.g != 1
        try:
            there = made_of(a.transformed(motion), side_a, b.transformed(motion), side_b, word)[0]
        except sc.ToleranceNotReached:
            continue
        points = grid(made.transformed(motion))
        assert np.abs(grid(there) - points).max() <= 1e-6 * np.ptp(points, axis=0).max()
    assert kept >= 0.4 * wanted
