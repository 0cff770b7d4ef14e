"""A curve over a sphere and its image on it: Project Curve, its panel, G on the curve, Tab, Ctrl+Z, the sidebar closed; then
the points of a mesh, in place and not."""

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
        curve_name = bpy.context.object.name
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
    few = len(made()[0].data.splinewright.value.points)
    bpy.context.window_manager.operators[-1].properties.tolerance = 1e-6
    yield from again(view)
    assert len(made()) == 1 and len(made()[0].data.splinewright.value.points) > few
    curve = bpy.data.objects[curve_name]
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
    assert part('bridge.follow.follow').problem(ob.data) == ""
    picture("moved")
    while made():
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert len(bpy.data.objects) == 2
    print("projected", flush=True)
    yield from points(view)


def points(view):
    """Steps: the panel moves the vertices themselves instead of new ones, and back."""
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_cube_add(size=4)
        cube = bpy.context.object.name
        bpy.ops.splinewright.add_sphere('EXEC_DEFAULT', True, radius=2.0)
        bpy.data.objects[cube].select_set(True)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="begun")
    yield from redrawn()
    view.move(420, 420)
    with view.override():
        assert bpy.ops.splinewright.project_points('INVOKE_DEFAULT', True) == {'FINISHED'}
    yield from redrawn()
    for in_place in (True, False):
        bpy.context.window_manager.operators[-1].properties.in_place = in_place
        yield from again(view)
        assert len(bpy.data.objects) == (2 if in_place else 3)
        lengths = [vertex.co.length for vertex in bpy.data.objects[cube].data.vertices]
        assert all(abs(length - (2 if in_place else 12**0.5)) < 1e-5 for length in lengths)
    while len(bpy.data.objects) > 2:
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert all(abs(vertex.co.length - 12**0.5) < 1e-5 for vertex in bpy.data.objects[cube].data.vertices)
    print("points", flush=True)


def again(view):
    """Steps: the last operator once more, as its panel does after a change."""
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message=getattr(bpy.types, bpy.context.window_manager.operators[-1].bl_idname).bl_label)
    yield from redrawn()


run(steps())
