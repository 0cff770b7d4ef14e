"""Offsets of plane curves: circles, corners, cusps and what crosses itself, at every scale, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, random_knots, random_weights


def ellipse(a=1.0, b=1.0):
    corners = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], float)
    weights = np.array([1, np.sqrt(0.5)] * 4 + [1])
    return sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], np.c_[corners * [a, b], np.zeros(9)], weights)


def polygon(*corners):
    points = np.c_[np.array(corners, float), np.zeros(len(corners))]
    count = len(points)
    return sc.NurbsCurve(1, np.r_[0, np.arange(count), count - 1], points)


SQUARE = polygon((0, 0), (2, 0), (2, 1), (0, 1), (0, 0))


def wave(seed, spans=9, degree=3):
    rng = np.random.default_rng(seed)
    count = spans + degree
    knots = np.r_[[0] * (degree + 1), np.arange(1, spans), [spans] * (degree + 1)]
    return sc.NurbsCurve(degree, knots, np.c_[np.linspace(0, 6, count), rng.uniform(-1, 1, count), np.zeros(count)])


def distances(curve, offset, each=3000):
    return curve.nearest(offset.evaluate(np.linspace(*offset.domain, each))).distances


@pytest.mark.parametrize("distance", [0.3, 0.999, -0.5, -7.0, 1.5])
def test_offsets_of_a_circle_are_circles(distance):
    made, = ellipse().offset(distance)
    points = made.evaluate(np.linspace(*made.domain, 500))
    assert np.linalg.norm(points, axis=1) == pytest.approx(abs(1 - distance), abs=1e-14 * max(1, abs(distance)))
    assert made.degree == 2 and len(made.points) == 9


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("distance", [0.2, -0.5, -3.0])
def test_offsets_are_at_the_distance(distance, tolerance):
    for curve in (ellipse(2, 1.4), ellipse(3, 2).elevate(2)):
        made, = curve.offset(distance, tolerance=tolerance)
        found = distances(curve, made)
        assert np.abs(found - abs(distance)).max() <= tolerance
        start, end = made.evaluate(np.array(made.domain))
        assert start == pytest.approx(end, abs=1e-12)


@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize("degree", [1, 2, 3, 5, 9])
def test_trimmed_offsets_of_every_kind_are_nowhere_nearer(degree, ends):
    rng = np.random.default_rng([degree, ENDS.index(ends)])
    count_made = 0
    for _ in range(6):
        knots = random_knots(rng, degree, 4, ends)
        count = len(knots) - 1 if ends == "periodic" else len(knots) - degree - 1
        points = np.c_[rng.uniform(-1, 1, (count, 2)), np.zeros(count)]
        curve = sc.NurbsCurve(degree, knots, points, random_weights(rng, count, True), periodic=ends == "periodic")
        for distance in (0.05, -0.3):
            try:
                made = curve.offset(distance, tolerance=1e-5, trimmed=True)
            except sc.InvalidShape as error:
                assert "nothing is left" in str(error)
                continue
            for part in made:
                found = distances(curve, part, 500)
                assert found.min() >= abs(distance) - 4e-5
                count_made += 1
    assert count_made > 3


def test_cusps_are_kept_or_trimmed():
    """Inside a parabola of least radius 1/2 the offset by 0.8 has two cusps and crosses itself on the axis."""
    parabola = sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 1, 0]], domain=(-2.0, 2.0))
    raw, = parabola.offset(0.8, tolerance=1e-7)
    u = np.linspace(-2, 2, 4001)
    speed = np.sqrt(1 + 4 * u * u)
    want = np.c_[u - 1.6 * u / speed, u * u + 0.8 / speed, 0 * u]
    assert raw.nearest(want).distances.max() < 2e-7
    cusp = np.sqrt((1.6 ** (2 / 3) - 1) / 4)
    place = np.array([cusp - 1.6 * cusp / 1.6 ** (1 / 3), cusp**2 + 0.8 / 1.6 ** (1 / 3), 0])
    assert raw.nearest([place * [-1, 1, 1], place]).distances.max() < 1e-9
    trimmed, = parabola.offset(0.8, tolerance=1e-7, trimmed=True)
    assert np.abs(distances(parabola, trimmed) - 0.8).max() < 1e-6
    corner = trimmed.nearest([0, 0.8, 0])
    assert corner.points[0] == pytest.approx(0, abs=1e-9)
    assert len(trimmed.self_intersections().parameters) == 0


def test_corners_of_a_square():
    out, = SQUARE.offset(-0.2)
    assert distances(SQUARE, out) == pytest.approx(0.2, abs=1e-12)
    assert out.length(tolerance=1e-12) == pytest.approx(6 + 0.4 * np.pi, abs=1e-9)
    sharp, = SQUARE.offset(-0.2, corner="sharp")
    corners = np.unique(sharp.points.round(9), axis=0)
    assert {(-0.2, -0.2), (2.2, 1.2)} <= {tuple(p[:2]) for p in corners}
    inside, = SQUARE.offset(0.2, trimmed=True)
    assert inside.degree == 1 and inside.length(tolerance=1e-12) == pytest.approx(6 - 8 * 0.2, abs=1e-9)
    assert distances(SQUARE, inside) == pytest.approx(0.2, abs=1e-12)


def test_a_sharp_corner_that_would_be_too_long_is_round():
    spike = polygon((0, 0), (3, 0.1), (0, 0.2))
    sharp, = spike.offset(-0.2, corner="sharp")
    assert sharp.points[:, 0].max() < 3.3
    assert distances(spike, sharp).max() == pytest.approx(0.2, abs=1e-9)


def test_an_offset_that_falls_apart():
    """A dumbbell's inner offset is two parts where its waist is narrower than twice the distance."""
    dumbbell = polygon((0, 0), (2, 0), (2, 0.8), (4, 0.8), (4, 0), (6, 0), (6, 2), (4, 2), (4, 1.2), (2, 1.2), (2, 2), (0, 2), (0, 0))
    made = dumbbell.offset(0.3, trimmed=True)
    assert len(made) == 2
    for part in made:
        assert distances(dumbbell, part).min() >= 0.3 - 1e-6
        ends = part.evaluate(np.array(part.domain))
        assert ends[0] == pytest.approx(ends[1], abs=1e-9)


@pytest.mark.parametrize("normal", [(0, 0, -2), (1, 2, 3)])
def test_other_planes(normal):
    normal = np.array(normal) / np.linalg.norm(normal)
    x = np.cross(normal, [0.3, 1, 0.1])
    x /= np.linalg.norm(x)
    matrix = np.eye(4)
    matrix[:3, :3] = np.stack([x, np.cross(normal, x), normal], 1)
    matrix[:3, 3] = 1, 2, 3
    flat = ellipse(2, 1).offset(0.3)[0]
    turned = ellipse(2, 1).transformed(matrix).offset(0.3, normal)[0]
    assert turned.nearest(flat.transformed(matrix).evaluate(np.linspace(*flat.domain, 200))).distances.max() < 5e-6


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e5])
def test_offsets_stay_where_curves_are_scaled_and_moved(scale, far):
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = far * scale
    near = wave(1).offset(0.4, tolerance=1e-5, trimmed=True)
    made = wave(1).transformed(matrix).offset(0.4 * scale, tolerance=1e-5 * scale, trimmed=True)
    assert len(made) == len(near)
    u = np.linspace(0, 1, 200)
    for a, b in zip(near, made):
        points = b.evaluate(b.domain[0] + u * np.diff(b.domain)[0]) / scale - far
        assert a.nearest(points).distances.max() < 2e-5


def test_gaps_make_parts():
    jumping = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]])
    made = jumping.offset(0.5)
    assert [part.points[:, 0].tolist() for part in made] == [[0, 1], [2, 3]]
    assert all(part.points[:, 1].tolist() == [0.5, 0.5] for part in made)


def test_every_kind_of_curve_answers():
    power = sc.PowerCurve([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    bezier = sc.BezierCurve(power.to_nurbs().points)
    for curve in (power, bezier, power.to_nurbs(), bezier.to_hermite()):
        made, = curve.offset(-0.3)
        assert np.abs(distances(power, made) - 0.3).max() < 1e-5


def test_bad_calls():
    for distance in (0.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape, match="distance"):
            SQUARE.offset(distance)
    for normal in ((0, 0, 0), (np.nan, 0, 1)):
        with pytest.raises(sc.InvalidShape, match="normal"):
            SQUARE.offset(1.0, normal)
    for tolerance in (0.0, -1.0, np.nan):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            SQUARE.offset(0.1, tolerance=tolerance)
    with pytest.raises(sc.InvalidShape, match="is a point"):
        sc.BezierCurve([(1, 1), (1, 1)]).offset(0.1)
    with pytest.raises(sc.InvalidShape, match="corner = 'soft' is none of 'round', 'sharp'"):
        SQUARE.offset(0.1, corner="soft")
    with pytest.raises(sc.InvalidShape, match="not in a plane"):
        sc.BezierCurve([[0, 0, 0], [1, 0, 1], [2, 0, 0]]).offset(0.1)
    for curve, distance in ((ellipse(), 1.0), (ellipse(2, 1), 1.2), (SQUARE, 0.6)):
        with pytest.raises(sc.InvalidShape, match="nothing is left"):
            curve.offset(distance, trimmed=True)
    with pytest.raises(sc.InvalidShape):
        sc.BezierCurve([[1, 0, 0]] * 3).offset(0.1)


@pytest.mark.parametrize("distance", [0.1, -0.1])
def test_a_curve_that_turns_back_within_a_span_is_gone_round(distance):
    for points in ([(0, 0), (1, 1), (0, 1), (1, 0)], [(0, 0), (1, 0), (0, 0)], [(0, 0), (3, 2), (-1, 2), (2, 0), (2, 1)]):
        curve = sc.BezierCurve(points)
        made, = curve.offset(distance, tolerance=1e-6)
        found = distances(curve, made)
        assert found.max() <= 0.1 + 1e-6
        assert np.linalg.norm(made.derivatives(made.domain[0], 1)[1]) > 0
    there, = sc.BezierCurve([(0, 0), (1, 0), (0, 0)]).offset(distance)
    assert there.length() == pytest.approx(1 + 0.2 * np.pi)
