"""An ellipse gets its half axes by typed numbers and is swept along a rail; a pipe is made of the rail, too: both follow the
radius of its points, which Alt+S changes. Undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
NAMES = {}


def picture(name):
    return save_picture(OUTPUT / f"tube-{name}.png")


def value(name):
    return bpy.data.objects[NAMES[name]].data.splinewright.value


def box(name):
    found = value(name)
    points = found.evaluate_grid(*(np.linspace(*domain, 33) for domain in found.domain)).reshape(-1, 3)
    return np.ptp(points, axis=0)


def ellipse(view):
    yield from by_keys.add(view, "Curve > NURBS > Conic > Ellipse")
    yield from until(lambda: len(bpy.data.objects) == 1, "an ellipse")
    NAMES['section'] = bpy.context.object.name
    yield from by_keys.sidebar(view)
    yield from by_keys.typed(view, "ellipse_length_0", "0.3")
    yield from until(lambda: abs(width(0) - 0.6) < 1e-5, "half axis a")
    settings().ellipse_length_1 = 0.15
    yield from until(lambda: abs(width(1) - 0.3) < 1e-5, "half axis b")
    picture("ellipse")
    view.area.spaces.active.show_region_ui = False
    yield from redrawn()


def width(axis):
    found = value('section')
    return np.ptp(found.evaluate(np.linspace(*found.domain, 65))[:, axis])


def settings():
    return bpy.context.object.data.splinewright_parameters


def swept(view):
    yield from by_keys.add(view, "Curve > NURBS > NURBS Curve")
    yield from until(lambda: len(bpy.data.objects) == 2, "a rail")
    NAMES['rail'] = bpy.context.object.name
    yield from by_keys.search(view, "pipe")
    yield from until(lambda: len(bpy.data.objects) == 3, "a pipe")
    NAMES['pipe'] = bpy.context.object.name
    yield from by_keys.keys(view, "G Y 3 Enter")
    yield from by_keys.choose(view, NAMES['rail'], NAMES['section'])
    with view.override():
        bpy.ops.splinewright.add_sweep('INVOKE_DEFAULT', True)
    yield from until(lambda: len(bpy.data.objects) == 4, "a sweep")
    NAMES['sweep'] = bpy.context.object.name
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    for name in ('sweep', 'pipe'):
        yield from by_keys.choose(view, NAMES[name])
        setattr(settings(), f"{name}_own_radius", True)
        yield from until(lambda: part('bridge.recipes.recipes').parameters(bpy.context.object.data)["own_radius"], "the switch")


def thicker(view):
    """One point of the rail by Alt+S, in its net."""
    before = {name: value(name) for name in ('sweep', 'pipe')}
    sizes = {name: box(name) for name in before}
    yield from by_keys.choose(view, NAMES['rail'])
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.curve.select_all(action='DESELECT')
        nets()[0].data.splines[0].points[2].select = True
        nets()[0].data.update_tag()
        bpy.ops.ed.undo_push(message="choose")
    yield from redrawn()
    yield from by_keys.keys(view, "Alt+S 3 Enter")
    yield from until(lambda: all(value(name) != was for name, was in before.items()), "both follow the radius")
    yield from redrawn()
    picture("radius")
    assert box('pipe')[2] > 1.3 * sizes['pipe'][2] and (box('sweep') / sizes['sweep']).max() > 1.1
    after = {name: value(name) for name in before}
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: all(value(name) == was for name, was in before.items()), "Ctrl+Z")
    yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from until(lambda: all(value(name) == was for name, was in after.items()), "Ctrl+Shift+Z")
    view.press('TAB')
    yield from out_of_net()


def kept(view):
    def is_whole():
        assert all(part('bridge.follow.follow').problem(bpy.data.objects[name].data) == "" for name in NAMES.values())
    pipe = lambda: value('pipe')
    yield from by_keys.followed_when_opened(view, OUTPUT / "tube.blend", pipe, is_whole, NAMES['rail'], "S X 1.2 Enter")
    picture("opened")


run(by_keys.one_by_one(ellipse, swept, thicker, kept))
