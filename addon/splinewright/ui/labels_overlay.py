"""Over the 3D view: the names of control points, weights, knots and functions beside them."""

import blf
import bpy
import numpy as np

from ..bridge.analysis import overlays
from ..bridge.data.settings import overlays_of
from ..bridge.shape import piece_materials
from ..core.base.words import say
from . import analysis_overlay, picking

_SIZE, _BELOW = 14.0, 0.72
#: To the right and above of what is named, in pixels.
_OFFSET = (6.0, 5.0)
#: Names of several objects at places nearer than this are written once, in pixels.
_APART = 4.0
_COLOR = (1.0, 1.0, 1.0, 1.0)


def draw():
    """Called by Blender for each 3D view, in pixels."""
    context = bpy.context
    chosen = overlays_of(context.scene)
    if not (context.space_data.overlay.show_overlays and (chosen.labels or chosen.axes)):
        return
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    taken = np.empty((0, 2))
    for ob in labeled(context) if chosen.labels else ():
        taken = _draw_labels(context, ob, overlays.kept(ob.data, 'labels', (), overlays.labels_of) or (), taken)
    for ob in analysis_overlay.active_shapes(context) if chosen.axes else ():
        found = overlays.kept(ob.data, 'numbers', (), overlays.axes_of)
        _draw_labels(context, ob, found.labels if found else (), taken)
    blf.disable(0, blf.SHADOW)


def labeled(context):
    """All pictures that are seen, and selected shapes."""
    pictures = [ob for ob in context.visible_objects if ob.type in ('CURVE', 'MESH') and piece_materials.KEY in ob.data.keys()]
    return dict.fromkeys((*pictures, *analysis_overlay.active_shapes(context)))


def _draw_labels(context, ob, labels, taken):
    """Draw names, but none where a name of another object stands. taken: (n, 2), the pixels of those; returned with the new ones."""
    if not labels:
        return taken
    region, scale = context.region, context.preferences.system.ui_scale
    pixels = picking.on_screen(region, context.region_data, ob.matrix_world, np.array([label.point for label in labels]))
    colors = piece_materials.colors_of(ob.data)
    for label, (x, y) in zip(labels, pixels):
        is_free = not len(taken) or np.abs(taken - (x, y)).max(1).min() > _APART * scale
        if is_free and 0 <= x < region.width and 0 <= y < region.height:
            blf.color(0, *colors.get(label.part, _COLOR))
            _draw_label(label, x + _OFFSET[0] * scale, y + _OFFSET[1] * scale, scale)
    return np.concatenate([taken, pixels[np.isfinite(pixels).all(1)]])


def _draw_label(label, x, y, scale):
    for text, is_below in label.runs:
        text = say(text)
        blf.size(0, (_BELOW if is_below else 1.0) * _SIZE * scale)
        blf.position(0, x, y - (0.25 * _SIZE * scale if is_below else 0.0), 0)
        blf.draw(0, text)
        x += blf.dimensions(0, text)[0]


CLASSES = ()
