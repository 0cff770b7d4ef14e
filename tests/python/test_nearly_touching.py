"""Surfaces that nearly touch over a wide region cross where closed forms say: copies that are shifted, turned or thicker by
little, waves at all small angles, and a tube that a torus goes through along a common circle."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc
from splinecore import build
from test_sections import check

TUBE = build.cylinder((0, 0, 0), (0, 0, 1), 1, 6)
BALL = build.sphere((0, 0, 0), 1)
RING = build.torus((0, 0, 0), (0, 0, 1), 3, 1)
WAY = np.array([0.3, 0.5, 0.8]) / np.linalg.norm([0.3, 0.5, 0.8])
ANGLES = [1e-1, 1e-2, 1e-3, 1e-4]


def total_length(found):
    return sum(curve.length(tolerance=1e-7) for curve in found.curves)


def wave(rng, count, height):
    x, y = np.meshgrid(*[np.linspace(-1, 1, count)] * 2, indexing="ij")
    knots = np.r_[[0.0] * 4, np.arange(1.0, count - 3), [count - 3.0] * 4]
    return sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, height * rng.normal(size=x.shape)], -1))


def raised(patch, heights):
    return patch.with_points(patch.points + np.stack([0 * heights, 0 * heights, heights], -1))


@pytest.mark.parametrize("angle", ANGLES)
def test_a_ball_and_its_copy_have_a_circle(angle):
    for other, radius in ((1, np.sqrt(1 - angle**2 / 4)), (1 + angle / 2, None)):
        ball = build.sphere(angle * WAY, other)
        found = BALL.sections(ball)
        along = (1 - other**2 + angle**2) / (2 * angle)
        assert found.kinds == ("crossing",) and found.closed.all() and not found.are_one
        assert total_length(found) == pytest.approx(2 * np.pi * (radius or np.sqrt(1 - along**2)), abs=1e-4)
    inside = build.sphere(angle / 2 * WAY, 1 - angle)
    assert not BALL.sections(inside).curves


@pytest.mark.parametrize("angle", ANGLES)
def test_a_ball_touches_a_little_larger_one_in_a_point(angle):
    found = BALL.sections(build.sphere(angle * WAY, 1 - angle), 1e-7)
    assert not found.curves and len(found.points) == 1 and not found.are_one
    assert np.linalg.norm(found.points[0] - WAY) < 2 * np.sqrt(2e-7 / angle)


@pytest.mark.parametrize("angle", ANGLES)
def test_a_tube_and_its_copy_have_two_lines(angle):
    for shift in ((angle, 0), (0.6 * angle, 0.8 * angle)):
        for radius in (1, 1 + angle / 2):
            found = TUBE.sections(build.cylinder((*shift, 1), (0, 0, 1), radius, 6))
            assert found.kinds == ("crossing",) * 2 and not found.are_one
            assert total_length(found) == pytest.approx(10, abs=1e-6)
    found = TUBE.sections(build.cylinder((angle, 0, 0), (0, 0, 1), 1 + angle, 6))
    assert found.kinds == ("touching",) and total_length(found) == pytest.approx(6, abs=1e-5)
    assert not TUBE.sections(build.cylinder((0, 0, 0), (0, 0, 1), 1 + angle, 6)).curves


@pytest.mark.parametrize("angle", ANGLES[1:3])
def test_a_tube_that_is_turned_a_little(angle):
    """About the middle of its axis: two ellipses, nearly a circle and two lines, that cross each other."""
    axis = np.array([np.sin(angle), 0, np.cos(angle)])
    found = TUBE.sections(build.cylinder(np.array([0, 0, 3]) - 4 * axis, axis, 1, 8))
    assert set(found.kinds) == {"crossing"} and not found.are_one
    assert total_length(found) == pytest.approx(12 + 2 * np.pi, abs=1e-3)


@pytest.mark.parametrize("angle", ANGLES)
def test_a_ring_and_its_copy(angle):
    found = RING.sections(build.torus((0, 0, angle), (0, 0, 1), 3, 1))
    assert found.kinds == ("crossing",) * 2 and found.closed.all() and not found.are_one
    assert total_length(found) == pytest.approx(12 * np.pi, abs=1e-3)


@pytest.mark.parametrize("seed", range(3))
def test_waves_at_all_small_angles(seed):
    """Of heights that differ by e f the zeros of f are the section, for each e."""
    rng = np.random.default_rng(seed)
    ground, rise = wave(rng, 8, 0.1), wave(rng, 8, 1).points[..., 2]
    wanted = None
    for angle in ANGLES[:3]:
        other = raised(ground, angle * rise)
        for one, two in ((ground, other), (other, ground)):
            found = one.sections(two, 1e-8)
            assert set(found.kinds) <= {"crossing"} and not found.are_one
            check(one, two, found, 1e-8)
            wanted = wanted or (len(found.curves), total_length(found))
            assert len(found.curves) == wanted[0]
            assert total_length(found) == pytest.approx(wanted[1], rel=0.2 * angle + 1e-3)


def test_a_patch_and_a_copy_moved_by_little(inputs):
    rng = np.random.default_rng(3)
    for _ in range(inputs(60)):
        patch = wave(rng, 6, 10**rng.uniform(-1.5, -0.5))
        angle = 10**rng.uniform(-3, -1)
        little = np.eye(4)
        little[:3, :3] = Rotation.from_rotvec(angle * rng.normal(size=3)).as_matrix()
        little[:3, 3] = 0.2 * angle * rng.normal(size=3)
        motion = np.eye(4)
        motion[:3, :3] = Rotation.from_quat(rng.normal(size=4)).as_matrix()
        copy = patch.transformed(little)
        found = patch.sections(copy, 1e-7)
        length = total_length(found)
        for one, two in ((copy, patch), (patch.transformed(motion), copy.transformed(motion)),
                         (patch.refine("u", [0.7, 1.9]), copy.elevate("v"))):
            other = one.sections(two, 1e-7)
            assert len(other.curves) == len(found.curves) and other.are_one == found.are_one
            assert total_length(other) == pytest.approx(length, abs=1e-4 * max(1, length))


TURNS = [0.0, 0.4, np.nextafter(0.4, 1), 0.4 + 2e-16, 0.4 - 3e-16, 1.1, -2.3]


def torus_through_tube(turn):
    """A torus that touches the tube along the unit circle, and its half whose seam is turned about the ring."""
    spin = np.eye(4)
    spin[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    up = np.array([[0, 0, 1, 4], [0, 1, 0, 0], [-1, 0, 0, 4], [0, 0, 0, 1]])  # a quarter about the axis of the torus
    half = build.revolve(TUBE.transformed(up @ spin).boundary("v_start"), (4, 0, 0), (0, 1, 0), sweep=-np.pi)
    return build.torus((4, 0, 0), (0, 1, 0), 4, 1), half


def require_circle_and_crossings(found, motion=np.eye(4)):
    """It touches the tube along the circle, and goes back through it on both sides, between the two points where both curve
    alike."""
    assert found.kinds == ("crossing", "crossing", "touching")
    assert not found.are_one and not len(found.points)
    assert found.curves[-1].length() == pytest.approx(2 * np.pi, abs=1e-4)
    ends = [motion[:3, :3] @ (0, y, 0) + motion[:3, 3] for y in (1, -1)]
    for curve in found.curves[:-1]:
        assert curve.length() == pytest.approx(9.089, abs=1.5e-3)
        at = curve.evaluate(np.array(curve.domain))
        assert min(np.abs(at - ends).max(), np.abs(at - ends[::-1]).max()) < 1e-3


@pytest.mark.parametrize("turn", TURNS)
def test_a_torus_that_goes_through_a_tube_along_a_common_circle(turn):
    tube = build.cylinder((0, 0, -10), (0, 0, 1), 1, 20)
    for torus in torus_through_tube(turn):
        for found in (tube.sections(torus), torus.sections(tube)):
            require_circle_and_crossings(found)


def test_a_torus_through_a_tube_turned_and_moved(inputs):
    for seed in range(inputs(80)):
        rng = np.random.default_rng(seed)
        motion = np.eye(4)
        motion[:3, :3] = Rotation.from_quat(rng.normal(size=4)).as_matrix()
        motion[:3, 3] = 10 * rng.normal(size=3)
        tube = build.cylinder((0, 0, -10), (0, 0, 1), 1, 20).transformed(motion)
        torus = torus_through_tube(rng.uniform(-np.pi, np.pi))[seed % 2].transformed(motion)
        for found in (tube.sections(torus), torus.sections(tube)):
            require_circle_and_crossings(found, motion)


def wild_bezier(rng, degree):
    x, y = np.meshgrid(*[np.linspace(-1, 1, degree + 1)] * 2, indexing="ij")
    return sc.BezierPatch(np.stack([x, y, rng.normal(size=x.shape)], -1))


def test_high_degrees_are_told_or_refused():
    rng = np.random.default_rng(25)
    one, other = wild_bezier(rng, 20), wild_bezier(rng, 20)
    found, turned = one.sections(other), other.sections(one)
    assert len(found.curves) == len(turned.curves) > 0
    assert total_length(found) == pytest.approx(total_length(turned), rel=1e-4)
    rng = np.random.default_rng(40)
    with pytest.raises(sc.InvalidShape, match="degrees so high"):
        wild_bezier(rng, 40).sections(wild_bezier(rng, 40))


def test_two_patches_through_infinity_together_are_refused():
    x, y = np.meshgrid(*[np.linspace(-1, 1, 4)] * 2, indexing="ij")
    ends = [0.0] * 4 + [1.0] * 4
    rng = np.random.default_rng(0)

    def through_infinity():
        points = np.stack([x, y, 0.5 * rng.normal(size=x.shape)], -1)
        return sc.NurbsPatch((3, 3), (ends, ends), points, np.where(x > 0.5, -1.0, 1.0) * rng.uniform(1, 1.3, x.shape))

    with pytest.raises(sc.InvalidShape, match="weights of both signs"):
        through_infinity().sections(through_infinity())
    for _ in range(4):  # near a sphere there is nothing of what goes to infinity
        patch, ball = through_infinity(), build.sphere((0, 0, 0), 0.8)
        found = patch.sections(ball)
        check(patch, ball, found, 1e-5)
        assert found.closed.all()
