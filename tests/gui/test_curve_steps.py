"""A curve of one span, added from the menu: it is smooth in the view, stays so when its net makes it bend more, and stands out from
its net; a pipe that folds says so in the panel."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, in_net, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"curve-steps-{name}.png")


def curve():
    return next(ob for ob in bpy.data.objects if ob.type == 'CURVE' and part('bridge.shape.shape').has_shape(ob))


def count():
    return len(curve().data.splines[0].points)


def added(view):
    with view.override():
        empty_file()
        bpy.ops.splinewright.add_bezier_curve('INVOKE_DEFAULT', True)
        curve().data.splinewright.value = part('core.base.library').sc.BezierCurve([(-2, 0, 0), (-1, 3, 0), (1, -3, 0), (2, 0, 0)])
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
        bpy.ops.ed.undo_push(message="curve")
    view.move(420, 420)
    yield from redrawn()
    yield from redrawn()
    assert count() > 40 and curve().data.splinewright.mode == 'AUTOMATIC'
    points = np.array([point.co[:3] for point in curve().data.splines[0].points])
    ways = np.diff(points, axis=0)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    assert np.degrees(np.arccos(np.clip((ways[:-1] * ways[1:]).sum(1), -1, 1))).max() < 7.0
    picture("smooth")


def in_its_net(view):
    view.press('TAB')
    yield from until(in_net, "Tab leads into the net")
    yield from redrawn()
    yield from redrawn()
    picture("net")
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Tab leads out of the net")


def folded(view):
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        curve().select_set(True)
        bpy.context.view_layer.objects.active = curve()
        bpy.ops.splinewright.add_pipe('INVOKE_DEFAULT', True, radius=1.2)
    yield from until(lambda: bpy.context.object.type == 'MESH', "the pipe")
    assert "the surface folds there" in part('bridge.recipes.recipes').read(bpy.context.object.data).warning
    view.open_sidebar()
    yield from view.show_tab("NURBS", (1045, 538))
    yield from redrawn()
    yield from redrawn()
    picture("folds")


def steps():
    view = View()
    yield from added(view)
    yield from in_its_net(view)
    yield from folded(view)


run(steps())
