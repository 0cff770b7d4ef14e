"""Curves as cubic Bezier segments, for pictures: exactly where they are polynomials up to degree 3, else near them."""

import numpy as np

#: A curve of more spans is drawn as so many times more straight lines.
MORE_LINES = 4
_ROUNDS, _CHECKED = 8, np.array([0.25, 0.5, 0.75])


def finite_points(shape):
    """Control points (n, 3) in rows, nan where they are directions at infinity."""
    points = np.array(shape.points, float)
    weights = getattr(shape, "weights", None)
    if weights is not None:
        points[np.asarray(weights) == 0] = np.nan
    return points.reshape(-1, 3)


def control_polygon(curve):
    """The control points of a curve, and of a closed one the first again."""
    points = finite_points(curve)
    return np.concatenate([points, points[:1]]) if getattr(curve, "periodic", False) else points


def size_of(points):
    """The longest side of the box of points, however large they are."""
    finite = points[np.isfinite(points).all(axis=-1)]
    return float(2 * (finite.max(axis=0) / 2 - finite.min(axis=0) / 2).max()) if len(finite) else 0.0


def reaches_infinity(shape):
    """Whether it may: where no weight is zero or negative it does not."""
    return hasattr(shape, "weights") and shape.is_rational and bool(np.asarray(shape.weights).min() <= 0)


def bounds_of(curve):
    """Parameters between which a curve is one polynomial or quotient of them."""
    start, end = curve.domain
    inner = np.asarray(getattr(curve, "knots", getattr(curve, "parameters", ())), float)
    return np.unique(np.concatenate([[start], inner[(inner > start) & (inner < end)], [end]]))


def cubics(curve, most=4000, nearness=5e-4):
    """Segments (n, 4, 3) along a curve, about `most` at most, off by the nearness times its size."""
    with np.errstate(all="ignore"):
        bounds = bounds_of(curve)
        is_one_rational = not hasattr(curve, "points") and curve.is_rational
        if reaches_infinity(curve) or is_one_rational:
            return _straight(curve, max(2, min(64, most // (len(bounds) - 1))))
        if len(bounds) > most + 1:
            points = curve.evaluate(np.linspace(*curve.domain, MORE_LINES * most + 1))
            return lines(points[:-1], points[1:])
        starts, ends = bounds[:-1], bounds[1:]
        segments = _hermite(curve, starts, ends)
        if curve.degree <= 3 and not getattr(curve, "is_rational", False):
            return segments
        limit = nearness * size_of(segments.reshape(-1, 3))
        for _ in range(_ROUNDS):
            far = _is_far(curve, starts, ends, segments, limit)
            if not far.any() or len(starts) + far.sum() > most:
                break
            bounds = np.sort(np.concatenate([bounds, starts[far] + (ends[far] - starts[far]) / 2]))
            starts, ends = bounds[:-1], bounds[1:]
            segments = _hermite(curve, starts, ends)
        return segments


def _hermite(curve, starts, ends):
    """The segments with the curve's points and derivatives; straight ones where those are too large for a number."""
    lengths = (ends - starts)[:, None]
    first = curve.derivatives(starts, 1, side="right", at_infinity="nan")
    last = curve.derivatives(ends, 1, side="left", at_infinity="nan")
    a, d = first[:, 0], last[:, 0]
    segments = np.stack([a, a + first[:, 1] * lengths / 3, d - last[:, 1] * lengths / 3, d], axis=1)
    return np.where(np.isfinite(segments).all(axis=(1, 2), keepdims=True), segments, lines(a, d))


def lines(a, d):
    """Segments that are straight, between rows of points."""
    return np.stack([a, a / 3 * 2 + d / 3, a / 3 + d / 3 * 2, d], axis=1)


def _is_far(curve, starts, ends, segments, limit):
    places = starts[:, None] + (ends - starts)[:, None] * _CHECKED
    off = np.abs(curve.evaluate(places, at_infinity="nan") - sampled(segments, _CHECKED))
    return off.max(axis=(1, 2)) > limit


def sampled(segments, t):
    """Points (n, m, 3) of segments at m places between 0 and 1."""
    t = np.asarray(t, float)
    functions = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3], axis=1)
    return functions @ segments


def _straight(curve, resolution):
    """Straight segments along what of a curve through infinity is near its control points."""
    points = np.array(curve.points, float) if hasattr(curve, "points") else curve.evaluate(np.linspace(*curve.domain, 9), at_infinity="nan")
    reach = size_of(points) or float(np.nanmax(np.abs(points))) or 1.0
    found = [np.concatenate([line, line[:1]]) if is_closed else line for line, is_closed in curve.polylines(resolution, reach)]
    return np.concatenate([np.empty((0, 4, 3)), *(lines(line[:-1], line[1:]) for line in found)])
