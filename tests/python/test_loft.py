"""Surfaces through sections: cylinders, cones and tori come back, sections are on them, ends go on as asked, bad calls."""

import math

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from shapes import circle, closed_cubic, cubic, hermite_chain, parabola
from splinecore import build, conics

STYLES = ("normal", "tight", "uniform", "straight")


def moved(curve, height=0.0, size=1.0, turn=0.0, shift=(0.0, 0.0)):
    c, s = size * math.cos(turn), size * math.sin(turn)
    return curve.transformed(np.array([[c, -s, 0, shift[0]], [s, c, 0, shift[1]], [0, 0, size, height]]))


def grid(patch, count=33):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


# What is known in closed form


@pytest.mark.parametrize("style", (*STYLES, "loose"))
@pytest.mark.parametrize("closed_form, radius_at", [
    ("cylinder", lambda z: np.full_like(z, 2.0)), ("cone", lambda z: 2.0 - 0.4 * z)])
def test_circles_of_a_cylinder_and_of_a_cone_give_them_back(style, closed_form, radius_at):
    heights = np.array([0.0, 0.7, 1.5, 2.0, 3.0])
    sections = [moved(circle(), z, float(radius_at(np.array(z)))) for z in heights]
    made, error = build.loft(sections, style=style)
    points = grid(made).reshape(-1, 3)
    assert error == 0.0 and made.periodic == (True, False)
    assert np.abs(np.hypot(points[:, 0], points[:, 1]) - radius_at(points[:, 2])).max() <= 1e-12


@pytest.mark.parametrize("turned", [False, True])
def test_seams_and_directions_do_not_matter(turned):
    """The circles begin anywhere and every second one runs the other way: the cylinder is not twisted. Where their knots lie
    over each other it is exact, elsewhere equal parameters are not quite equal angles."""
    for turns, most in (((0, 1, 3, 2), 1e-12), ((0, 0.2, 0.7, 1.9), 5e-4)):
        sections = [moved(circle(), z, turn=turn * np.pi / 2) for z, turn in enumerate(turns)]
        if turned:
            sections = [curve.reversed() if i % 2 else curve for i, curve in enumerate(sections)]
        points = grid(build.loft(sections).value).reshape(-1, 3)
        assert np.abs(np.hypot(points[:, 0], points[:, 1]) - 1).max() <= most
    twisted = grid(build.loft(sections, align=False).value).reshape(-1, 3)
    assert np.abs(np.hypot(twisted[:, 0], twisted[:, 1]) - 1).max() > 1e-2


def test_a_section_can_be_turned_against_the_others():
    bow = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 1, 0), (4, 0, 0)]).to_nurbs()
    sections = [moved(bow, z) for z in (0.0, 1.0, 2.0)]
    made = build.loft(sections, turned=[False, True, False]).value
    by_hand = build.loft([sections[0], sections[1].reversed(), sections[2]], align=False).value
    assert made == by_hand != build.loft(sections).value
    with pytest.raises(sc.InvalidShape, match="turned has 2 values for 3 sections"):
        build.loft(sections, turned=[True, False])
    with pytest.raises(TypeError, match="turned must be a list"):
        build.loft(sections, turned=True)


def test_the_sections_of_a_torus_on_its_own_knots_give_it_back():
    torus = build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0)
    knots = torus.knots[0]
    at = np.arange(0.0, torus.domain[0][1], 0.5)
    sections = [torus.isocurve("u", u) for u in at]
    made = build.loft(sections, closed=True, degree=2, knots=knots, parameters=[*at, torus.domain[0][1]], weights="kept",
                      align=False).value
    points = grid(made).reshape(-1, 3)
    assert np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2]) - 1).max() <= 1e-12


def test_a_torus_through_many_of_its_circles():
    """Without its knots it is a polynomial along v: near."""
    torus = build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0)
    sections = [torus.isocurve("u", u) for u in np.linspace(*torus.domain[0], 33)[:-1]]
    points = grid(build.loft(sections, closed=True).value, 101).reshape(-1, 3)
    assert np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2]) - 1).max() <= 2e-5


def test_planar_sections_of_one_plane_make_a_plane_surface():
    rng = np.random.default_rng(5)
    for _ in range(30):
        sections = [moved(random_curve(rng, ends="clamped"), shift=(0.0, 3.0 * i)) for i in range(4)]
        flat = [curve.transformed(np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0.2, 0.1, 0, 0]])) for curve in sections]
        points = grid(build.loft(flat, style="straight").value).reshape(-1, 3)
        assert np.abs(points[:, 2] - 0.2 * points[:, 0] - 0.1 * points[:, 1]).max() <= 1e-11


def test_two_segments_give_a_bilinear_patch_of_one_span():
    made = build.loft([sc.BezierCurve([[0, 0, 0], [1, 0, 0]]), sc.BezierCurve([[0, 1, 0], [1, 1, 1]])]).value
    assert made.degree == (1, 1) and made.points.tolist() == [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]


# Sections of every kind


@pytest.mark.parametrize("style", STYLES)
def test_every_section_is_a_line_of_the_surface(style):
    rng = np.random.default_rng(STYLES.index(style))
    for round_ in range(60):
        kinds = ["clamped", "unclamped"] if round_ % 2 else ["periodic"]
        count = int(rng.integers(3, 7))
        weights = rng.random() < 0.5
        sections = []
        for i in range(count):
            curve = moved(random_curve(rng, ends=kinds[rng.integers(len(kinds))], degree=int(rng.integers(1, 6))), 15.0 * i)
            sections.append(curve if weights and style == "straight" else sc.NurbsCurve(
                curve.degree, curve.knots, curve.points, periodic=curve.periodic))
        at = np.r_[0, np.cumsum(rng.uniform(0.5, 2, count - 1))]
        made = build.loft(sections, style=style, parameters=at, align=False).value
        u = np.linspace(0, 1, 40)[1:-1]
        for curve, v in zip(sections, at):
            domain = np.array(curve.domain)
            own = np.array(made.domain[0])
            off = (curve.evaluate(domain[0] + u * np.ptp(domain))
                   - made.evaluate(own[0] + u * np.ptp(own), np.full_like(u, v)))
            assert np.abs(off).max() <= 1e-9 * 100


@pytest.mark.parametrize("scale", [1e-150, 1e-6, 1e6, 1e150])
@pytest.mark.parametrize("far", [0.0, 1e6])
def test_at_any_size_and_far_away(scale, far):
    sections = [moved(curve.to_nurbs(), 4.0 * i) for i, curve in enumerate((cubic(), hermite_chain(), parabola()))]
    here = build.loft(sections, style="straight").value
    there = build.loft([curve.transformed(np.c_[scale * np.eye(3), [scale * far] * 3]) for curve in sections],
                       style="straight").value
    off = grid(there, 9) / scale - grid(here, 9) - far
    assert np.abs(off).max() <= 1e-12 * 10 + 1e-14 * far * 10


def test_kinds_degrees_and_closings_may_differ():
    made = build.loft([circle(), moved(closed_cubic(), 3.0), moved(hermite_chain().to_nurbs(), 6.0)], style="straight").value
    assert made.periodic == (False, False) and made.degree == (3, 1)
    closed = build.loft([circle(), moved(closed_cubic(), 3.0)]).value
    assert closed.periodic == (True, False)


def test_corners_lie_over_corners():
    square = build.contour([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)], closed=True)
    other = build.contour([(-1, -1, 2), (1, -1, 2), (1, 1, 2), (-1, 1, 2)], closed=True)
    made = build.loft([square, other]).value
    corners = {tuple(point) for point in made.points[:, 0].round(12)}
    assert {(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)} <= corners
    points = grid(made, 41).reshape(-1, 3)
    assert np.abs(np.abs(points[:, :2]).max(axis=1) - 1).max() <= 1e-12


def test_a_closed_loft_goes_round():
    sections = [moved(circle(), size=0.3).transformed(
        np.array([[math.cos(t), 0, -math.sin(t), 2 * math.cos(t)], [math.sin(t), 0, math.cos(t), 2 * math.sin(t)], [0, 1, 0, 0]]))
        for t in np.linspace(0, 2 * np.pi, 9)[:-1]]
    made = build.loft(sections, closed=True).value
    assert made.periodic == (True, True) and made.degree[1] == 3
    three = build.loft(sections[::3], closed=True).value
    assert three.degree[1] == 2 and three.periodic[1]


# Few knots


def test_within_a_tolerance_there_are_few_spans():
    rng = np.random.default_rng(3)
    heights = np.arange(5.0)
    sections = []
    for z in heights:
        u = np.sort(np.r_[0, rng.uniform(0, 1, 40), 1])
        sections.append(sc.fit.interpolate(np.c_[u, np.sin(2 * u + 0.2 * z), np.full_like(u, z)], parameters="chordal").value)
    exact = build.loft(sections).value
    made, error = build.loft(sections, tolerance=1e-3)
    assert exact.points.shape[0] > 150 and made.points.shape[0] <= 12
    assert 0 < error <= 1e-3
    assert made.periodic == (False, False) and (made.weights == 1).all()


def test_near_knots_are_taken_for_one():
    a = sc.NurbsCurve(3, [0, 0, 0, 0, 0.5, 1, 1, 1, 1], np.random.default_rng(1).random((5, 3)))
    b = sc.NurbsCurve(3, [0, 0, 0, 0, 0.5001, 1, 1, 1, 1], a.points + [0, 0, 2])
    assert build.loft([a, b]).value.points.shape[0] == 6
    made, error = build.loft([a, b], knot_distance=1e-3)
    assert made.points.shape[0] == 5 and 0 < error < 1e-3
    assert np.diff(np.unique(made.knots[0])).min() >= 1e-3


# Ends


def test_a_point_closes_the_surface_and_may_be_round():
    sections = [(0, 0, 0), moved(circle(), 1.0), moved(circle(), 2.0), (0, 0, 3)]
    made = build.loft(sections, start_flat=(0, 0, 1), end_flat=(0, 0, 1)).value
    assert (made.points[:, 0] == 0).all() and (made.points[:, -1] == [0, 0, 3]).all()
    assert made.periodic == (True, False)
    u = np.linspace(*made.domain[0], 30)
    d = made.derivatives(u, np.full_like(u, made.domain[1][0]), 1)[:, 0, 1]
    assert np.abs(d[:, 2]).max() <= 1e-12 and np.ptp(np.linalg.norm(d, axis=1)) <= 1e-2 * np.linalg.norm(d, axis=1).max()
    sharp = build.loft(sections).value
    d = sharp.derivatives(u, np.full_like(u, sharp.domain[1][0]), 1)[:, 0, 1]
    assert np.abs(d[:, 2]).min() > 0.1


def test_a_tangent_is_that_of_every_point():
    sections = [sc.BezierCurve([[0, 0, 0], [1, 0, 0]]), sc.BezierCurve([[0, 2, 0], [1, 2, 1]])]
    made = build.loft(sections, start_tangent=(0, 0, 1), end_tangent=(0, 1, 0)).value
    assert made.degree == (1, 3)
    u = np.linspace(0, 1, 9)
    for v, wanted in ((0, (0, 0, 1)), (1, (0, 1, 0))):
        d = made.derivatives(u, np.full_like(u, v), 1)[:, 0, 1]
        unit = d / np.linalg.norm(d, axis=1)[:, None]
        assert np.abs(unit - wanted).max() <= 1e-12


SIDES = ("u_start", "u_end", "v_start", "v_end")


@pytest.mark.parametrize("continuity", ["G0", "G1", "G2", "G3"])
def test_a_blend_goes_on_from_both_patches(continuity):
    rng = np.random.default_rng(7)
    order = int(continuity[1])
    for _ in range(25):
        first, second = (random_patch(rng, ends="clamped", degree=int(rng.integers(3, 6))) for _ in range(2))
        if rng.random() < 0.6:
            first, second = (sc.NurbsPatch(patch.degree, patch.knots, patch.points) for patch in (first, second))
        second = second.transformed(np.c_[np.eye(3), [0, 0, 60.0]])
        side_a, side_b = (SIDES[i] for i in rng.integers(4, size=2))
        try:
            made = build.blend_patches(first, side_a, second, side_b, continuity)
        except sc.InvalidShape as refused:
            assert "weights" in str(refused)
            continue
        assert made.degree[1] == 2 * order + 1
        assert len(np.unique(made.knots[1])) == 2
        for patch, side, own in ((first, side_a, "v_start"), (second, side_b, "v_end")):
            seam = sc.seam_continuity(patch, side, made, own, tolerance=1e-6)
            assert seam.gap <= 1e-10 * 60     # of the distance between both, closely beside ends of spans whose weights differ
            assert seam.g >= min(order, 2)


def test_the_third_order_of_a_blend_agrees():
    """Between pieces of one cubic by cubic patch G3 is that patch, where its speed is asked for."""
    rng = np.random.default_rng(2)
    whole = sc.BezierPatch(rng.uniform(-1, 1, (4, 4, 3)) * 0.3 + np.stack(np.meshgrid(*[np.arange(4.0)] * 2, [0.0]), -1)[:, :, 0])
    first, rest = whole.split("u", 1 / 3)
    _, third = rest.split("u", 0.5)
    middle, _ = rest.split("u", 0.5)
    v = np.linspace(0, 1, 33)
    made = build.blend_patches(first, "u_end", third, "u_start", "G3")
    points = made.evaluate(v, np.full_like(v, 0.5))
    assert np.linalg.norm(middle.nearest(points).points - points, axis=1).max() < 5e-3


def test_a_loft_between_neighbors_goes_on_from_them():
    low = build.cylinder((0, 0, -2), (0, 0, 1), 1.0, 1.0)
    high = build.cylinder((0, 0, 3), (0, 0, 1), 2.0, 1.0)
    made = build.loft([moved(circle(), 1.0, 2.5)], start_neighbor=(low, "v_end", "G2"),
                      end_neighbor=(high, "v_start", "G1", 1.5)).value
    assert made.periodic == (True, False)
    assert sc.seam_continuity(low, "v_end", made, "v_start").g == 2
    assert sc.seam_continuity(made, "v_end", high, "v_start").g >= 1
    ring = made.isocurve("v", 0.0)
    assert np.abs(ring.evaluate(np.linspace(*ring.domain, 50))[:, 2] + 1).max() <= 1e-12


# What cannot be


@pytest.mark.parametrize("sections, more, words", [
    ([], {}, "at least 2"),
    ([circle()], {}, "at least 2"),
    ([circle(), moved(circle(), 1.0)], {"closed": True}, "at least 3"),
    ([circle(), circle()], {}, "are equal"),
    ([circle(), (0, 0, 1), moved(circle(), 2.0)], {}, r"sections\[1\] is a point"),
    ([(0, 0, 0), (0, 0, 1)], {}, "all sections are points"),
    ([circle(), moved(circle(), 1.0)], {"start_flat": (0, 0, 1)}, "only a section that is a point"),
    ([circle(), moved(circle(), 1.0)], {"style": "straight", "start_tangent": (0, 0, 1)}, "no tangents"),
    ([circle(), moved(circle(), 1.0)], {"start_tangent": (0, 0, 0)}, "no direction"),
    ([circle(), moved(circle(), 1.0)], {"style": "wavy"}, "'wavy'"),
    ([circle(), moved(circle(), 1.0)], {"knot_distance": 1.0}, "knot_distance"),
    ([circle(), moved(circle(), 1.0)], {"tolerance": -1.0}, "tolerance"),
    ([circle(), moved(circle(), 1.0)], {"parameters": [1.0, 0.0]}, "parameters"),
    ([circle(), (0, 0, math.nan)], {}, "not finite"),
])
def test_what_makes_no_surface_is_refused_with_a_reason(sections, more, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.loft(sections, **more)


def test_what_is_no_section_is_refused():
    with pytest.raises(TypeError):
        build.loft(circle())
    with pytest.raises(sc.InvalidShape, match="a curve is expected"):
        build.loft([circle(), "circle"])
    with pytest.raises(TypeError, match="tuple"):
        build.loft([circle()], start_neighbor="left")
    with pytest.raises(sc.InvalidShape, match="seam"):
        build.blend_patches(build.torus((0, 0, 0), (0, 0, 1), 3, 1), "u_end", build.plane((0, 0, 5), (1, 0, 0), (0, 1, 0)), "u_start")


def test_wild_weights_are_refused_in_words():
    arc = conics.arc_about((0, 0, 0), (1, 0, 0), (0, 1, 0))
    nurbs = arc.to_nurbs()
    wild = [sc.NurbsCurve(2, nurbs.knots, nurbs.points + [0, 0, z], [1, w, 1]) for z, w in ((0, 1), (1, 400), (2, 1), (3, 300))]
    with pytest.raises(sc.InvalidShape, match="straight or loose"):
        build.loft(wild)
    assert build.loft(wild, style="straight").value.weights.min() > 0
    made, error = build.loft(wild, tolerance=1e-4)
    assert error <= 1e-4 and (made.weights == 1).all()
