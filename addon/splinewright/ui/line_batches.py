"""Lines and points, prepared once and drawn many times."""

from collections.abc import Callable
from contextlib import contextmanager
from typing import NamedTuple

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

from ..bridge.data import versions

#: Within nearer() all is nearer to the eye by this part of its distance.
_NEARER = 2e-3


class Stroke(NamedTuple):
    """Lines or points that are drawn alike, but for their own colors."""

    batch: gpu.types.GPUBatch
    is_lines: bool
    color: Callable                     # gives the color now: themes and preferences change; None: each has its own
    size: Callable                      # gives that of lines or points, on an interface that is not scaled


def lines(pairs, color, width):
    """The Stroke of pairs (n, 2, 3) of ends, or None where there are none."""
    return Stroke(_batch(_line_shader(), 'LINES', pairs), True, color, lambda: width) if len(pairs) else None


def colored(pairs, colors, width):
    """The Stroke of pairs (n, 2, 3) of ends that have colors (n, 2, 4), or None where there are none."""
    if not len(pairs):
        return None
    batch = batch_for_shader(_colored_shader(), 'LINES', {
        'pos': np.ascontiguousarray(pairs, np.float32).reshape(-1, 3),
        'color': np.ascontiguousarray(colors, np.float32).reshape(-1, 4)})
    return Stroke(batch, True, None, lambda: width)


def points(positions, color, size):
    """The Stroke of positions (n, 3), or None where there are none."""
    return Stroke(_batch(_point_shader(), 'POINTS', positions), False, color, size) if len(positions) else None


def arrows(pairs, color):
    """The Stroke of pairs of foot and head, or None where there are none."""
    found = [_arrow(foot, head) for foot, head in pairs]
    return lines(np.array(found).reshape(-1, 2, 3), color, 2.5)


def _arrow(foot, head):
    """(5, 2, 3): the ends of the lines of an arrow. Its barbs lie in two planes: one at least is seen from any side."""
    along = head - foot
    length = np.linalg.norm(along)
    if length == 0.0:
        return np.broadcast_to(head, (5, 2, 3))
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    sides = [0.06 * length * side / np.linalg.norm(side) for side in (across, np.cross(along, across))]
    back = head - 0.15 * along
    return np.array([(foot, head), *((head, back + sign * side) for side in sides for sign in (1, -1))])


@contextmanager
def nearer(part=1.0):
    """While this is drawn in the current 3D view, the surface on which it lies does not hide it; nor drawings by a
    smaller part of that nearer."""
    with gpu.matrix.push_pop_projection():
        distance = bpy.context.region_data.view_distance
        gpu.matrix.load_projection_matrix(_nearer(gpu.matrix.get_projection_matrix(), distance, part * _NEARER))
        yield


def _nearer(projection, distance, part):
    """The projection with everything nearer to the eye by a part, in the same place of the picture."""
    if projection[3][3] == 0.0:
        return projection @ Matrix.Scale(1.0 - part, 4)
    return projection @ Matrix.Translation((0.0, 0.0, part * distance))


def draw(strokes):
    """What comes later lies above what lies as far from the eye."""
    scale = bpy.context.preferences.system.ui_scale
    was_written = gpu.state.depth_mask_get()
    gpu.state.depth_mask_set(False)
    gpu.state.blend_set('ALPHA')        # edges of lines are smooth by it
    for stroke in filter(None, strokes):
        _draw(stroke, scale)
    gpu.state.blend_set('NONE')
    gpu.state.depth_mask_set(was_written)


def _batch(shader, kind, positions):
    return batch_for_shader(shader, kind, {'pos': np.ascontiguousarray(positions, np.float32).reshape(-1, 3)})


def _line_shader():
    return gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR')


def _colored_shader():
    return gpu.shader.from_builtin('POLYLINE_SMOOTH_COLOR')


def _point_shader():
    return gpu.shader.from_builtin(versions.point_shader())


def _draw(stroke, scale):
    of_lines = _line_shader if stroke.color else _colored_shader
    shader = of_lines() if stroke.is_lines else _point_shader()
    if stroke.is_lines:
        shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
        shader.uniform_float('lineWidth', stroke.size() * scale)
    else:
        gpu.state.point_size_set(stroke.size() * scale)
    if stroke.color:
        shader.uniform_float('color', stroke.color())
    stroke.batch.draw(shader)
    gpu.state.point_size_set(1.0)
