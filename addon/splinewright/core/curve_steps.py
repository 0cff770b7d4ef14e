"""Into how many straight pieces every span of a curve is cut where they are to look smooth."""

import numpy as np

#: So many pieces a span has; the first that are enough are taken.
_COUNTS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96)
#: Parts of a span at which a curve is looked at: a multiple of every count.
_PARTS = 192
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
    points, ways = _samples(curve, ends)
    size = float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))
    is_enough = [test for wanted, test in ((angle, lambda count: _turns_little(points, ways, count, angle, _SHORT * size)),
                                           (tolerance, lambda count: _lies_near(points, count, tolerance))) if wanted]
    return next((count for count in counts if all(test(count) for test in is_enough)), counts[-1])


def _samples(curve, ends):
    """(points, unit tangents), (spans, parts + 1, 3) each."""
    shares = np.linspace(0.0, 1.0, _PARTS + 1)
    at = ends[:-1, None] + np.diff(ends)[:, None] * shares
    jets = curve.derivatives(at[:, :-1].ravel(), 1).reshape(len(at), _PARTS, 2, 3)
    last = curve.derivatives(at[:, -1], 1, side='left').reshape(len(at), 1, 2, 3)
    jets = np.concatenate([jets, last], axis=1)
    lengths = np.linalg.norm(jets[:, :, 1], axis=-1, keepdims=True)
    return jets[:, :, 0], jets[:, :, 1] / np.where(lengths > 0.0, lengths, np.inf)


def _turns_little(points, ways, count, angle, short):
    stands = ~ways.any(axis=-1)
    parts = np.where(stands[:, :-1] | stands[:, 1:], 0.0, np.linalg.norm(np.diff(ways, axis=1), axis=-1))
    turns = parts.reshape(len(ways), count, -1).sum(axis=-1)
    every = _PARTS // count
    lengths = np.linalg.norm(np.diff(points[:, ::every], axis=1), axis=-1)
    return bool(((turns <= angle) | (lengths <= short)).all())


def _lies_near(points, count, tolerance):
    every = _PARTS // count
    starts = points[:, :-1].reshape(len(points), count, every, 3)
    chords = points[:, every::every] - points[:, :-1:every]
    along = starts - starts[:, :, :1]
    lengths = np.einsum('ijk,ijk->ij', chords, chords)[..., None]
    shares = np.einsum('ijlk,ijk->ijl', along, chords) / np.where(lengths > 0.0, lengths, np.inf)
    off = along - np.clip(shares, 0.0, 1.0)[..., None] * chords[:, :, None]
    return bool(np.linalg.norm(off, axis=-1).max() <= tolerance)
