"""Exact planes, cylinders, cones, spheres and tori; curves revolved, extruded and ruled."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import splinecore as sc
from shapes import circle, closed_cubic, cubic, curves, hermite_chain, inside, nurbs_curves, parabola, size_of
from splinecore import build

CENTER = np.array([0.5, -0.25, 1.0])
AXIS = np.array([2.0, -1.0, 2.0])
UNIT = AXIS / 3


def places(patch, count=25):
    """Points and normals of a grid, ends included, as rows."""
    points, normals = patch.evaluate_grid_with_normals(*(inside(domain, count) for domain in patch.domain))
    return points.reshape(-1, 3), normals.reshape(-1, 3)


def across(points):
    """(height above CENTER, the rest of the way) along AXIS."""
    height = (points - CENTER) @ UNIT
    return height, points - CENTER - height[:, None] * UNIT


def rotation(axis, angle):
    x, y, z = axis
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * skew + (1 - math.cos(angle)) * skew @ skew


@pytest.mark.parametrize("radius", [1.0, 2.5, 1e-6, 1e6])
def test_a_sphere_has_one_radius_and_normals_along_it(radius):
    points, normals = places(build.sphere((0, 0, 0), radius, axis=AXIS))
    assert np.abs(np.linalg.norm(points, axis=1) / radius - 1).max() <= 1e-14
    assert np.abs(normals - points / radius).max() <= 2e-14


def test_a_cylinder_has_one_radius():
    points, normals = places(build.cylinder(CENTER, AXIS, 2.0, 3.0))
    height, out = across(points)
    assert np.abs(np.linalg.norm(out, axis=1) / 2 - 1).max() <= 1e-14
    assert np.abs(normals - out / 2).max() <= 1e-14
    assert (height.min(), height.max()) == pytest.approx((0, 3), abs=1e-14)


@pytest.mark.parametrize("top", [0.0, 0.5, 3.0])
def test_a_cone_narrows_evenly(top):
    points, _ = places(build.cone(CENTER, AXIS, 2.0, 3.0, top_radius=top))
    height, out = across(points)
    assert np.abs(np.linalg.norm(out, axis=1) - (2 + (top - 2) * height / 3)).max() <= 1e-14


def test_a_torus_keeps_its_distance_from_its_ring():
    points, normals = places(build.torus(CENTER, AXIS, 3.0, 1.25))
    _, out = across(points)
    offset = points - CENTER - 3 * out / np.linalg.norm(out, axis=1, keepdims=True)
    assert np.abs(np.linalg.norm(offset, axis=1) / 1.25 - 1).max() <= 1e-14
    assert np.abs(normals - offset / 1.25).max() <= 2e-14


def test_a_disc_is_flat_and_fills_the_rim_of_a_cylinder():
    disc = build.disc(CENTER, AXIS, 2.0)
    points, normals = places(disc)
    height, out = across(points)
    assert np.abs(height).max() <= 1e-15 and np.linalg.norm(out, axis=1).max() <= 2 + 1e-14
    assert np.abs(normals - UNIT).max() <= 1e-14
    mantle = build.cylinder(CENTER, AXIS, 2.0, 3.0)
    assert (mantle.points[:, 0] == disc.points[:, 0]).all()
    assert sc.PatchSet.from_patches([mantle, disc]).edge_counts()["shared"] == 3, "the rim and a seam of each"


def test_a_plane_is_a_parallelogram():
    patch = build.plane((1, 2, 3), (2, 0, 0), (1, 1, 0))
    assert patch.degree == (1, 1)
    assert (patch.evaluate([0, 1, 1, 0.5], [0, 0, 1, 0.25]) == [(1, 2, 3), (3, 2, 3), (4, 3, 3), (2.25, 2.25, 3)]).all()


def makers():
    return [lambda **turn: build.cylinder((0, 0, 0), (0, 0, 1), 2, 1, **turn),
            lambda **turn: build.cone((0, 0, 0), (0, 0, 1), 2, 1, **turn),
            lambda **turn: build.disc((0, 0, 0), (0, 0, 1), 2, **turn),
            lambda **turn: build.sphere((0, 0, 0), 2, **turn),
            lambda **turn: build.torus((0, 0, 0), (0, 0, 1), 2, 1, **turn),
            lambda **turn: build.revolve(sc.BezierCurve([(1, 0, 0), (1, 0, 2)]), (0, 0, 0), (0, 0, 1), **turn)]


@pytest.mark.parametrize("make", makers())
def test_a_turn_begins_at_its_start_and_runs_as_far_as_its_sweep(make):
    for sweep in (0.4, 2.0, -1.25):
        patch = make(start=0.3, sweep=sweep)
        assert not patch.periodic[0]
        ends = patch.evaluate(patch.domain[0], 0.5)
        assert np.arctan2(ends[:, 1], ends[:, 0]) == pytest.approx([0.3, 0.3 + sweep], abs=1e-15)
    whole = make()
    assert whole.periodic[0] and whole.points.shape[0] == 8 and whole.domain[0] == (0, 4)
    assert make(sweep=2 * math.pi) == whole


@pytest.mark.parametrize("make", makers())
def test_a_clockwise_turn_has_its_normals_on_the_other_side(make):
    there = make(sweep=1.0)
    back = make(start=1.0, sweep=-1.0)
    points, normals = places(there, 5)
    others, opposite = (rows.reshape(5, 5, 3)[::-1].reshape(-1, 3) for rows in places(back, 5))
    assert np.abs(points - others).max() <= 4e-15 and np.abs(normals + opposite).max() <= 1e-13


def test_poles_are_equal_points():
    sphere = build.sphere(CENTER, 0.7, AXIS)
    assert sc.PatchSet.from_patches([sphere]).edge_counts() == {"shared": 1, "free": 0, "pole": 2}
    for j in (0, -1):
        assert (sphere.points[:, j] == sphere.points[0, j]).all()


@settings(max_examples=60)
@given(nurbs_curves(), st.floats(-6, 6), st.floats(0.05, 6.2), st.integers(0, 2**32))
def test_revolving_turns_every_point(curve, start, sweep, seed):
    rng = np.random.default_rng(seed)
    point, axis = rng.uniform(-5, 5, 3), rng.normal(size=3)
    axis /= np.linalg.norm(axis)
    patch = build.revolve(curve, point, 7 * axis, start, sweep)
    ring = sc.conics.arc((0, 0), (1, 0), (0, 1), start, sweep)
    u, v = inside(patch.domain[0], 5), inside(patch.domain[1], 5)
    x, y, _ = ring.evaluate(u).T
    profile = curve.evaluate(v) - point
    expected = np.array([profile @ rotation(axis, angle).T for angle in np.arctan2(y, x)]) + point
    assert np.abs(patch.evaluate_grid(u, v) - expected).max() <= 2e-13 * (size_of(curve) + 5)


def test_every_kind_of_curve_can_be_revolved_extruded_and_ruled():
    for curve in curves():
        v = inside(curve.domain, 9)
        ball = build.revolve(curve, (50, 0, 0), (0, 1, 1))
        assert ball.domain[1] == curve.domain and ball.periodic == (True, curve.to_nurbs().periodic)
        assert np.abs(ball.evaluate(0.0, v) - curve.evaluate(v)).max() <= 1e-13
        wall = build.extrude(curve, (1, 2, 3))
        assert np.abs(wall.evaluate(v, 0.5) - curve.evaluate(v) - (0.5, 1, 1.5)).max() <= 4e-15
        assert np.abs(build.ruled(curve, curve).evaluate(v, 0.5) - curve.evaluate(v)).max() <= 1e-14


def test_profiles_upwards_and_curves_counterclockwise_have_their_normals_outside():
    wall = build.extrude(circle(), (0, 0, 2))
    points, normals = places(wall)
    assert np.abs(normals[:, :2] - points[:, :2]).max() <= 1e-14
    lathe = build.revolve(sc.BezierCurve([(1, 0, 0), (3, 0, 1), (1, 0, 2)]), (0, 0, 0), (0, 0, 1))
    points, normals = places(lathe)
    assert ((normals[:, :2] * points[:, :2]).sum(axis=1) > 0).all()


def homogeneous(curve, u):
    """(X, Y, Z, W) by the basis functions."""
    form = curve.to_nurbs().unrolled()
    return np.array([form.knot_vector.functions(at) for at in u]) @ form.homogeneous_points


def test_ruled_surfaces_run_straight_from_curve_to_curve():
    for a in (circle(), cubic(), hermite_chain(), closed_cubic(), parabola()):
        for b in (cubic(), circle(), closed_cubic(), sc.BezierCurve([(0, 0, 5), (1, 1, 5)])):
            patch = build.ruled(a, b)
            u, v = inside(patch.domain[0], 9), np.array([0, 0.25, 1])
            assert patch.domain[0] == a.domain
            start, end = b.domain
            at_b = start + (u - a.domain[0]) / (a.domain[1] - a.domain[0]) * (end - start)
            at_b = np.clip(at_b, start, end)
            mixed = (1 - v[:, None]) * homogeneous(a, u)[:, None] + v[:, None] * homogeneous(b, at_b)[:, None]
            assert np.abs(patch.evaluate_grid(u, v) - mixed[..., :3] / mixed[..., 3:]).max() <= 1e-13


def test_ruled_surfaces_of_closed_curves_are_closed():
    other = sc.NurbsCurve(2, [0, 1, 4, 6], [(0, 0, 1), (1, 0, 1), (0, 1, 1)], periodic=True)
    patch = build.ruled(closed_cubic(), other)
    assert patch.periodic == (True, False) and patch.degree == (3, 1)
    assert build.ruled(closed_cubic(), circle()).periodic == (False, False)


LINE = sc.BezierCurve([(0, 0, 0), (0, 0, 1)])
NAN = float("nan")


@pytest.mark.parametrize("call, message", [
    (lambda: build.sphere((0, 0, 0), -1), "radius = -1 is not a positive length"),
    (lambda: build.sphere((0, 0, 0), NAN), "radius"),
    (lambda: build.sphere((0, NAN, 0), 1), "center[1] = nan is not finite"),
    (lambda: build.sphere((0, 0), 1, axis=(0, 0)), "axis has no direction"),
    (lambda: build.sphere((0, 0, 0, 0), 1), "center has shape (4,)"),
    (lambda: build.cylinder((0, 0, 0), (0, 0, 1), 1, 0), "height = 0 is not a positive length"),
    (lambda: build.cylinder((0, 0, 0), (0, 0, 1), 1, 1, sweep=0), "sweep = 0 is zero or more than a whole turn"),
    (lambda: build.cylinder((0, 0, 0), (0, 0, 1), 1, 1, sweep=6.5), "sweep = 6.5 is zero or more than a whole turn"),
    (lambda: build.cylinder((0, 0, 0), (0, 0, 1), 1, 1, start=math.inf), "start"),
    (lambda: build.cone((0, 0, 0), (0, 0, 1), 0, 1), "both 0"),
    (lambda: build.cone((0, 0, 0), (0, 0, 1), 1, 1, top_radius=-1), "top_radius = -1 is not a length"),
    (lambda: build.torus((0, 0, 0), (0, 0, 1), 1, 0), "tube_radius = 0 is not a positive length"),
    (lambda: build.torus((0, 0, 0), (0, 0, 1), 1e308, 1e308), "is not finite"),
    (lambda: build.disc((0, 0, 0), (0, 0, 0), 1), "axis has no direction: its length is 0"),
    (lambda: build.plane((0, 0, 0), (1, 0, 0), (2, 0, 0)), "axis_b is parallel to axis_a"),
    (lambda: build.extrude(LINE, (0, 0, 0)), "vector has no direction"),
    (lambda: build.revolve(LINE, (0, 0, 5), (0, 0, 1)), "the curve lies on the axis"),
    (lambda: build.revolve(LINE, (1, 0, 5), (0, 0, NAN)), "axis_direction[2] = nan is not finite"),
    (lambda: build.revolve(LINE, (1, 0, 5), (0, 0, 0)), "axis_direction has no direction"),
])
def test_wrong_numbers_are_refused_with_a_sentence(call, message):
    with pytest.raises(sc.InvalidShape) as refused:
        call()
    assert message in str(refused.value)


def test_what_is_no_curve_is_refused():
    for call in (lambda: build.revolve(3, (0, 0, 0), (0, 0, 1)), lambda: build.extrude("curve", (0, 0, 1)),
                 lambda: build.ruled(LINE, None)):
        with pytest.raises(sc.InvalidShape, match="a curve is expected"):
            call()


def test_a_profile_that_was_moved_to_the_axis_and_back_ends_in_a_pole():
    profile = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0.1), (1, 0, 0.1), (1, 0, 1)])
    rng = np.random.default_rng(8)
    for _ in range(200):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        place = rng.uniform(-3, 3, 3)
        there = profile.points @ turn.T + place
        back = sc.NurbsCurve(2, profile.knots, (there - place) @ turn)
        assert sc.PatchSet.from_patches([build.revolve(back, (0, 0, 0), (0, 0, 1))]).edge_counts()["pole"] == 1
