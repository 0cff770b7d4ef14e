"""Over the 3D view: what a shape measures at the mouse."""

from typing import NamedTuple

import blf
import bpy
import numpy as np

from ..bridge.file_state import state
from ..core import measured
from . import colors, messages, picking, strokes

#: In pixels of an interface that is not scaled: of an arm, of text, between its lines, and between the mouse and it.
_ARM, _SIZE, _LINE, _BESIDE = 70, 15, 20, 18
#: Of the point, where there is no other colour for it.
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
    if state.measured is None or state.measured.place is None:
        return
    point, arms, _ = state.measured.place
    pixel = picking.size_of_pixel(bpy.context.region, bpy.context.region_data, point)
    reach = _ARM * bpy.context.preferences.system.ui_scale * pixel
    strokes.draw([*(strokes.lines(np.array([[point, point + reach * arm]]), lambda color=color: color, 2.5)
                    for arm, color in zip(arms, colors.FRAME)),
                  strokes.points(point[None], lambda: _COLOR, lambda: 10)])


def draw_words():
    """Called by Blender for each 3D view."""
    shown, region = state.measured, bpy.context.region
    if shown is None or shown.region != region.as_pointer():
        return
    scale = bpy.context.preferences.system.ui_scale
    blf.size(0, _SIZE * scale)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 3, 0.0, 0.0, 0.0, 0.9)
    blf.color(0, *(messages.NOTE if shown.place else messages.WARNING))
    for i, text in enumerate(reversed(shown.words)):
        blf.position(0, shown.x - region.x + _BESIDE * scale, shown.y - region.y + (_BESIDE + i * _LINE) * scale, 0)
        blf.draw(0, text)
    blf.disable(0, blf.SHADOW)
