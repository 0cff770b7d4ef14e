"""Perspective images of curves from any side."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

verbs, failures = core("verbs.verbs"), core("base.failures")
POINTS = np.array([(0, 0, 0), (1, 2, 0), (3, 2.5, 0), (4, 0, 0)])
WEIGHTS = np.array([1, 2, 1.5, 1])


def seen(curve, eye, count=30):
    """Where lines from the eye through points of a curve meet z = 0."""
    at = curve.evaluate(np.linspace(*curve.domain, count))
    eye = np.array(eye, float)
    return eye + (at - eye) * (eye[2] / (eye[2] - at[:, 2]))[:, None]


def test_the_homogeneous_curve_seen_from_the_origin_below_the_plane_has_its_own_weights():
    lifted = sc.BezierCurve(np.column_stack([POINTS[:, :2] * WEIGHTS[:, None], WEIGHTS - 1]))
    image = verbs.project((0, 0, -1))(lifted)
    assert image.weights.tolist() == WEIGHTS.tolist() and np.allclose(image.points, POINTS, rtol=0, atol=1e-15)


@pytest.mark.parametrize('eye', [(0, 0, 7), (0, 0, -7), (1, -2, -3), (0.5, 1, 0.5), (1, 2, -1e-3), (-3, 1, 1e4)])
@pytest.mark.parametrize('side', (1, -1))
def test_weights_are_above_0_where_the_curve_lies_on_one_side_of_the_eye(eye, side):
    rng = np.random.default_rng(4)
    for _ in range(20):
        points = rng.uniform(-1, 1, (5, 3))
        points[:, 2] = eye[2] + side * rng.uniform(0.5, 3, 5)
        curve = sc.BezierCurve(points, rng.uniform(0.5, 2, 5))
        image = verbs.project(eye)(curve)
        found, expected = image.evaluate(np.linspace(0, 1, 30)), seen(curve, eye)
        assert (image.weights > 0).all() and np.allclose(found, expected, rtol=1e-11, atol=1e-11 * np.abs(expected).max())


@pytest.mark.parametrize('eye', [(0, 0, 1), (0, 0, -1)])
def test_points_on_both_sides_of_the_eye_keep_both_signs_as_a_part_is_behind_it(eye):
    image = verbs.project(eye)(sc.BezierCurve([(0, 0, 0), (1, 0, 3 * eye[2]), (2, 0, 0)]))
    assert image.weights.tolist() == [1, -2, 1]


def test_an_eye_in_the_plane_is_refused():
    with pytest.raises(failures.Refusal, match="eye"):
        verbs.project((1, 2, 0))(sc.BezierCurve(POINTS))
