"""Greville abscissae: means of knots, in fractions; control points on them make the parameter itself."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, random_knots
from splinecore import basis


def exact(knots, degree, periodic):
    """In fractions."""
    knots = [Fraction(float(knot)) for knot in knots]
    if not periodic:
        return [sum(knots[i + 1:i + degree + 1]) / degree for i in range(len(knots) - degree - 1)]
    count, period = len(knots) - 1, knots[-1] - knots[0]
    return [sum(knots[j % count] + period * (j // count) for j in range(i + 1 - degree, i + 1)) / degree for i in range(count)]


@pytest.mark.parametrize("ends", ENDS)
def test_they_are_means_of_knots(ends, inputs):
    for seed in range(inputs(200)):
        rng = np.random.default_rng(seed)
        degree = int(rng.integers(1, 12))
        knots = random_knots(rng, degree, int(rng.integers(1, 6)), ends) * 10.0**rng.uniform(-100, 100)
        vector = basis.KnotVector(degree, knots, ends == 'periodic')
        wanted = exact(knots, degree, ends == 'periodic')
        found = vector.greville
        assert found.shape == (vector.count,) and found.strides == (8,) and (np.diff(found) >= 0).all()
        assert max(abs(Fraction(float(a)) - b) for a, b in zip(found, wanted)) <= Fraction(1, 2**48) * Fraction(float(np.abs(knots).max()))


@pytest.mark.parametrize("ends", ('clamped', 'unclamped'))
def test_points_on_them_make_a_line_by_its_parameter(ends):
    for seed in range(30):
        rng = np.random.default_rng(seed)
        degree = int(rng.integers(1, 9))
        vector = basis.KnotVector(degree, random_knots(rng, degree, 4, ends))
        line = sc.NurbsCurve(degree, vector.knots, np.outer(vector.greville, (1, 2, 3)))
        u = np.linspace(*vector.domain, 40)
        assert np.abs(line.evaluate(u) - np.outer(u, (1, 2, 3))).max() < 1e-12


def test_ends_are_exact_and_degree_0_has_middles():
    vector = basis.KnotVector(3, [0.1] * 4 + [0.7] + [0.9] * 4)
    assert vector.greville[0] == 0.1 and vector.greville[-1] == 0.9
    assert basis.KnotVector(0, [0, 1, 3]).greville.tolist() == [0.5, 2.0]
    assert basis.KnotVector(2, [0, 1, 2, 3], True).greville.tolist() == [-0.5, 0.5, 1.5]
