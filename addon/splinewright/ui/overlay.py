"""Over the 3D view: seams, the rows of a cage in two colours, and arrows for directions at infinity."""

import bpy
import gpu
import numpy as np

from ..bridge.file_state import key, state
from ..bridge.net import live, selection
from . import colors, editing, seams_overlay, strokes


def draw():
    """Called by Blender for each 3D view."""
    if not bpy.context.space_data.overlay.show_overlays:
        return
    seams_overlay.draw()
    for ob in editing.nets() if state.nets else ():
        if ob.mode == 'EDIT' and ob.visible_get():
            current = live.known_session(ob.data)
            if current is not None:
                _draw_net(ob, current)


def _draw_net(ob, current):
    """What there is to draw is worked out once, until Blender tells of a change of the net."""
    name = key(ob.data)
    if name not in state.drawn:
        state.drawn[name] = list(_strokes(ob, current))
    gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
    with gpu.matrix.push_pop(), strokes.nearer():
        gpu.matrix.multiply_matrix(ob.matrix_world)
        strokes.draw(state.drawn[name])
    gpu.state.depth_test_set('NONE')


def _strokes(ob, current):
    """Those of a net; what lies above others comes last."""
    net, points = current.net, current.points
    for axis, pairs in enumerate(net.lines):
        yield strokes.lines(points[pairs], lambda axis=axis: colors.of_net()[axis], 1.5)
    yield strokes.points(points[(current.state.weights < 0) & net.are_points & (current.slots >= 0)],
                         lambda: colors.WARNING, lambda: _theme().vertex_size + 9)
    yield strokes.arrows([(points[foot], points[head]) for foot, head in net.arrows], colors.of_arrows)
    if ob.type == 'MESH':
        yield from _of_selection(ob, current)


def _of_selection(ob, current):
    """What Blender drew below our lines: vertices, and edges between selected ones."""
    net, points, are_there = current.net, current.points, current.slots >= 0
    selected = np.zeros(len(points), bool)
    selected[selection.every_selected(ob, net)] = True
    for pairs in net.lines:
        yield strokes.lines(points[pairs[selected[pairs].all(1)]], lambda: (*_theme().edge_select, 1.0), 2.0)
    yield strokes.points(points[are_there & ~selected], colors.of_points, lambda: _theme().vertex_size + 2)
    yield strokes.points(points[selected], lambda: (*_theme().vertex_select, 1.0), lambda: _theme().vertex_size + 3)


def _theme():
    return bpy.context.preferences.themes[0].view_3d
