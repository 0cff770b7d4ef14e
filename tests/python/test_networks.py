"""Surfaces between curves that go round, and through networks: patches come back, sides and curves are on them, bad calls."""

import itertools
import math

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from shapes import circle
from splinecore import build


def grid(patch, count=17):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def line(*points):
    return sc.BezierCurve(points)


def sides_of(patch):
    return [patch.boundary(side) for side in ("v_start", "u_end", "v_end", "u_start")]


# Coons


def test_the_sides_of_a_bilinear_patch_give_it_back():
    rng = np.random.default_rng(1)
    for _ in range(50):
        patch = sc.BezierPatch(rng.uniform(-1, 1, (2, 2, 3)) * 10.0 ** rng.integers(-3, 4))
        made, error = build.coons(sides_of(patch))
        assert error == 0.0 and made.degree == (1, 1)
        assert np.abs(made.points - patch.points).max() <= 1e-15 * np.abs(patch.points).max()


def test_any_order_of_turning_and_any_size():
    patch = sc.BezierPatch(np.random.default_rng(2).uniform(-1, 1, (4, 3, 3)))
    reference = build.coons(sides_of(patch)).value
    for turned in itertools.product((False, True), repeat=3):
        sides = [side.reversed() if t else side for side, t in zip(sides_of(patch), (False, *turned))]
        assert np.abs(grid(build.coons(sides).value) - grid(reference)).max() <= 1e-14
    for scale in (1e-150, 1e150):
        made = build.coons([side.to_nurbs().transformed(scale * np.eye(3)) for side in sides_of(patch)]).value
        assert np.abs(grid(made) / scale - grid(reference)).max() <= 1e-13


def test_every_side_is_on_the_patch():
    rng = np.random.default_rng(3)
    for _ in range(200):
        corners = rng.uniform(-10, 10, (4, 3))
        sides = []
        for i in range(4):
            curve = random_curve(rng, ends="clamped", degree=int(rng.integers(2, 6)))
            knots, points, weights = curve.knots, curve.points.copy(), curve.weights
            points[0], points[-1] = corners[i], corners[(i + 1) % 4]
            sides.append(sc.NurbsCurve(curve.degree, knots, points, weights))
        made = build.coons(sides).value
        for side, border in zip(sides, ("v_start", "u_end", "v_end", "u_start")):
            edge = made.boundary(border)
            if border in ("v_end", "u_start"):
                edge = edge.reversed()
            standard = side.standard_form()
            t = np.linspace(0, 1, 30)
            at = [curve.domain[0] + t * (curve.domain[1] - curve.domain[0]) for curve in (standard, edge)]
            assert np.abs(standard.evaluate(at[0], side="left") - edge.evaluate(at[1], side="left")).max() <= 1e-9
        assert (made.points[0, 0] == corners[0]).all() and (made.points[-1, -1] == corners[2]).all()


def test_three_sides_and_rational_ones():
    """An octant of a sphere has its borders."""
    x, y, z = np.eye(3)
    arcs = [sc.BezierCurve([a, a + b, b], [1, math.sqrt(0.5), 1]) for a, b in ((x, y), (y, z), (z, x))]
    made = build.coons(arcs).value
    for side in ("v_start", "u_end", "v_end"):
        edge = made.boundary(side)
        assert np.abs(np.linalg.norm(edge.evaluate(np.linspace(*edge.domain, 40)), axis=1) - 1).max() <= 1e-14
    assert np.ptp(made.points[0], axis=0).max() == 0.0


def test_a_gap_is_said_and_closed_within_a_tolerance():
    sides = [line((0, 0, 0), (1, 0, 0)), line((1, 0.01, 0), (1, 1, 0)), line((1, 1, 0), (0, 1, 0)), line((0, 1, 0), (0, 0, 0))]
    with pytest.raises(sc.ToleranceNotReached, match=r"sides\[0\] and sides\[1\] do not meet") as refused:
        build.coons(sides)
    assert "0.01" in str(refused.value)
    made, error = build.coons(sides, tolerance=0.02)
    assert error == pytest.approx(0.005) and made.points[-1, 0].tolist() == [1, 0.005, 0]


@pytest.mark.parametrize("sides, error, words", [
    ([line((0, 0, 0), (1, 0, 0))] * 2, sc.InvalidShape, "three or four"),
    ([circle().to_periodic().value] * 3, sc.InvalidShape, "closed"),
    ([line((0, 0, 0), (1, 0, 0)), line((5, 0, 0), (6, 0, 0)), line((9, 0, 0), (8, 3, 0))], sc.ToleranceNotReached, "gap"),
    (["side"] * 3, sc.InvalidShape, "a curve is expected"),
])
def test_what_goes_round_no_patch_is_refused(sides, error, words):
    with pytest.raises(error, match=words):
        build.coons(sides)


# Gordon


def greville(knots, degree, count):
    return np.array([knots[i + 1:i + degree + 1].mean() for i in range(count)])


def test_curves_of_any_patch_give_it_back():
    """As many along u as it has control points along v."""
    rng = np.random.default_rng(4)
    done = 0
    while done < 150:
        degree = int(rng.integers(1, 5))
        patch = random_patch(rng, ends="clamped", degree=degree, spans=int(rng.integers(1, 4)))
        if any((np.diff(np.unique(knots)) < 0.1).any() or (np.bincount(np.searchsorted(np.unique(knots), knots))[1:-1] > degree).any()
               for knots in patch.knots):
            continue
        if rng.random() < 0.5:
            patch = sc.NurbsPatch(patch.degree, patch.knots, patch.points)
        (count_u, count_v) = patch.points.shape[:2]
        at_v = greville(patch.knots[1], degree, count_v)
        at_u = np.linspace(*patch.domain[0], int(rng.integers(2, 6)))
        along_u = [patch.isocurve("v", v) for v in at_v]
        along_v = [patch.isocurve("u", u) for u in at_u]
        try:
            made, error = build.network(along_u, along_v)
        except sc.InvalidShape as refused:
            assert "places" in str(refused)             # a wild patch crosses itself
            continue
        done += 1
        assert max(np.abs(grid(made) - grid(patch)).max(), error) <= 1e-12 * np.abs(patch.points).max()


def test_order_and_direction_do_not_matter_and_what_hangs_over_is_cut_off():
    along_u = [line((-1, y, y * y), (3, y, y * y)) for y in (0.0, 0.5, 1.0, 2.0)]
    along_v = [sc.BezierCurve([(x, 0, 0), (x, 1, 0), (x, 2, 4)]) for x in (0.0, 1.0, 2.0)]
    reference = build.network(along_u, along_v).value
    rng = np.random.default_rng(5)
    for _ in range(10):
        u, v = [along_u[i] for i in rng.permutation(4)], [along_v[i] for i in rng.permutation(3)]
        u = [curve.reversed() if rng.random() < 0.5 else curve for curve in u]
        v = [curve.reversed() if rng.random() < 0.5 else curve for curve in v]
        made = build.network(u, v).value
        points = grid(made).reshape(-1, 3)
        assert np.abs(points[:, 2] - points[:, 1] ** 2).max() <= 1e-9
        assert points[:, 0].min() == pytest.approx(0, abs=1e-12) and points[:, 0].max() == pytest.approx(2, abs=1e-12)
    assert np.abs(grid(reference)[..., 2] - grid(reference)[..., 1] ** 2).max() <= 1e-9


def test_curves_that_cross_at_other_parameters_are_met_within_the_tolerance():
    rng = np.random.default_rng(6)
    s = np.linspace(0, 2, 9)

    def height(x, y):
        return 0.3 * np.sin(2 * x) * np.cos(1.5 * y)

    def curve(x, y):
        parameters = np.r_[0, np.cumsum(rng.uniform(0.5, 1.5, len(s) - 1))]
        return sc.fit.interpolate(np.stack(np.broadcast_arrays(x, y, height(x, y)), -1), parameters=parameters).value

    along_u = [curve(s, y) for y in (0.0, 0.7, 1.3, 2.0)]
    along_v = [curve(x, s) for x in (0.0, 0.5, 1.2, 2.0)]
    made, error = build.network(along_u, along_v, tolerance=0.02)
    assert error <= 0.02
    for one in along_u + along_v:
        points = one.evaluate(np.linspace(*one.domain, 25))
        assert np.linalg.norm(made.nearest(points).points - points, axis=1).max() <= 0.02


def test_rings_and_ribs_make_a_closed_surface():
    rings = [circle().transformed(np.array([[r, 0, 0, 0], [0, r, 0, 0], [0, 0, 1, z]])) for r, z in ((1, 0), (1.5, 1), (1.2, 2))]
    ribs = []
    for angle in np.linspace(0, 2 * math.pi, 9)[:-1]:
        c, s = math.cos(angle), math.sin(angle)
        ribs.append(sc.fit.interpolate([(c, s, 0), (1.5 * c, 1.5 * s, 1), (1.2 * c, 1.2 * s, 2)], degree=2).value)
    made, error = build.network(rings, ribs, tolerance=1e-4)
    assert made.periodic == (True, False) and error <= 1e-4
    points = grid(made, 33)
    assert np.abs(np.hypot(points[:, 0, 0], points[:, 0, 1]) - 1).max() <= 1e-4


def ring(radius, height):
    return circle().transformed(np.array([[radius, 0, 0, 0], [0, radius, 0, 0], [0, 0, 1, height]]))


@pytest.mark.parametrize("angle", [0.5, 2.0, math.pi])
@pytest.mark.parametrize("heights", [(0, 2), (0, 1, 2), (0, 0.3, 2)])
@pytest.mark.parametrize("is_swapped", [False, True])
def test_two_ribs_are_enough_for_rings(angle, heights, is_swapped):
    rings = [ring(1 + z, z) for z in heights]
    ribs = [line((math.cos(turn), math.sin(turn), 0), (3 * math.cos(turn), 3 * math.sin(turn), 2)) for turn in (0, angle)]
    made, error = build.network(ribs, rings) if is_swapped else build.network(rings, ribs)
    assert made.periodic == (not is_swapped, is_swapped) and error <= 1e-6
    points = grid(made, 33)
    assert np.abs(np.hypot(points[..., 0], points[..., 1]) - 1 - points[..., 2]).max() <= 1e-6


@pytest.mark.parametrize("count", [3, 4, 5, 8])
@pytest.mark.parametrize("degree", [2, 3, 4, 5])
@pytest.mark.parametrize("is_swapped", [False, True])
def test_bent_ribs_across_rings_of_any_degree(count, degree, is_swapped):
    """What ribs add to the loft of the rings is where they are."""
    rings = []
    for height in (0, 2):
        at = 2 * np.pi * np.arange(12) / 12
        rings.append(sc.fit.interpolate(np.c_[np.cos(at), np.sin(at), np.full(12, height)], degree=degree, closed=True).value)
    low, high = rings[0].domain
    places = low + (high - low) * (np.arange(count) + 0.3) / count
    ribs = [sc.BezierCurve([start, 0.5 * (start + end) * (1.6 + 0.2 * k, 1.6 + 0.2 * k, 1), end])
            for k, (start, end) in enumerate(zip(*(one.evaluate(places) for one in rings)))]
    made, error = build.network(ribs, rings) if is_swapped else build.network(rings, ribs)
    assert error <= 1e-6
    for one in rings + ribs:
        points = one.evaluate(np.linspace(*one.domain, 33))
        assert np.linalg.norm(made.nearest(points).points - points, axis=1).max() <= 1e-6


@pytest.mark.parametrize("slant", [1e-3, 0.1, 0.6, -0.5])
def test_two_ribs_may_cross_rings_anywhere(slant):
    ribs = [line((1, 0, 0), (1, 0, 2)), line((math.cos(2), math.sin(2), 0), (math.cos(2 + slant), math.sin(2 + slant), 2))]
    rings = [ring(1, 0), ring(1, 2)]
    made, error = build.network(rings, ribs, tolerance=1e-4)
    assert made.periodic == (True, False) and error <= 1e-4
    for one in rings + ribs:
        points = one.evaluate(np.linspace(*one.domain, 33))
        assert np.linalg.norm(made.nearest(points).points - points, axis=1).max() <= 1e-4


def test_two_closed_curves_across_two_closed_ones():
    torus = build.torus((0, 0, 0), (0, 0, 1), 3.0, 1.0)
    (u0, u1), (v0, v1) = torus.domain
    around = [torus.isocurve("v", v) for v in (v0, v0 + (v1 - v0) / 2)]
    over = [torus.isocurve("u", u) for u in (u0, u0 + (u1 - u0) / 2)]
    with pytest.raises(sc.InvalidShape, match="fewer than four closed curves cross fewer than four closed ones"):
        build.network(around, over)
    for along_u, along_v in ((around, [torus.isocurve("u", u0 + (u1 - u0) * k / 4) for k in range(4)]),
                             ([torus.isocurve("v", v0 + (v1 - v0) * k / 4) for k in range(4)], over)):
        made, error = build.network(along_u, along_v)
        assert made.periodic == (True, True) and error <= 1e-6


def test_far_domains_keep_crossings_apart():
    along_u = [sc.NurbsCurve(1, [1e12, 1e12, 1e12 + 1, 1e12 + 1], [(0, y, 0), (1, y, 0)]) for y in (0, 1)]
    made, error = build.network(along_u, [line((x, 0, 0), (x, 1, 0)) for x in (0, 0.5, 1)])
    assert error <= 1e-4 and np.abs(grid(made)[..., 2]).max() == 0


def test_two_ribs_of_different_shape():
    ribs = [sc.BezierCurve([(x, 0, 0), (y, 0, 1), (x, 0, 2)]) for x, y in ((1, 2), (-1, -1.5))]
    made, error = build.network([ring(1, 0), ring(1, 2)], ribs)
    assert error <= 1e-12
    for rib in ribs:
        points = rib.evaluate(np.linspace(0, 1, 33))
        assert np.linalg.norm(made.nearest(points).points - points, axis=1).max() <= 1e-9
    assert np.hypot(*np.moveaxis(grid(made, 33)[..., :2], -1, 0)).max() <= 1.6


@pytest.mark.parametrize("along_u, along_v, words", [
    ([line((0, 0, 0), (1, 0, 0)), line((0, 1, 0), (1, 1, 0)), line((0, 0, 0), (1, 0, 0))],
     [line((0, 0, 0), (0, 1, 0)), line((1, 0, 0), (1, 1, 0))], r"along_u\[0\] and along_u\[2\] cross along_v\[0\] in one place"),
    ([line((0, 0, 0), (1, 0, 0)), line((0, 1, 0), (1, 1, 0))],
     [line((1, 0, 0), (1, 1, 0)), line((0, 0, 0), (0, 1, 0)), line((0, 1, 0), (0, 0, 0))],
     r"along_v\[1\] and along_v\[2\] cross along_u\[0\] in one place"),
    ([line((0, 0, 0), (0, 0, 0)), line((0, 1, 0), (1, 1, 0))], [line((0, 0, 0), (0, 1, 0)), line((0, 0, 0), (1, 1, 0))],
     r"along_u\[0\] is a point"),
    ([line((0, 0, 0), (1, 0, 0))], [line((0, 0, 0), (0, 1, 0))] * 2, "fewer than two"),
    ([line((0, 0, 0), (1, 0, 0)), line((0, 1, 0.3), (1, 1, 0.3))], [line((0, 0, 0), (0, 1, 0)), line((1, 0, 0), (1, 1, 0))],
     r"along_u\[1\] and along_v\[0\] do not meet: they come to 0.3"),
    ([line((0, 0, 0), (1, 0, 0)), sc.BezierCurve([(-0.5, 1, 0), (0.5, 1.6, 0), (1.5, 0.4, 0), (2, 1, 0)])],
     [line((0, 0, 0), (0, 2, 0)), sc.BezierCurve([(1, 0, 0), (1, 3, 0), (1.6, -1, 0), (1.6, 2, 0)])], "places"),
    ([line((0, 0, 0), (1, 0, 0)), line((0, 1, 0), (1, 1, 0))], [line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (1, 1, 0))], "lie on each other"),
])
def test_what_is_no_network_is_refused_by_name(along_u, along_v, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.network(along_u, along_v)


def test_rings_that_begin_at_their_first_crossing_keep_their_domain():
    """Where they begin again is what it was, to the last digit: no knot is nearly 0."""
    random = np.random.default_rng(20261128)
    for count in (2, 2, 2, 4, 4) * 8:
        heights = np.linspace(0.0, 3.0, 2 + count)
        rings = [sc.conics.ellipse((0, 0, z), (1 + 0.1 * z, 0, 0), (0, 0.6 + 0.1 * z, 0)).to_nurbs() for z in heights]
        angles = np.linspace(0.0, 2 * np.pi, count, endpoint=False) + random.uniform(0.0, 1.0)
        lines = [sc.fit.interpolate(np.array([((1 + 0.1 * z) * np.cos(a), (0.6 + 0.1 * z) * np.sin(a), z) for z in heights]), 1).value
                 for a in angles]
        value = sc.build.network(rings, lines, tolerance=1e-3).value
        assert tuple(value.domain[0]) == tuple(rings[0].domain)
        assert all(abs(knot) > 1e-9 or knot == 0.0 for knots in value.knots for knot in knots)
