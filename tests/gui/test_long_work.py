"""Fit Patch near very many points, and Rebuild, Project Curve and Divide Equally of a curve of very many: the window says that
they are at work, Esc stops them, nothing has changed; others are let finish, and Ctrl+Z takes them back."""

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
    return [ob for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)]


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


def begun(view, name='fit_patch', **settings):
    """What the operator returned."""
    with view.override():
        return getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True, **settings)


def knot(count):
    """A curve of so many points all about a sphere, active; both are selected."""
    empty_file()
    bpy.ops.splinewright.add_sphere('EXEC_DEFAULT', True, radius=2.0)
    rng, sc = np.random.default_rng(6), part('core.base.library').sc
    points = rng.uniform(-1, 1, (count, 3)) + (0, 0, 4)
    data = part('bridge.shape.shape').new_data("knot", sc.fit.interpolate(points).value, (1, 1))
    ob = bpy.data.objects.new("knot", data)
    bpy.context.collection.objects.link(ob)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.view3d.view_all(center=False)
    bpy.ops.ed.undo_push(message="knot")


def scene():
    """What undo and Esc leave as it was."""
    return sorted(bpy.data.objects.keys()), bpy.data.objects["knot"].data.splinewright.value


def of_a_curve(view, name, endless, short):
    """Steps: stopped with some settings, done and undone with others."""
    with view.override():
        knot(2000)
    yield from redrawn()
    before = scene()
    view.move(420, 420)
    assert begun(view, name, **endless) == {'RUNNING_MODAL'}
    yield from redrawn()
    save_picture(OUTPUT / f"long-{name}.png")
    view.press('ESC')
    yield from until(lambda: not at_work(), f"Esc stops {name}")
    yield from redrawn()
    assert scene() == before
    begun(view, name, **short)          # it may be done before anybody looks
    yield from until(lambda: scene() != before, f"{name} is done")
    yield from redrawn()
    view.press('Z', ctrl=True)
    yield from until(lambda: scene() == before, f"one undo takes {name} back")
    print(name, flush=True)


def hills(count):
    """A shape of so many wavy patches of many spans, one above the other, active."""
    empty_file()
    rng, sc = np.random.default_rng(3), part('core.base.library').sc
    x, y = np.meshgrid(np.arange(60.0), np.arange(60.0), indexing='ij')
    knots = np.concatenate([np.zeros(3), np.arange(58.0), np.full(3, 57.0)])
    patches = [sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, rng.normal(3 * k, 0.7, (60, 60))], -1)) for k in range(count)]
    data = part('bridge.shape.shape').new_data("hills", sc.PatchSet.from_patches(patches), (1, 1))
    ob = bpy.data.objects.new("hills", data)
    bpy.context.collection.objects.link(ob)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.view3d.view_all(center=False)


def area():
    """As the panel shows it; None where it has a button."""
    ob = bpy.context.object
    whole = part('bridge.analysis.surveys').whole_soon(ob.data, np.array(ob.matrix_world, dtype=np.float64), 0.02)
    return whole and whole.area


def of_a_large_shape(view):
    """Steps: the panel Measure has a button for it; stopped, and pressed again."""
    with view.override():
        hills(60)
    view.open_sidebar()
    yield from redrawn()
    assert area() is None
    view.move(420, 420)
    assert begun(view, 'measure_whole') == {'RUNNING_MODAL'}
    yield from redrawn()
    save_picture(OUTPUT / "long-measure.png")
    view.press('ESC')
    yield from until(lambda: not at_work(), "Esc stops it")
    assert area() is None
    begun(view, 'measure_whole')
    yield from until(lambda: area() is not None, "it is measured")
    yield from redrawn()
    save_picture(OUTPUT / "long-measured.png")
    assert area() > 60 * 57**2
    print("measure", flush=True)


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
    yield from of_a_curve(view, 'rebuild', {'by': 'TOLERANCE', 'tolerance': 1e-6}, {'by': 'COUNT', 'count_u': 500})
    yield from of_a_curve(view, 'add_projected', {'tolerance': 1e-9}, {'tolerance': 0.5})
    yield from of_a_curve(view, 'divide_equally', {'count': 1_000_000, 'make': 'POINTS'}, {'count': 5000, 'make': 'EMPTIES'})
    yield from of_a_large_shape(view)
    work._SHORT = 30.0
    with view.override():
        cloud(50)
        assert begun(view, count_u=4, count_v=4) == {'FINISHED'}
    assert len(shapes()) == 1
    print("short work is done at once", flush=True)


def at_work():
    return any(thread.name == "Splinewright" for thread in threading.enumerate())


run(steps())
