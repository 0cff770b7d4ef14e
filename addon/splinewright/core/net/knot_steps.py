"""Knots more and less, of a curve or of a patch along an axis (core.verbs.patch_verbs.Along): what nets of both need."""

import numpy as np

from ..base.library import sc
from ..shape import parameters


def longer(knots, degree):
    """The knots with a span more at the end, as long as the last."""
    if knots[-1] == knots[-1 - degree]:
        step = knots[-1] - knots[knots < knots[-1]][-1]
        return np.append(knots[:-degree], np.full(degree + 1, knots[-1] + step))
    return np.append(knots, knots[-1] + np.diff(np.unique(knots))[-1])


def earlier(curve):
    """(degree, knots) without the last control point: what longer() undoes; of lower degree where there is one span."""
    knots, degree = curve.knots, curve.degree
    inner = parameters.inner_knots(curve)
    if not len(inner):
        return degree - 1, knots[1:-1]
    if knots[-1] != knots[-1 - degree]:
        return degree, knots[:-1]
    is_simple = (knots == inner[-1]).sum() == 1
    end = inner[-1] if is_simple else knots[-1]
    return degree, np.append(knots[:-degree - 2], np.full(degree + 1, end))


def averages(curve):
    """Of each control point the average of its knots; of periodic curves once around, and the first again."""
    means = sc.basis.KnotVector(curve.degree, curve.knots, curve.periodic).greville
    return np.append(means, means[0] + curve.knots[-1] - curve.knots[0]) if curve.periodic else means


def inserted(curve, steps):
    """With new control points, each at a fraction of the way from one to the next, (first, fraction): the shape stays."""
    at = averages(curve)
    for knot in [at[first] + (at[first + 1] - at[first]) * fraction for first, fraction in steps]:
        curve = curve.insert_knot(_free(curve, knot))
    return curve


def _free(curve, knot):
    """The parameter itself, or where there is a knot already the middle of the span beside it."""
    start, end = curve.domain
    if curve.periodic:
        knot = start + (knot - start) % (end - start)
    ends = np.concatenate([[start], parameters.inner_knots(curve), [end]])
    knot = min(max(knot, start), end)
    nearest = int(np.abs(ends - knot).argmin())
    if abs(ends[nearest] - knot) > 1e-9 * (end - start):
        return float(knot)
    nearest = min(nearest, len(ends) - 2)
    return float(ends[nearest] + (ends[nearest + 1] - ends[nearest]) / 2)


def without_a_knot(curve, place):
    """The result of removing one of the two inner knots that are nearest to a parameter, the one that changes less; of
    lower degree where there is none."""
    inner = parameters.inner_knots(curve)
    if not len(inner):
        return curve.reduce(1)
    start, end = curve.domain
    if curve.periodic:
        place = start + (place - start) % (end - start)
    nearest = inner[np.argsort(np.abs(inner - place), kind='stable')[:2]]
    return min((curve.remove_knot(float(knot), 1) for knot in nearest), key=lambda found: found.error)


def matched(before, after, wanted):
    """Of each point, or row, of a periodic net its control point now, of arrays of those, which may begin elsewhere: as
    many as can are to be where they were.

    wanted: those that they were before, not-a-number for new ones.
    """
    known = np.flatnonzero(np.isfinite(wanted))
    was = before[wanted[known].astype(int)]
    count = len(after)
    far = [np.linalg.norm(after[(known + turn) % count] - was, axis=-1).sum() for turn in range(count)]
    return (np.arange(count) + int(np.argmin(far))) % count
