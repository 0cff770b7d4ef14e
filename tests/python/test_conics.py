"""Conics: closed forms, what each construction promises, and equations against exact fractions."""

import copy
import math
import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import splinecore as sc
from shapes import coordinates, inside, positive
from splinecore import conics

FORMS = ["square", "triangle", "halves", "single"]
vectors = st.tuples(coordinates, coordinates, coordinates)
small = st.integers(-9, 9)


def terms(conic, points):
    """Value of the equation at points, relative to its largest term at their size."""
    offset = np.asarray(points) - conic.origin
    x, y = offset @ conic.x_axis, offset @ conic.y_axis
    size = max(1.0, np.abs(x).max(), np.abs(y).max())
    value = np.stack([x * x, x * y, y * y, x, y, np.ones_like(x)], axis=-1) @ conic.coefficients
    return np.abs(value).max() / (np.abs(conic.coefficients) * ([size**2] * 3 + [size] * 2 + [1])).max()


def exact_value(coefficients, point):
    a, b, c, d, e, f = (Fraction(k) for k in coefficients)
    x, y = point
    return a * x * x + b * x * y + c * y * y + d * x + e * y + f


def exact_point(points, weights, t):
    basis = [(1 - t) ** 2, 2 * t * (1 - t), t * t]
    w = sum(b * v for b, v in zip(basis, weights))
    return [sum(b * v * p[k] for b, v, p in zip(basis, weights, points)) / w for k in range(2)] if w else None


def exact_type(coefficients):
    """The type of a conic with integer coefficients, by its exact determinants."""
    a, b, c, d, e, f = coefficients
    big = 4 * a * c * f + b * d * e - a * e * e - c * d * d - f * b * b
    small_one = 4 * a * c - b * b
    if a == b == c == 0:
        return "line" if d or e else "empty"
    if small_one > 0:
        if big == 0:
            return "point"
        if (a + c) * big > 0:
            return "empty"
        return "circle" if a == c and b == 0 else "ellipse"
    if small_one < 0:
        return "crossing_lines" if big == 0 else "hyperbola"
    if big != 0:
        return "parabola"
    spread = d * d - 4 * a * f + e * e - 4 * c * f
    return "parallel_lines" if spread > 0 else "line" if spread == 0 else "empty"


@pytest.mark.parametrize("form", FORMS)
def test_a_circle_has_its_radius(form):
    curve = conics.circle((1, 2, 3), 5, form=form)
    offsets = curve.evaluate(inside(curve.domain, 1001)) - (1, 2, 3)
    assert np.abs(np.linalg.norm(offsets, axis=1) - 5).max() <= 5e-15
    assert np.array_equal(curve.points[0], curve.points[-1])
    unit = conics.circle((0, 0), 1, form=form)
    assert np.abs(np.linalg.norm(unit.evaluate(inside(unit.domain, 1001)), axis=1) - 1).max() <= 1e-15


@given(vectors, vectors, st.sampled_from(FORMS))
def test_an_ellipse_is_an_affine_circle(a, b, form):
    try:
        curve = conics.ellipse((1, 2, 3), a, b, form=form)
    except sc.InvalidShape:
        assert np.linalg.norm(np.cross(a, b)) <= 1e-12 * np.linalg.norm(a) * np.linalg.norm(b)
        return
    u = inside(curve.domain, 40)
    xy = conics.circle((0, 0), 1, form=form).evaluate(u)[:, :2]
    size = 1 + max(np.abs(a).max(), np.abs(b).max())
    assert np.abs(curve.evaluate(u) - ((1, 2, 3) + xy @ np.array([a, b]))).max() <= 1e-14 * size


@given(st.floats(-9, 9), st.floats(0.01, 6.28), st.booleans(), st.integers(0, 5))
def test_an_arc_begins_and_ends_at_its_angles(start, sweep, clockwise, spans):
    sweep = -sweep if clockwise else sweep
    curve = conics.arc((0, 0), (1, 0), (0, 1), start, sweep, span_count=spans)
    ends = curve.evaluate(curve.domain)[:, :2]
    wanted = [(math.cos(a), math.sin(a)) for a in (start, start + sweep)]
    assert np.abs(ends - wanted).max() <= 1e-14
    middle = curve.evaluate(sum(curve.domain) / 2)
    angle = start + sweep / 2
    if abs(sweep) < 5 * curve.domain[1]:
        assert np.abs(middle[:2] - (math.cos(angle), math.sin(angle))).max() <= 1e-12


def test_half_a_turn_in_one_span_has_a_direction_in_its_middle():
    half = conics.arc((0, 0), (1, 0), (0, 1), 0, math.pi, 1)
    assert half.weights.tolist() == [1, 0, 1] and half.points[1].tolist() == [0, 1, 0]
    assert conics.class_of(half) == "half_ellipse"


SLIDER = [(-3, "three_hyperbola_arcs", 3), (-1, "two_parabola_arcs", 2), (-0.6, "longer_ellipse_arc", 1),
          (0, "segment", 1), (0.6, "shorter_ellipse_arc", 1), (1, "parabola_arc", 1), (3, "hyperbola_arc", 1)]


@pytest.mark.parametrize("w1, name, count", SLIDER)
def test_the_middle_weight_gives_the_seven_classes(w1, name, count):
    curve = conics.conic_arc((-1, 0), (0, 1), (1, 0), w1)
    assert conics.class_of(curve) == name
    for length in (1.0, 10.0, 1e3, 1e6):
        arcs = curve.finite_arcs(length)
        assert len(arcs) == count or length < 10
        for arc in arcs:
            assert (arc.weights > 0).all() and np.abs(arc.points).max() <= 1 + 2 * length
            u = inside(arc.domain)
            points = arc.evaluate(u)
            assert np.abs(points[:, 0]).max() <= 1 + length and points[:, 1].min() >= -length - 1e-6 * length
            assert np.abs(points - curve.evaluate(u)).max() <= 1e-13 * (1 + length) ** 2


@given(st.floats(-4, 4), positive)
def test_no_slider_position_gives_far_or_undefined_points(w1, length):
    curve = conics.conic_arc((-1, 0, 2), (0, 1, 0), (1, 0, 1), w1)
    for arc in curve.finite_arcs(length):
        points = arc.evaluate(inside(arc.domain))
        assert np.isfinite(points).all() and np.abs(points).max() <= 2 + length * (1 + 1e-9)


def test_class_of_takes_any_quadratic_of_one_span():
    assert conics.class_of(sc.BezierCurve([(1, 0), (0, 0), (0, 1)], weights=[0, 1, 0])) == "hyperbola_arc"
    assert conics.class_of(sc.BezierCurve([(1, 0), (0, 5), (0, 1)], weights=[1, 0.2, -1])) == "two_hyperbola_arcs"
    assert conics.class_of(sc.BezierCurve([(1, 0), (2, 0), (0, 0)], weights=[1, -3, 1])) == "line_through_infinity"
    assert conics.class_of(sc.BezierCurve([(1, 1), (1, 1), (1, 1)])) == "point"


@given(st.lists(st.tuples(small, small), min_size=3, max_size=3), st.lists(small, min_size=3, max_size=3))
def test_the_equation_of_a_curve_holds_in_exact_fractions(points, weights):
    if any(w == 0 for w in weights):
        return
    curve = sc.BezierCurve(points, weights)
    (x0, y0), (x1, y1), (x2, y2) = points
    if (x1 - x0) * (y2 - y0) == (x2 - x0) * (y1 - y0):
        with pytest.raises(sc.InvalidShape, match="lie on one line"):
            conics.implicit(curve)
        return
    found = conics.implicit(curve).coefficients
    for t in (Fraction(1, 7), Fraction(1, 2), Fraction(9, 11)):
        point = exact_point(points, weights, t)
        if point is not None:
            size = max(abs(k) for k in found) * max(1, max(abs(v) for v in point)) ** 2
            assert abs(exact_value(found, point)) <= 1e-14 * size


@given(st.tuples(*[small] * 6), st.sampled_from([1.0, -1.0, 0.1, 1e-200, -3e150]))
def test_the_type_is_that_of_exact_determinants(coefficients, factor):
    if not any(coefficients):
        return
    conic = conics.ImplicitConic(np.array(coefficients) * factor)
    assert conic.type == exact_type(coefficients)


@given(st.tuples(*[small] * 6))
def test_curves_of_a_conic_lie_on_it_and_lead_back_to_it(coefficients):
    if not any(coefficients):
        return
    conic = conics.ImplicitConic(coefficients)
    for curve in conics.from_implicit(conic):
        for arc in curve.finite_arcs(20):
            assert terms(conic, arc.evaluate(inside(arc.domain))) <= 1e-13
        if curve.degree == 2:
            again = conics.implicit(curve.to_bezier()[0]).coefficients
            wanted = np.array(coefficients) / coefficients[np.abs(again[:3]).argmax()]
            assert np.abs(again - wanted).max() <= 1e-9 * np.abs(wanted).max()


@given(st.lists(st.tuples(small, small), min_size=5, max_size=5, unique=True))
def test_five_points_lie_on_their_conic_by_fractions(points):
    try:
        conic = conics.through_points(points)
    except sc.InvalidShape as error:
        assert "line" in str(error)
        return
    ox, oy = (Fraction(float(v)) for v in conic.origin[:2])
    assert conic.x_axis.tolist() == [1, 0, 0] and conic.y_axis.tolist() == [0, 1, 0]
    size = max(abs(k) for k in conic.coefficients) * 18**2
    for x, y in points:
        assert abs(exact_value(conic.coefficients, (x - ox, y - oy))) <= 1e-13 * size


@given(vectors, vectors, st.floats(1.05, 4), st.floats(0.1, 0.9))
def test_foci_have_the_sum_and_the_difference(f1, f2, more, less):
    gap = math.dist(f1, f2)
    if gap < 1e-3 or math.hypot(f1[0] - f2[0], f1[1] - f2[1]) < 1e-3 * gap:
        return
    size = max(1, np.abs([f1, f2]).max())
    for factor, sign, name in ((more, 1, "ellipse"), (less, -1, "hyperbola")):
        conic = conics.by_foci(f1, f2, factor * gap)
        assert conic.type == name and abs(conic.half_lengths[0] - factor * gap / 2) <= 1e-13 * size
        for curve in conics.from_implicit(conic):
            for arc in curve.finite_arcs(gap):
                points = arc.evaluate(inside(arc.domain))
                near, far = (np.linalg.norm(points - f, axis=1) for f in (f1, f2))
                assert np.abs(np.abs(near + sign * far) - factor * gap).max() <= 1e-10 * size
        assert len(conic.foci) == 2 and conic.eccentricity == pytest.approx(1 / factor, rel=1e-9)


@given(vectors, vectors, vectors)
def test_a_hyperbola_has_its_center_its_vertices_and_its_asymptotes(center, a, b):
    center, a, b = map(np.array, (center, a, b))
    assume(np.linalg.norm(np.cross(a, b)) > 1e-3 * max(1, np.linalg.norm(a) * np.linalg.norm(b)))
    for branch, sign in zip(conics.hyperbola(center, a, b), (1, -1), strict=True):
        assert np.array_equal(branch.weights, [0, 1, 1, 1, 0])
        assert np.allclose(branch.evaluate(0.5), center + sign * a, rtol=1e-12, atol=1e-9)
        u = np.linspace(0.05, 0.95, 19)
        x, y = np.linalg.lstsq(np.column_stack([a, b]), (branch.evaluate(u) - center).T, rcond=None)[0]
        assert np.allclose(x * x - y * y, 1, rtol=0, atol=1e-6 * (x * x).max())
        assert (sign * x > 0).all()


def test_a_far_hyperbola_has_control_points_at_its_vertices():
    branches = conics.from_implicit(conics.ImplicitConic([1, 0, -1, 0, 0, -400]))
    assert sorted(branch.points[2].tolist() for branch in branches) == [[-20, 0, 0], [20, 0, 0]]
    assert all(branch.polylines(16, 1.0) for branch in branches)


def test_a_parabola_is_as_far_from_its_focus_as_from_its_directrix():
    conic = conics.parabola((1, 2, 3), (0, 0, 3), (1, -1, 0))
    assert conic.type == "parabola" and conic.eccentricity == 1
    arc = conic.arc(-4, 3)
    points = arc.evaluate(inside(arc.domain))
    normal = np.array([1, 1, 0]) / math.sqrt(2)
    assert np.abs(np.linalg.norm(points - (1, 2, 3), axis=1) - np.abs((points - (0, 0, 3)) @ normal)).max() <= 1e-14
    assert np.abs(conic.foci[0] - (1, 2, 3)).max() <= 1e-14


def test_a_conic_tells_its_measures():
    conic = conics.ImplicitConic([9, 0, 25, 0, 0, -225], origin=(1, 1, 1), x_axis=(0, 2, 0), y_axis=(0, 0, 3))
    assert (conic.type, conic.half_lengths, conic.eccentricity) == ("ellipse", (5, 3), 0.8)
    assert conic.center.tolist() == [1, 1, 1] and [axis.tolist() for axis in conic.axes] == [[0, 1, 0], [0, 0, 1]]
    assert [focus.tolist() for focus in conic.foci] == [[1, -3, 1], [1, 5, 1]]
    assert repr(conic) == "ImplicitConic(ellipse)"
    assert not conic.coefficients.flags.writeable
    empty = conics.ImplicitConic([1, 0, 1, 0, 0, 1])
    assert (empty.type, empty.center, empty.foci, empty.eccentricity) == ("empty", None, [], None)


def test_conics_are_values():
    conic = conics.through_points([(1, 0, 2), (0, 1, 3), (-1, 0, 2), (0, -1, 1), (0.6, 0.8, 2.8)])
    other = conics.ImplicitConic(conic.coefficients, conic.origin, conic.x_axis, conic.y_axis)
    for same in (pickle.loads(pickle.dumps(conic)), copy.copy(conic), copy.deepcopy(conic), other):
        assert same == conic and hash(same) == hash(conic)
    assert conic != conics.ImplicitConic([1, 0, 1, 0, 0, -1]) and conic != 3


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-8])
def test_a_circle_as_hermite_is_as_near_as_it_says(tolerance):
    found = conics.as_hermite(conics.circle((0, 0), 1), tolerance)
    chain, error = found
    assert isinstance(found, sc.Approximation) and (found.value, found.error) == (chain, error)
    assert isinstance(chain, sc.HermiteCurve) and 0 < error <= tolerance
    off = np.abs(np.linalg.norm(chain.evaluate(inside(chain.domain, 3001)), axis=1) - 1).max()
    assert 0.4 * error <= off <= error + 1e-15


def test_what_cannot_be_had_as_hermite_says_so():
    with pytest.raises(sc.ToleranceNotReached):
        conics.as_hermite(conics.circle((0, 0), 1), 1e-70)
    with pytest.raises(sc.InvalidShape, match="finite_arcs"):
        conics.as_hermite(conics.conic_arc((-1, 0), (0, 1), (1, 0), -2), 1)


NAN, INF = float("nan"), float("inf")
UNIT = [1, 0, 1, 0, 0, -1]
REFUSED = [
    (lambda: conics.circle((0, 0), 0), r"radius = 0 "),
    (lambda: conics.circle((0, 0), -1), r"radius = -1"),
    (lambda: conics.circle((0, 0), NAN), r"radius"),
    (lambda: conics.circle((0, NAN), 1), r"center\[1\] = nan"),
    (lambda: conics.circle((0, 0), 1, (0, 0, 0)), r"normal has no direction"),
    (lambda: conics.circle((0, 0, 0, 0), 1), r"center has shape \(4,\)"),
    (lambda: conics.circle([(0, 0)], 1), r"center has shape \(1, 2\)"),
    (lambda: conics.circle((0, 0), 1, form="round"), r"form = 'round'"),
    (lambda: conics.circle((0, 0), 1, form=None), r"form = None"),
    (lambda: conics.ellipse((0, 0), (0, 0), (0, 1)), r"axis_a has the length 0"),
    (lambda: conics.ellipse((0, 0), (1, 1), (2, 2)), r"axis_b is parallel"),
    (lambda: conics.ellipse((0, 0), (INF, 1), (2, 2)), r"axis_a\[0\] = inf"),
    (lambda: conics.arc((0, 0), (1, 0), (0, 1), 0, 0), r"sweep = 0"),
    (lambda: conics.arc((0, 0), (1, 0), (0, 1), 0, 6.5), r"sweep = 6.5"),
    (lambda: conics.arc((0, 0), (1, 0), (0, 1), 0, 1, -2), r"span_count = -2"),
    (lambda: conics.arc((0, 0), (1, 0), (0, 1), 0, 2 * math.pi, 1), r"one span cannot"),
    (lambda: conics.by_foci((0, 0), (2, 0), 2), r"distance = 2 is that of the foci"),
    (lambda: conics.by_foci((0, 0), (2, 0), -1), r"distance = -1"),
    (lambda: conics.by_foci((0, 0), (2, 0), 3, (1, 0, 0)), r"normal lies along"),
    (lambda: conics.parabola((1, 1), (0, 0), (2, 2)), r"focus lies on the directrix"),
    (lambda: conics.parabola((1, 1), (0, 0), (0, 0)), r"directrix_direction has the length 0"),
    (lambda: conics.through_points(np.zeros((5, 3))), r"points\[0\] and points\[1\] coincide"),
    (lambda: conics.through_points(np.zeros((4, 3))), r"points has 4 rows"),
    (lambda: conics.through_points([(0, 0), (1, 0), (2, 0), (5, 0), (1, 1)]), r"points 0, 1, 2, 3 lie on one line"),
    (lambda: conics.through_points([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 2, 0), (2, 1, 5)]), r"off the plane"),
    (lambda: conics.through_points([(0, 0), (1, 0), (0, 1), (1, 2), (NAN, 1)]), r"points\[4\].x = nan"),
    (lambda: conics.through_points([(0, 0), (1, 0), (0, 1), (1, 2), (2, 1)], -1), r"tolerance = -1"),
    (lambda: conics.conic_arc((0, 0), (1, NAN), (2, 0), 1), r"p1\[1\] = nan"),
    (lambda: conics.conic_arc((0, 0), (1, 1), (2, 0), INF), r"w1 = inf"),
    (lambda: conics.class_of(sc.BezierCurve([(0, 0), (1, 1)])), r"degree = 1"),
    (lambda: conics.class_of(conics.circle((0, 0), 1)), r"curve has 4 spans"),
    (lambda: conics.implicit(sc.BezierCurve([(0, 0), (1, 1), (2, 2)])), r"lie on one line"),
    (lambda: conics.ImplicitConic([0] * 6), r"coefficients are all zero"),
    (lambda: conics.ImplicitConic([1] * 5), r"coefficients has 5 values"),
    (lambda: conics.ImplicitConic([1, 2, 3, INF, 5, 6]), r"coefficients\[3\] = inf"),
    (lambda: conics.ImplicitConic(UNIT, x_axis=(0, 0, 0)), r"x_axis has no direction: its length is 0"),
    (lambda: conics.ImplicitConic(UNIT, y_axis=(1, 0, 0)), r"y_axis is parallel"),
    (lambda: conics.ImplicitConic([0, 1, 0, 0, 0, 0]).arc(0, 1), r"only a circle"),
    (lambda: conics.ImplicitConic(UNIT).arc(1, 1), r"start = end = 1"),
    (lambda: conics.as_hermite(conics.circle((0, 0), 1), 0), r"tolerance = 0"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


BAD = [None, "ab", 1j, object(), {}, [object()], [None, None], True]


@pytest.mark.parametrize("bad", BAD, ids=lambda bad: repr(bad)[:12])
def test_what_is_of_another_type_raises_type_error(bad):
    calls = [lambda: conics.circle(bad, 1), lambda: conics.circle((0, 0), bad), lambda: conics.circle((0, 0), 1, bad),
             lambda: conics.ellipse((0, 0), bad, (0, 1)), lambda: conics.arc((0, 0), (1, 0), (0, 1), bad, 1),
             lambda: conics.arc((0, 0), (1, 0), (0, 1), 0, 1, bad), lambda: conics.by_foci(bad, (0, 1), 3),
             lambda: conics.parabola((0, 0), bad, (0, 1)), lambda: conics.through_points(bad),
             lambda: conics.conic_arc((0, 0), (1, 1), (2, 0), bad), lambda: conics.class_of(bad),
             lambda: conics.implicit(bad), lambda: conics.from_implicit(bad), lambda: conics.ImplicitConic(bad),
             lambda: conics.as_hermite(bad, 1), lambda: conics.as_hermite(conics.circle((0, 0), 1), bad),
             lambda: conics.ImplicitConic(UNIT).arc(bad, 1)]
    for call in calls:
        with pytest.raises((TypeError, sc.InvalidShape)):
            call()


def test_a_conic_that_no_constructor_made_is_refused():
    empty = conics.ImplicitConic.__new__(conics.ImplicitConic)
    with pytest.raises(TypeError):
        conics.from_implicit(empty)
