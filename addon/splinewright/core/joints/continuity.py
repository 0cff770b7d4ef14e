"""How smoothly the curves of a definition continue: each inside, at its knots, and from one to the next."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from ..shape import parameters
from ..verbs import verbs
from . import joints
from .held_joints import ENDS

#: Ends meet if they are nearer to each other than this part of the smaller piece.
_NEAR = 1e-3
#: Ends are sorted along it: on a grid no two of them come together there.
_SLANT = np.array([0.269, 0.535, 0.801])
#: Of ends in one place each is compared with so many others.
_MOST_NEIGHBORS = 16


class Joint(NamedTuple):
    """A place where a curve or patch continues, by itself or by another."""

    name: str                           # where it is, in words
    continuity: object                  # a splinecore Continuity; None at infinity
    degree: int                         # of the curve, or the higher of two: so many derivatives are all
    sides: tuple = ()                   # both, as in core.joints.held.Held


class Survey(NamedTuple):
    """The joints of a definition."""

    joints: tuple                       # the first ones
    count: int                          # of all
    bendable: int = 0                   # knots inside patches at which a crease may come about


def in_words(measured, degree):
    """Parametric and geometric continuity in one word, where this number of derivatives is all."""
    if measured.c < 0:
        return phrase("gap")
    return "C∞" if measured.c >= degree else f"C{measured.c} G{measured.g}"


def surveyed(definition, limit):
    """The Survey of a definition of curves, piece by piece, of a given number of joints at most.

    A name is a parameter or "seam", after the number of the piece where there are several; of two pieces their
    numbers and the way each runs: in "1 → → 2" the second continues where the first ends, "1 → ← 2" end both.
    """
    curves = verbs.curves_of(definition)
    ends = np.array([joints.ends_of(curve) for curve in curves])
    near = _NEAR * np.array([_size(definition.pool, piece) for piece in definition.pieces])
    found = [[_Inside(i, u) for u in _parameters(curves[i], ends[i], near[i])] for i in range(len(curves))]
    for between in _meetings(ends, np.minimum(near, np.median(near))):
        found[between.piece].append(between)
    found = sum(found, [])
    return Survey(tuple(one.joint(curves) for one in found[:limit]), len(found))


class _Inside(NamedTuple):
    """The parameter of a piece; None for the seam of one that is not periodic."""

    piece: int
    u: float

    def joint(self, curves):
        nurbs = curves[self.piece].to_nurbs()
        is_seam = self.u is None or self.u == nurbs.domain[0]
        where = phrase("seam") if is_seam else f"{self.u:.4g}"
        name = phrase("{number}: {where}", number=self.piece + 1, where=where) if len(curves) > 1 else where
        sides = ('end', 'start') if is_seam else (float(self.u), float(self.u))
        return _measured(name, nurbs.degree, [(self.piece, side) for side in sides], lambda: _at(nurbs, self.u))


class _Between(NamedTuple):
    """Two pieces, and of each whether it is its start (0) or its end (1)."""

    piece: int
    end: int
    other: int
    other_end: int

    def joint(self, curves):
        before, after = curves[self.piece].to_nurbs(), curves[self.other].to_nurbs()
        degree = max(before.degree, after.degree)
        sides = (self.piece, ENDS[self.end]), (self.other, ENDS[self.other_end])
        if (self.end, self.other_end) == (0, 1):
            return _measured(f"{self.other + 1} → → {self.piece + 1}", degree, sides[::-1],
                             lambda: after.continuity_to(before, joints.SMOOTH))
        name = f"{self.piece + 1} {'←→'[self.end]} {'→←'[self.other_end]} {self.other + 1}"
        before = before if self.end else before.reversed()
        after = after.reversed() if self.other_end else after
        return _measured(name, degree, sides, lambda: before.continuity_to(after, joints.SMOOTH))


def _at(nurbs, u):
    return nurbs.continuity_to(nurbs, joints.SMOOTH) if u is None else nurbs.continuity(u, joints.SMOOTH)


def _measured(name, degree, sides, measure):
    try:
        return Joint(name, measure(), degree, tuple(sides))
    except sc.PointAtInfinity:
        return Joint(name, None, degree, tuple(sides))


def _parameters(curve, ends, near):
    """Those of the joints inside a curve; None stands for the seam of a closed one."""
    if isinstance(curve, sc.BezierCurve):
        inner = []
    else:
        inner = parameters.inner_knots(curve).tolist()
    if getattr(curve, 'periodic', False):
        return [curve.domain[0], *inner]
    return [*inner, None] if np.linalg.norm(ends[1] - ends[0]) <= near else inner


def _size(pool, piece):
    """The diagonal of the box around the finite points of a piece."""
    rows = pool[piece.indices[0] if piece.kind == 'hermite' else piece.indices]
    points = rows[rows[:, 3] != 0, :3]
    return np.linalg.norm(np.ptp(points, axis=0)) if len(points) else 0.0


def _meetings(ends, near):
    """A _Between for two ends of different pieces that meet, in the order of the pieces.

    ends: (n, 2, 3), nan where there is none. near: (n,), how near to each other the ends of each are to lie.
    """
    pieces, sides = np.nonzero(np.isfinite(ends).all(-1))
    points, near = ends[pieces, sides], near[pieces]
    along = points @ _SLANT
    order = np.argsort(along, kind='stable')
    found = []
    for step in range(1, min(len(order), _MOST_NEIGHBORS + 1)):
        a, b = order[:-step], order[step:]
        if (along[b] - along[a]).min() > near.max():
            break
        meet = np.linalg.norm(points[a] - points[b], axis=1) <= np.minimum(near[a], near[b])
        first, second = np.minimum(a, b)[meet], np.maximum(a, b)[meet]
        found += zip(pieces[first].tolist(), sides[first].tolist(), pieces[second].tolist(), sides[second].tolist())
    return [_Between(*row) for row in sorted(found) if row[0] != row[2]]
