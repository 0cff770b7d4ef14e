"""Over the 3D view: what feeds the function of a triangle that is at the mouse, and with what coefficients."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from . import line_batches, messages, mouse_words
from .ui_state import ui_state

_COLOR, _WIDTH = (0.25, 0.95, 1.0, 1.0), 4.0
#: Pixels, of an interface that is not scaled, by which words stand above labels.
_ABOVE = 16


class Fed(NamedTuple):
    """For a region, at a pixel of the window."""

    region: int                         # as_pointer()
    x: int
    y: int
    lines: tuple                        # of polylines (n, 3) in the world
    words: str
    is_warning: bool


def draw():
    """Called by Blender for each 3D view."""
    shown = ui_state.fed
    if shown is not None:
        gpu.state.depth_test_set('NONE')
        line_batches.draw(line_batches.lines(np.stack([line[:-1], line[1:]], 1), lambda: _COLOR, _WIDTH) for line in shown.lines)


def draw_words():
    """Called by Blender for each 3D view, in pixels."""
    shown = ui_state.fed
    if shown is not None and shown.region == bpy.context.region.as_pointer():
        above = round(_ABOVE * bpy.context.preferences.system.ui_scale)
        mouse_words.draw(shown.x, shown.y + above, (shown.words,), messages.WARNING if shown.is_warning else messages.NOTE)
