"""y = x^k against y = 0: where they touch is known, and found however they are given, at any degree."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial

import splinecore as sc
from test_contacts_of_curves import counts, power_curve
from test_nothing_is_missed import motion

ZERO = Polynomial([0.0])


def scaled(rng):
    factor = 10 ** rng.uniform(-12, 9)
    return np.diag([factor, factor, factor, 1.0])


def far_away(rng):
    moved = motion(rng)
    moved[:3, 3] *= 1e3
    return moved


def knots(rng, curve):
    return curve.refine(np.sort(rng.uniform(*curve.domain, 3)))


WAYS = {
    "plain": lambda rng, a, b: (a, b),
    "moved": lambda rng, a, b: tuple(c.transformed(m) for m in [motion(rng)] for c in (a, b)),
    "far": lambda rng, a, b: tuple(c.transformed(m) for m in [far_away(rng)] for c in (a, b)),
    "scaled": lambda rng, a, b: tuple(c.transformed(m) for m in [scaled(rng)] for c in (a, b)),
    "rational": lambda rng, a, b: (a, b.moebius(rng.uniform(0.3, 3))),
    "elevated": lambda rng, a, b: (a.elevate().elevate(), b),
    "refined": lambda rng, a, b: (knots(rng, a), knots(rng, b)),
    "swapped": lambda rng, a, b: (b, a),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("power", range(2, 10))
def test_a_contact_is_where_the_most_derivatives_are_zero(power, way, inputs):
    """Its stretch is 2 (tolerance)^(1 / power) long: of that it is off by the rounding's part of the tolerance, about."""
    for index in range(inputs(60)):
        rng = np.random.default_rng([index, power, 41])
        start, end = -rng.uniform(0.6, 1.5), rng.uniform(0.6, 1.5)
        x = Polynomial([start, end - start])
        flat = power_curve(x, ZERO, ZERO)
        hill = power_curve(x, x**power * (rng.choice([-1, 1]) * 10 ** rng.uniform(-0.5, 1)), ZERO)
        a, b = WAYS[way](rng, flat, hill)
        found = a.intersections(b)
        assert counts(found) == (1, 0) and found.touches.all(), index
        far = 1e-10 if power == 2 else 1e-9 if power == 3 else 1e-8 if power < 6 else 1e-6
        assert abs(found.parameters[0, 0] - start / (start - end)) < far, index


@pytest.mark.parametrize("power", range(2, 10))
def test_a_contact_at_a_larger_tolerance_is_the_same_place(power, inputs):
    """Where the curve is no power but about the place, and far from even about it."""
    for index in range(inputs(60)):
        rng = np.random.default_rng([index, power, 42])
        x = Polynomial([-1, 2])
        hill = x**power * (1 + rng.uniform(-0.6, 0.6) * x)
        a, b = power_curve(x, ZERO, ZERO), power_curve(x, hill, ZERO)
        for tolerance in 10 ** rng.uniform(-9, -5, 2):
            found = a.intersections(b, tolerance)
            assert counts(found) == (1, 0) and found.touches.all(), index
            assert abs(found.parameters[0, 0] - 0.5) < 1e-6, (index, tolerance)

