"""While a section is dragged with the mouse a loft that takes long stays behind; it is exact when the mouse rests, when the button is
released, by Update Now, for scripts, and in files."""

import sys
import tempfile
import time
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, part, redrawn, run, until

file_state, follow, late, shape, store = (part(name) for name in (
    'bridge.data.file_state', 'bridge.follow.follow', 'bridge.recipes.late', 'bridge.shape.shape', 'bridge.data.store'))


def loft():
    return next(ob for ob in bpy.data.objects if shape.has_shape(ob) and ob.type == 'MESH')


def pool():
    return store.read(loft().data).pool


def require_exact():
    """Steps until the loft is not behind, when it is what its sections make now."""
    yield from redrawn()
    yield from until(up_to_date, "it is up to date")
    before = pool().copy()
    bpy.context.evaluated_depsgraph_get()
    assert np.array_equal(pool(), before), "nothing was to be done"
    file_state.state.made.clear()
    follow.refresh_all(set(), bpy.context.evaluated_depsgraph_get())
    assert np.array_equal(pool(), before), np.abs(pool() - before).max()


#: Of each change that Blender told of: whether the loft was behind then.
_behind = []


def seems_slow(*_):
    """The loft is taken for one that takes long, until it was made."""
    file_state.state.costs[file_state.key(loft().data)] = (10.0,)


def look(*_):
    _behind.append(late.is_late(loft().data))


def select_section(view):
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        ob = bpy.data.objects["Section 2"]
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
        bpy.ops.ed.undo_push(message="select")
    return ob


def dragged(view, ob, mode):
    """Steps in which the section is grabbed and dragged; the button is not pressed yet."""
    with view.override():
        loft().data.splinewright.update_mode = mode
    yield from redrawn()
    place = ob.matrix_world.translation.copy()
    _behind.clear()
    view.move(640, 400)
    view.press('G')
    for i in range(1, 6):
        view.move(640 + 15 * i, 400 + 5 * i)
        yield from redrawn()
    yield from until(lambda: (ob.matrix_world.translation - place).length > 0.01, "the section is dragged")
    yield from until(lambda: any(_behind), "the loft stays behind")


def up_to_date():
    return not late.is_late(loft().data)


def steps():
    view = View()
    with view.override():
        empty_file()
        for number, height in enumerate((0.0, 1.0, 2.5), 1):
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True)
            bpy.context.object.name = f"Section {number}"
            bpy.context.object.location.z = height
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.splinewright.add_loft('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="loft")
    yield from redrawn()
    ob = select_section(view)
    bpy.app.handlers.depsgraph_update_post.insert(0, seems_slow)
    bpy.app.handlers.depsgraph_update_post.append(look)

    yield from dragged(view, ob, 'ALWAYS')
    yield from until(up_to_date, "the mouse rests")
    yield from require_exact()
    view.press('LEFTMOUSE')
    yield from redrawn()

    yield from dragged(view, ob, 'ON_RELEASE')
    view.press('LEFTMOUSE')
    yield from until(up_to_date, "the button was released")
    yield from require_exact()

    yield from dragged(view, ob, 'ALWAYS')
    view.press('LEFTMOUSE')
    yield from redrawn()
    view.press('Z', ctrl=True)
    yield from redrawn()
    yield from until(up_to_date, "after undo")
    yield from require_exact()

    ob = bpy.data.objects["Section 2"]
    ob.location.x += 1.0
    bpy.context.view_layer.update()
    assert up_to_date(), "a script waits for it"
    yield from require_exact()

    yield from dragged(view, ob, 'MANUAL')
    view.press('LEFTMOUSE')
    end = time.monotonic() + 2.0
    yield from until(lambda: time.monotonic() > end, "some time")
    assert late.is_late(loft().data)
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        loft().select_set(True)
        bpy.context.view_layer.objects.active = loft()
        bpy.ops.splinewright.update_now('EXEC_DEFAULT', True)
    assert up_to_date()
    yield from require_exact()

    ob = select_section(view)
    yield from dragged(view, ob, 'MANUAL')
    view.press('LEFTMOUSE')
    yield from redrawn()
    with tempfile.TemporaryDirectory() as folder:
        bpy.ops.wm.save_as_mainfile(filepath=str(Path(folder) / "saved.blend"), copy=True)
    assert up_to_date()
    yield from require_exact()


run(steps())
