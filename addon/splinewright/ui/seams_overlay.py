"""The seams of the active patch shape, colored along them by how smoothly the surface continues."""

import bpy
import gpu
import numpy as np

from ..bridge.analysis import overlays, surveys
from ..core.analysis import lines
from ..core.joints import seams
from . import active_shape, colors, line_batches

#: Pixels of a seam and of the rim on either side, on an interface that is not scaled.
_WIDTH, _RIM = 4.0, 1.5


def patch_shape_of(ob):
    """The patch shape that is active, or whose net is; None where there is none."""
    owner = active_shape.shape_of(ob)
    return owner if owner is not None and owner.type == 'MESH' else None


def draw():
    """Called by Blender for each 3D view."""
    if not bpy.context.space_data.overlay.show_overlays:
        return
    ob = patch_shape_of(bpy.context.object)
    if ob is None or not ob.data.splinewright.show_seams or not ob.visible_get():
        return
    prepared = overlays.kept(ob.data, 'seams', tuple(colors.of_seams().values()), _strokes)
    gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
    with gpu.matrix.push_pop(), line_batches.nearer():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        line_batches.draw(prepared or ())
    gpu.state.depth_test_set('NONE')


def _strokes(data, *_):
    """Those of the seams of a Mesh, with a rim that tells them from all other lines."""
    pairs, shades = [lines.NONE], [np.empty((0, 2, 4))]
    for points, of_points in colored_lines(data):
        ends = np.stack([points[:-1], points[1:]], 1)
        is_whole = np.isfinite(ends).all((1, 2))
        pairs.append(ends[is_whole])
        shades.append(np.stack([of_points[:-1], of_points[1:]], 1)[is_whole])
    pairs, shades = np.concatenate(pairs), np.concatenate(shades)
    return [line_batches.lines(pairs, lambda: colors.SEAM_RIM, _WIDTH + 2 * _RIM), line_batches.colored(pairs, shades, _WIDTH)]


def colored_lines(data):
    """[(points (n, 3), colors (n, 4))] of the seams of a Mesh, and of the creases inside its patches."""
    found, of_class = [], colors.of_seams()
    measured, size = surveys.seams_of(data)
    for line in measured:
        numbers = seams.classes(line, size)
        found.append((line.points.astype(np.float32), np.array([of_class[number] for number in numbers.tolist()], np.float32)))
    return found
