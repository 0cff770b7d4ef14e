"""Lengths: closed forms, at every scale and weight, of many spans, and errors that name what was given."""

import math

import numpy as np
import pytest

import dense_rules
import splinecore as sc
from test_kernels import found_by_sets

CIRCLE = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)], float)


def near(value, expected, relative=1e-13):
    return abs(value - expected) <= relative * expected


def arms(t):
    """The length of (t², t³) from 0 to t."""
    return 8 / 27 * math.expm1(1.5 * math.log1p(9 / 4 * t * t))


def turns(count, radius=1.0, center=(0.0, 0.0)):
    """A circle that goes round so often: four spans a turn."""
    points = np.vstack([np.tile(CIRCLE, (count, 1)), CIRCLE[:1]]) * radius + center
    weights = np.append(np.tile([1, math.sqrt(0.5)], 4 * count), 1)
    knots = np.repeat(np.arange(4 * count + 1), 2)
    return sc.NurbsCurve(2, [0, *knots, 4 * count], points, weights)


def random_curves(rng):
    for degree in [*range(1, 10), 25]:
        for periodic in (False, True):
            for ends in ("clamped", "unclamped"):
                for weights in (None, rng.uniform(0.5, 2, 40), 10.0 ** rng.uniform(-3, 3, 40)):
                    inner = np.sort(rng.uniform(0, 1, 6))
                    inner[1] = inner[0] if degree > 1 else inner[1]
                    order = 0 if periodic else degree if ends == "clamped" else 0
                    knots = np.concatenate([np.zeros(order + 1), inner, np.ones(order + 1)])
                    if not periodic and ends == "unclamped":
                        more = np.cumsum(rng.uniform(0.1, 1, degree))
                        knots = np.concatenate([-more[::-1], knots, 1 + more])
                    count = len(knots) - (1 if periodic else degree + 1)
                    yield sc.NurbsCurve(degree, knots, rng.normal(size=(count, 3)),
                                        None if weights is None else weights[:count], periodic=periodic)


def dense(curve):
    """By Gauss's rule on parts of every span, ever shorter towards its ends, where wild weights have their peaks."""
    near_ends = 0.5 ** np.linspace(40, 1, 40)
    places = np.concatenate([[0.0], near_ends, 1 - near_ends[-2::-1], [1.0]])
    start, end = curve.domain
    knots = np.unique(np.concatenate([curve.knots, [start, end]]))
    knots = knots[(knots >= start) & (knots <= end)]
    edges = np.unique(knots[:-1, None] + np.diff(knots)[:, None] * places)

    def of_parts(parts):
        half = np.diff(parts[:, 0]) / 2
        u = parts[:, 0, :1] + half * (1 + dense_rules.NODES)
        speeds = np.linalg.norm(curve.derivatives(u, 1)[..., 1, :], axis=-1) * half
        return speeds @ dense_rules.SHARES, np.abs(speeds @ dense_rules.LAST).sum(-1)

    return dense_rules.settled(of_parts, np.stack([edges[:-1], edges[1:]], -1)[:, None])[0]


def test_lengths_are_those_of_a_dense_rule_whatever_the_knots_and_the_degree():
    """Where weights differ slopes are differences of large numbers: so many digits the dense rule has fewer."""
    for curve in random_curves(np.random.default_rng(1)):
        lost = 8 * np.finfo(float).eps * curve.weights.max() / curve.weights.min()
        assert near(curve.length(), dense(curve), 1e-11 + lost), curve
        if curve.degree == 1:
            ways = np.linalg.norm(np.diff(curve.clamped().points, axis=0), axis=1)
            assert near(curve.length(), ways.sum(), 1e-12), curve


def test_a_wide_tolerance_is_kept():
    for curve in random_curves(np.random.default_rng(2)):
        whole = curve.length()
        for tolerance in (1e-2, 1e-5, 1e-9):
            assert near(curve.length(tolerance=tolerance), whole, tolerance), (curve, tolerance)


def test_weights_that_grow_from_point_to_point_change_no_length():
    """Weights times powers of one number give the same points at other parameters."""
    rng = np.random.default_rng(3)
    for degree in (1, 2, 3, 5, 9):
        points = rng.normal(size=(degree + 1, 3))
        weights = rng.uniform(0.5, 2, degree + 1)
        whole = sc.BezierCurve(points, weights).length()
        for size in (1e-9, 1e3, 1e20, 1e60, 1e250):
            factors = size ** (np.arange(degree + 1) / degree)
            for wild in (weights * factors, -weights * factors, weights * factors[::-1]):
                assert near(sc.BezierCurve(points, wild).length(), whole, 1e-12), (degree, size)


def test_a_conic_of_any_weight_lies_between_its_chord_and_its_polygon():
    corner = [(0, 0), (1, 2), (3, 0)]
    polygon, chord = math.sqrt(5) + math.sqrt(8), 3.0
    for weight in (1e-250, 1e-20, 1e-6):
        found = sc.BezierCurve(corner, [1, weight, 1]).length()
        assert near(found, chord, 1e-12 + 100 * weight)
    for weight in (1e6, 1e20, 1e250):
        found = sc.BezierCurve(corner, [1, weight, 1]).length()
        assert near(found, polygon, 1e-12 + 100 / weight)


def test_weights_of_zero_and_below_are_measured_where_the_curve_is_finite():
    half = [(1, 0), (0, 1), (-1, 0)]
    assert near(sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], half, [1, 0, 1]).length(), math.pi)
    beyond = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, -math.sqrt(0.5), 1])
    assert near(beyond.length(), 1.5 * math.pi)


@pytest.mark.parametrize("size", [1e-150, 1e-30, 1e30, 1e150])
def test_lengths_keep_their_digits_at_every_scale_of_points_weights_and_parameters(size):
    rng = np.random.default_rng(4)
    for points, weights in ((rng.normal(size=(9, 3)), rng.uniform(0.5, 2, 9)), (rng.normal(size=(9, 3)), None)):
        knots = np.array([0, 0, 0, 0, 1, 2, 2, 3, 5, 6, 6, 6, 6.0])
        whole = sc.NurbsCurve(3, knots, points, weights).length()
        part = sc.NurbsCurve(3, knots, points, weights).length(0.25, 4)
        assert near(sc.NurbsCurve(3, knots, points * size, weights).length() / size, whole)
        assert near(sc.NurbsCurve(3, knots * size, points, weights).length(), whole)
        assert near(sc.NurbsCurve(3, knots * size, points, weights).length(0.25 * size, 4 * size), part, 1e-12)
        if weights is not None:
            assert near(sc.NurbsCurve(3, knots, points, weights * size).length(), whole)


def test_far_from_the_origin_nothing_but_the_rounding_of_the_points_is_lost():
    rng = np.random.default_rng(5)
    points = np.round(rng.normal(size=(20, 3)) * 2**20) / 2**20
    for weights in (None, rng.uniform(0.5, 2, 20)):
        knots = [0] * 3 + list(range(18)) + [17] * 3
        here = sc.NurbsCurve(3, knots, points, weights)
        there = sc.NurbsCurve(3, knots, points + [2**30, -2**31, 2**28], weights)
        assert there.length() == here.length()
        assert there.length(0.3, 11.7) == here.length(0.3, 11.7)


@pytest.mark.parametrize("t", [1.0, 0.3, 1e-2, 1e-4])
def test_the_arms_of_a_cusp_inside_a_span(t):
    curve = sc.PowerCurve([(0, 0), (0, 0), (1, 0), (0, 1)], 0.0, (-1, t))
    assert near(curve.length(), arms(1) + arms(t))
    assert near(curve.length(-t, t), 2 * arms(t), 1e-11)
    turned = sc.BezierCurve([(0, 0), (1, 0), (0, 0)])  # goes to 1/2 and back
    assert near(turned.length(), 1.0)
    wavering = sc.BezierCurve([(0, 0), (1, 0), (-1, 0), (0.5, 0)])
    ways = wavering.evaluate(np.sort([0, *np.roots([19.5, -18, 3]), 1]))[:, 0]
    assert near(wavering.length(), np.abs(np.diff(ways)).sum())


def test_a_hundred_thousand_spans_are_ordinary():
    round_and_round = turns(25_000)
    assert near(round_and_round.length(), 25_000 * 2 * math.pi, 1e-13)
    assert near(round_and_round.length(1.0, 1e5 - 1), 25_000 * 2 * math.pi - math.pi, 1e-12)
    points = np.random.default_rng(6).normal(size=(100_001, 3))
    line = sc.NurbsCurve(1, [0, *range(100_001), 100_000], points)
    assert near(line.length(), np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), 1e-12)


def test_a_length_of_many_spans_is_the_sum_of_those_of_its_parts():
    curve = turns(500, radius=3.0, center=(1e6, -1e6))
    cuts = np.linspace(*curve.domain, 8)
    parts = [curve.length(a, b) for a, b in zip(cuts[:-1], cuts[1:])]
    assert near(sum(parts), 500 * 2 * math.pi * 3.0, 1e-9)  # as the points are rounded there
    assert near(sum(parts), curve.length(), 1e-13)


def ring():
    return sc.NurbsCurve(3, range(8), np.random.default_rng(5).normal(size=(7, 3)), periodic=True)


@pytest.mark.parametrize("call, message", [
    (lambda: ring().length(8), "start = 8 is above 7, the end of the domain: an end is needed, too"),
    (lambda: ring().length(end=-1), "end = -1 is below 0, the start of the domain: a start is needed, too"),
    (lambda: ring().length(9, 8), "start = 9 is above end = 8"),
    (lambda: ring().length(8, 0), "start = 8 is above end = 0"),
    (lambda: turns(1).length(0, 8), "end = 8 is outside the domain [0, 4]"),
    (lambda: ring().length(math.inf), "start = inf"),
    (lambda: ring().length(end=-math.inf), "end = -inf"),
    (lambda: ring().length(math.nan), "start = nan"),
    (lambda: turns(1).length(8), "start = 8 is outside the domain [0, 4]"),
    (lambda: turns(1).length(end=-1), "end = -1 is outside the domain [0, 4]"),
    (lambda: turns(1).length(8, 1), "start = 8 is outside the domain [0, 4]"),
    (lambda: turns(1).length(3, 1), "start = 3 is above end = 1"),
])
def test_the_argument_that_was_given_is_blamed(call, message):
    with pytest.raises(sc.InvalidShape) as caught:
        call()
    assert str(caught.value).startswith(message)


def test_a_length_round_a_ring_counts_every_turn():
    curve = ring()
    whole = curve.length()
    part = curve.length(0, 1)
    assert near(curve.length(0, 8), whole + part) and near(curve.length(0, 7), whole) and curve.length(7, 7) == 0
    assert near(curve.length(0, 29), 4 * whole + part) and near(curve.length(-14, 7), 3 * whole)
    over_the_seam = curve.length(6, 8)
    assert near(over_the_seam, curve.length(6, 7) + part) and near(curve.length(-1, 15), 2 * whole + over_the_seam)
    assert near(curve.length(0.5, 0.5 + 7e6), 1e6 * whole)


MANY = """
import json, sys
sys.path.insert(0, sys.argv[1])
import numpy as np
import splinecore, test_lengths
curves = list(test_lengths.random_curves(np.random.default_rng(7)))
found = [curve.length(tolerance=t) for curve in curves for t in (1e-13, 1e-6)]
print(json.dumps([splinecore.__instruction_set__, found]))
"""


def test_every_processor_finds_nearly_the_same():
    first, *others = found_by_sets(MANY)
    for other in others:
        assert np.abs(first - other).max() <= 1e-13 * first.max()
        assert (np.abs(first / other - 1) <= np.tile([4e-13, 2e-6], len(first) // 2)).all()
