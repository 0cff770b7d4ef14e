"""What goes wrong in a net, in a real window: E and Esc, points that were deleted, saves that fail, undo turned off."""

import os
import sys
import tempfile
from pathlib import Path

import bmesh
import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (
    View, empty_file, in_net, into_net, nets, out_of_net, part, redrawn, run, save_picture, select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAME = "NURBS Patch"
#: Rows of the picture that are the status bar, and the columns left of the sidebar's place.
STATUS, VIEW = slice(778, 800), slice(0, 830)


def value():
    return bpy.data.objects[NAME].data.splinewright.value


def problem():
    return part('bridge.net.live').problem(nets()[0])


def selected():
    """Numbers of the selected vertices of the net, copies of points left out."""
    ob = nets()[0]
    return part('bridge.net.selection').selected(ob, part('bridge.net.live').session(ob.data).net)


def vertex_count():
    return len(bmesh.from_edit_mesh(nets()[0].data).verts)


def last_operator():
    operators = bpy.context.window_manager.operators
    return operators[-1].bl_idname if len(operators) else ""


def warned(picture):
    """How many pixels have the color of a warning."""
    color = np.array(part('ui.messages').WARNING[:3]) * 255
    # The outline of a selected object is not far from it: its green is 29 brighter.
    return int((np.abs(picture[:, VIEW].astype(int) - color) < (35, 17, 30)).all(-1).sum())


def is_quiet(picture):
    """Whether no warning stands in a view: a line of it has hundreds of pixels, what is selected a few like it."""
    return warned(picture) < 100


def look(name):
    return save_picture(OUTPUT / f"stray-{name}.png")


def undo_until(view, is_so, what):
    """Ctrl+Z, until it is so."""
    undone = []
    bpy.app.handlers.undo_post.append(lambda *_: undone.append(1))
    for count in range(1, 11):
        if is_so():
            return
        view.press('Z', ctrl=True)
        yield from until(lambda: len(undone) == count, "Ctrl+Z")
    assert is_so(), what


def drag(view, up, changed_from):
    """G, the mouse up, a click; until the shape followed and the operator has ended."""
    yield from redrawn()
    view.press('G')
    yield from redrawn()
    for _ in range(3):
        view.move(y=view.y + up // 3)
        yield from redrawn()
    yield from until(lambda: value() != changed_from, "the shape follows the drag")
    view.press('LEFTMOUSE')
    yield from until(lambda: last_operator() == 'TRANSFORM_OT_translate', "the drag has ended")
    view.move(420, 420)


def extruded_and_called_off(view):
    """The point that was in hand is moved, as if E and Esc had not been."""
    view.press('TAB')
    yield from into_net()
    select_points(14)
    before = value()
    for moved in (False, True):
        count = vertex_count()
        view.press('E')
        yield from until(lambda: vertex_count() == count + 1, "E makes a copy")
        if moved:
            view.move(y=view.y + 40)
            yield from redrawn()
        view.press('ESC')
        yield from until(lambda: selected() == [14], "the point is selected, not its copy")
        assert value() == before and problem() == "", "E and Esc moved the shape"
        view.move(420, 420)
        yield from drag(view, 60, before)
        rows = np.flatnonzero((value().points != before.points).any(-1))
        assert rows.tolist() == [14], f"points {rows} moved"
        before = value()
    yield from redrawn()
    assert is_quiet(look("extruded"))
    view.press('TAB')
    yield from out_of_net()
    assert value() == before
    print("extruded and called off", flush=True)


def drawn_once(view):
    """What is drawn over the net is worked out when it changes: its points, or what of it is selected."""
    view.press('TAB')
    yield from into_net()
    state, key = part('bridge.data.file_state').state, part('bridge.data.file_state').key

    def strokes():
        view.area.tag_redraw()
        look("strokes")
        return state.drawn[key(nets()[0].data)]

    first = strokes()
    assert strokes() is first, "worked out anew without need"
    view.press('A')
    yield from until(lambda: len(selected()) == 36, "all are selected")
    everything = strokes()
    assert everything is not first and strokes() is everything
    view.press('A', alt=True)
    yield from until(lambda: selected() == [], "none is selected")
    assert strokes() is not everything
    view.press('TAB')
    yield from out_of_net()
    print("drawn once", flush=True)


def deleted(view):
    """A point is deleted: said in view and status bar; Tab asks; Ctrl+Z takes it back."""
    view.press('TAB')
    yield from into_net()
    before, well = value(), look("well")
    select_points(7)
    with view.override():
        bpy.ops.mesh.delete('EXEC_DEFAULT', True, type='VERT')
    yield from until(lambda: "lost points" in problem(), "the problem")
    yield from until(lambda: warned(look("deleted")) > 300, "the warning in the view")
    picture = look("deleted")
    assert np.abs(picture[STATUS].astype(int) - well[STATUS]).mean() > 0.5, "nothing in the status bar"
    view.press('TAB')
    yield from until(lambda: np.abs(look("asked").astype(int) - picture).mean() > 1, "the question")
    assert in_net()
    view.press('ESC')
    yield from redrawn()
    view.move(300, 300)                 # a dialog goes when the mouse does
    yield from until(lambda: np.abs(look("stayed")[:, VIEW].astype(int) - picture[:, VIEW]).mean() < 0.5, "no question")
    assert in_net() and "lost points" in problem() and value() == before, "Esc left the net"
    view.move(420, 420)
    view.press('TAB')
    yield from until(lambda: np.abs(look("asked").astype(int) - picture).mean() > 1, "the question again")
    view.press('RET')
    yield from out_of_net()
    assert value() == before and is_quiet(look("left"))
    yield from undo_until(view, lambda: in_net() and "lost points" in problem(), "Ctrl+Z leads back")
    yield from undo_until(view, lambda: in_net() and problem() == "", "Ctrl+Z brings the point back")
    yield from redrawn()
    taken_back = look("taken-back")
    assert is_quiet(taken_back) and value() == before
    assert np.abs(taken_back[STATUS].astype(int) - well[STATUS]).mean() < 0.5, "the status bar says something still"
    print("deleted", flush=True)


def left_by_another_way(view):
    """A net that holds what its shape does not take stays as an object; Tab on it goes on."""
    select_points(7)
    with view.override():
        bpy.ops.mesh.delete('EXEC_DEFAULT', True, type='VERT')
    yield from until(lambda: "lost points" in problem(), "the problem")
    with view.override():
        bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    kept = part('ui.ui_state').ui_state.kept
    yield from until(lambda: len(kept) == 1 and nets()[0].mode == 'OBJECT', "the net is kept")
    yield from until(lambda: warned(look("kept")) > 300, "the warning in the view")
    view.press('TAB')
    yield from until(in_net, "Tab goes on with the net")
    assert "lost points" in problem()
    with view.override():
        bpy.ops.splinewright.renew_net('EXEC_DEFAULT', True)
    yield from until(lambda: in_net() and problem() == "" and vertex_count() == 36, "a net with all points")
    yield from redrawn()
    assert is_quiet(look("renewed"))
    print("left by another way", flush=True)


def failed_save(view):
    """Blender 3.4 tells nobody of it; the net is out again all the same."""
    before = value()
    select_points(14)
    try:
        bpy.ops.wm.save_as_mainfile(filepath=str(Path(tempfile.mkdtemp()) / "no folder" / "x.blend"))
    except RuntimeError:
        pass
    yield from until(in_net, "the net after the save failed")
    yield from drag(view, 60, before)
    view.press('TAB')
    yield from out_of_net()
    print("failed save", flush=True)


def without_global_undo(view):
    """In, a move, out, and back by Ctrl+Z."""
    bpy.context.preferences.edit.use_global_undo = False
    view.press('TAB')
    yield from into_net()
    select_points(14)
    before = value()
    yield from drag(view, 60, before)
    moved = value()
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT' and bpy.context.object.name == NAME, "out of the net")
    view.press('Z', ctrl=True)
    yield from until(lambda: bpy.context.mode == 'EDIT_MESH' and nets()[0].users_scene, "back in the net")
    yield from undo_until(view, lambda: value() == before, "the move is undone")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: value() == moved, "and redone")
    view.press('TAB')
    yield from until(lambda: bpy.context.mode == 'OBJECT' and bpy.context.object.name == NAME, "out of the net")
    bpy.context.preferences.edit.use_global_undo = True
    print("without global undo", flush=True)


def steps():
    view = View()
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()
    for part_of_it in (drawn_once, extruded_and_called_off, deleted, left_by_another_way, failed_save, without_global_undo):
        yield from part_of_it(view)
    print("nothing was lost:", bpy.app.version_string, flush=True)


run(steps())
