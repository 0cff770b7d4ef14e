"""Flat patches in one plane are one up to their borders."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc


def motion(rng):
    found = np.eye(4)
    found[:3, :3] = Rotation.from_quat(rng.normal(size=4)).as_matrix()
    return found


def rectangle(length, width, x, y, angle):
    c, s = np.cos(angle), np.sin(angle)
    corners = np.array([[(0, -width / 2, 0), (0, width / 2, 0)], [(length, -width / 2, 0), (length, width / 2, 0)]])
    return sc.BezierPatch(corners @ [[c, s, 0], [-s, c, 0], [0, 0, 1]] + [x, y, 0]).to_nurbs()


def corners_of(patch):
    return patch.points[[0, 1, 1, 0], [0, 0, 1, 1], :2]


def length_inside(start, end, corners):
    """How much of a segment is in a convex polygon (Cyrus and Beck 1978)."""
    low, high, way = 0.0, 1.0, end - start
    turn = np.sign(np.cross(corners[1] - corners[0], corners[2] - corners[1]))
    for one, two in zip(corners, np.roll(corners, -1, 0)):
        at, slope = turn * np.cross(two - one, start - one), turn * np.cross(two - one, way)
        if slope == 0.0:
            high = high if at >= 0 else -1.0
        elif slope > 0:
            low = max(low, -at / slope)
        else:
            high = min(high, -at / slope)
    return max(0.0, high - low) * np.linalg.norm(way)


def total_length(found):
    return sum(curve.length() for curve in found.curves)


def test_rectangles_in_one_plane(inputs):
    """Of all aspects: the border of what both have in common, however short a part of it is."""
    rng = np.random.default_rng(0)
    for _ in range(inputs(1000)):
        a = rectangle(10**rng.uniform(-0.5, 1.5), 10**rng.uniform(-1, 0.5), 0, 0, 0)
        b = rectangle(10**rng.uniform(-0.5, 1.5), 10**rng.uniform(-1, 0.5), *0.5 * rng.normal(size=2), rng.uniform(0, 6))
        wanted = sum(length_inside(start, end, corners_of(other)) for one, other in ((a, b), (b, a))
                     for start, end in zip(corners_of(one), np.roll(corners_of(one), -1, 0)))
        turned = motion(rng)
        found = a.transformed(turned).sections(b.transformed(turned))
        assert set(found.kinds) <= {"border"} and found.are_one == (wanted > 0)
        assert total_length(found) == pytest.approx(wanted, abs=1e-3 * (1 + wanted))
