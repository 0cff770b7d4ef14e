"""A patch of 100 × 100 points, through the points of a mesh grid, is dragged in its net by the mouse: it follows every move, has not
many more faces than points, and a step costs little more than one of a plain mesh of as many points. Undone, done again."""

import os
import sys
import time
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import in_net, into_net, out_of_net, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
COUNT, MOVES = 100, 8
#: Seconds of the processor that a step may cost beyond one of a plain mesh, most of it for drawing without a graphics card.
BEYOND = 0.6
NAMES, SPENT = {}, {}


def picture(name):
    return save_picture(OUTPUT / f"large-{name}.png")


def value():
    return bpy.data.objects[NAMES['patch']].data.splinewright.value


def grid(view):
    """In its Edit Mode all of it becomes one patch."""
    with view.override():
        bpy.ops.mesh.primitive_grid_add('EXEC_DEFAULT', True, x_subdivisions=COUNT - 1, y_subdivisions=COUNT - 1, size=6)
        NAMES['grid'] = bpy.context.object.name
        bpy.ops.ed.undo_push(message="grid")
    yield from by_keys.see_all(view)
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Tab enters the grid")
    view.press('A')
    yield from redrawn()
    yield from by_keys.search(view, "patch through grid")
    yield from until(lambda: len(bpy.data.objects) == 2, "F3 finds Patch Through Grid")
    if bpy.context.mode == 'EDIT_MESH':
        view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Tab leaves the grid")
    NAMES['patch'] = next(name for name in bpy.data.objects.keys() if name != NAMES['grid'])
    assert value().points.shape[:2] == (COUNT, COUNT), value().points.shape
    assert len(bpy.data.objects[NAMES['patch']].data.vertices) < 4 * COUNT * COUNT


def steps_of(view, name, has_moved):
    """Steps of G with the mouse; what one of them costs with all that is drawn."""
    view.move(420, 420)
    view.press('G')
    yield from redrawn()
    view.move(view.x, view.y + 4)
    yield from redrawn()
    start = time.process_time()
    for _ in range(MOVES):
        before = has_moved()
        view.move(view.x, view.y + 6)
        yield from redrawn()
        yield from until(lambda: has_moved() != before, "it follows this move")
    SPENT[name] = (time.process_time() - start) / MOVES
    picture(name)
    view.press('LEFTMOUSE')
    yield from redrawn()


def plain(view):
    """The grid itself."""
    yield from by_keys.choose(view, NAMES['grid'])
    bpy.data.objects[NAMES['patch']].hide_set(True)
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Tab enters the grid")
    with view.override():
        bpy.ops.mesh.select_all(action='DESELECT')
        bpy.context.object.update_from_editmode()
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Tab leaves the grid")
    middle = bpy.context.object.data.vertices[COUNT * COUNT // 2 + COUNT // 2]
    middle.select = True
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH', "Tab enters the grid")
    yield from redrawn()

    def place():
        view.window.view_layer.objects.active.update_from_editmode()
        return tuple(bpy.data.objects[NAMES['grid']].data.vertices[COUNT * COUNT // 2 + COUNT // 2].co)
    yield from steps_of(view, 'plain', place)
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Tab leaves the grid")
    bpy.data.objects[NAMES['patch']].hide_set(False)
    bpy.data.objects[NAMES['grid']].hide_set(True)


def net(view):
    yield from by_keys.choose(view, NAMES['patch'])
    view.press('TAB')
    yield from into_net()
    before = value()
    select_points(COUNT * COUNT // 2 + COUNT // 2)
    yield from redrawn()
    yield from steps_of(view, 'net', lambda: value().points[COUNT // 2, COUNT // 2].tobytes())
    yield from redrawn()
    after = value()
    moved = (after.points != before.points).any(-1)
    assert moved.sum() == 1, "one point is dragged, and no other one moves"
    print(f"a step of a plain grid {SPENT['plain']:.2f} s, of a net {SPENT['net']:.2f} s of the processor", flush=True)
    assert SPENT['net'] < SPENT['plain'] + BEYOND, SPENT
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == before and in_net(), "Ctrl+Z")
    yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from until(lambda: value() == after, "Ctrl+Shift+Z")
    view.press('TAB')
    yield from out_of_net()
    picture("left")


run(by_keys.one_by_one(grid, plain, net))
