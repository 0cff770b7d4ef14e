"""Rows that come and go in the net of a patch, by Blender's own keys in a real window: E, Ctrl+R, X, undo and redo."""

import os
import sys
from pathlib import Path

import bmesh
import bpy
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from window import (
    View, empty_file, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture, select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAME = "NURBS Patch"


def value():
    return bpy.data.objects[NAME].data.splinewright.value


def size():
    return value().points.shape[:2]


def net():
    return part('bridge.net.live').session(nets()[0].data).net


def place_of(vertices):
    """The middle of vertices of the net, as it is now."""
    return part('bridge.net.live').session(nets()[0].data).points[vertices].astype(float).mean(0)


def row(axis, place):
    """The vertices of a row of the net."""
    return np.take(part('core.net.cage_rows').grids(net())[0], place, axis).tolist()


def vertex_count():
    return len(bmesh.from_edit_mesh(nets()[0].data).verts)


def said():
    live = part('bridge.net.live')
    return live.problem(nets()[0]), live.note(nets()[0])


def is_waiting():
    return part('bridge.net.live').is_waiting(nets()[0])


def last_operator():
    operators = bpy.context.window_manager.operators
    return operators[-1].bl_idname if len(operators) else ""


def look(name):
    return save_picture(OUTPUT / f"rows-{name}.png")


def distance(one, other):
    return one.to_nurbs().largest_distance(other.to_nurbs())


def go_to(view, point):
    """The mouse over a point of the net's space."""
    place = view3d_utils.location_3d_to_region_2d(view.region, view.area.spaces.active.region_3d, Vector(point))
    view.move(round(view.region.x + place.x), round(view.region.y + place.y))


def undo_until(view, wanted, redo=False):
    """Ctrl+Z, or with Shift, until the shape has this value."""
    done = []
    handlers = bpy.app.handlers.redo_post if redo else bpy.app.handlers.undo_post
    handlers.append(lambda *_: done.append(1))
    for count in range(1, 16):
        if value() == wanted:
            return
        view.press('Z', ctrl=True, shift=redo)
        yield from until(lambda: len(done) == count, "Ctrl+Z")
    assert value() == wanted, "undo does not lead there"


def extruded(view, axis, end, x, y):
    """E on a border, the mouse away, a click."""
    before, (ended, count) = value(), (len(bpy.context.window_manager.operators), vertex_count())
    border = row(axis, end)
    with view.override():
        bpy.ops.mesh.select_all('EXEC_DEFAULT', True, action='DESELECT')
    go_to(view, place_of(border[1:3]))
    yield from redrawn()
    view.press('LEFTMOUSE', alt=True)
    yield from until(lambda: sorted(selected()) == sorted(border), "Alt+click takes the border")
    view.press('E')
    yield from until(lambda: vertex_count() == count + len(border), "E makes copies")
    for _ in range(3):
        view.move(view.x + x // 3, view.y + y // 3)
        yield from redrawn()
    yield from until(lambda: size()[axis] == before.points.shape[axis] + 1, "the shape has a row more")
    was = value()
    view.move(view.x + x // 3, view.y + y // 3)
    yield from until(lambda: value() != was, "the shape follows while it is dragged")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(bpy.context.window_manager.operators) > ended, "the click ends it")
    yield from redrawn()
    assert said() == ("", ""), said()
    assert sorted(selected()) == sorted(row(axis, end)), "the new row is in hand"


def selected():
    return part('bridge.net.selection').selected(nets()[0], net())


def called_off(view, axis, end):
    """E, the mouse away, Esc: no row more, and the border itself is in hand."""
    before, border, count = value(), row(axis, end), vertex_count()
    select_points(*border)
    yield from redrawn()
    view.press('E')
    yield from until(lambda: vertex_count() == count + len(border), "E makes copies")
    view.move(view.x + 50)
    yield from until(lambda: value() != before, "the shape has a row more")
    view.press('ESC')
    yield from until(lambda: value() == before and selected() == border, "Esc takes it back, the border is in hand")
    view.press('G')
    yield from redrawn()
    view.move(view.x + 40, view.y + 40)
    yield from until(lambda: value() != before, "the border moves")
    assert size() == before.points.shape[:2]
    view.press('ESC')
    yield from until(lambda: value() == before, "and back")
    yield from undo_until_clean(view, count)


def undo_until_clean(view, count):
    done = []
    bpy.app.handlers.undo_post.append(lambda *_: done.append(1))
    for times in range(1, 8):
        if vertex_count() == count:
            return
        view.press('Z', ctrl=True)
        yield from until(lambda: len(done) == times, "Ctrl+Z")
    assert vertex_count() == count


def loop_cut(view, axis, place, slide, end='LEFTMOUSE'):
    """Ctrl+R over an edge between two rows, a click, the mouse along the edge, and a click or a key that ends it."""
    before, count, ended = value(), vertex_count(), len(bpy.context.window_manager.operators)
    ends = np.array([place_of([row(axis, at)[2]]) for at in (place, place + 1)])
    go_to(view, ends.mean(0))
    yield from redrawn()
    view.press('R', ctrl=True)
    yield from redrawn()
    view.move(view.x + 1)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: vertex_count() > count, "the loop is cut")
    yield from until(is_waiting, "the net waits while it is slid")
    assert value() == before
    for part_of_way in (0.2, 0.5, 1.0):
        go_to(view, ends.mean(0) + part_of_way * slide * (ends[1] - ends[0]))
        yield from redrawn()
        assert value() == before and is_waiting() and "has ended" in said()[1], said()
    look(f"sliding-{axis}-{place}")
    view.press(end)
    yield from until(lambda: len(bpy.context.window_manager.operators) > ended, "the slide has ended")
    yield from until(lambda: size()[axis] == before.points.shape[axis] + 1, "the shape has a row more")
    yield from redrawn()
    assert distance(value(), before) < 1e-9 * np.abs(before.points).max(), "the shape did not stay"
    assert said() == ("", "") and not is_waiting(), said()


def is_in_the_middle(before, after, axis, place):
    """Whether the knot that is new lies between those that two rows stand for, as near to one as to the other."""
    (knot,) = np.setdiff1d(after.knots[axis], before.knots[axis])
    ends = [before.knots[axis][i + 1:i + before.degree[axis] + 1].mean() for i in (place, place + 1)]
    return abs(knot - np.mean(ends)) < 0.02 * (ends[1] - ends[0])


def steps():
    view = View()
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
    for keymap, item, name in part('ui.keymaps').of_user():
        item.active = name != "splinewright.insert_here"    # Ctrl+R is Blender's own
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    seen = [value()]
    empty = look("before")
    yield from extruded(view, 0, -1, 45, 15)
    seen.append(value())
    yield from extruded(view, 0, -1, 30, 45)
    yield from extruded(view, 1, 0, -15, -60)
    seen.append(value())
    assert mean_difference(look("extruded"), empty) > 0.05
    yield from called_off(view, 1, -1)
    assert value() == seen[-1]
    yield from loop_cut(view, 0, 2, 0.0)
    seen.append(value())
    assert is_in_the_middle(seen[-2], seen[-1], 0, 2)
    look("cut")
    yield from loop_cut(view, 1, 2, 0.25)
    seen.append(value())
    assert not is_in_the_middle(seen[-2], seen[-1], 1, 2), "the knot is not where the row was slid to"
    yield from loop_cut(view, 1, 4, 0.25, 'RIGHTMOUSE')      # cut in the middle, not slid
    seen.append(value())
    look("cut-all")
    cuts = bpy.context.window_manager.operators[-1].macros[0].properties
    assert cuts.number_cuts == 1
    cuts.number_cuts = 3
    with view.override():
        bpy.ops.ed.undo_redo()
    yield from until(lambda: size()[1] == seen[-1].points.shape[1] + 2, "the redo panel cuts three rows in")
    assert distance(value(), seen[-1]) < 1e-9 and said() == ("", "")
    seen[-1] = value()
    inner = row(0, 3)
    with view.override():
        bpy.ops.mesh.select_mode(type='EDGE')
    select_points(*inner)
    yield from redrawn()
    with view.override():
        bpy.ops.mesh.dissolve_edges('EXEC_DEFAULT', True)
    yield from until(lambda: size()[0] == seen[-1].points.shape[0] - 1, "a row less")
    look("dissolved")
    seen.append(value())
    with view.override():
        bpy.ops.mesh.select_mode(type='VERT')
    select_points(*row(1, 0))
    yield from redrawn()
    view.press('X')
    yield from redrawn()
    view.press('V')
    yield from until(lambda: size()[1] == seen[-1].points.shape[1] - 1, "the border is deleted")
    yield from redrawn()
    assert said() == ("", "")
    look("deleted")
    seen.append(value())
    for wanted in seen[-2::-1]:
        yield from undo_until(view, wanted)
    assert vertex_count() == seen[0].points.shape[0] * seen[0].points.shape[1] and said() == ("", "")
    for wanted in seen[1:]:
        yield from undo_until(view, wanted, redo=True)
    yield from redrawn()
    look("redone")
    view.press('TAB')
    yield from out_of_net()
    assert value() == seen[-1]
    view.press('TAB')
    yield from into_net()
    assert vertex_count() == seen[-1].points.shape[0] * seen[-1].points.shape[1]
    print("rows came and went:", bpy.app.version_string, flush=True)


run(steps())
