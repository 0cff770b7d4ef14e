"""The triangular scheme of basis functions as a picture and as text: places, coefficients, supports and wedges against the recursion itself."""

from itertools import pairwise

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

signs, triangle = core("formulas.signs"), core("formulas.triangle_picture")
formulas = core("formulas.formulas")
Refusal = core("base.failures").Refusal
KNOTS = ((1, [0, 1, 2, 3]), (2, [0, 1, 2, 3]), (3, range(8)), (3, [0, 0, 0, 0, 1, 3, 3, 4, 4, 4, 4]), (2, [0, 0, 0, 0, 1, 2]),
         (4, [-2, -1.5, 0, 0, 0, 0.25, 7, 7, 7, 7, 7, 9]))


def picture(degree, knots, chosen=(), is_support=False, spans=(), down=0.6):
    return triangle.picture(triangle.scheme(degree, list(knots), 1.0, down), chosen, is_support, spans, 0.05)


def marks(parts):
    """{text: place}"""
    return {part.name.partition(" ")[2]: signs.place_of(part.name, part.curve.points) for part in parts if part.name.startswith(signs.MARK)}


def links(parts, name):
    """{((i, degree), (i, degree))} by where arrows point."""
    found = set()
    for part in parts:
        if part.name == name and len(part.curve.points) == 10 and not np.array_equal(part.curve.points[0], part.curve.points[-1]):
            start, tip = part.curve.points[:2]
            along = (tip - start) / (1.0 - 2.0 * 0.22)
            ends = [start - 0.22 * along, start - 0.22 * along + along]
            found.add(tuple((round(-end[1] / 0.6 - end[0] / 2), round(end[0])) for end in ends))
    return found


@pytest.mark.parametrize('degree, knots', KNOTS)
def test_every_function_has_its_place_and_arrows_from_those_that_feed_it(degree, knots):
    knots = list(knots)
    parts = picture(degree, knots)
    expected, fed = {}, set()
    for level in range(degree + 1):
        for i in range(len(knots) - level - 1):
            is_zero = knots[i] == knots[i + level + 1]
            expected[f"N_{{{i},{level}}}" + (" = 0" if is_zero else "")] = (level, -0.6 * (i + level / 2))
            fed |= {((j, level - 1), (i, level)) for j in (i, i + 1) if level and knots[j] < knots[j + level]}
    found = marks(parts)
    assert set(found) == set(expected)
    assert all(np.allclose(found[name][:2], place) for name, place in expected.items())
    assert links(parts, triangle.LINK) == fed
    assert [part.name for part in parts if part.name.startswith("tick")] == [f"tick [{a:.6g}, {b:.6g})" for a, b in pairwise(knots)]


@pytest.mark.parametrize('degree, knots', KNOTS)
def test_coefficients_at_both_parents_are_those_of_the_recursion(degree, knots):
    knots = np.array(knots, float)
    for i in range(len(knots) - degree - 1):
        parts = picture(degree, knots, [(i, degree)])
        texts = [text for text in marks(parts) if not text.startswith("N_")]
        for u in np.linspace(knots[0], knots[-1], 11):
            left, right = (0.0 if a == b else (u - a) / (b - a) if sign > 0 else (b - u) / (b - a) for a, b, sign in (
                (knots[i], knots[i + degree], 1), (knots[i + 1], knots[i + degree + 1], -1)))
            values = [float(sc.Formula(text, ("u",)).evaluate(u)) for text in texts]
            assert np.allclose(sorted(set(values)), sorted({left, right}), rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize('degree, knots', KNOTS)
def test_support_leads_back_to_the_spans_of_the_function_and_wedges_are_all_that_a_span_has(degree, knots):
    knots = np.array(knots, float)
    for i in range(len(knots) - degree - 1):
        chosen = links(picture(degree, knots, [(i, degree)], True), f"support {i},{degree}")
        first = {j for (j, level), _ in chosen if level == 0}
        assert first == ({j for j in range(i, i + degree + 1) if knots[j] < knots[j + 1]} if degree else set())
    for span in range(len(knots) - 1):
        parts = picture(degree, knots, spans=[span])
        chosen = links(parts, f"wedge {span}")
        tops = {each for _, each in chosen if each[1] == degree}
        wanted = {(i, degree) for i in range(span - degree, span + 1) if 0 <= i < len(knots) - degree - 1} if knots[span] < knots[span + 1] else set()
        assert tops == wanted
        border = next(part.curve.points for part in reversed(parts) if part.name == f"wedge {span}")
        assert np.array_equal(border[0], border[-1])
        for i, level in {each for link in chosen for each in link}:
            at = np.array([level, -0.6 * (i + level / 2)])
            inside = [np.interp(at[0], *half.T[:2]) for half in (border[:len(border) // 2 - 1], border[len(border) // 2 + 1:-1][::-1])]
            assert inside[1] < at[1] < inside[0]


def test_lecture_on_0_to_3():
    found = marks(picture(2, [0, 1, 2, 3], [(0, 2)]))
    assert "u/2" in found and "(3-u)/2" in found


@pytest.mark.parametrize('settings, message', (
    ({'chosen': [(5, 1)]}, "no function N_5,1"), ({'chosen': [(0, 4)]}, "no function N_0,4"), ({'spans': [9]}, "no span 9")))
def test_what_is_not_there_is_refused(settings, message):
    with pytest.raises(Refusal, match=message):
        picture(2, [0, 1, 2, 3, 4], **settings)


def test_bad_knots_are_refused():
    for knots, message in (([3, 2, 1, 0], "must not decrease"), ([0, 1], "at least 4"), (range(60), "150 are the most")):
        with pytest.raises(Refusal, match=message):
            picture(2, list(knots))


def test_text_has_the_triangle():
    text = formulas.text(sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], np.eye(3)), 0.5)
    lines = text.split("Triangle of functions")[1].split("\n\n")[0].splitlines()[1:]
    assert lines == ["  [0, 0]  0", "                0", "  [0, 0]  0           N0,2", "                N1,1", "  [0, 1]  N2,0        N1,2",
                     "                N2,1", "  [1, 1]  0           N2,2", "                0", "  [1, 1]  0"]
    assert "written up to" in formulas.text(sc.NurbsCurve(2, range(60), np.zeros((57, 3)) + np.arange(57)[:, None]), 0.5)


def definition_of(parts):
    definitions = core("shape.definition")
    return definitions.named(definitions.from_value([part.curve for part in parts]), [part.name for part in parts])


def value_of(knots, i, degree, u):
    if degree == 0:
        return float(knots[i] <= u < knots[i + 1])
    def share(part, whole):
        return part / whole if whole else 0.0
    return (share(u - knots[i], knots[i + degree] - knots[i]) * value_of(knots, i, degree - 1, u)
            + share(knots[i + degree + 1] - u, knots[i + degree + 1] - knots[i + 1]) * value_of(knots, i + 1, degree - 1, u))


@pytest.mark.parametrize('degree, knots', KNOTS)
def test_what_is_pointed_at_is_said_by_numbers_that_fit_the_functions(degree, knots):
    knots = [float(knot) for knot in knots]
    shown = triangle.items(definition_of(picture(degree, knots)))
    assert [item.name for item in shown if item.is_span] == [f"[{a:.6g}, {b:.6g})" for a, b in pairwise(knots)]
    assert len([item for item in shown if not item.is_span]) == sum(len(knots) - level - 1 for level in range(degree + 1))
    for item in shown:
        if item.is_span:
            said = triangle.in_words(definition_of(picture(degree, knots, spans=[item.i])), item)
            middle = (knots[item.i] + knots[item.i + 1]) / 2
            on = [other.name for other in shown if not other.is_span and value_of(knots, other.i, other.degree, middle) > 0]
            assert "is empty" in str(said) if middle == knots[item.i + 1] else str(said).endswith(": " + ", ".join(on))
            continue
        said = str(triangle.in_words(definition_of(picture(degree, knots, [(0, degree), (item.i, item.degree)])), item))
        if item.is_zero or item.degree == 0:
            assert ("is zero" in said) == (knots[item.i] == knots[item.i + item.degree + 1]) and item.name in said
            continue
        assert len(triangle.lines_of(definition_of(picture(degree, knots, [(item.i, item.degree)])), item)) == sum(
            knots[i] < knots[i + item.degree] for i in (item.i, item.i + 1))
        name, _, formula = said.partition(" = ")
        left, right = formula.split(" + ")
        for u in np.linspace(knots[0], knots[-1], 23):
            terms = [eval(text, {'u': u}) * value_of(knots, i, item.degree - 1, u)       # noqa: S307
                     for text, i in ((left.rpartition(" ")[0], item.i), (right.rpartition(" ")[0], item.i + 1))]
            assert name == item.name and np.isclose(sum(terms), value_of(knots, item.i, item.degree, u), atol=1e-5)


def test_a_support_is_said_without_coefficients():
    shown = definition_of(picture(2, [0, 1, 2, 3], [(0, 2)], True))
    item = next(item for item in triangle.items(shown) if item.name == "N0,2")
    assert str(triangle.in_words(shown, item)) == "N0,2 and all that it depends on"
