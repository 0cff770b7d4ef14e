"""What became of patches whose net gained and lost rows: the definition that follows, and which vertex is which then.

Rows that were extruded from a border are appended, rows that were cut in are inserted, rows that are gone are removed;
patches that share borders go along. Vertices that make no row are passed over.
"""

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..shape.definition import Definition, Piece
from . import cage_rows, patch_net, row_edits
from .grown import Grown, NEW, STRAY, copy_of

#: How far borders that patches share may lie apart, as a part of how large they are, and be taken for one.
_SAME = 1e-9
#: What is not told of how far a shape is from what it was.
_NOTHING = 1e-13


def grow(net, definition, cages):
    """The Grown net of a definition, as of grown.grow(). cages: the one core.net.cage.Cage."""
    (cage,) = cages
    if len(cage.numbers) == len(net.rows) and (cage.numbers >= 0).all():
        return None
    plans = cage_rows.plans(net, cage)
    if plans is None or all(plan.is_idle for plan in plans):
        return None
    _require_rows(net, plans)
    patches = definitions.to_patch_set(definition)
    edits = [_carried_out(patches[i], plan, cage) for i, plan in enumerate(plans)]
    slots, made = _put_together(definition, plans, edits)
    faces = _other_faces(cage, slots, made, any(plan.is_torn for plan in plans))
    error = max(edit.error for edit in edits)
    return _told(cage, plans, slots, made, _note(plans, error if error > _NOTHING * definition.size else 0.0), faces)


def settled(cages):
    """As of grown.settled(): copies beside what they are copies of, that lie where that is."""
    (cage,) = cages
    numbers = cage.numbers.copy()
    own = {number: slot for slot, number in enumerate(numbers.tolist()) if number >= 0}
    for slot in np.flatnonzero((numbers < NEW) & (numbers != STRAY)).tolist():
        origin = own.get(copy_of(int(numbers[slot])))
        if origin is not None and (cage.places[slot] == cage.places[origin]).all():
            numbers[slot] = STRAY
    return [numbers] if (numbers != cage.numbers).any() else None


def _require_rows(net, plans):
    if any(piece.kind == 'hermite' for piece in net.source.pieces):
        raise Refusal("nets with Hermite patches neither gain nor lose rows: make them NURBS patches first, the shape has "
                      "its points as they were")
    if net.arrows:
        raise Refusal("nets with points at infinity neither gain nor lose rows: bring those back first, or use Insert Knot")
    if any(sum(not axis.is_idle for axis in plan.axes) > 1 and any(axis.before or axis.after for axis in plan.axes)
           for plan in plans):
        raise Refusal("a patch was extruded and changed along its other direction at once: do one after the other")


def _note(plans, error):
    if not error:
        return ""
    count = sum(len(axis.gone) for plan in plans for axis in plan.axes)
    return phrase("without those rows the shape lies within {error} of what it was",
                  one="without that row the shape lies within {error} of what it was", count=count, error=decimals.text_of(error))


# The patches ---------------------------------------------------------------------------------------


class _Edit:
    """A patch after its edits, and the slots of its control points."""

    def __init__(self, patch, slots, error, is_changed):
        self.patch, self.slots, self.error, self.is_changed = patch, slots, error, is_changed


def _carried_out(patch, plan, cage):
    orders, error = [None, None], 0.0
    for axis in (0, 1):
        edited = _along(row_edits.started(patch, axis), plan, cage)
        patch, orders[axis], error = edited.patch, edited.order, error + edited.error
    slots = np.empty_like(plan.slots)
    slots[np.ix_(*orders)] = plan.slots
    return _Edit(patch, slots, error, not plan.is_idle)


def _along(edited, plan, cage):
    axis = plan.axes[edited.axis]
    places = list(axis.gone)
    while places and not row_edits.is_periodic(edited) and places[-1] == len(edited.order) - 1:
        edited = row_edits.removed(edited, places.pop())
    while places and not row_edits.is_periodic(edited) and places[0] == 0:
        edited = row_edits.removed(edited, 0)
        places = [place - 1 for place in places[1:]]
    for place in reversed(places):
        edited = row_edits.removed(edited, place)
    if axis.gaps:
        edited = row_edits.inserted(edited, axis.gaps, axis.is_mirrored)
    for is_extruded, end in ((axis.before, 0), (axis.after, -1)):
        if is_extruded:
            row = np.take(plan.slots, end, edited.axis)
            points, weights = cage.places[row].astype(np.float64), cage.weights[row].astype(np.float64)
            edited = row_edits.appended(edited, points, weights, not end)
    return edited


# The definition ------------------------------------------------------------------------------------


def _put_together(definition, plans, edits):
    """(of each row of the pool its slot, the definition). Patches that did not change keep what they share."""
    slots = np.unique(np.concatenate([edit.slots.ravel() for edit in edits]))
    pool = np.full((len(slots), 4), np.nan)
    for edit in sorted(edits, key=lambda one: one.is_changed):
        rows, own = np.searchsorted(slots, edit.slots), np.dstack([edit.patch.points, edit.patch.weights])
        flat, firsts = np.unique(rows.ravel(), return_index=True)
        own = own.reshape(-1, 4)
        is_new = np.isnan(pool[flat, 0])
        pool[flat[is_new]] = own[firsts[is_new]]
        if (np.abs(pool[rows.ravel()] - own) > _SAME * np.abs(own).max()).any():
            raise Refusal("patches that share a border have other knots or weights along it: their rows cannot go along, "
                          "the shape has them as they were")
    pieces = tuple(_piece(edit, np.searchsorted(slots, edit.slots)) for edit in edits)
    return slots, Definition(definition.form, pool, pieces)


def _piece(edit, rows):
    indices = rows.astype(np.int32)
    if isinstance(edit.patch, sc.BezierPatch):
        return Piece('bezier', indices)
    return Piece('nurbs', indices, tuple(edit.patch.degree), tuple(map(bool, edit.patch.periodic)),
                 tuple(np.array(knots) for knots in edit.patch.knots))


def _other_faces(cage, slots, made, is_torn):
    """(faces that are to be made, by their slots, faces that are to go): where a row left a gap, and where a face has to
    be parted, as beside a pole. Raises Refusal unless the cage else connects what the definition connects."""
    own = set(slots.tolist())
    there = {face for face in cage.faces if face <= own}
    wanted = {frozenset(corners): corners for corners in
              (tuple(slots[list(corners)].tolist()) for corners in patch_net.make(made).faces)}
    missing, others = [face for face in wanted if face not in there], there - set(wanted)
    parted = {face: [part for part in missing if part < face] for face in others}
    is_told = all(parts and face == frozenset().union(*parts) for face, parts in parted.items())
    if not is_told or not is_torn and len(missing) > len({part for parts in parted.values() for part in parts}):
        raise Refusal("points are connected otherwise than rows of patches are: the shape has them as they were")
    return tuple(wanted[face] for face in missing), frozenset(others)


def _told(cage, plans, slots, made, note, faces):
    numbers = np.where(cage.numbers == STRAY, STRAY, NEW)
    numbers[slots] = np.arange(len(slots))
    was = cage.numbers[slots]
    origins = np.where(was < NEW, copy_of(was), was)
    now_of = dict(zip(was[was >= 0].tolist(), np.flatnonzero(was >= 0).tolist()))
    for slot in np.flatnonzero((numbers == NEW) & (cage.numbers < NEW)).tolist():
        now = now_of.get(copy_of(int(cage.numbers[slot])), NEW)
        numbers[slot] = copy_of(now) if now != NEW else NEW
    added = np.flatnonzero(was < NEW) if all(axis.only_appends for plan in plans for axis in plan.axes) else []
    return Grown(patch_net.make(made), (numbers,), origins, np.array(added, dtype=np.int64), note, *faces)
