"""Over the 3D view: the stroke that is being drawn."""

import numpy as np

from ..bridge.data.file_state import state
from . import strokes

_COLOR = (0.35, 1.0, 0.5, 1.0)


def draw():
    """Called by Blender for each 3D view."""
    if len(state.drawn_stroke) < 2:
        return
    line = np.array(state.drawn_stroke)
    strokes.draw([strokes.lines(np.stack([line[:-1], line[1:]], 1), lambda: _COLOR, 2.5)])
