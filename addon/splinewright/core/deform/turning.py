"""Lines of exact curves and surfaces that are arcs of circles or ellipses, whatever their NURBS form: those of circles, cylinders,
spheres, tori and all surfaces of revolution."""

import math
from typing import NamedTuple

import numpy as np

from ..base.library import sc

#: Parts of the largest singular value below which one is rounding, and above which it is none.
_ROUNDING, _CLEAR = 1e-9, 1e-6
#: Places in each span at which lines are looked at.
_PLACES = 8


class Turning(NamedTuple):
    """Lines of points with weights that all turn at one rate: line j is rows[0, j] + cos(a) rows[1, j] + sin(a) rows[2, j] at an angle
    a, each of (x, y, z, 1) times a weight."""

    start: float                        # angle
    sweep: float | None                 # above 0; None for a whole turn
    rows: np.ndarray                    # (3, m, 4)

    def at(self, points):
        """(n, m, 4): with points (n, 2) in place of (cos(a), sin(a))."""
        return np.tensordot(np.column_stack([np.ones(len(points)), points]), self.rows, 1)

    @property
    def radius(self):
        """What no half axis of a line is longer than, where all weights are positive, or else as far as was looked."""
        weights = self.rows[0, :, 3]
        axes = self.rows[1:, :, :3]
        if not (weights > 0).all():
            return math.inf
        return float(np.linalg.norm(np.moveaxis(axes / weights[:, None], 0, -1), 2, axis=(1, 2)).max())


def turning(degree, knots, periodic, points):
    """The Turning of lines with these knots and control points (n, m, 4), each times its weight; None where they do not all turn."""
    count, across, _ = points.shape
    middle, size = _frame(points)
    if not size > 0.0:
        return None
    flat = ((points - np.concatenate([middle, [0.0]]) * points[..., 3:]) / ([size] * 3 + [1.0])).reshape(count, -1)
    left, values, right = np.linalg.svd(flat, full_matrices=False)
    if len(values) < 3 or not values[2] > _CLEAR * values[0] or len(values) > 3 and values[3] > _ROUNDING * values[0]:
        return None
    own, parts = left[:, :3], (values[:3, None] * right[:3]).reshape(3, across, 4)
    at = _places(degree, knots, periodic, count)
    track = sc.NurbsCurve(degree, knots, own, periodic=periodic).evaluate(at)
    form, line = _conic(track), _one_line(parts[..., 3])
    if form is None or line is None:
        return None
    into = _onto_circle(form, line)
    return None if into is None else _turned(track @ into.T, np.linalg.inv(into), parts, middle, size)


def _turned(track, back, parts, middle, size):
    """track: (n, 3), of (1, cos, sin) times a weight. back: from these to the rows of parts."""
    if not (track[:, 0] > 0).all() and not (track[:, 0] < 0).all():
        return None
    angles = np.unwrap([math.atan2(y / w, x / w) for w, x, y in track[:, :3]])
    steps = np.diff(angles)
    if (steps > 0).all():
        sign = 1.0
    elif (steps < 0).all():
        sign = -1.0
    else:
        return None
    sweep = abs(angles[-1] - angles[0])
    if sweep > 2 * math.pi + _CLEAR:
        return None
    rows = np.tensordot(back.T, parts, 1)
    rows[2] *= sign
    rows[1:, :, 3] = 0.0                # rounding
    rows = rows * ([size] * 3 + [1.0])
    rows[..., :3] += middle * rows[..., 3:]
    weights = rows[0, :, 3]
    rows = rows / (weights[0] if weights[0] != 0 else np.abs(weights).max())
    if np.ptp(rows[0, :, 3]) <= _ROUNDING:
        rows[0, :, 3] = 1.0
    return Turning(sign * float(angles[0]), None if abs(sweep - 2 * math.pi) <= _CLEAR else float(sweep), rows)


def _frame(points):
    """(middle (3,), size) of finite control points."""
    weights = points[..., 3]
    found = points[..., :3][weights != 0] / weights[weights != 0][:, None]
    if not len(found):
        return np.zeros(3), 0.0
    return found.mean(axis=0), float(np.linalg.norm(np.ptp(found, axis=0)))


def _places(degree, knots, periodic, count):
    breaks = np.unique(knots if periodic else knots[degree:count + 1])
    parts = (np.arange(_PLACES) / _PLACES)[None]
    return np.append((breaks[:-1, None] + np.diff(breaks)[:, None] * parts).ravel(), breaks[-1])


def _conic(track):
    """(3, 3): the symmetric form that is 0 at all of these, None where there is not just one."""
    unit = track / np.linalg.norm(track, axis=1)[:, None]
    x, y, z = unit.T
    _, values, axes = np.linalg.svd(np.stack([x * x, y * y, z * z, x * y, x * z, y * z], 1))
    if len(values) < 6 or values[5] > _ROUNDING * values[0] or not values[4] > _CLEAR * values[0]:
        return None
    a, b, c, d, e, f = axes[5]
    return np.array([[a, d / 2, e / 2], [d / 2, b, f / 2], [e / 2, f / 2, c]])


def _one_line(weights):
    """(3,): what the weights of every line are times a number, None where there is no such."""
    line, values, _ = np.linalg.svd(weights, full_matrices=False)
    return line[:, 0] if values[0] > 0 and (len(values) < 2 or values[1] <= _ROUNDING * values[0]) else None


def _onto_circle(form, line):
    """(3, 3): to (w, w cos, w sin), where w is the line; None unless it is an ellipse that this line leaves whole."""
    _, _, rest = np.linalg.svd(line[None])
    basis = np.vstack([line, rest[1:]])
    back = np.linalg.inv(basis)
    inner = back.T @ form @ back
    if np.trace(inner[1:, 1:]) < 0:
        inner = -inner
    values = np.linalg.eigvalsh(inner[1:, 1:])
    if not values[0] > _ROUNDING * np.abs(inner).max():
        return None
    center = -np.linalg.solve(inner[1:, 1:], inner[1:, 0])
    square = center @ inner[1:, 1:] @ center - inner[0, 0]
    if not square > _ROUNDING * np.abs(inner).max():
        return None
    to_circle = np.linalg.cholesky(inner[1:, 1:]).T / math.sqrt(square)
    return np.vstack([[1.0, 0.0, 0.0], np.column_stack([-to_circle @ center, to_circle])]) @ basis
