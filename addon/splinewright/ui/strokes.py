"""Lines and points of one colour each, prepared once and drawn many times."""

from collections.abc import Callable
from typing import NamedTuple

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge import versions


class Stroke(NamedTuple):
    """Lines or points that are drawn alike."""

    batch: gpu.types.GPUBatch
    is_lines: bool
    color: Callable                     # gives the colour now: themes and preferences change
    size: Callable                      # gives that of lines or points, on an interface that is not scaled


def lines(pairs, color, width):
    """The Stroke of pairs (n, 2, 3) of ends, or None where there are none."""
    return Stroke(_batch(_line_shader(), 'LINES', pairs), True, color, lambda: width) if len(pairs) else None


def points(positions, color, size):
    """The Stroke of positions (n, 3), or None where there are none."""
    return Stroke(_batch(_point_shader(), 'POINTS', positions), False, color, size) if len(positions) else None


def draw(strokes):
    scale = bpy.context.preferences.system.ui_scale
    for stroke in filter(None, strokes):
        _draw(stroke, scale)


def _batch(shader, kind, positions):
    return batch_for_shader(shader, kind, {'pos': np.ascontiguousarray(positions, np.float32).reshape(-1, 3)})


def _line_shader():
    return gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR')


def _point_shader():
    return gpu.shader.from_builtin(versions.point_shader())


def _draw(stroke, scale):
    shader = _line_shader() if stroke.is_lines else _point_shader()
    if stroke.is_lines:
        shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
        shader.uniform_float('lineWidth', stroke.size() * scale)
    else:
        gpu.state.point_size_set(stroke.size() * scale)
    shader.uniform_float('color', stroke.color())
    stroke.batch.draw(shader)
    gpu.state.point_size_set(1.0)
