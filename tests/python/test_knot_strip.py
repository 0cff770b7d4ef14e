"""The knots of a piece as marks on a bar: what stands at each, where it may be moved, which is at a pixel."""

from decimal import Decimal

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

decimals, definitions, knots, shared, strip = (
    core(name) for name in ('base.decimals', 'shape.definition', 'verbs.knots', 'shape.shared_knots', 'verbs.knot_strip'))
Refusal = core('base.failures').Refusal
RNG = np.random.default_rng(7)
SCALES = (1e-150, 1e-6, 1.0, 1e6, 1e150)


def clamped(degree, inner, scale=1.0, end=3.0, start=0.0):
    vector = scale * np.array([start] * (degree + 1) + list(inner) + [end] * (degree + 1))
    return sc.NurbsCurve(degree, vector, RNG.normal(size=(len(vector) - degree - 1, 3)))


def unclamped(scale=1.0):
    return sc.NurbsCurve(3, scale * np.arange(11.0), RNG.normal(size=(7, 3)))


def periodic(vector=range(8)):
    return sc.NurbsCurve(3, vector, RNG.normal(size=(len(vector) - 1, 3)), periodic=True)


def definition_of(value):
    return definitions.from_value(value)


def bars(value):
    return strip.bars_of(definition_of(value).pieces[0])


def bar(value):
    (found,) = bars(value)
    return found


def moved(value, number, to, piece=0, axis=0):
    definition = definition_of(value)
    return definitions.to_value(knots.moved(definition, shared.together(definition, piece, axis), number, to))


def said(of):
    return [(strip.number(of, float(value)), strip.words(of, i)) for i, value in enumerate(of.values)]


@pytest.mark.parametrize('scale, numbers', (
    (1.0, ["0", "1", "2", "3"]), (1e-150, ["0", "1e-150", "2e-150", "3e-150"]),
    (1e150, ["0", "1e+150", "2e+150", "3e+150"])))
def test_each_knot_says_how_often_it_is_there_and_how_smooth_the_curve_is(scale, numbers):
    assert said(bar(clamped(3, (1, 1, 2), scale))) == list(zip(numbers, ["×4", "×2 C1", "×1 C2", "×4"]))


def test_numbers_have_the_digits_that_tell_knots_apart_and_no_noise():
    found = bar(clamped(2, (1e6 + 0.001, 1e6 + 0.002), start=1e6, end=1e6 + 0.003))
    assert [text for text, _ in said(found)] == ["1000000", "1000000.001", "1000000.002", "1000000.003"]
    assert strip.number(bar(clamped(3, (1,))), -1e-17) == "0"


@pytest.mark.parametrize('degree', (*range(1, 10), 255))
def test_a_knot_that_is_there_as_often_as_it_may_is_a_corner_or_a_gap(degree):
    corner, gap = (bar(clamped(degree, [1.5] * count)) for count in (degree, degree + 1))
    assert strip.words(corner, 1) == f"×{degree} C0" and strip.words(gap, 1) == f"×{degree + 1} gap"
    assert strip.smoothness(corner, 1) == 0 and strip.smoothness(gap, 1) == -1 and strip.smoothness(gap, 0) is None


def test_weights_do_not_matter():
    curve = clamped(2, (1, 1))
    rational = sc.NurbsCurve(2, curve.knots, curve.points, [1, 0.5, 2, -1, 1])
    assert said(bar(rational)) == said(bar(curve)) == [("0", "×3"), ("1", "×2 C0"), ("3", "×3")]


def test_unclamped_knots_outside_the_domain_are_told_from_those_inside():
    found = bar(unclamped())
    assert found.domain == (3, 7) and [strip.is_inside(found, i) for i in range(11)] == [3 <= i <= 7 for i in range(11)]
    assert strip.words(found, 1) == "×1" and strip.words(found, 4) == "×1 C2" and strip.words(found, 3) == "×1"
    assert not any(strip.why_fixed(found, i) for i in range(11))


def test_the_seam_of_a_periodic_curve_counts_both_sides_and_stays():
    found = bar(periodic([0, 0, 1, 2, 3, 4, 5, 5]))
    assert said(found)[0] == ("0", "×3 C0") and said(found)[-1] == ("5", "×3 C0") and said(found)[2] == ("2", "×1 C2")
    assert strip.why_fixed(found, 0) == strip.why_fixed(found, 5) == strip.SEAM_STAYS and not strip.why_fixed(found, 1)


def test_a_patch_has_two_bars_and_pieces_without_knots_plain_ones():
    patch = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 3, 3, 3], [0, 0, 1, 1]), RNG.normal(size=(4, 2, 3)))
    u, v = bars(patch)
    assert (u.name, v.name) == ("u", "v") and said(u) == [("0", "×3"), ("1", "×1 C1"), ("3", "×3")]
    assert len(v.values) == 2
    for value in (sc.BezierCurve(RNG.normal(size=(256, 3))), sc.BezierPatch(RNG.normal(size=(3, 2, 3)))):
        assert all(said(of) == [("0", ""), ("1", "")] and strip.why_fixed(of, 0) == strip.NO_KNOTS for of in bars(value))
    chain = sc.HermiteCurve(RNG.normal(size=(3, 3)), RNG.normal(size=(3, 3)), [0, 1, 4])
    assert said(bar(chain)) == [("0", ""), ("1", ""), ("4", "")]
    assert [strip.why_fixed(bar(chain), i) for i in range(3)] == [strip.ENDS_STAY, "", strip.ENDS_STAY]


@pytest.mark.parametrize('scale', SCALES)
def test_places_on_the_bar_and_parameters_are_each_others_inverse(scale):
    found = bar(clamped(3, (0.5, 1, 2), scale))
    at = strip.fractions(found.values, found.span)
    assert np.allclose(at, np.array([0, 0.5, 1, 2, 3]) / 3, rtol=1e-14)
    assert np.allclose([strip.at_fraction(part, found.span) for part in at], found.values, rtol=1e-14, atol=0)


def test_the_nearest_mark_within_reach_is_meant():
    places = [10.0, 20.0, 21.0]
    assert [strip.nearest(places, x, 7) for x in (3.5, 2.5, 14, 20.4, 20.6, 40)] == [0, None, 0, 1, 2, None]


@pytest.mark.parametrize('scale', SCALES)
def test_the_mouse_moves_a_knot_between_its_neighbors_and_not_onto_them(scale):
    found = bar(clamped(3, (1, 1, 2), scale))
    low, high = strip.reach(found, 1)
    assert 0 < low < 0.01 * scale and 1.99 * scale < high < 2 * scale
    assert strip.is_between(found, 1, low) and not strip.is_between(found, 1, 0.0)
    assert not strip.is_between(found, 1, float(found.values[2])) and not strip.is_between(found, 1, float('nan'))


def test_outer_knots_of_unclamped_curves_are_moved_on_the_bar_and_typed_beyond_it():
    found = bar(unclamped())
    assert strip.reach(found, 0)[0] == 0 and strip.reach(found, 10)[1] == 10
    assert strip.is_between(found, 0, -1e9) and strip.is_between(found, 10, 1e9) and not strip.is_between(found, 10, 9)


def test_a_knot_without_room_stays():
    close = np.nextafter(1.0, 2.0)
    found = bar(clamped(3, (1.0, close, np.nextafter(close, 2.0))))
    assert strip.why_fixed(found, 2) == strip.NO_ROOM and not strip.why_fixed(found, 1)


@pytest.mark.parametrize('width, pixels, wanted', (
    (0.01, 1, "0.01"), (0.01, 1.5, "0.02"), (0.01, 4, "0.05"), (0.01, 6, "0.1"), 
    (3e-153, 1, "5e-153"), (7e147, 1, "1e148")))
def test_steps_are_round_and_as_wide_as_asked_for(width, pixels, wanted):
    found = strip.step(width, pixels)
    assert float(found) == float(Decimal(wanted))


@pytest.mark.parametrize('value, step, wanted', (
    (0.123456, "0.01", 0.12), (1.2345e-150, "1e-152", 1.23e-150), (1.2345e150, "1e148", 1.23e150),
    (1e6 + 0.0012344, "1e-6", 1000000.001234)))
def test_rounded_parameters_are_the_shortest_decimals(value, step, wanted):
    assert strip.rounded(value, Decimal(step)) == wanted


def test_what_would_be_rounded_onto_a_neighbor_is_not():
    assert strip.within(0.98, Decimal("0.5"), 0.2, 0.99) == 0.98 and strip.within(0.7, Decimal("0.5"), 0.2, 0.99) == 0.5
    assert strip.within(7.0, Decimal("0.5"), 0.2, 0.99) == 0.99 and strip.within(-7.0, Decimal("0.5"), 0.2, 0.99) == 0.2


def test_texts_that_would_overlap_are_left_out_those_wanted_most_first():
    assert strip.thinned([0, 5, 10, 100], [9, 9, 9, 9]).tolist() == [True, False, True, True]
    assert strip.thinned([5, 0, 10], [9, 9, 9]).tolist() == [True, False, False]
    lefts, widths = RNG.uniform(0, 1000, 500), RNG.uniform(1, 60, 500)
    shown = np.flatnonzero(strip.thinned(lefts, widths))
    order = shown[np.argsort(lefts[shown])]
    assert (lefts[order][1:] >= (lefts + widths)[order][:-1]).all() and shown[0] == 0
    hidden = np.setdiff1d(np.arange(500), shown)
    assert all(((lefts[shown] < lefts[i] + widths[i]) & (lefts[i] < (lefts + widths)[shown])).any() for i in hidden)


def test_the_ends_of_the_domain_and_knots_that_are_there_often_come_first():
    assert strip.by_weight(bar(clamped(3, (0.5, 1, 1, 2)))) == [0, 4, 2, 1, 3]
    assert strip.by_weight(bar(unclamped()))[:5] == [3, 7, 4, 5, 6]


@pytest.mark.parametrize('scale', SCALES)
def test_all_copies_of_a_knot_go_and_nothing_else_changes(scale):
    before = clamped(3, (1, 1, 2), scale)
    after = moved(before, 5, 1.5 * scale)       # the second copy
    assert np.array_equal(after.knots, scale * np.array([0, 0, 0, 0, 1.5, 1.5, 2, 3, 3, 3, 3]))
    assert np.array_equal(after.points, before.points) and after.degree == 3


@pytest.mark.parametrize('value, number, to', ((periodic(), 2, 2.5), (unclamped(), 0, -4.0), (unclamped(), 10, 12.0)))
def test_knots_of_periodic_and_unclamped_curves_are_moved(value, number, to):
    wanted = np.array(value.knots)
    wanted[number] = to
    assert np.array_equal(moved(value, number, to).knots, wanted)


def test_a_parameter_of_a_hermite_chain_is_moved():
    chain = sc.HermiteCurve(RNG.normal(size=(3, 3)), RNG.normal(size=(3, 3)), [0, 1, 4])
    assert np.array_equal(moved(chain, 1, 2.5).parameters, [0, 2.5, 4])


@pytest.mark.parametrize('value, number, to, words', (
    (clamped(3, (1, 2)), 4, 2.0, "between 0 and 2"), (clamped(3, (1, 2)), 4, -1.0, "between 0 and 2"),
    (clamped(3, (1, 2)), 4, float('nan'), "between 0 and 2"), (clamped(3, (1, 2)), 4, float('inf'), "between 0 and 2"),
    (clamped(3, (1, 2)), 0, 0.5, "Reparameterize"), (clamped(3, (1, 2)), 9, 2.5, "Reparameterize"),
    (clamped(3, (1, 2)), 10, 0.5, "none of number 11"), (clamped(3, (1, 2)), -1, 0.5, "none of number 0"),
    (periodic(), 0, -0.5, "begins at this knot"), (unclamped(), 0, 1.0, "below 1"), (unclamped(), 10, 9.0, "above 9"),
    (sc.BezierCurve(RNG.normal(size=(4, 3))), 0, 0.5, "no knots")))
def test_what_may_not_be_is_refused_in_words(value, number, to, words):
    with pytest.raises(Refusal, match=words):
        moved(value, number, to)


def test_an_outer_knot_that_would_lie_at_infinity_is_refused():
    with pytest.raises((Refusal, sc.Error)):
        moved(unclamped(), 10, float('inf'))


def sheet(*turned):
    """A row of patches that share their borders along v, of which some run the other way along v."""
    points, found = RNG.normal(size=(10, 5, 3)), []
    for i in range(3):
        net, vector = points[3 * i:3 * i + 4], np.array([0, 0, 0, 0, 1, 3, 3, 3, 3.0])
        if i in turned:
            net, vector = net[:, ::-1], 3.0 - vector[::-1]
        found.append(sc.NurbsPatch((3, 3), ([0, 0, 0, 0, 1, 1, 1, 1], vector), net))
    return sc.PatchSet.from_patches(found)


@pytest.mark.parametrize('turned', ((), (1,), (0, 2)))
def test_patches_that_share_a_border_along_the_knot_go_along(turned):
    before = sheet(*turned)
    after = moved(before, 4, 1.75 if 0 in turned else 1.25, axis=1)
    for i in range(3):
        assert after[i].knots[1][4] == (1.75 if i in turned else 1.25)
        assert np.array_equal(after[i].knots[0], before[i].knots[0])
    ends = [after[i].evaluate_grid([0.0, 1.0], np.linspace(0, 3, 7)) for i in range(3)]
    for i in range(2):
        left, right = ends[i][1], ends[i + 1][0]
        if (i in turned) != (i + 1 in turned):
            right = right[::-1]
        assert np.allclose(left, right, atol=1e-12)


def test_patches_with_other_knots_or_without_a_border_in_common_stay():
    points = RNG.normal(size=(7, 5, 3))
    one, other = np.array([0, 0, 0, 0, 1, 3, 3, 3, 3.0]), np.array([0, 0, 0, 0, 2, 3, 3, 3, 3.0])
    u = [0, 0, 0, 0, 1, 1, 1, 1]
    before = sc.PatchSet.from_patches(
        [sc.NurbsPatch((3, 3), (u, one), points[:4]), sc.NurbsPatch((3, 3), (u, other), points[3:])])
    definition = definition_of(before)
    assert shared.together(definition, 0, 1) == [shared.Along(0, 1)]
    assert shared.together(definition_of(sheet()), 0, 0) == [shared.Along(0, 0)]
    assert {along.piece for along in shared.together(definition_of(sheet(1)), 2, 1)} == {0, 1, 2}


@pytest.mark.parametrize('number, text, wanted', (
    (0.5, "0.5", 0.5), (np.float32(0.1), "0.1", 0.1), (np.float32(1 / 3), repr(1 / 3), 1 / 3), (0.0, "1e-150", 1e-150),
    (3.4028234663852886e38, "1e150", 1e150), (0.25, "0.5", 0.25), (np.float32(0.2), "", 0.2), (0.25, "none", 0.25)))
def test_the_exact_number_is_meant_until_another_is_set(number, text, wanted):
    assert decimals.meant(float(number), text) == wanted
