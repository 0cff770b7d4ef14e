"""Keys of control points set and taken away by hand."""

from contextlib import suppress

import numpy as np

from ...core.base.failures import Refusal, blenders_refusals
from ...core.shape import keyed_rows
from ..data import problems, store
from ..keys import point_keys
from ..recipes import recipes
from ..shape import shape
from . import keyed_net, live


def require_free(data):
    """Raises Refusal where points of a data-block cannot have keys."""
    if recipes.has(data):
        raise Refusal("{name} is made by a recipe: key its numbers in the panel, or use Apply Construction first", name=data.name)
    shape.require_writable(data)
    action = data.animation_data.action if data.animation_data else None
    if action is not None and (action.library or action.override_library):
        raise Refusal("the keys of {name} are linked from another file: make them local first", name=data.name)


def insert(data, rows, frame, place=True, weight=True):
    """Set keys of rows at a frame as they are; how many points got any. Raises Refusal, and changes nothing, where that
    cannot be."""
    require_free(data)
    definition = store.read(data)
    rows = np.unique(np.asarray(rows, np.int64))
    keyed_rows.require_single(definition.pool, rows)
    has_weight = keyed_rows.weighted(definition) & weight
    rows = rows[place | has_weight[rows]]
    if not len(rows):
        raise Refusal("these points have no weights: tangents, points of Hermite pieces and directions have none")
    items = point_keys.added(data, rows.tolist())
    _mark_stage(data)
    point_keys.show(data, definition.pool)
    for item, row in zip(items, rows.tolist()):
        for name in ['place'] * place + ['weight'] * bool(has_weight[row]):
            with blenders_refusals():
                data.keyframe_insert(f"{point_keys.PATH}{item}].{name}", frame=frame, group=f"Point {row}")
    return len(rows)


def _mark_stage(data):
    held = keyed_net.held_net(data)
    if held is not None:
        point_keys.put_stage(data, live.session(held.data).stage.net.first)


def clear(data, rows=None, frame=None):
    """Take keys of rows, or of all points, away, of one frame where it is given; of how many points there were any."""
    require_free(data)
    of_item = point_keys.rows(data)
    chosen = np.flatnonzero(np.ones(len(of_item), bool) if rows is None else np.isin(of_item, rows))
    if frame is not None:
        return len({item for item in chosen.tolist() if _clear_frame(data, item, frame)})
    keyed = point_keys.keyed(data)
    point_keys.clear(data, chosen, drivers_too=False)
    problems.set_problem(data, problems.KEYED, "")             # it is told again if it still is so
    return len(keyed.intersection(chosen.tolist()))


def _clear_frame(data, item, frame):
    """Whether an item had keys at a frame."""
    had = False
    for name in ('place', 'weight'):
        with suppress(RuntimeError, TypeError):         # there are none
            had |= data.keyframe_delete(f"{point_keys.PATH}{item}].{name}", frame=frame)
    return had


def put(data, row, place, weight):
    """Move a point by hand to what an item says, other than the shape has it in float32; keys hold from the next frame on.

    Raises Refusal or an error of the library, and changes nothing, where nothing results.
    """
    require_free(data)
    definition = store.read(data)
    if not 0 <= row < len(definition.pool):
        raise Refusal("{name} has no point {row} any more", name=data.name, row=row)
    given = np.array([[*place, weight]], np.float32)
    after, problem = keyed_rows.taken(definition, np.array([row]), given, np.ones((1, 4), bool))
    if problem:
        raise Refusal(problem)
    if after is not definition:
        keyed_net.set_definition(data, after)


def rows_of(net, data, vertices):
    """(k,) rows of a shape's pool that vertices of its net stand for; -1 for feet."""
    found = {-1: -1}
    for one, other in zip(net.definition.pieces, store.read(data).pieces):
        if one.indices.shape == other.indices.shape:
            found.update(zip(one.indices.ravel().tolist(), other.indices.ravel().tolist()))
    return [found.get(row, -1) for row in net.rows[vertices].tolist()]
