"""Where the ends of two curves meet: which ends are nearest, and the curves as one."""

from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..shape import definition as definitions
from ..shape import places
from ..verbs import verbs

#: For continuity, in the order in which it asks for more.
SMOOTHNESS = ('C0', 'G1', 'C1', 'C2')

#: Below this an angle, or a relative difference of derivatives or curvatures, is what points in single precision
#: leave of a smooth joint.
SMOOTH = 1e-4

_START, _END = 0, 1


def joined(definition, first, second, smoothness, linear=np.eye(3), parted=None):
    """The verbs.Changed definition in which two pieces are one, at the place of the former.

    first, second: numbers of the pieces, counted from 1; 0 for the one whose end is nearest to the other.
    linear: (3, 3), what takes the points to the space in which distances are measured.
    parted: `first` is one of a given number of pieces at the beginning, `second` one of the rest, counted from there.

    The two nearest ends meet; a piece is reversed where it must be. The parameter of the first is continued in that
    of the second. Raises Refusal where a piece has no ends or they lie at infinity.
    """
    curves = verbs.curves_of(definition)
    count = len(curves)
    if count < 2:
        raise Refusal("it has one piece: Make Periodic closes it, and two shapes are joined if both are selected")
    rows = _chosen(curves[:parted], first)
    columns = _chosen(curves[parted or 0:], second) + (parted or 0)
    a, end_a, b, end_b = _nearest_ends(curves, rows, columns, linear)
    whole, error, origin = _in_a_row((curves[a], a), end_a, (curves[b], b), end_b, smoothness)
    after, origins = list(curves), [(places.Origin(i),) for i in range(count)]
    after[a], origins[a] = whole, origin
    del after[b], origins[b]
    return _changed(after, [i for i in range(count) if i != b], error, origins)


def _changed(curves, parents, error, origins):
    value = curves[0] if len(curves) == 1 else curves
    return verbs.Changed(definitions.from_value(value), tuple(parents), error, origins=tuple(origins))


def _chosen(curves, number):
    """Numbers, counted from 0, of the pieces that are meant."""
    if number == 0:
        return np.arange(len(curves))
    verbs.require_piece(curves, number)
    return np.array([number - 1])


def _nearest_ends(curves, rows, columns, linear):
    """(piece, end, another piece, end) of the two that lie nearest to each other; of equal ones those that need no
    reversal, if the first piece's end is one of them."""
    ends = np.full((len(curves), 2, 3), np.nan)
    for i in {*rows, *columns}:
        ends[i] = ends_of(curves[i]) @ linear.T
    best = None
    for a in rows:
        others = columns[columns != a]
        if not len(others):
            continue
        gaps = np.linalg.norm(ends[a][None, ::-1, None] - ends[others][:, None], axis=-1)
        gaps[np.isnan(gaps)] = np.inf
        i, end_a, end_b = np.unravel_index(gaps.argmin(), gaps.shape)
        if np.isfinite(gaps.min()) and (best is None or gaps.min() < best[0]):
            best = gaps.min(), (int(a), 1 - int(end_a), int(others[i]), int(end_b))
    if best is None:
        _refuse(curves, rows, columns)
    return best[1]


def _refuse(curves, rows, columns):
    """Raises Refusal: no two ends can meet."""
    if len(rows) == len(columns) == 1 and rows[0] == columns[0]:
        raise Refusal("a piece is not joined to itself: Make Periodic closes it")
    for i in (*rows, *columns):
        if getattr(curves[i], 'periodic', False):
            raise Refusal("piece {number} is periodic: it has no end to join", number=i + 1)
    raise Refusal("the ends of the pieces lie at infinity")


def ends_of(curve):
    """(2, 3): where a curve starts and ends; nan for an end at infinity, and where a curve is periodic."""
    if getattr(curve, 'periodic', False):
        return np.full((2, 3), np.nan)
    start, end = curve.domain
    return np.concatenate([curve.evaluate([start], at_infinity='nan'),
                           curve.evaluate([end], side='left', at_infinity='nan')])


def _in_a_row(first, end_a, second, end_b, smoothness):
    """(both as one curve, how far they moved, the core.shape.places.Origins of it). Both are pairs: a curve, its number."""
    (a, number), (b, other) = first, second
    if end_a == _START and end_b == _END:
        return _in_a_row(second, _END, first, _START, smoothness)
    a = _Part(a.to_nurbs(), (places.Origin(number),))
    b = _Part(b.to_nurbs(), (places.Origin(other),))
    whole, error = _joined(_turned(a) if end_a == _START else a, _turned(b) if end_b == _END else b, smoothness)
    return whole.curve, error, whole.origins


class _Part(NamedTuple):
    """A NURBS curve, and the core.shape.places.Origins of what it consists of."""

    curve: object
    origins: tuple


def _turned(part):
    return _Part(part.curve.reversed(), tuple(origin._replace(stretches=places.reversed_(origin.stretches))
                                              for origin in part.origins))


def _joined(a, b, smoothness):
    """(a _Part of both, how far they moved). The domain of the first stays, and that of the other follows it."""
    found = a.curve.join(b.curve, smoothness)
    (start, end), (_, joint) = found.value.domain, a.curve.domain
    at = (joint - start) / (end - start)
    origins = (*_squeezed(a.origins, 0.0, at), *_squeezed(b.origins, at, 1.0))
    return _Part(found.value, origins), found.error


def _squeezed(origins, start, end):
    """What lies from 0 to 1 from `start` to `end`."""
    return tuple(origin._replace(stretches=places.squeezed(origin.stretches, start, end)) for origin in origins)


def chained(definition, tolerance):
    """The verbs.Changed definition in which pieces whose ends lie within the tolerance, a length, are one.

    A joint where the directions agree is made C1: the parameter of the later piece is scaled for that. Then knots
    go as far as the tolerance allows, so that a chain of Bezier curves is the B-spline again that it came from (S8).
    Raises Refusal where no two ends meet.
    """
    curves, length = verbs.curves_of(definition), decimals.typed(tolerance)
    if len(curves) == 1:
        raise Refusal("it has one piece: there is nothing to join")
    rows = _rows(np.array([ends_of(curve) for curve in curves]), length)
    if len(rows) == len(curves):
        raise Refusal("no two ends of its pieces lie within {length} of each other", length=decimals.text_of(length))
    after, error, origins = [], 0.0, []
    for row in rows:
        number = row[0][0]
        part, moved = _as_one(curves, row, length) if len(row) > 1 else (
            _Part(curves[number], (places.Origin(number),)), 0.0)
        after.append(part.curve)
        origins.append(part.origins)
        error = max(error, moved)
    return _changed(after, [row[0][0] for row in rows], error, origins)


def _rows(ends, tolerance):
    """Lists of (piece, is it reversed), each a row of pieces that continue one another."""
    free, rows = set(range(len(ends))), []
    while free:
        row = [(min(free), False)]
        free.discard(row[0][0])
        for is_forward in (True, False):
            while (found := _next(ends, row, is_forward, free, tolerance)) is not None:
                row.insert(len(row) if is_forward else 0, found)
                free.discard(found[0])
        rows.append(row)
    return rows


def _next(ends, row, is_forward, free, tolerance):
    """The (piece, is it reversed) that continues at the end or the start of a row, or None."""
    piece, is_reversed = row[-1 if is_forward else 0]
    here = ends[piece, _START if is_forward == is_reversed else _END]
    others = np.array(sorted(free), dtype=int)
    if not len(others):
        return None
    gaps = np.linalg.norm(ends[others] - here, axis=-1)
    gaps[np.isnan(gaps)] = np.inf
    i, end = np.unravel_index(gaps.argmin(), gaps.shape)
    return (int(others[i]), bool(end == _START) != is_forward) if gaps[i, end] <= tolerance else None


def _as_one(curves, row, tolerance):
    """(the _Part of a row of pieces, how far it lies from them)."""
    whole, error = None, 0.0
    for piece, is_reversed in row:
        part = _Part(curves[piece].to_nurbs(), (places.Origin(piece),))
        part = _turned(part) if is_reversed else part
        if whole is None:
            whole = part
            continue
        is_smooth = whole.curve.continuity_to(part.curve, SMOOTH).g >= 1
        whole, moved = _joined(whole, part, 'C1' if is_smooth else 'C0')
        error += moved
    found = whole.curve.remove_knots(tolerance)
    return whole._replace(curve=found.value), error + found.error
