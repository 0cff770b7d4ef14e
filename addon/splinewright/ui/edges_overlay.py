"""Over the 3D view: edges with their numbers while those are clicked that are rounded."""

from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np

from . import line_batches, numbers_overlay, picking
from .ui_state import ui_state

_OTHER = (1.0, 1.0, 1.0, 0.35)
_SIZE = 15.0


class Edges(NamedTuple):
    """Those of which some are chosen."""

    lines: tuple                        # of polylines (n, 3) in the world
    chosen: frozenset                   # of numbers from 1
    hovered: int                        # the number of the one at the mouse; 0 for none

    def look_of(self, number):
        """(color, width): of an edge."""
        if number == self.hovered:
            return numbers_overlay.COLORS[2], 5.0
        return (numbers_overlay.COLORS[1], 4.0) if number in self.chosen else (_OTHER, 2.0)


def draw():
    """Called by Blender for each 3D view."""
    found = ui_state.rounding
    if found is None:
        return
    order = sorted(range(1, len(found.lines) + 1), key=lambda number: found.look_of(number)[1])
    gpu.state.depth_test_set('NONE')
    line_batches.draw(_stroke(found.lines[number - 1], *found.look_of(number)) for number in order)


def _stroke(line, color, width):
    return line_batches.lines(np.stack([line[:-1], line[1:]], 1), lambda: color, width)


def draw_numbers():
    """Called by Blender for each 3D view, in pixels."""
    found, context = ui_state.rounding, bpy.context
    if found is None:
        return
    scale = context.preferences.system.ui_scale
    middles = np.array([line[len(line) // 2] for line in found.lines])
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    for number, place in enumerate(picking.on_screen(context.region, context.region_data, np.eye(4), middles), 1):
        if not np.isfinite(place).all():
            continue
        color, is_hovered = found.look_of(number)[0], number == found.hovered
        blf.size(0, (1.5 if is_hovered else 1.0) * _SIZE * scale)
        blf.color(0, *color[:3], 1.0 if is_hovered or number in found.chosen else 0.7)
        blf.position(0, *(place - 0.5 * np.array(blf.dimensions(0, str(number)))), 0)
        blf.draw(0, str(number))
    blf.disable(0, blf.SHADOW)
