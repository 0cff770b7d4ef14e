"""The draughtsman's spline: a strip that weights, called ducks, hold at points (S5, 001.36 to 38).

Between ducks it bends as little as it can: the natural cubic spline. Outside of them it is straight.
"""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import signs
from .functions import Part, line

STRIP, END = "strip", "end"
#: A part of the energy within which it is found.
_WITHIN = 1e-9


def strip(points, spacing):
    """The natural cubic spline through points (n, 3). Raises Refusal for fewer than two, or an error of the library."""
    if len(points) < 2:
        raise Refusal("a strip is held by two ducks or more")
    if len(points) == 2:
        return sc.NurbsCurve(1, [0.0, 0.0, 1.0, 1.0], points).elevate(2)
    return sc.fit.interpolate(points, 3, spacing, ends='natural')[0]


def energy(curve):
    """The integral of the squared curvature over the length of a polynomial curve: what it takes to bend a strip so, with stiffness 1."""
    return sum(_over(curve, start, end) for start, end in curve.pieces())


def _over(curve, start, end):
    """Between two knots, halved until two rules agree."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    stack, total, steps = [(start, end, _rule(curve, start, end, nodes, weights))], 0.0, 0
    while stack:
        first, last, whole = stack.pop()
        middle = (first + last) / 2.0
        halves = [(first, middle), (middle, last)]
        parts = [_rule(curve, *half, nodes, weights) for half in halves]
        steps += 1
        if abs(sum(parts) - whole) <= _WITHIN * max(total + sum(parts), 1e-300) or steps > 4000:
            total += sum(parts)
        else:
            stack += [(*half, part) for half, part in zip(halves, parts)]
    return total


def _rule(curve, start, end, nodes, weights):
    u = (start + end) / 2.0 + (end - start) / 2.0 * nodes
    first, second = curve.derivatives(u, 2)[:, 1:3].transpose(1, 0, 2)
    across = (np.cross(first, second) ** 2).sum(axis=1)
    speed = np.sqrt((first ** 2).sum(axis=1))
    with np.errstate(divide='ignore', invalid='ignore'):
        values = across / speed ** 5
    return float((end - start) / 2.0 * (weights * values).sum())


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
    return parts + signs.cross(f"E = {bent:.4g}", middle, marker / 4.0), bent
