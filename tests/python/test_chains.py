"""Chains of Bezier curves: from a polygon, joined, in C2 pairs (rows S7, S8)."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import coordinates, point_lists, positive, random_points, semicircle

build = sc.build


def lectures_chain(d, u):
    """The f, g and e of row S8 in fractions; u are the knots u_3 … u_{m+3}."""
    d = [[Fraction(x) for x in point] for point in d]
    m = len(u) - 1
    h = {i + 3: Fraction(u[i + 1]) - Fraction(u[i]) for i in range(m)}

    def mix(a, p, b, q):
        return [(a * x + b * y) / (a + b) for x, y in zip(p, q)]

    if m == 1:
        return [d]
    f, g, e = {1: d[1]}, {1: mix(h[4], d[1], h[3], d[2])}, {0: d[0], m: d[m + 2]}
    for i in range(2, m):
        f[i] = mix(h[i + 2] + h[i + 3], d[i], h[i + 1], d[i + 1])
        g[i] = mix(h[i + 3], d[i], h[i + 1] + h[i + 2], d[i + 1])
    f[m], g[m] = mix(h[m + 2], d[m], h[m + 1], d[m + 1]), d[m + 1]
    for i in range(1, m):
        e[i] = mix(h[i + 3], g[i], h[i + 2], f[i + 1])
    return [[e[i], f[i + 1], g[i + 1], e[i + 1]] for i in range(m)]


@given(point_lists(4, 9), st.data())
def test_the_chain_has_the_lectures_points(points, data):
    steps = data.draw(st.lists(st.sampled_from([0.25, 1.0, 3.0]), min_size=len(points) - 3, max_size=len(points) - 3))
    u = [0.0, *np.cumsum(steps).tolist()]
    chain = build.chain_from_polygon(points, u)
    expected = lectures_chain(points, u)
    size = np.abs(points).max() + 1e-300
    assert len(chain) == len(expected)
    for curve, right in zip(chain, expected):
        assert np.abs(curve.points - np.array([[float(x) for x in p] for p in right])).max() <= 1e-15 * size * 4
    again = build.polygon_of_chain(chain, steps)
    assert np.abs(again - np.array(points)).max() <= 1e-12 * size


def test_the_chain_on_equal_steps_is_the_default():
    points = random_points(6, seed=31)
    assert build.chain_from_polygon(points) == build.chain_from_polygon(points, [5, 6, 7, 8])
    assert np.abs(build.polygon_of_chain(build.chain_from_polygon(points)) - points).max() <= 1e-13
    assert build.chain_from_polygon(points[:4]) == [sc.BezierCurve(points[:4])]


def test_a_chain_that_is_not_c2_is_refused_by_its_joint():
    chain = build.chain_from_polygon(random_points(7, seed=32))
    bent = chain[2].points.copy()
    bent[1] += 1e-3
    chain[2] = chain[2].with_points(bent)
    with pytest.raises(sc.InvalidShape, match="joint 2 is not C1"):
        build.polygon_of_chain(chain)
    assert build.polygon_of_chain(chain, tolerance=0.01).shape == (7, 3)
    with pytest.raises(sc.InvalidShape, match="joint 1 is not C"):
        build.polygon_of_chain(chain, [1, 3, 1, 1])


triples = st.tuples(coordinates, coordinates, coordinates)


@given(st.tuples(*[triples] * 5), positive, positive)
def test_a_pair_meets_with_equal_second_derivatives(places, a, b):
    q0, q1, d, r2, r3 = np.array(places)
    q, r = build.c2_pair(*places, a, b)
    assert np.array_equal(q.points[:2], [q0, q1]) and np.array_equal(r.points[2:], [r2, r3])
    size = np.abs(places).max() * (2 + a / b + b / a) + 1e-300
    assert np.array_equal(q.points[3], r.points[0])
    assert np.abs(q.points[2] + b / a * (q.points[2] - q.points[1]) - d).max() <= 1e-14 * size
    assert np.abs(r.points[1] + a / b * (r.points[1] - r.points[2]) - d).max() <= 1e-14 * size
    assert np.abs(b * (q.points[3] - q.points[2]) - a * (r.points[1] - r.points[0])).max() <= 1e-14 * size * (a + b)
    assert np.abs(build.polygon_of_chain([q, r], [a, b])[2] - d).max() <= 1e-12 * size


@given(st.lists(st.integers(1, 5), min_size=1, max_size=5), st.data())
def test_joined_curves_are_kept_segment_by_segment(degrees, data):
    curves = []
    for degree in degrees:
        points = data.draw(point_lists(degree + 1, degree + 1))
        weights = data.draw(st.lists(positive, min_size=degree + 1, max_size=degree + 1))
        if curves:
            points[0] = tuple(curves[-1].points[-1])
        curves.append(sc.BezierCurve(points, weights))
    parameters = np.arange(len(curves) + 1) ** 2 / 2
    joined = build.join_beziers(curves, parameters)
    assert joined.degree == max(degrees) and joined.domain == (0, parameters[-1])
    t = np.linspace(0, 1, 7)[:-1]
    for i, curve in enumerate(curves):
        u = parameters[i] + t * (parameters[i + 1] - parameters[i])
        assert np.abs(joined.evaluate(u) - curve.evaluate(t)).max() <= 1e-10 * (np.abs(curve.points).max() + 1)


def test_joined_curves_of_one_degree_keep_their_points():
    p = random_points(7, seed=33)
    joined = build.join_beziers([sc.BezierCurve(p[:4]), sc.BezierCurve(p[3:])])
    assert np.array_equal(joined.points, p)
    assert joined.knots.tolist() == [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2]


def test_a_direction_keeps_its_shape_when_weights_are_scaled():
    arc = sc.BezierCurve([(2, 0), (1, 0)], [3, 3])
    joined = build.join_beziers([arc, semicircle()])
    t = np.linspace(0, 1, 9)
    assert np.abs(joined.evaluate(1 + t) - semicircle().evaluate(t)).max() <= 1e-15


LINE = sc.BezierCurve([(0, 0), (1, 1)])
FAR = sc.BezierCurve([(1, 2), (3, 3)])
CUBIC = sc.BezierCurve(random_points(4, seed=34))


@pytest.mark.parametrize("call, words", [
    (lambda: build.join_beziers([LINE, FAR]), "joint 1 is open: an end lies 1 from the next start"),
    (lambda: build.join_beziers([]), "curves is empty"),
    (lambda: build.join_beziers([LINE], [0, 1, 2]), "parameters has 3 values"),
    (lambda: build.join_beziers([LINE], [0, 0]), r"parameters\[1\] = 0"),
    (lambda: build.join_beziers([LINE], tolerance=-1), "tolerance = -1"),
    (lambda: build.join_beziers([LINE], tolerance=float("nan")), "tolerance = nan"),
    (lambda: build.join_beziers([semicircle().with_weights([1, 1, 0]), LINE]), "joint 1 lies at infinity"),
    (lambda: build.chain_from_polygon(np.zeros((3, 3))), "points has 3 rows"),
    (lambda: build.chain_from_polygon(np.zeros((5, 3)), [0, 1]), "parameters has 2 values for 3"),
    (lambda: build.chain_from_polygon([(0, 0), (1, 0), (2, float("inf")), (0, 0)]), r"points\[2\].y = inf"),
    (lambda: build.polygon_of_chain([]), "chain is empty"),
    (lambda: build.polygon_of_chain([LINE]), r"chain\[0\] has degree 1"),
    (lambda: build.polygon_of_chain([CUBIC.with_weights([1, 2, 1, 1])]), r"chain\[0\] is rational"),
    (lambda: build.polygon_of_chain([CUBIC], [-1]), r"lengths\[0\] = -1"),
    (lambda: build.polygon_of_chain([CUBIC], [1, 1]), "lengths has 2 values"),
    (lambda: build.polygon_of_chain([CUBIC], tolerance=-1), "tolerance = -1"),
    (lambda: build.c2_pair((0, 0), (1, 0), (1, 1), (2, 0), (3, 0), 0), "a = 0"),
    (lambda: build.c2_pair((0, 0), (1, 0), (1, 1), (2, 0), (3, 0), 1, float("inf")), "b = inf"),
    (lambda: build.c2_pair((0, 0), (1, 0), (1, float("nan")), (2, 0), (3, 0)), r"d\[1\] = nan"),
    (lambda: build.c2_pair((0, 0), (1, 0), 1, (2, 0), (3, 0)), r"d has shape \(\)"),
    (lambda: build.c2_pair((0, 0), [(1, 0)], (1, 1), (2, 0), (3, 0)), r"q1 has shape \(1, 2\)"),
])
def test_bad_numbers_are_named(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call, words", [
    (lambda: build.join_beziers(None), "curves must be a list"), (lambda: build.join_beziers(LINE), "curves must be a list"),
    (lambda: build.join_beziers([LINE, None]), r"curves\[1\] must be a BezierCurve"),
    (lambda: build.polygon_of_chain([CUBIC.to_nurbs()]), r"chain\[0\] must be a BezierCurve"),
    (lambda: build.join_beziers([LINE], tolerance=None), "tolerance"),
    (lambda: build.chain_from_polygon("abcd"), "points"), (lambda: build.c2_pair(1, 2), ""),
    (lambda: build.c2_pair(None, (1, 0), (1, 1), (2, 0), (3, 0)), "q0"),
])
def test_what_is_of_another_type_raises_type_error(call, words):
    with pytest.raises(TypeError, match=words):
        call()
