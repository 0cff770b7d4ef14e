"""Edges of a box are clicked: each lights up at the mouse, clicks add and remove, Enter rounds them; the eyedropper of the result
begins with those that are rounded, and Esc leaves all as it was."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from box_scene import box
from window import View, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: In the middle of edges that are seen.
TOP_RIGHT, TOP_FRONT, UPRIGHT = (1.5, 0, 1), (0, -1, 1), (1.5, -1, 0.5)


def picture(name):
    return save_picture(OUTPUT / f"round-by-click-{name}.png")


def rounding():
    return part('ui.ui_state').ui_state.rounding


def scene(view):
    yield from box(view)
    with view.override():
        ob = bpy.data.objects["box"]
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.ed.undo_push(message="select")
    yield from redrawn()


def begun(view):
    with view.override():
        assert bpy.ops.splinewright.round_here('INVOKE_DEFAULT', True) == {'RUNNING_MODAL'}
    yield from redrawn()


def at(view, place):
    view.move(*view.pixel_of(place))
    yield from until(lambda: rounding().hovered, f"an edge at {place}")
    yield from redrawn()


def clicked(view, place, count):
    yield from at(view, place)
    number = rounding().hovered
    view.press('LEFTMOUSE')
    yield from until(lambda: len(rounding().chosen) == count, f"{count} edges after a click at {place}")
    yield from redrawn()
    return number


def made(view):
    sharp = picture("sharp")
    yield from begun(view)
    view.press('RET')
    yield from redrawn()
    assert rounding() is not None and len(bpy.data.objects) == 1
    first = yield from clicked(view, TOP_RIGHT, 1)
    yield from clicked(view, UPRIGHT, 2)
    yield from clicked(view, UPRIGHT, 1)
    yield from at(view, TOP_FRONT)
    assert mean_difference(picture("picking"), sharp) > 0.003
    view.press('RET')
    yield from until(lambda: len(bpy.data.objects) == 2 and rounding() is None, "the rounded box")
    yield from redrawn()
    read = part('bridge.recipes.recipes')
    assert read.parameters(bpy.context.object.data)['edges'] == str(first) and read.read(bpy.context.object.data).said == "1 edge rounded"
    picture("one")
    return first


def changed(view, first):
    data = bpy.context.object.data
    yield from begun(view)
    assert rounding().chosen == {first}
    view.press('A')
    yield from until(lambda: len(rounding().chosen) == 12, "A takes all")
    view.press('ESC')
    yield from until(lambda: rounding() is None, "Esc ends it")
    assert part('bridge.recipes.recipes').parameters(data)['edges'] == str(first)
    yield from begun(view)
    yield from clicked(view, TOP_FRONT, 2)
    view.press('RET')
    yield from redrawn()
    yield from until(lambda: rounding() is None, "more are rounded")
    yield from redrawn()
    assert part('bridge.recipes.recipes').read(bpy.context.object.data).said != "1 edge rounded"
    picture("more")


def taken_back(view):
    view.press('Z', ctrl=True)
    yield from until(lambda: part('bridge.recipes.recipes').read(bpy.context.object.data).said == "1 edge rounded", "Ctrl+Z takes that back")
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 1, "Ctrl+Z brings the box back")
    yield from redrawn()


def steps():
    view = View()
    yield from scene(view)
    first = yield from made(view)
    yield from changed(view, first)
    yield from taken_back(view)


run(steps())
