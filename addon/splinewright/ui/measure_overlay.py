"""Over the 3D view: what a shape measures at the mouse."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np
from mathutils import Matrix

from ..core.analysis import measured
from . import colors, line_batches, messages, mouse_words, picking
from .ui_state import ui_state

#: Of an arm, in pixels of an interface that is not scaled.
_ARM = 70
#: Of the point, where there is no other color for it.
_COLOR = (0.35, 1.0, 0.5, 1.0)


class Measured(NamedTuple):
    """For a region, at a pixel of the window."""

    region: int                         # as_pointer()
    x: int
    y: int
    place: measured.Place               # in the world; None where it has none
    words: tuple                        # lines of text


def draw():
    """Called by Blender for each 3D view."""
    if ui_state.measured is not None:
        _show_arms(ui_state.measured)


def draw_words():
    """Called by Blender for each 3D view."""
    if ui_state.measured is not None:
        _show_words(ui_state.measured)


def show_all(shown):
    """Draw a Measured into the current 3D view, arms and words."""
    _show_arms(shown)
    region = bpy.context.region
    scale = Matrix.Diagonal((2 / region.width, 2 / region.height, 1, 1))
    with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
        gpu.matrix.load_identity()
        gpu.matrix.load_projection_matrix(Matrix.Translation((-1, -1, 0)) @ scale)
        _show_words(shown)


def _show_arms(shown):
    if shown.place is None:
        return
    point, arms, _ = shown.place
    pixel = picking.size_of_pixel(bpy.context.region, bpy.context.region_data, point)
    reach = _ARM * bpy.context.preferences.system.ui_scale * pixel
    line_batches.draw([*(line_batches.lines(np.array([[point, point + reach * arm]]), lambda color=color: color, 2.5)
                    for arm, color in zip(arms, colors.FRAME)),
                  line_batches.points(point[None], lambda: _COLOR, lambda: 10)])


def _show_words(shown):
    if shown.region == bpy.context.region.as_pointer():
        mouse_words.draw(shown.x, shown.y, shown.words, messages.NOTE if shown.place else messages.WARNING)
