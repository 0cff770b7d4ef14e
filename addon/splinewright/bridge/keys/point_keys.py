"""Control points with keys or drivers: items of a list on the Mesh or Curve, one for each, which Blender animates.

An item has the number of a row of the definition's pool, and that row in float32. What counts is the definition beside it;
of an item that counts what keys and drivers give. Items keep their places in the list, by which data paths name them.
"""

import re

import numpy as np

from ...core.base.words import phrase
from ...core.shape import keyed_rows
from ..cage import net_object
from ..data import animation, store
from ..data.file_state import state
from ..recipes import recipes

#: The beginning of the data paths of items.
PATH = "splinewright_keyed["
_OF_ITEM = re.compile(r'splinewright_keyed\[(\d+)\]\.(place|weight)')
#: In place of the row of an item whose point is gone.
GONE = -1


def of(data):
    """The items of a data-block."""
    return data.splinewright_keyed


def rows(data):
    """(k,) of each item the row of its point in the pool, or GONE."""
    found = np.full(len(of(data)), GONE, np.int32)
    of(data).foreach_get('row', found)
    return found


def values(data):
    """(k, 4) float32: x, y, z, w of the items, as they are in a data-block or an evaluated one."""
    count = len(of(data))
    places, weights = np.empty(3 * count, np.float32), np.empty(count, np.float32)
    of(data).foreach_get('place', places)
    of(data).foreach_get('weight', weights)
    return np.column_stack([places.reshape(-1, 3), weights])


def animated(data):
    """(k, 4) bool: what of the items keys or drivers give."""
    found = np.zeros((len(of(data)), 4), bool)
    if not len(found):
        return found
    for channel in animation.channels(data):
        item, axis = _meant(channel)
        if 0 <= item < len(found) and 0 <= axis < 4:
            found[item, axis] = True
    return found


def _meant(channel):
    """(the item, 0 to 3 for x, y, z, w) that an F-curve or driver is of; (-1, -1) for those of others."""
    path = channel.data_path
    found = _OF_ITEM.fullmatch(path) if path.startswith(PATH) else None
    if found is None:
        return -1, -1
    return int(found[1]), 3 if found[2] == 'weight' else channel.array_index


def has(data):
    """Whether a point of a data-block has keys or drivers."""
    return len(of(data)) > 0 and any(channel.data_path.startswith(PATH) for channel in animation.channels(data))


def keyed(data):
    """The numbers of the items that have F-curves."""
    found = {_meant(channel)[0] for channel in animation.curves(data)} if len(of(data)) else set()
    return found - {-1}


def count(data):
    """Of how many points there are keys or drivers."""
    return int(animated(data).any(1).sum())


def given(data, evaluated):
    """(the definition with what keys and drivers give to its points, None where it has that; what the shape does not take, or "")."""
    is_given = animated(data)
    chosen = np.flatnonzero(is_given.any(1))
    if not len(chosen) or len(of(evaluated)) != len(is_given):
        return None, ""                 # items have come or gone since it was evaluated: it will be again
    if recipes.has(data):
        return None, "its points are made by a recipe, so keys move none of them: key its numbers"
    definition, of_item = store.read(data), rows(data)
    is_there = (0 <= of_item[chosen]) & (of_item[chosen] < len(definition.pool))
    there = chosen[is_there]
    after, problem = keyed_rows.taken(definition, of_item[there], values(evaluated)[there], is_given[there])
    if not is_there.all():
        problem = problem or phrase("keys are of {points} that the shape has not: use Clear Point Keyframes",
                                    points=_points(int((~is_there).sum())))
    return (None if after is definition else after), problem


def _points(count):
    return phrase("{count} points", one="{count} point", count=count)


def show(data, pool):
    """Let the items show the rows of a definition's pool. Writing the geometry tells Blender of it."""
    if not len(of(data)):
        return
    of_item, shown = rows(data), values(data)
    there = (0 <= of_item) & (of_item < len(pool))
    wanted = shown.copy()
    wanted[there] = np.clip(pool[of_item[there]], -_MOST, _MOST)
    if not np.array_equal(wanted, shown):
        of(data).foreach_set('place', np.ascontiguousarray(wanted[:, :3]).ravel())
        of(data).foreach_set('weight', np.ascontiguousarray(wanted[:, 3]))


_MOST = float(np.finfo(np.float32).max)


def added(data, wanted):
    """The numbers of the items of rows, new ones where there are none."""
    known = {row: i for i, row in enumerate(rows(data).tolist()) if row != GONE}
    for row in wanted:
        if row not in known:
            item = of(data).add()
            item.row = row
            known[row] = len(of(data)) - 1
    return [known[row] for row in wanted]


def put_rows(data, of_item):
    """Let items be of other rows."""
    of(data).foreach_set('row', np.ascontiguousarray(of_item, np.int32))


def stages(data):
    """(k,) of each item the stage of a net that its row is of, by its first number; 0 where no net has others."""
    found = np.zeros(len(of(data)), np.int32)
    of(data).foreach_get('stage', found)
    return found


def put_stage(data, first):
    of(data).foreach_set('stage', np.full(len(of(data)), first, np.int32))


def carry(data, definition):
    """A data-block is given another definition: its items go with their points. Those of points that are gone go, and it
    is told; while a net is out only when that is put away, as undo may bring them back."""
    if not len(of(data)) or not store.has_definition(data):
        return
    try:
        before, of_item = store.read(data), rows(data)
    except store.UnreadableDefinition:
        return
    is_there = (0 <= of_item) & (of_item < len(before.pool))
    found = np.full(len(of_item), GONE)
    found[is_there] = keyed_rows.carried(before, definition, of_item[is_there])[of_item[is_there]]
    kept = np.flatnonzero(found != GONE)
    is_other = (before.pool[of_item[kept], 3] == 0) != (definition.pool[found[kept], 3] == 0)
    found[kept[is_other]] = GONE        # a place is no direction
    put_rows(data, np.where(is_there, found, of_item))
    if net_object.editor(data) is None:
        sweep(data)


def finalize(data):
    """The net of a data-block was put away."""
    if len(of(data)) and not data.library:
        put_stage(data, 0)
        sweep(data)


def sweep(data):
    """Let keys and drivers of points that are gone go, and tell of it."""
    gone = np.flatnonzero(rows(data) == GONE) if len(of(data)) else ()
    if len(gone):
        lost = int(animated(data)[gone].any(1).sum())
        clear(data, gone)
        tell_lost(data, lost)


def tell_lost(data, count):
    """Keep for the next report that keys of this number of points went."""
    if count:
        state.lost_keys.append(phrase("{name}: the keys of {count} went, which became others or are gone",
                                      name=data.name, count=_points(count)))


def clear(data, items, drivers_too=True):
    """Remove the keys, and drivers, of items by their numbers. Items at the end of the list go, too, where nothing is of
    them; others stay, as data paths count them."""
    chosen = set(np.asarray(items).tolist())
    animation.remove(data, lambda channel: _meant(channel)[0] in chosen, drivers_too)
    is_in_use = animated(data).any(1)
    last = len(is_in_use)
    while last and not is_in_use[last - 1]:
        last -= 1
        of(data).remove(last)


def remove(data):
    """A data-block has stopped being a shape."""
    if not len(of(data)):
        return
    of(data).clear()
    if all(path.startswith(PATH) for path in animation.paths(data)):
        data.animation_data_clear()
    else:
        animation.remove(data, lambda channel: channel.data_path.startswith(PATH))
