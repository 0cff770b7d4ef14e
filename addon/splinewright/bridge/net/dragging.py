"""Steps of a drag in which positions of a net are others than in the step before, and nothing else is.

What live.sync_from_cage() makes sure of at any change holds from step to step while their occasion is the same: such a step reads, works
out and writes positions, and leaves the rest alone.
"""

from typing import Any, NamedTuple

from ..cage import cage, net_object
from ..data import held
from ..data.file_state import ended_operators, key, look_again, state
from ..keys import point_keys
from ..recipes import recipes
from ..shape import shape
from . import keyed, live


class Drag(NamedTuple):
    """A net of patches and its shape, in a step of which live.sync_from_cage() saw to all."""

    occasion: tuple
    ob: Any
    data: Any
    current: live.Session
    typed: Any                          # as of net_object.typed()


def occasion(updates):
    """Facts that stay the same while one gesture lasts and nobody else does anything: the operators that have ended, and what of
    which data-blocks Blender says it has evaluated again."""
    return ended_operators(), [(update.id.as_pointer(), update.is_updated_geometry, update.is_updated_transform)
                               for update in updates]


def begin(ob, occasion):
    """Let goes_on() follow a net that was just pulled, if nothing but its points has a say in its shape."""
    data, current = net_object.shape_of(ob).data, live.session(ob.data)
    is_plain = (current.last is not None and current.is_dragged and not live.problem(ob) and not live.note(ob)
                and not current.is_waiting and not recipes.has(data) and not held.has(data)
                and not len(point_keys.of(data)) and not keyed.has_keys(data))
    state.drag = Drag(occasion, ob, data, current, net_object.typed(ob.data, current.net)) if is_plain else None


def goes_on(occasion):
    """Whether this was a step like the one before, which is done then. Whatever is otherwise, or goes wrong, is left to
    live.sync_from_cage(), which says it."""
    drag = state.drag
    if drag is None or drag.occasion != occasion:
        return False
    try:
        is_done = _step(drag)
    except Exception:
        is_done = False
    state.drag = drag if is_done else None      # what is written ends a drag, but not its own
    return is_done


def _step(drag):
    _, ob, data, current, typed = drag
    last, said = current.last, cage.snapshot(ob, current.last.said)
    again = last.again(current.net, said, typed) if said is not None and said.slots is not None else None
    if again is None:
        return False
    look_again(ob.data)
    state.touched.pop(key(data), None)
    found, definition = again
    current.take(found.state, found.slots)
    current.look_at(data)
    shape.require_writable(data)
    moved = current.moved_on(current.patch_set(definition), last.rows)
    if moved is None:
        return False
    live.show_moved(data, definition, moved, current, current.stamp)
    return True
