"""What only a real window has: saving while a net is edited, other ways out, two windows, local view,
snapping, the redo panel, timers."""

import os
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, empty_file, in_net, into_net, is_out, nets, out_of_net, part, redrawn, run, save_picture,
                    select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
FOLDER = Path(tempfile.mkdtemp())


def value():
    return bpy.data.objects["NURBS Patch"].data.splinewright.value


def require_exact(name):
    shape, store, ob = part('bridge.shape.shape'), part('bridge.data.store'), bpy.data.objects[name]
    assert np.array_equal(shape.points_of(ob.data), shape.evaluated(ob.data, store.read(ob.data)).points)
    assert not shape.is_touched(ob.data)
    return ob


def drag(view, up, **modifiers):
    view.press('G')
    yield from redrawn()
    for _ in range(3):
        view.y += up // 3
        view.window.event_simulate('MOUSEMOVE', 'NOTHING', x=view.x, y=view.y, **modifiers)
        yield from redrawn()


def add_patch(view):
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()


def saving(view):
    view.press('TAB')
    yield from into_net()
    select_points(14)
    before = value()
    yield from drag(view, 60)
    view.press('LEFTMOUSE')
    store = part('bridge.data.store')
    yield from until(lambda: value() != before and not store.is_draft(bpy.data.objects["NURBS Patch"].data),
                     "the shape follows, with exact normals")
    require_exact("NURBS Patch")
    moved = bpy.data.objects["NURBS Patch"].data.splinewright.value
    path = FOLDER / "saved.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    yield from until(in_net, "the net again, after saving")
    path.unlink()
    view.press('S', ctrl=True)
    yield from until(lambda: path.is_file() and in_net(), "Ctrl+S saves and stays in the net")
    copy = str(FOLDER / "copy.blend")   # Blender 5 reads no names from the file that is open
    bpy.ops.wm.save_as_mainfile(filepath=copy, copy=True)
    yield from until(in_net, "the net again, after a copy was saved")
    with bpy.data.libraries.load(copy) as (inside, _):
        assert inside.objects == ["NURBS Patch"], inside.objects
    yield from drag(view, 30)
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != moved, "the shape follows after saving")
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and value() == moved, "Ctrl+Z undoes the move in the net")
    require_exact("NURBS Patch")
    print("saving", flush=True)


def other_ways_out(view):
    with view.override():
        bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    yield from out_of_net()
    assert bpy.context.object.name == "NURBS Patch", "the net was not swept"
    after = require_exact("NURBS Patch").data.splinewright.value
    view.press('Z', ctrl=True)
    yield from into_net()
    view.press('Z', ctrl=True)
    yield from redrawn()
    view.press('Z', ctrl=True, shift=True)
    yield from redrawn()
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: is_out() and value() == after, "redo leads out of the net")
    require_exact("NURBS Patch")
    view.press('TAB')
    yield from into_net()
    view.press('TAB')
    yield from out_of_net()
    print("other ways out", flush=True)


def snapping(view):
    """With the magnet on the shape goes where Blender snaps the point to, by whole steps."""
    before = value()
    view.press('TAB')
    yield from into_net()
    select_points(0)
    settings = bpy.context.scene.tool_settings
    settings.snap_elements, settings.use_snap = {'INCREMENT'}, True
    view.press('G')
    yield from redrawn()
    view.press('Z')
    yield from redrawn()
    for _ in range(3):
        view.move(y=view.y + 80)
        yield from redrawn()
    view.press('LEFTMOUSE')
    yield from redrawn()
    yield from until(lambda: value() != before, "the snapped point moves the shape")
    settings.use_snap = False
    view.move(420, 420)
    point = require_exact("NURBS Patch").data.splinewright.value.points[0, 0]
    nets()[0].update_from_editmode()
    assert np.array_equal(point, nets()[0].data.vertices[0].co), "the shape is not where the point was snapped to"
    step = (point - before.points[0, 0])[2]
    assert step != 0 and abs(10 * step - round(10 * step)) < 1e-4, step
    view.press('TAB')
    yield from out_of_net()
    print(f"snapping: {step:.6f}", flush=True)


def redo_panel(view):
    """Changing a setting of the last operator, as the panel at the lower left does."""
    with view.override():
        bpy.context.object.scale = (2, 2, 2)
        bpy.ops.ed.undo_push(message="scale")
        bpy.ops.splinewright.apply_transform('EXEC_DEFAULT', True)
    yield from redrawn()
    applied = require_exact("NURBS Patch").data.splinewright.value
    last = bpy.context.window_manager.operators[-1]
    assert last.bl_idname == 'SPLINEWRIGHT_OT_apply_transform'
    last.properties['scale'] = False
    with view.override():
        bpy.ops.ed.undo_redo()
    yield from redrawn()
    ob = require_exact("NURBS Patch")
    assert ob.data.splinewright.value != applied and tuple(ob.scale) == (2, 2, 2), "the redo panel changed nothing"
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.ed.undo_redo()          # of Tab itself
    yield from redrawn()
    assert in_net() and require_exact("NURBS Patch")
    view.press('TAB')
    yield from out_of_net()
    print("redo panel", flush=True)


def local_view(view):
    with view.override():
        bpy.ops.view3d.localview()
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    with view.override():
        assert in_net() and nets()[0] in bpy.context.visible_objects, "the net is not to be seen in local view"
    save_picture(OUTPUT / "windows-local-view.png")
    view.press('TAB')
    yield from out_of_net()
    with view.override():
        bpy.ops.view3d.localview()
    yield from redrawn()
    print("local view", flush=True)


def two_windows(view):
    """Another window shows another scene; a shape in both is edited in one."""
    first = view.window.scene
    other = bpy.data.scenes.new("other")
    ob = bpy.data.objects["NURBS Patch"]
    other.collection.objects.link(ob)
    with view.override():
        bpy.ops.wm.window_new_main()
    yield from until(lambda: len(bpy.context.window_manager.windows) == 2, "a second window")
    yield from redrawn()
    second = next(window for window in bpy.context.window_manager.windows if window != view.window)
    second.scene = other
    yield from redrawn()
    with view.override():
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True)
    yield from redrawn()
    held = nets()[0]
    assert held.name in first.objects and held.name not in other.objects
    with view.override():
        select_points(14)
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 1))
    yield from redrawn()
    require_exact("NURBS Patch")
    with bpy.context.temp_override(window=second):
        bpy.context.view_layer.update()
        bpy.ops.wm.window_close()
    yield from until(lambda: len(bpy.context.window_manager.windows) == 1, "one window")
    yield from redrawn()
    with view.override():
        bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    yield from out_of_net()
    require_exact("NURBS Patch")
    print("two windows", flush=True)


def steps():
    view = View()
    empty_file()
    yield from add_patch(view)
    for part_of_it in (saving, other_ways_out, snapping, redo_panel, local_view, two_windows):
        view.move(420, 420)
        yield from part_of_it(view)
    print("windows did what they should:", bpy.app.version_string, flush=True)


run(steps())
