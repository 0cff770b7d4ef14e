"""A tool of ours with the mouse: chosen, its settings changed, what a click would use shown; clicks and strokes."""

import os
from pathlib import Path

import bpy
import numpy as np

from window import mean_difference, part, redrawn, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
_VIEW = np.s_[120:700, 100:1000]


def picture(name):
    return save_picture(OUTPUT / f"tool-{name}.png")


def state():
    return part('ui.ui_state').ui_state


def value(name):
    return bpy.data.objects[name].data.splinewright.value


def choose(view, name, **settings):
    """By the entry of the menu, as F3 does; its settings as the header has them."""
    with view.override():
        assert bpy.ops.splinewright.use_tool('EXEC_DEFAULT', tool=name) == {'FINISHED'}
    toolbar = part('ui.toolbar')
    tool = toolbar.active(bpy.context)
    assert tool is not None and tool.name == name
    view.move(420, 420)
    yield from redrawn()
    properties = toolbar.settings(bpy.context, tool)
    assert not set(settings) - {*tool.shown, *tool.of_patches}, "what the header shows"
    for setting, wanted in settings.items():
        setattr(properties, setting, wanted)
    yield from redrawn()


def hover(view, point, name, is_shown=True):
    """Steps with the mouse over a point; what a click would use is drawn there."""
    view.move(*_corner(view))
    yield from redrawn()
    plain = picture(name)
    view.move(*view.pixel_of(point))
    for _ in range(3):
        yield from redrawn()
    if is_shown:
        yield from until(lambda: mean_difference(picture(name)[_VIEW], plain[_VIEW]) > 0.002, f"{name} is shown at the mouse")


def _corner(view):
    return view.region.x + 330, view.region.y + 60


def click(view, point):
    view.move(*view.pixel_of(point))
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from redrawn()


def undone(view, is_so, what):
    view.press('Z', ctrl=True)
    yield from until(is_so, f"Ctrl+Z takes {what} back")
    yield from redrawn()


def count():
    return len(bpy.data.objects)


def stroke(view, *points):
    yield from view.drag([view.pixel_of(point) for point in points])
    yield from redrawn()
    view.release()
