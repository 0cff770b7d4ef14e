"""Marks at equal steps of the parameter, both tangents at corners, and derivatives at the ends, as arrows."""

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from . import signs

#: Ends so near to each other, as a part of the size, meet.
_MEET = 1e-9
#: Directions that differ less are one; derivatives that are shorter, as a part of the size for a domain of length 1, are zero.
_ONE_DIRECTION, _ZERO = 1e-6, 1e-9


def steps(curves, count, radius):
    """Crosses at count + 1 equally spaced parameters of each curve; a periodic curve has no one at its end."""
    shown = []
    for curve in curves if count > 0 else ():
        curve = curve.to_nurbs()
        start, end = curve.domain
        for i in range(count if curve.periodic else count + 1):
            u = end if i == count else start + (end - start) * i / count
            shown += signs.cross(f"u = {u:.4g}", _derivatives(curve, u, i == count, 0)[0], radius)
    return shown


def tangents(curves, length):
    """Two arrows of a length at each corner: as the curve arrives there, T_-, and as it leaves, T_+."""
    shown = []
    for before, after in _joints([curve.to_nurbs() for curve in curves]):
        arrives, leaves = _direction(*before, True), _direction(*after, False)
        if arrives is not None and leaves is not None and np.linalg.norm(leaves - arrives) > _ONE_DIRECTION:
            place = _derivatives(*after, False, 0)[0]
            shown += signs.arrow("T_{-}", place, length * arrives) + signs.arrow("T_{+}", place, length * leaves)
    return shown


def derivatives(curves):
    """(arrows from the ends of curves, as long as the first derivatives there; how many of those are zero, in words). Of Hermite chains from all
    nodes."""
    found, zero = [], 0
    for curve in curves:
        at = list(curve.parameters) if isinstance(curve, sc.HermiteCurve) else curve.domain
        nurbs = curve.to_nurbs()
        sides = [(u, is_left) for i, u in enumerate(at) for is_left in ((True, False) if 0 < i < len(at) - 1 else (i > 0,))]
        for u, is_left in sides[:1] if nurbs.periodic else sides:
            place, vector = _derivatives(nurbs, u, is_left, 1)
            zero += not vector.any()
            if not any(_are_same(known, (place, vector), nurbs) for known in found[-1:]):
                found.append((place, vector))
    arrows = [part for i, (place, vector) in enumerate(found) for part in signs.arrow(f"R_{{{i}}}", place, vector)]
    said = phrase("{count} derivatives at ends are zero", one="{count} derivative at ends is zero", count=zero)
    return arrows, said if zero else ""


def _are_same(one, other, curve):
    near = _MEET * max(_size(curve), np.abs(one[1]).max())
    return all(np.abs(a - b).max() <= near for a, b in zip(one, other))


def _joints(curves):
    """[((curve, u), (curve, u))]: where one passes to the other, or to itself."""
    found = [((curve, u), (curve, u)) for curve in curves for u in _inner(curve)]
    for i, curve in enumerate(curves):
        following = curves[(i + 1) % len(curves)]
        end, start = _derivatives(curve, curve.domain[1], True, 0)[0], _derivatives(following, following.domain[0], False, 0)[0]
        if np.abs(start - end).max() <= _MEET * max(_size(curve), _size(following)):
            found.append(((curve, curve.domain[1]), (following, following.domain[0])))
    return found


def _inner(curve):
    start, end = curve.domain
    knots = np.unique(curve.knots)
    return knots[(knots > start) & (knots < end)]


def _direction(curve, u, is_left):
    """(3,): where it goes there, also where its first derivatives are zero; None where it stays or is at infinity."""
    start, end = curve.domain
    wanted = _derivatives(curve, u, is_left, curve.degree)[1:]
    for order, vector in enumerate(wanted, 1):
        length = np.linalg.norm(vector)
        if length * (end - start) ** order > _ZERO * _size(curve):
            return vector / length * (-1.0 if is_left and order % 2 == 0 else 1.0)
    return None


def _derivatives(curve, u, is_left, order):
    """(order + 1, 3); NaN at infinity."""
    side = 'left' if is_left else 'right'
    if order == 0:
        return curve.evaluate([u], side=side, at_infinity='nan')
    try:
        return curve.derivatives([u], order, side=side)[0]
    except sc.Error:
        return np.full((order + 1, 3), np.nan)


def _size(curve):
    rows = curve.homogeneous_points
    finite = rows[rows[:, 3] != 0.0]
    return np.ptp(finite[:, :3] / finite[:, 3:], axis=0).max()
