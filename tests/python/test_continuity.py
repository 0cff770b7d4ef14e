"""How smoothly curves go on where they meet: gap, angle, curvature, C and G (row S16)."""

import math
import time

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve, random_curves
from shapes import circle, closed_cubic, cubic, hyperbola, random_points


def values(found):
    return found.gap, found.angle, found.curvature_difference, found.c, found.g


def curve(degree, knots, points, weights=None):
    return sc.NurbsCurve(degree, knots, points, weights)


def arc(radius, start, sweep, center=(0, 0), middle=1.0):
    """A circular arc as one rational quadratic; another middle weight makes it another conic."""
    def at(angle, size=1.0):
        return center[0] + radius * size * math.cos(angle), center[1] + radius * size * math.sin(angle)

    half = sweep / 2
    points = [at(start), at(start + half, 1 / math.cos(half)), at(start + sweep)]
    return curve(2, [0, 0, 0, 1, 1, 1], points, [1, middle * math.cos(half), 1])


def test_a_value_that_only_measures_make():
    found = circle().continuity(1)
    assert isinstance(found, sc.Continuity) and repr(found) == (
        "Continuity(gap=0, angle=0, curvature_difference=0, c=1, g=2)")
    with pytest.raises(TypeError):
        sc.Continuity()
    with pytest.raises(AttributeError):
        found.gap = 3


def test_arcs_of_one_circle_go_on_with_one_curvature():
    equal = arc(1, 0, 1).continuity_to(arc(1, 1, 1))
    assert (equal.c, equal.g) == (1, 2) and equal.gap == 0
    assert equal.angle <= 1e-15 and equal.curvature_difference <= 4e-15
    faster = arc(1, 0, 1).continuity_to(arc(1, 1, 2))
    assert (faster.c, faster.g) == (0, 2)


@pytest.mark.parametrize("radius", [0.01, 0.5, 2, 100])
def test_a_smaller_circle_inside_differs_by_its_curvature(radius):
    touching = arc(radius, 1, 1, center=((1 - radius) * math.cos(1), (1 - radius) * math.sin(1)))
    found = arc(1, 0, 1).continuity_to(touching)
    assert (found.c, found.g) == (0, 1) and found.angle <= 1e-13
    assert math.isclose(found.curvature_difference, abs(1 / radius - 1), rel_tol=1e-11)


def test_circles_that_touch_from_outside_bend_opposite_ways():
    found = arc(1, 0, 1).continuity_to(arc(0.5, 1 + math.pi, -1, center=(1.5 * math.cos(1), 1.5 * math.sin(1))))
    assert found.g == 1 and math.isclose(found.curvature_difference, 1 + 2, rel_tol=1e-12)


@pytest.mark.parametrize("weight", [0.25, 0.5, 2])
def test_the_curvature_at_the_end_of_a_conic_falls_with_the_square_of_its_middle_weight(weight):
    found = arc(1, 0, 1).continuity_to(arc(1, 1, 1, middle=weight))
    assert math.isclose(found.curvature_difference, abs(1 / weight**2 - 1), rel_tol=1e-12) and found.g == 1


@pytest.mark.parametrize("angle", [0, 1e-9, 1e-7, 5e-5, 1e-3, 0.5, math.pi / 2, 3, math.pi])
def test_the_angle_of_two_lines_is_the_angle(angle):
    turn = (1 + math.cos(angle), math.sin(angle))
    (_, found), *_ = curve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), turn]).joints()
    assert abs(found.angle - angle) <= 1e-15 + 1e-9 * angle and found.gap == 0
    assert (found.c, found.g) == ((1, 2) if angle <= 1e-8 else (0, 0))


def test_a_gap_has_a_length_and_no_continuity():
    found = curve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (4, 4), (5, 4)]).continuity(1)
    assert values(found) == (5, 0, 0, -1, -1)
    assert circle().continuity_to(circle().transformed(np.c_[np.eye(3), (0, 0, 0.25)])).gap == 0.25


@pytest.mark.parametrize("degree", range(1, 10))
def test_a_knot_of_multiplicity_m_is_p_minus_m_times_smooth(degree):
    for times in range(degree + 2):
        count = degree + 1 + times
        knots = [0] * (degree + 1) + [1] * times + [2.5] * (degree + 1)
        weights = np.random.default_rng(times).uniform(0.5, 2, count)
        found = curve(degree, knots, random_points(count, seed=degree), weights).continuity(1)
        assert found.c == degree - times
        assert found.g == (max(2, found.c) if found.c >= 2 or times == 0 else found.c)


def test_joints_of_a_thousand_curves_have_the_continuity_of_their_knots():
    seen = 0
    for which in random_curves(50, positive=True):
        start, end = which.domain
        found = dict(which.joints())
        inner = np.unique(which.knots[(which.knots > start) & (which.knots < end)])
        assert set(inner) <= set(found) <= {start, *inner}
        assert not which.periodic or start in found
        for u in inner:
            assert found[u].c == which.degree - (which.knots == u).sum()
            assert values(found[u]) == values(which.continuity(u))
        seen += len(inner)
    assert seen > 1000


def test_inserted_knots_are_joints_without_a_difference():
    for index, which in enumerate(random_curves(51, 300, positive=True)):
        start, end = which.domain
        u = start + np.random.default_rng(index).uniform(0.2, 0.8) * (end - start)
        found = dict(which.insert_knot(u).joints())[u]
        assert found.c == which.degree and found.g >= 2


def test_the_seam_of_a_closed_curve_is_a_joint():
    assert [u for u, _ in circle().joints()] == [1, 2, 3, 0]
    assert [u for u, _ in closed_cubic().joints()] == [0, 1, 2.5, 3, 4]
    assert all((one.c, one.g) == (2, 2) for _, one in closed_cubic().joints())
    assert values(closed_cubic().continuity(6)) == values(closed_cubic().continuity(0))
    assert 0 not in dict(cubic().joints())


def test_a_degenerate_tangent_takes_its_direction_from_the_next_derivative():
    stopped = curve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(-1, 1), (0, 0), (0, 0), (0, 0), (1, 1)])
    ((_, corner),) = stopped.joints()
    assert (corner.c, corner.g) == (1, 0) and math.isclose(corner.angle, math.pi / 2)
    line = curve(3, [0] * 4 + [1] * 4, [(0, 0), (1, 0), (1, 0), (1, 0)])
    onwards = curve(3, [0] * 4 + [1] * 4, [(1, 0), (1, 0), (1, 0), (2, 0)])
    assert values(line.continuity_to(onwards)) == (0, 0, 0, 3, 2)


def test_a_cusp_turns_back_and_its_curvature_has_no_bound():
    """(t², t³) from t = -1 to 1 in Bernstein form."""
    cusp = curve(3, [-1] * 4 + [1] * 4, [(1, -1), (-1 / 3, 1), (-1 / 3, -1), (1, 1)])
    found = cusp.continuity(0)
    assert (found.gap, found.angle, found.curvature_difference, found.c, found.g) == (0, math.pi, math.inf, 3, 0)


def test_a_parabola_through_its_vertex_with_a_double_root_keeps_its_curvature():
    """(t², t⁴) for t > 0, whose curvature at the origin is 2, against the x axis."""
    bent = curve(4, [0] * 5 + [1] * 5, [(0, 0), (0, 0), (1 / 6, 0), (0.5, 0), (1, 1)])
    straight = curve(1, [0, 0, 1, 1], [(-1, 0), (0, 0)])
    found = straight.continuity_to(bent)
    assert math.isclose(found.curvature_difference, 2, rel_tol=1e-12) and (found.angle, found.c, found.g) == (0, 0, 1)


def test_a_point_at_infinity_has_no_continuity():
    parabola = hyperbola().to_nurbs().with_weights([1, -1, 1])
    with pytest.raises(sc.PointAtInfinity, match="u = 0.5"):
        parabola.continuity(0.5)
    far = curve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 0), (2, 1), (3, 0), (4, 0)], [1, 1, 0, 1, 1])
    assert far.joints() == []
    with pytest.raises(sc.PointAtInfinity, match="u = 3"):
        curve(1, [2, 2, 3, 3], [(0, 0), (1, 1)], [1, 0]).continuity_to(circle())
    with pytest.raises(sc.PointAtInfinity, match="u = 2"):
        circle().continuity_to(curve(1, [2, 2, 3, 3], [(0, 0), (1, 1)], [0, 1]))


@pytest.mark.parametrize("turn", [5e-5, 2e-8, 1e-10])
def test_direction_and_derivative_are_judged_by_one_tolerance(turn):
    """A line goes on as one of another speed: a corner for both, or for neither."""
    first = sc.BezierCurve([(0, 0), (1, 0)]).to_nurbs()
    corner = sc.BezierCurve([(1, 0), (1 + math.cos(turn), math.sin(turn))]).to_nurbs()
    slower = sc.BezierCurve([(1, 0), (1 + math.cos(turn) / 2, math.sin(turn) / 2)]).to_nurbs()
    is_corner = turn > 1e-8
    assert first.continuity_to(corner).c == (0 if is_corner else 1)
    for other in (corner, slower):
        assert first.continuity_to(other).g == (0 if is_corner else 2)
        assert first.continuity_to(other, turn / 2).g == 0 and first.continuity_to(other, 2 * turn).g == 2


def test_rounding_alone_makes_no_corner():
    """Far from the origin, and after verbs, ends that were smooth are smooth."""
    one = curve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [(0, 0), (1, 2), (3, 1), (4, -2), (6, 0), (7, 1)])
    for shift in (0, 1e6, 1e10):
        moved = one.with_points(one.points + [shift, -shift, shift])
        for before, after in (moved.split(1.3), moved.elevate(2).split(2), moved.split(0.7)):
            found = before.continuity_to(after)
            assert found.c >= 2 and found.g >= 2, (shift, found)
            assert before.moebius(3).continuity_to(after).g == 2, shift


def test_a_looser_tolerance_forgives_more():
    kinked = curve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (2, 1e-3)])
    assert [(kinked.continuity(1, most).c, kinked.continuity(1, most).g) for most in (0, 1e-8, 1e-5, 1e-2)] == [
        (0, 0), (0, 0), (0, 0), (1, 2)]


@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1e150, 1e300])
def test_measures_do_not_depend_on_the_units(scale):
    rng = np.random.default_rng(6)
    for _ in range(20):
        which = random_curve(rng, degree=4, ends="clamped", spans=3)
        for (u, one), (v, other), (t, longer), (_, heavy) in zip(
                which.joints(), which.with_points(which.points * scale).joints(),
                which.with_domain((0, scale)).joints(), which.with_weights(which.weights * scale).joints()):
            assert u == v and 0 <= t <= scale
            assert (one.c, one.g) == (other.c, other.g) == (longer.c, longer.g) == (heavy.c, heavy.g)
            assert np.allclose([other.angle, longer.angle, heavy.angle], one.angle, rtol=1e-6, atol=1e-9)
            found = [other.curvature_difference * scale, longer.curvature_difference, heavy.curvature_difference]
            assert np.allclose(found, one.curvature_difference, rtol=1e-6, atol=1e-9)


REFUSED = [
    (lambda: circle().continuity(0), "u = 0 is an end of the curve"),
    (lambda: circle().continuity(4), "u = 4 is an end"),
    (lambda: circle().continuity(4.5), r"u = 4.5 is outside the domain \[0, 4\]"),
    (lambda: circle().continuity(math.nan), "u = nan"), (lambda: circle().continuity(1, -1e-9), "tolerance = -1e-09"),
    (lambda: circle().continuity(1, math.nan), "tolerance = nan"), (lambda: circle().joints(-1), "tolerance = -1"),
    (lambda: circle().continuity_to(circle(), math.inf), "tolerance = inf"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("bad", [None, "a", [1, 2], 1j, object(), True])
def test_what_is_of_another_type_raises_type_error(bad):
    for call in (circle().continuity, circle().joints):
        with pytest.raises(TypeError):
            call(bad)


@pytest.mark.parametrize("bad", [None, "a", [1, 2], 1j, object(), True])
def test_what_is_no_curve_is_named(bad):
    for call in (circle().continuity_to, circle().join):
        with pytest.raises(sc.InvalidShape, match=f"other is {type(bad).__name__}, a curve is expected"):
            call(bad)


def test_work_on_joints_and_seams_grows_with_their_number():
    """In the processor's time, of the best of some: eight times as much takes no twenty times as long."""

    def seconds(work):
        best = np.inf
        for _ in range(3):
            before = time.process_time()
            work()
            best = min(best, time.process_time() - before)
        return best

    def shapes(count):
        knots = np.arange(count + 4.0)
        points = np.random.default_rng(count).normal(size=(count, 2, 3))
        return sc.NurbsCurve(3, knots, points[:, 0]), sc.NurbsPatch((3, 1), (knots, [0, 0, 1, 1]), points)

    few, many = shapes(1000), shapes(8000)
    assert seconds(many[0].joints) < 20 * seconds(few[0].joints)

    def seam(patch):
        return sc.seam_continuity(patch, 'v_start', patch, 'v_start')

    assert seconds(lambda: seam(many[1])) < 20 * seconds(lambda: seam(few[1]))
