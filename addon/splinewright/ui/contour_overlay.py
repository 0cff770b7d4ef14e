"""Over the 3D view: the contour that is being drawn, and what the next click adds."""

import numpy as np

from ..core.base.failures import FAILURES
from ..core.drawing import contours
from . import line_batches
from .ui_state import ui_state

_COLOR, _NEXT, _POINT = (0.35, 1.0, 0.5, 1.0), (0.35, 1.0, 0.5, 0.45), (1.0, 1.0, 1.0, 1.0)
#: Points of an arc.
_COUNT = 48


def draw():
    """Called by Blender for each 3D view."""
    if ui_state.contour is None:
        return
    done, longer = ui_state.contour
    found = [_stroke(done, _COLOR), _stroke(longer, _NEXT) if longer != done else None,
             line_batches.points(np.array(longer.points), lambda: _POINT, lambda: 5.0)]
    line_batches.draw([stroke for stroke in found if stroke is not None])


def _stroke(contour, color):
    try:
        parts = contours.parts_of(contour)
    except FAILURES:
        return None                     # there is none yet
    lines = [part.evaluate(np.linspace(*part.domain, _COUNT if part.degree > 1 else 2)) for part in parts]
    return line_batches.lines(np.concatenate([np.stack([line[:-1], line[1:]], 1) for line in lines]), lambda: color, 2.0)
