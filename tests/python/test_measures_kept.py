"""Lengths and areas keep the tolerance that they were asked for, or say why not: random shapes against a dense rule."""

import math
import re

import numpy as np
import pytest

import dense_rules
import splinecore as sc

TOLERANCES = (1e-3, 1e-6, 1e-9, None)
ROUNDING = 2e-13


def random_knots(rng, degree):
    """On a grid, so that a domain may lie far away; knots inside may be as multiple as makes cusps."""
    kind = rng.choice(["clamped", "unclamped", "periodic"])
    inner = np.sort(rng.choice(np.arange(1, 64), rng.integers(0, 7), replace=False)) / 64.0
    inner = np.repeat(inner, rng.choice([1, 1, 1, degree], len(inner)))
    start = rng.choice([0.0, 0.0, 1e7, -3e9])
    if kind == "periodic":
        missing = max(0, degree + 1 - len(inner))
        inner = np.sort(np.concatenate([inner, np.arange(1, missing + 1) / 64.0 + 1 / 128]))
        return np.concatenate([[0.0], inner, [1.0]]) + start, True
    if kind == "clamped":
        return np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)]) + start, False
    more = np.cumsum(rng.integers(1, 32, degree)) / 64.0
    return np.concatenate([-more[::-1], [0.0], inner, [1.0], 1 + more]) + start, False


def random_weights(rng, shape):
    return rng.choice([1.0, 2.0], shape) if rng.random() < 0.4 else rng.uniform(0.4, 2.5, shape)


def count_of(knots, degree, periodic):
    return len(knots) - (1 if periodic else degree + 1)


def random_curve(rng):
    degree = int(rng.integers(1, 10))
    knots, periodic = random_knots(rng, degree)
    points = np.round(rng.normal(size=(count_of(knots, degree, periodic), 3)) * 2**20) / 2**20
    return degree, knots, points, random_weights(rng, len(points)), periodic


def random_patch(rng):
    """Nets that wave, and thin ones: across they are up to a million times as narrow as along."""
    degree = tuple(int(p) for p in rng.integers(1, 6, 2))
    (u, periodic_u), (v, periodic_v) = (random_knots(rng, p) for p in degree)
    count = (count_of(u, degree[0], periodic_u), count_of(v, degree[1], periodic_v))
    thin = 2.0 ** -rng.integers(0, 20) if rng.random() < 0.5 else 1.0
    x, y = np.meshgrid(*(np.linspace(0, 1, n) for n in count), indexing="ij")
    points = np.stack([x, y, np.zeros(count)], -1)
    points += rng.normal(size=points.shape) * [0.2 / count[0], 0.2 / count[1], 0.3]
    points = np.round(points * 2**20) / 2**20 * [1.0, thin, thin]
    return degree, (u, v), points, random_weights(rng, count), (periodic_u, periodic_v)


def moved(rng, points):
    """As large as doubles allow for, or far from the origin: what is measured stays, but for a power of two."""
    if rng.random() < 0.4:
        exponent = int(rng.integers(-490, 490))
        return points * 2.0**exponent, exponent
    is_fine = np.abs(points[..., 1:]).max() < 2**-6
    return points + (0.0 if is_fine else rng.choice([0.0, 2.0**20, -(2.0**26)])), 0


def said(error):
    """The tolerance and the error that a refusal tells."""
    return [float(number) for number in re.fullmatch(".* within (.*): the error would be (.*)", str(error)).groups()]


def kept(measure, truth, unsure):
    """How many times the tolerance each result is off, at most; refusals must not contradict themselves."""
    worst = {}
    for tolerance in TOLERANCES:
        try:
            found = measure(**({} if tolerance is None else {"tolerance": tolerance}))
        except sc.ToleranceNotReached as error:
            allowed, wrong = said(error)
            assert wrong > allowed, str(error)
            continue
        allowed = tolerance or 1e-12
        assert abs(found / truth - 1) <= allowed + unsure + ROUNDING, (tolerance, found, truth, unsure)
        worst[tolerance] = abs(found / truth - 1) / allowed
    return worst


def check_curve(rng):
    degree, knots, points, weights, periodic = random_curve(rng)
    truth, unsure = dense_rules.settled_length(degree, knots - knots[0], points, weights, periodic)
    given, exponent = moved(rng, points)
    rational = None if (weights == 1).all() else weights * 2.0 ** int(rng.integers(-400, 400))
    curve = sc.NurbsCurve(degree, knots, given, rational, periodic=periodic)
    return kept(lambda **how: math.ldexp(curve.length(**how), -exponent), truth, unsure), unsure


def check_patch(rng):
    degree, knots, points, weights, periodic = random_patch(rng)
    truth, unsure = dense_rules.settled_area(degree, [k - k[0] for k in knots], points, weights, periodic)
    given, exponent = moved(rng, points)
    rational = None if (weights == 1).all() else weights * 2.0 ** int(rng.integers(-400, 400))
    patch = sc.NurbsPatch(degree, knots, given, rational, periodic)
    return kept(lambda **how: math.ldexp(patch.area(**how), -2 * exponent), truth, unsure), unsure


@pytest.mark.parametrize("check, count", [(check_curve, 120), (check_patch, 50)])
def test_random_shapes_keep_every_tolerance(check, count, inputs):
    rng, count = np.random.default_rng(23), inputs(count)
    found = [check(rng) for _ in range(count)]
    sure = [worst for worst, unsure in found if unsure < 1e-10]
    assert len(sure) > 0.9 * count
    for tolerance in TOLERANCES[:3]:
        reached = [worst[tolerance] for worst in sure if tolerance in worst]
        assert len(reached) > 0.9 * len(sure) and max(reached) <= 1.0


SQUARE = np.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]], float)


def square(weights, points=SQUARE):
    return sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, points, weights)


@pytest.mark.parametrize("wild", [1e-100, 1e-30, 1e-16, 1e-12, 1e-4, 1e4, 1e12, 1e16, 1e30])
def test_wild_weights_change_no_area(wild):
    both = [[1, 1], [wild, wild]], [[1, wild], [1, wild]], [[wild, 1], [1, wild]], [[1, wild], [wild, 1]]
    corners = [np.where(np.arange(4).reshape(2, 2) == i, wild, 1.0) for i in range(4)]
    for weights in [*both, *corners]:
        for sign in (1.0, -1.0):
            assert abs(square(sign * np.array(weights)).area() - 1.0) <= 1e-12, (wild, weights)
    wavy = np.random.default_rng(8).normal(size=(2, 2, 3))
    u, v = np.meshgrid(*[np.linspace(-1, 1, 200)] * 2)
    found = [square(weights, wavy).area(tolerance=1e-9) for weights in both[:2]]
    assert abs(found[0] / square(None, wavy).area() - 1) <= 1e-9  # the same points at other parameters
    assert abs(found[1] / found[0] - 1) <= 2e-9


def test_areas_of_weights_of_zero_and_below_are_found_where_the_patch_is_finite():
    knots = [0, 0, 0, 1, 1, 1]
    half = [[(1, 0, 0), (1, 0, 1)], [(0, 1, 0), (0, 1, 0)], [(-1, 0, 0), (-1, 0, 1)]]
    weights = np.array([[1, 1], [0, 0], [1, 1]])
    for turned in (False, True):
        net, w = (np.swapaxes(half, 0, 1), weights.T) if turned else (half, weights)
        order = ((1, 2), ([0, 0, 1, 1], knots)) if turned else ((2, 1), (knots, [0, 0, 1, 1]))
        assert abs(sc.NurbsPatch(*order, net, w).area() / math.pi - 1) <= 1e-12
    beyond = [[(1, 0, 0), (1, 0, 1)], [(1, 1, 0), (1, 1, 1)], [(0, 1, 0), (0, 1, 1)]]
    for middle, angle in ((math.sqrt(0.5), 0.5), (-math.sqrt(0.5), 1.5)):
        patch = sc.NurbsPatch((2, 1), (knots, [0, 0, 1, 1]), beyond, [[1, 1], [middle, middle], [1, 1]])
        assert abs(patch.area() / (angle * math.pi) - 1) <= 1e-12


def test_weights_beyond_all_measure_are_refused_in_words():
    with pytest.raises(sc.InvalidShape, match="the weights of the patch differ too much in size for it"):
        square([[1, 1], [1, 1e250]]).area()


@pytest.mark.parametrize("weights", [
    [1e250, 1, 1], [1, 1, 1e250], [1, 1e250, 1], [1e-250, 1, 1e-250, 1], [1e250, 1, 1e250, 1],
    [1, 1, 1, 1, 1, 1e250], [10**157.7, 10**47.2, 10**207.1, 10**133.4, 10**247.7, 10**24.3],
])
def test_lengths_with_weights_near_the_largest_numbers_are_found(weights):
    rng = np.random.default_rng(9)
    for _ in range(20):
        points = rng.normal(size=(len(weights), 3))
        curve = sc.BezierCurve(points, weights)
        way = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        found = curve.length()
        assert np.linalg.norm(points[-1] - points[0]) * (1 - 1e-13) <= found <= way * (1 + 1e-13)
        assert abs(curve.length(tolerance=1e-6) / found - 1) <= 1e-6
        assert abs(curve.length(0, 0.5) + curve.length(0.5, 1) - found) <= 1e-12 * found


def test_domains_far_from_zero_lose_no_digit():
    rng = np.random.default_rng(10)
    step = 2.0**-13  # between neighbors at 1e12
    for start, size in ((1e7, 1.0), (-1e7, 1.0), (1e12, 80 * step)):
        inner = np.sort(rng.choice(np.arange(1, 80), 5, replace=False)) / 80.0
        knots = np.concatenate([[0] * 4, inner, [1] * 4])
        far = start + (np.round(knots * 2**20) / 2**20 if size == 1.0 else np.round(knots * 80) * step)
        near = far - start
        points, weights = rng.normal(size=(9, 3)), rng.uniform(0.5, 2, 9)
        there, here = (sc.NurbsCurve(3, u, points, weights) for u in (far, near))
        assert abs(there.length() / here.length() - 1) <= 1e-14
        middle = there.length(start + 0.25 * size, start + 0.75 * size)
        assert abs(middle / here.length(0.25 * size, 0.75 * size) - 1) <= 1e-12
        net, weights = rng.normal(size=(9, 9, 3)), rng.uniform(0.5, 2, (9, 9))
        there, here = (sc.NurbsPatch((3, 3), (u, u), net, weights) for u in (far, near))
        assert abs(there.area(tolerance=1e-9) / here.area(tolerance=1e-9) - 1) <= 1e-13


def test_a_refusal_speaks_of_the_patch_as_it_was_given():
    """Folded along lines that are no lines of its parameters: with every digit it is too much work."""
    net = np.random.default_rng(11).normal(size=(5, 5, 2))
    for size in (2.0**-100, 1.0, 2.0**100):
        points = np.concatenate([net, np.zeros((5, 5, 1))], -1) * size
        with pytest.raises(sc.ToleranceNotReached, match="the area cannot be found within") as caught:
            sc.NurbsPatch((4, 4), ([0] * 5 + [1] * 5,) * 2, points).area(tolerance=1e-13)
        area = sc.NurbsPatch((4, 4), ([0] * 5 + [1] * 5,) * 2, points).area(tolerance=1e-5)
        allowed, wrong = said(caught.value)
        assert 0.99e-13 * area < allowed < wrong < 1e-5 * area
