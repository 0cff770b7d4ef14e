"""What curves have in common does not depend on how far they go on, on their pace, or on how far away they are."""

import numpy as np
import pytest

import splinecore as sc
from test_contacts_of_curves import counts, touching
from test_fits_move import at_shares, made_or_none, moved_back, off, task


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_a_part_that_holds_a_contact_touches_as_the_whole_curve(order, inputs):
    """However large the tolerance: a contact within it along half of a part is no overlap."""
    for index in range(inputs(250)):
        rng = np.random.default_rng([index, order, 31])
        at, a, b = touching(rng, order)
        tolerance = 10 ** rng.uniform(-10, -5)
        whole = a.intersections(b, tolerance)
        assert counts(whole) == (1, 0), index
        for cut in rng.uniform(0.1, 0.9, 2):
            if b.nearest(a.evaluate(cut)).distances > 4 * tolerance:
                parts = sorted(counts(part.intersections(b, tolerance)) for part in a.split(cut))
                assert parts == [(0, 0), (1, 0)], index


def test_curves_beside_each_other_within_the_tolerance_are_one(inputs):
    """Half a tolerance apart all along, along all or a part of both, from end to end or to a corner."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 32])
        gap = 10 ** rng.uniform(-8, -3)
        start, end = np.sort(rng.uniform(-0.5, 1.5, 2))
        if min(end, 1) - max(start, 0) < 0.1:
            continue
        line = sc.BezierCurve([(0, 0, 0), (1, 0, 0)]).to_nurbs()
        beside = np.array([(start, gap, 0), (end, gap, 0)])
        if rng.random() < 0.5:  # and goes away at a corner
            beside = np.r_[beside, [(end, 1, 0)]]
        other = sc.NurbsCurve(1, np.r_[0, np.arange(len(beside)), len(beside) - 1], beside)
        for one, two in ((line, other), (other, line), (line.reversed(), other)):
            assert counts(one.intersections(two, 2 * gap)) == (0, 1), index
        assert counts(line.intersections(other, 0.9 * gap)) == (0, 0), index


def test_a_curve_that_stands_still_at_its_end_is_one_with_its_copies(inputs):
    """Weights far above that of the end make rounding of the speed there."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 33])
        degree = int(rng.integers(3, 8))
        points = rng.uniform(-1, 1, (degree + 1, 3)) * [1, 1, index % 2]
        points[-1] = points[-2]
        weights = 10 ** rng.uniform(-3, 3, degree + 1)
        curve = sc.NurbsCurve(degree, np.r_[[0] * (degree + 1), [1] * (degree + 1)], points, weights)
        copy = curve.refine(rng.uniform(0, 1, 2))
        copy = (copy.reversed() if rng.random() < 0.5 else copy).elevate()
        size = np.ptp(points, axis=0).max()
        for a, b in ((curve, copy), (copy, curve)):
            longest = max(a.intersections(b).overlaps, key=lambda overlap: np.ptp(overlap[0]))
            ends = [np.linalg.norm(c.evaluate(longest[k]) - c.evaluate(c.domain), axis=1) for k, c in enumerate((a, b))]
            assert np.max(ends) <= 1e-6 * size, index


def hurried_loop(rng):
    """It nearly stands still along most of its first span, and makes a loop in the last 1e-6 of it and the start of the next."""
    knots = [0.0] * 5 + [0.337545] * 4 + [1.0] * 5
    points = np.array([(0.182483, 1.097192), (0.181412, -0.439212), (0.559382, -0.112233), (-0.926293, -0.258065),
                       (0.118878, 0.261298), (-0.327498, 0.088274), (0.780931, 0.107222), (-0.197128, -0.335801),
                       (-0.372167, -0.408675)])
    weights = np.array([95.001, 1.1222, 0.089295, 958.5, 0.2357, 1.1131, 136.81, 182.22, 136.62])
    points += 0.05 * rng.normal(size=points.shape)
    return sc.NurbsCurve(4, knots, np.c_[points, np.zeros(9)], weights * 10 ** rng.uniform(-0.2, 0.2, 9))


def reach_of_loop(curve, place):
    knot = 0.337545  # evenly on both sides of it
    points = curve.evaluate(np.r_[np.linspace(place[0], knot, 300), np.linspace(knot, place[1], 300), np.linspace(*place, 300)])
    return np.linalg.norm(points - points[0], axis=1).max()


def test_loops_are_found_whatever_the_pace(inputs):
    """Those that a small tolerance finds, with a larger one that they reach far beyond."""
    loops = 0
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 34])
        curve, tolerance = hurried_loop(rng), 10 ** rng.uniform(-6, -4.5)
        wanted = curve.self_intersections(tolerance=1e-9).parameters
        wanted = [place for place in wanted if reach_of_loop(curve, place) > 30 * tolerance]
        loops += len(wanted)
        for one in (curve, curve.reversed()):
            found = one.self_intersections(tolerance=tolerance)
            places = found.parameters if one is curve else 1 - found.parameters[:, ::-1]
            for place in wanted:
                is_on = any(np.all([low <= u <= high for u, (low, high) in zip(place, pair)]) for pair in found.overlaps)
                assert is_on or np.abs(places - place).max(axis=1).min(initial=1) < 1e-3, index
    assert loops > 0.5 * inputs(1000)


def test_faired_curves_far_away_are_those_near_the_origin(inputs):
    """Ten million sizes away, with weights of six powers of ten, up to the rounding of their points."""
    far = 1e7
    for seed in range(inputs(1000)):
        rng, curve, size, _, motion = task(seed, 4)
        scale = np.linalg.norm(motion[:, 0])
        motion[:, 3] = scale * far * size * rng.uniform(-1, 1, 3)
        tolerance = size * 10 ** rng.uniform(-5, -1)
        made = [made_or_none(way) for way in (lambda: curve.fair(tolerance), lambda: curve.transformed(motion).fair(tolerance * scale))]
        assert (made[0] is None) == (made[1] is None), seed
        if None in made:
            continue
        plain, moved = made
        slack = 0.01 * tolerance + 1e-13 * far * size
        assert off(at_shares(plain.value), moved_back(at_shares(moved.value), motion)) <= slack, seed
        assert abs(plain.error - moved.error / scale) <= slack, seed


def test_a_stretch_that_comes_to_rest_is_found_however_refined():
    """Of the last 1e-6 before it rests the nearest place lies between the end and what is looked at beside it."""
    weights = [0.6146893213348281, 3.132686605456112, 0.009905607718017243, 0.001467994884345279, 899.3317373788227,
               229.96771315980496, 0.0020190069436772764, 6.836530165571941]
    points = [(0.6348464197425387, -0.4412755748178758, -0.3123834743029381),
              (0.4263048728539667, -0.5967348168724687, -0.5899292877944313),
              *[(0.4335431685814706, 0.9896150405522783, -0.6546369539103278)] * 3,
              (0.1253677328984053, 0.7467988218458481, -0.73825081072538),
              (0.42783980534250277, -0.3879085907301616, 0.7173294634222074),
              (-0.5007039688546713, -0.648026768298454, -0.5721140921389258)]
    knots = [0.0, 0.0, 0.0, 0.20219289702733712, 0.4632278866795384, 0.7119096743535488, 0.7119096743535488,
             0.7769725407340635, 1.0, 1.0, 1.0]
    curve = sc.NurbsCurve(2, knots, points, weights)
    part = curve.part(0.1912683975109043, 0.5138331863555675)
    for seed in range(20):
        refined = curve.refine(np.sort(np.random.default_rng(seed).uniform(0, 1, 3)))
        assert counts(refined.intersections(part)) == (0, 1) == counts(part.intersections(refined)), seed
