"""Curves that a surface is made through: their order, and which of them run across others."""

from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import AboutInputs

#: Parts of a curve's domain at which it is looked at.
_PARTS = np.linspace(0.0, 1.0, 33)
#: Curves nearer than this part of the size of them all meet.
_MEET = 1e-6


class Point(NamedTuple):
    """An input that is a place alone, as an empty is."""

    place: tuple                        # (x, y, z)


def size_of(curves):
    """The diagonal of the box of the control points."""
    points = np.concatenate([curve.to_nurbs().points for curve in curves])
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def samples(curve):
    """(33, 3): evenly by the parameter."""
    start, end = curve.domain
    return curve.evaluate(start + (end - start) * _PARTS)


def ends(curve):
    """(2, 3): where it starts and ends."""
    return curve.evaluate(np.array(curve.domain))


def is_closed(curve):
    """Whether a NurbsCurve ends where it starts, to a millionth of its size."""
    start, end = ends(curve)
    return curve.periodic or bool(np.linalg.norm(end - start) <= _MEET * size_of([curve]))


def with_new(order, count):
    """Numbers below `count`, then the others of `order` each where it belongs among them, by an order of all.

    Those below stay as they are: where they run as in `order`, or the other way, the new ones lie between them so; else each
    comes behind the one that is before it in `order`.
    """
    ranks = {number: rank for rank, number in enumerate(order)}
    old = list(range(count))
    for sign in (1, -1):
        wanted = sorted(order, key=lambda number: sign * ranks[number])
        if [number for number in wanted if number < count] == old:
            return wanted
    for number in (number for number in order if number >= count):
        before = order[ranks[number] - 1] if ranks[number] else None
        old.insert(old.index(before) + 1 if before is not None else 0, number)
    return old


def in_a_row(curves):
    """The order in which curves, or points (3,), lie one behind the other, as numbers from 0: from one of the two that are farthest apart, the
    first curve if it is one of them, always to the nearest."""
    marks = np.array([_mark(curve) for curve in curves])
    apart = np.linalg.norm(marks[:, None] - marks[None], axis=-1)
    first = min(np.unravel_index(apart.argmax(), apart.shape)) if len(curves) > 1 else 0
    order, left = [int(first)], set(range(len(curves))) - {int(first)}
    while left:
        nearest = min(sorted(left), key=lambda i: apart[order[-1], i])
        order.append(nearest)
        left.remove(nearest)
    return order


def _mark(curve):
    """(4,): the middle of a curve, and how far it lies about that: two circles about one point are two places. A point is one."""
    points = curve[None] if isinstance(curve, np.ndarray) else samples(curve)
    middle = points.mean(axis=0)
    return [*middle, np.linalg.norm(points - middle, axis=1).mean()]


def loop(curves, tolerance):
    """Curves in the order in which they go around, from the first on to the one whose end is nearest to where it ends. Raises
    AboutInputs where they leave a gap that is wider than a tolerance."""
    left, order, gaps = list(range(1, len(curves))), [0], []
    start, at = ends(curves[0])
    while left:
        apart = [np.linalg.norm(ends(curves[i]) - at, axis=1) for i in left]
        nearest = min(range(len(left)), key=lambda i: apart[i].min())
        gaps.append(apart[nearest].min())
        at = ends(curves[left[nearest]])[1 - apart[nearest].argmin()]
        order.append(left.pop(nearest))
    gaps.append(np.linalg.norm(at - start))
    widest = int(np.argmax(gaps))
    if gaps[widest] > tolerance:
        raise AboutInputs("the curves do not close: ends of {} and {} lie {gap} apart, the tolerance is {tolerance}", order[widest],
                          order[(widest + 1) % len(order)], gap=decimals.text_of(gaps[widest], 3), tolerance=decimals.text_of(tolerance, 3))
    return [curves[i] for i in order]


def families(curves, gap, numbers):
    """Two lists of (curve, its number): those of a network, each of which comes within a gap of all of the other family and of none
    separately. numbers: of the curves among the inputs. Raises Refusal."""
    reach = max(gap, _MEET * size_of(curves))
    meets = np.zeros((len(curves), len(curves)), bool)
    for i, j in zip(*np.triu_indices(len(curves), 1)):
        meets[i, j] = meets[j, i] = _meet(curves[i], curves[j], reach)
    family = {0: 0}
    waiting = [0]
    while waiting:
        i = waiting.pop()
        for j in range(len(curves)):
            if meets[i, j] and j not in family:
                family[j] = 1 - family[i]
                waiting.append(j)
    alone = [i for i in range(len(curves)) if i not in family]
    if alone:
        apart, nearest = min((_apart(curves[alone[0]], curves[j]), j) for j in range(len(curves)) if j != alone[0])
        raise AboutInputs("{} meets no other curve: it comes to about {distance} of {}, the gap that is allowed is {gap}",
                          numbers[alone[0]], numbers[nearest], distance=decimals.text_of(apart, 2), gap=decimals.text_of(reach, 2))
    both = next(((i, j) for i in sorted(family) for j in sorted(family) if meets[i, j] and family[i] == family[j]), None)
    if both:
        raise AboutInputs("{} and {} meet each other, and others that both meet: the curves are not two families that run across each "
                          "other", *(numbers[i] for i in both))
    return tuple([(curves[i], numbers[i]) for i in range(len(curves)) if family[i] == wanted] for wanted in (0, 1))


def _apart(a, b):
    """About how near two curves come."""
    return min(float(one.nearest(samples(other)).distances.min()) for one, other in ((a, b), (b, a)))


def _meet(a, b, reach):
    return len(a.intersections(b, tolerance=reach).distances) > 0
