"""Over the 3D view: the number by which weights change, at the mouse."""

from typing import NamedTuple

import bpy

from . import messages, mouse_words
from .ui_state import ui_state


class Weighing(NamedTuple):
    """A text for a region, at a pixel of the window."""

    region: int                         # as_pointer()
    x: int
    y: int
    text: str
    is_warning: bool


def draw():
    """Called by Blender for each 3D view."""
    shown = ui_state.weighing
    if shown is not None and shown.region == bpy.context.region.as_pointer():
        mouse_words.draw(shown.x, shown.y, (shown.text,), messages.WARNING if shown.is_warning else messages.NOTE)
