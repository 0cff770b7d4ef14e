"""Keys of points while a net is out: which are of which point in its stages, and digits that the net does not hold."""

from contextlib import contextmanager

import numpy as np

from ...core.shape import keyed_rows
from ..data import store
from ..keys import keyed_seams, point_keys


def with_digits(data, net, definition):
    """What a net says, in which points with keys, and what follows them beside seams, have all their digits where they lie
    as the shape has them."""
    if not len(point_keys.of(data)):
        return definition
    rows = np.union1d(point_keys.rows(data), keyed_seams.rows(data))
    rows = rows[(0 <= rows) & (rows < len(definition.pool))]
    return keyed_rows.as_present(net, definition, store.pool(data), rows)


@contextmanager
def staged(data, current):
    """While a shape gets another definition because its net is of another stage: items of points that were there before
    are of these again."""
    if not len(point_keys.of(data)):
        yield
        return
    first = current.stage.net.first
    for was in np.unique(point_keys.stages(data)).tolist():
        current.keyed_rows[was] = point_keys.rows(data)
    yield
    known = current.keyed_rows.get(first)
    if known is not None:
        now = point_keys.rows(data)
        now[:len(known)] = np.where(known[:len(now)] != point_keys.GONE, known[:len(now)], now[:len(known)])
        point_keys.put_rows(data, now)
        point_keys.show(data, store.pool(data))
    point_keys.put_stage(data, first)
