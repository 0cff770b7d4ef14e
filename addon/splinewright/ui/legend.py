"""The legend of colors on shapes, at the lower right of the view: a bar of them and the numbers they stand for."""

from functools import cache

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..core.base.words import say
from . import knot_strip_overlay, surface_shader

#: Pixels of the bar, of text, between the legend and the border, on an interface that is not scaled.
_BAR, _TEXT, _MARGIN = (14, 160), 12, 24
_STEPS = 64


def draw(context, title, numbers, colors, notes=()):
    """In pixels. title, notes: lines above the bar and below it; numbers: texts beside it, from its lower end on, if any."""
    scale = context.preferences.system.ui_scale
    title, notes = list(map(say, title)), list(map(say, notes))
    width, height, margin, line = *(size * scale for size in (*_BAR, _MARGIN)), 1.4 * _TEXT * scale
    blf.size(0, _TEXT * scale)
    room = max([1.5 * width + max(map(_width, numbers), default=0.0), *map(_width, (*title, *notes))])
    left, bottom = _right_of_view(context) - margin - room, 2.0 * margin + line * len(notes) + knot_strip_overlay.top(context)
    _draw_bar(left, bottom, width, height, colors)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    blf.color(0, 1.0, 1.0, 1.0, 1.0)
    for i, text in enumerate(numbers):
        _write(text, left + 1.5 * width, bottom + i / (len(numbers) - 1) * height - 0.35 * _TEXT * scale)
    for i, text in enumerate(reversed(title)):
        _write(text, left, bottom + height + line + i * line)
    for i, text in enumerate(notes):
        _write(text, left, bottom - 1.2 * line - i * line)
    blf.disable(0, blf.SHADOW)


def _width(text):
    return blf.dimensions(0, text)[0]


def _write(text, x, y):
    blf.position(0, x, y, 0)
    blf.draw(0, text)


def _right_of_view(context):
    """Where regions that lie over the view begin."""
    over = [region.x - context.region.x for region in context.area.regions if region.type == 'UI' and region.width > 1
            and region.x > context.region.x]
    return min([context.region.width, *over])


def _draw_bar(left, bottom, width, height, colors):
    with gpu.matrix.push_pop():
        gpu.matrix.translate((left, bottom))
        gpu.matrix.scale((width, height))
        _bar(tuple(map(tuple, colors))).draw(_shader())


@cache
def _bar(colors):
    """1 wide and high. Needs a window."""
    at = np.linspace(0.0, 1.0, _STEPS)
    places = np.array([(side, t, 0.0) for t in at for side in (0, 1)], np.float32)
    shades = np.append(surface_shader.colors_at(2.0 * at - 1.0, np.array(colors)), np.ones((_STEPS, 1)), 1).repeat(2, 0)
    return batch_for_shader(_shader(), 'TRI_STRIP', {'pos': places, 'color': shades.astype(np.float32)})


def _shader():
    return gpu.shader.from_builtin('SMOOTH_COLOR')
