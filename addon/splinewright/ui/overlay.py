"""Over the 3D view: seams, the rows of a cage in two colours, and arrows for directions at infinity."""

from typing import Callable, NamedTuple

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge.file_state import key, state
from ..bridge.net import live, selection
from . import editing, seams_overlay

#: As Blender colours the two directions of its own surfaces: u yellow, v magenta.
COLORS = ((0.95, 0.78, 0.1, 1.0), (0.9, 0.25, 0.75, 1.0))
ARROW_COLOR = (0.2, 0.9, 0.95, 1.0)

_handle = None


def draw():
    """Called by Blender for each 3D view."""
    if not bpy.context.space_data.overlay.show_overlays:
        return
    seams_overlay.draw()
    for ob in editing.nets() if state.nets else ():
        if ob.mode == 'EDIT' and ob.visible_get():
            current = live.known_session(ob.data)
            if current is not None:
                _draw_net(ob, current)


def _draw_net(ob, current):
    """What there is to draw is worked out once, until Blender tells of a change of the net."""
    name = key(ob.data)
    if name not in state.drawn:
        state.drawn[name] = _picture(ob, current)
    gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        scale = bpy.context.preferences.system.ui_scale
        for stroke in state.drawn[name]:
            _draw_stroke(stroke, scale)
    gpu.state.depth_test_set('NONE')


class _Stroke(NamedTuple):
    """Lines or points that are drawn alike."""

    batch: gpu.types.GPUBatch
    is_lines: bool
    color: Callable                     # gives the colour now: themes change
    size: Callable                      # of lines or points, on an interface that is not scaled


def _picture(ob, current):
    """The strokes of a net, those that lie above others last."""
    net, points = current.net, current.points
    strokes = [_lines(points[pairs], lambda color=color: color, 1.5) for color, pairs in zip(COLORS, net.lines)]
    arrows = [arrow(points[foot], points[head]) for foot, head in net.arrows]
    strokes.append(_lines(np.array(arrows).reshape(-1, 2, 3), lambda: ARROW_COLOR, 2.5))
    if ob.type == 'MESH':
        strokes += _selection(ob, current)
    return [stroke for stroke in strokes if stroke]


def _selection(ob, current):
    """What Blender drew below our lines: vertices, and edges between selected ones."""
    net, points, are_there = current.net, current.points, current.places >= 0
    selected = np.zeros(len(points), bool)
    selected[selection.every_selected(ob, net)] = True
    for pairs in net.lines:
        yield _lines(points[pairs[selected[pairs].all(1)]], lambda: (*_theme().edge_select, 1.0), 2.0)
    yield _points(points[are_there & ~selected], lambda: (*_theme().vertex, 1.0), lambda: _theme().vertex_size + 2)
    yield _points(points[selected], lambda: (*_theme().vertex_select, 1.0), lambda: _theme().vertex_size + 3)


def _theme():
    return bpy.context.preferences.themes[0].view_3d


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


def _lines(pairs, color, width):
    """pairs: (n, 2, 3) ends."""
    return _Stroke(_batch(_line_shader(), 'LINES', pairs), True, color, lambda: width) if len(pairs) else None


def _points(positions, color, size):
    return _Stroke(_batch(_point_shader(), 'POINTS', positions), False, color, size) if len(positions) else None


def _batch(shader, kind, positions):
    return batch_for_shader(shader, kind, {'pos': np.ascontiguousarray(positions, np.float32).reshape(-1, 3)})


def _line_shader():
    return gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR')


def _point_shader():
    # Blender 5 has a shader of its own for points.
    return gpu.shader.from_builtin('POINT_UNIFORM_COLOR' if bpy.app.version >= (5, 0, 0) else 'UNIFORM_COLOR')


def _draw_stroke(stroke, scale):
    shader = _line_shader() if stroke.is_lines else _point_shader()
    if stroke.is_lines:
        shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
        shader.uniform_float('lineWidth', stroke.size() * scale)
    else:
        gpu.state.point_size_set(stroke.size() * scale)
    shader.uniform_float('color', stroke.color())
    stroke.batch.draw(shader)
    gpu.state.point_size_set(1.0)


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
