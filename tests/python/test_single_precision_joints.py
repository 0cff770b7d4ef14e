"""What single precision leaves of a smooth joint is shown as smooth, and a corner that is one is not."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

continuity, definitions, joints, seams = core("joints.continuity"), core("shape.definition"), core("joints.joints"), core("joints.seams")


def single(points):
    return np.asarray(points, np.float32).astype(float)


def two_pieces(turn, around):
    """Handles of one length on both sides of a point; the second is turned."""
    point, way = np.array([around, 1.0, 2.0]), np.array([math.cos(0.7), math.sin(0.7), 0.3])
    turned = np.array([math.cos(0.7 + turn), math.sin(0.7 + turn), 0.3])
    before = single([point - 2 * way - [0, 1, 0], point - 1.7 * way, point - 0.3 * way, point])
    after = single([point, point + 0.3 * turned, point + 1.5 * turned, point + 2 * turned])
    return [sc.BezierCurve(before), sc.BezierCurve(after)]


@pytest.mark.parametrize("around", [0.0, 7.0, 30.0])
def test_a_joint_in_single_precision_is_smooth(around):
    curves = two_pieces(0.0, around)
    (joint,) = continuity.surveyed(definitions.from_value(curves), 9).joints
    assert joint.continuity.angle > 1e-9 and joint.continuity.g >= 1 and joint.continuity.c >= 1
    assert curves[0].to_nurbs().continuity_to(curves[1].to_nurbs()).g == 0
    chained = joints.chained(definitions.from_value(curves), 1e-3).definition
    assert len(chained.pieces) == 1 and continuity.surveyed(chained, 9).joints[0].continuity.g >= 1


def test_a_corner_is_a_corner():
    (joint,) = continuity.surveyed(definitions.from_value(two_pieces(2e-3, 0.0)), 9).joints
    assert joint.continuity.g == 0 and joint.continuity.c == 0


@pytest.mark.parametrize("turn, g", [(3e-7, 2), (2e-3, 0)])
def test_a_seam_is_judged_as_a_joint(turn, g):
    flat = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
    bent = [[(1, 0, 0), (1, 1, 0)], [(2, 0, math.tan(turn)), (2, 1, math.tan(turn))]]
    both = sc.PatchSet.from_patches([sc.BezierPatch(flat), sc.BezierPatch(bent)])
    (seam,) = seams.seams_of(definitions.from_value(both), 9)[0]
    assert seam.measured.g == g
