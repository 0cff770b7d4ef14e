"""Contours by clicks; curves trimmed, made longer and filleted by clicks; what is pointed at is shown, Esc and Ctrl+Z."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from flat_shapes import begun, curves, lines
from window import View, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
CORNERS = [(-3, -1.5, 0), (3, -1.5, 0), (3, 1.5, 0), (-3, 1.5, 0)]


def picture(name):
    return save_picture(OUTPUT / f"curve-here-{name}.png")


def state():
    return part('ui.ui_state').ui_state


def call(view, name):
    with view.override():
        getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True)
    yield from redrawn()


def click(view, point):
    view.move(*view.pixel_of(point))
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from redrawn()


def drawn(view):
    """A slot by clicks, A and C; Esc makes nothing; Backspace takes one back; a number is a length."""
    yield from begun(view)
    plain = picture("empty")
    yield from call(view, 'draw_contour')
    for corner in CORNERS[:2]:
        yield from click(view, corner)
    view.press('ESC')
    yield from until(lambda: state().contour is None, "Esc ends it")
    assert not bpy.data.objects
    yield from call(view, 'draw_contour')
    for corner in CORNERS[:2]:
        yield from click(view, corner)
    yield from click(view, (0, 0, 0))
    yield from until(lambda: len(state().contour[0].points) == 3, "three points")
    view.press('BACK_SPACE')
    yield from until(lambda: len(state().contour[0].points) == 2, "one is taken back")
    view.press('A')
    view.move(*view.pixel_of(CORNERS[2]))
    yield from until(lambda: state().contour[1].kinds[-1] == 'arc', "an arc is shown")
    yield from redrawn()
    assert mean_difference(picture("drawing"), plain) > 0.001
    yield from click(view, CORNERS[2])
    view.press('A')
    yield from click(view, CORNERS[3])
    view.press('C')
    yield from until(lambda: len(bpy.data.objects) == 1, "a contour")
    made, = curves()
    wanted = 6 + np.pi * 1.5 + 6 + 3
    assert abs(made.length() - wanted) < 0.02 * wanted and np.allclose(*made.evaluate(np.array(made.domain)))
    yield from redrawn()
    picture("drawn")
    view.press('Z', ctrl=True)
    yield from until(lambda: not bpy.data.objects, "Ctrl+Z takes it back")
    yield from call(view, 'draw_contour')
    yield from click(view, CORNERS[0])
    view.move(*view.pixel_of(CORNERS[1]))
    view.press('TWO', "2")
    yield from until(lambda: np.isclose(state().contour[1].points[-1][0], -1, atol=0.05), "two units on")
    view.press('LEFTMOUSE')
    yield from redrawn()
    view.press('RET')
    yield from until(lambda: len(bpy.data.objects) == 1, "a segment")
    assert abs(curves()[0].length() - 2) < 1e-6
    print("drawn", flush=True)


def words():
    shown = state().weighing
    return shown.text if shown else ""


def guided(view):
    """Ctrl holds angles, numbers are lengths and angles, the mouse takes marks of other curves, C closes by an arc."""
    yield from lines(view, [(-4, 3, 0), (4, 3, 0)])
    yield from call(view, 'draw_contour')
    yield from click(view, (-3, -2, 0))
    first = np.array(state().contour[0].points[0])
    view.move(*view.pixel_of((1, -1.7, 0)))
    view.window.event_simulate('LEFT_CTRL', 'PRESS', x=view.x, y=view.y, ctrl=True)
    view.window.event_simulate('MOUSEMOVE', 'NOTHING', x=view.x + 1, y=view.y, ctrl=True)
    yield from until(lambda: abs(state().contour[1].points[-1][1] - first[1]) < 1e-6, "held to the axis")
    assert "Angle 0°" in words(), words()
    view.window.event_simulate('LEFT_CTRL', 'RELEASE', x=view.x, y=view.y)
    for key, text in (('THREE', "3"), ('TAB', ""), ('NINE', "9"), ('ZERO', "0")):
        view.press(key, text=text)
    yield from until(lambda: np.allclose(state().contour[1].points[-1], first + (0, 3, 0), atol=1e-5), "3 units upwards")
    assert "Length 3 " in words() and "[90°]" in words(), words()
    picture("typed")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(state().contour[0].points) == 2, "the typed point")
    for point, name in (((0.05, 2.95, 0), "Midpoint"), ((first[0] + 0.05, 3.05, 0), "Perpendicular"), ((3.95, 3.05, 0), "End")):
        view.move(*view.pixel_of(point))
        yield from until(lambda: words().endswith(name), f"{name} is said")
    picture("marks")
    yield from until(lambda: np.allclose(state().contour[1].points[-1], (4, 3, 0), atol=1e-6), "the end itself")
    view.press('S')
    yield from until(lambda: not words().endswith("End"), "S turns that off")
    view.press('S')
    yield from until(lambda: words().endswith("End"), "and on")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(state().contour[0].points) == 3, "three points")
    view.press('A')
    view.press('C')
    yield from until(lambda: len(bpy.data.objects) == 2, "a contour")
    assert curves()[0].length() > 3 + np.hypot(7, 2) + np.hypot(7, 5) + 1, "an arc closes it"
    yield from redrawn()
    picture("closed-by-arc")
    print("guided", flush=True)


def trimmed(view):
    yield from lines(view, [(-4, 0, 0), (4, 0, 0)], [(-1, -2, 0), (-1, 2, 0)], [(1, -2, 0), (1, 2, 0)])
    yield from call(view, 'trim_here')
    view.move(*view.pixel_of((0.1, 0, 0)))
    yield from until(lambda: state().aimed is not None, "what is at the mouse is shown")
    yield from redrawn()
    picture("trimming")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(curves("line 0")) == 2, "a click trims")
    yield from redrawn()
    picture("trimmed")
    view.press('Z', ctrl=True)
    yield from until(lambda: len(curves("line 0")) == 1, "Ctrl+Z takes it back")
    print("trimmed", flush=True)


def longer(view):
    yield from lines(view, [(-4, 0, 0), (0, 0, 0)], [(2, -2, 0), (2, 2, 0)])
    yield from call(view, 'extend_here')
    yield from click(view, (-0.5, 0, 0))
    yield from until(lambda: np.allclose(curves("line 0")[0].evaluate(curves("line 0")[0].domain[1]), (2, 0, 0), atol=1e-5),
                     "it goes on to the other")
    print("longer", flush=True)


def filleted(view):
    yield from lines(view, [(-4, 0, 0), (4, 0, 0)], [(0, -3, 0), (0, 3, 0)])
    yield from call(view, 'fillet_here')
    yield from click(view, (3, 0, 0))
    assert len(bpy.data.objects) == 2
    yield from click(view, (0, 2, 0))
    yield from until(lambda: len(bpy.data.objects) == 1, "two became one")
    ends = curves("line 0")[0].evaluate(np.array(curves("line 0")[0].domain))
    assert np.allclose(ends, [(0, 3, 0), (4, 0, 0)], atol=1e-5)
    assert np.isclose(curves("line 0")[0].length(), 7 - 2 * 0.4 + 0.2 * np.pi, atol=1e-4)
    yield from redrawn()
    picture("filleted")
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 2, "Ctrl+Z takes it back")
    print("filleted", flush=True)


def not_meant(view):
    """What is worked on is said, and that another curve at the mouse is not."""
    meant, told = part('ui.operators.meant'), []
    found, why_none = meant.why_none, meant.why_none

    def heard(*arguments):
        told.append(found(*arguments))
        return told[-1]
    meant.why_none = heard
    yield from lines(view, [(-4, 0, 0), (4, 0, 0)], [(0, -3, 0), (0, 3, 0)])
    bpy.data.objects["line 1"].select_set(False)
    for name in ('fillet_here', 'chamfer_here', 'trim_here', 'extend_here', 'split_here'):
        told.clear()
        yield from call(view, name)
        yield from click(view, (0, 2, 0))
        yield from until(lambda: told, f"{name} says why nothing is done")
        assert told == ["line 1 is not selected: only line 0 is worked on"], (name, told)
        picture(f"not-meant-{name}")
        yield from click(view, (-5, -3, 0))
        yield from until(lambda: len(told) == 2, "a click beside")
        assert told[1] == "" and len(bpy.data.objects) == 2
        view.press('ESC')
        yield from redrawn()
    meant.why_none = why_none
    print("not meant", flush=True)


def steps():
    view = View()
    for part_of_it in (drawn, guided, trimmed, longer, filleted, not_meant):
        yield from part_of_it(view)


run(steps())
