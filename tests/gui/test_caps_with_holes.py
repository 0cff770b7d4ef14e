"""A plate with bolt holes and a letter, selected by A: Fill from the Add menu is plane with holes; Extrude with Caps is closed."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
OUTLINES = (((-3, -2), (3, -2), (3, 2), (-3, 2)), ((-0.6, -1.2), (0.6, -1.2), (0.9, 1.4), (0, 0.4), (-0.9, 1.4)))
HOLES = [(x, y) for x in (-2.3, 2.3) for y in (-1.3, 1.3)]


def picture(name):
    return save_picture(OUTPUT / f"caps-with-holes-{name}.png")


def scene(view):
    sc = part('core.base.library').sc
    with view.override():
        empty_file()
        for points in OUTLINES:
            data = part('bridge.shape.shape').new_data("outline", sc.build.contour([(*p, 0) for p in points], closed=True), (8, 8))
            bpy.context.scene.collection.objects.link(bpy.data.objects.new("outline", data))
        for place in HOLES:
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True)
            bpy.context.object.location, bpy.context.object.scale = (*place, 0), (0.4, 0.4, 0.4)
        bpy.ops.object.select_all(action='DESELECT')
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="curves")
    view.move(420, 420)
    yield from redrawn()


def filled(view):
    view.press('A')
    yield from until(lambda: len(bpy.context.selected_objects) == 6, "A selects all")
    before = picture("curves")
    with view.override():
        bpy.ops.splinewright.add_filling('INVOKE_DEFAULT', True)
    yield from until(lambda: bpy.context.object.type == 'MESH', "the filling")
    yield from redrawn()
    wanted = 24 - 4 * 0.16 * np.pi - part('core.base.library').sc.build.fill_rim([part('core.base.library').sc.build.contour(
        [(*p, 0) for p in OUTLINES[1]], closed=True)]).value[0].area()
    assert 0.99 * wanted < bpy.context.object.data.splinewright.value.area() < 1.3 * wanted
    assert mean_difference(picture("filled"), before) > 0.01


def capped(view):
    with view.override():
        bpy.data.objects.remove(bpy.context.object)
        curves = [ob for ob in bpy.data.objects if ob.type == 'CURVE']
        for ob in curves:
            ob.hide_set(False)
            ob.select_set(True)
        bpy.context.view_layer.objects.active = curves[0]
        bpy.ops.splinewright.make_editable('INVOKE_DEFAULT', True)
        bpy.ops.splinewright.join('INVOKE_DEFAULT', True)
        bpy.ops.splinewright.add_extrude('INVOKE_DEFAULT', True, z=1.0, caps='both')
    yield from until(lambda: bpy.context.object.type == 'MESH', "the plate")
    yield from redrawn()
    mesh = bpy.context.object.data
    counts = np.bincount([loop.edge_index for loop in mesh.loops])
    assert (counts == 2).all()
    with view.override():
        bpy.context.space_data.shading.show_cavity = True
    yield from redrawn()
    picture("capped")


def steps():
    view = View()
    yield from scene(view)
    yield from filled(view)
    yield from capped(view)


run(steps())
