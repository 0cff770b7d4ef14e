"""Where curves meet: closed forms, crossings that were planted, dense polylines as a second judge, and bad calls."""

import itertools

import numpy as np
import pytest
from numpy.polynomial import chebyshev

import splinecore as sc
from random_curves import ENDS, random_knots, random_weights
from splinecore import conics


def placed(x=0.0, y=0.0, z=0.0, turn=0.0):
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    matrix[:3, 3] = x, y, z
    return matrix


def scaled(factor, offset=0.0):
    matrix = np.diag([factor, factor, factor, 1.0])
    matrix[:3, 3] = offset
    return matrix


def ellipse(a, b):
    corners = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], float)
    weights = np.array([1, np.sqrt(0.5)] * 4 + [1])
    return sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], np.c_[corners * [a, b], np.zeros(9)], weights)


def line(start, end):
    return sc.BezierCurve([[*start, 0][:3], [*end, 0][:3]])


def graph(coefficients, swapped=False):
    """(t, p(t)) over [-1, 1] of Chebyshev coefficients, or (p(t), t)."""
    power = chebyshev.cheb2poly(coefficients)
    points = np.zeros((len(power), 3))
    points[:, 1] = power
    points[1, 0] = 1.0
    if swapped:
        points[:, :2] = points[:, 1::-1]
    return sc.PowerCurve(points, domain=(-1.0, 1.0))


def single(degree):
    return np.eye(degree + 1)[degree]


def sizes(*curves):
    points = np.concatenate([curve.to_nurbs().points for curve in curves])
    return np.ptp(points, axis=0).max()


def check(a, b, found, tolerance=None):
    """Every place is one of both curves, and no place is there twice."""
    size = sizes(a, b)
    tolerance = tolerance or 2.0**-33 * size * 1.01
    for (u, v), point, distance in zip(found.parameters, found.points, found.distances):
        both = np.array([a.evaluate(u), b.evaluate(v)])
        assert np.linalg.norm(both[0] - both[1]) <= tolerance + 1e-14 * size
        assert distance == pytest.approx(np.linalg.norm(both[0] - both[1]), abs=1e-12 * size)
        assert point == pytest.approx(both.mean(0), abs=1e-12 * size)
    assert len(np.unique(found.parameters, axis=0)) == len(found.parameters)


def polyline_crossings(a, b, each):
    """Parameters at which plane polylines on the curves cross."""
    def sampled(curve):
        start, end = curve.domain
        knots = np.unique(np.clip(curve.knots, start, end))
        u = [np.linspace(p, q, each) for p, q in zip(knots[:-1], knots[1:])]
        points = [np.r_[curve.evaluate(t[:-1]), curve.evaluate(t[-1:], side="left"), [[np.nan] * 3]] for t in u]
        return np.concatenate([np.r_[t, t[-1]] for t in u]), np.concatenate(points)[:, :2]

    (u, p), (v, q) = sampled(a), sampled(b)
    r, s = np.diff(p, axis=0)[:, None], np.diff(q, axis=0)[None]
    gap = q[None, :-1] - p[:-1, None]
    cross = r[..., 0] * s[..., 1] - r[..., 1] * s[..., 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (gap[..., 0] * s[..., 1] - gap[..., 1] * s[..., 0]) / cross
        w = (gap[..., 0] * r[..., 1] - gap[..., 1] * r[..., 0]) / cross
    sine = np.abs(cross) / (np.linalg.norm(r, axis=-1) * np.linalg.norm(s, axis=-1) + 1e-300)
    i, j = np.nonzero((t >= 0) & (t < 1) & (w >= 0) & (w < 1) & (sine > 0.05))
    return np.c_[u[i] + t[i, j] * np.diff(u)[i], v[j] + w[i, j] * np.diff(v)[j]]


def plane_curve(rng, degree, ends, spans):
    knots = random_knots(rng, degree, spans, ends)
    count = len(knots) - 1 if ends == "periodic" else len(knots) - degree - 1
    points = np.c_[rng.uniform(-1, 1, (count, 2)), np.zeros(count)]
    return sc.NurbsCurve(degree, knots, points, random_weights(rng, count, True), periodic=ends == "periodic")


@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5, 7, 9])
def test_plane_curves_of_every_kind_cross_where_polylines_do(degree, ends):
    rng = np.random.default_rng([degree, ENDS.index(ends)])
    count = 0
    for spans in (1, 3, 8):
        a = plane_curve(rng, degree, ends, spans)
        b = plane_curve(rng, int(rng.integers(1, 10)), ENDS[rng.integers(3)], 5)
        found = a.intersections(b)
        check(a, b, found)
        assert not len(found.overlaps)
        for place in polyline_crossings(a, b, 60):
            apart = np.abs(found.parameters - place)
            for axis, curve in enumerate((a, b)):
                length = np.diff(curve.domain)[0]
                apart[:, axis] = np.minimum(apart[:, axis], np.abs(length - apart[:, axis])) / length
            assert apart.max(1).min() < 0.02
            count += 1
        assert len(b.intersections(a).parameters) == len(found.parameters)
    assert count > 3


@pytest.mark.parametrize("degree", [*range(1, 10), 25])
def test_planted_crossings_in_space(degree):
    """A curve of degree d with its points moved by a pencil of lines through d given points of it meets it there."""
    rng = np.random.default_rng(degree)
    points = rng.uniform(-1, 1, (degree + 1, 3))
    a = sc.BezierCurve(points, rng.uniform(0.5, 2, degree + 1))
    planted = (np.arange(degree) + 0.5) / degree if degree < 25 else np.array([0.1, 0.3, 0.55, 0.9])
    for u in planted:
        at = a.evaluate(u)
        b = sc.BezierCurve([at - [0.3, 0.1, 0.2], at, at + [0.1, 0.4, -0.2]], [1, 2.5, 1])
        through = sc.BezierCurve(b.points - (b.evaluate(0.37) - at), b.weights)
        found = a.intersections(through)
        check(a, through, found)
        assert np.abs(found.parameters - [u, 0.37]).max(1).min() < 1e-9
        lifted = a.intersections(through.to_nurbs().transformed(placed(z=1e-3)))
        assert not (np.abs(lifted.parameters - [u, 0.37]).max(1) < 1e-9).any()


def test_each_place_has_its_own_distance_and_touch():
    flat = line((-2, 0), (2, 0))
    hills = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [[-1.5, 1, 0], [-1, 0.03, 0], [0, -1, 0], [1, 0.01, 0], [1.5, 0.5, 0]])
    found = flat.intersections(hills, 0.02)
    apart = np.linalg.norm(flat.evaluate(found.parameters[:, 0]) - hills.evaluate(found.parameters[:, 1]), axis=1)
    assert len(found.distances) == 2 and found.distances == pytest.approx(apart, abs=1e-15)
    parabola = sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 1, 0]], domain=(-2.0, 2.0))
    mixed = parabola.intersections(ellipse(1, 1).transformed(placed(y=1.0, turn=0.4)))
    assert mixed.touches.tolist() == [False, True, False]
    assert mixed.distances.strides == (8,) and mixed.touches.strides == (1,)


def test_two_cubics_cross_nine_times():
    """y = T3(x) and x = T3(y): with x = cos s the places are those of cos 9s = cos s."""
    a, b = graph(single(3)), graph(single(3), swapped=True)
    found = a.intersections(b)
    want = np.sort(np.cos(np.pi * np.r_[np.arange(5) / 4, np.arange(1, 5) / 5]))
    assert found.parameters[:, 0] == pytest.approx(want, abs=1e-13)
    assert found.parameters[:, 1] == pytest.approx(chebyshev.chebval(want, single(3)), abs=1e-13)
    assert not found.touches[1:-1].any()


@pytest.mark.parametrize("degree", [2, 3, 5, 9, 16, 25])
def test_every_root_of_a_chebyshev_polynomial(degree):
    found = graph(single(degree)).intersections(line((-1.1, 0.3), (1.2, 0.3)))
    want = np.cos((np.arccos(0.3) + 2 * np.pi * np.arange(degree)) / degree)
    assert found.parameters[:, 0] == pytest.approx(np.sort(want), abs=1e-11)


@pytest.mark.parametrize("degree", [2, 3, 6, 9])
def test_a_chebyshev_polynomial_touches_its_bounds(degree):
    found = graph(single(degree)).intersections(line((-1.2, 1), (1.2, 1)))
    want = np.sort(np.cos(2 * np.pi * np.arange(degree // 2 + 1) / degree))
    assert found.parameters[:, 0] == pytest.approx(want, abs=1e-8)
    inner = np.abs(found.parameters[:, 0]) < 0.999
    assert found.touches[inner].all()


@pytest.mark.parametrize("power", range(2, 10))
def test_a_power_touches_its_tangent_once(power):
    points = np.zeros((power + 1, 3))
    points[1, 0] = points[power, 1] = 1
    found = sc.PowerCurve(points, domain=(-1.0, 1.0)).intersections(line((-2, 0), (1.7, 0)))
    assert len(found.parameters) == 1 and found.touches.tolist() == [True] and not len(found.overlaps)
    assert found.parameters[0] == pytest.approx([0, 2 / 3.7], abs=1e-8 if power < 4 else 0.3)
    assert abs(found.points[0, 1]) <= 2.0**-33 * 4


@pytest.mark.parametrize("a, b, c, d", [(2, 1, 1, 2), (3, 1, 1.5, 1.2), (2, 1.9, 1.95, 1.99)])
def test_ellipses_cross_four_times(a, b, c, d):
    x = np.sqrt((1 / b**2 - 1 / d**2) / (1 / c**2 / b**2 - 1 / a**2 / d**2))
    y = b * np.sqrt(1 - x**2 / a**2)
    found = ellipse(a, b).intersections(ellipse(c, d))
    places = found.points[np.lexsort((found.points[:, 1], found.points[:, 0].round(6))), :2]
    assert places == pytest.approx(np.array(sorted(itertools.product((-x, x), (-y, y)))), abs=1e-11)
    assert len(found.parameters) == 4 and not found.touches.any()


def test_circles_apart_touching_and_crossing():
    circle = ellipse(1, 1)
    for x in (0.25, 1.0, 1.75, 1.999):
        found = circle.intersections(circle.transformed(placed(x)))
        assert np.sort(found.points[:, 1]) == pytest.approx([-np.sqrt(1 - x * x / 4), np.sqrt(1 - x * x / 4)], abs=1e-11)
        assert not found.touches.any()
    for x, turn in itertools.product((2.0, -2.0), (0.0, 0.3, 1.2)):
        found = circle.transformed(placed(turn=turn)).intersections(circle.transformed(placed(x)))
        assert found.touches.tolist() == [True]
        assert found.points[0] == pytest.approx([x / 2, 0, 0], abs=1e-9)
    inside = circle.intersections(ellipse(0.5, 0.5).transformed(placed(0.5)))
    assert inside.touches.tolist() == [True] and inside.points[0] == pytest.approx([1, 0, 0], abs=1e-7)
    for x in (2.0 + 1e-6, 3.0):
        assert len(circle.intersections(circle.transformed(placed(x))).parameters) == 0
    assert len(circle.intersections(circle.transformed(placed(z=0.1))).parameters) == 0


def test_conics_with_contact_of_every_order():
    """x^2 + (y - r)^2 = r^2 and the parabola y = x^2: one touch, of order four at r = 1/2, and two crossings above it."""
    parabola = sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 1, 0]], domain=(-2.0, 2.0))
    for r, crossings in ((0.3, 0), (0.5, 0), (0.7, 2), (1.0, 2)):
        found = parabola.intersections(ellipse(r, r).transformed(placed(y=r, turn=0.4)))
        inner = np.abs(found.parameters[:, 0]) < 0.01
        assert inner.sum() == 1 and found.touches[inner].all()
        assert (~inner).sum() == crossings
        if crossings:
            assert found.parameters[~inner, 0] == pytest.approx(np.sqrt(2 * r - 1) * np.array([-1, 1]), abs=1e-11)


def test_a_hyperbola_through_infinity_meets_a_line_on_both_branches():
    """Weights 1, -1, 1 take the quadratic's other way round, through infinity."""
    arc = sc.BezierCurve([[1, 2, 0], [0, 0, 0], [-1, 2, 0]], [1, -2, 1])
    found = arc.intersections(line((-9, -5), (9, -4)))
    check(arc, line((-9, -5), (9, -4)), found)
    assert len(found.parameters) == 2
    assert len(arc.intersections(line((-9, 1), (9, 1.1))).parameters) == 0


def zigzag(axis, count=64):
    rng = np.random.default_rng(5)
    points = np.zeros((count, 3))
    points[:, 0] = np.linspace(0, 1, count)
    points[:, 1] = np.where(np.arange(count) % 2, 0.2, -0.2) * (1 if axis == 0 else -1) + rng.uniform(-0.02, 0.02, count)
    return sc.NurbsCurve(3, np.r_[[0] * 4, np.arange(1, count - 3), [count - 3] * 4] / (count - 3), points)


def test_zigzags_cross_wherever_they_do():
    a, b = zigzag(0), zigzag(1)
    u = np.linspace(0, 1, 200_001)
    changes = np.count_nonzero(np.diff(np.sign((a.evaluate(u) - b.evaluate(u))[:, 1])))
    found = a.intersections(b)
    assert len(found.parameters) == changes > 50
    assert not found.touches.any() and found.distances.max() < 1e-15
    assert len(a.self_intersections().parameters) == 0


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1.0, 1e9, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e3, 1e6])
def test_places_stay_where_curves_are_scaled_and_moved(scale, far):
    rng = np.random.default_rng(11)
    for _ in range(5):
        a, b = (plane_curve(rng, 3, "clamped", 6) for _ in range(2))
        near = a.intersections(b)
        matrix = scaled(scale, far * scale)
        moved = a.transformed(matrix).intersections(b.transformed(matrix))
        assert moved.parameters.shape == near.parameters.shape
        assert moved.parameters == pytest.approx(near.parameters, abs=1e-7 if far else 1e-12)
        assert moved.points == pytest.approx((near.points + far) * scale, rel=1e-7, abs=1e-7 * scale)


def test_curves_that_are_one():
    circle = ellipse(1, 1)
    for other, reverse in ((circle, False), (circle.reversed(), True), (circle.elevate(2), False)):
        found = circle.intersections(other)
        assert found.overlaps.tolist() == [[[0, 4], [0, 4]]] and found.reversed.tolist() == [reverse]
        assert len(found.parameters) == 0
    turned = circle.intersections(circle.transformed(placed(turn=0.7)))
    (a, b), = turned.overlaps
    assert a.tolist() == [0, 4] and b[1] - b[0] == pytest.approx(4)
    assert circle.transformed(placed(turn=0.7)).evaluate(b[0]) == pytest.approx(circle.evaluate(0), abs=1e-9)


@pytest.mark.parametrize("degree", [1, 2, 3, 5, 8])
def test_parts_in_common(degree):
    rng = np.random.default_rng(degree)
    whole = sc.NurbsCurve(degree, random_knots(rng, degree, 4, "clamped"), rng.uniform(-5, 5, (len(
        random_knots(np.random.default_rng(degree), degree, 4, "clamped")) - degree - 1, 3)))
    start, end = whole.domain
    cuts = start + (end - start) * np.array([0.2, 0.45, 0.7])
    first, last = whole.split(cuts[2])[0], whole.split(cuts[0])[1]
    found = first.intersections(last.reversed())
    assert len(found.parameters) == 0 and found.reversed.tolist() == [True]
    assert found.overlaps[0, 0] == pytest.approx([cuts[0], cuts[2]], abs=1e-7 * (end - start))
    touching = whole.split(cuts[1])
    met = touching[0].intersections(touching[1])
    assert met.parameters == pytest.approx(np.array([[cuts[1], cuts[1]]]), abs=1e-9) and not len(met.overlaps)


def test_an_overlap_beside_crossings():
    base = line((0, 0), (4, 0))
    other = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 5, 5],
                          [[0.5, 1, 0], [0.5, -1, 0], [1, 0, 0], [3, 0, 0], [3.5, 1, 0], [3.7, -1, 0]])
    found = base.intersections(other)
    assert found.overlaps == pytest.approx(np.array([[[0.25, 0.75], [2, 3]]]), abs=1e-9)
    assert found.parameters == pytest.approx(np.array([[0.125, 0.5], [3.6 / 4, 4.5]]), abs=1e-9)


@pytest.mark.parametrize("p, q", [(2, 3), (3, 4), (3, 5), (4, 5), (5, 6), (5, 7)])
def test_double_points_of_chebyshev_curves(p, q):
    """(T_p, T_q) has (p - 1)(q - 1) / 2 double points, at cos(k pi / p +- l pi / q)."""
    power = np.zeros((q + 1, 3))
    power[:p + 1, 0] = chebyshev.cheb2poly(single(p))
    power[:, 1] = chebyshev.cheb2poly(single(q))
    found = sc.PowerCurve(power, domain=(-1.0, 1.0)).self_intersections()
    want = set()
    for k, j in itertools.product(range(1, p), range(1, q)):
        pair = sorted((np.cos(k * np.pi / p + j * np.pi / q), np.cos(k * np.pi / p - j * np.pi / q)))
        want.add(tuple(np.round(pair, 9)))
    assert len(want) == (p - 1) * (q - 1) // 2
    assert found.parameters == pytest.approx(np.array(sorted(want)), abs=1e-8)


def test_curves_that_meet_themselves_at_no_place():
    for curve in (ellipse(3, 1), line((0, 0), (1, 1)), zigzag(0, 12),
                  sc.BezierCurve([[0, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0]]),  # a cusp
                  sc.NurbsCurve(3, np.arange(9) / 8, np.random.default_rng(1).uniform(size=(8, 3)) +
                                10 * np.c_[np.cos(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4), np.zeros(8)],
                                periodic=True)):
        found = curve.self_intersections()
        assert len(found.parameters) == 0 and len(found.overlaps) == 0


def test_a_periodic_figure_eight_meets_itself_once():
    around = np.arange(16) * np.pi / 8
    points = np.c_[np.sin(around), np.sin(2 * around), np.zeros(16)]
    eight = sc.NurbsCurve(3, np.arange(17.0), points, periodic=True)
    found = eight.self_intersections()
    assert len(found.parameters) == 1
    assert np.diff(found.parameters[0]) == pytest.approx(8, abs=1e-9)
    assert found.points[0] == pytest.approx([0, 0, 0], abs=1e-12)


def test_a_curve_that_jumps_meets_only_where_it_is():
    jumping = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]])
    found = jumping.intersections(line((1.5, -1), (1.5, 1)))
    assert len(found.parameters) == 0
    assert len(jumping.intersections(line((2.5, -1), (2.5, 1))).parameters) == 1


def test_the_tolerance_decides_what_meets():
    a, b = line((0, 0), (2, 0)), line((1, 0.01), (1, 3))
    assert len(a.intersections(b).parameters) == 0
    found = a.intersections(b, 0.02)
    assert found.parameters == pytest.approx(np.array([[0.5, 0.0]]), abs=1e-12)
    assert found.distances == pytest.approx([0.01]) and found.points[0] == pytest.approx([1, 0.005, 0])
    circle = ellipse(1, 1)
    assert len(circle.intersections(circle.transformed(placed(2.001)), 0.01).parameters) == 1
    assert len(circle.intersections(line((-2, 1), (2, 1)), 1e-4).parameters) == 1


def test_every_kind_of_curve_answers():
    power = graph(single(2))
    kinds = [power, power.to_bezier() if hasattr(power, "to_bezier") else power, power.to_nurbs(), power.to_nurbs().to_hermite()]
    kinds[1] = kinds[1][0] if isinstance(kinds[1], list) else kinds[1]
    flat = line((-1, 0.5), (1, 0.5))
    kinds = [kind[0] if isinstance(kind, (list, tuple)) else kind for kind in kinds]
    for kind in kinds:
        found = kind.intersections(flat)
        assert isinstance(found, sc.Intersections) and "count=2" in repr(found)
        assert sorted(found.points[:, 0]) == pytest.approx([-np.sqrt(0.75), np.sqrt(0.75)], abs=1e-12)
        assert len(kind.self_intersections().parameters) == 0


def test_bad_calls():
    a = line((0, 0), (1, 0))
    for tolerance in (-1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            a.intersections(a, tolerance)
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            a.self_intersections(tolerance)
    for other in (None, 3, [[0, 0, 0], [1, 1, 1]], conics):
        with pytest.raises(sc.InvalidShape, match="other is .*, a curve is expected"):
            a.intersections(other)


def test_points_and_lines_that_go_back():
    point = sc.BezierCurve([[0.5, 0, 0]] * 3)
    found = line((0, 0), (1, 0)).intersections(point)
    assert len(found.parameters) == 1 and found.parameters[0, 0] == pytest.approx(0.5)
    assert len(point.self_intersections().parameters) == 0
    back = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [0, 0, 0]])
    found = back.intersections(line((0.25, -1), (0.25, 1)))
    assert found.parameters[:, 0] == pytest.approx([0.25, 1.75])


def test_too_much_work_is_refused_and_long_work_can_be_ended():
    rng = np.random.default_rng(3)
    points = np.c_[rng.uniform(-1, 1, (6000, 2)), np.zeros(6000)]
    tangle = sc.NurbsCurve(3, np.r_[[0] * 3, np.arange(5998), [5997] * 3], points)
    with pytest.raises(sc.Cancelled):
        tangle.intersections(tangle.transformed(placed(0.01)), cancel=lambda: True)
    with pytest.raises(sc.InvalidShape, match="pairs"):
        tangle.intersections(tangle.transformed(placed(z=1e-3)), 0.1)
