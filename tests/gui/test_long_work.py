"""Fit Patch near very many points: the window says that it is at work, Esc stops it, nothing has changed; another one is let
finish, and Ctrl+Z takes it back."""

import os
import sys
import threading
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
MANY = 60_000


def shapes():
    return [ob for ob in bpy.data.objects if part('bridge.shape').has_shape(ob)]


def cloud(count):
    points = np.random.default_rng(3).uniform(-3, 3, (count, 3)).astype(np.float32)
    points[:, 2] = np.sin(points[:, 0]) * np.cos(points[:, 1]) + 0.1 * points[:, 2]
    empty_file()
    mesh = bpy.data.meshes.new("cloud")
    mesh.vertices.add(count)
    mesh.vertices.foreach_set('co', points.ravel())
    mesh.update()
    ob = bpy.data.objects.new("cloud", mesh)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    bpy.ops.view3d.view_all(center=False)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.ed.undo_push(message="cloud")


def begun(view, **settings):
    """What the operator returned."""
    with view.override():
        return bpy.ops.splinewright.fit_patch('INVOKE_DEFAULT', True, **settings)


def steps():
    view = View()
    with view.override():
        cloud(MANY)
    yield from redrawn()
    view.move(420, 420)
    assert begun(view, by='TOLERANCE', tolerance=1e-5, corrections=1000) == {'RUNNING_MODAL'}
    yield from redrawn()
    save_picture(OUTPUT / "long-work.png")
    view.press('A', alt=True)           # deselects all, were it taken
    view.press('ESC')
    yield from until(lambda: not at_work(), "Esc stops it")
    yield from redrawn()
    save_picture(OUTPUT / "long-stopped.png")
    assert not shapes() and bpy.context.mode == 'EDIT_MESH' and bpy.context.object.data.total_vert_sel == MANY
    print("stopped", flush=True)
    work = part('ui.operators.long_work')
    work._SHORT = 0.0                   # on a fast machine this were short
    assert begun(view, count_u=12, count_v=12, corrections=4) == {'RUNNING_MODAL'}
    yield from until(lambda: len(shapes()) == 1, "it is done")
    yield from redrawn()
    save_picture(OUTPUT / "long-done.png")
    assert bpy.context.mode == 'OBJECT' and bpy.context.window_manager.operators[-1].bl_idname == 'SPLINEWRIGHT_OT_fit_patch'
    view.press('Z', ctrl=True)
    yield from until(lambda: not shapes(), "one undo")
    yield from redrawn()
    assert bpy.context.mode == 'EDIT_MESH'
    print("done and undone", flush=True)
    work._SHORT = 30.0
    with view.override():
        cloud(50)
        assert begun(view, count_u=4, count_v=4) == {'FINISHED'}
    assert len(shapes()) == 1
    print("short work is done at once", flush=True)


def at_work():
    return any(thread.name == "Splinewright" for thread in threading.enumerate())


run(steps())
