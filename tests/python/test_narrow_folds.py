"""Folds about as wide as the tolerance: the same overlaps however curves are given; cusps are touched by no arcs."""

import numpy as np
from numpy.polynomial import Polynomial

import splinecore as sc
from splinecore import build
from test_contacts_of_curves import counts, power_curve, ways_to_say

TOLERANCE = 1e-5


def fold(rng):
    """Along a line to and fro, some of the ways from a tenth of the tolerance to a hundred of them long."""
    count = int(rng.integers(3, 9))
    steps = rng.uniform(0.1, 0.5, count) * np.where(np.arange(count) % 2, -1, 1)
    short = rng.random(count) < 0.4
    steps[short] = np.sign(steps[short]) * TOLERANCE * 10 ** rng.uniform(-1, 2, short.sum())
    shares = np.r_[0, np.cumsum(steps)]
    shares /= max(np.abs(shares).max(), 0.1)
    degree = int(rng.integers(1, min(4, count)))
    inner = np.sort(rng.uniform(0.1, 0.9, count - degree))
    way = rng.normal(size=3)
    knots = np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)]
    return sc.NurbsCurve(degree, knots, np.outer(shares, way / np.linalg.norm(way)))


def beside(rng, curve):
    """The curve itself, a part of it, or the line that it runs along."""
    choice = rng.integers(4)
    if choice == 0:
        return curve.reversed().elevate()
    if choice == 1:
        return curve.part(*np.sort(rng.uniform(0, 1, 2)))
    if choice == 2:
        along = curve.points @ curve.points[np.abs(curve.points).max(axis=1).argmax()]
        return sc.NurbsCurve(1, [0, 0, 1, 1], curve.points[[along.argmin(), along.argmax()]])
    return curve.refine(rng.uniform(0, 1, 2))


def odd_ways(index):
    """The ways to give curves in which there are other numbers, though not at the edge of the tolerance."""
    rng = np.random.default_rng([index, 51])
    curve = fold(rng)
    other = beside(rng, curve)
    found = counts(curve.intersections(other, TOLERANCE))
    ways = list(ways_to_say(rng, curve, other))
    scale = [1.0, ways[1][0].length() / curve.length(), 1.0, 1.0, 1.0]
    odd = [k for k, (a, b) in enumerate(ways) if counts(a.intersections(b, TOLERANCE * scale[k])) != found]
    edge = {counts(curve.intersections(other, TOLERANCE * factor)) for factor in (0.9, 0.98, 1.02, 1.1)} if odd else {found}
    return odd if edge == {found} else []


def test_narrow_folds_have_the_same_overlaps_however_given(inputs):
    """In at most one of 25, of many narrow folds each, the numbers differ without being at the edge of the tolerance."""
    odd = [index for index in range(inputs(1000)) if odd_ways(index)]
    assert len(odd) <= inputs(1000) / 25, odd


def test_what_folds_along_its_own_copy_is_one_with_it_and_comes_back_once():
    """There are 10 tolerances from turn to turn."""
    for step in (2.0, 6.0, 10.0):
        shares = np.array([0, 1, 1 - step * TOLERANCE, 2])
        zigzag = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], np.outer(shares, (1, 0, 0)))
        line = sc.NurbsCurve(1, [0, 0, 1, 1], np.array([(0, 0, 0), (2, 0, 0)]))
        for a, b in ((zigzag, line), (line, zigzag), (zigzag.reversed(), line)):
            assert counts(a.intersections(b, TOLERANCE)) == (0, 1)


def test_no_arc_touches_a_cusp(inputs):
    """Where rounding leaves a speed that is not zero a cusp has all tangents: each arc ends on its curves, along them."""
    for index in range(inputs(200)):
        rng = np.random.default_rng([index, 52])
        at = Polynomial([-rng.uniform(0.3, 0.7), 1])
        cusp = power_curve(at**2, at**3, Polynomial([0.0]))
        turned = np.eye(4)
        turned[:2, :2] = rng.normal(size=(2, 2))
        cusp = cusp.transformed(turned)
        other = sc.BezierCurve(np.c_[rng.uniform(-0.5, 0.5, (4, 2)), np.zeros(4)]).to_nurbs()
        try:
            arcs = build.fillets(cusp, other, 10 ** rng.uniform(-2, 0))
        except sc.InvalidShape as refused:
            assert "not told" in str(refused)
            continue
        for arc, a, b, _, _ in arcs:
            for curve, u, end in ((cusp, a, arc.domain[0]), (other, b, arc.domain[1])):
                along, of_arc = curve.derivatives(u, 1)[1], arc.derivatives(end, 1)[1]
                sine = np.linalg.norm(np.cross(along, of_arc)) / (np.linalg.norm(along) * np.linalg.norm(of_arc))
                assert np.linalg.norm(curve.evaluate(u) - arc.evaluate(end)) < 1e-6 and sine < 1e-5, index
