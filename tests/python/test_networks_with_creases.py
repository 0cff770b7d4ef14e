"""Networks of curves that are as smooth as their knots let them be: the surface has knots where they have, so that few do."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def knots_of(rng, degree):
    inner = np.sort(rng.uniform(0.15, 0.85, 3))
    inner = np.sort(np.r_[inner, inner[0] + 10.0**rng.uniform(-12, -5)])
    return np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)], len(inner) + degree + 1


def bent_patch(rng, degree):
    """Rational, with weights that no curve across makes polynomial."""
    (along, n), (across, m) = knots_of(rng, degree), knots_of(rng, degree)
    net = np.stack([*np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, m), indexing="ij"), rng.normal(0, 0.05, (n, m))], -1)
    return sc.NurbsPatch((degree, degree), (along, across), net, 10 ** rng.uniform(-0.2, 0.2, (n, m)))


@pytest.mark.parametrize("degree", [2, 3])
def test_curves_are_met_with_few_knots(degree, inputs):
    """Where knots nearly coincide even spans would need to be as short as the square root of the tolerance: 917 of them."""
    counts = []
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, degree, 61])
        patch = bent_patch(rng, degree)
        shares = [np.linspace(0, 1, count) ** rng.uniform(0.7, 1.4) for count in rng.integers(2, 5, 2)]
        scale = 10**rng.uniform(-9, 6)
        along_u = [patch.isocurve("v", v).transformed(scale * np.eye(3)) for v in shares[1]]
        along_v = [patch.isocurve("u", u).transformed(scale * np.eye(3)) for u in shares[0]]
        made = build.network(along_u, along_v, tolerance=1e-5 * scale)
        assert made.error <= 1e-5 * scale, seed
        for curve in [*along_u, *along_v]:
            points = curve.evaluate(np.linspace(*curve.domain, 31))
            assert made.value.nearest(points).distances.max() <= made.error / 0.98 + 1e-12 * scale, seed
        counts += made.value.points.shape[:2]
    print("\nC", degree, np.median(counts), max(counts))
    assert max(counts) <= 300
