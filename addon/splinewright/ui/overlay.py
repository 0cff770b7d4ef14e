"""Over the 3D view: the rows of a cage in two colors, its points, and arrows for directions at infinity."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from ..bridge.data.file_state import key, state
from ..bridge.net import live, selection
from . import colors, editing, line_batches
from .ui_state import ui_state


def draw_lines():
    """Called by Blender for each 3D view."""
    for ob in _nets_seen():
        _draw_net(ob, _prepared(ob).lines)


def draw_points():
    """Called by Blender for each 3D view: what lies above the lines of shapes, too."""
    for ob in _nets_seen():
        prepared = _prepared(ob)
        _draw_net(ob, prepared.points)
        _draw_net(ob, prepared.covered)


def _nets_seen():
    if not ui_state.nets or not bpy.context.space_data.overlay.show_overlays:
        return []
    return [ob for ob in editing.nets() if ob.mode == 'EDIT' and ob.visible_get()]


class Prepared(NamedTuple):
    """strokes.Strokes of a net."""

    lines: list
    points: list                        # those that Blender does not draw, and arrows
    covered: list                       # those that it draws, below what is ours


def _prepared(ob):
    """What there is to draw, worked out once, until Blender tells of a change of the net."""
    current = live.known_session(ob.data)
    if current is None:
        return Prepared([], [], [])
    name = key(ob.data)
    if name not in state.drawn:
        state.drawn[name] = Prepared(*_strokes(ob, current))
    return state.drawn[name]


def _draw_net(ob, prepared):
    gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
    with gpu.matrix.push_pop(), line_batches.nearer():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        line_batches.draw(prepared)
    gpu.state.depth_test_set('NONE')


def _strokes(ob, current):
    """Those of a Prepared; what lies above others comes last."""
    net, points = current.net, current.points
    rows = [line_batches.lines(points[pairs], lambda axis=axis: colors.of_net()[axis], 1.5)
            for axis, pairs in enumerate(net.lines)]
    marked = line_batches.points(points[(current.state.weights < 0) & net.are_points & (current.slots >= 0)],
                            lambda: colors.WARNING, lambda: _theme().vertex_size + 9)
    arrows = line_batches.arrows([(points[foot], points[head]) for foot, head in net.arrows], colors.of_arrows)
    edges, vertices = _of_selection(ob, current)
    return [*rows, *edges], [marked, arrows], vertices


def _of_selection(ob, current):
    """(edges, vertices): what Blender drew below our lines, edges between selected vertices, and vertices."""
    net, points, are_there = current.net, current.points, current.slots >= 0
    selected = np.zeros(len(points), bool)
    selected[selection.every_selected(ob, net)] = True
    edges = []
    if ob.type == 'MESH':
        edges = [line_batches.lines(points[pairs[selected[pairs].all(1)]], lambda: (*_theme().edge_select, 1.0), 2.0)
                 for pairs in net.lines]
    else:
        are_there = are_there & net.are_points          # handles have colors of their own
    return edges, [
        line_batches.points(points[are_there & ~selected], colors.of_points, lambda: _theme().vertex_size + 2),
        line_batches.points(points[are_there & selected], lambda: (*_theme().vertex_select, 1.0),
                       lambda: _theme().vertex_size + 3)]


def _theme():
    return bpy.context.preferences.themes[0].view_3d
