"""All arcs of a radius that touch two curves: as many as the offsets cross, counted by polygons, and moved, scaled and turned round the
same."""

import numpy as np

import splinecore as sc
from splinecore import build


def random_curve(rng):
    degree = int(rng.choice([1, 2, 3, 3, 4, 5, 8]))
    count = degree + 1 + int(rng.integers(0, 6))
    knots = np.r_[np.zeros(degree + 1), np.sort(rng.uniform(0.0, 1.0, count - degree - 1)), np.ones(degree + 1)]
    points = np.c_[rng.uniform(-2, 2, (count, 2)), np.zeros(count)]
    weights = 10**rng.uniform(-1, 1, count) if rng.random() < 0.3 else None
    return sc.NurbsCurve(degree, knots, points, weights)


def cubic(rng):
    return sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], np.c_[rng.uniform(-2, 2, (6, 2)), np.zeros(6)])


def offset_points(curve, side, at):
    found = np.array([curve.derivatives(u, 1) for u in at])
    tangent = found[:, 1, :2] / np.linalg.norm(found[:, 1, :2], axis=1)[:, None]
    return found[:, 0, :2] + side * np.c_[-tangent[:, 1], tangent[:, 0]]


def offset_polygon(curve, side, count, longest=0.02):
    """At even parameters, and closer where a curve that nearly stops turns round: there the offset runs along an arc."""
    at = np.linspace(*curve.domain, count)
    points = offset_points(curve, side, at)
    for _ in range(40):
        steps = np.flatnonzero(np.linalg.norm(np.diff(points, axis=0), axis=1) > longest)
        if not len(steps):
            break
        between = 0.5 * (at[steps] + at[steps + 1])
        points = np.insert(points, steps + 1, offset_points(curve, side, between), axis=0)
        at = np.insert(at, steps + 1, between)
    return points


def crossings(a, b):
    by_a, by_b = np.diff(a, axis=0), np.diff(b, axis=0)
    count = 0
    for start, way in zip(a[:-1], by_a):
        area = way[0] * by_b[:, 1] - way[1] * by_b[:, 0]
        gap = b[:-1] - start
        with np.errstate(all="ignore"):
            s = (gap[:, 0] * by_b[:, 1] - gap[:, 1] * by_b[:, 0]) / area
            t = (gap[:, 0] * way[1] - gap[:, 1] * way[0]) / area
        count += np.count_nonzero((s >= 0) & (s < 1) & (t >= 0) & (t < 1))
    return count


def is_on_edge(a, b, radius):
    """Whether offsets nearly touch: a radius a little smaller or larger has another number of arcs."""
    return len({len(build.fillets(a, b, radius * share)) for share in (0.999, 0.9999, 1.0001, 1.001)}) > 1


def require_count(a, b, radius, found, wanted, seed):
    assert found == wanted or is_on_edge(a, b, radius), (seed, found, wanted)


def test_none_is_missed(inputs):
    """Where a curve bends more than the arc, its place is not the nearest one to the center."""
    for seed in range(inputs(80)):
        rng = np.random.default_rng([seed, 4])
        a, b, radius = cubic(rng), cubic(rng), rng.uniform(0.1, 0.8)
        sides = [[offset_polygon(curve, side, 1000) for side in (radius, -radius)] for curve in (a, b)]
        wanted = sum(crossings(one, two) for one in sides[0] for two in sides[1])
        require_count(a, b, radius, len(build.fillets(a, b, radius)), wanted, seed)


def test_motions_scales_and_directions_change_nothing(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 5])
        a, b, radius = random_curve(rng), random_curve(rng), 10**rng.uniform(-1.3, 0.3)
        count = len(build.fillets(a, b, radius))
        turn, scale = rng.uniform(0, 2 * np.pi), 10**rng.uniform(-12, 9)
        matrix = np.eye(4)
        matrix[:2, :2] = scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        matrix[:2, 3] = scale * rng.uniform(-3, 3, 2)
        for one, other, by in ((a.transformed(matrix), b.transformed(matrix), scale), (b, a, 1.0), (a.reversed(), b.reversed(), 1.0)):
            require_count(a, b, radius, len(build.fillets(one, other, radius * by)), count, seed)


def test_an_arc_that_touches_a_curve_twice_is_there_for_both_places():
    """Half a turn about a place on the middle line of two walls touches both: with the floor, there are two corners."""
    walls = build.contour([(-1, 3, 0), (-1, 0, 0), (1, 0, 0), (1, 3, 0)])
    floor = sc.BezierCurve([(-4, 0.5, 0), (4, 0.5, 0)])
    found = build.fillets(walls, floor, 1.0)
    centers = {tuple(np.round(arc.evaluate(arc.domain[0]), 6)) for arc, *_ in found}
    assert {(-1.0, 1.5, 0.0), (1.0, 1.5, 0.0)} <= centers
