"""How finely a shape is shown: the settings of its data-block, and the faces they ask for."""

import math

import numpy as np
from mathutils import Matrix

from ...core.base.failures import Refusal
from ...core.base.library import sc
from ...core.verbs import curve_steps
from . import settings
from .settings import ANGLE, AUTOMATIC, BOTH, COUNT, TOLERANCE

#: Automatic faces come as near to a surface as this part of its size, and normals turn by no more on a face, in radians, but where
#: faces are this part of its size already: beside poles, in folds and round sharp bends.
_SHARE, _TURN, _SMALLEST = 1e-3, math.radians(15.0), 1 / 200
#: By so much curves turn at most on a piece of what is shown of them automatically.
_PIECE_TURN = math.radians(4.0)


def of(data):
    """What the settings of a data-block ask for: equal ones, equal faces."""
    chosen = settings.of(data)
    return chosen.mode, chosen.resolution_u, chosen.resolution_v, chosen.tolerance, chosen.angle


def by_count(data):
    """Whether the faces, or the pieces of curves, do not depend on where the points lie."""
    return settings.of(data).mode == COUNT


def steps_of(data, curve):
    """Into how many pieces every span of a curve is cut that a data-block shows."""
    mode, count, _, tolerance, angle = of(data)
    if mode == COUNT:
        return count
    if mode == AUTOMATIC:
        return curve_steps.steps(curve, _PIECE_TURN) or count
    return curve_steps.steps(curve, angle if mode in (ANGLE, BOTH) else None, tolerance if mode in (TOLERANCE, BOTH) else None) or count


def tessellated(data, patch_set):
    """The splinecore Tessellation that the settings ask for. Raises InvalidShape where it cannot be."""
    mode, resolution_u, resolution_v, tolerance, angle = of(data)
    if mode == COUNT:
        return sc.Tessellation(patch_set, (resolution_u, resolution_v))
    if mode == AUTOMATIC:
        size = _size(patch_set)
        return sc.Tessellation.adaptive(patch_set, tolerance=_SHARE * size or None, angle=_TURN, smallest=_SMALLEST * size)
    return sc.Tessellation.adaptive(patch_set, tolerance=tolerance if mode in (TOLERANCE, BOTH) else None,
                                    angle=angle if mode in (ANGLE, BOTH) else None)


def _size(patch_set):
    """The diagonal of the box of the control points; those at infinity have no place."""
    places = patch_set.points[patch_set.weights != 0.0]
    return float(np.linalg.norm(np.ptp(places, axis=0))) if len(places) else 0.0


def of_render(ob, points, scene, depsgraph):
    """The length, in the object's units, that is one pixel where a shape is nearest to the scene's camera.

    points: (n, 3), of the shape. Raises Refusal where the scene has no camera, or none of them is before it.
    """
    camera = scene.camera
    if camera is None:
        raise Refusal("the scene has no camera")
    scale = largest_scale(ob.matrix_world)
    if scale == 0.0:
        raise Refusal("it has a scale of 0: no camera sees it")
    render = scene.render
    width, height = (size * render.resolution_percentage / 100 for size in (render.resolution_x, render.resolution_y))
    window = np.array(camera.calc_matrix_camera(depsgraph, x=round(width), y=round(height), scale_x=render.pixel_aspect_x,
                                                scale_y=render.pixel_aspect_y), dtype=np.float64)
    camera_world = camera.matrix_world.normalized()
    if camera_world.determinant() == 0.0:
        raise Refusal("the camera has a scale of 0")
    to_camera = camera_world.inverted() @ ob.matrix_world
    depth = -(np.array(to_camera, dtype=np.float64)[2, :3] @ points.T + to_camera[2][3])
    # The window's matrix leads to clip space, which is 2 wide and divided by w: the depth, or 1 where all is parallel.
    is_perspective = window[3, 3] == 0.0
    start = camera.data.clip_start if camera.type == 'CAMERA' else 0.0
    seen = depth[depth >= start]
    if not len(seen):
        raise Refusal("the shape lies behind the camera")
    distance = seen.min() if is_perspective else 1.0
    pixel = distance * min(2 / (width * window[0, 0]), 2 / (height * window[1, 1]))
    return float(pixel / scale)


def largest_scale(matrix: Matrix):
    """By how much a matrix lengthens what it lengthens most."""
    return float(np.linalg.svd(np.array(matrix.to_3x3(), dtype=np.float64), compute_uv=False)[0])
