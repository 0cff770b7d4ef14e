"""Arcs by points, tangents and centers, and arcs that touch two curves: closed forms, random ones, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, conics


def circle_of(arc):
    """Center and radius, of which all points are checked."""
    points = arc.evaluate(np.linspace(*arc.domain, 200))
    a, b, c = points[0], points[70], points[150]
    u, v = b - a, c - a
    normal = np.cross(u, v)
    center = a + (np.cross(normal, u) * (v @ v) + np.cross(v, normal) * (u @ u)) / (2 * normal @ normal)
    radii = np.linalg.norm(points - center, axis=1)
    assert radii == pytest.approx(radii[0], rel=1e-9)
    return center, radii[0]


@pytest.mark.parametrize("scale", [1e-150, 1e-6, 1.0, 1e6, 1e150])
def test_arcs_through_three_points(scale):
    rng = np.random.default_rng(3)
    for _ in range(50):
        start, through, end = scale * rng.uniform(-1, 1, (3, 3))
        arc = conics.arc_through(start, through, end)
        ends = arc.evaluate(np.array(arc.domain))
        assert np.array_equal(ends[0], start) and np.array_equal(ends[1], end)
        assert arc.nearest(through).distances < 1e-12 * scale * 100
        circle_of(arc.transformed(np.diag([1 / scale, 1 / scale, 1 / scale, 1])))


def test_an_arc_through_three_points_turns_the_way_they_say():
    top = conics.arc_through((1, 0, 0), (0, 1, 0), (-1, 0, 0))
    assert top.length(tolerance=1e-12) == pytest.approx(np.pi)
    most = conics.arc_through((1, 0, 0), (-1, 0, 0), (0, 1, 0))
    assert most.length(tolerance=1e-12) == pytest.approx(1.5 * np.pi)
    assert most.evaluate(np.mean(most.domain))[1] < 0


def test_arcs_from_a_tangent():
    rng = np.random.default_rng(4)
    for _ in range(50):
        start, tangent, end = rng.uniform(-1, 1, (3, 3))
        arc = conics.arc_from_tangent(start, tangent, end)
        first = arc.derivatives(arc.domain[0], 1)[1]
        assert first / np.linalg.norm(first) == pytest.approx(tangent / np.linalg.norm(tangent), abs=1e-12)
        assert arc.evaluate(arc.domain[1]) == pytest.approx(end, abs=1e-12)
        circle_of(arc)


def test_arcs_about_a_center():
    for angle in (0.3, 2.0, np.pi, 5.0):
        arc = conics.arc_about((1, 2, 3), (3, 2, 3), (1 + np.cos(angle), 2 + np.sin(angle), 3))
        assert arc.length(tolerance=1e-12) == pytest.approx(2 * angle)
        back = conics.arc_about((1, 2, 3), (3, 2, 3), (1 + np.cos(angle), 2 + np.sin(angle), 3), (0, 0, -1))
        assert back.length(tolerance=1e-12) == pytest.approx(2 * (2 * np.pi - angle))
    whole = conics.arc_about((0, 0, 0), (1, 0, 0), (2, 0, 0))
    assert whole.length(tolerance=1e-12) == pytest.approx(2 * np.pi)


def test_bad_arcs():
    for call, match in ((lambda: conics.arc_through((0, 0, 0), (1, 1, 1), (2, 2, 2)), "on one line"),
                        (lambda: conics.arc_through((0, 0, 0), (0, 0, 0), (2, 2, 2)), "coincide"),
                        (lambda: conics.arc_through((0, 0, 0), (1, np.nan, 0), (2, 2, 2)), "not finite"),
                        (lambda: conics.arc_from_tangent((0, 0, 0), (1, 1, 0), (2, 2, 0)), "line between"),
                        (lambda: conics.arc_from_tangent((0, 0, 0), (0, 0, 0), (2, 2, 0)), "direction is zero"),
                        (lambda: conics.arc_from_tangent((1, 0, 0), (0, 1, 0), (1, 0, 0)), "coincide"),
                        (lambda: conics.arc_about((0, 0, 0), (0, 0, 0), (1, 0, 0)), "is the center"),
                        (lambda: conics.arc_about((0, 0, 0), (0, 0, 1), (1, 0, 0)), "along the radius")):
        with pytest.raises(sc.InvalidShape, match=match):
            call()


def line(start, end):
    return sc.BezierCurve([[*start, 0], [*end, 0]])


def check(a, b, radius, found):
    for arc, u, v, goes_on_a, goes_on_b in found:
        center, of = circle_of(arc)
        assert of == pytest.approx(radius, rel=1e-10)
        for curve, at, end, goes_on in ((a, u, 0, goes_on_a), (b, v, 1, goes_on_b)):
            point, along = curve.derivatives(at, 1)
            assert arc.evaluate(arc.domain[end]) == pytest.approx(point, abs=1e-10)
            way = arc.derivatives(arc.domain[end], 1)[1]
            cosine = way @ along / np.linalg.norm(way) / np.linalg.norm(along)
            assert cosine == pytest.approx(1 if goes_on else -1, abs=1e-9)


def test_lines_at_a_right_angle():
    a, b = line((-2, 0), (2, 0)), line((0, -2), (0, 2))
    found = build.fillets(a, b, 0.5)
    check(a, b, 0.5, found)
    assert sorted((round(u, 9), round(v, 9)) for _, u, v, *_ in found) == [(0.375, 0.375), (0.375, 0.625), (0.625, 0.375), (0.625, 0.625)]
    assert all(arc.length(tolerance=1e-12) == pytest.approx(0.25 * np.pi) for arc, *_ in found)
    corner = build.fillets(line((0, 0), (2, 0)), line((0, 0), (0, 2)), 0.5)
    assert len(corner) == 1 and corner[0][1:3] == pytest.approx((0.25, 0.25))


def test_a_line_and_a_circle():
    circle = conics.circle((0, 0, 0), 1)
    ground = line((-5, -1.2), (5, -1.2))
    found = build.fillets(ground, circle, 0.4)
    check(ground, circle, 0.4, found)
    # Outside: (1 + r)² = (r - 1.2)² + x²; inside the circle none is as low.
    x = np.sqrt(1.4**2 - 0.8**2)
    assert sorted(10 * u - 5 for _, u, *_ in found) == pytest.approx([-x, x], abs=1e-9)


def test_random_curves():
    rng = np.random.default_rng(8)
    count = 0
    for _ in range(20):
        a, b = (sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], np.c_[rng.uniform(-2, 2, (6, 2)), np.zeros(6)]) for _ in range(2))
        found = build.fillets(a, b, 0.2)
        check(a, b, 0.2, found)
        count += len(found)
        assert len(build.fillets(b, a, 0.2)) == len(found)
    assert count > 50


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1.0, 1e9, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e3, 1e6])
def test_fillets_stay_where_curves_are_scaled_and_moved(scale, far):
    rng = np.random.default_rng(0)
    a, b = (sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], np.c_[rng.uniform(-2, 2, (6, 2)), np.zeros(6)]) for _ in range(2))
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:2, 3] = far * scale
    near = build.fillets(a, b, 0.2)
    made = build.fillets(a.transformed(matrix), b.transformed(matrix), 0.2 * scale)
    assert len(made) == len(near) == 13
    places = [np.array([fillet[1:3] for fillet in found]) for found in (near, made)]
    assert places[1] == pytest.approx(places[0], abs=1e-7 if far else 1e-12)


def test_bad_fillets():
    a, b = line((0, 0), (1, 0)), line((0, 0), (0, 1))
    assert build.fillets(a, b, 3.0) == []
    for radius in (0.0, -1.0, np.nan):
        with pytest.raises(sc.InvalidShape, match="radius"):
            build.fillets(a, b, radius)
    with pytest.raises(sc.InvalidShape, match="normal"):
        build.fillets(a, b, 0.1, (0, 0, 0))
    with pytest.raises(sc.InvalidShape, match="not in a plane"):
        build.fillets(sc.BezierCurve([[0, 0, 0], [1, 0, 1], [2, 0, 0]]), b, 0.1)
    with pytest.raises(sc.InvalidShape, match="a is int, a curve is expected"):
        build.fillets(3, b, 0.1)
