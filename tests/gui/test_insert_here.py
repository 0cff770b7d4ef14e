"""Ctrl+R over a shape or its net, the mouse, the wheel, a click: a knot is where it was shown."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, place_seen, value
from window import View, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"insert-{name}.png")


def aimed():
    return part('ui.ui_state').ui_state.aimed


def near(found, wanted):
    return found is not None and np.allclose(found.parameters, wanted, atol=0.05)


def on_a_patch(view):
    """In the net: along u, then by the wheel along v; Esc; a click."""
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    before = value()
    (u0, u1), (v0, v1) = before.domain
    u, v = place_seen(view)
    view.press('TAB')
    yield from into_net()
    plain = picture("net")
    view.move(*view.pixel_of(before.evaluate(u, v)))
    view.press('R', ctrl=True)
    yield from until(lambda: near(aimed(), (u, v)) and aimed().direction == 'U', "what is at the mouse is shown")
    yield from redrawn()
    assert mean_difference(picture("along-u"), plain) > 0.05
    view.press('ESC')
    yield from until(lambda: aimed() is None, "Esc ends it")
    assert value() == before
    view.press('R', ctrl=True)
    yield from until(lambda: near(aimed(), (u, v)), "what is at the mouse, again")
    view.wheel_up()
    yield from until(lambda: aimed().direction == 'V', "the wheel turns to v")
    yield from redrawn()
    picture("along-v")
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != before, "a click inserts")
    yield from into_net()
    assert len(value().knots[1]) == len(before.knots[1]) + 1 and len(value().knots[0]) == len(before.knots[0])
    assert np.abs(np.asarray(value().knots[1]) - v).min() < 0.05
    grid = np.linspace(u0, u1, 9), np.linspace(v0, v1, 9)
    assert np.allclose(value().evaluate_grid(*grid), before.evaluate_grid(*grid), rtol=0, atol=1e-12)
    picture("inserted")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from into_net()
    view.press('TAB')
    yield from out_of_net()
    print("on a patch", flush=True)


def on_a_curve(view):
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    before = value()
    start, end = before.domain
    u = start + 0.3 * (end - start)
    view.press('TAB')
    yield from into_net()
    view.move(*view.pixel_of(before.evaluate(u)))
    view.press('R', ctrl=True)
    yield from until(lambda: near(aimed(), (u,)), "what is at the mouse is shown")
    yield from redrawn()
    picture("curve")
    view.press('LEFTMOUSE')
    yield from until(lambda: value() != before, "a click inserts")
    yield from into_net()
    assert len(value().knots) == len(before.knots) + 1
    at = np.linspace(start, end, 33)
    assert np.allclose(value().evaluate(at), before.evaluate(at), rtol=0, atol=1e-12)
    view.press('TAB')
    yield from out_of_net()
    print("on a curve", flush=True)


def steps():
    view = View()
    yield from on_a_patch(view)
    yield from on_a_curve(view)
    print("knots were inserted by clicks:", bpy.app.version_string, flush=True)


run(steps())
