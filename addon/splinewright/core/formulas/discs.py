"""Circles around the control points of a curve or patch whose areas are the parts that those have in one of its points (S6, S9, S14, S16)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from . import functions, products, signs
from .functions import Part

#: The radius of the cross at a point that has no part, beside that of the circle of a whole one.
_NONE = 0.06
#: The normal of circles of curves.
_UP = (0.0, 0.0, 1.0)


def shares(curve, u):
    """(n,): by what each control point of a NurbsCurve is multiplied in the point at u; with weights that is R_i, and infinite or NaN where
    the point is at infinity."""
    return _rational(_values(curve.unrolled().knot_vector, u, curve.domain, len(curve.points)), curve)


def shares_of_patch(patch, u, v):
    """(nu, nv): the same of a NurbsPatch at (u, v)."""
    vectors, sizes = patch.unrolled().knot_vectors, patch.points.shape
    along = [_values(vectors[axis], (u, v)[axis], patch.domain[axis], sizes[axis]) for axis in (0, 1)]
    return _rational(np.outer(*along), patch)


def _values(vector, u, domain, count):
    """(count,): of the functions on an unrolled KnotVector, those that are one of a periodic shape together."""
    values = vector.functions(u, side='left' if u == domain[1] else 'right')
    found = np.zeros(count)
    np.add.at(found, np.arange(len(values)) % count, values)
    return found


def _rational(values, shape):
    found = values * shape.homogeneous_points[..., 3]
    with np.errstate(divide='ignore', invalid='ignore'):
        return found / found.sum()


def picture(curve, position, radius, letter="N"):
    """(the Parts of a NurbsCurve, a warning or ""). letter: of its functions; position: 0 at the start, 1 at the end; radius: of a circle for the value 1."""
    u = _at(curve.domain, position)
    names = {(i,): f"{letter}_{{{i},{curve.degree}}}" for i in range(len(curve.points))}
    point = curve.evaluate([u], side=_side(u, curve.domain), at_infinity='nan')[0]
    return _picture(curve, shares(curve, u), names, radius, signs.cross(f"C  u = {u:.4g}", point, _NONE * radius), _UP)


def picture_of_patch(patch, position, radius, letter="N"):
    """The same of a NurbsPatch at two positions: circles lie as its tangent plane does."""
    u, v = (_at(domain, share) for domain, share in zip(patch.domain, position))
    count, other = patch.points.shape[:2]
    if count * other > functions.MOST:
        raise Refusal("these are {count} functions: {most} are the most", count=count * other, most=functions.MOST)
    names = {(i, j): products.name_of(f"{letter}_{{{i},{patch.degree[0]}}}", f"{letter}_{{{j},{patch.degree[1]}}}") for i, j in np.ndindex(count, other)}
    values = shares_of_patch(patch, u, v)
    if not np.isfinite(values).all():
        return _picture(patch, values, names, radius, [], _UP)
    sides = tuple(_side(at, domain) for at, domain in zip((u, v), patch.domain))
    place, normal = (each[0, 0] for each in patch.evaluate_grid_with_normals([u], [v], side=sides))
    return _picture(patch, values, names, radius, signs.cross(f"S  u = {u:.4g}, v = {v:.4g}", place, _NONE * radius),
                    normal if np.isfinite(normal).all() and normal.any() else _UP)


def _at(domain, position):
    start, end = domain
    return min(start + position * (end - start), end)


def _side(u, domain):
    return 'left' if u == domain[1] else 'right'


def _picture(shape, values, names, radius, marks, normal):
    """values, names: by the number or numbers of a point; marks: of the point that they give."""
    if not np.isfinite(values).all():
        return [], "the point is at infinity: parts of it are not numbers"
    parts = []
    for number, name in names.items():
        place = signs.place(shape.homogeneous_points[number])
        if np.isfinite(place).all():
            parts.append(Part(name, _circle(place, radius * np.sqrt(abs(values[number])), radius, normal)))
    return parts + marks, _warning(values, shape)


def _circle(place, radius, whole, normal):
    if radius > 1e-6 * whole:
        return sc.conics.circle(place, radius, normal)
    return signs.cross("", place, _NONE * whole)[0].curve


def _warning(values, shape):
    below = [phrase("P{i} has {value:.3g}", i=','.join(map(str, number)), value=values[number]) for number in np.ndindex(values.shape) if values[number] < 0.0]
    away = np.count_nonzero(shape.homogeneous_points[..., 3] == 0.0)
    said = [phrase("{points}: circles show the size alone", points=", ".join(below[:3] + ["…"] * (len(below) > 3)))] if below else []
    said += [phrase("{count} points at infinity have no circle", one="{count} point at infinity has no circle", count=int(away))] if away else []
    return "; ".join(said)
