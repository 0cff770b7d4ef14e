"""Single vertices of a net in Edit Mode: which are selected, and how one is moved by a number."""

import bpy
import numpy as np

from ...core.net import reading
from ...core.net.reading import ChangedNet
from ..cage import cage, free_net, net_object, net_splines
from ..data.file_state import key, state


def selected(ob, net):
    """Numbers of the selected vertices, ascending. The feet of arrows and idle handles are left out."""
    chosen = every_selected(ob, net)
    return chosen[net.rows[chosen] >= 0].tolist()


def every_selected(ob, net):
    """(k,): selected(), with feet and idle handles. Kept until Blender tells of a change, or select() makes one."""
    name = key(ob.data)
    if name not in state.selected:
        state.selected[name] = _selected(ob, net)
    return state.selected[name]


def _selected(ob, net):
    try:
        slots = _slots(ob, net)
    except ChangedNet:
        return np.empty(0, np.int64)    # live.problem() says it
    flags = _flags(ob)
    there = np.flatnonzero((slots >= 0) & (slots < len(flags)))
    return there[flags[slots[there]]]


def select(ob, net, vertices):
    """Make these the selected vertices."""
    slots = _slots(ob, net)[list(vertices)]
    flags = np.zeros(len(_flags(ob)), bool)
    flags[slots[(slots >= 0) & (slots < len(flags))]] = True
    _set_flags(ob, flags)


def is_chosen(ob, index, kind):
    """cage.is_chosen() of a patch's net."""
    return cage.is_chosen(ob, index, kind)


def choose(ob, index, kind, how):
    """cage.choose() in a patch's net."""
    state.selected.pop(key(ob.data), None)
    cage.choose(ob, index, kind, how)


def clear(ob):
    """Select nothing of a patch's net."""
    state.selected.pop(key(ob.data), None)
    cage.clear(ob)


def move(ob, net, vertices, rows):
    """place(), and the numbers are kept in float64 beside the net."""
    _require_there(ob, net, vertices)
    numbers = free_net.numbers(ob.data)[vertices] if free_net.is_free(ob.data) else np.asarray(vertices) + net.first
    net_object.add_typed(ob.data, np.column_stack([numbers, rows]))
    place(ob, net, vertices, rows)


def place(ob, net, vertices, rows):
    """Give vertices positions and weights, rows (k, 4), as Blender holds them.

    Raises Refusal where the net cannot be read, or a vertex is not there.
    """
    by_slot = dict(zip(_require_there(ob, net, vertices).tolist(), rows.tolist()))
    if _is_curve(ob):
        net_splines.move(ob.data, by_slot)
    else:
        cage.move(ob, by_slot)


def handle_types(ob):
    """What give_handle_types() takes."""
    return net_splines.letters(ob.data) if _is_curve(ob) else None


def give_handle_types(ob, types):
    """Let the handles of a net have these types again. Handles that Blender computes are where it computes them then."""
    if _is_curve(ob) and not np.array_equal(types, net_splines.letters(ob.data)):
        net_splines.give_letters(ob.data, types)


def _require_there(ob, net, vertices):
    """(k,): the slots of vertices."""
    net_object.required_shape(ob)
    slots = _slots(ob, net)[vertices]
    if (slots < 0).any():
        raise ChangedNet("a point of the net is not there any more")
    return slots


def select_originals(ob, net):
    """Select points in place of their copies, where these are where the points are: what was called off is moved as if
    it had not been. Safe at any time: nothing is added and nothing removed. In edge and face select mode, where a
    vertex cannot be selected alone, all stays."""
    if not _is_curve(ob) and not cage.selects_vertices(ob):
        return
    present = net_object.present(ob, net)
    slots, flags = reading.slots(net, present), _flags(ob)
    copies = np.flatnonzero((present.numbers >= 0) & flags)
    points = slots[present.numbers[copies]]
    positions = present.positions()
    is_copy = (points != copies) & (positions[points] == positions[copies]).all(1)
    if is_copy.any():
        flags[copies[is_copy]] = False
        flags[points[is_copy]] = True
        _set_flags(ob, flags)


def _slots(ob, net):
    """(n,) of each vertex its slot among those that Blender holds, or -1. Raises ChangedNet."""
    if free_net.is_free(ob.data):
        return np.arange(len(net.rows))
    return reading.slots(net, net_object.present(ob, net))


def _is_curve(ob):
    return isinstance(ob.data, bpy.types.Curve)


def _flags(ob):
    return net_splines.flags(ob.data) if _is_curve(ob) else cage.flags(ob)


def _set_flags(ob, flags):
    state.selected.pop(key(ob.data), None)
    if _is_curve(ob):
        net_splines.set_flags(ob.data, flags)
    else:
        cage.set_flags(ob, flags)
