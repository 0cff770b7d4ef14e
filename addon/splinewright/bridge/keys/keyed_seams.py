"""Joints and seams that hold while keys move points: what follows them, and from where, so that a frame is the same whichever came
before it. Kept beside the definition; damaged parts count as missing."""

from dataclasses import replace

import numpy as np

from ...core.joints import held_bounds
from ..data import held, store
from . import point_keys

KEY = "splinewright_keyed_rest"


def applied(data, definition):
    """(a definition in which the joints or seams of a data-block hold, what write() is to keep of it, in words what does not hold as
    smoothly as it is to). Raises Refusal or an error of the library where they cannot."""
    seams = held.read(data, definition)
    if not seams:
        return definition, None, ""
    start = replace(definition, pool=_at_rest(data, definition.pool))
    kept = held_bounds.kept(start, seams, set(point_keys.rows(data)[point_keys.animated(data).any(1)].tolist()))
    after = kept.definition
    rows = np.flatnonzero((after.pool != start.pool).any(1))
    return after, {'rows': rows.tolist(), 'placed': after.pool[rows].ravel().tolist(),
                   'origins': start.pool[rows].ravel().tolist()}, held_bounds.sentence(kept.lost)


def write(data, rest):
    """Keep what applied() gave."""
    if rest is not None and rest['rows']:
        store.assign(data, KEY, rest)
    elif KEY in data.keys():
        del data[KEY]


def rows(data):
    """(k,) of the pool that followed."""
    return _kept(data)[0]


def _at_rest(data, pool):
    """The pool with rows where they were that lie, in float32, as they were placed."""
    found, placed, origins = _kept(data)
    if not len(found) or found.max() >= len(pool):
        return pool
    with np.errstate(over='ignore'):
        lie = (pool[found].astype(np.float32) == placed.astype(np.float32)).all(1)
    before = pool.copy()
    before[found[lie]] = origins[lie]
    return before


def _kept(data):
    """(rows (k,), where they were placed (k, 4), where they had been (k, 4)) that are stored; none where that is damaged."""
    none, group = (np.empty(0, np.int64), np.empty((0, 4)), np.empty((0, 4))), data.get(KEY)
    if not store.is_group(group):
        return none
    try:
        found = np.array(group['rows'], np.int64)
        placed, origins = (np.array(group[name], np.float64).reshape(-1, 4) for name in ('placed', 'origins'))
    except (KeyError, TypeError, ValueError):
        return none
    is_whole = found.ndim == 1 and len(found) == len(placed) == len(origins) and (found >= 0).all()
    return (found, placed, origins) if is_whole and np.isfinite([placed, origins]).all() else none
