"""Over the 3D view: the stroke that is being drawn."""

import numpy as np

from . import line_batches
from .ui_state import ui_state

_COLOR = (0.35, 1.0, 0.5, 1.0)


def draw():
    """Called by Blender for each 3D view."""
    if len(ui_state.drawn_stroke) < 2:
        return
    line = np.array(ui_state.drawn_stroke)
    line_batches.draw([line_batches.lines(np.stack([line[:-1], line[1:]], 1), lambda: _COLOR, 2.5)])
