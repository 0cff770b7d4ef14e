"""Helices, curves on patches, joins within a tolerance, circles that touch three curves, tangents of patches."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import ENDS, random_curve
from random_patches import random_patch
from splinecore import build, conics

SCALES = [1e-150, 1e-6, 1.0, 1e6, 1e150]


def line(*ends):
    return sc.BezierCurve(np.array(ends, float))


def dense(curve, count=2001):
    return curve.evaluate(np.linspace(*curve.domain, count))


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("turns", [4, -2.5, 0.2])
def test_a_helix_about_a_line(turns, scale):
    made = build.helix(line((0, 0, 0), (0, 0, 3 * scale)), 0.5 * scale, turns, start=(1, 0, 0), tolerance=1e-7 * scale)
    points = dense(made) / scale
    angle = 2 * np.pi * turns * points[:, 2] / 3
    assert points[:, :2] == pytest.approx(0.5 * np.c_[np.cos(angle), np.sin(angle)], abs=1e-7)
    assert made.length(tolerance=1e-9) == pytest.approx(scale * np.hypot(3, np.pi * turns), rel=1e-6)
    assert made.continuity(np.mean(made.domain)).c >= 1


@pytest.mark.parametrize("degree", [2, 3, 5, 9])
def test_spirals_about_curves(degree):
    rng = np.random.default_rng(degree)
    for ends in ("clamped", "unclamped"):
        axis = random_curve(rng, degree=degree, ends=ends, spans=3)
        whole = axis.length(tolerance=1e-9)
        tolerance = 1e-5 * whole
        made = build.helix(axis, 0.02 * whole, 5, end_radius=0.05 * whole, phase=0.3, tolerance=tolerance)
        u = np.linspace(*axis.domain, 300)[:-1]
        # By the same parameter, beside the axis at right angles to it.
        out = made.evaluate(u) - axis.evaluate(u)
        share = np.array([axis.length(axis.domain[0], one, tolerance=1e-9) for one in u]) / whole
        assert np.linalg.norm(out, axis=1) == pytest.approx(whole * (0.02 + 0.03 * share), abs=tolerance)
        tangents = axis.derivatives(u, 1)[:, 1]
        tangents /= np.linalg.norm(tangents, axis=1)[:, None]
        assert np.abs((out * tangents).sum(1)).max() <= tolerance


def test_a_helix_far_from_a_small_axis():
    """The tolerance was that of the axis, which rounding of the radius kept from being reached for minutes."""
    rng = np.random.default_rng(5813)
    for _ in range(20):
        points = [2.5e3, -4e2, 0] + 1e-5 * rng.normal(size=(5, 3))
        axis = sc.NurbsCurve(4, [0] * 5 + [1] * 5, points, 10.0**rng.uniform(-3, 3, 5))
        made = build.helix(axis, 2e3, 0.3)
        off = np.linalg.norm(dense(made, 101) - points.mean(0), axis=1)
        assert off == pytest.approx(2e3, rel=2e-6)


SPHERE = build.sphere((0, 0, 0), 1)
IMAGE = sc.BezierCurve([(0.2, 0.3), (1.5, 1.2), (3, 0.8), (3.9, 1.9)])


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("distance", [0.0, 0.25, -0.4])
def test_curves_on_a_sphere(distance, scale):
    sphere = SPHERE.with_points(scale * SPHERE.points)
    for tolerance in (1e-4, 1e-8):
        made = build.curve_on_patch(sphere, IMAGE, distance * scale, tolerance=tolerance * scale)
        assert np.linalg.norm(dense(made) / scale, axis=1) == pytest.approx(1 + distance, abs=tolerance)
    images = IMAGE.evaluate(np.linspace(0, 1, 2001))
    on_patch = SPHERE.evaluate(images[:, 0], images[:, 1]) * (1 + distance)
    assert dense(made) / scale == pytest.approx(on_patch, abs=1e-8)


def test_curves_on_a_patch_go_over_its_seam():
    made = build.curve_on_patch(SPHERE, line((0.5, 1), (9.0, 1.2)))
    assert np.linalg.norm(dense(made), axis=1) == pytest.approx(1, abs=1e-6)
    u = np.linspace(0, 1, 500)
    assert made.evaluate(u) == pytest.approx(SPHERE.evaluate((0.5 + 8.5 * u) % 4, 1 + 0.2 * u), abs=2e-6)


def test_curves_on_patches_of_every_kind():
    rng = np.random.default_rng(3)
    done = 0
    for k in range(40):
        patch = random_patch(rng, positive=True, degree=1 + k % 5)
        ranges = np.array([patch.domain[0], patch.domain[1]])
        image = sc.BezierCurve(ranges[:, 0] + rng.uniform(0.05, 0.95, (4, 2)) * (ranges[:, 1] - ranges[:, 0]))
        size = np.ptp(patch.points.reshape(-1, 3), axis=0).max()
        try:
            made = build.curve_on_patch(patch, image, tolerance=1e-5 * size)
        except sc.InvalidShape as refused:
            assert "tolerance" in str(refused)
            continue
        done += 1
        t = np.linspace(0, 1, 400)
        at = image.evaluate(t)
        away = np.linalg.norm(made.evaluate(t) - patch.evaluate(at[:, 0], at[:, 1]), axis=1)
        assert np.sort(away)[-4] <= 2e-5 * size, k
    assert done > 30


def test_a_crease_is_a_corner_of_the_curve():
    roof = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]), np.array([[(x, y, 1 - abs(x - 1)) for y in (0, 2)] for x in (0, 1, 2)], float))
    made = build.curve_on_patch(roof, line((0, 0), (2, 1)))
    assert made.evaluate(0.5) == pytest.approx((1, 1, 1)) and made.continuity(0.5).g == 0
    beside = build.curve_on_patch(roof, line((0.1, 0), (0.9, 1)), np.sqrt(0.5))
    assert dense(beside, 5)[:, 2] == pytest.approx(dense(beside, 5)[:, 0] + 1)


def test_joined_within_a_tolerance():
    pieces = [line((0, 0), (1, 0)), line((2, 1), (1, 1e-4)), line((5, 0), (6, 0)), line((2, 1), (0, 1e-4))]
    whole, alone = build.join_curves(pieces, 1e-3)
    assert alone.evaluate(0.0) == pytest.approx((5, 0, 0))
    assert np.array_equal(*whole.evaluate(np.array(whole.domain)))
    assert whole.nearest((1, 5e-5, 0)).distances < 1e-12
    assert len(build.join_curves(pieces, 1e-5)) == 3 and len(build.join_curves(pieces, 0)) == 3


@pytest.mark.parametrize("scale", SCALES)
def test_parts_of_curves_are_joined_in_any_order(scale):
    rng = np.random.default_rng(11)
    for ends in ENDS:
        curve = random_curve(rng, degree=3, ends=ends, spans=6)
        curve = curve.with_points(scale * curve.points)
        start, end = curve.domain
        pieces = curve.parts(np.sort(rng.uniform(start, end, 5)))
        mixed = [pieces[i].reversed() if rng.random() < 0.5 else pieces[i] for i in rng.permutation(len(pieces))]
        made = build.join_curves(mixed, 1e-9 * scale)
        assert sum(one.length(tolerance=1e-9) for one in made) == pytest.approx(curve.length(tolerance=1e-9), rel=1e-7)
        assert len(made) <= 2


def test_circles_that_touch_three_lines():
    sides = [line((0, 0), (4, 0)), line((0, 0), (0, 3)), line((4, 0), (0, 3))]
    for scale in SCALES:
        scaled = [side.with_points(scale * side.points) for side in sides]
        arc, center, radius, parameters = build.touching_circle(*scaled, (0.3, 0.3, 0.5))
        assert radius == pytest.approx(scale) and center == pytest.approx((scale, scale, 0))
        assert parameters == pytest.approx((0.25, 1 / 3, 0.6))
        assert arc.evaluate(np.array(arc.domain)) == pytest.approx(scale * np.array([(1, 0, 0), (1.6, 1.8, 0)]))


def test_circles_that_touch_three_curves():
    rng = np.random.default_rng(2)
    found = 0
    for _ in range(100):
        centers = rng.uniform(-5, 5, (3, 2))
        radii = rng.uniform(0.2, 1, 3)
        circles = [conics.circle((*center, 0), radius) for center, radius in zip(centers, radii)]
        middle = centers.mean(0)
        # Where each looks at the middle of all.
        near = [circle.nearest((*middle, 0)).parameters for circle in circles]
        try:
            arc, center, radius, parameters = build.touching_circle(*circles, near)
        except sc.InvalidShape:
            continue
        found += 1
        away = np.linalg.norm(centers - center[:2], axis=1)
        assert np.minimum(abs(away - radius - radii), abs(abs(away - radius) - radii)) == pytest.approx(0, abs=1e-9)
        for circle, u in zip(circles, parameters):
            assert arc.nearest(circle.evaluate(u)).distances < 1e-9
    assert found > 60


def test_tangents_of_patches_are_chosen():
    rng = np.random.default_rng(6)
    done = 0
    for k in range(60):
        patch = random_patch(rng, positive=True, degree=2 + k % 4)
        u, v = (start + 0.37 * (end - start) for start, end in (patch.domain[0], patch.domain[1]))
        by, gain_u, gain_v = rng.normal(size=(3, 3))
        before = patch.derivatives(u, v, 1)
        for tangents in ({"tangent_u_by": gain_u}, {"tangent_v_by": gain_v}, {"tangent_u_by": gain_u, "tangent_v_by": gain_v}):
            try:
                after = patch.dragged(u, v, by, **tangents).derivatives(u, v, 1)
            except sc.InvalidShape as refused:
                assert "too few" in str(refused)
                continue
            done += 1
            size = 1 + np.abs(before).max()
            assert after[0, 0] - before[0, 0] == pytest.approx(by, abs=1e-8 * size)
            if "tangent_u_by" in tangents:
                assert after[1, 0] - before[1, 0] == pytest.approx(gain_u, abs=1e-8 * size)
            if "tangent_v_by" in tangents:
                assert after[0, 1] - before[0, 1] == pytest.approx(gain_v, abs=1e-8 * size)
    assert done > 100


def test_tangents_of_hermite_patches_are_chosen():
    rng = np.random.default_rng(7)
    net = rng.normal(size=(4, 3, 4, 3))
    patch = sc.HermitePatch(*net)
    before = patch.derivatives(0.7, 1.2, 1)
    moved = patch.dragged(0.7, 1.2, (1, 0, 0), (0, 1, 0), (0, 0, 0)).derivatives(0.7, 1.2, 1)
    gained = moved - before
    assert gained[0, 0] == pytest.approx((1, 0, 0)) and gained[1, 0] == pytest.approx((0, 1, 0))
    assert gained[0, 1] == pytest.approx((0, 0, 0), abs=1e-12)


def test_bad_calls_are_refused():
    axis = line((0, 0, 0), (0, 0, 3))
    sides = [line((0, 0), (4, 0)), line((0, 0), (0, 3)), line((4, 0), (0, 3))]
    for call, message in (
        (lambda: build.helix(axis, -1, 2), "0 or more"),
        (lambda: build.helix(axis, 0, 2), "both radii"),
        (lambda: build.helix(axis, 1, 0), "turns"),
        (lambda: build.helix(axis, 1, 1e9), "turns"),
        (lambda: build.helix(axis, 1, 2, phase=np.inf), "phase|finite"),
        (lambda: build.helix(axis, 1, 2, tolerance=0), "tolerance"),
        (lambda: build.helix(axis, 1, 2, start=(0, 0, 1)), "along the tangent|start"),
        (lambda: build.helix(line((1, 1), (1, 1)), 1, 2), "point|length|still"),
        (lambda: build.curve_on_patch(SPHERE, line((0, 1), (1, 9))), "leaves the patch at v"),
        (lambda: build.curve_on_patch(SPHERE, line((0, 1), (1e9, 1))), "too often to be followed"),
        (lambda: build.curve_on_patch(SPHERE, line((0, 1), (1e300, 1))), "too often to be followed"),
        (lambda: build.curve_on_patch(SPHERE, line((0, 0), (1, 0)), 0.5), "no normal"),
        (lambda: build.curve_on_patch(SPHERE, IMAGE, np.nan), "no number|finite"),
        (lambda: build.curve_on_patch(SPHERE, IMAGE, tolerance=-1), "tolerance"),
        (lambda: build.curve_on_patch(axis, IMAGE), "patch is expected"),
        (lambda: build.join_curves([], 1), "no curve"),
        (lambda: build.join_curves([axis], -1), "0 or more"),
        (lambda: build.touching_circle(*sides, (0, 0, 9)), "outside"),
        (lambda: build.touching_circle(*sides, (0.5, 0.5, 0.5), (0, 0, 0)), "normal"),
        (lambda: build.touching_circle(sides[0], sides[0], sides[0], (0.1, 0.5, 0.9)), "on one line"),
    ):
        with pytest.raises((sc.InvalidShape, sc.ToleranceNotReached), match=message):
            call()
