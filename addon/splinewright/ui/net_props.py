"""The numbers of the selected points while a net is edited. Reading and writing them is all they do."""

from contextlib import suppress

import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty, FloatVectorProperty, PointerProperty

from ..bridge.data.file_state import look_again
from ..bridge.net import live, selection, weighing
from ..core.base import decimals
from ..core.base.failures import Refusal
from . import editing

#: Points whose numbers are shown at once: Blender's vectors hold 32 numbers.
SHOWN = 8
#: Parts of the largest coordinate that come of rounding.
_ROUNDING = 1e-15


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
        live.sync_from_cage(ob)
    return chosen(data)


def _exact_rows(data, vertices):
    """(k, 4) float64: x, y, z, w of vertices."""
    state = live.session(data).state
    return np.column_stack([state.positions[vertices], state.weights[vertices]])


def _get_numbers(self):
    ob, vertices = chosen(self.id_data)
    numbers = np.zeros((SHOWN, 4))
    if ob:
        rows = _seen(self, ob, _exact_rows(self.id_data, vertices[:SHOWN]))
        numbers[:len(rows)] = rows
    return numbers.ravel()


def _seen(self, ob, rows):
    """Rows x, y, z, w in the space that was chosen; roundings and -0 are 0."""
    seen = rows.copy()
    if self.space == 'GLOBAL':
        matrix = np.array(ob.matrix_world, dtype=np.float64)
        seen[:, :3] = seen[:, :3] @ matrix[:3, :3].T + matrix[:3, 3]
    size = np.abs(seen[:, :3]).max(initial=0.0)
    seen[:, :3][np.abs(seen[:, :3]) <= _ROUNDING * size] = 0.0
    return seen + 0.0


def _put(self, ob, vertices, rows, seen, wanted):
    """Move vertices from the shown places to the wanted ones; nothing where these are the same."""
    changed = np.flatnonzero((wanted != seen).any(1))
    if not len(changed):
        return
    rows = rows.copy()
    if self.space == 'GLOBAL':
        matrix = np.array(ob.matrix_world, dtype=np.float64)
        if not abs(np.linalg.det(matrix[:3, :3])) > 0.0:
            return
        wanted = wanted.copy()
        wanted[:, :3] = (wanted[:, :3] - matrix[:3, 3]) @ np.linalg.inv(matrix[:3, :3]).T
        rows[changed] = wanted[changed]
    else:
        rows = np.where(wanted != seen, wanted, rows)
    _move(ob, [vertices[i] for i in changed], rows[changed])


def _get_median(self):
    ob, vertices = chosen(self.id_data)
    return _seen(self, ob, _exact_rows(self.id_data, vertices))[:, :3].mean(0) if ob and len(vertices) else np.zeros(3)


def _set_median(self, median):
    ob, vertices = _chosen_now(self.id_data)
    if not ob or not len(vertices):
        return
    rows = _exact_rows(self.id_data, vertices)
    seen = _seen(self, ob, rows)
    was = seen[:, :3].mean(0)
    steps = [decimals.typed(to) - at if np.float32(to) != np.float32(at) else 0.0 for to, at in zip(median, was)]
    _put(self, ob, vertices, rows, seen, seen + [*steps, 0.0])


def _set_numbers(self, numbers):
    data = self.id_data
    ob, vertices = _chosen_now(data)
    if not ob:
        return
    vertices = vertices[:SHOWN]
    rows = _exact_rows(data, vertices)
    seen = _seen(self, ob, rows)
    typed, wanted = np.array(numbers, np.float32).reshape(SHOWN, 4)[:len(rows)], seen.copy()
    different = typed != seen.astype(np.float32)
    wanted[different] = [decimals.typed(value) for value in typed[different]]
    _put(self, ob, vertices, rows, seen, wanted)


def _move(ob, vertices, rows):
    """Nothing happens where the net has lost its points, of which the panel tells."""
    with suppress(Refusal):
        selection.move(ob, live.session(ob.data).net, vertices, rows)


def _get_weight(self):
    ob, vertices = chosen(self.id_data)
    points = weighing.weighted(self.id_data, vertices) if ob else []
    return float(_exact_rows(self.id_data, points)[:, 3].mean()) if points else 1.0


def _set_weight(self, weight):
    data = self.id_data
    ob, vertices = _chosen_now(data)
    vertices = np.array(weighing.weighted(data, vertices) if ob else [], np.int64)
    rows = _exact_rows(data, vertices) if ob else np.empty((0, 4))
    different = rows[:, 3].astype(np.float32) != np.float32(weight)
    if different.any():
        rows[:, 3] = decimals.typed(weight)
        _move(ob, vertices[different].tolist(), rows[different])


class SplinewrightNet(bpy.types.PropertyGroup):
    """x, y, z and w of the first selected points of a net, and the weight of all of them. A net goes when it is put away:
    keys and drivers on it would not hold, and there are none."""

    numbers: FloatVectorProperty(
        name="Coordinates", description="Coordinates and weights of the selected points",
        size=4 * SHOWN, get=_get_numbers, set=_set_numbers, precision=5, options=set())
    median: FloatVectorProperty(
        name="Median", description="The mean of the selected points and handles: all move with it",
        size=3, get=_get_median, set=_set_median, precision=5, options=set())
    space: EnumProperty(
        name="Space", description="In which space coordinates are shown and typed", options=set(), items=(
            ('LOCAL', "Local", "The shape's own space"), ('GLOBAL', "Global", "The world")))
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
