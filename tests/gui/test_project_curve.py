"""A curve over a sphere and its image on it: Project Curve, G on the curve, Tab, Ctrl+Z, the sidebar closed."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"project-{name}.png")


def made():
    return [ob for ob in bpy.data.objects if ob.name.endswith("Project Curve")]


def steps():
    view = View()
    with view.override():
        empty_file()
        bpy.ops.splinewright.add_sphere('EXEC_DEFAULT', True, radius=2.0)
        ball = bpy.context.object
        bpy.ops.splinewright.add_interpolating('EXEC_DEFAULT', True, size=1.5, location=(0, 0, 2.5))
        curve = bpy.context.object
        ball.select_set(True)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="begun")
    yield from redrawn()
    before = picture("before")
    view.move(420, 420)
    with view.override():
        bpy.ops.splinewright.add_projected('INVOKE_DEFAULT', True)
    yield from until(lambda: len(made()) == 1, "a curve on the sphere")
    yield from redrawn()
    assert mean_difference(picture("made"), before) > 0.0005
    ob, value = made()[0], made()[0].data.splinewright.value
    for each in bpy.context.selected_objects:
        each.select_set(False)
    curve.select_set(True)
    bpy.context.view_layer.objects.active = curve
    view.press('G')
    yield from redrawn()
    view.move(460, 380)
    yield from until(lambda: ob.data.splinewright.value != value, "it goes along while the curve moves")
    view.press('LEFTMOUSE')
    yield from redrawn()
    assert part('bridge.follow').problem(ob.data) == ""
    picture("moved")
    while made():
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert len(bpy.data.objects) == 2
    print("projected", flush=True)


run(steps())
