"""Curves whose weights have both signs run through infinity, where rounding is more than the tolerance: they are decided
there, too, and soon."""

import time

import numpy as np

import splinecore as sc
from test_nothing_is_missed import motion

SOON = 4.0  # seconds: all pairs up to the limit take longer


def endless(rng):
    degree = int(rng.integers(1, 9))
    inner = np.sort(rng.uniform(0, 1, int(rng.integers(0, 4))))
    count = degree + 1 + len(inner)
    weights = rng.choice([-1, 1], count) * 10 ** rng.uniform(-1, 1, count)
    weights[:2] = 1, -1
    knots = np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)]
    return sc.NurbsCurve(degree, knots, rng.uniform(-1, 1, (count, 3)), weights)


def soon(call):
    start = time.process_time()
    found = call()
    assert time.process_time() - start < SOON
    return found


def test_a_curve_through_infinity_lies_on_itself_all_along(inputs):
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 61])
        curve = endless(rng)
        places = rng.uniform(0, 1, 100)
        far = np.linalg.norm(curve.evaluate(places), axis=1)
        for said in (curve, curve.transformed(motion(rng))):
            found = soon(lambda: said.intersections(said))
            own = [a for a, b in found.overlaps if np.abs(a - b).max() < 1e-6]
            lies = np.any([(places >= start) & (places <= end) for start, end in own], axis=0)
            assert lies[far < 1e3].all(), index


def test_what_stands_still_is_one_place_whatever_its_weights(inputs):
    """Its points are 0 / 0 where its weight is zero, and rounding next to there."""
    for index in range(inputs(1000)):
        rng = np.random.default_rng([index, 62])
        curve = endless(rng)
        u = rng.uniform(0, 1)
        point = curve.evaluate(u)
        if np.abs(point).max() > 10:
            continue
        degree = int(rng.integers(1, 8))
        weights = rng.choice([-1, 1], degree + 1) * 10 ** rng.uniform(-3, 3, degree + 1)
        still = sc.NurbsCurve(degree, [0] * (degree + 1) + [1] * (degree + 1), [point] * (degree + 1), weights)
        for a, b, axis in ((curve, still, 0), (still, curve, 1)):
            found = soon(lambda: a.intersections(b))
            assert len(found.parameters) >= 1 and not len(found.overlaps), index
            assert np.abs(found.parameters[:, axis] - u).min() < 1e-4, index


def test_points_far_beyond_all_others_are_decided_soon():
    """Beside 1e275 all else is one point."""
    far = sc.NurbsCurve(6, [0] * 7 + [1] * 7, np.eye(7)[:, [2, 3, 4]] * 1e275, [1, 4, 2, -1, 3, 2, 1])
    for weights in ([4.0, -0.6], [1.0, 1.0]):
        near = sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 4, 0), (2, 3, 1)], weights)
        assert len(soon(lambda: far.intersections(near)).parameters) >= 1
        assert len(soon(lambda: near.intersections(far)).parameters) >= 1


def test_a_jump_within_the_rounding_of_the_parameter_is_said():
    """Between weights of 1 and 1e150 the curve goes all its way in 1e-19 of its parameter."""
    points = np.random.default_rng(4).uniform(-1, 1, (9, 3))
    curve = sc.NurbsCurve(8, [0] * 9 + [1] * 9, points, [1e-150, 1e-140, 7, -7, 0.5, 2, 1e150, 1, 1])
    other = sc.NurbsCurve(8, [0] * 9 + [1] * 9, points[::-1])
    for call in (lambda: curve.intersections(other), lambda: curve.intersections(curve), curve.self_intersections):
        try:
            soon(call)
        except sc.InvalidShape as refused:
            assert "weights are too unlike" in str(refused) or "within the tolerance" in str(refused)
