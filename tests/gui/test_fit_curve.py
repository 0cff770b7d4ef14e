"""Annotations drawn by hand become clean curves: D and a drag, the Add menu's operator, its panel, Ctrl+Z."""

import math
import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"fit-{name}.png")


def curves():
    return [ob for ob in bpy.data.objects if ob.type == 'CURVE']


def annotations():
    scene = bpy.context.scene
    data = scene.annotation if hasattr(scene, 'annotation') else scene.grease_pencil
    return [stroke for layer in data.layers for frame in layer.frames for stroke in frame.strokes] if data else []


def steps():
    view = View()
    with view.override():
        empty_file()
        bpy.ops.view3d.view_axis(type='TOP')
    yield from redrawn()
    bpy.context.scene.tool_settings.annotation_stroke_placement_view3d = 'CURSOR'
    with view.override():
        bpy.ops.gpencil.annotate('INVOKE_DEFAULT', mode='DRAW', wait_for_input=True)
    yield from redrawn()
    places = [(300 + 5 * i, 400 + round(80 * math.sin(i / 8)) + i % 2) for i in range(60)]
    yield from view.drag(places)
    view.release()
    yield from until(lambda: annotations(), "a stroke of the annotation tool")
    view.press('ESC')
    yield from redrawn()
    before = picture("drawn")
    with view.override():
        assert bpy.ops.splinewright.fit_curve.poll()
        bpy.ops.splinewright.fit_curve('INVOKE_DEFAULT', True)
    yield from until(lambda: len(curves()) == 1, "a curve")
    yield from redrawn()
    value = curves()[0].data.splinewright.value
    assert len(value.points) < len(annotations()[0].points) / 2
    assert mean_difference(picture("fitted"), before) > 0.001
    bpy.context.window_manager.operators[-1].properties.tolerance = 1.0
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from redrawn()
    assert [len(ob.data.splinewright.value.points) <= len(value.points) for ob in curves()] == [True]
    view.move(420, 420)
    while curves():
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert annotations()
    print("annotations", flush=True)


run(steps())
