"""Tools in the view of a net: a knot by the tool's click, weights by dragging points and the dial, the pie, hints."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, value
from window import (View, in_net, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture,
                    select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
STATE = part('ui.ui_state').ui_state


def picture(name):
    return save_picture(OUTPUT / f"tools-{name}.png")


def net_of(view, operator):
    """Steps that bring the net of a new shape out, large in the view."""
    yield from added(view, operator)
    view.area.spaces.active.region_3d.view_distance = 1.4 * max(bpy.context.object.dimensions)     # versions differ
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
    """The knot is shown without any click; a click puts it there; on a point it selects."""
    yield from net_of(view, bpy.ops.splinewright.add_nurbs_curve)
    before = value()
    start, end = before.domain
    picture("toolbar")
    yield from choose(view, "splinewright.insert_knot")
    view.move(*view.pixel_of(point(1)))
    view.press('LEFTMOUSE')
    yield from until(lambda: chosen() == [1], "a click on a point selects")
    yield from redrawn()
    plain = picture("insert-none")
    u = start + 0.15 * (end - start)
    view.move(*view.pixel_of(before.evaluate(u)))
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


def press(view, at):
    view.move(*at)
    yield from redrawn()
    view.window.event_simulate('LEFTMOUSE', 'PRESS', x=view.x, y=view.y)
    yield from redrawn()


def drag(view, at, by):
    yield from press(view, at)
    for step in range(1, 6):
        view.move(at[0] + by * step // 5, at[1])
        yield from redrawn()


def release(view):
    view.window.event_simulate('LEFTMOUSE', 'RELEASE', x=view.x, y=view.y)


def weights_by_the_tool(view):
    """A point that is dragged sideways: Esc, the button let go, a click that only selects."""
    yield from choose(view, "splinewright.weight")
    before, i = value(), 2
    place = view.pixel_of(point(i))
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
    assert chosen() == [i] and float(f"{weights()[i]:.4g}") == weights()[i], "the number that was shown"
    yield from redrawn()
    picture("weight-dial")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes the weight back")
    yield from until(in_net, "the net")
    yield from redrawn()
    yield from press(view, view.pixel_of(point(4)))
    release(view)
    yield from until(lambda: chosen() == [4] and STATE.weighing is None, "a click selects")
    assert value() == before
    print("weights by the tool", flush=True)


def weights_by_the_dial(view):
    """The ring around the selected point is dragged, also where its switch shows it with another tool."""
    yield from choose(view, "builtin.select_box")
    select_points(2)
    yield from redrawn()
    plain, before = picture("no-dial"), value()
    bpy.context.scene.splinewright_sights.weights = True
    yield from redrawn()
    yield from until(lambda: mean_difference(picture("dial"), plain) > 0.002, "the dial")
    x, y = view.pixel_of(point(2))
    places = [(x + reach, y) for reach in range(14, 40, 2)]

    def is_hit():
        return bool(STATE.weighing)
    for place in places:
        yield from press(view, place)
        if is_hit():
            break
        release(view)
        yield from redrawn()
        select_points(2)
        yield from redrawn()
    assert is_hit(), "the dial is nowhere"
    view.move(x + 150, y)
    yield from until(lambda: weights()[2] > 1.2, "the curve follows the dial")
    for key, text in (('ZERO', "0"), ('PERIOD', "."), ('FIVE', "5")):
        view.press(key, text)
    yield from until(lambda: weights()[2] == 0.5, "the number that was typed")
    picture("dial-typed")
    release(view)
    view.press('RET')
    yield from until(lambda: STATE.weighing is None, "Return ends it")
    assert weights()[2] == 0.5
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from until(in_net, "the net")
    bpy.context.scene.splinewright_sights.weights = False
    yield from redrawn()
    print("weights by the dial", flush=True)


def weights_by_the_menu(view):
    """Without a button held: a negative weight is drawn as a warning, 0 is refused."""
    before = value()
    select_points(2)
    yield from redrawn()
    view.move(*view.pixel_of(point(2)))
    with view.override():
        bpy.ops.splinewright.weight_here('INVOKE_DEFAULT', True)
    yield from until(lambda: STATE.weighing, "it began")
    for key, text in (('THREE', "3"), ('MINUS', "-")):
        view.press(key, text)
    yield from until(lambda: weights()[2] == -3.0, "a negative weight")
    yield from redrawn()
    picture("negative")
    assert STATE.weighing.is_warning
    for _ in range(2):
        view.press('BACK_SPACE')
    view.press('ZERO', "0")
    yield from until(lambda: STATE.weighing.text == "Weight 0", "a weight of 0")
    assert STATE.weighing.is_warning
    yield from redrawn()
    picture("zero")
    view.press('RET')
    yield from redrawn()
    assert STATE.weighing, "Return does not take what the header says no to"
    view.press('ESC')
    yield from until(lambda: STATE.weighing is None, "Esc ends it")
    assert value() == before
    print("weights by the menu", flush=True)


def the_pie(view):
    """Its key, and the entry to the left."""
    view.move(view.region.x + view.region.width // 2, view.region.y + view.region.height // 2)
    yield from redrawn()
    plain = picture("no-pie")
    view.press('Q', shift=True)
    yield from until(lambda: mean_difference(picture("pie"), plain) > 0.3, "the pie")
    yield from redrawn()
    picture("pie")
    view.move(view.x - 120, view.y)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from redrawn()
    view.move(*view.pixel_of(value().evaluate(sum(value().domain) / 2)))
    yield from until(lambda: STATE.aimed is not None, "Insert Knot was the entry to the left")
    view.press('ESC')
    yield from until(lambda: STATE.aimed is None, "Esc ends it")
    print("the pie", flush=True)


def hints(view):
    """The line of keys is there while the net is, and switched off by the preferences."""
    status = np.s_[-22:, :500]
    yield from redrawn()
    out = picture("hints")[status]
    view.press('TAB')
    yield from out_of_net()
    yield from until(lambda: mean_difference(picture("no-hints")[status], out) > 0.5, "they go with the net")
    gone = picture("no-hints")[status]
    view.press('TAB')
    yield from into_net()
    yield from until(lambda: mean_difference(picture("hints")[status], gone) > 0.5, "they come with the net")
    preferences = part('ui.preferences').get()
    preferences.show_hints = False
    yield from until(lambda: mean_difference(picture("hints-off")[status], gone) < 0.3, "the preferences switch them off")
    preferences.show_hints = True
    view.press('TAB')
    yield from out_of_net()
    print("hints", flush=True)


def on_a_patch(view):
    """Isocurves at the mouse, along what the header says; a plain mesh has neither tools nor their keys."""
    yield from net_of(view, bpy.ops.splinewright.add_nurbs_patch)
    before = value()
    (u0, u1), (v0, v1) = before.domain
    yield from choose(view, "splinewright.insert_knot")
    settings = part('ui.toolbar').settings(bpy.context, part('ui.tool_table').TOOLS["insert_knot"])
    settings.direction = 'BOTH'
    grid = [(u, v) for u in np.linspace(u0, u1, 9)[1:-1] for v in np.linspace(v0, v1, 10)[1:-1]]
    view.move(*next(pixel for pixel in (view.pixel_of(before.evaluate(*at)) for at in grid)
                    if part('ui.operators.insert_here').aimed_at(bpy.context, *pixel, 'BOTH')))
    yield from redrawn()
    yield from redrawn()
    picture("patch")
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != before, "a click inserts")
    yield from into_net()
    assert [len(after) - len(knots) for after, knots in zip(value().knots, before.knots)] == [1, 1]
    yield from choose(view, "splinewright.weight")
    view.press('TAB')
    yield from out_of_net()
    with view.override():
        bpy.ops.mesh.primitive_cube_add()
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.view3d.view_selected()
    view.area.spaces.active.region_3d.view_distance = 12.0
    yield from redrawn()
    picture("cube")
    bpy.ops.mesh.select_all(action='DESELECT')
    yield from redrawn()
    cube = bpy.context.object
    view.move(*view.pixel_of(cube.matrix_world @ cube.data.vertices[7].co))
    view.press('LEFTMOUSE')
    yield from until(lambda: cube.data.total_vert_sel == 1, "a click on a cube selects, whatever tool is chosen")
    print("on a patch", flush=True)


def is_border(number):
    return number // 6 in (0, 5) or number % 6 in (0, 5)


def clicked_at(view, number, away=(0, 0), **modifiers):
    x, y = view.pixel_of(point(number))
    view.move(x + away[0], y + away[1])
    yield from redrawn()
    view.press('LEFTMOUSE', **modifiers)
    yield from redrawn()
    yield from redrawn()


def seen_from_below(view):
    """Clicks take no point that the surface hides, but with X-ray or X-Ray Control Points; all else they do as ever."""
    yield from net_of(view, bpy.ops.splinewright.add_nurbs_patch)
    eye, was = view.area.spaces.active.region_3d, view.area.spaces.active.region_3d.view_rotation.copy()
    with view.override():
        bpy.ops.view3d.view_axis(type='BOTTOM')
    shading, sights = view.area.spaces.active.shading, bpy.context.scene.splinewright_sights
    for tool in ("builtin.select_box", "builtin.select", "builtin.move"):
        yield from choose(view, tool)
        before = value()
        select_points()
        yield from clicked_at(view, 8)
        assert not [number for number in chosen() if not is_border(number)], (tool, chosen())
        yield from clicked_at(view, 8, away=(0, 4), shift=True)
        assert not [number for number in chosen() if not is_border(number)], (tool, chosen())
        for owner, name in ((shading, 'show_xray'), (sights, 'points_behind')):
            setattr(owner, name, True)
            yield from redrawn()
            yield from clicked_at(view, 8)
            yield from until(lambda: chosen() == [8], f"{name} lets {tool} take what is behind")
            setattr(owner, name, False)
            yield from redrawn()
        yield from clicked_at(view, 2, away=(3, 2))
        yield from until(lambda: chosen() == [2], f"{tool} takes what is seen")
        yield from clicked_at(view, 3, away=(3, 2), shift=True)
        yield from until(lambda: chosen() == [2, 3], f"{tool} takes one more with Shift")
        assert value() == before, (tool, "a click changes nothing")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    yield from choose(view, "builtin.select_box")
    yield from clicked_at(view, 8, away=(0, 4))
    assert not [number for number in chosen() if not is_border(number)], chosen()
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    yield from dragged_from_hidden(view)
    eye.view_perspective, eye.view_rotation = 'PERSP', was
    print("seen from below", flush=True)


def dragged_from_hidden(view):
    """A press near a hidden point and a seen one begins what it begins elsewhere, with the seen one."""
    for tool, operator in (("builtin.select_box", 'VIEW3D_OT_select_box'), ("builtin.select", 'TRANSFORM_OT_translate')):
        yield from choose(view, tool)
        (x, y), (right, up) = view.pixel_of(point(8)), view.pixel_of(point(2))
        x, y = round(0.52 * x + 0.48 * right), round(0.52 * y + 0.48 * up)
        for step in view.drag([(x, y), (x + 6, y + 8), (x + 30, y + 30), (x + 60, y + 60)]):
            yield from redrawn()
        release(view)
        yield from redrawn()
        if bpy.context.window_manager.operators[-1].bl_idname != operator:
            view.press('LEFTMOUSE')     # where the drag does not end with the button
        yield from until(lambda: bpy.context.window_manager.operators[-1].bl_idname == operator, operator)
    with view.override():
        bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    yield from out_of_net()


def switched_off(view):
    """The add-on goes while a tool of its is in use, and comes again."""
    cube = bpy.context.object
    part('ui').unregister()
    bpy.ops.mesh.select_all(action='DESELECT')
    view.move(view.x + 40, view.y + 40)
    yield from redrawn()
    picture("switched-off")
    yield from choose(view, "builtin.select_box")
    view.move(*view.pixel_of(cube.matrix_world @ cube.data.vertices[7].co))
    view.press('LEFTMOUSE')
    yield from until(lambda: cube.data.total_vert_sel == 1, "a click selects")
    part('ui').register()
    yield from redrawn()
    bpy.ops.object.mode_set(mode='OBJECT')
    yield from net_of(view, bpy.ops.splinewright.add_nurbs_curve)
    yield from choose(view, "splinewright.weight")
    yield from drag(view, view.pixel_of(point(2)), 120)
    yield from until(lambda: weights()[2] > 1.2, "the tool works again")
    release(view)
    yield from until(lambda: STATE.weighing is None, "the button lets it go")
    print("switched off and on", flush=True)


def steps():
    view = View()
    yield from knots_by_the_tool(view)
    yield from weights_by_the_tool(view)
    yield from weights_by_the_dial(view)
    yield from weights_by_the_menu(view)
    yield from the_pie(view)
    yield from hints(view)
    yield from seen_from_below(view)
    yield from on_a_patch(view)
    yield from switched_off(view)
    print("tools were used:", bpy.app.version_string, flush=True)


run(steps())
