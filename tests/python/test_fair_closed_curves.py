"""Fairing closed curves of few points and high degrees, whose functions go round more than once: what comes out is the minimum that
fairing asks for, and that of the curve run through backwards."""

import numpy as np

import splinecore as sc


def closed(rng):
    degree, count = int(rng.integers(2, 11)), int(rng.integers(1, 6))
    distinct = np.sort(rng.uniform(0.1, 0.9, int(rng.integers(0, count))))
    start = int(rng.integers(1, min(degree, count - len(distinct)) + 1)) if count > len(distinct) else 1
    knots = np.r_[[0.0] * start, distinct, 1.0]
    return sc.NurbsCurve(degree, knots * 10**rng.uniform(-2, 2), rng.normal(size=(len(knots) - 1, 3)), periodic=True)


def products(curve):
    """Integrals of products of the functions, and of their second derivatives."""
    knots, count = np.unique(curve.knots), len(curve.points)
    nodes, weights = np.polynomial.legendre.leggauss(curve.degree + 1)
    plain, bent = np.zeros((2, count, count))
    for start, end in zip(knots[:-1], knots[1:]):
        u, w = (start + end) / 2 + nodes * (end - start) / 2, weights * (end - start) / 2
        jets = np.stack([curve.with_points(np.outer(unit, [1, 0, 0])).derivatives(u, 2)[:, :, 0] for unit in np.eye(count)], -1)
        plain += jets[:, 0].T * w @ jets[:, 0]
        bent += jets[:, 2].T * w @ jets[:, 2]
    return plain, bent


def test_what_is_faired_is_the_minimum(inputs):
    """Of three points and degrees from 6 on it was not, by up to a hundredth of what they moved."""
    made = 0
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, 911])
        curve = closed(rng)
        size = np.ptp(curve.points, axis=0).max()
        if size == 0:
            continue
        tolerance = float(size * 10**rng.uniform(-4, -1))
        try:
            found = curve.fair(tolerance)
        except sc.InvalidShape:
            continue
        if found.error < 0.5 * tolerance:
            continue
        made += 1
        plain, bent = products(curve)
        moved, force = plain @ (found.value.points - curve.points), bent @ found.value.points
        factor = -(moved * force).sum() / (force * force).sum()
        assert np.abs(moved + factor * force).max() <= 1e-6 * np.abs(moved).max(), seed
        back = curve.reversed().fair(tolerance).value.reversed().with_domain(curve.domain)
        assert back.largest_distance(found.value) <= 0.004 * tolerance, seed
    assert made > 0.3 * inputs(400)
