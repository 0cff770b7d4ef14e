"""A loft is moved by G, copied by Shift+D, turned by R and applied by Ctrl+A, with the sidebar closed; then the panel's choice."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAMES = {}


def picture(name):
    return save_picture(OUTPUT / f"moving-{name}.png")


def loft():
    return bpy.data.objects[NAMES['loft']]


def seen(ob):
    """The vertices of a shape in the world."""
    flat = np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.vertices.foreach_get('co', flat)
    matrix = np.array(ob.matrix_world)
    return flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


def scene(view):
    with view.override():
        empty_file()
        for height, size in ((0.0, 1.0), (1.0, 0.6), (2.5, 1.4)):
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True)
            bpy.context.object.location.z = height
            bpy.context.object.scale = size, size, size
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.splinewright.add_loft('EXEC_DEFAULT', True)
        NAMES['loft'] = bpy.context.object.name
        bpy.context.object.data.splinewright.mode = 'COUNT'
        NAMES['rings'] = [ob.name for ob in bpy.data.objects if ob.type == 'CURVE']
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="loft")
    yield from redrawn()


def chosen(view, *objects):
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        for ob in objects:
            ob.select_set(True)
        bpy.context.view_layer.objects.active = objects[0]
        bpy.ops.ed.undo_push(message="select")
    yield from redrawn()


def near(a, b):
    return a.shape == b.shape and np.abs(a - b).max() < 1e-5


def typed(view, *keys):
    """Keys of a modal transform, to its end."""
    for key in keys:
        view.press(*key) if isinstance(key, tuple) else view.press(key)
    view.press('RET')


def moved(view):
    yield from chosen(view, loft())
    view.move(640, 420)
    before = seen(loft())
    typed(view, 'G', 'X', ('THREE', "3"))
    yield from until(lambda: near(seen(loft()), before + (3.0, 0.0, 0.0)), "G moves the loft")
    yield from redrawn()
    picture("moved")
    view.press('Z', ctrl=True)
    yield from until(lambda: near(seen(loft()), before), "Ctrl+Z puts it back")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: near(seen(loft()), before + (3.0, 0.0, 0.0)), "Ctrl+Shift+Z")


def moved_with_all(view):
    yield from chosen(view, loft(), *(bpy.data.objects[name] for name in NAMES['rings']))
    before = seen(loft())
    typed(view, 'G', 'Y', ('TWO', "2"))
    yield from until(lambda: near(seen(loft()), before + (0.0, 2.0, 0.0)), "G on all moves it once")


def copied(view):
    yield from chosen(view, loft())
    before = seen(loft())
    view.press('D', shift=True)
    typed(view, 'Y', ('FOUR', "4"))
    yield from until(lambda: bpy.context.object.name != NAMES['loft'], "the copy")
    copy = bpy.context.object
    yield from until(lambda: near(seen(copy), before + (0.0, 4.0, 0.0)), "Shift+D moves the copy")
    assert near(seen(loft()), before)
    ring = bpy.data.objects[NAMES['rings'][1]]
    yield from chosen(view, ring)
    typed(view, 'S', ('TWO', "2"))
    yield from until(lambda: not near(seen(loft()), before), "S on a ring")
    yield from until(lambda: near(seen(copy), seen(loft()) + (0.0, 4.0, 0.0)), "both follow")
    yield from redrawn()
    picture("copied")


def applied(view):
    yield from chosen(view, loft())
    typed(view, 'R', 'Z', ('THREE', "3"), ('ZERO', "0"))
    yield from until(lambda: abs(loft().rotation_euler.z) > 0.5, "R turns it")
    yield from redrawn()
    before = seen(loft())
    view.press('A', ctrl=True)
    yield from redrawn()
    view.press('A', "a")                        # All Transforms
    yield from until(lambda: np.allclose(loft().matrix_world, np.eye(4), atol=1e-6), "Ctrl+A")
    yield from redrawn()
    assert near(seen(loft()), before)
    assert part('bridge.follow.follow').problem(loft().data) == "" and not part('bridge.shape.shape').is_touched(loft().data)


def said(view):
    plain = picture("closed")
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1044, 538))
    assert mean_difference(picture("panel"), plain) > 0.01


def steps():
    view = View()
    yield from scene(view)
    yield from moved(view)
    yield from moved_with_all(view)
    yield from copied(view)
    yield from applied(view)
    yield from said(view)


run(steps())
