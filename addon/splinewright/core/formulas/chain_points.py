"""The points d, e, f and g of a chain of cubics that is C2 (S7, S8): of its spline polygon and of its Bezier polygons.

d_i are the control points of the spline; e_i the joints, f_i and g_i the points between them. f and g lie on legs of the polygon of d,
e on the segments from g to f; all are labeled with the ratios in which they divide.
"""

import numpy as np

from ..base.library import sc
from . import signs
from .functions import Part

SPLINE, BEZIER = "spline polygon", "Bezier polygon"
#: Places and ends so near to each other, as a part of the size, are one: Blender moves points in single precision.
_ONE_PLACE = 1e-6


def of_curve(curve, polygons, marker):
    """The Parts of the NURBS form of a curve. polygons: 'both', 'spline', 'bezier' or 'none'; marker: the radius of marks."""
    curve = curve.to_nurbs()
    count, whole = len(curve.points), curve.unrolled()
    rows = whole.homogeneous_points[:count]
    spline = [np.concatenate([rows, rows[:1]]) if curve.periodic else rows]
    beziers = [bezier.homogeneous_points for bezier in curve.to_bezier()]
    names = _named(beziers, _ratios(whole, beziers, curve.periodic), curve.periodic)
    marks = [(f"d_{{{i}}}", row) for i, row in enumerate(rows)]
    return _polygons(polygons, spline, beziers) + _marks(_merged(marks, names), marker)


def of_chain(beziers, polygons, marker):
    """(the Parts of polynomial cubic Bezier curves, one after the other; why there is no spline polygon, or "")."""
    lengths = _lengths(beziers)
    size = max(np.ptp(bezier.points, axis=0).max() for bezier in beziers)
    try:
        points = sc.build.polygon_of_chain(beziers, lengths, _ONE_PLACE * size)
    except sc.Error as error:
        rows = [bezier.homogeneous_points for bezier in beziers]
        return _polygons(polygons, [], rows) + _marks(_named(rows, {}, False), marker), f"no spline polygon: {error}"
    joints = np.concatenate([[0.0], np.cumsum(lengths)])
    spline = sc.NurbsCurve(3, np.concatenate([np.repeat(joints[0], 3), joints, np.repeat(joints[-1], 3)]), points)
    return of_curve(spline, polygons, marker), ""


def _lengths(beziers):
    """Intervals on which neighbors have one derivative where they meet; the first is 1."""
    lengths = [1.0]
    for one, other in zip(beziers, beziers[1:]):
        before, after = np.linalg.norm(one.points[-1] - one.points[-2]), np.linalg.norm(other.points[1] - other.points[0])
        lengths.append(lengths[-1] * (after / before if before > 0.0 and after > 0.0 else 1.0))
    return lengths


def _named(beziers, ratios, is_closed):
    """[(text, row)] of Bezier points: joints e, between them f and g of cubics, else b."""
    found = []
    for i, rows in enumerate(beziers):
        inner = ["f", "g"] if len(rows) == 4 else []
        found.append((f"e_{{{i}}}", rows[0]))
        found += [(f"{inner[j]}_{{{i + 1}}}" if inner else f"b_{{{i + 1},{j + 1}}}", row) for j, row in enumerate(rows[1:-1])]
    if not is_closed:
        found.append((f"e_{{{len(beziers)}}}", beziers[-1][-1]))
    return [(name + ratios.get(name, ""), row) for name, row in found]


def _ratios(curve, beziers, is_closed):
    """{name: text}: in which ratio points of a cubic divide the segments that they lie on, as it is seen: with weights."""
    if curve.degree != 3:
        return {}
    u, w = np.array(curve.knots), curve.homogeneous_points[:, 3]
    start, end = curve.domain
    spans = [j for j in range(3, len(w)) if start <= u[j] < u[j + 1] <= end]
    found = {}
    for i, j in enumerate(spans):
        found[f"f_{{{i + 1}}}"] = signs.ratio((u[j] - u[j - 1]) * w[j - 1], (u[j + 2] - u[j]) * w[j - 2])
        found[f"g_{{{i + 1}}}"] = signs.ratio((u[j + 1] - u[j - 1]) * w[j - 1], (u[j + 2] - u[j + 1]) * w[j - 2])
        before = spans[i - 1]
        if (i > 0 or is_closed) and np.count_nonzero(u == u[j]) <= 2:
            found[f"e_{{{i}}}"] = signs.ratio((u[before + 1] - u[before]) * beziers[i][1, 3], (u[j + 1] - u[j]) * beziers[i - 1][-2, 3])
    return found


def _merged(marks, others):
    """Marks of both, where those that lie on one of the first are named beside it: d_1 = f_1."""
    places = np.array([signs.place(row) for _, row in marks])
    size = np.ptp(places[np.isfinite(places).all(axis=1)], axis=0).max()
    texts, found = [text for text, _ in marks], []
    for text, row in others:
        distances = np.linalg.norm(places - signs.place(row), axis=1)
        same = np.flatnonzero(distances <= 1e-9 * size)
        if len(same):
            letter, below, _ = signs.named(f"{signs.MARK} {text}")
            texts[same[0]] += f" = {letter}{below}"
        else:
            found.append((text, row))
    return [*zip(texts, (row for _, row in marks)), *found]


def _polygons(which, spline, beziers):
    shown = [(SPLINE, spline)] if which in ('both', 'spline') else []
    shown += [(BEZIER, beziers)] if which in ('both', 'bezier') else []
    return [Part(name, one) for name, polygons in shown for rows in polygons for one in signs.polygon(rows)]


def _marks(marks, radius):
    return [part for text, row in marks for part in signs.cross(text, signs.place(row), radius)]
