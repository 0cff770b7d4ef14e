"""The knot strip: knots dragged by the mouse and by numbers, inserted by a double click, removed by a key; Esc, undo."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, shape, value
from window import (View, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, until,
                    user_item)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
strip, state = part('ui.knot_strip'), part('ui.ui_state').ui_state


def picture(name):
    return save_picture(OUTPUT / f"strip-{name}.png")


def shown(view):
    """What the strip shows."""
    with view.override():
        return strip.shown(bpy.context)


def pixel(view, at, axis=0):
    """Of the window: where a parameter lies on a bar."""
    found = shown(view)
    left, right = found.ends(axis)
    box = found.boxes[axis]
    x = left + float(part('core.verbs.knot_strip').fractions(at, found.spans[axis])) * (right - left)
    return round(view.region.x + x), round(view.region.y + (box.bottom + box.top) / 2)


def button(view, how, **modifiers):
    view.window.event_simulate('LEFTMOUSE', how, x=view.x, y=view.y, **modifiers)


def over(view, at, axis=0):
    """Steps until the mouse is over a parameter of the strip, and it is shown."""
    def is_there():
        wanted = pixel(view, at, axis)
        if (view.x, view.y) != wanted:
            view.move(*wanted)
        pointed = state.pointed_knot
        return pointed is not None and pointed.axis == axis and abs(pointed.value - at) < 0.02
    view.move(view.region.x + 300, view.region.y + 300)
    yield from until(lambda: state.pointed_knot is None, "the mouse elsewhere")
    yield from until(is_there, f"{at} of the strip at the mouse")


def taken(view, at, axis=0):
    """Steps until the knot at a parameter is taken hold of."""
    yield from over(view, at, axis)
    button(view, 'PRESS')
    view.move(view.x + 6, view.y)
    yield from until(lambda: state.moved_knot is not None, "a knot is taken hold of")


def led(view, at, axis=0):
    view.move(*pixel(view, at, axis))
    yield from until(lambda: abs(knots_along(axis)[1:-1] - at).min() < 0.02, "the knot is at the mouse")


def knots_along(axis):
    found = value().knots
    return np.unique(found[axis] if isinstance(found, tuple) else found)


def dragged(view, was, to, axis=0):
    """Steps of a whole drag."""
    before = value()
    yield from taken(view, was, axis)
    yield from led(view, to, axis)
    assert value() != before, "the shape follows"
    button(view, 'RELEASE')
    yield from until(lambda: state.moved_knot is None, "letting go ends it")
    yield from redrawn()


def clicked_twice(view):
    """Steps of a double click. Simulated events are none, whatever their number: another button stands for it."""
    item = user_item('splinewright.insert_on_strip')
    assert (item.type, item.value) == ('LEFTMOUSE', 'DOUBLE_CLICK')
    before, was = value(), shape().select_get()
    button(view, 'PRESS')
    button(view, 'RELEASE')
    yield from redrawn()
    assert value() == before and shape().select_get() == was, "a click on the bar does nothing"
    item.type, item.value = 'BUTTON5MOUSE', 'PRESS'
    yield from redrawn()
    view.press('BUTTON5MOUSE')
    yield from redrawn()
    item = user_item('splinewright.insert_on_strip')
    item.type, item.value = 'LEFTMOUSE', 'DOUBLE_CLICK'


def switched_on(view):
    bpy.context.scene.splinewright_sights.strip = False
    yield from redrawn()
    plain = picture("off")
    bpy.context.scene.splinewright_sights.strip = True
    bpy.ops.ed.undo_push(message="strip")
    yield from redrawn()
    assert mean_difference(picture("on"), plain) > 0.3


def on_a_curve(view):
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    yield from switched_on(view)
    before = value()
    inner = float(knots_along(0)[1])
    yield from over(view, inner)
    picture("hovered")
    yield from taken(view, inner)
    yield from led(view, 0.6 * inner)
    yield from until(lambda: value() != before, "the curve follows")
    assert np.array_equal(value().points, before.points)
    picture("dragging")
    view.press('ESC')
    yield from until(lambda: state.moved_knot is None and value() == before, "Esc puts it back")
    button(view, 'RELEASE')
    yield from redrawn()
    yield from dragged(view, inner, 0.6 * inner)
    after = value()
    picture("dragged")
    assert abs(knots_along(0)[1] - 0.6 * inner) < 0.01 and np.array_equal(after.points, before.points)
    assert shape().select_get() and bpy.context.window_manager.operators[-1].bl_idname == 'SPLINEWRIGHT_OT_move_knot'
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: value() == after, "Shift+Ctrl+Z does it again")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from redrawn()
    yield from over(view, 0.5 * inner)
    yield from clicked_twice(view)
    yield from until(lambda: len(value().points) == len(before.points) + 1, "a double click inserts a knot")
    yield from redrawn()
    picture("inserted")
    new = float(knots_along(0)[1])
    assert value().largest_distance(before) < 1e-9 and abs(new - 0.5 * inner) < 0.01
    yield from over(view, new)
    view.press('X')
    yield from until(lambda: len(value().points) == len(before.points), "X removes it")
    yield from redrawn()
    kept = value()
    assert kept.largest_distance(before) < 1e-9
    yield from over(view, inner)
    view.press('DEL')
    yield from until(lambda: "cannot be removed within" in said(), "what goes too far is refused")
    assert len(value().points) == len(before.points)
    yield from redrawn()
    picture("refused")
    bpy.context.scene.splinewright_sights.strip_tolerance = 10.0
    view.press('DEL')
    yield from until(lambda: len(value().points) == len(before.points) - 1, "with a larger tolerance it goes")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == kept, "Ctrl+Z takes it back")
    bpy.context.scene.splinewright_sights.strip_tolerance = 1e-3
    bpy.ops.ed.undo_push(message="tolerance")
    print("on a curve", flush=True)


def said():
    """By the last operator that Blender remembers, in the panel."""
    operators = bpy.context.window_manager.operators
    return getattr(operators[-1], 'result', "") if operators else ""


def with_keys(view):
    """A typed number; Ctrl and Shift; a drag that goes nowhere, one of an end, and one beside the strip."""
    before, inner = value(), float(knots_along(0)[1])
    yield from taken(view, inner)
    for key, text in (('ONE', "1"), ('PERIOD', "."), ('TWO', "2")):
        view.press(key, text)
    yield from until(lambda: knots_along(0)[1] == 1.2, "a number is its parameter")
    view.press('NINE', "9")
    yield from until(lambda: knots_along(0)[1] == 1.29, "which grows by digits")
    view.press('RET')
    yield from until(lambda: state.moved_knot is None, "Enter ends it")
    button(view, 'RELEASE')
    yield from redrawn()
    assert knots_along(0)[1] == 1.29
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from taken(view, inner)
    view.window.event_simulate('MOUSEMOVE', 'NOTHING', x=pixel(view, 1.51)[0], y=view.y, ctrl=True)
    yield from until(lambda: knots_along(0)[1] == 1.5, "with Ctrl it is round")
    view.press('SEVEN', "7")
    yield from redrawn()
    view.press('RET')
    yield from redrawn()
    assert state.moved_knot is not None, "what cannot be is not taken"
    picture("out-of-place")
    view.press('RIGHTMOUSE')
    yield from until(lambda: state.moved_knot is None and value() == before, "the right mouse button puts it back")
    button(view, 'RELEASE')
    yield from over(view, inner)
    button(view, 'PRESS')
    button(view, 'RELEASE')
    yield from redrawn()
    assert value() == before and state.moved_knot is None
    start = float(before.domain[0])
    yield from over(view, start)
    button(view, 'PRESS')
    view.move(view.x + 60, view.y)
    yield from redrawn()
    picture("end")
    button(view, 'RELEASE')
    yield from redrawn()
    assert value() == before and shape().select_get(), "the end stays"
    yield from over(view, 0.5 * inner)
    button(view, 'PRESS')
    view.move(view.x + 80, view.y + 200)
    yield from redrawn()
    button(view, 'RELEASE')
    yield from redrawn()
    assert value() == before and shape().select_get(), "no box was drawn"
    x, y = pixel(view, 0.5 * inner)
    view.move(x, y + 120)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: not shape().select_get(), "a click beside the strip selects as ever")
    view.press('Z', ctrl=True)
    yield from until(lambda: shape().select_get(), "Ctrl+Z takes it back")
    print("with keys", flush=True)


def in_the_net(view, add, was, to, axis=0):
    """The net comes out again; undo leads back into it."""
    yield from added(view, add)
    before = value()
    view.press('TAB')
    yield from into_net()
    assert len(shown(view).bars) == (1 if axis == 0 and shape().type == 'CURVE' else 2)
    picture(f"net-{shape().type.lower()}")
    yield from taken(view, was, axis)
    yield from led(view, to, axis)
    yield from until(lambda: value() != before, "the shape follows")
    picture(f"net-{shape().type.lower()}-dragging")
    view.press('ESC')
    yield from until(lambda: state.moved_knot is None and value() == before, "Esc puts it back")
    button(view, 'RELEASE')
    yield from dragged(view, was, to, axis)
    yield from into_net()
    after = value()
    assert after != before and np.array_equal(after.points, before.points)
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from into_net()
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: value() == after, "Shift+Ctrl+Z does it again")
    yield from into_net()
    selected = part('bridge.net.selection').selected
    live = part('bridge.net.live')
    bpy.ops.mesh.select_all(action='SELECT') if shape().type == 'MESH' else bpy.ops.curve.select_all(action='SELECT')
    yield from redrawn()
    ob = bpy.context.object
    count = len(selected(ob, live.session(ob.data).net))
    yield from over(view, (was + to) / 2, axis)
    button(view, 'PRESS')
    view.move(view.x, view.y + 150)
    yield from redrawn()
    button(view, 'RELEASE')
    yield from redrawn()
    ob = bpy.context.object
    assert count and len(selected(ob, live.session(ob.data).net)) == count, "what was selected is"
    yield from over(view, (was + to) / 2, axis)
    points = np.shape(value().points)
    yield from clicked_twice(view)
    yield from until(lambda: np.size(value().points) > np.prod(points), "a knot is inserted")
    yield from into_net()
    picture(f"net-{shape().type.lower()}-inserted")
    view.press('TAB')
    yield from out_of_net()
    print("in the net", shape().name, flush=True)


def of_a_recipe(view):
    """What is made by its numbers shows its knots, and keeps them."""
    yield from added(view, bpy.ops.splinewright.add_circle)
    before = value()
    for act in (lambda: view.move(view.x + 60, view.y), lambda: view.press('X')):
        yield from over(view, float(knots_along(0)[1]))
        button(view, 'PRESS')
        act()
        button(view, 'RELEASE')
        yield from redrawn()
        assert value() == before and state.moved_knot is None and shape().select_get()
    picture("recipe")
    view.press('ESC')
    print("of a recipe", flush=True)


def steps():
    view = View()
    view.move()
    yield from on_a_curve(view)
    yield from with_keys(view)
    yield from in_the_net(view, bpy.ops.splinewright.add_nurbs_curve, 1.0, 0.5)
    yield from in_the_net(view, bpy.ops.splinewright.add_nurbs_patch, 1.0, 1.6, axis=1)
    yield from of_a_recipe(view)
    print("knots were moved on the strip:", bpy.app.version_string, flush=True)


run(steps())
