"""Points more and less in the net of a curve, in a real window: E with the mouse, Subdivide, X, and Ctrl+Z through them."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
KINDS = {'nurbs': 'add_nurbs_curve', 'chain': 'add_hermite_curve'}


def value(name):
    return bpy.data.objects[name].data.splinewright.value


def points():
    spline = nets()[0].data.splines[0]
    return spline.bezier_points if spline.type == 'BEZIER' else spline.points


def is_selected(point):
    return point.select_control_point if hasattr(point, 'select_control_point') else point.select


def choose(*places):
    """Select points by their places, as an undo step."""
    bpy.ops.curve.select_all(action='DESELECT')
    for place in places:
        point = points()[place]
        for name in ('select', 'select_control_point', 'select_left_handle', 'select_right_handle'):
            if hasattr(point, name):
                setattr(point, name, True)
    nets()[0].data.update_tag()
    bpy.ops.ed.undo_push(message="choose")


def look(name):
    return save_picture(OUTPUT / f"growing-{name}.png")


def said():
    live = part('bridge.net.live')
    return live.problem(nets()[0]), live.note(nets()[0])


def last_operator():
    operators = bpy.context.window_manager.operators
    return operators[-1].bl_idname if len(operators) else ""


def extrude(view, count, name, x, y):
    """E, the mouse away, a click: until there is a point more, the shape follows, and the operator has ended."""
    before = value(name)
    view.press('E')
    yield from until(lambda: len(points()) == count + 1, "E makes a copy")
    for part_of_way in (1, 2, 3):
        view.move(view.x + x // 3, view.y + y // 3)
        yield from redrawn()
    yield from until(lambda: len(value(name).to_nurbs().points) > len(before.to_nurbs().points), "the shape has a point more")
    was = value(name)
    view.move(view.x + x // 3, view.y + y // 3)
    yield from until(lambda: value(name) != was, "the shape follows while it is dragged")
    view.press('LEFTMOUSE')
    yield from until(lambda: last_operator().startswith('CURVE_OT_extrude'), "the click ends it")
    yield from redrawn()
    assert said() == ("", ""), said()


def undo_until(view, name, wanted, redo=False):
    """Ctrl+Z, or with Shift, until the shape has this value."""
    done = []
    handlers = bpy.app.handlers.redo_post if redo else bpy.app.handlers.undo_post
    handlers.append(lambda *_: done.append(1))
    for count in range(1, 13):
        if value(name) == wanted:
            return
        view.press('Z', ctrl=True, shift=redo)
        yield from until(lambda: len(done) == count, "Ctrl+Z")
    assert value(name) == wanted, "undo does not lead there"


def grown(view, kind):
    """A curve's net gains two points at its end, one between two, loses one, and goes back through all that."""
    empty_file()
    with view.override():
        getattr(bpy.ops.splinewright, KINDS[kind])('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
    name = bpy.context.object.name
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    first, count = value(name), len(points())
    empty = look(f"{kind}-before")
    choose(-1)
    yield from extrude(view, count, name, 60, 30)
    assert [is_selected(point) for point in points()] == [False] * count + [True]
    yield from extrude(view, count + 1, name, -30, 90)
    longer = value(name)
    assert mean_difference(look(f"{kind}-extruded"), empty) > 0.05
    choose(0, 1)
    with view.override():
        bpy.ops.curve.subdivide('EXEC_DEFAULT', True)
    yield from until(lambda: value(name) != longer, "the shape has a knot more")
    cut = value(name)
    assert cut.to_nurbs().largest_distance(longer.to_nurbs()) < 1e-9, "the shape did not stay"
    look(f"{kind}-cut")
    choose(3)
    with view.override():
        bpy.ops.curve.delete('EXEC_DEFAULT', True, type='VERT')
    yield from until(lambda: value(name) != cut, "a point less")
    less = value(name)
    yield from until(lambda: "lies within" in said()[1], "how near it is")
    look(f"{kind}-deleted")
    yield from undo_until(view, name, cut)
    yield from undo_until(view, name, longer)
    yield from undo_until(view, name, first)
    assert len(points()) == count and said() == ("", "")
    yield from undo_until(view, name, less, redo=True)
    assert len(points()) == count + 2
    yield from redrawn()
    view.press('TAB')
    yield from out_of_net()
    assert value(name) == less
    view.press('TAB')
    yield from into_net()
    assert len(points()) == count + 2
    yield from called_off(view, name)
    view.press('TAB')
    yield from out_of_net()
    assert value(name) != less and len(value(name).points) == len(less.points)
    print(kind, "grew and shrank", flush=True)


def called_off(view, name):
    """E, the mouse away, Esc: no point more, and the end itself is in hand and moves."""
    before, count = value(name), len(points())
    choose(-1)
    view.press('E')
    yield from until(lambda: len(points()) == count + 1, "E makes a copy")
    view.move(view.x + 50)
    yield from until(lambda: value(name) != before, "the shape has a point more")
    view.press('ESC')
    yield from until(lambda: value(name) == before, "Esc takes it back")
    yield from until(lambda: is_selected(points()[count - 1]) and not is_selected(points()[count]), "the end is in hand")
    view.press('G')
    yield from redrawn()
    view.move(view.x + 40, view.y + 40)
    yield from until(lambda: value(name) != before, "the end moves")
    view.press('LEFTMOUSE')
    yield from until(lambda: last_operator() == 'TRANSFORM_OT_translate', "the drag has ended")
    assert len(value(name).points) == len(before.points) and said()[0] == ""
    rows = np.flatnonzero((value(name).points != before.points).any(-1))
    assert rows.tolist() == [len(before.points) - 1], rows


def steps():
    view = View()
    for kind in KINDS:
        yield from grown(view, kind)
    print("points came and went:", bpy.app.version_string, flush=True)


run(steps())
