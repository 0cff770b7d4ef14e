"""Lofts of closed sections that are the same but for a motion, a beginning, a direction, a size or digits: no more knots than one has."""

import numpy as np

import splinecore as sc
from splinecore import build, fit


def rotation(rng):
    q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return q * np.linalg.det(q)


def turned_by(angle):
    return np.array([[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])


KINDS = {
    "as it is": lambda points, i, rng: points,
    "single precision": lambda points, i, rng: points.astype(np.float32).astype(float),
    "six digits": lambda points, i, rng: points.round(6),
    "scaled": lambda points, i, rng: points * (1.0 + 0.2 * i),
    "turned by little": lambda points, i, rng: points @ turned_by(rng.normal() * 1e-5),
    "turned on and on": lambda points, i, rng: points @ turned_by(2e-5 * i),
    "far away": lambda points, i, rng: points + 1e5,
}


def sections(rng):
    """@returns closed curves, the number of points and the shortest span of each."""
    count, degree = int(rng.integers(5, 25)), int(rng.integers(1, 6))
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    points = np.c_[np.cos(angle) * rng.uniform(1, 3), np.sin(angle), 0 * angle] + rng.normal(size=(count, 3)) * [0.1, 0.1, 0.05]
    steps = np.ones(count) if rng.random() < 0.5 else np.exp(rng.normal(size=count) * 0.5)
    weights = None if rng.random() < 0.6 else np.exp(rng.normal(size=count) * 0.3)
    start, unit = rng.choice([0.0, 1.0, 1e3, 1e6]), 10.0 ** rng.integers(-3, 4)
    change, turn = KINDS[str(rng.choice(list(KINDS)))], rotation(rng)
    made = []
    for i in range(int(rng.integers(2, 7))):
        by = int(rng.integers(0, count))
        moved = change((np.roll(points, -by, 0) + [0.0, 0.0, 2.0 * i]) @ turn, i, rng)
        knots = start + unit * np.r_[0.0, np.cumsum(np.roll(steps, -by))]
        curve = sc.NurbsCurve(degree, knots, moved, None if weights is None else np.roll(weights, -by), periodic=True)
        made.append(curve.reversed() if rng.random() < 0.3 else curve)
    return made, count, steps.min() / steps.sum()


def test_copies_share_their_knots(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 41])
        curves, count, shortest = sections(rng)
        made = build.loft(curves)
        spans = np.diff(np.unique(made.value.knots[0]))
        assert made.value.points.shape[0] == count, seed
        assert spans.min() > 0.999 * shortest * spans.sum(), seed
        size = max(np.ptp(curve.points, axis=0).max() for curve in curves)
        for curve in curves[:: max(1, len(curves) - 1)]:
            places = np.linspace(*curve.domain, 23)
            rounding = 1e-12 * np.abs(curve.points).max() + 1e-13 * size * np.abs(curve.domain).max() / np.diff(np.unique(curve.knots)).min()
            assert made.value.nearest(curve.evaluate(places)).distances.max() <= made.error + rounding, seed


def test_beginnings_that_are_off_by_less_than_a_knot_can_be():
    """Circles of 24 spans, each turned by so much: by less than a sixteenth of a span they begin at a knot; what is left does not add up."""
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    points = np.c_[3 * np.cos(angle), np.sin(angle), 0 * angle]
    for turn in (1e-9, 1e-6, 1e-4, 1e-3):
        curves = [sc.NurbsCurve(3, np.arange(25.0), points @ turned_by(turn * i) + [0, 0, i], periodic=True) for i in range(4)]
        assert build.loft(curves).value.points.shape[0] == 24
    # An ellipse by itself is turned where its sections are: each begins beside the one before it.
    curves = [sc.NurbsCurve(3, np.arange(25.0), np.roll(points, 3 * i, 0) + [0, 0, i], periodic=True) for i in range(4)]
    made = build.loft(curves).value
    first, last = (made.evaluate_grid([made.domain[0][0]], [v])[0, 0] for v in made.domain[1])
    assert np.allclose(last - first, [0, 0, 3], atol=1e-12)


def test_knots_that_rounding_parts_are_one():
    """Chord lengths of points far away differ in their last digits; what that moves is rounding, or said."""
    rng = np.random.default_rng(5)
    points = np.cumsum(rng.uniform(0.5, 1, (30, 3)), axis=0)
    curves = [fit.interpolate(points @ rotation(rng) + offset, parameters="chordal").value for offset in (0.0, 1e2, 1e3)]
    assert len({tuple(curve.knots) for curve in curves}) > 1
    made = build.loft(curves, align=False)
    assert made.value.points.shape[0] == curves[0].points.shape[0] and made.error < 1e-9


def test_knots_of_domains_far_from_zero():
    """What rounding of a domain makes of knots is one in every order of the sections."""
    rng = np.random.default_rng(6)
    knots = np.r_[[0.0] * 4, np.sort(rng.uniform(0.1, 0.9, 6)), [1.0] * 4]
    for far in (1e3, 1e6, 1e9):
        near, other = (sc.NurbsCurve(3, at, rng.normal(size=(10, 3))) for at in (knots, far + knots))
        for both in ([near, other], [other, near]):
            assert build.loft(both, align=False).value.points.shape[0] == 10, far
