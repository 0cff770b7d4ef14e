"""Sections along a rail: tori, cylinders and sums in closed form, frames measured densely, corners, bad calls."""

import math

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, closed_cubic, cubic, hermite_chain
from splinecore import build, conics


def grid(patch, count=65):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def ring(radius):
    return circle().transformed(radius * np.eye(3))


def line(*points):
    return sc.BezierCurve(points)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-9])
@pytest.mark.parametrize("periodic", [False, True])
def test_a_circle_along_a_circle_is_a_torus(tolerance, periodic):
    rail = ring(3.0)
    if periodic:
        rail = rail.to_periodic().value
    made, error = build.sweep(rail, ring(1.0), tolerance=tolerance)
    points = grid(made).reshape(-1, 3)
    off = np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2]) - 1).max()
    assert off <= tolerance and error <= tolerance
    assert made.periodic[1]


def test_a_straight_rail_is_exact():
    made, error = build.sweep(line((0, 0, 0), (0, 0, 5)), ring(2.0))
    points = grid(made).reshape(-1, 3)
    assert error == 0.0 and made.degree == (2, 1)
    assert np.abs(np.hypot(points[:, 0], points[:, 1]) - 2).max() <= 1e-14


def test_parallel_sections_make_the_sum_of_both_curves():
    rail, section = cubic(), hermite_chain()
    made, error = build.sweep(rail, section, frame="parallel")
    assert error == 0.0
    u, v = (np.linspace(*domain, 23) for domain in made.domain)
    points = made.evaluate_grid(u, v)
    frame = points - rail.evaluate(np.linspace(*rail.domain, 23), side="right")[None]
    assert np.abs(frame - frame[:, :1]).max() <= 1e-12
    assert np.linalg.norm(frame[:, 0], axis=1) == pytest.approx(np.linalg.norm(section.evaluate(np.linspace(*section.domain, 23)), axis=1))


@pytest.mark.parametrize("rail", [cubic(), closed_cubic(), hermite_chain()], ids=["cubic", "closed", "hermite"])
def test_every_point_of_a_ring_is_its_radius_from_the_rail(rail):
    """At right angles to it: in minimal frames the nearest distance is the radius, where that is small."""
    size = np.ptp(rail.evaluate(np.linspace(*rail.domain, 50)), axis=0).max()
    radius, tolerance = 1e-3 * size, 1e-6 * size
    made, _ = build.sweep(rail, ring(radius), tolerance=tolerance)
    v = np.linspace(*made.domain[1], 41)
    points = made.evaluate_grid(np.linspace(*made.domain[0], 9), v)
    centers = rail.evaluate(np.linspace(*rail.domain, 41))
    assert np.abs(np.linalg.norm(points - centers[None], axis=2) - radius).max() <= 1.01 * tolerance


def test_upright_sections_stay_upright():
    helix = build.helix(line((0, 0, 0), (0, 0, 4)), 2.0, 1.5)
    wall = line((0, 0, 0), (0, 1, 0))
    made, _ = build.sweep(helix, wall, frame="upright", tolerance=1e-6)
    points = grid(made)
    up = points[-1] - points[0]
    slope = (4 / 1.5) / (2 * math.pi * 2.0)
    assert np.abs(up[:, 2] / np.linalg.norm(up, axis=1) - 1 / math.hypot(1, slope)).max() <= 1e-5
    with pytest.raises(sc.InvalidShape, match="upright"):
        build.sweep(line((0, 0, 0), (0, 0, 1)), wall, frame="upright")


def test_scale_and_twist_go_by_length():
    rail = sc.PowerCurve([(0, 0, 0), (0, 0, 1), (0, 0, 3)])                    # it speeds up: no straight parameter
    made, _ = build.sweep(rail, line((1, 0, 0), (2, 0, 0)), end_scale=3.0, twist=math.pi, tolerance=1e-7, start=(1, 0, 0))
    points = grid(made)
    share = points[0, :, 2] / 4
    assert np.linalg.norm(points[0, :, :2], axis=1) == pytest.approx(1 + 2 * share, abs=1e-6)
    assert np.unwrap(np.arctan2(points[0, :, 1], points[0, :, 0])) == pytest.approx(math.pi * share, abs=1e-6)

def waving_rail(count, degree=3, closed=False):
    """Bends differently in every span."""
    turn = np.linspace(0, 2 * math.pi, count, endpoint=not closed)
    points = np.stack([4 * np.cos(turn), 3 * np.sin(turn), 0.5 * np.sin(5 * turn)], 1)
    if closed:
        return sc.NurbsCurve(degree, np.arange(count + 1.0), points, periodic=True)
    return sc.NurbsCurve(degree, np.concatenate([np.zeros(degree), np.arange(count - degree + 1), np.full(degree, count - degree)]), points)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [3, 4, 5])
def test_rows_are_few_and_smooth_where_the_rail_has_knots(degree, closed):
    rail = waving_rail(16, degree, closed)
    made, error = build.sweep(rail, line((-0.2, 0, 0), (0, 0.1, 0), (0.2, 0, 0)), tolerance=1e-4)
    assert error <= 1e-4 and made.points.shape[1] <= (90 if closed else 80)
    knots = made.knots[1][:-1] if closed else np.unique(made.knots[1])[1:-1]
    before, after = (made.derivatives(np.full(len(knots), 0.3), knots, 1, side=side)[:, 0, 1] for side in ("left", "right"))
    assert np.abs(before - after).max() <= 1e-9 * np.abs(after).max()


def test_a_rail_that_needs_no_knots_gets_none():
    made, _ = build.sweep(line((0, 0, 0), (1, 0, 0.2), (2, 0, 0)), ring(0.1), tolerance=1e-2)
    assert len(set(made.knots[1])) == 2
    knots = np.concatenate([np.zeros(3), np.arange(31), np.full(3, 30)])
    gentle = sc.NurbsCurve(3, knots, [(x, 0.01 * x * x, 0) for x in (knots[i:i + 3].mean() / 30 for i in range(1, 34))])
    assert build.sweep(gentle, ring(0.1), tolerance=1e-3).value.points.shape[1] <= 6


@pytest.mark.parametrize("closed", [False, True])
def test_weights_of_the_section_stay(closed):
    rail = waving_rail(12, closed=closed)
    assert not build.sweep(rail, waving_rail(8).transformed(0.1 * np.eye(3)), tolerance=1e-4).value.is_rational
    several = [waving_rail(8).transformed(size * np.eye(3)) for size in (0.1, 0.2, 0.15)]
    assert not build.sweep(rail, several, at=np.linspace(*rail.domain, 4)[:3], tolerance=1e-4).value.is_rational
    made = build.sweep(rail, ring(0.1), tolerance=1e-4).value
    assert np.array_equal(made.weights, np.repeat(made.weights[:, :1], made.weights.shape[1], 1))



def test_sections_change_along_the_rail():
    rail = sc.BezierCurve([(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 3, 3)])
    made, error = build.sweep(rail, [ring(1.0), ring(0.5), ring(0.8)], at=[0, 0.4, 1], tolerance=1e-6)
    for v, radius in ((0, 1.0), (0.4, 0.5), (1, 0.8)):
        edge = made.evaluate(np.linspace(*made.domain[0], 33), np.full(33, v))
        assert np.linalg.norm(edge - rail.evaluate(v), axis=1) == pytest.approx(radius, abs=1e-5)
    assert error <= 1e-6


def test_corners_of_straight_rails_are_mitered():
    rail = build.contour([(0, 0, 0), (4, 0, 0), (4, 3, 0), (4, 3, 5)])
    made, error = build.sweep(rail, ring(0.5), tolerance=1e-9)
    assert error <= 1e-9
    points = grid(made, 97).reshape(-1, 3)
    segments = [((0, 0, 0), (1, 0, 0)), ((4, 0, 0), (0, 1, 0)), ((4, 3, 0), (0, 0, 1))]
    off = np.min([np.abs(np.linalg.norm(np.cross(points - a, d), axis=1) - 0.5) for a, d in segments], axis=0)
    assert off.max() <= 1e-9
    frame = build.contour([(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)], closed=True)
    closed, _ = build.sweep(frame, ring(0.5), tolerance=1e-9)
    assert np.abs(grid(closed)[:, 0] - grid(closed)[:, -1]).max() <= 1e-12      # its first corner is mitered, too


@pytest.mark.parametrize("rail, sections, more, words", [
    (line((0, 0, 0), (1, 0, 0)), [], {}, "no section"),
    (line((0, 0, 0), (1, 0, 0)), [circle(), circle()], {"at": [0.5, 0.2]}, "behind"),
    (line((0, 0, 0), (1, 0, 0)), [circle()], {"at": [3.0]}, "parameter 3"),
    (line((0, 0, 0), (1, 0, 0)), [circle()], {"at": [0.0, 1.0]}, "for 1 sections"),
    (line((0, 0, 0), (1, 0, 0)), circle(), {"end_scale": 0.0}, "end_scale"),
    (line((0, 0, 0), (1, 0, 0)), circle(), {"twist": math.inf}, "twist"),
    (line((0, 0, 0), (1, 0, 0)), circle(), {"frame": "loose"}, "loose"),
    (build.contour([(0, 0, 0), (4, 0, 0), (1, 0, 0)]), circle(), {}, "turns back"),
    (build.contour([(0, 0, 0), (1, 0, 0), (2, 2, 0)], bulges=[0, 0.5]), circle(), {}, "round the corner first"),
    (cubic(), circle(), {"frame": "parallel", "twist": 1.0}, "parallel"),
    (line((1, 1, 1), (1, 1, 1)), circle(), {}, "point"),
])
def test_what_cannot_be_swept_is_refused(rail, sections, more, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.sweep(rail, sections, **more)


def test_a_twist_that_rows_could_not_follow_is_refused():
    """At places for which it is made of whole turns it could not be told from none."""
    rail = sc.BezierCurve([(0, 0, 0), (0, 0, 9)])
    section = sc.BezierCurve([(1, 0, 0), (2, 0, 0)])
    for twist in (80 * np.pi * 4096, -1e9):
        with pytest.raises(sc.InvalidShape, match="at most 1024 turns"):
            build.sweep(rail, section, twist=twist, tolerance=1e-3)
