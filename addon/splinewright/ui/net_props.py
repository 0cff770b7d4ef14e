"""The numbers of the selected points while a net is edited. Reading and writing them is all they do."""

from contextlib import suppress

import bpy
import numpy as np
from bpy.props import FloatProperty, FloatVectorProperty, PointerProperty

from ..bridge.file_state import look_again
from ..bridge.net import live, selection
from ..core import decimals
from ..core.failures import Refusal
from . import editing

#: Points whose numbers are shown at once: Blender's vectors hold 32 numbers.
SHOWN = 8


def net_of(data):
    """The net object in Edit Mode of a net's data-block, or None."""
    return next((ob for ob in editing.nets() if ob.data == data and ob.mode == 'EDIT'), None)


def chosen(data):
    """(net object, numbers of its selected vertices), or (None, [])."""
    ob, session = net_of(data), live.known_session(data)
    return (ob, selection.selected(ob, session.net)) if ob and session else (None, [])


def _chosen_now(data):
    """chosen(), and numbers up to date: several may be set before Blender tells of the first."""
    ob = net_of(data)
    if ob:
        look_again(data)
        live.pull(ob)
    return chosen(data)


def _exact_rows(data, vertices):
    """(k, 4) float64: x, y, z, w of vertices."""
    state = live.session(data).state
    return np.column_stack([state.positions[vertices], state.weights[vertices]])


def _get_numbers(self):
    ob, vertices = chosen(self.id_data)
    numbers = np.zeros((SHOWN, 4))
    if ob:
        rows = _exact_rows(self.id_data, vertices[:SHOWN])
        numbers[:len(rows)] = rows
    return numbers.ravel()


def _set_numbers(self, numbers):
    data = self.id_data
    ob, vertices = _chosen_now(data)
    if not ob:
        return
    vertices = vertices[:SHOWN]
    rows = _exact_rows(data, vertices)
    wanted = np.array(numbers, np.float32).reshape(SHOWN, 4)[:len(rows)]
    different = wanted != rows.astype(np.float32)
    rows[different] = [decimals.typed(value) for value in wanted[different]]
    changed = np.flatnonzero(different.any(1))
    if len(changed):
        _move(ob, [vertices[i] for i in changed], rows[changed])


def _move(ob, vertices, rows):
    """Nothing happens where the net has lost its points, of which the panel tells."""
    with suppress(Refusal):
        selection.move(ob, live.session(ob.data).net, vertices, rows)


def _get_weight(self):
    ob, vertices = chosen(self.id_data)
    points = _with_weight(self.id_data, vertices) if ob else []
    return float(_exact_rows(self.id_data, points)[:, 3].mean()) if points else 1.0


def _set_weight(self, weight):
    data = self.id_data
    ob, vertices = _chosen_now(data)
    vertices = np.array(_with_weight(data, vertices) if ob else [], np.int64)
    rows = _exact_rows(data, vertices) if ob else np.empty((0, 4))
    different = rows[:, 3].astype(np.float32) != np.float32(weight)
    if different.any():
        rows[:, 3] = decimals.typed(weight)
        _move(ob, vertices[different].tolist(), rows[different])


def _with_weight(data, vertices):
    """Those of the vertices that are points and may be given a weight."""
    vertices = np.array(vertices, np.int64)
    return vertices[live.session(data).net.weighted[vertices]].tolist()


class SplinewrightNet(bpy.types.PropertyGroup):
    """x, y, z and w of the first selected points of a net, and the weight of all of them. A net goes when it is put away:
    keys and drivers on it would not hold, and there are none."""

    numbers: FloatVectorProperty(
        name="Coordinates", description="Coordinates and weights of the selected points, in the shape's own space",
        size=4 * SHOWN, get=_get_numbers, set=_set_numbers, precision=5, options=set())
    weight: FloatProperty(
        name="Weight", description="Weight of all selected points: above 1 pulls the shape nearer",
        get=_get_weight, set=_set_weight, precision=5, step=10, options=set())


CLASSES = (SplinewrightNet,)


def register():
    for owner in (bpy.types.Mesh, bpy.types.Curve):
        owner.splinewright_points = PointerProperty(type=SplinewrightNet)


def unregister():
    for owner in (bpy.types.Mesh, bpy.types.Curve):
        del owner.splinewright_points
