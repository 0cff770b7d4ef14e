"""Tools in the view of a net: a knot by the tool's click, weights by dragging points and the dial, the pie, hints."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, empty_file, in_net, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture,
                    select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
STATE = part('bridge.file_state').state
NAMES = []


def picture(name):
    return save_picture(OUTPUT / f"tools-{name}.png")


def value():
    return bpy.data.objects[NAMES[-1]].data.splinewright.value


def pixel_of(view, point):
    place = view3d_utils.location_3d_to_region_2d(view.region, view.area.spaces.active.region_3d, Vector(point))
    return round(view.region.x + place.x), round(view.region.y + place.y)


def added(view, operator):
    with view.override():
        empty_file()
        operator('EXEC_DEFAULT', True)
        NAMES.append(bpy.context.object.name)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()


def choose(view, name):
    with view.override():
        bpy.ops.wm.tool_set_by_id(name=name)
    yield from redrawn()


def chosen():
    ob = nets()[0]
    return part('bridge.net.selection').selected(ob, part('bridge.net.live').session(ob.data).net)


def weights():
    return np.asarray(value().weights) if value().weights is not None else np.ones(np.shape(value().points)[:-1])


def point(i):
    ob = nets()[0]
    return Vector(part('bridge.net.live').session(ob.data).points[i])


def knots_by_the_tool(view):
    """The knot is shown without any click; a click puts it there; beside the shape it selects."""
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    before = value()
    start, end = before.domain
    picture("toolbar")
    yield from choose(view, "splinewright.insert_knot")
    view.move(*pixel_of(view, point(1)))
    view.press('LEFTMOUSE')
    yield from until(lambda: chosen() == [1], "a click beside the curve selects")
    yield from redrawn()
    plain = picture("insert-none")
    u = start + 0.3 * (end - start)
    view.move(*pixel_of(view, before.evaluate(u)))
    yield from redrawn()
    yield from until(lambda: mean_difference(picture("insert"), plain) > 0.002, "the knot is shown at the mouse")
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != before, "a click inserts")
    yield from into_net()
    after = value()
    assert len(after.knots) == len(before.knots) + 1 and np.abs(np.asarray(after.knots) - u).min() < 0.05
    picture("inserted")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from into_net()
    print("knots by the tool", flush=True)


def drag(view, at, by, keys=()):
    view.move(*at)
    yield from redrawn()
    view.window.event_simulate('LEFTMOUSE', 'PRESS', x=view.x, y=view.y)
    yield from redrawn()
    for step in range(1, 6):
        view.move(at[0] + by * step // 5, at[1])
        yield from redrawn()


def release(view):
    view.window.event_simulate('LEFTMOUSE', 'RELEASE', x=view.x, y=view.y)


def weights_by_the_tool(view):
    yield from choose(view, "splinewright.weight")
    before, i = value(), 2
    place = pixel_of(view, point(i))
    yield from drag(view, place, 120)
    yield from until(lambda: STATE.weighing is not None and weights()[i] > 1.2, "the curve follows the weight")
    picture("weight-drag")
    view.press('ESC')
    yield from until(lambda: STATE.weighing is None, "Esc ends it")
    assert value() == before
    release(view)
    yield from redrawn()
    yield from drag(view, place, -120)
    release(view)
    yield from until(lambda: STATE.weighing is None and weights()[i] < 0.8, "the button lets it go")
    assert chosen() == [i]
    yield from redrawn()
    picture("weight-dial")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes the weight back")
    yield from until(in_net, "the net")
    print("weights by the tool", flush=True)


def steps():
    view = View()
    yield from knots_by_the_tool(view)
    yield from weights_by_the_tool(view)
    print("tools were used:", bpy.app.version_string, flush=True)


run(steps())
