"""Shapes made from other objects that stopped following them: said at the object in the 3D views, and in the status bar."""

import textwrap

import blf
import bpy
import gpu
import numpy as np

from ..bridge.follow import follow
from ..core.base.words import phrase, say
from . import colors, messages, picking

#: In pixels of an interface that is not scaled.
_SIZE, _LINE, _MARGIN = 12, 17, 7
#: Characters in a line of a label, and how many objects have one.
_WIDTH, _MOST = 46, 20


def sentence(layer):
    """[(object, why)] of what stopped following and is seen in a view layer."""
    why = follow.stopped()
    return [(ob, why[ob.data]) for ob in layer.objects if ob.data in why and ob.visible_get(view_layer=layer)] if why else []


def in_status(layer):
    """A sentence for the status bar, or ""."""
    found = sentence(layer)
    if not found:
        return ""
    more = phrase(" ({count} more stopped)", count=len(found) - 1) if len(found) > 1 else ""
    ob, why = found[0]
    return phrase("{name} stopped following: {why}{more}", name=ob.name, why=why, more=more)


def draw():
    """Called by Blender for each 3D view, in pixels: a label at each object."""
    context = bpy.context
    if not context.space_data.overlay.show_overlays:
        return
    for ob, why in sentence(context.view_layer)[:_MOST]:
        if ob.visible_get(viewport=context.space_data):
            _draw_label(context, ob, textwrap.wrap(say(phrase("{name} stopped following: {why}", name=ob.name, why=why)), _WIDTH))


def _draw_label(context, ob, lines):
    middle = np.mean(np.array(ob.bound_box, dtype=np.float64), axis=0)
    x, y = picking.on_screen(context.region, context.region_data, ob.matrix_world, middle[None])[0]
    if not (0 <= x < context.region.width and 0 <= y < context.region.height):
        return
    scale = context.preferences.system.ui_scale
    blf.size(0, _SIZE * scale)
    widths = [blf.dimensions(0, line)[0] for line in lines]
    margin, height = _MARGIN * scale, _LINE * scale
    half = max(widths) / 2 + margin
    left, right = messages.free_space()
    x = min(max(x, left + half), max(right - half, left + half))
    top = y + len(lines) * height / 2
    gpu.state.blend_set('ALPHA')
    messages.draw_box(x - half, top - len(lines) * height - margin / 2, x + half, top + margin / 2)
    blf.color(0, *colors.WARNING)
    for i, (line, width) in enumerate(zip(lines, widths), 1):
        blf.position(0, x - width / 2, top - (i - 0.28) * height, 0)
        blf.draw(0, line)
    gpu.state.blend_set('NONE')
