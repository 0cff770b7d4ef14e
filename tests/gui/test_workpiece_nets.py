"""Nets of two surfaces at once, among other objects: local view, the magnet on a corner of a cube, a row that is deleted, a point that
cannot be, a save in the net; the file that is opened has the shape selected, and Tab goes on. By mouse and keys."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import View, in_net, into_net, nets, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
PATH = OUTPUT / "nets.blend"
NAMES = {}


def picture(name):
    return save_picture(OUTPUT / f"nets-{name}.png")


def value(name='sheet'):
    return bpy.data.objects[NAMES[name]].data.splinewright.value


def space():
    return next(area.spaces.active for area in bpy.context.window.screen.areas if area.type == 'VIEW_3D')


def scene(view):
    yield from by_keys.add(view, "Surface > NURBS > NURBS Patch")
    yield from until(lambda: len(bpy.data.objects) == 1, "a patch")
    NAMES['sheet'] = bpy.context.object.name
    with view.override():
        bpy.ops.mesh.primitive_cube_add('EXEC_DEFAULT', True, size=1.0, location=(3, 0, 0.5))
        NAMES['cube'] = bpy.context.object.name
        bpy.ops.ed.undo_push(message="cube")
    yield from by_keys.see_all(view)
    yield from by_keys.choose(view, NAMES['sheet'])


def alone(view):
    """/ in the net leaves the surface there."""
    view.press('TAB')
    yield from into_net()
    view.press('NUMPAD_SLASH')
    yield from until(lambda: space().local_view is not None, "local view")
    yield from until(lambda: bpy.data.objects[NAMES['sheet']].visible_get(viewport=space()), "the surface is in it, too")
    assert not bpy.data.objects[NAMES['cube']].visible_get(viewport=space())
    yield from redrawn()
    picture("alone")
    view.press('NUMPAD_SLASH')
    yield from until(lambda: space().local_view is None, "all is seen again")


def snapped(view):
    """The magnet takes a corner of the cube, and not the surface that goes along."""
    before = value()
    tools = bpy.context.scene.tool_settings
    tools.snap_elements, tools.use_snap = {'VERTEX'}, True
    corner = max((bpy.data.objects[NAMES['cube']].matrix_world @ vertex.co for vertex in bpy.data.objects[NAMES['cube']].data.vertices),
                 key=lambda place: place.z - place.x)
    select_points(len(nets()[0].data.vertices) - 1)
    yield from redrawn()
    nets()[0].update_from_editmode()
    start = nets()[0].matrix_world @ nets()[0].data.vertices[-1].co
    view.move(*view.pixel_of(start))
    yield from redrawn()
    view.press('G')
    yield from redrawn()
    goal = np.array(view.pixel_of(corner))
    for share in (0.3, 0.6, 0.9, 1.0):
        here = np.array(view.pixel_of(start))
        view.move(*(int(x) for x in here + share * (goal - here)))
        yield from redrawn()
    picture("snapping")
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != before, "the point moves")
    yield from redrawn()
    nets()[0].update_from_editmode()
    reached = nets()[0].matrix_world @ nets()[0].data.vertices[-1].co
    assert np.allclose(reached, corner, atol=1e-5), (reached, corner)
    tools.use_snap = False
    view.move(420, 420)
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    print("magnet", flush=True)


def deleted(view):
    """X on a whole row takes it; on one point the shape stays, and the panel says why."""
    before = value()
    net = part('bridge.net.live').session(nets()[0].data).net
    rows = {int(row): vertex for vertex, row in enumerate(net.rows)}
    indices = net.definition.pieces[0].indices
    select_points(*(rows[int(row)] for row in indices[1]))
    yield from redrawn()
    view.press('X')
    yield from redrawn()
    for key in ('HOME', 'DOWN_ARROW'):
        view.press(key)
        yield from redrawn()
    picture("menu")
    view.press('V', "v")                          # Vertices
    yield from until(lambda: value() != before, "a row is deleted")
    assert value().points.shape[0] == before.points.shape[0] - 1
    yield from redrawn()
    picture("row")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == before, "Ctrl+Z brings it back")
    select_points(rows[int(indices[1, 1])])
    yield from redrawn()
    view.press('X')
    yield from redrawn()
    view.press('V', "v")
    yield from until(lambda: len(nets()[0].data.vertices) < len(rows) or in_net(), "Blender deletes the point")
    yield from redrawn()
    yield from redrawn()
    picture("point")
    assert value() == before, "the shape stays where a single point is deleted"
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from redrawn()
    assert value() == before


def saved(view):
    """In the net, by Ctrl+S; what is opened has the shape selected."""
    with view.override():
        bpy.ops.wm.save_as_mainfile(filepath=str(PATH))
    yield from until(in_net, "the net is there again after saving")
    stamp, was = PATH.stat().st_mtime_ns, value()
    view.move(420, 420)
    view.press('S', ctrl=True)
    yield from until(lambda: PATH.stat().st_mtime_ns > stamp and in_net(), "Ctrl+S saves, and stays in the net")
    bpy.ops.wm.open_mainfile(filepath=str(PATH))
    yield from redrawn()
    view = View()
    view.move(420, 420)
    assert not nets() and value() == was
    assert bpy.context.object.name == NAMES['sheet'] and bpy.context.object.select_get()
    view.press('TAB')
    yield from into_net()
    picture("opened")
    view.press('A')
    yield from redrawn()
    yield from by_keys.keys(view, "G Z 0.5 Enter")
    yield from until(lambda: value() != was, "the net of the opened file moves the shape")
    view.press('TAB')
    yield from out_of_net()


def together(view):
    """Two nets at once: one G moves both shapes."""
    view = View()
    view.move(420, 690)
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
    yield from by_keys.add(view, "Surface > NURBS > Bezier Patch")
    yield from until(lambda: bpy.context.object.name != NAMES['sheet'], "another patch")
    NAMES['other'] = bpy.context.object.name
    yield from by_keys.keys(view, "G Y 3 Enter")
    yield from by_keys.see_all(view)
    yield from by_keys.choose(view, NAMES['sheet'], NAMES['other'])
    before = value('sheet'), value('other')
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH' and len(nets()) == 2, "two nets")
    yield from redrawn()
    view.press('A')
    yield from redrawn()
    yield from by_keys.keys(view, "G Z 1 Enter")
    yield from until(lambda: value('sheet') != before[0] and value('other') != before[1], "both shapes move")
    picture("together")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: (value('sheet'), value('other')) == before, "Ctrl+Z takes both back")
    view.press('TAB')
    yield from out_of_net()


run(by_keys.one_by_one(scene, alone, snapped, deleted, saved, together))
