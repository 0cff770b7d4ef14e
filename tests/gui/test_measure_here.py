"""The tool Measure: what is at the mouse is shown there, a click takes it into the panel, Esc leaves it; Ctrl+Z."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, place_seen, shape, value
from window import View, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"measure-{name}.png")


def shown():
    return part('ui.ui_state').ui_state.measured


def parameters():
    """Those that the panel shows."""
    settings, domain = shape().data.splinewright, value().domain
    axes = domain if isinstance(domain[0], tuple) else (domain,)
    return [start + part * (end - start) for (start, end), part in zip(axes, (settings.measure_u, settings.measure_v))]


def measure(view):
    with view.override():
        assert bpy.ops.splinewright.measure_here('INVOKE_DEFAULT', True) == {'RUNNING_MODAL'}


def clicked(view, place):
    """Steps: shown at the mouse, called off by Esc, shown again and clicked."""
    name = value().__class__.__name__
    plain, before = picture(f"{name}-before"), parameters()
    view.move(*view.pixel_of(value().evaluate(*place)))
    measure(view)
    view.move(view.x + 1)
    yield from until(lambda: shown() and np.allclose(shown().place.point, value().evaluate(*place), atol=0.1), "the place is shown")
    yield from redrawn()
    assert mean_difference(picture(name), plain) > 0.02
    view.press('ESC')
    yield from until(lambda: shown() is None, "Esc ends it")
    assert parameters() == before
    measure(view)
    view.move(view.x - 1)
    yield from until(lambda: shown(), "the place is shown, again")
    view.press('LEFTMOUSE')
    yield from until(lambda: shown() is None, "a click ends it")
    yield from redrawn()
    assert np.allclose(parameters(), place, atol=0.05), (parameters(), place)
    picture(f"{name}-taken")
    return before


def steps():
    view = View()
    view.open_sidebar()
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    start, end = value().domain
    before = yield from clicked(view, (start + 0.3 * (end - start),))
    view.press('Z', ctrl=True)
    yield from until(lambda: parameters() == before, "Ctrl+Z takes the place back")
    view.press('TAB')
    yield from into_net()
    yield from clicked(view, (start + 0.6 * (end - start),))
    view.press('TAB')
    yield from out_of_net()
    print("on a curve, and in its net", flush=True)
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    yield from clicked(view, place_seen(view))
    print("on a patch", flush=True)


run(steps())
