"""Drawings over 3D views, in the order in which they lie there."""

import bpy

from . import (aim_overlay, analysis_overlay, axis_overlay, contour_overlay, edges_overlay, fed_overlay, knot_strip_overlay, labels_overlay,
               lesson_overlay, measure_overlay, messages, numbers_overlay, overlay, pen_overlay, pull_overlay, seams_overlay, sections_overlay,
               stopped, weight_overlay)

#: What Blender calls for each 3D view, in the space of the scene or in pixels.
_DRAWS = (
    (analysis_overlay.draw_paint, 'POST_VIEW'), (analysis_overlay.draw_legend, 'POST_PIXEL'),
    (overlay.draw_lines, 'POST_VIEW'),
    (analysis_overlay.draw, 'POST_VIEW'),
    (seams_overlay.draw, 'POST_VIEW'),
    (overlay.draw_points, 'POST_VIEW'),
    (numbers_overlay.draw_outline, 'POST_VIEW'), (numbers_overlay.draw, 'POST_PIXEL'),
    (labels_overlay.draw, 'POST_PIXEL'),
    (aim_overlay.draw, 'POST_VIEW'),
    (pull_overlay.draw, 'POST_VIEW'),
    (pen_overlay.draw, 'POST_VIEW'),
    (contour_overlay.draw, 'POST_VIEW'),
    (axis_overlay.draw, 'POST_VIEW'), (sections_overlay.draw, 'POST_VIEW'), (sections_overlay.draw_numbers, 'POST_PIXEL'),
    (edges_overlay.draw, 'POST_VIEW'), (edges_overlay.draw_numbers, 'POST_PIXEL'),
    (measure_overlay.draw, 'POST_VIEW'), (fed_overlay.draw, 'POST_VIEW'),
    (knot_strip_overlay.draw, 'POST_PIXEL'),
    (weight_overlay.draw, 'POST_PIXEL'), (measure_overlay.draw_words, 'POST_PIXEL'), (fed_overlay.draw_words, 'POST_PIXEL'),
    (lesson_overlay.draw, 'POST_PIXEL'), (stopped.draw, 'POST_PIXEL'), (messages.draw, 'POST_PIXEL'),
)

_handles = ()

CLASSES = ()


def register():
    global _handles
    if not bpy.app.background:
        _handles = tuple(bpy.types.SpaceView3D.draw_handler_add(draw, (), 'WINDOW', when) for draw, when in _DRAWS)


def unregister():
    global _handles
    for handle in _handles:
        bpy.types.SpaceView3D.draw_handler_remove(handle, 'WINDOW')
    _handles = ()
