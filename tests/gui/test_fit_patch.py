"""A hilly mesh is selected in Edit Mode: a patch near its vertices and one through its faces, by Blender's own keys; the panel
changes it, undo takes it back; then the new patch is shaped, undone, saved and opened again."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, empty_file, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, select_points,
                    until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"patch-{name}.png")


def shapes():
    return [ob for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)]


def points_of_shape():
    return np.array(shapes()[0].data.splinewright.value.points)


def hills(view):
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=12, y_subdivisions=9, size=6)
        mesh = bpy.context.object.data
        for vertex in mesh.vertices:
            vertex.co.z = 0.5 * np.sin(vertex.co.x) * np.cos(vertex.co.y)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.mesh.select_all(action='SELECT')
        bpy.ops.ed.undo_push(message="hills")


def changed_and_taken_back(view, operator, degree):
    """Steps: the panel changes the degree along u; undo takes the patch back, redo makes it again."""
    bpy.context.window_manager.operators[-1].properties.degree_u = degree
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from redrawn()
    assert [ob.data.splinewright.value.degree[0] for ob in shapes()] == [degree]
    assert len(bpy.data.objects) == 2 and bpy.context.mode == 'OBJECT'
    presses = 0
    while shapes():
        view.press('Z', ctrl=True)
        yield from redrawn()
        presses += 1
    assert bpy.context.mode == 'EDIT_MESH' and len(bpy.data.objects) == 1
    for _ in range(presses):
        view.press('Z', ctrl=True, shift=True)
        yield from redrawn()
    assert [ob.data.splinewright.value.degree[0] for ob in shapes()] == [degree]


def steps():
    view = View()
    for operator, name in (('fit_patch', "near"), ('patch_through_grid', "through")):
        hills(view)
        yield from redrawn()
        before = picture("mesh")
        view.move(420, 420)
        with view.override():
            getattr(bpy.ops.splinewright, operator)('INVOKE_DEFAULT', True)
        yield from until(lambda: len(shapes()) == 1 and bpy.context.mode == 'OBJECT', name)
        yield from redrawn()
        assert mean_difference(picture(name), before) > 0.001
        yield from changed_and_taken_back(view, operator, 2)
        view.press('TAB')
        yield from into_net()
        points = points_of_shape()
        with view.override():
            select_points(40)
        for key in ('G', 'Z'):
            view.press(key)
            yield from redrawn()
        view.press('ONE', text="1")
        view.press('RET')
        yield from until(lambda: not np.array_equal(points_of_shape(), points), "moved")
        view.press('Z', ctrl=True)
        yield from until(lambda: np.array_equal(points_of_shape(), points), "taken back")
        view.press('Z', ctrl=True, shift=True)
        yield from until(lambda: not np.array_equal(points_of_shape(), points), "moved again")
        view.press('TAB')
        yield from out_of_net()
        picture(f"{name}-shaped")
        shaped = shapes()[0].data.splinewright.value
        path = str(OUTPUT / "patch.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
        yield from redrawn()
        assert shapes()[0].data.splinewright.value == shaped
        view = View()
    print("patches", flush=True)


run(steps())
