"""Over the 3D view: seams, the rows of a cage in two colours, and arrows for directions at infinity."""

import bmesh
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge import versions
from ..bridge.file_state import state
from ..bridge.net import live, net_object
from . import colors, editing, seams_overlay

_handle = None


def draw():
    """Called by Blender for each 3D view."""
    if not bpy.context.space_data.overlay.show_overlays:
        return
    seams_overlay.draw()
    for ob in editing.nets() if state.nets else ():
        if ob.mode == 'EDIT' and ob.visible_get():
            gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
            with gpu.matrix.push_pop():
                gpu.matrix.multiply_matrix(ob.matrix_world)
                _draw_net(ob, live.session(ob.data))
            gpu.state.depth_test_set('NONE')


def _draw_net(ob, current):
    numbers, positions = current.net, current.points
    scale = bpy.context.preferences.system.ui_scale
    for color, pairs in zip(colors.of_net(), numbers.lines):
        draw_lines(color, 1.5 * scale, positions[pairs])
    for foot, head in numbers.arrows:
        draw_lines(colors.of_arrows(), 2.5 * scale, arrow(positions[foot], positions[head]))
    if ob.type == 'MESH':
        _draw_selection(ob, current, scale)


def _draw_selection(ob, current, scale):
    """What Blender drew below our lines: vertices, and edges between selected ones."""
    selected = _selected(ob, len(current.points))
    if selected is None:
        return
    theme = bpy.context.preferences.themes[0].view_3d
    for pairs in current.net.lines:
        draw_lines((*theme.edge_select, 1.0), 2.0 * scale, current.points[pairs[selected[pairs].all(1)]])
    size = (theme.vertex_size + 2) * scale
    _draw_points((*theme.vertex, 1.0), size, current.points[~selected])
    _draw_points((*theme.vertex_select, 1.0), size + 1, current.points[selected])


def _selected(ob, count):
    """(count,) bool in the order of the net's numbers, or None while the net is not whole."""
    vertices = bmesh.from_edit_mesh(ob.data).verts
    number = vertices.layers.int.get(net_object.NUMBER)
    if len(vertices) != count or number is None:
        return None
    selected = np.zeros(count, bool)
    selected[[vertex[number] for vertex in vertices if vertex.select]] = True
    return selected


def arrow(foot, head):
    """(3, 2, 3): the ends of the lines of an arrow."""
    along = head - foot
    length = np.linalg.norm(along)
    if length == 0.0:
        return np.broadcast_to(head, (3, 2, 3))
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    across *= 0.06 * length / np.linalg.norm(across)
    back = head - 0.15 * along
    return np.array([(foot, head), (head, back + across), (head, back - across)])


def draw_lines(color, width, pairs):
    """pairs: (n, 2, 3) ends."""
    if len(pairs):
        shader = gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR')
        shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
        shader.uniform_float('lineWidth', width)
        _draw(shader, 'LINES', color, pairs)


def _draw_points(color, size, positions):
    if len(positions):
        gpu.state.point_size_set(size)
        _draw(gpu.shader.from_builtin(versions.point_shader()), 'POINTS', color, positions)
        gpu.state.point_size_set(1.0)


def _draw(shader, kind, color, positions):
    shader.uniform_float('color', color)
    batch_for_shader(shader, kind, {'pos': np.ascontiguousarray(positions, np.float32).reshape(-1, 3)}).draw(shader)


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
