"""Contours, rounded and chamfered corners, arcs and lines between two curves: closed forms, every scale, bad calls."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, conics

SCALES = [1e-150, 1e-6, 1.0, 1e6, 1e150]
SQUARE = build.contour([(0, 0), (4, 0), (4, 3), (0, 3)], closed=True)


def line(*ends):
    return sc.BezierCurve(np.array(ends, float))


def ends(curve):
    return curve.evaluate(np.array(curve.domain))


def scaled(curve, scale, shift=0.0):
    return curve.with_points(scale * curve.points + shift)


@pytest.mark.parametrize("scale", SCALES)
def test_contours_of_segments_and_arcs(scale):
    points = scale * np.array([(0, 0), (4, 0), (4, 2), (0, 2)], float)
    slot = build.contour(points, [0, 1, 0, 1], closed=True)
    assert slot.length() == pytest.approx(scale * (8 + 2 * np.pi))
    assert np.array_equal(*ends(slot))
    assert max(joint.angle for _, joint in slot.joints()) < 1e-7
    inward = build.contour(points, [0, -0.5, 0, 0], closed=True)
    # An arc of bulge b and chord c has the radius c (1 + b^2) / (4 b) and the angle 4 atan b.
    assert inward.length() == pytest.approx(scale * (10 + 2 * 1.25 / 2 * 4 * np.arctan(0.5)))
    assert inward.nearest((scale * 3.5, scale, 0)).distances == pytest.approx(0, abs=1e-12 * scale)


def test_contours_in_space():
    rng = np.random.default_rng(4)
    for _ in range(40):
        points = rng.normal(size=(6, 3))
        bulges = rng.uniform(-2, 2, 5)
        made = build.contour(points, bulges, normal=(0.2, -0.5, 1))
        for point in points:
            assert made.nearest(point).distances < 1e-12
        chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
        lengths = chords * (1 + bulges**2) / np.abs(bulges) * np.arctan(np.abs(bulges))
        assert made.length() == pytest.approx(lengths.sum())
    straight = build.contour(points)
    assert straight.degree == 1 and straight.length() == pytest.approx(chords.sum())


@pytest.mark.parametrize("scale", SCALES)
def test_corners_of_a_square(scale):
    square = scaled(SQUARE, scale)
    rounded = square.rounded(0.5 * scale)
    assert rounded.length() == pytest.approx(scale * (10 + np.pi))
    assert max(joint.angle for _, joint in rounded.joints()) < 1e-7
    chamfered = square.chamfered(0.5 * scale)
    assert chamfered.length() == pytest.approx(scale * (10 + 4 * np.hypot(0.5, 0.5)))
    assert np.array_equal(*ends(rounded)) and np.array_equal(*ends(chamfered))
    full = square.rounded(1.5 * scale)
    assert full.length() == pytest.approx(scale * (2 + 3 * np.pi))


def test_corners_of_open_curves_and_with_curves_beside():
    bent = build.contour([(0, 0), (4, 0), (4, 4)], [0, 0.4])
    made = bent.rounded(0.5)
    assert ends(made) == pytest.approx(ends(bent))
    assert max(joint.angle for _, joint in made.joints()) < 1e-7
    arcs = [u for u, joint in made.joints() if joint.curvature_difference > 0.1]
    bends = made.curvature((np.array(arcs)[:-1] + arcs[1:]) / 2)
    assert np.isclose(bends, 2).any()


def test_corners_in_space_and_far_away():
    zigzag = build.contour([(0, 0, 0), (4, 0, 1), (4, 5, 0), (0, 3, 3)])
    for shift in (0.0, 1e8):
        made = scaled(zigzag, 1.0, shift).rounded(0.7)
        assert max(joint.angle for _, joint in made.joints(1e-5)) < 1e-5
        assert made.length(tolerance=1e-9) < zigzag.length()
        inner = [u for u, joint in made.joints(1e-5) if joint.curvature_difference > 0.1]
        assert len(inner) == 4


def test_a_drop_has_its_one_corner_rounded():
    drop = sc.BezierCurve([(0, 0), (3, 3), (-3, 3), (0, 0)]).to_nurbs()
    made = drop.rounded(0.2)
    assert np.linalg.norm(np.subtract(*ends(made))) < 1e-12
    assert max(joint.angle for _, joint in made.joints()) < 1e-6
    assert made.nearest((0, 0, 0)).distances > 0.05


def test_smooth_curves_stay_as_they_are():
    circle = conics.circle((0, 0, 0), 1)
    assert circle.rounded(0.1) == circle and circle.chamfered(0.1) == circle


KEPT = [(0.9, 0.9, 1, 1), (0.1, 0.9, -1, 1), (0.9, 0.1, 1, -1), (0.1, 0.1, -1, -1)]


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("at_a, at_b, side_a, side_b", KEPT)
def test_two_lines_are_filleted_on_the_sides_that_are_kept(at_a, at_b, side_a, side_b, scale):
    a = line((-2 * scale, 0), (2 * scale, 0))
    b = line((0, -2 * scale), (0, 2 * scale))
    first, arc, second = build.filleted(a, b, 0.5 * scale, (at_a, at_b))
    assert ends(arc)[:, :2] == pytest.approx(np.array([(side_a * 0.5, 0), (0, side_b * 0.5)]) * scale)
    assert arc.length() == pytest.approx(0.25 * np.pi * scale)
    assert first.length() == pytest.approx(1.5 * scale) and second.length() == pytest.approx(1.5 * scale)
    first, bridge, second = build.chamfered(a, b, (scale, 0.5 * scale), (at_a, at_b))
    assert ends(bridge)[:, :2] == pytest.approx(np.array([(side_a, 0), (0, side_b * 0.5)]) * scale)


def test_lines_that_do_not_meet_go_on():
    a, b = line((2, 0), (4, 0)), line((0, 1), (0, 3))
    first, arc, second = build.filleted(a, b, 0.5, (0.5, 0.5))
    assert ends(first)[:, 0] == pytest.approx((0.5, 4)) and ends(second)[:, 1] == pytest.approx((0.5, 3))
    first, bridge, second = build.chamfered(a, b, (0, 0.5), (0.5, 0.5))
    assert ends(first)[:, 0] == pytest.approx((0, 4)) and ends(second)[:, 1] == pytest.approx((0.5, 3))


def test_a_circle_is_not_cut():
    circle = conics.circle((0, 0, 0), 1)
    kept, arc, rest = build.filleted(circle, line((0, 0), (4, 0)), 0.25, (circle.domain[0] + 0.05, 0.9))
    assert kept == circle
    center_away = np.linalg.norm(arc.evaluate(np.mean(arc.domain)))
    assert center_away > 1 and ends(rest)[1] == pytest.approx((4, 0, 0))


def test_random_curves_with_their_fillets_are_smooth():
    rng = np.random.default_rng(8)
    done = 0
    for _ in range(60):
        a = sc.BezierCurve(np.c_[np.linspace(-3, 3, 4), rng.uniform(-0.5, 0.5, 4), np.zeros(4)])
        b = sc.BezierCurve(np.c_[rng.uniform(-0.5, 0.5, 4), np.linspace(-3, 3, 4), np.zeros(4)])
        radius = rng.uniform(0.05, 0.5)
        kept = tuple(rng.choice([0.05, 0.95], 2))
        first, arc, second = build.filleted(a, b, radius, kept)
        whole, = build.join_curves([first, arc, second], 1e-7)
        assert max(joint.angle for _, joint in whole.joints(1e-6)) < 1e-5
        assert whole.domain[1] > whole.domain[0]
        done += 1
    assert done == 60


def test_bad_calls_are_refused():
    a, b = line((-2, 0), (2, 0)), line((0, -2), (0, 2))
    for call, message in (
        (lambda: SQUARE.rounded(0), "not above 0"),
        (lambda: SQUARE.rounded(np.nan), "not above 0|finite"),
        (lambda: SQUARE.rounded(1.6), "does not fit"),
        (lambda: SQUARE.rounded(9), r"no arc of radius 9 fits at the corner \("),
        (lambda: SQUARE.chamfered(1.6), "does not fit"),
        (lambda: SQUARE.chamfered(5), "too short for a chamfer of 5"),
        (lambda: build.contour([(0, 0), (1, 0), (0.5, 0)]).rounded(0.1), "turns back"),
        (lambda: build.filleted(a, b, 0, (0, 0)), "not above 0"),
        (lambda: build.filleted(a, b, 0.5, (7, 0)), "outside"),
        (lambda: build.filleted(a, b, 0.5, (0, 0, 0)), "3 numbers"),
        (lambda: build.filleted(a, line((0, 1), (1, 1)), 3, (0.5, 0.5)), "touches both|no arc"),
        (lambda: build.filleted(a, line((0, 0, 1), (0, 1, 2)), 0.1, (0.5, 0.5)), "plane"),
        (lambda: build.chamfered(a, a, (1, 1), (0.1, 0.9)), "coincide along a segment"),
        (lambda: build.filleted(a, a, 0.5, (0.1, 0.9)), "no arc of radius 0.5"),
        (lambda: build.filleted(a, line((1, 1), (1, 1)), 0.5, (0.1, 0.9)), "is a point"),
        (lambda: build.chamfered(a, b, (0, 0), (0, 0)), "both lengths are 0"),
        (lambda: build.chamfered(a, b, (-1, 0), (0, 0)), "0 or more"),
        (lambda: build.chamfered(a, b, (9, 1), (0, 0)), "too short"),
        (lambda: build.chamfered(a, line((0, 1), (1, 1)), (1, 1), (0, 0)), "nor do their"),
        (lambda: build.contour([(0, 0)]), "two points"),
        (lambda: build.contour([(0, 0), (0, 0)]), "no length"),
        (lambda: build.contour([(0, 0), (1, 0)], [1, 2]), "2 values for 1 parts"),
        (lambda: build.contour([(0, 0), (1, 0)], [np.inf]), "no number|finite"),
        (lambda: build.contour([(0, 0), (1, 0)], [1], normal=(1, 0, 0)), "along the chord"),
        (lambda: build.contour([(0, 0), (1, 0)], [1], normal=(0, 0, 0)), "zero"),
        (lambda: build.contour([(0, np.nan), (1, 0)]), "finite"),
    ):
        with pytest.raises(sc.InvalidShape, match=message):
            call()
