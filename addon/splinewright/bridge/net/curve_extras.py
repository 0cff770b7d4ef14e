"""What lies along curves while their net is out: handle types, radius and tilt stay with the points that they are of."""

import numpy as np

from ...core.net import handles
from ...core.shape import definition as definitions
from ..cage import net_splines
from ..curve import handles as kept_types
from ..data import store
from ..shape import curve_pieces, shape


def has_types(data):
    """Whether a shape has handle types at some of its joints."""
    return any(kept_types.known(data))


def keep_types(data, ob, current, definition, were_said):
    """Let a shape have the handle types that its net shows; where it lacks a point, those that were there. were_said: for
    some of its joints, before it was given this definition."""
    if not current.net.chains:
        return
    known, there = kept_types.of_pieces(data, definition), current.slots >= 0
    letters = np.zeros(len(there), '<U1') if there.all() else handles.of_net(current.net, known)
    letters[there] = net_splines.letters(ob.data)[current.slots[there]]
    types = handles.of_vertices(current.net, letters)
    if any(known) or not were_said:     # otherwise it has others than those for which they were said
        types = handles.said(definition, types, known)
    if types != known:
        kept_types.write(data, types)


def show(data, definition):
    """Give a shape of curves another definition: what lies along them stays in its place where they gain or lose spans."""
    before = store.read(data)
    if definitions.have_same_pieces(before, definition) or len(before.pieces) != len(definition.pieces):
        shape.set_definition(data, definition)
        return
    pieces = curve_pieces.of(data, before)
    shape.set_definition(data, definition)
    curve_pieces.write(data, definition, curve_pieces.regrown(pieces, before, definition), is_kept=True)
