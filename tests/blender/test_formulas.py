"""Formulas as Text: what is printed, read again by a parser of its own, is the shape."""

import re
from fractions import Fraction

import bpy
import numpy as np
import pytest

import patches
from shapes import activate, add
from support import part, splinecore as sc

formulas = part('core.formulas.formulas')
EPS = np.finfo(float).eps
_NUMBER = r"\d[\d.]*(?:e[-+]?\d+)?(?:/\d+)?"
_TERM = re.compile(rf"([-+]?) ?({_NUMBER})?((?: ?[stuv](?:\^\d+)?)*)$")
_SPAN = re.compile(r"  on \[(\S+), (\S+)\](?: x \[(\S+), (\S+)\])?")


def value_of(text):
    return float(Fraction(text))


def polynomial(text, variables):
    """{exponents of variables: coefficient} of a printed sum."""
    found = {}
    for term in re.split(r" (?=[-+] )", text):
        match = _TERM.match(term)
        assert match and term, term
        sign, size, names = match.groups()
        assert size or names, term
        powers = dict.fromkeys(variables, 0)
        for name in names.split():
            letter, _, exponent = name.partition("^")
            powers[letter] += int(exponent or 1)
        key = tuple(powers[letter] for letter in variables)
        assert key not in found, term
        found[key] = value_of(size or "1") * (-1 if sign == "-" else 1)
    return found


def spans_of(text):
    """[(intervals, {axis: {variables: sum}})] of the power basis as printed, by lines."""
    lines = text[text.index("Power basis, "):].split("\n\n")[0].split("\n")[1:]
    found = []
    for line in lines:
        match = _SPAN.match(line)
        if match:
            found.append(([value_of(each) for each in match.groups() if each], {}))
        else:
            name, _, written = line.strip().partition(" = ")
            found[-1][1][name] = written
    return found


def evaluated(sums, *local):
    """(axes, n) values of printed sums, at numbers from the starts of a span."""
    names = ["u", "v"] if len(local) == 2 else ["t"]

    def at(written):
        text = written.replace("s", "u").replace("t", "v") if len(local) == 2 else re.sub("[su]", "t", written)
        return sum(c * np.prod([x ** k for x, k in zip(local, powers)], axis=0) for powers, c in polynomial(text, names).items()) \
            + np.zeros(len(local[0]))
    return {axis: at(written) for axis, written in sums.items()}


def require_same(found, exact, size, extent, degree):
    """That printed coordinates are those of points (n, 3), where they are not near infinity."""
    weight = found.get("W", np.ones(len(exact)))
    near = np.isfinite(exact).all(1) & (np.abs(weight) > 1e-3 * np.abs(weight).max())
    assert near.any()
    points = np.column_stack([found.get(upper, found.get(upper.lower())) for upper in "XYZ"])
    gap = np.abs(points[near] - weight[near, None] * exact[near]).max() / np.abs(weight).max()
    assert gap <= 1e-9 * extent + 100 * 3 ** degree * EPS * size, (gap, extent, size)


def check_curve(curve, position=0.5):
    text = formulas.text(curve, position)
    start = text.index("Power basis")
    assert start > 0 and text == formulas.text(curve, position)
    spans = spans_of(text)
    points = curve.points
    for (start, end), sums in spans:
        local = np.linspace(0.0, end - start, 7)[1:-1]
        exact = curve.evaluate(start + local, at_infinity='nan')
        require_same(evaluated(sums, local), exact, np.abs(points).max(), np.ptp(points, axis=0).max(), curve.degree)
    return text, spans


def random_points(seed, count, scale=1.0, origin=0.0):
    return np.random.default_rng(seed).uniform(-1, 1, (count, 3)) * scale + origin


KNOTS = {
    'clamped': lambda p, n: ([0] * (p + 1) + sorted(np.random.default_rng(n).integers(1, 9, n - p - 1).tolist()) + [9] * (p + 1), False),
    'unclamped': lambda p, n: (np.cumsum(np.random.default_rng(n).uniform(0.1, 1, n + p + 1)), False),
    'uniform': lambda p, n: (np.arange(n + p + 1) / 3, False),
    'periodic': lambda p, n: (np.cumsum(np.random.default_rng(p).uniform(0.1, 1, n + 1)), True)}


@pytest.mark.parametrize('knots', KNOTS)
@pytest.mark.parametrize('degree', (1, 2, 3, 9))
@pytest.mark.parametrize('scale, origin', ((1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e6), (1e-3, 1e9)))
def test_the_power_basis_as_printed_is_the_curve(knots, degree, scale, origin):
    values, periodic = KNOTS[knots](degree, degree + 3)
    if knots == 'clamped':              # no knot more often than the degree
        values = sorted(set(values[degree + 1:-degree - 1]))
        values = [0] * (degree + 1) + values + [9] * (degree + 1)
    count = len(values) - (1 if periodic else degree + 1)
    curve = sc.NurbsCurve(degree, values, random_points(degree, count, scale, origin), periodic=periodic)
    text, spans = check_curve(curve)
    assert len(spans) == len(np.unique(np.array(values)[degree:len(values) - degree])) - 1 or periodic
    assert curve.is_rational or "W =" not in text


@pytest.mark.parametrize('weights', ([1, -1, 1, 2], [1, 0, 1, 1], [-1, -2, -1, -1], [1e-6, 1, 1e6, 1], [1 / 3, 2 / 3, 1, 1]))
@pytest.mark.parametrize('scale, origin', ((1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)))
def test_rational_curves_are_printed_as_they_are(weights, scale, origin):
    points = random_points(7, 4, scale, origin)
    check_curve(sc.BezierCurve(points, weights))
    check_curve(sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], points, weights))


@pytest.mark.parametrize('scale, origin', ((1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)))
def test_hermite_chains_are_hermite(scale, origin):
    tangents = random_points(1, 8, scale).reshape(4, 2, 3)
    text, _ = check_curve(sc.HermiteCurve(random_points(2, 4, scale, origin), tangents, [0, 0.1, 2, 7 / 3]))
    assert text.startswith("Hermite chain of degree 3 of 3 segments") and "NURBS" not in text and "Bezier matrix" not in text
    assert "R1 before" in text and "R1 after" in text and "Hermite functions at" in text
    assert matrix_after(text, "Hermite matrix M_H", 2).tolist() == [[2, 1, -2, 1], [-3, -2, 3, -1], [0, 1, 0, 0], [1, 0, 0, 0]]


def matrix_after(text, name, skipped=1):
    """The matrix that is printed below a line with a name."""
    lines = text[text.index(name):].split("\n")[skipped:]
    factor = Fraction(1)
    if lines[0].strip().endswith("times"):
        factor, lines = Fraction(lines[0].split()[0]), lines[1:]
    size = len(lines[0].split())
    return np.array([[float(Fraction(word) * factor) for word in line.split()] for line in lines[:size]])


def test_matrices_of_uniform_splines_are_fractions():
    text = formulas.text(sc.NurbsCurve(3, range(10), random_points(1, 6)), 0.5)
    lines = [line.strip() for line in text.split("\n")]
    at = lines.index("uniform B-spline matrix on [3, 4] of P0 to P3, [4, 5] of P1 to P4, [5, 6] of P2 to P5:")
    assert lines[at + 1:at + 6] == ["1/6 times", "-1   3  -3   1", "3  -6   3   0", "-3   0   3   0", "1   4   1   0"]
    assert lines[at + 7:at + 12] == ["1/6 times", "1  4  1  0", "0  4  2  0", "0  2  4  0", "0  1  4  1"]
    for degree in range(1, 10):
        text = formulas.text(sc.NurbsCurve(degree, range(2 * degree + 2), random_points(1, degree + 1)), 0.5)
        assert np.allclose(matrix_after(text, "uniform B-spline matrix" if degree > 1 else "Bezier matrix"), sc.basis.uniform_matrix(degree), rtol=1e-15, atol=0)


@pytest.mark.parametrize('knots', ([0, 0, 0, 0, 1, 1, 2, 2, 2, 2], [0, 0, 0, 0, 0.1, 3 ** 0.5, 2, 2, 2, 2], [0, 1, 2, 4, 8, 9, 10, 10, 11, 13]))
def test_every_segment_has_its_matrix(knots):
    curve = sc.NurbsCurve(3, knots, random_points(3, 6))
    text = formulas.text(curve, 0.5)
    heads = re.findall(r"matrix on (.*):\n", text)
    found = [(value_of(a), value_of(b), int(i)) for head in heads for a, b, i in re.findall(r"\[(\S+), (\S+)\] of P(\d+) to", head)]
    assert len(found) == len(np.unique(knots[3:-3])) - 1
    for head in heads:
        matrix = matrix_after(text, f"matrix on {head}:")
        for a, b, first in [each for each in found if f"of P{each[2]} to" in head]:
            t = np.linspace(0, 1, 5)
            points = np.vander(t, 4) @ matrix @ curve.points[first:first + 4]
            u = np.minimum(a + t * (b - a), np.nextafter(b, a))
            assert np.allclose(points, curve.evaluate(u), rtol=0, atol=1e-8)


def test_numbers_that_are_rounding_are_zero_and_small_ones_are_not():
    third = sc.BezierCurve([(-1, 1e9, 1e-12), (-1 / 3, 1e9 + 1 / 3, 0), (1 / 3, 1e9 + 2 / 3, 0), (1, 1e9 + 1, 0)])
    text = formulas.text(third, 0.5)
    assert "    x = -1 + 2 t\n    y = 1000000000 + t\n" in text and "\n    z = 1e-12 - 3e-12 t + 3e-12 t^2 - 1e-12 t^3\n" in text
    turned = sc.BezierCurve([(0, 0), (1, 1), (2, 2)]).elevate(3)
    angle = np.sqrt([0.1, 0.9])
    points = turned.points[:, :2] @ np.array([[angle[0], angle[1]], [-angle[1], angle[0]]]) + 0.1
    spans = spans_of(formulas.text(sc.BezierCurve(points), 0.5))
    assert all("t^" not in written for written in spans[0][1].values())


def test_de_boors_numbers_and_both_coefficients_of_basis_functions():
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 3, 3, 3], [(0, 0, 0), (1, 3, 0), (2, 0, 0), (3, 3, 0), (4, 0, 0)])
    text = formulas.text(curve, 0.5)
    assert "  N1,2 = 1/8" in text.replace("0.125", "1/8") and "de Boor's algorithm at u = 1.5" in text
    fed = re.findall(rf"  N(\d),(\d) = \(({_NUMBER})\) N\d,\d \+ \(({_NUMBER})\) N\d,\d", text)
    known = curve.knot_vector.knots
    for i, degree, left, right in fed:
        i, degree = int(i), int(degree)
        assert value_of(left) == (1.5 - known[i]) / (known[i + degree] - known[i])
        assert value_of(right) == (known[i + degree + 1] - 1.5) / (known[i + degree + 1] - known[i + 1])
    assert len(fed) == 5
    last = text[text.index("de Boor's"):].split("\n\n")[0].split("\n")[-1]
    assert last.split("(")[1].split(")")[0] == "2, 0.75, 0"
    assert np.allclose(curve.evaluate([1.5])[0], (2, 0.75, 0))


@pytest.mark.parametrize('position', (0.0, 0.3, 0.999, 1.0))
@pytest.mark.parametrize('knots', KNOTS)
def test_de_boor_ends_in_the_point(knots, position):
    values, periodic = KNOTS[knots](3, 7)
    count = len(values) - (1 if periodic else 4)
    curve = sc.NurbsCurve(3, values, random_points(5, count), periodic=periodic)
    text = formulas.text(curve, position)
    start, end = curve.domain
    point = curve.evaluate([start + position * (end - start)], side='left' if position == 1.0 else 'right')[0]
    for name in ("de Boor's", "de Casteljau"):
        last = text[text.index(name):].split("\n\n")[0].split("\n")
        last = next(line for line in reversed(last) if line.startswith("  3:"))
        assert np.allclose([value_of(each) for each in re.search(r"\((-?\d[^)]*)\)", last)[1].split(", ")], point, rtol=0, atol=1e-9)


def check_patch(patch):
    text = formulas.text(patch, 0.5)
    spans = spans_of(text)
    points = np.asarray(patch.points)
    for (a, b, c, d), sums in spans:
        s, t = (each.ravel() for each in np.meshgrid(np.linspace(0, b - a, 5)[1:-1], np.linspace(0, d - c, 5)[1:-1]))
        exact = np.array([patch.evaluate(a + x, c + y, at_infinity='nan') for x, y in zip(s, t)]).reshape(-1, 3)
        require_same(evaluated(sums, s, t), exact, np.abs(points).max(), np.ptp(points.reshape(-1, 3), axis=0).max(), sum(patch.degree))
    return text, spans


@pytest.mark.parametrize('scale, origin', ((1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e6)))
def test_patches_are_printed_as_they_are(scale, origin):
    def grid(seed, *size):
        return random_points(seed, size[0] * size[1], scale, origin).reshape(*size, 3)
    bezier, _ = check_patch(sc.BezierPatch(grid(1, 4, 3)))
    assert bezier.startswith("Bezier patch of degree 3 x 2, 4 x 3 control points") and bezier.count("Bezier matrix") == 2
    check_patch(sc.BezierPatch(grid(1, 3, 3), np.array([[1, -1, 2], [1, 0, 1], [2, 1, 1 / 3]])))
    _, spans = check_patch(sc.NurbsPatch((3, 2), ([0, 1, 2, 3, 4, 5.5, 6, 7, 8], [0, 0, 0, 1 / 3, 2, 2, 2]), grid(2, 5, 4)))
    assert len(spans) == 4
    check_patch(sc.NurbsPatch((2, 1), ([0, 1, 2, 4, 5], [0, 0, 1, 1]), grid(3, 4, 2), periodic=(True, False)))
    flat = [random_points(seed, 6, scale).reshape(2, 3, 3) for seed in (4, 5, 6)]
    hermite, _ = check_patch(sc.HermitePatch(grid(7, 2, 3), *flat, parameters=([0, 2], [0, 1, 1.5])))
    assert hermite.count("Hermite matrix M_H") == 2 and "Twists T_i,j" in hermite


def test_what_is_too_long_is_said():
    rng = np.random.default_rng(1)
    many = sc.NurbsCurve(2, range(33), random_points(1, 30))
    assert "  and 12 spans more" in formulas.text(many, 0.5)
    uneven = sc.NurbsCurve(2, np.cumsum(rng.uniform(0.1, 1, 33)), random_points(1, 30))
    assert "  and 18 matrices more" in formulas.text(uneven, 0.5)
    assert "Formulas are written up to degree 30: this is degree 31" in formulas.text(sc.BezierCurve(random_points(1, 32)), 0.5)
    assert "Matrices are written up to degree 9: this is degree 12" in formulas.text(sc.BezierCurve(random_points(1, 13)), 0.5)
    high = sc.BezierPatch(random_points(1, 25).reshape(5, 5, 3))
    assert "The power basis is written for at most 16 terms: here are 25" in formulas.text(high, 0.5)


@pytest.mark.parametrize('name', sorted({*patches.MORE, 'bicubic'}))
def test_the_operator_writes_those_of_every_patch(name):
    ob = add(patches.value_of(name), "patch")
    activate(ob)
    assert bpy.ops.splinewright.write_formulas() == {'FINISHED'}
    text = bpy.data.texts["patch Formulas"].as_string()
    assert " patch of degree " in text and "Along v:" in text
