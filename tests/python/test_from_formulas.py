"""Curves and patches from formulas: exact for polynomials, within the tolerance for anything else."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import splinecore as sc

NAN, INF = float("nan"), float("inf")


def distance(curve, formulas, count=20_000):
    """The largest one at random parameters."""
    t = np.random.default_rng(1).uniform(*curve.domain, count)
    wanted = np.stack([formula.evaluate(t) for formula in formulas], axis=-1)
    return np.linalg.norm(curve.evaluate(t)[:, :len(formulas)] - wanted, axis=1).max()


def test_a_twisted_cubic_is_exact():
    curve, error = sc.build.curve_from_formulas(["t", "t^2", "t^3"], (0, 1))
    assert error == 0 and curve.degree == 3 and curve.domain == (0, 1)
    assert np.allclose(curve.points, [(0, 0, 0), (1 / 3, 0, 0), (2 / 3, 1 / 3, 0), (1, 1, 1)], rtol=0, atol=1e-16)


def test_the_result_is_a_value_with_its_error():
    found = sc.build.curve_from_formulas(["t", "sin(t)"], (0, 3))
    assert isinstance(found, sc.Approximation)
    assert [found.value, found.error] == list(found)
    assert repr(found) == f"Approximation(value={found.value!r}, error={found.error!r})"


@given(st.lists(st.lists(st.integers(-5, 5), min_size=1, max_size=7), min_size=2, max_size=3),
       st.floats(-10, 10), st.floats(0.1, 10))
def test_polynomials_are_exact_on_any_domain(coefficients, start, length):
    texts = ["+".join(f"({c})*t^{k}" for k, c in enumerate(row)) for row in coefficients]
    curve, error = sc.build.curve_from_formulas(texts, (start, start + length))
    t = np.linspace(*curve.domain, 20)
    wanted = np.stack([np.polynomial.polynomial.polyval(t, np.array(row, float)) for row in coefficients], axis=-1)
    size = max(max(abs(curve.domain[0]), abs(curve.domain[1]), 1) ** 6 * 5, 1)
    assert error == 0 and np.abs(curve.evaluate(t)[:, :len(texts)] - wanted).max() < 1e-13 * size


@pytest.mark.parametrize("texts, domain", [
    (["cos(t)", "sin(t)", "t/5"], (0, 100 * math.pi)), (["t", "exp(t)"], (-3, 3)), (["t", "1/(1+25*t^2)"], (-1, 1)),
    (["t", "sqrt(t)"], (0, 1)), (["t", "abs(t - 0.3)"], (0, 1)), (["cos(t)^3", "sin(t)^3"], (0, 2 * math.pi)),
    (["t - sin(t)", "1 - cos(t)"], (0, 20)), (["t", "t^t"], (0, 2))])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-7])
def test_a_fit_lies_within_the_tolerance(texts, domain, tolerance):
    curve, error = sc.build.curve_from_formulas(texts, domain, tolerance=tolerance)
    formulas = [sc.Formula(text) for text in texts]
    assert 0 < error <= tolerance and curve.degree == 5
    assert distance(curve, formulas) <= min(tolerance, 1.1 * error + 1e-9)


@settings(max_examples=40)
@given(st.floats(0.1, 30), st.floats(-3, 3), st.floats(0.1, 5), st.floats(-8, -1))
def test_spirals_of_any_size(frequency, growth, length, digits):
    constants = {"f": frequency, "g": growth}
    texts = ["exp(g*s)*cos(f*s)", "exp(g*s)*sin(f*s)", "s"]
    tolerance = 10**digits * math.exp(abs(growth) * length)
    curve, error = sc.build.curve_from_formulas(texts, (-length, length), tolerance=tolerance, variable="s",
                                          constants=constants)
    formulas = [sc.Formula(text, variables=("s",), constants=constants) for text in texts]
    assert error <= tolerance and distance(curve, formulas, 2000) <= tolerance


def test_formulas_and_texts_can_be_mixed():
    radius = sc.Formula("r*cos(a)", variables=("a",), constants={"r": 2})
    curve, _ = sc.build.curve_from_formulas([radius, "2*sin(t)"], (0, 6), tolerance=1e-9)
    assert np.abs(np.linalg.norm(curve.evaluate(np.linspace(0, 6, 99)), axis=1) - 2).max() < 1e-9


def test_a_thousand_turns_need_few_points():
    curve, _ = sc.build.curve_from_formulas(["cos(t)", "sin(t)", "t/5"], (0, 2000 * math.pi), tolerance=1e-4)
    assert len(curve.points) < 50_000


@pytest.mark.parametrize("text", ["1/(t - 0.3)", "tan(3*t)", "sign(t)", "sign(t - 0.3)", "floor(2*t)"])
def test_poles_and_jumps_cannot_be_followed(text):
    with pytest.raises(sc.ToleranceNotReached, match="t = "):
        sc.build.curve_from_formulas(["t", text], (-1, 1))


REFUSED = [
    (lambda: sc.build.curve_from_formulas(["t", "1/t"], (-1, 1)), "'1/t' has no finite value at t = 0"),
    (lambda: sc.build.curve_from_formulas(["t", "log(t)"], (-1, 1)), r"'log\(t\)' has no finite value at t = -1"),
    (lambda: sc.build.curve_from_formulas(["t"], (0, 1)), "formulas has 1 of them"),
    (lambda: sc.build.curve_from_formulas(["t"] * 4, (0, 1)), "formulas has 4 of them"),
    (lambda: sc.build.curve_from_formulas(["t", "2t"], (0, 1)), r"formulas\[1\]: an operator.* at character 1$"),
    (lambda: sc.build.curve_from_formulas(["t", "u"], (0, 1)), r"formulas\[1\]: unknown name 'u' at character 0$"),
    (lambda: sc.build.curve_from_formulas(["t", sc.Formula("u*v", variables=("u", "v"))], (0, 1)),
     r"formulas\[1\] has 2 variables"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (1, 0)), r"domain = \[1, 0\] does not increase"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (1, 1)), r"domain = \[1, 1\] does not increase"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, NAN)), "domain = .* is not finite"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (-INF, 0)), "domain = .* is not finite"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (-1e308, 1e308)), "domain = .* overflows"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1, 2)), "domain has 3 values"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance=0), "tolerance = 0 "),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance=-1), "tolerance = -1 "),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance=NAN), "tolerance = nan"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance=INF), "tolerance = inf"),
    (lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), variable="sin"), "name of a function"),
    (lambda: sc.build.patch_from_formulas(["u", "v"], (0, 1), (0, 1)), "formulas has 2 of them"),
    (lambda: sc.build.patch_from_formulas(["u", "v", "t"], (0, 1), (0, 1)), r"formulas\[2\]: unknown name 't'"),
    (lambda: sc.build.patch_from_formulas(["u", "v", sc.Formula("t")], (0, 1), (0, 1)), r"formulas\[2\] has 1 variable"),
    (lambda: sc.build.patch_from_formulas(["u", "v", "0"], (0, 1), (1, 0)), "domain_v"),
    (lambda: sc.build.patch_from_formulas(["u", "v", "0"], (INF, 1), (0, 1)), "domain_u"),
    (lambda: sc.build.patch_from_formulas(["u", "v", "0"], (0, 1), (0, 1), tolerance=0), "tolerance = 0"),
    (lambda: sc.build.patch_from_formulas(["u", "v", "1/(u - v)"], (0, 1), (0, 1)), "has no finite value at u = 0, v = 0"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_arguments_are_refused(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call", [
    lambda: sc.build.curve_from_formulas("tt", (0, 1)), lambda: sc.build.curve_from_formulas(None, (0, 1)),
    lambda: sc.build.curve_from_formulas(["t", 1], (0, 1)), lambda: sc.build.curve_from_formulas(["t", "t"], None),
    lambda: sc.build.curve_from_formulas(["t", "t"], "01"), lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance="1"),
    lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), variable=None),
    lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), 1e-3),
    lambda: sc.build.curve_from_formulas(["t", "t"], (0, 1), tolerance=None),
    lambda: sc.build.patch_from_formulas(["u", "v", "0"], (0, 1)),
    lambda: sc.build.patch_from_formulas(["u", "v", "0"], (0, 1), (0, 1), variables="uv")])
def test_wrong_types_raise_type_error(call):
    with pytest.raises(TypeError):
        call()


def surface_distance(patch, texts):
    (u0, u1), (v0, v1) = patch.domain
    generator = np.random.default_rng(2)
    u, v = generator.uniform(u0, u1, 5000), generator.uniform(v0, v1, 5000)
    wanted = np.stack([sc.Formula(text, variables=("u", "v")).evaluate(u, v) for text in texts], axis=-1)
    return np.linalg.norm(patch.evaluate(u, v) - wanted, axis=1).max()


def test_a_polynomial_patch_is_exact():
    texts = ["u", "v", "u^2 - v^2"]
    patch, error = sc.build.patch_from_formulas(texts, (-1, 1), (0, 2))
    assert error == 0 and patch.degree == (2, 2) and surface_distance(patch, texts) < 1e-15


@pytest.mark.parametrize("texts, domains", [
    (["(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"], [(0, 2 * math.pi)] * 2),
    (["u", "v", "sin(u)*cos(2*v)"], [(0, 3), (0, 3)]), (["u*cos(v)", "u*sin(v)", "v"], [(0, 1), (0, 12)])])
def test_a_fitted_patch_lies_within_the_tolerance(texts, domains):
    patch, error = sc.build.patch_from_formulas(texts, *domains, tolerance=1e-5)
    assert 0 < error <= 1e-5 and patch.degree == (5, 5) and surface_distance(patch, texts) <= 1e-5
    named, _ = sc.build.patch_from_formulas([text.replace("u", "r") for text in texts], *domains, tolerance=1e-5,
                                      variables=("r", "v"), constants={"k": 1})
    assert named == patch
