"""Add shapes from the menus of a real window, change them, undo; a picture of each state is kept."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, part, pick_by_keys, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    rgb = save_picture(OUTPUT / f"{name}.png")
    assert len(np.unique(rgb.reshape(-1, 3), axis=0)) > 200, f"{name}.png is empty"
    return rgb


def pick(view, menu, steps_down, name):
    """Open a menu, go to its first entry, wherever the mouse is, and choose one by keyboard."""
    with view.override():
        bpy.ops.wm.call_menu(name=menu)
    yield from redrawn()
    picture(name)
    yield from pick_by_keys(view, ['HOME', *['DOWN_ARROW'] * steps_down])
    before = len(bpy.data.objects)
    view.press('RET')
    yield from until(lambda: len(bpy.data.objects) > before, "the menu entry adds a shape")
    yield from redrawn()


def below(menu, operator):
    """How many entries of a menu stand before an operator."""
    entries = [entry for entry in getattr(part('ui.menu_table'), menu).entries if entry]
    return next(i for i, entry in enumerate(entries) if getattr(entry, 'operator', "") == operator)


def frame(view):
    with view.override():
        bpy.ops.view3d.view_selected()
    yield from redrawn()


def steps():
    view = View()
    with view.override():
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.object.delete()
        bpy.ops.ed.undo_push(message="empty")
        view.area.spaces.active.overlay.show_cursor = False
    view.open_sidebar()
    view.move()
    yield from redrawn()
    empty = picture("empty")

    yield from pick(view, "SPLINEWRIGHT_MT_surface_add", below('ADD_SURFACE', 'add_teapot'), "menu")
    ob = bpy.context.object
    assert ob is not None and len(ob.data.splinewright.value) == 32, "the menu entry added no teapot"
    yield from frame(view)
    yield from view.show_tab("NURBS", click=(1044, 537))
    view.move(80, 96)               # open the redo panel
    view.press('LEFTMOUSE')
    yield from redrawn()
    view.move(650, 550)
    yield from redrawn()
    shown = picture("teapot")
    assert np.mean(np.any(shown != empty, axis=2)) > 0.05, "the teapot is not to be seen"

    ob.data.splinewright.resolution_u = 3
    assert len(ob.data.polygons) == 32 * 3 * 10
    view.press('Z', ctrl=True)
    yield from until(lambda: not bpy.data.objects, "Ctrl+Z takes the teapot away")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: "Teapot" in bpy.data.objects, "Shift+Ctrl+Z brings it back")
    assert len(bpy.data.objects["Teapot"].data.splinewright.value) == 32

    bpy.data.objects["Teapot"].hide_set(True)
    view.move(view.region.x + view.region.width // 2, view.region.y + view.region.height - 60)      # the menu is high
    bpy.context.preferences.edit.object_align = 'VIEW'
    yield from pick(view, "SPLINEWRIGHT_MT_curve_add", below('ADD_CURVE', 'add_nurbs_curve'), "curve-menu")
    ob = bpy.context.object
    assert ob.type == 'CURVE' and ob.name == "NURBS Curve", ob.name
    facing = view.area.spaces.active.region_3d.view_rotation.to_matrix()
    assert np.allclose(ob.matrix_world.to_3x3(), facing, atol=1e-5), "the curve is not aligned to the view"
    ob.rotation_euler = (0, 0, 0)
    ob.data.bevel_depth = 0.02
    yield from frame(view)
    picture("curve")
    print("the window did what it should:", bpy.app.version_string, flush=True)


run(steps())
