"""Points more and less on one curve, as Blender's Edit Mode adds and removes them.

Every edit gives an Edited: the curve, and of each point that its net has then, in order, the control point.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import parameters
from . import knot_steps


class Edited(NamedTuple):
    """A curve, of each point of its net the number of the control point, and how far it lies from what it was."""

    curve: object
    order: np.ndarray
    closed: bool
    error: float = 0.0


class Point(NamedTuple):
    """The point added at an end: where, its weight, and where the handles of a chain stand."""

    position: np.ndarray
    weight: float = 1.0
    before: np.ndarray = None
    after: np.ndarray = None


def started(curve, order, closed):
    """A curve before its edits. A single cubic with handles is a chain of one segment."""
    return Edited(curve, np.asarray(order), closed)


def as_chain(edited):
    """A single cubic as a chain of one segment; a chain as it is."""
    return edited if _is_chain(edited.curve) else edited._replace(curve=edited.curve.to_hermite(), order=np.array([0, 1]))


def appended(edited, point, at_start):
    """One more point beyond an end; the others stay where they are."""
    if at_start:
        edited = edited if _is_chain(edited.curve) else edited._replace(curve=edited.curve.to_nurbs())
        return turned(appended(turned(edited), point._replace(before=point.after, after=point.before), False))
    curve = edited.curve
    longer = _longer_chain(curve, point) if _is_chain(curve) else _longer_polygon(curve.to_nurbs(), point)
    return edited._replace(curve=longer, order=np.append(edited.order, len(curve.points)))


def inserted(edited, place, times):
    """A given number of additional points after the point at a place of the order: the shape stays."""
    curve, order = edited.curve, edited.order
    if _is_chain(curve):
        return edited._replace(curve=_refined_chain(curve, place, times), order=np.arange(len(order) + times))
    _require_finite(curve)
    nurbs = knot_steps.inserted(curve.to_nurbs(), [(int(order[place]), part / (times + 1)) for part in range(1, times + 1)])
    wanted = np.insert(order.astype(float), place + 1, np.full(times, np.nan))
    return edited._replace(curve=nurbs, order=_matched(curve, nurbs, wanted))


def removed(edited, place):
    """Without the point at a place of the order: at an open end the curve ends earlier, elsewhere the shape stays as
    near as a curve with a point less can."""
    curve, order = edited.curve, edited.order
    is_end = not edited.closed and place in (0, len(order) - 1)
    if len(order) <= 2:
        raise Refusal("a curve needs two points")
    if _is_chain(curve):
        if edited.closed and place == 0:
            curve, place = _begun_later(curve), len(order) - 1
        fewer = sc.HermiteCurve(*(np.delete(rows, place, 0) for rows in (curve.points, curve.tangents, curve.parameters)))
        error = 0.0 if is_end else curve.to_nurbs().largest_distance(fewer.to_nurbs())
        return edited._replace(curve=fewer, order=np.arange(len(order) - 1), error=edited.error + error)
    _require_finite(curve)
    if edited.closed and not _is_periodic(curve) and place == 0:
        raise Refusal("the point where this closed curve begins and ends cannot go: open it first (Toggle Cyclic)")
    if is_end and place == 0:
        return turned(removed(turned(edited), len(order) - 1))
    if is_end:
        return edited._replace(curve=_ended_earlier(curve), order=order[:-1])
    found = knot_steps.without_a_knot(curve, knot_steps.averages(curve.to_nurbs())[order[place]])
    wanted = np.delete(order.astype(float), place)
    return edited._replace(curve=found.value, order=_matched(curve, found.value, wanted), error=edited.error + found.error)


def closed(edited):
    """The last point connected with the first; a polygon becomes periodic, with knots evenly spaced."""
    curve = edited.curve
    if _is_chain(curve):
        step = np.diff(curve.parameters).mean()
        whole = sc.HermiteCurve(np.append(curve.points, curve.points[:1], 0), np.append(curve.tangents, curve.tangents[:1], 0),
                                np.append(curve.parameters, curve.parameters[-1] + step))
        return edited._replace(curve=whole, closed=True)
    start, step = _even(curve)
    whole = sc.NurbsCurve(curve.degree, start + step * np.arange(len(curve.points) + 1), curve.points, curve.weights, True)
    return edited._replace(curve=whole, closed=True)


def begun_at(edited, place):
    """A closed curve with its beginning at a place of the order."""
    curve = edited.curve
    if _is_chain(curve):
        for _ in range(place):
            curve = _begun_later(curve)
    elif _is_periodic(curve):
        knots = np.append(curve.knots[place:], curve.knots[1:place + 1] + curve.knots[-1] - curve.knots[0])
        curve = sc.NurbsCurve(curve.degree, knots, np.roll(curve.points, -place, 0), np.roll(curve.weights, -place), True)
    elif place:
        raise Refusal("this closed curve ends where it begins and opens there only (Toggle Cyclic)")
    return edited._replace(curve=curve)


def opened(edited):
    """Not connected any more from the last point to the first."""
    curve = edited.curve
    if _is_chain(curve):
        parted = sc.HermiteCurve(curve.points[:-1], curve.tangents[:-1], curve.parameters[:-1])
    elif _is_periodic(curve):
        start, step = _even(curve)
        degree, points = curve.degree, len(curve.points)
        knots = start + step * np.clip(np.arange(points + degree + 1.0) - degree, 0, points - degree)
        parted = sc.NurbsCurve(degree, knots, curve.points, curve.weights)
    else:
        parted = _ended_earlier(curve)
    return edited._replace(curve=parted, closed=False)


def joined(first, second):
    """Two open curves as one: chains keep their shapes and get a segment between them, polygons the spans by which they
    are apart, as if the second had been appended point by point."""
    if first.closed or second.closed:
        raise Refusal("a closed curve has no end to be connected: open it first (Toggle Cyclic)")
    one, other = first.curve, second.curve
    if _is_chain(one) and _is_chain(other):
        whole = _chained(one, other)
    elif _is_chain(one) or _is_chain(other):
        raise Refusal("a curve with handles and one without are not connected here: use Join Pieces for that")
    elif one.degree != other.degree:
        raise Refusal("curves of degree {degree} and {other_degree} are not connected here: raise the lower degree first",
                      degree=one.degree, other_degree=other.degree)
    else:
        _require_finite(one)
        _require_finite(other)
        whole = _concatenated(one.to_nurbs(), other.to_nurbs())
    return Edited(whole, np.append(first.order, second.order + len(one.points)), False, first.error + second.error)


def turned(edited):
    """The other way round; the parameters change their signs, and so keep their digits."""
    curve = edited.curve
    if _is_chain(curve):
        curve = sc.HermiteCurve(curve.points[::-1], -curve.tangents[::-1, ::-1], 0.0 - curve.parameters[::-1])
    elif isinstance(curve, sc.BezierCurve):
        curve = curve.reversed()
    else:
        curve = sc.NurbsCurve(curve.degree, 0.0 - curve.knots[::-1], curve.points[::-1], curve.weights[::-1])
    return edited._replace(curve=curve, order=len(edited.curve.points) - 1 - edited.order[::-1])


def _even(curve):
    """(where the domain starts, how long its spans are on the average)."""
    start, end = curve.domain
    return start, (end - start) / (len(parameters.inner_knots(curve)) + 1)


def _is_chain(curve):
    return isinstance(curve, sc.HermiteCurve)


def _is_periodic(curve):
    return getattr(curve, 'periodic', False)


def _require_finite(curve):
    if (curve.weights == 0).any():
        raise Refusal("a curve with points at infinity takes and loses points at its ends only: use Insert Knot")


# Polygons ------------------------------------------------------------------------------------------


def _longer_polygon(curve, point):
    """With a span as long as the last."""
    return sc.NurbsCurve(curve.degree, knot_steps.longer(curve.knots, curve.degree),
                         np.vstack([curve.points, _apart(point.position, curve.points[0])]),
                         np.append(curve.weights, point.weight))


def _concatenated(first, second):
    """The points of both, with as many spans between as points are appended to lead from the one to the other."""
    degree, end = first.degree, first.domain[1]
    between = end + (end - first.knots[first.knots < end][-1]) * np.arange(1, degree + 1)
    knots = [first.knots[:-degree], between, between[-1] + (second.knots[degree + 1:] - second.domain[0])]
    points = np.vstack([first.points, _apart(second.points[0], first.points[-1]), second.points[1:]])
    return sc.NurbsCurve(degree, np.concatenate(knots), points, np.append(first.weights, second.weights))


def _apart(position, other):
    """A position that is not that of another point in every bit: ends that meet are one point, here they are two."""
    position = np.asarray(position, dtype=np.float64)
    return np.nextafter(position, np.inf) if np.array_equal(position, other) else position


def _ended_earlier(curve):
    """Without the last control point: what appended() undoes."""
    points, weights = curve.points[:-1], curve.weights[:-1]
    if isinstance(curve, sc.BezierCurve):
        return sc.BezierCurve(points, weights)
    return sc.NurbsCurve(*knot_steps.earlier(curve), points, weights)


def _matched(before, after, wanted):
    """Of each point of the net its control point now; wanted: as of knot_steps.matched()."""
    return knot_steps.matched(before.points, after.points, wanted) if _is_periodic(after) else np.arange(len(wanted))


# Chains with tangents ------------------------------------------------------------------------------


def _longer_chain(curve, point):
    """With a segment as long in parameter as the last."""
    step = curve.parameters[-1] - curve.parameters[-2]
    tangents = np.array([point.position - point.before, point.after - point.position]) * 3.0 / step
    size = np.abs([point.position, point.before, point.after]).max()
    if np.abs(tangents[0] - tangents[1]).max() <= 8 * np.finfo(np.float32).eps * size * 3.0 / step:
        tangents[1] = tangents[0]
    return sc.HermiteCurve(np.vstack([curve.points, _apart(point.position, curve.points[0])]),
                           np.concatenate([curve.tangents, tangents[None]]),
                           np.append(curve.parameters, curve.parameters[-1] + step))


def _chained(first, second):
    """With a segment between as long in parameter as the last of the first."""
    start = 2 * first.parameters[-1] - first.parameters[-2]
    points = np.vstack([first.points, _apart(second.points[0], first.points[-1]), second.points[1:]])
    return sc.HermiteCurve(points, np.concatenate([first.tangents, second.tangents]),
                           np.append(first.parameters, start + (second.parameters - second.parameters[0])))


def _refined_chain(curve, place, times):
    start, end = curve.parameters[place:place + 2]
    new = start + (end - start) * np.arange(1, times + 1) / (times + 1)
    derivatives = np.array([curve.derivatives(u, 1) for u in new]).reshape(times, 2, 3)
    tangents = np.repeat(derivatives[:, 1:], 2, axis=1)
    return sc.HermiteCurve(np.insert(curve.points, place + 1, derivatives[:, 0], 0),
                           np.insert(curve.tangents, place + 1, tangents, 0), np.insert(curve.parameters, place + 1, new))


def _begun_later(curve):
    """A closed chain that begins at its second point."""
    tangents = np.concatenate([curve.tangents[1:], curve.tangents[1:2]])
    tangents[-2, 1] = curve.tangents[0, 1]
    parameters = curve.parameters
    return sc.HermiteCurve(np.concatenate([curve.points[1:], curve.points[1:2]]), tangents,
                           np.append(parameters[1:], parameters[-1] + parameters[1] - parameters[0]))
