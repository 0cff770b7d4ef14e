"""The curvature comb of curves: teeth away from the middle of curvature, as long as the curvature is large."""

from typing import NamedTuple

import numpy as np

from .lines import NONE, ends_of, segments


class Comb(NamedTuple):
    """Pairs of ends, (n, 2, 3)."""

    teeth: np.ndarray
    back: np.ndarray                    # the line along the ends of the teeth


def of(curves, density, scale):
    """The Comb of curves with a given number of teeth in every span; one is as long as the curvature times scale.

    At a knot there are two: the curvatures of both spans.
    """
    teeth, back = [NONE], [NONE]
    for curve in curves:
        ends = ends_of(curve)
        for start, end in zip(ends, ends[1:]):
            pairs = _of_span(curve, np.linspace(start, end, density + 1), scale)
            teeth.append(pairs[np.isfinite(pairs).all((1, 2))])
            back.append(segments(pairs[:, 1]))
    return Comb(np.concatenate(teeth), np.concatenate(back))


def _of_span(curve, at, scale):
    """(n, 2, 3): the teeth at parameters of one span; nan where there is no curvature to speak of."""
    derivatives = np.concatenate([curve.derivatives(at[:-1], 2, at_infinity='nan'),
                                  curve.derivatives(at[-1:], 2, side='left', at_infinity='nan')])
    feet, velocity, acceleration = np.moveaxis(derivatives, 1, 0)
    return np.stack([feet, feet - scale * bend(velocity, acceleration)], 1)


def bend(velocity, acceleration):
    """(n, 3): the vectors towards the middles of curvature, as long as the curvature; nan where nothing moves."""
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    with np.errstate(all='ignore'):
        along = velocity / speed
        return (acceleration / speed - along * (along * acceleration / speed).sum(1, keepdims=True)) / speed
