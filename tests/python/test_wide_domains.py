"""Derivatives over domains of any length are those over [0, 1], times powers of the length."""

import numpy as np
import pytest

import splinecore as sc

U = np.array([0.0, 0.1, 0.3, 0.42, 0.55, 0.9, 1.0])


def knots(degree):
    return np.concatenate([np.zeros(degree + 1), [0.3, 0.55], np.ones(degree + 1)])


def curve(degree, length, size):
    rng = np.random.default_rng(degree)
    return sc.NurbsCurve(degree, knots(degree) * length, rng.normal(size=(degree + 3, 3)) * size,
                         rng.uniform(0.5, 2.0, degree + 3))


def patch(degree, lengths, size):
    rng = np.random.default_rng(degree)
    shape = (degree + 3, degree + 3)
    return sc.NurbsPatch((degree, degree), [knots(degree) * length for length in lengths],
                         rng.normal(size=(*shape, 3)) * size, rng.uniform(0.5, 2.0, shape))


def assert_scaled(found, wanted, exponents):
    """found is wanted times 10^exponents, where that is a normal number."""
    for place in np.ndindex(exponents.shape):
        if abs(exponents[place]) < 290:
            expected = wanted[(slice(None), *place)] * 10.0 ** exponents[place]
            np.testing.assert_allclose(found[(slice(None), *place)], expected, rtol=0, atol=1e-10 * np.abs(expected).max())


# Powers of ten: of the length of the domain, and of the coordinates.
@pytest.mark.parametrize("length, size, order", [(120, 200, 4), (150, 200, 3), (-110, -200, 4), (-150, -250, 3), (60, 0, 4),
                                                 (-60, 0, 4), (-96, 0, 3), (-90, -90, 4)])
@pytest.mark.parametrize("degree", [3, 5, 9])
def test_derivatives_of_a_curve(length, size, order, degree):
    exponents = size - length * np.arange(order + 1)
    wanted = curve(degree, 1.0, 1.0).derivatives(U, order)
    found = curve(degree, 10.0**length, 10.0**size).derivatives(U * 10.0**length, order)
    assert_scaled(found, wanted, exponents)


@pytest.mark.parametrize("lengths, size", [((120, 0), 200), ((0, 120), 200), ((80, 80), 200), ((-70, -70), -290),
                                           ((120, -120), 0), ((-120, 120), 0)])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_derivatives_of_a_patch(lengths, size, order):
    along = np.arange(order + 1)
    exponents = size - lengths[0] * along[:, None] - lengths[1] * along[None, :]
    if exponents.max() > 290:
        with pytest.raises(sc.InvalidShape, match="too large for a number"):
            patch(3, [10.0**one for one in lengths], 10.0**size).derivatives(U * 10.0 ** lengths[0], U * 10.0 ** lengths[1],
                                                                            order)
        return
    wanted = patch(3, (1.0, 1.0), 1.0).derivatives(U, U[::-1].copy(), order)
    found = patch(3, [10.0**one for one in lengths], 10.0**size).derivatives(
        U * 10.0 ** lengths[0], U[::-1] * 10.0 ** lengths[1], order)
    assert_scaled(found, wanted, exponents)


def test_what_is_too_large_is_refused_and_what_is_not_is_there_with_nan():
    short = curve(3, 1e-110, 1.0)
    with pytest.raises(sc.InvalidShape, match="derivative 3 at u = .* is too large for a number"):
        short.derivatives(U * 1e-110, 3)
    found = short.derivatives(U * 1e-110, 3, at_infinity="nan")
    assert np.isfinite(found[:, :3]).all() and np.isnan(found[:, 3]).any()
