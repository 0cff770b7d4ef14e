"""Stripes and colors of curvature on the surfaces of shapes."""

from typing import NamedTuple

import bpy
import gpu

from ..bridge.analysis import overlays
from ..bridge.shape import images
from ..core.analysis import faces
from . import legend, line_batches, surface_shader

#: Paint is so much of strokes.nearer() nearer: lines lie above it.
_PART = 0.5


class Painted(NamedTuple):
    """A surface as it is drawn."""

    batch: gpu.types.GPUBatch
    reach: float                        # what most of its numbers are not beyond


def draw(chosen, obs):
    """In the current 3D view, over the faces of those objects that are surfaces."""
    found, context = _painted(chosen, obs), bpy.context
    reach = _reach(chosen, found)
    for ob, painted in found:
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with line_batches.nearer(_PART):
            for matrix in images.of(ob, context.view_layer, context.space_data):
                _draw(chosen, painted.batch, matrix, reach)
    gpu.state.depth_test_set('NONE')


def _draw(chosen, batch, matrix, reach):
    if chosen.curvature:
        surface_shader.draw(batch, matrix, 'NUMBERS', reach=reach)
    else:
        surface_shader.draw(batch, matrix, chosen.stripe_kind, chosen.stripe_count, chosen.stripe_axis)


def _painted(chosen, obs):
    """[(object, Painted)]."""
    what = ('curvature', (chosen.curvature_kind,)) if chosen.curvature else ('faces', (None,))
    found = [(ob, overlays.kept(ob.data, *what, _paint)) for ob in obs if ob.type == 'MESH']
    return [(ob, painted) for ob, painted in found if painted is not None]


def _paint(data, value):
    found = overlays.faces_of(data, value)
    return Painted(surface_shader.batch(found), faces.reach(found))


def _reach(chosen, found):
    return chosen.curvature_range or max((painted.reach for _, painted in found), default=0.0)


def draw_legend(context, chosen, obs):
    """In pixels, at the lower right: a bar of the colors and the numbers they stand for."""
    found = _painted(chosen, obs)
    if not found:
        return
    reach = _reach(chosen, found)
    title = chosen.bl_rna.properties['curvature_kind'].enum_items[chosen.curvature_kind].name
    legend.draw(context, [title], [text_of(part * reach) for part in (-1.0, -0.5, 0.0, 0.5, 1.0)], surface_shader.COLORS)


def text_of(number):
    """A number of the legend."""
    return f"{number:.3g}" if number else "0"
