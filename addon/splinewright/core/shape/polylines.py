"""Where the points of the polylines that show a curve lie on it, in parts of its domain."""

from typing import NamedTuple

import numpy as np


class Line(NamedTuple):
    """One polyline."""

    at: np.ndarray                      # (n,) of its points
    end: float                          # where it ends, or closes
    closed: bool


def lines(curve, counts, reach):
    """The Lines of curve.polylines() at some resolution and this reach, from pairs of how many points each has, and
    whether it is closed. Where they cannot be told, or the reach is None, the points are spread evenly."""
    curve = curve.to_nurbs()
    pieces = () if reach is None else _pieces_within(curve, reach)
    found = [_samples(curve, *piece, *line) for piece, line in zip(pieces, counts)]
    if len(pieces) != len(counts) or any(at is None for at in found):
        return _spread(counts)
    start, end = curve.domain
    return [Line((at - start) / (end - start), (last - start) / (end - start), closed)
            for at, (_, last), (_, closed) in zip(found, pieces, counts)]


def _spread(counts):
    """Lines of equal parts of the domain, one after the other."""
    part = 1 / len(counts)
    return [Line((i + np.arange(count) / (count if closed else count - 1)) * part, (i + 1) * part, closed)
            for i, (count, closed) in enumerate(counts)]


def _samples(curve, first, last, count, closed):
    """The parameters of a given number of points, evenly spread over what a piece holds of every span; None where they are not."""
    inner = np.unique(curve.knots)
    ends = np.concatenate([[first], inner[(inner > first) & (inner < last)], [last]])
    spans, steps = len(ends) - 1, count - (0 if closed else 1)
    if steps <= 0 or steps % spans:
        return None
    at = np.interp(np.arange(steps + 1) / (steps // spans), np.arange(spans + 1), ends)
    return at[:count]


def _pieces_within(curve, reach):
    """Where the polylines of a curve begin and end, as splinecore takes them apart."""
    pieces = curve.pieces()
    if (curve.weights > 0).all() or (curve.weights < 0).all():
        return pieces
    arcs, within = _arcs(curve, reach), []
    for start, end in pieces:
        is_open = False
        for first, last in arcs:
            first, last = max(first, start), min(last, end)
            if first < last:
                if is_open and within[-1][1] == first:
                    within[-1] = within[-1][0], last
                else:
                    within.append((first, last))
                is_open = True
    return within


def _arcs(curve, reach):
    """Where the arcs within reach lie; those of a periodic curve may begin in one period and end in the next."""
    arcs = [arc.domain for arc in curve.finite_arcs(reach)]
    if not curve.periodic:
        return arcs
    period = curve.domain[1] - curve.domain[0]
    return sorted([*arcs, *((first - period, last - period) for first, last in arcs)])


def without_repeats(points):
    """(m, 3): points, (n, 3), but for those that are where the one before them is."""
    points = np.asarray(points, dtype=np.float64)
    return points[np.append(True, (np.diff(points, axis=0) != 0.0).any(axis=1))] if len(points) else points
