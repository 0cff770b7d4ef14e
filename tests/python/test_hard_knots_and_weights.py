"""Verbs where knots lie close together far from zero, weights differ by hundreds of digits or are all negative."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc

RNG = np.random.default_rng
SHORT = (1e-6, 1e-9, 1e-12)


def blossomed(degree, knots, points, u):
    """de Boor's algorithm in rational numbers, of a polynomial curve."""
    knots, u = [Fraction(k) for k in knots], Fraction(u)
    rows = [[Fraction(x) for x in row] for row in points]
    last = len(rows) - 1
    span = max(i for i in range(degree, last + 1) if knots[i] <= u and knots[i] < knots[i + 1])
    level = [rows[span - degree + j] for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[span - degree + j], knots[span + 1 + j - r]
            share = (u - low) / (high - low)
            level[j] = [(1 - share) * a + share * b for a, b in zip(level[j - 1], level[j])]
    return level[degree]


def mirrored_by(before, after):
    """u -> c - u in rational numbers, as the verb has it."""
    return lambda u: Fraction(after[0]) + Fraction(before[1]) - Fraction(u)


@pytest.mark.parametrize("short", SHORT)
def test_reversing_keeps_every_point_where_a_short_span_lies_far_from_the_other_end(short):
    knots = [0.0] * 4 + [short] + [1e6] * 4
    points = RNG(1).integers(-9, 9, (5, 3)).astype(float)
    curve = sc.NurbsCurve(3, knots, points)
    back = curve.reversed()
    image = mirrored_by(curve.domain, back.domain)
    for u in (0.3 * short, 0.7 * short, 2 * short, 5e5):
        one = blossomed(3, curve.knots, curve.points, u)
        other = blossomed(3, back.knots, back.points, image(u))
        assert max(abs(a - b) for a, b in zip(one, other)) <= Fraction(1, 10**12)
    assert back.reversed() == curve


def test_a_curve_with_one_short_span_stays_where_it_is():
    curve = sc.NurbsCurve(3, [0] * 4 + [1e-4, 3.3333] + [7.1] * 4, np.random.default_rng(8).normal(size=(6, 3)))
    assert curve.reversed().domain == curve.domain
    assert curve.reversed().reversed().largest_distance(curve) <= 1e-9


def test_reversing_keeps_the_domain_where_it_can():
    for knots in ([0.0] * 4 + [1 / 3, 0.7] + [1.0] * 4, [5.0] * 4 + [5.1] + [7.3] * 4, list(np.linspace(-1, 3, 13))):
        curve = sc.NurbsCurve(3, knots, RNG(2).normal(size=(len(knots) - 4, 3)))
        assert curve.reversed().domain == curve.domain


@pytest.mark.parametrize("short", SHORT)
def test_reversing_patches_and_chains_keeps_short_spans(short):
    points = RNG(3).normal(size=(5, 4, 3))
    patch = sc.NurbsPatch((3, 3), ([0.0] * 4 + [short] + [1e6] * 4, [0.0] * 4 + [1.0] * 4), points)
    back = patch.reversed("u")
    assert np.array_equal(back.knots[0], -patch.knots[0][::-1]) and back.reversed("u") == patch
    assert np.array_equal(back.knots[1], patch.knots[1])
    chain = sc.HermiteCurve(points[:3, 0], points[:3, 1], [0.0, short, 1e6])
    assert np.array_equal(chain.reversed().parameters, [-1e6, -short, 0.0])
    assert chain.reversed().reversed() == chain
    grid = sc.HermitePatch(points[:3, :2], points[:3, 1:3], points[1:4, :2], parameters=([0.0, short, 1e6], [0.0, 1.0]))
    assert np.array_equal(grid.reversed("u").parameters[0], [-1e6, -short, 0.0])
    assert grid.reversed("u").reversed("u") == grid


def test_a_point_that_is_all_but_a_copy_is_no_copy():
    """Its share is 1 - 1e-17, which rounds to 1: but the other weighs 1e20."""
    line = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 0)], [1, 1e20])
    fine = line.insert_knot(1e-17)
    assert fine.points[1, 0] == pytest.approx(1000 / 1001, rel=1e-14) and fine.weights[1] == pytest.approx(1001)
    patch = sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]],
                          [[1, 1], [1e20, 1e20]])
    assert patch.insert_knot("u", 1e-17).points[1, 0, 0] == pytest.approx(1000 / 1001, rel=1e-14)
    assert patch.isocurve("u", 1e-17).points[0, 0] == pytest.approx(1000 / 1001, rel=1e-14)
    unclamped = sc.NurbsCurve(2, [-1e-17, -1e-17, 0, 1, 2, 3], [(0, 0), (1, 0), (1, 1)], [1, 1e20, 1])
    assert unclamped.to_bezier()[0].points[0, 0] == pytest.approx(1000 / 1001, rel=1e-12)


def rounded_distance(curve, other):
    """How far apart two curves are at parameters near the ends and between, as a part of their size."""
    start, end = curve.domain
    near = (end - start) * 2.0 ** -np.arange(1.0, 80)
    u = np.concatenate([[start, end], start + near, end - near])
    sides = [np.abs(curve.evaluate(u, side=side) - other.evaluate(u, side=side)).max() for side in ("left", "right")]
    return max(sides) / np.abs(curve.points).max()


def test_unclamping_keeps_the_curve_or_says_that_it_cannot():
    line = lambda weights: sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (3, 0)], weights)
    for weights in ((1, 1e20, 1), (1e20, 1, 1e-20), (-1, -1e20, -1)):
        with pytest.raises(sc.InvalidShape, match="weights are so different"):
            line(weights).unclamped()
    random, refused, kept = RNG(6), 0, 0
    for spread in (*range(1, 9), 12, 16):
        for degree in (1, 2, 3, 5, 9):
            points, weights = random.normal(size=(degree + 3, 3)), 10.0 ** random.uniform(-spread, spread, degree + 3)
            knots = np.r_[[0.0] * (degree + 1), 0.3, 0.5, [1.0] * (degree + 1)]
            curve = sc.NurbsCurve(degree, knots, points, weights)
            patch = sc.NurbsPatch((degree, 1), (knots, [0, 0, 1, 1]), np.stack([points, points + (0, 0, 1)], 1),
                                  np.stack([weights, weights], 1))
            for unclamped, of in ((curve.unclamped, lambda c: c), (lambda: patch.unclamped("u"),
                                                                   lambda p: p.isocurve("v", 0.0))):
                try:
                    after = of(unclamped())
                except sc.InvalidShape:
                    refused += 1
                else:
                    kept += 1
                    assert rounded_distance(curve, after) <= 1e-8
    assert kept >= 20 and refused >= 20
    for weights in ((1, 1000, 1), (1, 1, 1e20), (-1, -1, -1), (1e-150, 1e-151, 1e-150)):
        assert rounded_distance(line(weights), line(weights).unclamped()) <= 1e-12


VERBS = {
    "insert_knot": lambda c: c.insert_knot(0.3, 2), "refine": lambda c: c.refine([0.1, 0.6, 0.6]),
    "split": lambda c: c.split(0.4), "elevate": lambda c: c.elevate(2), "to_bezier": lambda c: c.to_bezier(),
    "reversed": lambda c: c.reversed(), "unclamped": lambda c: c.unclamped(), "reduce": lambda c: c.elevate().reduce().value,
    "remove_knots": lambda c: c.insert_knot(0.2).remove_knots(1e-9).value, "with_domain": lambda c: c.with_domain((2, 5)),
    "transformed": lambda c: c.transformed([[1, 2, 0, 1], [0, 1, 3, 0], [0, 0, 1, 2], [0.1, 0, 0, 2]]),
    "finite_arcs": lambda c: c.finite_arcs(100.0), "remove_knot": lambda c: c.remove_knot(0.5).value,
}


def pieces_of(result):
    return list(result) if isinstance(result, (list, tuple)) else [result]


def a_curve(weights=(1.0, 2.0, 0.5, 1.0, 3.0)):
    points = [(0, 0, 1), (1, 2, 0), (3, 1, -1), (4, 4, 2), (6, 0, 0)]
    return sc.NurbsCurve(3, [0] * 4 + [0.5] + [1] * 4, points, weights)


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("factor", (-1.0, 2.0**1020, 2.0**-1070, -2.0**-1000, 1e300))
def test_verbs_give_the_same_points_whatever_all_weights_are_multiplied_by(verb, factor):
    curve = a_curve()
    other = curve.with_weights(curve.weights * factor)
    assert np.array_equal(other.weights, curve.weights * factor) and np.array_equal(other.points, curve.points)
    pairs = list(zip(pieces_of(VERBS[verb](curve)), pieces_of(VERBS[verb](other))))
    assert len(pairs) == len(pieces_of(VERBS[verb](curve)))
    for one, two in pairs:
        u = np.linspace(*one.domain, 21)
        # 2^-1070 leaves the weights 2, 0.5, 1 and 3 as they are: sums of them would round.
        assert np.abs(one.evaluate(u) - two.evaluate(u)).max() <= 1e-12
        assert np.abs(one.points - two.points).max() <= 1e-12


@pytest.mark.parametrize("verb", ("standard_form", "moebius", "reduce"))
def test_negative_weights_are_a_legal_shape_of_bezier_curves_too(verb):
    bezier = sc.BezierCurve([(0, 0), (1, 2), (3, 1), (4, 0)], [1, 2, 0.5, 3])
    negative = bezier.with_weights(-bezier.weights)
    calls = {"standard_form": lambda c: c.standard_form(), "moebius": lambda c: c.moebius(2.0),
             "reduce": lambda c: c.elevate().reduce().value}
    one, two = calls[verb](bezier), calls[verb](negative)
    u = np.linspace(0, 1, 11)
    assert np.abs(one.evaluate(u) - two.evaluate(u)).max() <= 1e-13
    if verb == "standard_form":
        assert two.weights[[0, -1]].tolist() == [1, 1]
    if verb == "reduce":
        assert (two.weights < 0).all()


@pytest.mark.parametrize("axis", "uv")
@pytest.mark.parametrize("factor", (-1.0, 2.0**1020, 2.0**-1070))
def test_verbs_of_patches_give_the_same_points_whatever_all_weights_are_multiplied_by(axis, factor):
    weights = np.array([[1, 2, 0.5], [3, 1, 2], [1, 4, 0.25], [0.5, 1, 1]])
    patch = sc.NurbsPatch((2, 2), ([0] * 3 + [0.5] + [1] * 3, [0] * 3 + [1] * 3), RNG(5).normal(size=(4, 3, 3)), weights)
    other = sc.NurbsPatch(patch.degree, patch.knots, patch.points, weights * factor)
    u, v = np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 7))
    for verb in (lambda p: p, lambda p: p.insert_knot(axis, 0.3), lambda p: p.elevate(axis), lambda p: p.split(axis, 0.4)[0],
                 lambda p: p.reversed(axis), lambda p: p.insert_knot(axis, 0.3).remove_knots(axis, 1e-9).value,
                 lambda p: p.elevate(axis).reduce(axis).value, lambda p: p.to_bezier()[0][0]):
        one, two = verb(patch), verb(other)
        at = [start + (end - start) * t for (start, end), t in zip(one.domain, (u, v))]
        assert np.abs(one.evaluate(*at) - two.evaluate(*at)).max() <= 1e-12
    assert np.abs(patch.isocurve(axis, 0.3).points - other.isocurve(axis, 0.3).points).max() <= 1e-13


def test_weights_of_all_sizes_meet_in_one_curve():
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (0, 1e10), (3, 4)], [1e300, 1e-300, 1.0])
    assert curve.evaluate(0).tolist() == [1, 0, 0] and curve.evaluate(1).tolist() == [3, 4, 0]
    assert np.abs(curve.insert_knot(0.3).evaluate([0, 0.5, 1]) - curve.evaluate([0, 0.5, 1])).max() <= 1e-13


def test_redundant_knots_go_before_any_that_shapes_the_curve():
    """From the left the tolerance was spent on the first genuine knot, and redundant ones stayed."""
    rng = RNG(7)
    shape = sc.NurbsCurve(3, [0] * 4 + [2, 5, 7] + [10] * 4, rng.normal(size=(7, 3)))
    fine = shape.refine([1, 3, 4, 6, 8, 9])
    least = min(shape.remove_knot(u).error for u in (2, 5, 7))
    value, bound = fine.remove_knots(0.99 * least)
    assert np.array_equal(value.knots, shape.knots) and bound <= 1e-14
    value, bound = fine.remove_knots(1.02 * least)
    assert len(value.points) == 6 and bound == pytest.approx(least, rel=0.02)
    patch = sc.NurbsPatch((3, 1), (shape.knots, [0, 0, 1, 1]), rng.normal(size=(7, 2, 3)))
    least = min(patch.remove_knot("u", u).error for u in (2, 5, 7))
    value, bound = patch.refine("u", [1, 3, 4, 6, 8, 9]).remove_knots("u", 0.9 * least)
    assert np.array_equal(value.knots[0], shape.knots) and bound <= 1e-13


def test_the_error_of_a_redundant_knot_is_rounding():
    for degree in range(1, 10):
        curve = sc.NurbsCurve(degree, [0] * (degree + 1) + [1, 2] + [3] * (degree + 1), RNG(degree).normal(size=(degree + 3, 3)))
        for times in range(1, degree + 1):
            value, bound = curve.insert_knot(1.3, times).remove_knot(1.3, times)
            assert bound <= 2e-15 * 2**degree, (degree, times)
            assert np.abs(value.points - curve.points).max() <= 2e-15 * 2**degree


@pytest.mark.parametrize("periodic", (False, True))
def test_tens_of_thousands_of_knots_are_removed(periodic):
    count = 20_000
    shape = sc.NurbsCurve(3, [0] * 4 + [count] * 4, RNG(8).normal(size=(4, 3)), [1, 2, 1, 1])
    if periodic:
        shape = sc.NurbsCurve(3, np.arange(0, count + 1, count / 8), RNG(8).normal(size=(8, 3)), periodic=True)
    extra = np.setdiff1d(np.arange(1, count), shape.knots)
    value, bound = shape.refine(extra).remove_knots(1e-9)
    assert len(value.points) == len(shape.points) and bound <= 1e-9


def test_a_long_removal_is_cancelled():
    count = 20_000
    curve = sc.NurbsCurve(3, [0] * 4 + [count] * 4, RNG(9).normal(size=(4, 3))).refine(np.arange(1, count))
    with pytest.raises(sc.Cancelled):
        curve.remove_knots(1e-9, cancel=lambda: True)
    with pytest.raises(TypeError, match="not callable"):
        curve.remove_knots(1e-9, cancel=3)


def test_no_elevation_gives_the_value_itself():
    bezier = sc.BezierCurve([(0, 0), (1, 2), (3, 1)], [1, 2, 3])
    grid = sc.BezierPatch(RNG(1).normal(size=(3, 4, 3)))
    assert bezier.elevate(0) == bezier and a_curve().elevate(0) == a_curve()
    assert grid.elevate("u", 0) == grid and grid.to_nurbs().elevate("v", 0) == grid.to_nurbs()
    for call in (lambda: bezier.elevate(-1), lambda: a_curve().elevate(-1), lambda: grid.elevate("u", -1)):
        with pytest.raises(sc.InvalidShape, match="times = -1"):
            call()


@pytest.mark.parametrize("factor", (1.0, 3.0, -2.0**-1000))
def test_bezier_points_are_those_of_the_pieces(factor):
    curve = a_curve().refine([0.2, 0.7])
    curve = curve.with_weights(curve.weights * factor)
    rows = curve.bezier_points()
    pieces = curve.to_bezier()
    assert rows.shape == (len(pieces), 4, 4)
    for row, piece in zip(rows, pieces):
        assert np.abs(row[:, :3] / row[:, 3:] - piece.points).max() <= 1e-14
        assert np.abs(row[:, 3] / piece.weights - 1).max() <= 1e-14
    ring = sc.NurbsCurve(2, range(6), RNG(4).normal(size=(5, 3)), periodic=True)
    assert np.abs(ring.bezier_points()[4, :, :3] - ring.to_bezier()[4].points).max() <= 1e-15
