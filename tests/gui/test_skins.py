"""A loft of circles that are clicked in no order, with the sidebar closed: Add menu, G on a section, Ctrl+Z, Tab, the list in the
panel; a tube of four surfaces that is closed."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
HEIGHTS = (2.0, 0.0, 3.0, 1.0)
LOFT = []


def picture(name):
    return save_picture(OUTPUT / f"skins-{name}.png")


def value():
    return bpy.data.objects[LOFT[-1]].data.splinewright.value


def sources():
    return [source.location.z for source in part('bridge.recipes.recipes').read(bpy.data.objects[LOFT[-1]].data).sources]


def scene(view):
    with view.override():
        empty_file()
        for height in HEIGHTS:
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True)
            bpy.context.object.location.z = height
            bpy.context.object.scale = (1 + 0.3 * height, 1.0, 1.0)
        bpy.ops.object.select_all(action='DESELECT')
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="circles")
    yield from redrawn()


def clicked(view):
    """Each circle by a click on it in the view, with Shift from the second on."""
    circles = sorted((ob for ob in bpy.data.objects if ob.type == 'CURVE'), key=lambda ob: HEIGHTS.index(ob.location.z))
    for i, ob in enumerate(circles):
        start = ob.matrix_world @ bpy.data.objects[ob.name].data.splines[0].points[0].co.xyz
        view.move(*view.pixel_of(start))
        view.press('LEFTMOUSE', shift=i > 0)
        yield from until(lambda: ob.select_get() and len(bpy.context.selected_objects) == i + 1, f"circle {i + 1} is selected")


def lofted(view):
    with view.override():
        bpy.ops.splinewright.add_loft('INVOKE_DEFAULT', True)
    yield from until(lambda: bpy.context.object is not None and bpy.context.object.type == 'MESH', "the loft")
    LOFT.append(bpy.context.object.name)
    assert sources() in (sorted(HEIGHTS), sorted(HEIGHTS, reverse=True))
    yield from redrawn()
    picture("loft")


def followed(view):
    before = value()
    circle = next(ob for ob in bpy.data.objects if ob.type == 'CURVE' and ob.location.z == 1.0)
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
    circle.select_set(True)
    bpy.context.view_layer.objects.active = circle
    with view.override():
        bpy.ops.ed.undo_push(message="select")
    view.press('G')
    view.press('X')
    view.press('TWO', "2")
    view.press('RET')
    yield from until(lambda: value() != before, "the loft follows G")
    yield from redrawn()
    picture("moved")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")


def listed(view):
    loft = bpy.data.objects[LOFT[-1]]
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
    loft.select_set(True)
    bpy.context.view_layer.objects.active = loft
    yield from redrawn()
    plain = picture("selected")
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1044, 538))
    assert mean_difference(picture("list"), plain) > 0.01


def closed(view):
    """A tube of four surfaces, by A and F3: the numbers of its walls stand in them."""
    sc = part('core.base.library').sc
    wall = sc.BezierCurve([(1, 0, -1), (1, 0, 0)])
    with view.override():
        empty_file()
        for i in range(4):
            data = part('bridge.shape.shape').new_data(f"wall {i}", sc.build.revolve(wall, (0, 0, 0), (0, 0, 1), i * np.pi / 2, np.pi / 2), (8, 8))
            bpy.context.scene.collection.objects.link(bpy.data.objects.new(f"wall {i}", data))
        bpy.ops.ed.undo_push(message="walls")
    yield from redrawn()
    view.move(640, 420)
    view.press('A')
    yield from until(lambda: len(bpy.context.selected_objects) == 4, "A")
    view.press('F3')
    yield from redrawn()
    yield from redrawn()
    for letter in "fill":
        view.press(letter.upper(), letter)
    yield from redrawn()
    yield from redrawn()
    view.press('RET')
    yield from until(lambda: len(bpy.data.objects) == 5, "the filling")
    yield from redrawn()
    LOFT.append(bpy.context.object.name)
    assert len(value()) == 4
    plain = picture("closed")
    assert len(part('ui.sections_overlay').shown(bpy.context.object)) == 4
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 4, "Ctrl+Z takes it back")
    yield from redrawn()
    assert mean_difference(picture("open"), plain) > 0.01


def steps():
    view = View()
    yield from scene(view)
    yield from clicked(view)
    yield from lofted(view)
    yield from followed(view)
    yield from listed(view)
    yield from closed(view)


run(steps())
