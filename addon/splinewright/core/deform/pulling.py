"""A point of a shape is pulled, or the tangent or osculating circle of a curve there: its control points follow by the least
change (The NURBS Book, 11.5)."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import definition as definitions
from ..shape import parameters as parameters_of
from ..verbs import verbs

#: What is pulled at a point of a curve; of patches the point alone.
HANDLES = ('POINT', 'TANGENT', 'CIRCLE')
#: The handle of an osculating circle is at most so far round it from the point, in radians.
_ROUND = 1.0
#: What turns by less, in radians, is as good as straight.
_STRAIGHT = 1e-9
#: Parts of which an osculating circle is drawn.
_PARTS = 96


def pulled(definition, number, parameters, by, locality=0.0, keeps_tangent=False, handle='POINT'):
    """The definition with the point of piece `number`, from 0, at (u,) or (u, v) moved by a vector (3,), or one of the HANDLES
    there.

    keeps_tangent: of a curve. Raises Refusal or an error of the library.
    """
    pool = definition.pool.copy()
    if definition.has_curves:
        curve, piece = verbs.pieces_of(definition)[number], definition.pieces[number]
        pool[piece.indices, :3] = _rows(_curve(curve, parameters[0], by, locality, keeps_tangent, handle))
    else:
        pool[:, :3] = definitions.to_patch_set(definition).dragged(number, *parameters, by, locality=locality).points
    if not np.isfinite(pool).all():
        raise Refusal("a point would be too far away for a number")
    return replace(definition, pool=pool)


def _curve(curve, u, by, locality, keeps_tangent, handle):
    if handle == 'POINT':
        return curve.dragged(u, by, np.zeros(3) if keeps_tangent else None, locality=locality)
    if handle == 'TANGENT':
        return curve.dragged(u, np.zeros(3), np.asarray(by) / _reach(curve, u))
    bend = _bend(curve, u)
    change = bend.through(bend.chord + by) - bend.curvature
    return curve.dragged(u, np.zeros(3), np.zeros(3), bend.speed * (bend.speed * change))


def handle_at(curve, u, handle):
    """(3,): where one of the HANDLES is."""
    point, velocity = curve.derivatives(u, 1)
    if handle == 'POINT':
        return point
    if handle == 'TANGENT':
        return point + _reach(curve, u) * velocity
    return point + _bend(curve, u).chord


def drawn(curve, u, handle):
    """(k, 2, 3): segments that show one of the HANDLES."""
    point = curve.evaluate(u)
    if handle == 'POINT':
        return np.empty((0, 2, 3))
    if handle == 'TANGENT':
        return np.array([[point, handle_at(curve, u, handle)]])
    bend = _bend(curve, u)
    size = np.linalg.norm(bend.curvature)
    if size * np.linalg.norm(bend.chord) < _STRAIGHT:
        around = point + np.array([[-1.0], [1.0]]) * 4 * bend.chord
    else:
        turn = np.linspace(0, 2 * np.pi, _PARTS + 1)[:, None]
        around = point + (np.sin(turn) * bend.tangent + (1 - np.cos(turn)) * (bend.curvature / size)) / size
    return np.stack([around[:-1], around[1:]], axis=1)


def _reach(curve, u):
    """A third of the span around a parameter: there the handle of a Bezier segment is."""
    ends = np.unique(np.clip(parameters_of.knots_of(curve), *curve.domain))
    span = min(max(int(np.searchsorted(ends, u, side='right')) - 1, 0), len(ends) - 2)
    return (ends[span + 1] - ends[span]) / 3.0


class _Bend(NamedTuple):
    """The osculating circle at a point of a curve."""

    speed: float
    tangent: np.ndarray                 # (3,), 1 long
    curvature: np.ndarray               # (3,), towards the middle, one over the radius long
    chord: np.ndarray                   # (3,), from the point to another on the circle, by which it is pulled

    def through(self, chord):
        """(3,): the curvature of the circle that touches the tangent at the point and goes through another, a chord away."""
        across = chord - (chord @ self.tangent) * self.tangent
        length = np.linalg.norm(chord)
        if not length > 0:
            raise Refusal("no circle goes through the point twice: pull farther away from it")
        return 2 * (across / length) / length


def _bend(curve, u):
    """The _Bend at a parameter. Raises Refusal where the curve has no direction."""
    _, velocity, acceleration = curve.derivatives(u, 2)
    speed = np.linalg.norm(velocity)
    if not speed > 0:
        raise Refusal("the curve has no direction there, and no osculating circle")
    tangent = velocity / speed
    curvature = (acceleration - (acceleration @ tangent) * tangent) / speed / speed
    size, length = np.linalg.norm(curvature), _reach(curve, u) * speed
    angle = min(length * size, _ROUND)
    if angle < _STRAIGHT:
        return _Bend(speed, tangent, curvature, length * tangent)
    return _Bend(speed, tangent, curvature, (math.sin(angle) * tangent + (1 - math.cos(angle)) * (curvature / size)) / size)


def _rows(curve):
    """What the indices of a curve's piece stand for."""
    if isinstance(curve, sc.HermiteCurve):
        return np.stack([curve.points, curve.tangents[:, 0], curve.tangents[:, 1]])
    return curve.points


def followers(before, after):
    """(points (k, 3) that moved between two definitions, how far each did as a part of the farthest (k,))."""
    far = np.linalg.norm(after.pool[:, :3] - before.pool[:, :3], axis=1)
    moved = np.flatnonzero((far > 0) & (before.pool[:, 3] != 0))
    return after.pool[moved, :3], far[moved] / far[moved].max(initial=0.0) if len(moved) else far[moved]
