"""The pen: a drag in the view becomes a clean curve, on a surface too; Esc and short strokes make nothing; Ctrl+Z."""

import math
import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
WAVE = [(300 + 5 * i, 400 + round(60 * math.sin(i / 8)) + i % 2) for i in range(60)]
LOOP = [(450 + round(90 * math.cos(i / 10)), 400 + round(90 * math.sin(i / 10))) for i in range(63)]


def picture(name):
    return save_picture(OUTPUT / f"pen-{name}.png")


def curves():
    return [ob for ob in bpy.data.objects if ob.type == 'CURVE']


def take_pen(view, name='draw_curve'):
    with view.override():
        getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True)
    yield from redrawn()


def steps():
    view = View()
    with view.override():
        empty_file()
        bpy.ops.view3d.view_axis(type='TOP')
    yield from redrawn()
    before = picture("before")
    yield from take_pen(view)
    yield from view.drag(WAVE)
    yield from redrawn()
    assert mean_difference(picture("drawing"), before) > 0.001
    view.press('ESC')
    yield from redrawn()
    assert not curves()
    yield from take_pen(view)
    yield from view.drag(WAVE[:2])
    view.release()
    yield from redrawn()
    assert not curves()
    yield from take_pen(view)
    yield from view.drag(WAVE)
    view.release()
    yield from redrawn()
    yield from until(lambda: len(curves()) == 1, "a curve")
    value = curves()[0].data.splinewright.value
    assert len(value.points) < len(WAVE) / 2 and not value.periodic
    picture("drawn")
    bpy.context.window_manager.operators[-1].properties.tolerance = 1.0
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message="again")
    yield from redrawn()
    assert [len(ob.data.splinewright.value.points) <= len(value.points) for ob in curves()] == [True]
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_plane_add(size=100, location=(0, 0, -2))
        bpy.ops.ed.undo_push(message="plane")
    yield from redrawn()
    for name, keys in (('draw_curve', 'S'), ('draw_on_surface', '')):
        yield from take_pen(view, name)
        for key in keys:
            view.press(key)
        yield from view.drag(LOOP)
        view.release()
        yield from redrawn()
        yield from until(lambda: len(curves()) == 1, "a closed curve")
        value = curves()[0].data.splinewright.value
        assert value.periodic and np.allclose(np.array(value.points)[:, 2], -2, atol=1e-4)
        picture(f"closed-{name}-{keys}")
        view.press('Z', ctrl=True)
        yield from until(lambda: not curves(), "one undo")
    assert [ob.type for ob in bpy.data.objects] == ['MESH']
    print("pen", flush=True)


run(steps())
