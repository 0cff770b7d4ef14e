"""Curves that touch to any order, stand still, or lie on themselves over their end: one finding each, however said."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial

import splinecore as sc
from test_nothing_is_missed import motion, polyline, refined


def power_curve(*coordinates):
    power = np.zeros((max(len(p.coef) for p in coordinates), 3))
    for axis, p in enumerate(coordinates):
        power[: len(p.coef), axis] = p.coef
    return sc.PowerCurve(power).to_nurbs()


def touching(rng, order):
    """Two curves with so many derivatives in common at a parameter, which are apart elsewhere."""
    at = rng.choice([0, 1, 0.5, rng.uniform(0, 1)])
    bend, aside = rng.normal(size=(2, int(rng.integers(1, 4))))
    x = Polynomial([-at, 1])
    y, z = (Polynomial(np.r_[0, rng.normal(), c]) for c in (bend, aside))
    apart = Polynomial([-at, 1]) ** (order + 1) * rng.choice([-1, 1]) * 10 ** rng.uniform(-0.5, 1)
    one = power_curve(x, y(x), z(x))
    other = power_curve(x, y(x) + apart, z(x))
    return at, one, other.elevate() if rng.random() < 0.3 else other


def ways_to_say(rng, a, b):
    moved = motion(rng)
    moved[:3, 3] *= 10 ** rng.uniform(0, 3)
    yield a.transformed(moved), b.transformed(moved)
    scale = np.diag([10 ** rng.uniform(-12, 9)] * 3 + [1.0])
    scale[0, 0] = scale[1, 1] = scale[2, 2]
    yield a.transformed(scale), b.transformed(scale)
    yield a.reversed(), b
    yield refined(rng, a), refined(rng, b)
    yield b, a


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_a_contact_of_any_order_is_one_place(order, inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, order, 21])
        at, a, b = touching(rng, order)
        found = a.intersections(b)
        assert counts(found) == (1, 0), index
        far = 1e-9 if order < 3 or at in (0, 1) else 1e-6  # there second derivatives are zero, too
        is_at_end = min(at, 1 - at) < 1e-3 and set(found.parameters.ravel()) == {round(at)}  # rounding cannot tell
        assert found.touches.all() and (is_at_end or np.abs(found.parameters - at).max() < far), index
        for one, other in ways_to_say(rng, a, b):
            assert counts(one.intersections(other)) == (1, 0), index


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_how_far_a_contact_reaches_is_by_the_tolerance(order):
    """y = x^(k + 1) is within 1e-4 of y = 0 up to |x| = 1e-4^(1 / (k + 1)): an overlap if that is much of the curve."""
    x = Polynomial([-1, 2])
    for long, is_one in ((8.0, False), (0.5e-4 ** (1 / (order + 1)), True)):
        flat = power_curve(long * x, Polynomial([0.0]), Polynomial([0.0]))
        hill = power_curve(x, x ** (order + 1), Polynomial([0.0]))
        found = flat.intersections(hill, 1e-4)
        assert (len(found.parameters), len(found.overlaps)) == ((0, 1) if is_one else (1, 0))


def random_knots(rng, degree):
    steps = rng.uniform(0.2, 1, int(rng.integers(1, 6)))
    if rng.random() < 0.3:
        steps[rng.integers(len(steps))] = 10 ** rng.uniform(-8, -3)
    inner = np.cumsum(steps)[:-1] / steps.sum()
    if rng.random() < 0.4:
        inner = np.sort(np.repeat(inner, rng.integers(1, degree + 1, len(inner))))
    return np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)]


def standing_still(rng):
    """A curve with control points in one place, so that it has corners and cusps where its speed is zero."""
    degree = int(rng.integers(2, 8))
    knots = random_knots(rng, degree)
    count = len(knots) - degree - 1
    points = rng.uniform(-1, 1, (count, 3))
    points[:, 2] *= rng.random() < 0.4
    for _ in range(int(rng.integers(1, 3))):
        first, times = int(rng.integers(count - 1)), int(rng.integers(2, 4))
        points[first : first + times] = points[first]
    weights = None if rng.random() < 0.5 else 10 ** rng.uniform(-1, 1, count)
    curve = sc.NurbsCurve(degree, knots, points, weights)
    stays = any(np.ptp(piece.evaluate([0.0, 0.3, 1.0]), axis=0).max() < 1e-9 for piece in curve.to_bezier())
    return standing_still(rng) if stays else curve


def counts(found):
    return len(found.parameters), len(found.overlaps)


def is_at_the_edge(meet, size):
    """Whether another tolerance by a little says other numbers."""
    return len({counts(meet(factor * 2.0**-33 * size)) for factor in (0.9, 0.98, 1, 1.02, 1.1)}) > 1


def test_curves_that_stand_still_share_their_parts_once(inputs):
    """In at most one of 250 the numbers differ without being at the edge of the tolerance: why is not known."""
    edges = unknown = 0
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 22])
        curve = standing_still(rng)
        part = curve.part(*np.sort(rng.uniform(0, 1, 2)))
        if np.linalg.norm(np.ptp(part.evaluate(np.linspace(*part.domain, 50)), axis=0)) < 0.01:
            continue  # nearly a point
        found = curve.intersections(part)
        size = np.linalg.norm(curve.points - curve.points.mean(axis=0), axis=1).max()
        long = [overlap for overlap in found.overlaps if np.abs(overlap[0] - part.domain).max() < 1e-3]
        assert len(long) == 1, index
        for a, b in ways_to_say(rng, curve, part):
            if counts(a.intersections(b)) != counts(found):
                is_edge = is_at_the_edge(lambda t: curve.intersections(part, t), size)
                edges, unknown = edges + is_edge, unknown + (not is_edge)
    assert edges <= 0.01 * inputs(1000) and unknown <= inputs(1000) / 250


def test_curves_that_stand_still_meet_themselves_the_same_however_said(inputs):
    edges = 0
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 23])
        curve = standing_still(rng)
        found = counts(curve.self_intersections())
        size = np.linalg.norm(curve.points - curve.points.mean(axis=0), axis=1).max()
        for said, _ in ways_to_say(rng, curve, curve):
            if counts(said.self_intersections()) != found:
                assert is_at_the_edge(lambda t: curve.self_intersections(t), size), index
                edges += 1
    assert edges <= 0.01 * inputs(1000)


def closed_with_a_leg_twice(rng, back):
    """A closed polyline over one leg twice, the other way if `back`, that begins within the leg; and where both are."""
    leg = rng.uniform(-1, 1, (2, 3))
    others = [rng.uniform(-1, 1, (int(rng.integers(2, 4)), 3)) for _ in range(2)]
    start = leg[0] + rng.uniform(0.1, 0.9) * (leg[1] - leg[0])
    second = leg[::-1] if back else leg
    points = np.concatenate([[start], leg[1:], others[0], second, others[1], leg[:1], [start]])
    knots = np.r_[0, np.arange(len(points)), len(points) - 1].astype(float)
    here = 2 + len(others[0])
    return sc.NurbsCurve(1, knots, points), (here, here + 1), (len(points) - 2, len(points))


def test_a_stretch_of_a_closed_curve_with_itself_over_its_end_is_one(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 24])
        curve, inner, over = closed_with_a_leg_twice(rng, index % 2 == 1)
        for said in (curve, curve.transformed(motion(rng)), refined(rng, curve), curve.elevate()):
            found = said.self_intersections()
            assert found.overlaps == pytest.approx(np.array([[inner, over]]), abs=1e-6), index
            assert found.reversed.tolist() == [index % 2 == 1]


def test_a_closed_curve_of_several_turns_lies_on_itself_once_for_each_pair_of_turns():
    for turns, spans in ((2, 8), (3, 7), (4, 6)):
        angle = np.arange(turns * spans) * 2 * np.pi / spans
        knots = np.arange(turns * spans + 1.0)
        curve = sc.NurbsCurve(3, knots, np.c_[np.cos(angle), np.sin(angle), 0 * angle], periodic=True)
        found = curve.self_intersections()
        assert not found.reversed.any() and not len(found.parameters)
        shifts = np.diff(found.overlaps[:, :, 0], axis=1).ravel() % (turns * spans)
        lengths = np.diff(found.overlaps, axis=2)[:, :, 0]
        nearest = sorted(np.minimum(shifts, turns * spans - shifts).round(6))
        assert nearest == [spans * k for k in range(1, turns // 2 + 1)]
        whole = np.where(np.isclose(2 * shifts, turns * spans), 0.5, 1.0) * turns * spans
        assert lengths == pytest.approx(np.c_[whole, whole], abs=1e-6)


def test_polylines_that_begin_within_a_fold_have_it_once():
    fold = polyline((0.4, 0.2), (1, 0.5), (1, 1), (0, 1), (0, 0), (0.4, 0.2))
    assert counts(fold.self_intersections()) == (0, 0)
    spike = polyline((1, 0.5), (0, 0), (0, 1), (-1, 0), (0, 0), (1, 0.5))
    assert spike.self_intersections().overlaps == pytest.approx(np.array([[[0, 1], [4, 5]]]), abs=1e-7)


def test_folds_far_from_the_origin_lie_on_themselves(inputs):
    """Control points there are rounded by more than the 1/64 of the tolerance within which curves else are one."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 25])
        way, places = rng.normal(size=3), rng.uniform(0.1, 0.9, 2)
        shares = [0, 1, places[0] * 0.5, places[0] * 0.5 + 0.4]
        knots = np.r_[0, np.arange(4), 3].astype(float)
        fold = sc.NurbsCurve(1, knots, np.outer(shares, way))
        found = counts(fold.self_intersections())
        assert found[1] >= 2
        for _ in range(2):
            far = motion(rng)
            far[:3, 3] *= 10 ** rng.uniform(1, 3)
            assert counts(fold.transformed(far).self_intersections()) == found, index
