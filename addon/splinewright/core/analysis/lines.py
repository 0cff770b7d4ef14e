"""Lines on curves and patches: the curve itself, knots, isocurves."""

import numpy as np

from ..shape import parameters
from ..verbs.patch_verbs import Along

#: No pairs of ends.
NONE = np.empty((0, 2, 3))
#: Steps in every span of a curve, at least.
_STEPS = 32
#: Steps in every span of a line on a patch, and in all spans together.
_PATCH_STEPS, _MOST_STEPS = 16, 4000


def curves(curves, resolution, reach, around):
    """(n, 2, 3): the curves, no coarser than with a given number of steps in every span; reach and around as of
    splinecore.NurbsCurve.polylines()."""
    lines = [line for curve in curves for line in curve.polylines(max(resolution, _STEPS), reach, around)]
    return _joined([segments(np.append(points, points[:1], 0) if closed else points) for points, closed in lines])


def knots_of_curves(curves):
    """(n, 3): the points of curves at their knots, the ends among them."""
    return _finite(np.concatenate([curve.evaluate(ends_of(curve), at_infinity='nan') for curve in curves]))


def knots_of_patches(patches):
    """(n, 2, 3): the lines on patches at their knots, the sides among them."""
    return _on_patches(patches, ends_of)


def isocurves(patches, count):
    """(n, 2, 3): a given number of lines in every span of patches, evenly spread, each way."""
    return _on_patches(patches, lambda along: _between(ends_of(along), count + 1)[0])


def normals(patches, count, length):
    """(n, 2, 3): normals of patches of a length, a given number in every span each way, and at its ends."""
    found = []
    for patch in patches:
        at = [np.unique(np.concatenate(_between(ends_of(Along(patch, axis)), count))) for axis in 'uv']
        feet, along = patch.evaluate_grid_with_normals(*at, at_infinity='nan')
        pairs = np.stack([feet, feet + length * along], -2).reshape(-1, 2, 3)
        found.append(_whole(pairs))
    return _joined(found)


def segments(points):
    """(n - 1, 2, 3): the pieces of a polyline (n, 3) that are finite and no points."""
    return _whole(np.stack([points[:-1], points[1:]], -2).reshape(-1, 2, 3))


def ends_of(curve):
    """The parameters where the spans of a curve begin and end."""
    start, end = curve.domain
    return np.concatenate([[start], parameters.inner_knots(curve), [end]])


def _on_patches(patches, at):
    """The lines at some parameters of patches; at: of a patch along an axis."""
    found = []
    for patch in patches:
        along_u, along_v = Along(patch, 'u'), Along(patch, 'v')
        for fixed, ways, is_swapped in ((along_u, along_v, False), (along_v, along_u, True)):
            ends = ends_of(ways)
            steps = min(_PATCH_STEPS, max(1, _MOST_STEPS // (len(ends) - 1)))
            inner, knots = _between(ends, steps)
            both = (at(fixed), np.sort(np.append(inner, knots)))
            points = patch.evaluate_grid(*(both[::-1] if is_swapped else both), at_infinity='nan')
            points = points.swapaxes(0, 1) if is_swapped else points
            found.append(_whole(np.stack([points[:, :-1], points[:, 1:]], -2).reshape(-1, 2, 3)))
    return _joined(found)


def _between(ends, parts):
    """(the parameters that divide every span into a given number of parts, the ends of spans)."""
    fractions = np.arange(1, parts) / parts
    return (ends[:-1, None] + fractions * np.diff(ends)[:, None]).ravel(), ends


def _whole(pairs):
    """Those that are finite and no points."""
    return pairs[np.isfinite(pairs).all((1, 2)) & (pairs[:, 0] != pairs[:, 1]).any(1)]


def _finite(points):
    return points[np.isfinite(points).all(1)]


def _joined(parts):
    return np.concatenate([NONE, *parts])
