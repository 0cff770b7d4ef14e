"""The axis of the active surface of revolution, as a line in the 3D views."""

import bpy
import gpu
import numpy as np

from ..bridge import recipes, shape, store
from . import strokes

_COLOR = (1.0, 0.62, 0.1, 0.9)
_WIDTH = 1.5
#: How far the line goes on beyond the surface, in parts of its size.
_BEYOND = 0.15


def line_of(ob):
    """(2, 3): the ends of the axis in the world, or None where an object is no surface of revolution that is seen."""
    if ob is None or ob.mode != 'OBJECT' or not ob.visible_get() or not shape.has_shape(ob):
        return None
    if recipes.kind(ob.data) != 'revolve':
        return None
    try:
        values = recipes.parameters(ob.data)
    except store.UnreadableDefinition:
        return None
    k = "xyz".index(values['axis'])
    ends = np.array([[values[f"offset_{name}"] for name in "xyz"]] * 2)
    box = np.array(ob.bound_box)
    low, high = box.min(0), box.max(0)
    gap = _BEYOND * (high - low).max()
    ends[:, k] = low[k] - gap, high[k] + gap
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    return ends @ matrix[:3, :3].T + matrix[:3, 3]


def draw():
    """Called by Blender for each 3D view."""
    line = line_of(bpy.context.object) if bpy.context.space_data.overlay.show_overlays else None
    if line is None:
        return
    gpu.state.blend_set('ALPHA')
    strokes.draw([strokes.lines(line[None], lambda: _COLOR, _WIDTH)])
    gpu.state.blend_set('NONE')
