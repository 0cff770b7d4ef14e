"""The numbers of what the active surface is made from, and which way curves of it run, or of edges that it rounds, in the 3D
views."""

from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np

from ..bridge.analysis import surveys
from ..bridge.recipes import placing, recipes
from ..bridge.shape import shape
from ..core.base.failures import FAILURES
from . import line_batches, numbers_overlay, overlaid, picking
from .ui_state import ui_state

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


class _Seen(NamedTuple):
    """The drawing of an object."""

    sections: list
    are_edges: bool
    feet: np.ndarray                    # (n, 3): of all
    heads: np.ndarray
    arrows: list                        # the Stroke, as soon as it is drawn


def shown(ob):
    """The Sections of what an object is made from, where that is any number of shapes that are seen."""
    return _seen(ob).sections


def _seen(ob):
    if ob is None or ob.mode != 'OBJECT' or not ob.visible_get():
        return _NOTHING
    return overlaid.kept('sections', ob, _found)


def _found(ob):
    """The _Seen of an object."""
    if not shape.has_shape(ob) or not recipes.follows(ob.data):
        return _NOTHING
    try:
        stored = recipes.read(ob.data)
        are_edges = 'edges' in stored.recipe.defaults
        if not stored.recipe.has_more or len(stored.sources) > _MOST:
            return _NOTHING
        found = _edges(ob, stored.sources) if are_edges else _sections(stored)
    except FAILURES:
        return _NOTHING
    return _Seen(found, are_edges, *(np.array(points).reshape(-1, 3) for points in ([one.foot for one in found], [one.head for one in found])), [])


def _sections(stored):
    return [_section(i + 1, source, is_turned) for i, (source, is_turned) in enumerate(zip(stored.sources, stored.turned))
            if source is not None and source.visible_get() and shape.has_shape(source)]


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
    points = surveys.starts_of(source.data)[::-1 if is_turned else 1][:2]
    matrix = np.array(source.matrix_world, dtype=np.float64)
    return Section(number, *(points @ matrix[:3, :3].T + matrix[:3, 3]))


_NOTHING = _Seen([], False, np.empty((0, 3)), np.empty((0, 3)), [])


def _of_context():
    is_asked = bpy.context.space_data.overlay.show_overlays and ui_state.rounding is None
    return _seen(bpy.context.object) if is_asked else _NOTHING


def draw():
    """Called by Blender for each 3D view: where curves start, and which way they run."""
    seen = _of_context()
    if seen.sections:
        if not seen.arrows:
            seen.arrows.append(line_batches.arrows([(one.foot, one.head) for one in seen.sections if (one.foot != one.head).any()],
                                              lambda: _COLOR))
        gpu.state.blend_set('ALPHA')
        line_batches.draw(seen.arrows)
        gpu.state.blend_set('NONE')


def _hidden(context, seen):
    """Which Sections are edges that lie behind the surface itself."""
    ob = context.object
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    if not seen.are_edges or not abs(np.linalg.det(matrix)) > 0.0:
        return [False] * len(seen.sections)
    back = np.linalg.inv(matrix)
    return numbers_overlay.hidden_ones(context, ob, seen.feet @ back[:3, :3].T + back[:3, 3]).tolist()


def _places(context, seen, behind):
    """(n, 2) of floats: where the middles of the numbers stand, a given number of pixels behind where curves start."""
    feet, heads = (picking.on_screen(context.region, context.region_data, np.eye(4), points) for points in (seen.feet, seen.heads))
    along = heads - feet
    length = np.linalg.norm(along, axis=1, keepdims=True)
    return feet - behind * along / np.where(length == 0.0, 1.0, length)


def draw_numbers():
    """Called by Blender for each 3D view, in pixels."""
    seen, context = _of_context(), bpy.context
    if not seen.sections:
        return
    scale = context.preferences.system.ui_scale
    places = _places(context, seen, _BEHIND * scale)
    are_finite = np.isfinite(places).all(axis=1).tolist()
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    blf.size(0, _SIZE * scale)
    for one, (x, y), is_finite, is_hidden in zip(seen.sections, places.tolist(), are_finite, _hidden(context, seen)):
        if not is_finite:
            continue
        blf.color(0, *_COLOR[:3], numbers_overlay.HIDDEN if is_hidden else _COLOR[3])
        text = str(one.number)
        width, height = blf.dimensions(0, text)
        blf.position(0, x - width / 2, y - height / 2, 0)
        blf.draw(0, text)
    blf.disable(0, blf.SHADOW)
