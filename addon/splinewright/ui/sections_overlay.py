"""The numbers of what the active surface is made from, and which way curves of it run, or of edges that it rounds, in the 3D
views."""

from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np

from ..bridge import placing, recipes, shape, store, surveys
from ..bridge.file_state import state
from ..core import sections, verbs
from ..core.failures import FAILURES
from . import numbers_overlay, picking, strokes

_COLOR = (1.0, 0.62, 0.1, 0.95)
_SIZE = 15.0
#: How far a number stands behind where its curve starts, in pixels of an interface that is not scaled.
_BEHIND = 14.0
#: Longer lists show no numbers.
_MOST = 200


class Section(NamedTuple):
    """Where a curve, surface or edge is seen."""

    number: int
    foot: np.ndarray                    # (3,) in the world: where a curve starts; the middle of a surface or edge
    head: np.ndarray                    # (3,): a part of a curve further; the same of a surface


def shown(ob):
    """The Sections of what an object is made from, where that is any number of shapes that are seen."""
    if ob is None or ob.mode != 'OBJECT' or not ob.visible_get() or not shape.has_shape(ob) or not recipes.follows(ob.data):
        return []
    try:
        stored = recipes.read(ob.data)
        if not stored.recipe.has_more or len(stored.sources) > _MOST:
            return []
        if 'edges' in stored.recipe.defaults:
            return _edges(ob, stored.sources)
        return [_section(i + 1, source, is_turned) for i, (source, is_turned) in enumerate(zip(stored.sources, stored.turned))
                if source is not None and source.visible_get() and shape.has_shape(source)]
    except FAILURES:
        return []


def _edges(ob, sources):
    """Sections at the edges of what a shape rounds."""
    if not all(source is not None and shape.has_shape(source) for source in sources):
        return []
    space = placing.now(ob.data, ob, sources, bpy.context.evaluated_depsgraph_get())
    points = surveys.edges_of(ob.data, sources, [space.of(source) for source in sources])
    if len(points) > _MOST:
        return []
    matrix = np.array(ob.matrix_world, dtype=np.float64) @ space.applied
    return [Section(i + 1, point, point) for i, point in enumerate(points @ matrix[:3, :3].T + matrix[:3, 3])]


def _section(number, source, is_turned):
    definition = store.read(source.data)
    piece = verbs.pieces_of(definition)[0]
    if definition.has_curves:
        points = sections.samples(piece)[::-1 if is_turned else 1][[0, 3]]
    else:
        points = np.repeat([piece.evaluate(*map(np.mean, piece.domain))], 2, axis=0)
    matrix = np.array(source.matrix_world, dtype=np.float64)
    return Section(number, *(points @ matrix[:3, :3].T + matrix[:3, 3]))


def _of_context():
    is_asked = bpy.context.space_data.overlay.show_overlays and state.rounding is None
    return shown(bpy.context.object) if is_asked else []


def draw():
    """Called by Blender for each 3D view: where curves start, and which way they run."""
    found = _of_context()
    if found:
        gpu.state.blend_set('ALPHA')
        strokes.draw([strokes.arrows([(one.foot, one.head) for one in found if (one.foot != one.head).any()], lambda: _COLOR)])
        gpu.state.blend_set('NONE')


def _hidden(context, found):
    """Which Sections are edges that lie behind the surface itself."""
    ob = context.object
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    if 'edges' not in recipes.of(ob.data).defaults or not abs(np.linalg.det(matrix)) > 0.0:
        return np.zeros(len(found), bool)
    back = np.linalg.inv(matrix)
    points = np.array([one.foot for one in found]) @ back[:3, :3].T + back[:3, 3]
    return numbers_overlay.hidden_ones(context, ob, points)


def draw_numbers():
    """Called by Blender for each 3D view, in pixels."""
    found, context = _of_context(), bpy.context
    if not found:
        return
    feet, heads = (picking.on_screen(context.region, context.region_data, np.eye(4), np.array(points))
                   for points in ([one.foot for one in found], [one.head for one in found]))
    scale = context.preferences.system.ui_scale
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    blf.size(0, _SIZE * scale)
    for one, foot, head, is_hidden in zip(found, feet, heads, _hidden(context, found)):
        blf.color(0, *_COLOR[:3], numbers_overlay.HIDDEN if is_hidden else _COLOR[3])
        text = str(one.number)
        behind = foot - _BEHIND * scale * (head - foot) / (np.linalg.norm(head - foot) or 1.0)
        if np.isfinite(behind).all():
            blf.position(0, *(behind - 0.5 * np.array(blf.dimensions(0, text))), 0)
            blf.draw(0, text)
    blf.disable(0, blf.SHADOW)
