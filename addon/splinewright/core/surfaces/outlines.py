"""Where pieces of a shape can be told from one another: a point in the middle of each, and the lines around it."""

import numpy as np

from ..verbs import patch_curves

#: Parts of the domain that are tried for the middle; where one lies at infinity the next is taken.
_MIDDLES = np.array([0.5, 0.25, 0.75, 0.1, 0.9])
#: Steps in every span of a line.
_STEPS = 12


def middles(pieces):
    """(n, 3): a point in the middle of each curve or patch; nan where there is none."""
    return np.array([_middle(piece) for piece in pieces]).reshape(-1, 3)


def _middle(piece):
    if hasattr(piece, 'isocurve'):
        (start_u, end_u), (start_v, end_v) = piece.domain
        points = piece.evaluate(start_u + _MIDDLES * (end_u - start_u), start_v + _MIDDLES * (end_v - start_v),
                                at_infinity='nan')
    else:
        start, end = piece.domain
        points = piece.evaluate(start + _MIDDLES * (end - start), at_infinity='nan')
    finite = points[np.isfinite(points).all(1)]
    return finite[0] if len(finite) else np.full(3, np.nan)


def outline(piece):
    """Polylines (n, 3): a curve itself; of a patch its sides, and its seam where it is periodic."""
    if not hasattr(piece, 'isocurve'):
        return _lines(piece)
    seams = [piece.isocurve(axis, start) for axis, (start, _), is_periodic in zip(
        'uv', piece.domain, getattr(piece, 'periodic', (False, False))) if is_periodic]
    return sum(map(_lines, seams), []) + sum(sides(piece).values(), [])


def sides(patch):
    """{side: its polylines (n, 3)} of the sides of a patch that are curves."""
    found = {side: patch_curves.side_of(patch, side) for side in patch_curves.SIDES}
    return {side: _lines(curve) for side, (curve, reason) in found.items() if not reason}


def _lines(curve):
    """Of a closed line its first point comes once more."""
    return [np.concatenate([points, points[:1]]) if is_closed else points
            for points, is_closed in curve.polylines(_STEPS)]
