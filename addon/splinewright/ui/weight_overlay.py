"""Over the 3D view: the number by which weights change, at the mouse."""

from typing import NamedTuple

import blf
import bpy

from ..bridge.file_state import state
from . import messages

_SIZE, _BESIDE = 15, 18


class Weighing(NamedTuple):
    """A text for a region, at a pixel of the window."""

    region: int                         # as_pointer()
    x: int
    y: int
    text: str
    is_warning: bool


def draw():
    """Called by Blender for each 3D view."""
    shown, region = state.weighing, bpy.context.region
    if shown is None or shown.region != region.as_pointer():
        return
    scale = bpy.context.preferences.system.ui_scale
    blf.size(0, _SIZE * scale)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 3, 0.0, 0.0, 0.0, 0.9)
    blf.color(0, *(messages.WARNING if shown.is_warning else messages.NOTE))
    blf.position(0, shown.x - region.x + _BESIDE * scale, shown.y - region.y + _BESIDE * scale, 0)
    blf.draw(0, shown.text)
    blf.disable(0, blf.SHADOW)
