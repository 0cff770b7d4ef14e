"""Fits that leave a given residual: the noise, or nothing."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit


@pytest.mark.parametrize("deviation", [1e-3, 0.1, 3.0])
def test_a_residual_is_used_up_and_takes_the_noise_away(deviation, inputs):
    """Noise of a known deviation about a curve: what is left is nearer to the truth than the points are."""
    for seed in range(inputs(20)):
        rng = np.random.default_rng([91, seed])
        t = np.linspace(0, 1, 300)
        truth = 100 * np.c_[t, 0.2 * np.sin(5 * t), 0.1 * t**2]
        points = truth + rng.normal(0, deviation, truth.shape)
        residual = 3 * len(points) * deviation**2
        made = fit.approximate(points, parameters=t, residual=residual).value
        left = ((made.evaluate(t) - points) ** 2).sum()
        assert 0.98 * residual <= left <= residual
        assert ((made.evaluate(t) - truth) ** 2).sum() <= 0.6 * residual
        weighted = fit.approximate(points, 40, parameters=t, residual=4 * residual, weights=np.full(300, 4.0)).value
        assert 0.98 * residual <= ((weighted.evaluate(t) - points) ** 2).sum() <= residual * (1 + 1e-12)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e9])
@pytest.mark.parametrize("far", [0.0, 1e6])
def test_no_residual_goes_through_all_points(scale, far):
    random = np.random.default_rng(5)
    for count in (4, 9, 40):
        points = (random.normal(size=(count, 3)) + far) * scale
        curve = fit.approximate(points, count, parameters=np.linspace(0, 1, count), residual=0).value
        assert np.abs(curve.evaluate(np.linspace(0, 1, count)) - points).max() <= 1e-11 * np.abs(points).max()
    with pytest.raises(sc.ToleranceNotReached):
        fit.approximate(points, 12, parameters=np.linspace(0, 1, 40), residual=0)


def test_a_residual_leaves_ends_free_unless_they_are_asked_for():
    rng = np.random.default_rng(93)
    t = np.linspace(0, 1, 100)
    points = np.c_[t, rng.normal(0, 0.05, 100)]
    free = fit.approximate(points, residual=0.25).value
    fixed = fit.approximate(points, residual=0.25, fixed_ends=True).value
    assert np.linalg.norm(free.evaluate(0.0)[:2] - points[0]) > 1e-3
    assert np.linalg.norm(fixed.evaluate(0.0)[:2] - points[0]) <= 1e-12
    ring = np.c_[np.cos(2 * np.pi * t[:-1]), np.sin(2 * np.pi * t[:-1])] + rng.normal(0, 0.02, (99, 2))
    closed = fit.approximate(ring, residual=99 * 2 * 0.02**2, closed=True).value
    assert closed.periodic and np.abs(np.linalg.norm(closed.evaluate(np.linspace(*closed.domain, 200)), axis=1) - 1).max() < 0.03
    assert fit.approximate(points, residual=1e9).value.curvature(np.linspace(0.05, 0.95, 9)).max() < 1e-2


def test_residuals_that_cannot_be_are_refused():
    points = np.random.default_rng(95).normal(size=(20, 2))
    with pytest.raises(sc.ToleranceNotReached):
        fit.approximate(points, 6, residual=1e-3)
    for more in ({"residual": -1}, {"residual": np.nan}, {"residual": 1, "tolerance": 1}, {"residual": 1, "smoothing": 1},
                 {"residual": 1, "corrections": 2}):
        with pytest.raises(sc.InvalidShape):
            fit.approximate(points, 10, **more)
