"""Words over the 3D view, beside the mouse."""

import blf
import bpy

from ..core.base.words import say

#: In pixels of an interface that is not scaled: of text, between its lines, and between the mouse and it.
_SIZE, _LINE, _BESIDE = 15, 20, 18


def draw(x, y, lines, color):
    """At a pixel of the window, in the current region, the last line beside it and the others above."""
    region, scale = bpy.context.region, bpy.context.preferences.system.ui_scale
    blf.size(0, _SIZE * scale)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 3, 0.0, 0.0, 0.0, 0.9)
    blf.color(0, *color)
    for i, text in enumerate(map(say, reversed(lines))):
        blf.position(0, x - region.x + _BESIDE * scale, y - region.y + (_BESIDE + i * _LINE) * scale, 0)
        blf.draw(0, text)
    blf.disable(0, blf.SHADOW)
