"""Circles around the control points of a curve whose areas are the parts that those have in one of its points (S6, S9, S14)."""

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from . import functions, signs
from .functions import Part

#: The radius of the cross at a point that has no part, beside that of the circle of a whole one.
_NONE = 0.06


def shares(curve, u):
    """(n,): by what each control point of a NurbsCurve is multiplied in the point at u; with weights that is R_i, and infinite or NaN where
    the point is at infinity."""
    side = 'left' if u == curve.domain[1] else 'right'
    values = curve.unrolled().knot_vector.functions(u, side=side)
    found = np.zeros(len(curve.points))
    np.add.at(found, np.arange(len(values)) % len(found), values)
    found *= curve.homogeneous_points[:, 3]
    with np.errstate(divide='ignore', invalid='ignore'):
        return found / found.sum()


def picture(curve, position, radius, letter="N"):
    """(the Parts of a NurbsCurve, a warning or ""). letter: of its functions; position: 0 at the start, 1 at the end; radius: of a circle for the value 1."""
    start, end = curve.domain
    u = min(start + position * (end - start), end)
    values, parts = shares(curve, u), []
    if not np.isfinite(values).all():
        return [], "the point is at infinity: parts of it are not numbers"
    for i, value in enumerate(values):
        place, name = signs.place(curve.homogeneous_points[i]), f"{letter}_{{{i},{curve.degree}}}"
        if np.isfinite(place).all():
            parts.append(Part(name, _circle(place, radius * np.sqrt(abs(value)), radius)))
    point = curve.evaluate([u], side='left' if u == end else 'right')[0]
    return parts + signs.cross(f"C  u = {u:.4g}", point, _NONE * radius), _warning(values, curve)


def _circle(place, radius, whole):
    if radius > 1e-6 * whole:
        return sc.conics.circle(place, radius)
    return signs.cross("", place, _NONE * whole)[0].curve


def _warning(values, curve):
    below = [phrase("P{i} has {value:.3g}", i=i, value=value) for i, value in enumerate(values) if value < 0.0]
    away = np.count_nonzero(curve.homogeneous_points[:, 3] == 0.0)
    said = [phrase("{points}: circles show the size alone", points=", ".join(below[:3] + ["…"] * (len(below) > 3)))] if below else []
    said += [phrase("{count} points at infinity have no circle", one="{count} point at infinity has no circle", count=int(away))] if away else []
    return "; ".join(said)
