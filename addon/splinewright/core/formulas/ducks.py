"""The draftsman's spline: a strip that weights, called ducks, hold at points (S5, 001.36 to 38).

Between ducks it bends as little as it can: the natural cubic spline. Outside of them it is straight.
"""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import signs
from .functions import Part, line

STRIP, END = "strip", "end"
#: A part of the energy within which it is found; times the size, an energy that is none; most intervals of one.
_WITHIN, _STRAIGHT, _MOST = 1e-9, 1e-15, 20_000
#: Parts of the largest speed: below the first a curve stops, below the other one it is slow.
_STOPS, _SLOW = 1e-12, 0.2


def strip(points, spacing):
    """The natural cubic spline through points (n, 3). Raises Refusal for fewer than two, or an error of the library."""
    if len(points) < 2:
        raise Refusal("a strip is held by two ducks or more")
    if len(points) == 2 and np.array_equal(*points):
        raise Refusal("both ducks are at one place")
    if len(points) == 2:
        return sc.NurbsCurve(1, [0.0, 0.0, 1.0, 1.0], points).elevate(2)
    return sc.fit.interpolate(points, 3, spacing, ends='natural')[0]


def energy(curve):
    """The integral of the squared curvature over the length of a polynomial curve: what it takes to bend a strip so, with stiffness 1.

    Infinite where the curve stops or turns back; NaN where rounding hides it.
    """
    size, (start, end) = np.ptp(curve.points, axis=0).max(), curve.domain
    if not size > 0.0:
        return np.inf
    unit = (size, end - start)
    knots = np.unique(curve.knots)
    knots = knots[(knots >= start) & (knots <= end)]
    graded = [_graded(curve, *span, unit) for span in zip(knots, knots[1:])]
    if None in graded:
        return np.inf
    places = [np.array(each) for each in graded]
    within = max(_WITHIN, 1e3 * np.finfo(float).eps * np.abs(curve.points).max() / size)
    return _sum(curve, np.concatenate([each[:-1] for each in places]), np.concatenate([each[1:] for each in places]), unit, within) / size


def _sum(curve, starts, ends, unit, within):
    """Of the rule over intervals, halved until two rules agree."""
    total, whole = 0.0, _rule(curve, starts, ends, unit)
    while len(starts) <= _MOST:
        middles = (starts + ends) / 2.0
        halves = np.stack([_rule(curve, starts, middles, unit), _rule(curve, middles, ends, unit)])
        sums = halves.sum(axis=0)
        is_found = np.abs(sums - whole) <= max(within * (total + sums.sum()), _STRAIGHT)
        total += sums[is_found].sum()
        if is_found.all():
            return total
        left = ~is_found
        starts, ends = np.concatenate([starts[left], middles[left]]), np.concatenate([middles[left], ends[left]])
        whole = halves[:, left].ravel()
        if not (np.isfinite(whole).all() and (starts < ends).all()):
            break
    return np.nan


def _graded(curve, start, end, unit):
    """Parameters between two knots, ever denser where a cubic is slow, for it bends there; None where it stops."""
    middle, half = (start + end) / 2.0, (end - start) / 2.0
    first, second, third = _derivatives(curve, np.array([middle]), 3, unit)[0] * (half / unit[1]) ** np.arange(3)[:, None]
    third = third / 2.0
    slowest = np.roots([2.0 * third @ third, 3.0 * second @ third, second @ second + 2.0 * first @ third, first @ second]).real
    slowest = np.append(slowest[np.abs(slowest) < 1.0], (-1.0, 1.0))
    fastest, found = max(np.linalg.norm(first + s * second + s * s * third) for s in (-1.0, 0.0, 1.0)), {start, end}
    for s in slowest:
        speed = np.linalg.norm(first + s * second + s * s * third)
        if speed <= _STOPS * fastest:
            return None
        if speed < _SLOW * fastest:
            found |= {middle + half * at for at in (s, *(s + sign * 0.5 ** k for sign in (-1, 1) for k in range(40))) if abs(at) < 1.0}
    return sorted(found)


def _derivatives(curve, u, order, unit):
    """(n, order, 3): from the first one on, of the curve in units of its size and of its domain."""
    size, length = unit
    return curve.derivatives(u, order)[:, 1:] * (length ** np.arange(1.0, order + 1.0))[:, None] / size


def _rule(curve, starts, ends, unit):
    """(n,)"""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    u = (starts + ends)[:, None] / 2.0 + (ends - starts)[:, None] / 2.0 * nodes
    first, second = _derivatives(curve, u.ravel(), 2, unit).transpose(1, 0, 2)
    across = (np.cross(first, second) ** 2).sum(axis=1)
    speed = np.sqrt((first ** 2).sum(axis=1))
    with np.errstate(divide='ignore', invalid='ignore'):
        values = (across / speed ** 5).reshape(u.shape)
    return (ends - starts) / unit[1] / 2.0 * (values @ weights)


def energy_text(energy):
    """An energy() in words."""
    return "infinite" if np.isinf(energy) else "not found" if np.isnan(energy) else f"{energy:.4g}"


def picture(points, spacing, marker, ends):
    """(the Parts of a strip through ducks at points (n, 3), its energy). ends: how far it reaches beyond the first and the last one."""
    curve = strip(points, spacing)
    bent = energy(curve)
    start, end = curve.domain
    parts = [Part(STRIP, curve)]
    for u, sign, side in ((start, -1.0, 'right'), (end, 1.0, 'left')):
        place, along = curve.derivatives([u], 1, side=side)[0]
        length = np.linalg.norm(along)
        if ends > 0.0 and length > 0.0:
            parts.append(Part(END, line(tuple(place), tuple(place + sign * ends / length * along))))
    for i, point in enumerate(points):
        parts += signs.cross(f"D_{{{i}}}", point, marker)
    middle = curve.evaluate([(start + end) / 2.0])[0]
    return parts + signs.cross(f"E = {energy_text(bent)}", middle, marker / 4.0), bent
