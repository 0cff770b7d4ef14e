"""Where a gesture of the add-on snaps to, as the magnet in the header says."""

import bpy
import numpy as np

from . import picking

#: To what of the face at the mouse, best first.
_ELEMENTS = ('VERTEX', 'EDGE_MIDPOINT', 'EDGE', 'FACE')
#: How near in pixels.
_NEAR = 15.0


def is_on(event):
    """Ctrl turns the magnet round."""
    return bpy.context.scene.tool_settings.use_snap != event.ctrl


def takes_steps():
    """Whether the magnet holds to steps where nothing else is near: not where it is set to parts of other objects alone."""
    elements = bpy.context.scene.tool_settings.snap_elements
    return bool({'INCREMENT', 'GRID'} & set(elements)) or not set(_ELEMENTS) & set(elements)


def place_at(context, region, view, pixel, ignored):
    """(3,): the place in the world at a pixel of a region on other objects than the ignored; None where none is near, or the
    magnet holds to steps."""
    elements = [name for name in _ELEMENTS if name in context.scene.tool_settings.snap_elements]
    hit = _face_at(context, region, view, pixel, ignored) if elements else None
    if hit is None:
        return None
    place, corners = hit
    for name in elements:
        places = np.array([place]) if name == 'FACE' else _places(name, corners, place)
        if not len(places):
            continue
        away = np.linalg.norm(picking.on_screen(region, view, np.eye(4), places) - pixel, axis=1)
        away[np.isnan(away)] = np.inf
        if away.min() <= picking.near(_NEAR):
            return places[away.argmin()]
    return None


def _face_at(context, region, view, pixel, ignored):
    """(where the face at a pixel is met (3,), its corners (n, 3)), in the world; None over nothing."""
    depsgraph = context.evaluated_depsgraph_get()
    found = picking.face_seen(context, region, view, pixel, depsgraph, ignored)
    if found is None:
        return None
    ob, face, place = found
    shown = ob.evaluated_get(depsgraph)
    if ob.type != 'MESH' or face >= len(shown.data.polygons):
        return np.array(place), np.empty((0, 3))
    corners = [shown.matrix_world @ shown.data.vertices[i].co for i in shown.data.polygons[face].vertices]
    return np.array(place), np.array(corners)


def _places(name, corners, place):
    """The corners of a face, the middles of its edges, or on each edge the nearest point to a place."""
    if name == 'VERTEX':
        return corners
    along = np.roll(corners, -1, axis=0) - corners
    if name == 'EDGE_MIDPOINT':
        return corners + along / 2
    length = np.maximum((along * along).sum(1), np.finfo(np.float64).tiny)
    return corners + np.clip(((place - corners) * along).sum(1) / length, 0, 1)[:, None] * along
