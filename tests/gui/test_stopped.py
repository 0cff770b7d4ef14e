"""A loft whose section is deleted with X says so at the object and in the status bar, by the name; undo takes that back."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"stopped-{name}.png")


def why():
    return part('ui.stopped').in_status(bpy.context.window_manager.windows[0].view_layer)


def steps():
    view = View()
    with view.override():
        empty_file()
        for number, (height, size) in enumerate(((0.0, 1.0), (1.0, 0.6), (2.5, 1.4)), 1):
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True)
            bpy.context.object.name = f"Section {number}"
            bpy.context.object.location.z = height
            bpy.context.object.scale = size, size, size
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.splinewright.add_loft('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="loft")
    yield from redrawn()
    before = picture("before")
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        ob = bpy.data.objects["Section 2"]
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
        bpy.ops.ed.undo_push(message="select")
    view.move(640, 300)
    view.press('DEL')
    yield from until(lambda: "'Section 2'" in why(), "it says which curve is gone")
    yield from redrawn()
    after = picture("after")
    status = slice(-24, None), slice(0, 500)        # beside Blender's own reports, which fade
    assert mean_difference(before[status], after[status]) > 1.0, "the status bar says it"
    assert mean_difference(before[:-24], after[:-24]) > 0.5, "the view says it"
    view.press('Z', ctrl=True)
    yield from until(lambda: not why(), "undo mends it")
    yield from redrawn()
    again = picture("again")
    assert mean_difference(before[status], again[status]) < 1.0


run(steps())
