"""A curve through an edge loop and through objects: from the menus, with undo and the panel at the lower left, live."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"through-{name}.png")


def curves():
    return [ob for ob in bpy.data.objects if ob.type == 'CURVE']


def last():
    return bpy.context.window_manager.operators[-1]


def through_a_loop(view):
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_circle_add(vertices=6, radius=2)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Edit Mode")
    view.press('A')
    yield from redrawn()
    before = picture("vertices")
    with view.override():
        bpy.ops.splinewright.curve_through_points('INVOKE_DEFAULT', True)
    yield from until(lambda: len(curves()) == 1 and bpy.context.mode == 'OBJECT', "a curve")
    yield from redrawn()
    assert curves()[0].data.splinewright.value.periodic and mean_difference(picture("loop"), before) > 0.01
    last().properties.degree = 2
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from redrawn()
    assert [ob.data.splinewright.value.degree for ob in curves()] == [2]
    while curves():
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert bpy.context.mode == 'EDIT_MESH' and len(bpy.data.objects) == 1
    print("loop", flush=True)


def through_objects(view):
    with view.override():
        empty_file()
        for i, place in enumerate(((-3, 0, 0), (-1, 0, 2), (1, 0, -2), (3, 0, 0))):
            bpy.ops.object.empty_add(location=place)
            bpy.context.object.name = f"Post {i}"
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.splinewright.curve_through_points('INVOKE_DEFAULT', True)
        bpy.ops.view3d.view_axis(type='FRONT')
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    before = picture("objects")
    value = curves()[0].data.splinewright.value
    view.press('TAB')
    yield from until(lambda: len(bpy.context.selected_objects) == 4, "Tab selects the objects that it goes through")
    for ob in bpy.context.selected_objects:
        ob.select_set(ob.name == "Post 1")
    bpy.context.view_layer.objects.active = bpy.data.objects["Post 1"]
    view.move(420, 420)
    view.press('G')
    yield from redrawn()
    view.move(470, 360)
    yield from until(lambda: curves()[0].data.splinewright.value != value, "the curve goes along while the object moves")
    view.press('LEFTMOUSE')
    yield from redrawn()
    assert mean_difference(picture("moved"), before) > 0.01
    assert part('bridge.follow.follow').problem(curves()[0].data) == ""
    print("objects", flush=True)


def steps():
    view = View()
    yield from redrawn()
    yield from through_a_loop(view)
    yield from through_objects(view)


run(steps())
