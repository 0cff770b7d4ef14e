"""Tubes within tubes: plane ends between them are closed by rings of segments from rim to rim (lecture row S20)."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import places
from . import sections

#: Parts of the way round at which segments may begin, and places on a rim at which they are looked at.
_STARTS, _PLACES = 64, 512
#: Places at which all ways are looked at first, and how many of the best are looked at closely.
_COARSE, _TRIED = 96, 6
#: Where the rims begin is kept where that is so good a part of the best.
_GOOD = 0.5
#: Knots that lie so near, as a part of the way round, are one; rims are in a plane, as a part of their size.
_SAME, _FLAT = 1e-9, 1e-6
_AROUND_END = {'start': 0, 'end': -1}


class Hollow(NamedTuple):
    """A tube in a tube, with ends of the ring between them closed; normals on the same side all over."""

    outer: object
    inner: object
    rings: list                         # in the order of the ends
    lies: tuple                         # core.shape.places.Place of the outer and the inner one on what they were
    is_turned: bool                     # whether normals of the outer one are turned


class Way(NamedTuple):
    """How an inner tube is run round: against the outer one, from a part of its way on."""

    is_reversed: bool
    start: float


def is_within(inner, rim):
    """Whether a closed curve lies within another one that is plane, in its plane. Raises Refusal where they cross."""
    points = sections.samples(rim)[:-1]
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    normal, own = axes[2], sections.samples(inner)[:-1]
    if np.abs((own - middle) @ normal).max() > _FLAT * spread[0] or np.abs((points - middle) @ normal).max() > _FLAT * spread[0]:
        return False
    onto = np.eye(4)
    onto[:3, :3] -= np.outer(normal, normal)
    onto[:3, 3] = normal * (normal @ middle)
    flat = rim.transformed(onto)
    are_in = {_goes_round(flat, (onto @ [*place, 1.0])[:3], normal) for place in own}
    if are_in not in ({True}, {False}):
        raise Refusal("two of its rims cross or touch in one plane: what lies between them is no ring")
    return are_in == {True}


def _goes_round(curve, place, normal):
    """None where the place lies on the curve."""
    try:
        return curve.winding_number(place, normal) != 0
    except sc.InvalidShape:
        return None


def around_u(patch, side):
    """A patch so that its side runs along u, and whether it was swapped for that."""
    is_swapped = side.startswith('u')
    return (patch.swapped() if is_swapped else patch), is_swapped


def hollow(outer, inner, ends):
    """The Hollow of two patches closed along u, of which the ends with these names, 'start' and 'end' of v, are closed by rings.
    Raises Refusal where segments between the rims would cross."""
    rims = [[patch.boundary(f"v_{end}") for patch in (outer, inner)] for end in ends]
    way = _best_way(rims)
    outer = outer.clamped('u') if outer.periodic[0] else outer
    own = inner.reversed('u') if way.is_reversed else inner
    outer, inner = _on_same_knots(outer, _beginning_at(own, way.start))
    rings = [_ring(outer, inner, end) for end in ends]
    patches = [outer, inner.reversed('u'), *rings]
    is_turned = len(ends) == 2 and _is_inside_out(patches)
    if is_turned:
        patches = [patch.reversed('u') for patch in patches]
    lie_outer = places.reversed_(places.WHOLE) if is_turned else places.WHOLE
    begin = 1.0 - way.start if way.is_reversed else way.start
    lie = places.opened(places.WHOLE, begin) if way.start else places.WHOLE
    lie = lie if is_turned != way.is_reversed else places.reversed_(lie)
    return Hollow(patches[0], patches[1], patches[2:], (places.Place(u=lie_outer), places.Place(u=lie)), is_turned)


def _ring(outer, inner, end):
    at = _AROUND_END[end]
    rows = np.stack([outer.homogeneous_points[:, at], inner.homogeneous_points[:, at]], 1)
    made = sc.NurbsPatch.from_homogeneous((outer.degree[0], 1), (outer.knots[0], [0.0, 0.0, 1.0, 1.0]), rows)
    return made.reversed('u') if end == 'start' else made


def _best_way(rims):
    """The Way in which segments between rims lie beside each other best, the inner one run as it is where that is good."""
    ways = [Way(is_reversed, start) for is_reversed in (False, True) for start in _starts([inner for _, inner in rims], is_reversed)]
    coarse = [_Table(*both) for both in rims]
    guessed = sorted(ways[1:], key=lambda way: -min(table.least_sine(way) for table in coarse))[:_TRIED]
    found = [(_least_turn(rims, way), way) for way in (ways[0], *guessed)]
    best = max(turn for turn, _ in found)
    if not best > 0.0:
        raise Refusal("segments from a rim to the one within it would cross: a cap with such a hole cannot be made")
    return next(way for turn, way in found if turn >= _GOOD * best)


class _Table:
    """Places on an outer and an inner rim, evenly by their parameters."""

    def __init__(self, outer, inner):
        self._parts = np.arange(_COARSE + 1) / _COARSE
        self._ours = _at(outer, self._parts)
        self._theirs = _at(inner, self._parts)
        self._normal = _normal_of(self._ours)

    def least_sine(self, way):
        parts = _run(self._parts, way)
        return _sine_of(self._ours, np.stack([np.interp(parts, self._parts, column) for column in self._theirs.T], 1), self._normal)


def _run(parts, way):
    """Where on the inner rim segments end that begin at these parts of the outer one."""
    return (1.0 - (parts + way.start) if way.is_reversed else parts + way.start) % 1.0


def _at(curve, parts):
    start, end = curve.domain
    return curve.evaluate(start + (end - start) * parts)


def _normal_of(points):
    return np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]


def _starts(rims, is_reversed):
    """Parts of the way round, first where the rim begins."""
    own = np.concatenate([[0.0], np.arange(1, _STARTS) / _STARTS, *map(_breaks, rims)])
    own = 1.0 - own if is_reversed else own
    return [0.0, *sorted({round(part, 12) for part in own.tolist()} - {0.0, 1.0})]


def _breaks(curve):
    """Parts of its domain at which a curve has knots."""
    start, end = curve.domain
    knots = np.unique(np.clip(curve.knots, start, end))
    return (knots - start) / (end - start)


def _least_turn(rims, way):
    """The smallest sine by which a step along a rim leaves the segment there, on one side for all; not above 0 where some cross."""
    return min(_least_sine(outer, inner, way) for outer, inner in rims)


def _least_sine(outer, inner, way):
    parts = np.unique(np.concatenate([np.arange(_PLACES) / _PLACES, _breaks(outer)]))
    parts = np.append(parts[parts < 1.0 - _SAME], 1.0)
    ours = _at(outer, parts)
    return _sine_of(ours, _at(inner, _run(parts, way)), _normal_of(ours))


def _sine_of(ours, others, normal):
    across = others - ours
    sines = [_sines(np.diff(line, axis=0), across[at], normal) for line in (ours, others) for at in (slice(None, -1), slice(1, None))]
    sines = np.concatenate(sines)
    return max(sines.min(), -sines.max())


def _sines(steps, across, normal):
    lengths = np.linalg.norm(steps, axis=1) * np.linalg.norm(across, axis=1)
    turns = np.cross(steps, across) @ normal
    return turns[lengths > 0] / lengths[lengths > 0]


def _beginning_at(patch, part):
    """A patch closed along u that begins at a part of its way round, clamped there."""
    if not part:
        return patch.clamped('u') if patch.periodic[0] else patch
    start, end = patch.domain[0]
    at = start + (end - start) * part
    knots = np.unique(patch.knots[0])
    nearest = float(knots[np.abs(knots - at).argmin()])
    pieces = patch.split('u', nearest if abs(nearest - at) <= _SAME * (end - start) else at)
    if len(pieces) == 1:
        return pieces[0]
    last, first = (piece.clamped('u') for piece in pieces)
    degree = patch.degree[0]
    rows, more = first.homogeneous_points, last.homogeneous_points
    scale = rows[-1, :, 3].sum() / more[0, :, 3].sum()
    knots = np.concatenate([first.knots[0][:-1], last.knots[0][degree + 1:] - last.domain[0][0] + first.domain[0][1]])
    return sc.NurbsPatch.from_homogeneous(patch.degree, (knots, patch.knots[1]), np.concatenate([rows, scale * more[1:]]),
                                          (False, patch.periodic[1]))


def _is_inside_out(patches):
    """Whether normals of a closed surface point inwards, whatever its size."""
    points = np.concatenate([patch.points.reshape(-1, 3) for patch in patches])
    matrix = np.column_stack([np.eye(3), -points.mean(axis=0)]) / np.ptp(points, axis=0).max()
    return sc.PatchSet.from_patches([patch.transformed(matrix) for patch in patches]).volume() < 0.0


def _on_same_knots(outer, inner):
    """Both with one degree, one domain and the same knots along u."""
    degree = max(outer.degree[0], inner.degree[0])
    outer, inner = (patch.elevate('u', degree - patch.degree[0]) if patch.degree[0] < degree else patch for patch in (outer, inner))
    inner = inner.with_domain('u', outer.domain[0])
    start, end = outer.domain[0]
    known = outer.knots[0]
    theirs = [float(known[np.abs(known - knot).argmin()]) if np.abs(known - knot).min() <= _SAME * (end - start) else float(knot)
              for knot in inner.knots[0]]
    inner = sc.NurbsPatch.from_homogeneous(inner.degree, (theirs, inner.knots[1]), inner.homogeneous_points, (False, inner.periodic[1]))
    more, fewer = missing(theirs, known), missing(known, theirs)
    return (outer.refine('u', more) if more else outer), (inner.refine('u', fewer) if fewer else inner)


def missing(wanted, known):
    """Knots of one list that the other has not as often."""
    return [knot for knot in np.unique(wanted).tolist()
            for _ in range(int(np.sum(np.equal(wanted, knot))) - int(np.sum(np.equal(known, knot))))]
