"""A homogeneous curve times a polynomial a(t): another curve on the same cone, against products of values and of fractions."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

homogeneous = core("formulas.homogeneous")
Refusal = core("base.failures").Refusal
FACTORS = {"1 + t^2": (1, 0, 1), "t": (0, 1), "t - 1/2": (-0.5, 1), "-2": (-2,), "(t - 1)*(t + 2)*(t - 3)": (6, -5, -2, 1), "t^4 - t": (0, -1, 0, 0, 1),
           "2 - t": (2, -1)}
CURVES = {
    'bezier': sc.BezierCurve([(0, 0), (1, 2), (3, 2), (4, 0)], [1, 2, 0.5, 1]).to_nurbs(),
    'infinite': sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]).to_nurbs(),
    'spans': sc.NurbsCurve(2, [0, 0, 0, 1, 1.5, 1.5, 3, 3, 3], [(0, 0), (1, 2), (3, 1), (4, 4), (5, 0), (6, 1)], [1, 3, -1, 2, 0.5, 1]),
    'unclamped': sc.NurbsCurve(3, range(9), [(0, 0), (1, 2), (3, 1), (4, 4), (5, 0)], [1, 3, 1, 2, 0.5]),
    'periodic': sc.NurbsCurve(2, range(6), [(0, 0), (1, 2), (3, 1), (4, 4), (5, 0)], [1, 3, 1, 2, 0.5], periodic=True),
}


def made(curve, text):
    return homogeneous.multiplied_by(curve, homogeneous.factor_of(sc.Formula(text), curve.domain))


def values(curve, u):
    """(n, 4): homogeneous, by curves of three coordinates that have no weights."""
    rows = curve.homogeneous_points
    plain = [sc.NurbsCurve(curve.degree, curve.knots, columns, periodic=curve.periodic) for columns in (rows[:, :3], np.pad(rows[:, 3:], ((0, 0), (0, 2))))]
    return np.column_stack([plain[0].evaluate(u), plain[1].evaluate(u)[:, 0]])


@pytest.mark.parametrize('text', FACTORS)
@pytest.mark.parametrize('name', CURVES)
def test_each_value_is_multiplied(name, text):
    curve, powers = CURVES[name], FACTORS[text]
    found = made(curve, text)
    assert found.degree == curve.degree + len(powers) - 1 and found.periodic == (curve.periodic and len(powers) == 1)
    assert np.allclose(found.domain, curve.domain)
    u = np.linspace(*curve.domain, 41)
    expected = values(curve, u) * np.polynomial.polynomial.polyval(u, powers)[:, None]
    assert np.allclose(values(found, u), expected, rtol=0, atol=1e-13 * np.abs(expected).max())


@pytest.mark.parametrize('text', FACTORS)
def test_bezier_points_are_those_of_the_product_in_fractions(text):
    rows = [[Fraction(x) for x in row] for row in CURVES['bezier'].homogeneous_points.tolist()]
    powers, n = [Fraction(x) for x in FACTORS[text]], len(rows) - 1
    m = len(powers) - 1
    factor = [sum(Fraction(comb(i, k), comb(m, k)) * powers[k] for k in range(i + 1)) for i in range(m + 1)]
    product = [[sum(Fraction(comb(n, k - i) * comb(m, i), comb(n + m, k)) * factor[i] * rows[k - i][x] for i in range(m + 1) if 0 <= k - i <= n)
                for x in range(4)] for k in range(n + m + 1)]
    assert np.allclose(made(CURVES['bezier'], text).homogeneous_points, np.array(product, dtype=float), rtol=0, atol=2e-14)


def test_the_image_stays_and_one_leaves_all_as_it_is():
    curve = CURVES['bezier']
    assert made(curve, "1") == curve
    u = np.linspace(0, 1, 21)
    for text in ("1 + t^2", "t^4 - 3", "-2"):
        assert np.allclose(made(curve, text).evaluate(u), curve.evaluate(u), atol=1e-12)


def test_where_the_factor_is_zero_the_curve_goes_through_the_origin():
    for text, at in (("t", 0.0), ("t - 1/2", 0.5), ("(1 - t)^2", 1.0)):
        for space in (homogeneous.space_of(1.0, True), homogeneous.space_of(2.0, False)):
            found = made(CURVES['bezier'], text)
            parts = homogeneous.picture(found, space, 0.05, True, True, True, 8)
            upon = next(part.curve for part in parts if part.name == homogeneous.CURVE)
            assert np.allclose(upon.evaluate(at), space.at(np.zeros(4)), atol=1e-12)


@pytest.mark.parametrize('text, message', (("sin(t)", "no polynomial of degree 4"), ("t^5", "no polynomial of degree 4"), ("0", "is 0"), ("t - t", "is 0")))
def test_other_factors_are_refused(text, message):
    with pytest.raises(Refusal, match=message):
        made(CURVES['bezier'], text)
