"""Verbs refuse bad input in a sentence and change nothing; numbers of any size are served or refused."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import circle, closed_cubic, cubic, nurbs_curves
from test_extremes import assert_finite_or_refused, number, row

NAN, INF = math.nan, math.inf

REFUSED = [
    (lambda c: c.elevate(-1), "times = -1 is below 0"),
    (lambda c: c.elevate(254), "times = 254: the degree would exceed 255"),
    (lambda c: c.elevate(10**9), "times = 1000000000: the degree would exceed 255"),
    (lambda c: c.elevate(10**30), "times = 10{30}"),
    (lambda c: c.reduce(0), r"times = 0 is outside \[1, 1\]"), (lambda c: c.reduce(2), "times = 2 is outside"),
    (lambda c: c.reduce(-(10**30)), "times = -10{30}"),
    (lambda c: c.reduce(1, -1), "tolerance = -1 is below 0"), (lambda c: c.reduce(1, NAN), "tolerance = nan"),
    (lambda c: c.reduce(tolerance=INF), "tolerance = inf"),
    (lambda c: c.remove_knot(0), "u = 0 is not a knot that can be removed"),
    (lambda c: c.remove_knot(4), "u = 4 is not a knot that can be removed"),
    (lambda c: c.remove_knot(0.5), "u = 0.5 is not a knot that can be removed"),
    (lambda c: c.remove_knot(1, 3), r"times = 3 is outside \[1, 2\]"),
    (lambda c: c.remove_knot(1, 0), r"times = 0 is outside \[1, 2\]"),
    (lambda c: c.remove_knot(9), r"u = 9 is outside the domain \[0, 4\]"),
    (lambda c: c.remove_knot(NAN), "u = nan"), (lambda c: c.remove_knot(1, 1, -1e-300), "tolerance = -1e-300"),
    (lambda c: c.remove_knot(1, 1, NAN), "tolerance = nan"),
    (lambda c: c.remove_knots(-1), "tolerance = -1"), (lambda c: c.remove_knots(NAN), "tolerance = nan"),
    (lambda c: c.remove_knots(INF), "tolerance = inf"),
    (lambda c: c.insert_knot(0.5, 4), "times = 4|multiplicity"), (lambda c: c.refine([1, NAN]), r"knots\[1\] = nan"),
    (lambda c: c.split(-1), "u = -1 is not inside"), (lambda c: c.moebius(NAN), "rho = nan"),
    (lambda c: c.multiplied(0, 1), "start = 0 is not"), (lambda c: c.multiplied(1, NAN), "end = nan is not"),
    (lambda c: c.moebius(1e-200), "range of numbers"), (lambda c: c.largest_distance(cubic()), "the domains differ"),
    (lambda c: closed_cubic().remove_knot(0), "u = 0 is not a knot that can be removed"),
    (lambda c: closed_cubic().reduce(3), r"times = 3 is outside \[1, 2\]"),
    (lambda c: sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 1)]).reduce(), "a curve needs degree 1 or more"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    curve = circle()
    with pytest.raises(sc.InvalidShape, match=words):
        call(curve)
    assert curve == circle()


NOT_A_NUMBER = ["1", [1, 2], 1j, object(), {}, b"1", True]
TAKES_A_NUMBER = {
    "u": [lambda bad: circle().remove_knot(bad), lambda bad: circle().split(bad),
          lambda bad: circle().insert_knot(bad)],
    "times": [lambda bad: circle().elevate(bad), lambda bad: circle().reduce(bad),
              lambda bad: circle().remove_knot(1, bad)],
    "tolerance": [lambda bad: circle().remove_knot(1, 1, bad), lambda bad: circle().reduce(1, bad),
                  lambda bad: circle().remove_knots(bad)],
}


@pytest.mark.parametrize("argument", TAKES_A_NUMBER)
@pytest.mark.parametrize("bad", NOT_A_NUMBER, ids=repr)
def test_what_is_no_number_raises_type_error_that_names_the_argument(argument, bad):
    for call in TAKES_A_NUMBER[argument]:
        with pytest.raises(TypeError, match=f"^{argument} "):
            call(bad)


def test_what_is_missing_is_asked_for():
    for call in (circle().remove_knot, circle().remove_knots, circle().elevate):
        with pytest.raises(TypeError, match=r"is missing: a number|must be an integer"):
            call(None)
    for call in (circle().remove_knot, circle().remove_knots, circle().with_domain, circle().transformed):
        with pytest.raises(TypeError):
            call()


@pytest.mark.parametrize("bad", [None, 3, "curve", circle().to_bezier()[0]])
def test_what_is_no_nurbs_curve_raises_type_error(bad):
    with pytest.raises(TypeError):
        circle().largest_distance(bad)


VERBS = {
    "elevate": lambda c: c.elevate(2), "reduce": lambda c: c.elevate().reduce(), "unclamped": lambda c: c.unclamped(),
    "remove_knot": lambda c: c.insert_knot(0.3, 2).remove_knot(0.3, 2), "remove_knots": lambda c: c.remove_knots(0),
    "clamped": lambda c: c.clamped(), "with_domain": lambda c: c.with_domain((3, 9)).with_domain((0, 1)),
}


@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1e150, 1e300])
@pytest.mark.parametrize("verb", VERBS)
def test_verbs_do_not_depend_on_the_units(verb, scale):
    points = np.random.default_rng(2).uniform(-1, 1, (5, 3))
    base = sc.NurbsCurve(3, [0] * 4 + [0.5] + [1] * 4, points, [1, 2, 0.5, 1, 1])
    changed = VERBS[verb](base.with_points(base.points * scale))
    curve, bound = changed if isinstance(changed, sc.Approximation) else (changed, 0)
    u = np.linspace(0, 1, 33)
    assert np.abs(curve.evaluate(u) / scale - base.evaluate(u)).max() <= 1e-13 and bound <= 1e-13 * scale
    weighted = VERBS[verb](base.with_weights(base.weights * scale))
    weighted = weighted.value if isinstance(weighted, sc.Approximation) else weighted
    assert np.abs(weighted.evaluate(u) - base.evaluate(u)).max() <= 1e-13


@pytest.mark.parametrize("scale", [1e-150, 1e150])
def test_distances_do_not_depend_on_the_units(scale):
    one, other = circle(), circle().transformed(np.diag([1, 2, 1]))
    large = one.with_points(one.points * scale).largest_distance(other.with_points(other.points * scale))
    assert math.isclose(large / scale, one.largest_distance(other), rel_tol=0.01)


@pytest.mark.parametrize("verb", [*VERBS, "join", "joints", "to_periodic", "transformed", "polylines"])
@given(st.lists(row, min_size=5, max_size=5), st.lists(number, min_size=5, max_size=5), number)
def test_every_result_is_finite_or_refused(verb, points, weights, a):
    more = {
        "join": lambda c: [c.join(c, kind).value for kind in ("C0", "G1", "C1", "C2")],
        "joints": lambda c: [[one.angle, one.c, one.g] for _, one in c.joints()],
        "to_periodic": lambda c: c.to_periodic(abs(a)), "transformed": lambda c: c.transformed(np.diag([1, 1, 1, a])),
        "polylines": lambda c: [points for points, _ in c.polylines(3, abs(a) or 1)],
    }

    def call():
        curve = sc.NurbsCurve(3, [0, 0, 0, 0, 0.5, 1, 1, 1, 1], points, weights)
        result = {**VERBS, **more}[verb](curve)
        if isinstance(result, sc.Approximation):
            assert result.error >= 0
            return result.value
        return result

    assert_finite_or_refused(call)


@given(nurbs_curves(rational=False))
def test_a_polynomial_curve_stays_one(curve):
    start, end = curve.domain
    u = start + 0.37 * (end - start)
    lower = [curve.reduce().value] if curve.degree > 1 else []
    for after in (curve.elevate(3), curve.refine(np.linspace(start, end, 9)[1:-1]), curve.unclamped(), curve.clamped(),
                  *curve.split(u), curve.insert_knot(u).remove_knot(u).value, curve.join(curve, "C1").value, *lower):
        assert not after.is_rational


def test_calls_of_modeling_take_a_hundred_random_points():
    rng = np.random.default_rng(4)
    wild = sc.NurbsCurve(9, np.r_[[0] * 9, range(92), [91] * 9], rng.normal(size=(100, 3)), rng.uniform(0.1, 4, 100))
    assert np.isclose(wild.elevate(3).largest_distance(wild.with_points(wild.points + 0.1)), 0.1 * math.sqrt(3), rtol=1e-6)
    assert wild.reduce(2).value.degree == 7
    assert wild.remove_knots(0.5).error <= 0.5
    assert all(found.c >= 2 for _, found in wild.join(wild, "C2").value.joints())
