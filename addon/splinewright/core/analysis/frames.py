"""Curves at one place: the osculating circle and the frame there; and their hodographs."""

from typing import NamedTuple

import numpy as np

from .combs import bend
from .lines import NONE, ends_of, segments

#: Steps around a circle, and in every span of a hodograph.
_STEPS = 128, 32


class Frame(NamedTuple):
    """What there is of it; where a curve is straight it has a tangent only."""

    axes: tuple                         # tangent, normal, binormal: pairs of ends, (n, 2, 3), of n curves or fewer
    circles: np.ndarray                 # (m, 2, 3)


def frames(curves, part, length):
    """The Frame of curves where a part of their domain lies behind, with axes of a length."""
    axes, circles = [[NONE], [NONE], [NONE]], [NONE]
    for curve in curves:
        start, end = curve.domain
        at = start + part * (end - start)
        (point, velocity, acceleration), = curve.derivatives([at], 2, at_infinity='nan')
        with np.errstate(all='ignore'):
            tangent = velocity / np.linalg.norm(velocity)
            inward = bend(velocity[None], acceleration[None])[0]
            curvature = np.linalg.norm(inward)
            normal = inward / curvature
        for found, axis in zip(axes, (tangent, normal, np.cross(tangent, normal))):
            if np.isfinite(axis).all() and np.isfinite(point).all():
                found.append(np.stack([point, point + length * axis])[None])
        if np.isfinite(normal).all() and np.isfinite(point).all():
            circles.append(_circle(point, tangent, normal, 1.0 / curvature))
    return Frame(tuple(map(np.concatenate, axes)), np.concatenate(circles))


def _circle(point, tangent, normal, radius):
    turn = np.linspace(0.0, 2.0 * np.pi, _STEPS[0] + 1)[:, None]
    return segments(point + radius * (np.sin(turn) * tangent + (1.0 - np.cos(turn)) * normal))


class Hodograph(NamedTuple):
    """The first derivatives as points: lines (n, 2, 3), and arrows from the origin."""

    lines: np.ndarray
    arrows: tuple


def hodographs(curves, part, scale):
    """The Hodograph of curves times scale; an arrow leads to where a part of their domain lies behind."""
    lines, arrows = [NONE], []
    for curve in curves:
        ends = ends_of(curve)
        for start, end in zip(ends, ends[1:]):
            at = np.linspace(start, end, _STEPS[1] + 1)
            points = np.concatenate([_velocity(curve, at[:-1]), _velocity(curve, at[-1:], 'left')])
            lines.append(segments(scale * points))
        head = scale * _velocity(curve, [ends[0] + part * (ends[-1] - ends[0])])[0]
        if np.isfinite(head).all() and head.any():
            arrows.append((np.zeros(3), head))
    return Hodograph(np.concatenate(lines), tuple(arrows))


def _velocity(curve, at, side='right'):
    return curve.derivatives(at, 1, side=side, at_infinity='nan')[:, 1]
