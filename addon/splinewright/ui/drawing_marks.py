"""What drawing snaps to: marks of the curves that are shown, and of the drawing."""

import numpy as np

from ..bridge.follow import neighboring_curves
from ..core.base.failures import FAILURES
from ..core.drawing import contours, snap_marks
from . import picking

#: How near in pixels, of an interface that is not scaled.
_NEAR = 12.0


class Marks:
    """They may be turned off."""

    def __init__(self, context):
        self.are_on = True
        self._segments = snap_marks.segments(neighboring_curves.curves_of(None, context.visible_objects, context.evaluated_depsgraph_get()))
        self._known = self._found = snap_marks.of_segments(self._segments)

    def begin_at(self, drawn):
        """A point was added to the drawing, or taken back."""
        try:
            own = snap_marks.segments(contours.parts_of(drawn)) if len(drawn.points) > 1 else []
        except FAILURES:
            own = []
        feet = snap_marks.feet(self._segments, drawn.points[-1]) if drawn.points else []
        self._found = [*self._known, *snap_marks.of_segments(own), *feet]

    def at(self, region, view, pixel):
        """The core.drawing.snap_marks.Mark nearest to a pixel of a region; None where none is near."""
        if not (self.are_on and self._found):
            return None
        places = np.array([mark.place for mark in self._found])
        away = np.linalg.norm(picking.on_screen(region, view, np.eye(4), places) - pixel, axis=1)
        away[np.isnan(away)] = np.inf
        nearest = int(away.argmin())
        return self._found[nearest] if away[nearest] <= picking.near(_NEAR) else None
