"""The axis of the active surface of revolution, and an edge that is picked to be it, as lines in the 3D views."""

import bpy
import gpu
import numpy as np

from ..bridge.recipes import placing, recipes
from ..bridge.shape import shape
from ..core.base.failures import FAILURES
from ..core.recipes.surface_recipes import axis_of
from . import line_batches, overlaid
from .ui_state import ui_state

_COLOR = (1.0, 0.62, 0.1, 0.9)
_WIDTH = 1.5
#: That of an edge that is picked to be the axis.
_PICKED = 4.0
#: How far the line goes on beyond the surface, in parts of its size.
_BEYOND = 0.15


def line_of(ob):
    """(2, 3): the ends of the axis in the world, or None where an object is no surface of revolution that is seen."""
    if ob is None or ob.mode != 'OBJECT' or not ob.visible_get():
        return None
    return overlaid.kept('axis', ob, _line_of)


def _line_of(ob):
    if not shape.has_shape(ob) or recipes.kind(ob.data) != 'revolve':
        return None
    try:
        stored = recipes.read(ob.data)
        through, direction = _axis(stored, ob)
    except FAILURES:
        return None
    direction = direction / np.linalg.norm(direction)
    box = np.array(ob.bound_box)
    along = (box - through) @ direction
    gap = _BEYOND * np.ptp(box, axis=0).max()
    ends = through + np.outer((along.min() - gap, along.max() + gap), direction)
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    return ends @ matrix[:3, :3].T + matrix[:3, 3]


def _axis(stored, ob):
    """(a point of the axis, its direction) in the space of a surface of revolution, in its present place. Raises
    Refusal."""
    frames = [frame for frame in stored.frames if frame]
    space = placing.now(ob.data, ob, (*stored.sources, *frames), bpy.context.evaluated_depsgraph_get())
    offset = [stored.values[f"offset_{name}"] for name in "xyz"]
    through, direction = axis_of(stored.values['axis'], offset, *map(space.of, frames))
    return (space.applied @ [*through, 1.0])[:3], space.applied[:3, :3] @ direction


def draw():
    """Called by Blender for each 3D view."""
    line = line_of(bpy.context.object) if bpy.context.space_data.overlay.show_overlays else None
    seen = [] if line is None else [overlaid.kept('axis drawn', bpy.context.object,
                                                  lambda _: line_batches.lines(line[None], lambda: _COLOR, _WIDTH))]
    if ui_state.edge is not None:
        seen.append(line_batches.lines(np.array(ui_state.edge[1:])[None], lambda: _COLOR, _PICKED))
    if not seen:
        return
    gpu.state.blend_set('ALPHA')
    line_batches.draw(seen)
    gpu.state.blend_set('NONE')
