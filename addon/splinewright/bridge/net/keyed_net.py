"""The net of a shape whose points have keys goes where they are."""

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.net import handles
from ..cage import net_object
from ..keys import keyed_seams
from ..shape import shape
from . import live, selection
from .growing import Phase


def set_definition(data, definition):
    """shape.set_definition() with points that lie elsewhere, and those beside seams that hold; a net that is out shows
    them there. Returns in words what does not hold as smoothly as it is to."""
    definition, rest, lost = keyed_seams.applied(data, definition)
    net = held_net(data)
    if net is None:
        shape.set_definition(data, definition)
        keyed_seams.write(data, rest)
        return lost
    current, there = live.session(net.data), net_object.net_of(definition)
    vertices, rows = _placed(current, there)
    faces = shape.set_definition(data, definition)
    keyed_seams.write(data, rest)
    current.pool = definition.pool
    if faces is not None:
        current.wrote(data, faces)
    _give_true_types(net, current, there)
    selection.place(net, current.net, vertices, rows)
    live.sync_from_cage(net, Phase.BUSY)
    return lost


def _give_true_types(net, current, there):
    """Handles that are not where Blender would compute them are given as keys have them: it shall not compute them."""
    if not current.net.chains:
        return
    types, is_there = selection.handle_types(net).copy(), current.slots >= 0
    letters = np.zeros(len(is_there), types.dtype)
    letters[is_there] = types[current.slots[is_there]]
    types[current.slots[is_there]] = handles.true_of_net(there, letters)[is_there]
    selection.give_handle_types(net, types)


def held_net(data):
    """The net in Edit Mode of a shape's data-block, or None."""
    token = net_object.editor(data)
    if token is None:
        return None
    return next((ob for ob in bpy.data.objects if net_object.is_net(ob) and ob.mode == 'EDIT'
                 and net_object.token(ob.data) == token), None)


def _placed(current, net):
    """(vertices of a session's net that lie elsewhere in another with other numbers, rows x, y, z, w of them there)."""
    known = current.net
    if not np.array_equal(known.origins, net.origins) or [spline.kind for spline in known.splines] != [
            spline.kind for spline in net.splines]:
        raise Refusal("keys give the points what their net cannot show: leave the net")
    with np.errstate(over='ignore'):
        is_other = ((current.state.positions.astype(np.float32) != net.single).any(1)
                    | (current.state.weights.astype(np.float32) != net.single_weights))
    vertices = np.flatnonzero(is_other & (current.slots >= 0))
    return vertices, np.column_stack([net.positions, net.weights])[vertices]
