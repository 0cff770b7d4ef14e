"""Nearest points on the pieces of a shape, and the curves that they make."""

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import parameters

#: Points between two steps of a progress bar.
PART = 20_000


def feet(pieces, points, told=lambda done: None, cancel=None):
    """((n, 3) nearest points on any of the curves or patches, (n,) distances). told: called with how many are done; cancel: as
    the library takes it."""
    pieces, found, distances = list(pieces), np.empty_like(points), np.empty(len(points))
    for first in range(0, len(points), PART):
        part = slice(first, first + PART)
        nearest = sc.nearest(pieces, points[part], cancel=cancel)
        found[part], distances[part] = nearest.points, nearest.distances
        told(min(first + PART, len(points)))
    return found, distances


#: In each span of a curve so many of its points are brought to the surface at first, and so many in all at most.
_FIRST, _MOST = 16, 40_000
#: There are to be so many of them for each control point: of fewer a curve is made that goes through all.
_FEW = 4
_DEGREE = 3


def curve_on(pieces, curve, tolerance, cancel=None):
    """(a curve of the nearest points of a curve, at equal parameters; the largest distance from them that was found).

    It is fitted to ever more of them, until it is within the tolerance half-way between them, too. cancel: as the library takes
    it. Raises Refusal where that does not come: where nearest points jump.
    """
    curve, steps, best = curve.to_nurbs(), _FIRST, None
    ends = np.concatenate([curve.domain[:1], parameters.inner_knots(curve), curve.domain[1:]])
    error = np.inf
    while steps * len(ends) <= _MOST and not (best and len(best[0].points) * _FEW <= steps * len(ends)):
        at = np.unique(np.concatenate([np.linspace(*span, 2 * steps + 1) for span in zip(ends, ends[1:])]))
        wanted, _ = feet(pieces, curve.evaluate(at), cancel=cancel)
        made = _fitted(at, wanted, curve, tolerance, cancel)
        if made is not None:
            error = float(np.linalg.norm(made.evaluate(at) - wanted, axis=1).max())
            if error <= tolerance and (best is None or len(made.points) < len(best[0].points)):
                best = made, error
        steps *= 2
    if best:
        return best
    nearest = phrase(": the error would be {error}", error=decimals.text_of(error)) if np.isfinite(error) else ""
    raise Refusal("the nearest points jump, or turn too fast for a curve within {tolerance}{nearest}",
                  tolerance=decimals.text_of(tolerance), nearest=nearest)


def _fitted(at, points, curve, tolerance, cancel):
    """A curve near every other one of the points, or None."""
    closed = curve.periodic and np.array_equal(points[0], points[-1])
    rows = points[::2][:-1] if closed else points[::2]
    try:
        return sc.fit.approximate(rows, degree=_DEGREE, parameters=at[::2], tolerance=tolerance / 2, closed=closed,
                                  cancel=cancel).value
    except sc.Cancelled:
        raise
    except sc.Error:
        return None
