"""The weights of a net's selected points, in Edit Mode."""

import numpy as np

from ...core.base.failures import Refusal
from . import live, selection


def weighted(data, vertices):
    """Those of the vertices of a net's data-block that are points and may be given a weight."""
    vertices = np.array(vertices, np.int64)
    return vertices[live.session(data).net.weighted[vertices]].tolist()


def of_selected(ob):
    """(vertices, their weights (k,) float64) of a net: its selected points that have one."""
    session = live.known_session(ob.data)
    if session is None:
        return [], np.empty(0)
    vertices = weighted(ob.data, selection.selected(ob, session.net))
    return vertices, session.state.weights[vertices]


def put(ob, vertices, weights, is_passing=False):
    """Give vertices weights, and their shape the result. is_passing: others follow at once, as in a drag.

    Raises Refusal where the net or its shape does not take them; the net has them then.
    """
    current = live.session(ob.data)
    rows = np.column_stack([current.state.positions[vertices], weights])
    (selection.place if is_passing else selection.move)(ob, current.net, vertices, rows)
    live.sync_from_cage(ob)
    if live.problem(ob):
        raise Refusal(live.problem(ob))
