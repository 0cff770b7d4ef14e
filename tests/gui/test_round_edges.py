"""Round Edge of a box that is clicked, by the menu: the numbers of its edges stand in the view, it follows G, and Ctrl+Z takes all back."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from box_scene import box
from by_keys import command
from window import View, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"round-edges-{name}.png")


def numbers():
    return part('ui.sections_overlay').shown(bpy.context.object)


def rounded(view):
    view.move(*view.pixel_of((0, 0, 1)))
    view.press('LEFTMOUSE')
    yield from until(lambda: [ob.name for ob in bpy.context.selected_objects] == ["box"], "a click selects the box")
    sharp = picture("sharp")
    yield from command(view, "Surface from Surfaces > Round Edge")
    yield from until(lambda: len(bpy.data.objects) == 2, "the rounded box")
    yield from redrawn()
    assert len(numbers()) == 12 and bpy.data.objects["box"].hide_get()
    assert part('bridge.recipes.recipes').read(bpy.context.object.data).said == "12 edges rounded"
    assert mean_difference(picture("round"), sharp) > 0.01


def numbered(view):
    """Without overlays the numbers are gone."""
    with_numbers = picture("numbers")
    overlay = view.area.spaces.active.overlay
    overlay.show_overlays = False
    yield from redrawn()
    assert mean_difference(picture("plain"), with_numbers) > 0.01
    overlay.show_overlays = True
    yield from redrawn()


def moved_and_back(view):
    ob = bpy.context.object
    name, feet = ob.name, np.array([one.foot for one in numbers()])
    view.press('G')
    view.press('Z')
    view.press('ONE', "1")
    view.press('RET')
    yield from until(lambda: abs(bpy.data.objects[name].location.z - 1.0) < 1e-6, "G moves it")
    yield from redrawn()
    assert np.allclose([one.foot for one in numbers()], feet + (0, 0, 1))
    view.press('Z', ctrl=True)
    yield from until(lambda: abs(bpy.data.objects[name].location.z) < 1e-6, "Ctrl+Z moves it back")
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 1 and not bpy.data.objects["box"].hide_get(), "Ctrl+Z brings the box back")
    yield from redrawn()
    picture("undone")


def steps():
    view = View()
    yield from box(view)
    yield from rounded(view)
    yield from numbered(view)
    yield from moved_and_back(view)


run(steps())
