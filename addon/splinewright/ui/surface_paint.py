"""Stripes and colours of curvature on the surfaces of shapes, and the legend of these colours."""

from typing import NamedTuple

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge import sights
from ..core.sights import faces
from . import knot_strip_overlay, strokes, surface_shader

#: Paint is so much of strokes.nearer() nearer: lines lie above it.
_PART = 0.5
#: The legend: pixels of its bar, of its text, between it and the border, on an interface that is not scaled.
_BAR, _TEXT, _MARGIN = (14, 160), 12, 24
_STEPS = 64


class Painted(NamedTuple):
    """A surface as it is drawn."""

    batch: gpu.types.GPUBatch
    reach: float                        # what most of its numbers are not beyond


def draw(chosen, obs):
    """In the 3D view at hand, over the faces of those objects that are surfaces."""
    found = _painted(chosen, obs)
    reach = _reach(chosen, found)
    for ob, painted in found:
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with strokes.nearer(_PART):
            if chosen.curvature:
                surface_shader.draw(painted.batch, ob.matrix_world, 'NUMBERS', reach=reach)
            else:
                surface_shader.draw(painted.batch, ob.matrix_world, chosen.stripe_kind, chosen.stripe_count,
                                    chosen.stripe_axis)


def _painted(chosen, obs):
    """[(object, Painted)]."""
    what = ('curvature', (chosen.curvature_kind,)) if chosen.curvature else ('faces', (None,))
    found = [(ob, sights.kept(ob.data, *what, _paint)) for ob in obs if ob.type == 'MESH']
    return [(ob, painted) for ob, painted in found if painted is not None]


def _paint(data, value):
    found = sights.faces_of(data, value)
    return Painted(surface_shader.batch(found), faces.reach(found))


def _reach(chosen, found):
    return chosen.curvature_range or max((painted.reach for _, painted in found), default=0.0)


def draw_legend(context, chosen, obs):
    """In pixels, at the lower right: a bar of the colours and the numbers they stand for."""
    found = _painted(chosen, obs)
    if not found:
        return
    reach, scale = _reach(chosen, found), context.preferences.system.ui_scale
    width, height, margin = _BAR[0] * scale, _BAR[1] * scale, _MARGIN * scale
    texts = [text_of(part * reach) for part in (-1.0, -0.5, 0.0, 0.5, 1.0)]
    title = chosen.bl_rna.properties['curvature_kind'].enum_items[chosen.curvature_kind].name
    blf.size(0, _TEXT * scale)
    room = max(blf.dimensions(0, text)[0] for text in (*texts, title))
    left, bottom = _right_of_view(context) - margin - room - 1.5 * width, 2.0 * margin + knot_strip_overlay.top(context)
    _draw_bar(left, bottom, width, height)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    blf.color(0, 1.0, 1.0, 1.0, 1.0)
    for i, text in enumerate(texts):
        _write(text, left + 1.5 * width, bottom + i / 4 * height - 0.35 * _TEXT * scale)
    _write(title, left, bottom + height + _TEXT * scale)
    blf.disable(0, blf.SHADOW)


def text_of(number):
    """A number of the legend."""
    return f"{number:.3g}" if number else "0"


def _write(text, x, y):
    blf.position(0, x, y, 0)
    blf.draw(0, text)


def _right_of_view(context):
    """Where regions that lie over the view begin."""
    over = [region.x - context.region.x for region in context.area.regions if region.type == 'UI' and region.width > 1
            and region.x > context.region.x]
    return min([context.region.width, *over])


def _draw_bar(left, bottom, width, height):
    shader = gpu.shader.from_builtin('SMOOTH_COLOR')
    at = np.linspace(0.0, 1.0, _STEPS)
    places = np.array([(left + side * width, bottom + t * height, 0.0) for t in at for side in (0, 1)], np.float32)
    colours = np.array([(*surface_shader.color_of(2.0 * t - 1.0), 1.0) for t in at for _ in (0, 1)], np.float32)
    batch_for_shader(shader, 'TRI_STRIP', {'pos': places, 'color': colours}).draw(shader)
