"""The seams of the patch shape in hand, coloured along them by how smoothly the surface goes on."""

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge import store, surveys
from ..core import seams
from . import colors, hand, strokes


def shape_in_hand(ob):
    """The patch shape that is active, or whose net is; None where there is none."""
    owner = hand.shape_of(ob)
    return owner if owner is not None and owner.type == 'MESH' else None


def draw():
    """In the 3D view at hand."""
    ob = shape_in_hand(bpy.context.object)
    if ob is None or not ob.data.splinewright.show_seams or not ob.visible_get():
        return
    try:
        lines = coloured_lines(ob.data)
    except store.UnreadableDefinition:
        return
    gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
    with gpu.matrix.push_pop(), strokes.nearer():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        for points, of_points in lines:
            _draw_line(points, of_points)
    gpu.state.depth_test_set('NONE')


def coloured_lines(data):
    """[(points (n, 3), colours (n, 4))] of the seams of a Mesh."""
    found, of_class = [], colors.of_seams()
    measured, size = surveys.seams_of(data)
    for seam in measured:
        if seam.measured is not None:
            numbers = seams.classes(seam.measured, size)
            found.append((seam.measured.points.astype(np.float32),
                          np.array([of_class[number] for number in numbers.tolist()], np.float32)))
    return found


def _draw_line(points, of_points):
    shader = gpu.shader.from_builtin('POLYLINE_SMOOTH_COLOR')
    shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
    shader.uniform_float('lineWidth', 4.0 * bpy.context.preferences.system.ui_scale)
    finite = np.isfinite(points).all(1)
    if finite.sum() > 1:
        batch_for_shader(shader, 'LINE_STRIP', {'pos': points[finite], 'color': of_points[finite]}).draw(shader)
