"""Parts of curves, what is trimmed and how curves go on: of every kind, at every scale, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, random_curve
from splinecore import build, conics

SCALES = [1e-150, 1e-6, 1.0, 1e6, 1e150]


def line(*ends):
    return sc.BezierCurve(np.array(ends, float))


CIRCLE = conics.circle((0, 0, 0), 1)
CUBIC = sc.NurbsCurve(3, [0, 0, 0, 0, 0.4, 1, 1, 1, 1], [(0, 0, 0), (1, 2, 0), (3, 2, 1), (4, 0, 0), (5, 1, 0)])


def size(curve):
    low, high = curve.bounding_box()
    return np.abs(np.array([low, high])).max()


def kinds(seed, count=60):
    rng = np.random.default_rng(seed)
    for k in range(count):
        yield rng, random_curve(rng, positive=True, degree=1 + k % 9, ends=ENDS[k % len(ENDS)])


def test_parts_are_the_curve():
    for rng, curve in kinds(1):
        start, end = curve.domain
        cuts = np.sort(rng.uniform(start, end, 4))
        for piece in curve.parts(cuts):
            u = np.linspace(*piece.domain, 40)
            inside = np.where(u > end, u - (end - start), u)
            # At a jump of the curve the two may take different sides.
            away = np.linalg.norm(piece.evaluate(u[1:-1]) - curve.evaluate(inside[1:-1]), axis=1)
            assert np.median(away) <= 1e-9 * size(curve) and np.sort(away)[-3] <= 1e-6 * size(curve)


def test_parts_follow_each_other():
    first, *others = CUBIC.parts([0.7, 0.2, 0.2 + 1e-15, 0, 1])
    assert [piece.domain for piece in (first, *others)] == [(0, 0.2), (0.2, 0.7), (0.7, 1)]
    assert CUBIC.parts([]) == [CUBIC] and CUBIC.parts([0, 1]) == [CUBIC]
    for kind in (CUBIC, sc.BezierCurve([(0, 0), (1, 2), (3, 0)]), sc.HermiteCurve([(0, 0), (1, 1)], [(1, 0), (1, 0)])):
        assert [type(piece) for piece in kind.parts([0.5])] == [sc.NurbsCurve] * 2


def test_parts_of_closed_curves_go_over_the_seam():
    for curve in (CIRCLE, CIRCLE.to_periodic().value):
        start, end = curve.domain
        turn = end - start
        cuts = start + turn * np.array([0.3, 0.8])
        pieces = curve.parts(cuts)
        assert [piece.domain for piece in pieces] == [pytest.approx(cuts), pytest.approx((cuts[1], cuts[0] + turn))]
        lengths = [piece.length() for piece in pieces]
        assert sum(lengths) == pytest.approx(2 * np.pi)
        whole, = curve.parts([start + 0.3 * turn])
        assert whole.length() == pytest.approx(2 * np.pi)
        assert whole.evaluate(whole.domain[0]) == pytest.approx(curve.evaluate(start + 0.3 * turn))
        for piece in pieces:
            assert np.linalg.norm(piece.evaluate(np.linspace(*piece.domain, 99)), axis=1) == pytest.approx(1, abs=1e-13)


@pytest.mark.parametrize("scale", SCALES)
def test_trimmed_between_meets(scale):
    bar = line((0, 0), (4 * scale, 0))
    posts = [line((x * scale, -scale), (x * scale, scale)) for x in (1, 2, 3)]
    for at, left in ((0.1, [(0.25, 1)]), (0.3, [(0, 0.25), (0.5, 1)]), (0.9, [(0, 0.75)])):
        pieces = bar.trimmed(posts, at)
        assert [piece.domain for piece in pieces] == [pytest.approx(ends) for ends in left]
    assert len(bar.split_by(posts)) == 4


def test_trimmed_circles():
    left, = CIRCLE.trimmed([line((0, -2), (0, 2))], CIRCLE.domain[0])
    assert left.length() == pytest.approx(np.pi) and left.evaluate(np.mean(left.domain))[0] == pytest.approx(-1)
    right, = CIRCLE.trimmed([line((0, -2), (0, 2))], np.mean(CIRCLE.domain))
    assert right.length() == pytest.approx(np.pi) and right.evaluate(np.mean(right.domain))[0] == pytest.approx(1)
    with pytest.raises(sc.InvalidShape, match="only one"):
        CIRCLE.trimmed([line((0, -2), (0, 0))], 0)


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("at", ["start", "end"])
@pytest.mark.parametrize("how", ["natural", "arc", "straight"])
def test_extended_by_a_length(how, at, scale):
    curve = CUBIC.with_points(scale * CUBIC.points)
    made = curve.extended(1.3 * scale, at, how)
    assert made.length() == pytest.approx(curve.length() + 1.3 * scale, rel=1e-9)
    u = np.linspace(0, 1, 50)
    assert np.abs(made.evaluate(u) - curve.evaluate(u)).max() <= 1e-12 * scale
    joint = made.continuity(0.0 if at == "start" else 1.0)
    assert joint.g >= {"natural": 3, "arc": 2, "straight": 1}[how]


@pytest.mark.parametrize("how", ["natural", "arc", "straight"])
def test_curves_of_every_kind_are_extended(how):
    done = 0
    for rng, curve in kinds(2):
        by = 0.1 * curve.length(tolerance=1e-9)
        if by == 0:
            continue
        for at in ("start", "end"):
            try:
                made = curve.extended(by, at, how)
            except sc.InvalidShape as refused:
                assert any(word in str(refused) for word in ("infinity", "whole circle", "is closed"))
                continue
            done += 1
            u = np.linspace(*curve.domain, 60)[1:-1]
            away = np.linalg.norm(made.evaluate(u) - curve.evaluate(u), axis=1)
            assert np.sort(away)[-3] <= 1e-7 * size(curve)
            start, end = made.domain
            more = (start, curve.domain[0]) if at == "start" else (curve.domain[1], end)
            assert made.length(*more, tolerance=1e-9) == pytest.approx(by, rel=1e-6)
            joint = made.continuity(curve.domain[0] if at == "start" else curve.domain[1], 1e-5)
            assert joint.gap <= 1e-9 * size(curve) and joint.angle < 1e-5
    assert done > 40


def test_natural_extensions_are_the_same_polynomials():
    parabola = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    made = parabola.extended(3.0)
    u = np.linspace(*made.domain, 50)
    assert made.evaluate(u)[:, :2] == pytest.approx(np.c_[2 * u, 4 * u * (1 - u)], abs=1e-12)
    assert len(made.points) == 3 and made.domain[0] == 0
    arc = conics.arc_about((0, 0, 0), (1, 0, 0), (0, 1, 0))
    assert np.linalg.norm(arc.extended(1.0).evaluate(np.linspace(0, 1, 20)), axis=1) == pytest.approx(1)


def test_arcs_go_round_their_circle():
    arc = conics.arc_about((1, 2, 3), (3, 2, 3), (1, 4, 3))
    for at in ("start", "end"):
        made = arc.extended(2.5, at, "arc")
        assert np.linalg.norm(made.evaluate(np.linspace(*made.domain, 99)) - (1, 2, 3), axis=1) == pytest.approx(2)
    with pytest.raises(sc.InvalidShape, match="12.566"):
        arc.extended(13.0, how="arc")


def test_extended_to_others():
    bar = line((0, 0), (1, 0))
    walls = [line((5, -1), (5, 1)), line((3, -1), (3, 1)), line((-2, -1), (-2, 1))]
    for how in ("natural", "arc", "straight"):
        assert bar.extended_to(walls, "end", how).evaluate(np.inf if False else 3.0) == pytest.approx((3, 0, 0))
        assert bar.extended_to(walls, "start", how).domain == pytest.approx((-2, 1))
    quarter = conics.arc_about((0, 0, 0), (1, 0, 0), (0, 1, 0))
    made = quarter.extended_to([line((-3, 0), (3, 0))], "end", "arc")
    assert made.length() == pytest.approx(np.pi)
    with pytest.raises(sc.InvalidShape, match="meets none"):
        bar.extended_to([line((0, 1), (1, 1))])


def test_bad_calls_are_refused():
    for call, message in (
        (lambda: CUBIC.part(0.5, 0.5), "where it starts"),
        (lambda: CUBIC.part(0.5, 1.5), "outside"),
        (lambda: CUBIC.part(-0.5, 0.5), "outside"),
        (lambda: CIRCLE.part(CIRCLE.domain[0], CIRCLE.domain[1] * 3 + 9), "longer than a turn"),
        (lambda: CUBIC.parts([2]), "outside"),
        (lambda: CUBIC.parts([np.nan]), "outside|finite"),
        (lambda: CUBIC.trimmed([line((0, 9), (1, 9))], 0.5), "nothing meets"),
        (lambda: CUBIC.trimmed([], 0.5), "nothing meets"),
        (lambda: CUBIC.trimmed([CIRCLE], 7), "outside"),
        (lambda: CUBIC.trimmed([3], 0.5), "curve is expected"),
        (lambda: CUBIC.extended(0), "not above 0"),
        (lambda: CUBIC.extended(-1), "not above 0"),
        (lambda: CUBIC.extended(np.inf), "not finite"),
        (lambda: CUBIC.extended(1, "middle"), "middle"),
        (lambda: CUBIC.extended(1, how="somehow"), "somehow"),
        (lambda: CIRCLE.extended(1), "closed"),
        (lambda: CIRCLE.extended_to([CUBIC]), "closed"),
        (lambda: line((1, 1), (1, 1), (1, 1)).extended(1), "closed|stands still"),
    ):
        with pytest.raises(sc.InvalidShape, match=message):
            call()
    with pytest.raises(TypeError, match="list of curves"):
        CUBIC.split_by(CIRCLE)
    with pytest.raises(sc.Cancelled):
        many = build.contour(np.c_[np.arange(400), np.arange(400) % 2])
        many.split_by([many.transformed(np.diag([1.0, -1.0, 1.0, 1.0]))] * 40, cancel=lambda: True)
