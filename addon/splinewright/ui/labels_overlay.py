"""Over the 3D view: the names of control points, weights, knots and functions beside them."""

import blf
import bpy
import numpy as np

from ..bridge.analysis import overlays
from ..bridge.curve import piece_materials
from ..bridge.data.settings import overlays_of
from . import analysis_overlay, picking

_SIZE, _BELOW = 14.0, 0.72
#: To the right and above of what is named, in pixels.
_OFFSET = (6.0, 5.0)
_COLOR = (1.0, 1.0, 1.0, 1.0)


def draw():
    """Called by Blender for each 3D view, in pixels."""
    context = bpy.context
    if not (context.space_data.overlay.show_overlays and overlays_of(context.scene).labels):
        return
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    for ob in labeled(context):
        found = overlays.kept(ob.data, 'labels', (), overlays.labels_of)
        if found:
            _draw_labels(context, ob, found)
    blf.disable(0, blf.SHADOW)


def labeled(context):
    """Selected shapes, and all pictures that are seen."""
    pictures = [ob for ob in context.visible_objects if ob.type == 'CURVE' and piece_materials.KEY in ob.data.keys()]
    return dict.fromkeys((*analysis_overlay.active_shapes(context), *pictures))


def _draw_labels(context, ob, labels):
    region, scale = context.region, context.preferences.system.ui_scale
    pixels = picking.on_screen(region, context.region_data, ob.matrix_world, np.array([label.point for label in labels]))
    colors = piece_materials.colors_of(ob.data)
    for label, (x, y) in zip(labels, pixels):
        if 0 <= x < region.width and 0 <= y < region.height:
            blf.color(0, *colors.get(label.part, _COLOR))
            _draw_label(label, x + _OFFSET[0] * scale, y + _OFFSET[1] * scale, scale)


def _draw_label(label, x, y, scale):
    for text, size, drop in ((label.base, _SIZE, 0.0), (label.below, _BELOW * _SIZE, 0.25 * _SIZE), (label.after, _SIZE, 0.0)):
        if text:
            blf.size(0, size * scale)
            blf.position(0, x, y - drop * scale, 0)
            blf.draw(0, text)
            x += blf.dimensions(0, text)[0]


CLASSES = ()
