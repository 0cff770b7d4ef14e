"""Over the 3D view: the point of a shape that is pulled at, and the control points that follow it."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from ..bridge.shape import shape
from . import line_batches
from .ui_state import ui_state

_COLOR = (0.35, 1.0, 0.5, 1.0)
#: Control points are drawn in so many steps of brightness.
_STEPS = 6


class Pull(NamedTuple):
    """All in the space of the object of this name."""

    name: str
    start: np.ndarray                   # (3,) where the point of the shape was
    end: np.ndarray                     # (3,) where it is
    followers: np.ndarray               # (k, 3) control points that move
    parts: np.ndarray                   # (k,) how far each moves, from 0 to 1
    lines: np.ndarray = np.empty((0, 2, 3))     # of the tangent or circle that is pulled


def draw():
    """Called by Blender for each 3D view."""
    pull = ui_state.pulled
    ob = bpy.context.view_layer.objects.get(pull.name) if pull else None
    if not shape.has_shape(ob):
        return
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        line_batches.draw(_strokes(pull))


def _strokes(pull):
    steps = np.ceil(pull.parts * _STEPS)
    for step in np.unique(steps).tolist():
        color = (*_COLOR[:3], step / _STEPS)
        yield line_batches.points(pull.followers[steps == step], lambda color=color: color, lambda: 8)
    if len(pull.lines):
        yield line_batches.lines(pull.lines, lambda: _COLOR, 1.5)
    if not np.array_equal(pull.start, pull.end):
        yield line_batches.lines(np.array([[pull.start, pull.end]]), lambda: _COLOR, 2.0)
    yield line_batches.points(pull.end[None], lambda: _COLOR, lambda: 11)
