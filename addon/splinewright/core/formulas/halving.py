"""Control polygons halved again and again, which is how de Casteljau's construction draws a curve (S6)."""

import numpy as np

from ..base.failures import Refusal
from . import signs
from .functions import Part

#: Most points of a step.
MOST = 20000
#: Ends that are so near to each other, as a part of the size, are one.
_ONE_END = 1e-9


def halving(curves, ratio, steps, distance):
    """The Parts "step 0", "step 1", …: the polygons of all curves in their Bezier form, divided at a ratio step by step.

    distance: from each step to the next, along x. Raises Refusal for too many points.
    """
    pieces = [_rows(curve) for curve in curves]
    last = sum(len(rows) * rows.shape[1] for rows in pieces) << steps
    if last > MOST:
        raise Refusal("step {steps} has {count} points: {most} are the most", steps=steps, count=last, most=MOST)
    shown = []
    for step in range(steps + 1):
        for rows in pieces:
            beside = rows.copy()
            beside[..., 0] += step * distance * rows[..., 3]
            shown += [Part(f"step {step}", one) for run in _joined(beside) for one in signs.polygon(run)]
        pieces = [_divided(rows, ratio) for rows in pieces]
    return shown


def _rows(curve):
    """(spans, degree + 1, 4)."""
    return np.array([bezier.homogeneous_points for bezier in curve.to_nurbs().to_bezier()])


def _divided(rows, ratio):
    """Each of the Bezier curves as two, by de Casteljau."""
    levels, left, right = rows, [rows[:, 0]], [rows[:, -1]]
    while levels.shape[1] > 1:
        levels = (1.0 - ratio) * levels[:, :-1] + ratio * levels[:, 1:]
        left.append(levels[:, 0])
        right.append(levels[:, -1])
    halves = np.stack([np.stack(left, 1), np.stack(right[::-1], 1)], 1)
    return halves.reshape(-1, *rows.shape[1:])


def _joined(rows):
    """The polygons one after the other as one, as far as each begins where the one before ends."""
    near = _ONE_END * np.abs(rows).max()
    gaps = np.flatnonzero(np.abs(rows[1:, 0] - rows[:-1, -1]).max(axis=1) > near) + 1
    return [np.concatenate([*run[:, :-1], run[-1, -1:]]) for run in np.split(rows, gaps)]
