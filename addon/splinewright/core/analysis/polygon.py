"""The control polygon of curves, the control net of patches, as lines."""

from typing import NamedTuple

import numpy as np

from ..net import curve_net, patch_net
from .lines import NONE


class Polygon(NamedTuple):
    """Lines are pairs of ends, (n, 2, 3)."""

    points: np.ndarray                  # (n, 3): control points, and heads of handles
    rows: tuple                         # the lines along u, and those along v; of curves all are the first
    arrows: tuple                       # pairs of foot and head: directions at infinity


def of(definition):
    """The Polygon of a definition."""
    net = (curve_net if definition.has_curves else patch_net).make(definition)
    rows = (_along_splines(net), ()) if definition.has_curves else net.lines
    heads = [head for _, head in net.arrows]
    is_seen = net.rows >= 0
    is_seen[heads] = False
    at = net.positions
    return Polygon(at[is_seen], tuple(at[pairs] if len(pairs) else NONE for pairs in map(np.asarray, rows)),
                   tuple((at[foot], at[head]) for foot, head in net.arrows))


def _along_splines(net):
    """Pairs of vertices: of a polygon those beside each other; of Bezier points each with its handles, and handles that
    are control points themselves with each other."""
    pairs, first = [np.empty((0, 2), int)], 0
    arrows = {head for _, head in net.arrows}
    for spline in net.splines:
        is_bezier = spline.kind == 'BEZIER'
        last = first + spline.count * (3 if is_bezier else 1)
        before = np.arange(first, last - 1)
        found = np.stack([before, before + 1], -1)
        if is_bezier:
            are_handles = (before - first) % 3 == 2
            found = found[(net.rows[found] >= 0).all(1) & (~are_handles | net.are_points[found].all(1))]
        elif spline.closed:
            found = np.append(found, [(last - 1, first)], 0)
        if last - 1 not in arrows:
            pairs.append(found)
        first = last
    return np.concatenate(pairs)
