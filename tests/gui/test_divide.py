"""A railing: a post and a curve are selected, Divide Equally places posts along it; the panel, Ctrl+Z, sidebar closed."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"divide-{name}.png")


def posts():
    return [ob for ob in bpy.data.objects if ob.type == 'MESH' and ob.name != "Post"]


def steps():
    view = View()
    with view.override():
        empty_file()
        bpy.ops.splinewright.add_interpolating('EXEC_DEFAULT', True, size=4.0)
        curve = bpy.context.object
        bpy.ops.mesh.primitive_cone_add(radius1=0.15, depth=1.0)
        post = bpy.context.object
        post.name = "Post"
        post.rotation_euler = (0.0, 0.0, 0.5)
        curve.select_set(True)
        bpy.context.view_layer.objects.active = curve
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="begun")
    yield from redrawn()
    before = picture("before")
    view.move(420, 420)
    with view.override():
        bpy.ops.splinewright.divide_equally('INVOKE_DEFAULT', True)
    yield from until(lambda: len(posts()) == 11, "posts along the curve")
    yield from redrawn()
    assert mean_difference(picture("posts"), before) > 0.001
    properties = bpy.context.window_manager.operators[-1].properties
    assert properties.make == 'COPIES' and properties.source == "Post"
    properties.count = 20
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from redrawn()
    assert len(posts()) == 21
    while posts():
        view.press('Z', ctrl=True)
        yield from redrawn()
    assert "Post" in bpy.data.objects and len(bpy.data.objects) == 2
    print("railing", flush=True)
    with view.override():
        assert bpy.ops.splinewright.divide_equally('INVOKE_DEFAULT', True, make='EMPTIES') == {'FINISHED'}
    assert not posts() and bpy.context.object.type == 'EMPTY'
    print("empties beside a post that is selected", flush=True)


run(steps())
