"""Over the 3D view: where a knot would lie that is inserted by a click, or what a click would do to a curve."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from ..bridge.analysis import surveys
from ..bridge.shape import shape
from ..core.base.failures import FAILURES
from ..core.verbs import parameter_picking
from . import line_batches
from .ui_state import ui_state

_COLOR = (0.35, 1.0, 0.5, 1.0)


class Aim(NamedTuple):
    """The item at the mouse: the name of an object, the number of its piece, its parameters, and along what a patch gets
    a knot; or points (n, 3) of what a click would take or add."""

    name: str
    number: int
    parameters: tuple
    direction: str
    line: object = None


def draw():
    """Called by Blender for each 3D view."""
    show(ui_state.aimed)


def show(aimed):
    """Draw an Aim, if there is one, into the current 3D view."""
    ob = bpy.context.view_layer.objects.get(aimed.name) if aimed else None
    if not shape.has_shape(ob):
        return
    try:
        lines = [aimed.line] if aimed.line is not None else parameter_picking.lines(surveys.pieces_of(ob.data)[aimed.number - 1], aimed.parameters, aimed.direction)
    except (*FAILURES, IndexError):
        return                          # the shape is another one meanwhile
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        line_batches.draw(_stroke(line[np.isfinite(line).all(1)]) for line in lines)


def _stroke(line):
    if len(line) == 1:
        return line_batches.points(line, lambda: _COLOR, lambda: 10)
    return line_batches.lines(np.stack([line[:-1], line[1:]], 1), lambda: _COLOR, 3.0)
