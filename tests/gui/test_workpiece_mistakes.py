"""Doing it wrong: a vase is moved though it follows, its scale applied, its profile deleted and put across its axis; a pipe is too thick,
a network comes apart, curves that do not close are filled. Nothing breaks, all is said, and Ctrl+Z takes it back. By keys."""

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
    return save_picture(OUTPUT / f"mistakes-{name}.png")


def ob(name):
    return bpy.data.objects[NAMES[name]]


def value(name):
    return ob(name).data.splinewright.value


def seen(name):
    points = np.array([vertex.co for vertex in ob(name).data.vertices])
    matrix = np.array(ob(name).matrix_world)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def box(name):
    points = seen(name)
    return np.array([points.min(axis=0), points.max(axis=0)])


def problem(name):
    return part('bridge.follow.follow').problem(ob(name).data)


def warning(name):
    return part('bridge.recipes.recipes').read(ob(name).data).warning


def in_status():
    return part('ui.stopped').in_status(bpy.context.window_manager.windows[0].view_layer)


def added(view, path, name):
    before = len(bpy.data.objects)
    yield from by_keys.add(view, path)
    yield from until(lambda: len(bpy.data.objects) == before + 1, path)
    NAMES[name] = bpy.context.object.name


def beside(view, distance):
    """The profile by so much from its axis, in its net."""
    before = value('profile')
    view.press('TAB')
    yield from into_net()
    view.press('A')
    yield from redrawn()
    yield from by_keys.keys(view, f"G X {distance} Enter")
    yield from until(lambda: value('profile') != before, "the profile moves")
    view.press('TAB')
    yield from out_of_net()


def vase(view):
    """G moves all of it."""
    yield from added(view, "Curve > NURBS > NURBS Curve", 'profile')
    yield from by_keys.keys(view, "R X 90 Enter")
    yield from beside(view, 1.5)
    yield from added(view, "Surface > NURBS > Surface from Curves > Revolve", 'vase')
    yield from by_keys.see_all(view)
    before = seen('vase')
    yield from by_keys.keys(view, "G X 3 Enter")
    yield from until(lambda: np.allclose(seen('vase'), before + (3, 0, 0), atol=1e-4), "the vase moves, and keeps its shape")
    picture("moved")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: np.allclose(seen('vase'), before, atol=1e-5), "Ctrl+Z")


def applied(view):
    """Ctrl+A after S: it stays where it is seen, and goes on following."""
    size = np.ptp(box('vase'), axis=0)
    yield from by_keys.keys(view, "S 2 Enter")
    yield from until(lambda: np.allclose(np.ptp(box('vase'), axis=0), 2 * size, rtol=1e-4), "S makes it larger")
    before = box('vase')
    view.press('A', ctrl=True)
    yield from redrawn()
    view.press('S', "s")
    yield from until(lambda: np.allclose(ob('vase').scale, 1), "Ctrl+A applies the scale")
    yield from redrawn()
    assert problem('vase') == "", problem('vase')
    assert np.abs(box('vase') - before).max() < 1e-3 * np.ptp(before), (box('vase'), before)
    assert not part('bridge.shape.shape').is_touched(ob('vase').data)
    was = value('vase')
    yield from by_keys.choose(view, NAMES['profile'])
    yield from by_keys.keys(view, "S 1.1 Enter")
    yield from until(lambda: value('vase') != was, "it goes on following")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value('vase') == was, "Ctrl+Z")


def deleted(view):
    """The profile: the vase says which curve is gone, and stays."""
    was = value('vase')
    yield from by_keys.choose(view, NAMES['profile'])
    view.press('DEL')
    yield from until(lambda: NAMES['profile'] in problem('vase') and in_status(), "it says which curve is gone")
    assert value('vase') == was
    yield from redrawn()
    picture("deleted")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: not problem('vase') and not in_status(), "Ctrl+Z mends it")


def across(view):
    """The profile through the axis: made, and said."""
    yield from by_keys.choose(view, NAMES['profile'])
    yield from beside(view, -1.5)
    yield from until(lambda: "crosses the axis" in warning('vase'), "it says that the profile crosses the axis")
    yield from by_keys.choose(view, NAMES['vase'])
    yield from by_keys.sidebar(view)
    picture("across")
    view.area.spaces.active.show_region_ui = False
    yield from redrawn()
    yield from by_keys.choose(view, NAMES['profile'])
    yield from beside(view, 1.5)
    yield from until(lambda: not warning('vase'), "beside the axis again")


def thick(view):
    """A pipe thicker than its rail bends."""
    yield from added(view, "Curve > NURBS > NURBS Curve", 'rail')
    yield from by_keys.keys(view, "G Y 6 Enter")
    yield from added(view, "Surface > NURBS > Surface from Curves > Pipe", 'pipe')
    assert not warning('pipe')
    yield from by_keys.sidebar(view)
    yield from by_keys.typed(view, "pipe_radius", "2")
    yield from until(lambda: warning('pipe'), "it says where the pipe folds")
    yield from by_keys.see_all(view)
    picture("thick")
    view.area.spaces.active.show_region_ui = False
    yield from redrawn()


def line(view, name, start, end):
    sc = part('core.base.library').sc
    made = bpy.data.objects.new(name, part('bridge.shape.shape').new_data(name, sc.BezierCurve(np.array([start, end], float)), (12, 12)))
    bpy.context.scene.collection.objects.link(made)
    NAMES[name] = made.name


def apart(view):
    """One of four borders is moved away: the network names it. Fill refuses what does not close, and makes nothing."""
    corners = ((10, 0, 0), (12, 0, 0), (12, 2, 0.5), (10, 2, 0))
    names = [f"border {i}" for i in range(4)]
    for i, name in enumerate(names):
        line(view, name, corners[i], corners[(i + 1) % 4])
    with view.override():
        bpy.ops.ed.undo_push(message="borders")
    yield from by_keys.choose(view, *names)
    yield from added(view, "Surface > NURBS > Surface from Curves > Network Surface", 'net')
    yield from by_keys.see_all(view)
    assert problem('net') == ""
    was = value('net')
    yield from by_keys.choose(view, names[2])
    yield from by_keys.keys(view, "G Z 0.5 Enter")
    yield from until(lambda: "border 2" in problem('net') and in_status(), "it names the border that is away")
    assert value('net') == was
    yield from redrawn()
    picture("apart")
    many = len(bpy.data.objects)
    yield from by_keys.choose(view, *names)
    yield from by_keys.add(view, "Surface > NURBS > Surface from Curves > Fill")
    yield from redrawn()
    picture("fill")
    view.press('ESC')                   # what is said stands at the mouse
    view.move(420, 420)
    yield from redrawn()
    assert len(bpy.data.objects) == many, "what does not close is not filled"
    yield from by_keys.choose(view, names[2])
    yield from by_keys.keys(view, "G Z -0.5 Enter")
    yield from until(lambda: not problem('net'), "it follows again where it fits")


def kept(view):
    before = {name: value(name) for name in ('vase', 'pipe', 'net')}
    yield from by_keys.saved_and_opened(view, OUTPUT / "mistakes.blend")
    assert all(value(name) == was for name, was in before.items()) and not nets()
    assert not problem('net') and not problem('vase') and warning('pipe')


run(by_keys.one_by_one(vase, applied, deleted, across, thick, apart, kept))
