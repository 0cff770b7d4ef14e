"""Into how many straight pieces every span of a curve is cut where they are to look smooth."""

from bisect import bisect_left

import numpy as np

#: So many pieces a span has: as few as are enough.
_COUNTS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96)
#: Parts of a piece at which a curve is looked at, where it has not very many.
_PARTS = 8
#: Pieces shorter than this part of the size need not turn by less.
_SHORT = 2e-4
#: Points of one curve.
_MOST = 20_000


def steps(curve, angle=None, tolerance=None):
    """The number of pieces in every span at which a curve turns by no more than an angle on each, and is no farther from them than
    a tolerance; as near to that as 96 come. None where it runs to infinity, so that this cannot be told."""
    curve = curve.to_nurbs()
    if not (np.asarray(curve.weights) > 0.0).all():
        return None
    ends = np.unique(np.clip(curve.knots, *curve.domain))
    counts = [count for count in _COUNTS if count * (len(ends) - 1) <= _MOST] or [1]
    return counts[bisect_left(counts[:-1], True, key=lambda count: _is_enough(curve, ends, count, angle, tolerance))]


def _is_enough(curve, ends, count, angle, tolerance):
    parts = max(2, min(_PARTS, _MOST // (count * (len(ends) - 1))))
    points, ways = _samples(curve, ends, count * parts)
    if angle and not _turns_little(points, ways, parts, angle):
        return False
    return not tolerance or _lies_near(points, parts, tolerance)


def _samples(curve, ends, parts):
    """(points, unit tangents), (spans, parts + 1, 3) each."""
    shares = np.linspace(0.0, 1.0, parts + 1)
    at = ends[:-1, None] + np.diff(ends)[:, None] * shares
    jets = curve.derivatives(at[:, :-1].ravel(), 1).reshape(len(at), parts, 2, 3)
    last = curve.derivatives(at[:, -1], 1, side='left').reshape(len(at), 1, 2, 3)
    jets = np.concatenate([jets, last], axis=1)
    lengths = np.linalg.norm(jets[:, :, 1], axis=-1, keepdims=True)
    return jets[:, :, 0], jets[:, :, 1] / np.where(lengths > 0.0, lengths, np.inf)


def _turns_little(points, ways, parts, angle):
    stands = ~ways.any(axis=-1)
    turns = np.where(stands[:, :-1] | stands[:, 1:], 0.0, np.linalg.norm(np.diff(ways, axis=1), axis=-1))
    turns = turns.reshape(len(ways), -1, parts).sum(axis=-1)
    lengths = np.linalg.norm(np.diff(points[:, ::parts], axis=1), axis=-1)
    size = np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0))
    return bool(((turns <= angle) | (lengths <= _SHORT * size)).all())


def _lies_near(points, parts, tolerance):
    starts = points[:, :-1].reshape(len(points), -1, parts, 3)
    chords = points[:, parts::parts] - points[:, :-1:parts]
    along = starts - starts[:, :, :1]
    lengths = np.einsum('ijk,ijk->ij', chords, chords)[..., None]
    shares = np.einsum('ijlk,ijk->ijl', along, chords) / np.where(lengths > 0.0, lengths, np.inf)
    off = along - np.clip(shares, 0.0, 1.0)[..., None] * chords[:, :, None]
    return bool(np.linalg.norm(off, axis=-1).max() <= tolerance)
