"""The rows of a cage in two colours, and arrows for directions at infinity, over the 3D view."""

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge import live
from . import editing

#: As Blender colours the two directions of its own surfaces: u yellow, v magenta.
COLORS = ((0.95, 0.78, 0.1, 1.0), (0.9, 0.25, 0.75, 1.0))
ARROW_COLOR = (0.2, 0.9, 0.95, 1.0)
_WIDTH = 2.5

_handle = None


def draw():
    """Called by Blender for each 3D view."""
    if not editing.known or not bpy.context.space_data.overlay.show_overlays:
        return
    shader = gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR')
    shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
    shader.uniform_float('lineWidth', _WIDTH * bpy.context.preferences.system.ui_scale)
    for ob in editing.nets():
        if ob.mode == 'EDIT' and ob.visible_get():
            _draw_net(shader, ob)


def _draw_net(shader, ob):
    current = live.session(ob.data)
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        for color, pairs in zip(COLORS, current.net.lines):
            _draw_lines(shader, color, current.positions[pairs].reshape(-1, 3))
        for foot, head in current.net.arrows:
            _draw_lines(shader, ARROW_COLOR, arrow(current.positions[foot], current.positions[head]))


def arrow(foot, head):
    """(6, 3): ends of the lines of an arrow."""
    along = head - foot
    length = np.linalg.norm(along)
    if length == 0.0:
        return np.repeat(head[None], 6, 0)
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    across *= 0.06 * length / np.linalg.norm(across)
    back = head - 0.15 * along
    return np.array([foot, head, head, back + across, head, back - across], np.float32)


def _draw_lines(shader, color, ends):
    if len(ends):
        shader.uniform_float('color', color)
        batch_for_shader(shader, 'LINES', {'pos': np.ascontiguousarray(ends, np.float32)}).draw(shader)


CLASSES = ()


def register():
    global _handle
    if not bpy.app.background:
        _handle = bpy.types.SpaceView3D.draw_handler_add(draw, (), 'WINDOW', 'POST_VIEW')


def unregister():
    global _handle
    if _handle is not None:
        bpy.types.SpaceView3D.draw_handler_remove(_handle, 'WINDOW')
        _handle = None
