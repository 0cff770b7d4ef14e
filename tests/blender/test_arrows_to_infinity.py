"""Arrows to points at infinity, as lines in space: their heads are seen from every side."""

import numpy as np
import pytest

from support import part

line_batches = part('ui.line_batches')
AXES = np.eye(3)
#: Of the length of an arrow: how wide its head is at least, seen from a side.
WIDE = 0.06


def width_seen(lines, along, eye):
    """How wide the head of an arrow is, across it, in a view along `eye`."""
    across = np.cross(eye, along)
    return np.ptp(lines.reshape(-1, 3) @ across / np.linalg.norm(across)) / np.linalg.norm(along)


@pytest.mark.parametrize('along', [*AXES, *-AXES, (1, 1, 0), (0, -1, 1), (1, 2, -3)], ids=str)
def test_the_head_is_seen_in_front_top_and_side_view_and_from_anywhere(along):
    foot, along = np.array([0.3, -1, 2]), 2.5 * np.array(along, float)
    lines = line_batches._arrow(foot, foot + along)
    assert lines.shape == (5, 2, 3) and np.array_equal(lines[0], [foot, foot + along])
    eyes = [*AXES, *np.random.default_rng(6).normal(size=(200, 3))]
    for eye in (eye for eye in eyes if np.linalg.norm(np.cross(eye, along)) > 1e-9):
        assert width_seen(lines, along, eye) >= WIDE


def test_an_arrow_without_length_is_a_point():
    place = np.array([1.0, 2, 3])
    assert (line_batches._arrow(place, place) == place).all()
