"""Choose Function: the mouse over a function of the triangle shows its parents and coefficients, over a span its wedge; a click
keeps that, Esc and Ctrl+Z take it back."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
store, triangle, ui_state = part('bridge.data.store'), part('core.formulas.triangle_picture'), part('ui.ui_state')
_names = []


def picture(name):
    return save_picture(OUTPUT / f"triangle-{name}.png")


def shape():
    """Undo gives it another address."""
    return bpy.data.objects[_names[-1]]


def names():
    return [piece.name for piece in store.read(shape().data).pieces]


def chosen():
    settings, kind = shape().data.splinewright_parameters, part('bridge.recipes.recipes').kind(shape().data)
    return getattr(settings, f'{kind}_chosen'), getattr(settings, f'{kind}_spans')


def words():
    shown = ui_state.ui_state.fed
    return str(shown.words) if shown else ""


def pixel_of(view, name):
    item = next(item for item in triangle.items(store.read(shape().data)) if item.name == name)
    return view.pixel_of(shape().matrix_world @ Vector(item.point))


def made(view, add, **settings):
    """Steps that leave a triangle in the middle of the view, seen from above, with labels."""
    with view.override():
        add('EXEC_DEFAULT', True, **settings)
        _names.append(bpy.context.object.name)
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
    view.area.spaces.active.region_3d.update()
    part('bridge.data.settings').overlays_of(bpy.context.scene).labels = True
    view.move(420, 420)
    yield from redrawn()


def begin(view):
    with view.override():
        assert bpy.ops.splinewright.choose_function('INVOKE_DEFAULT', True) == {'RUNNING_MODAL'}


def pointed(view, name, said):
    """Steps that move the mouse onto an item until the words about it are shown."""
    view.move(*pixel_of(view, name))
    yield from until(lambda: said in words(), f"{said!r} at {name}, not {words()!r}")
    yield from redrawn()


def explored(view, kind):
    """Steps: hover, leave, Esc; nothing is left of it."""
    plain, before = picture(f"{kind}-before"), names()
    begin(view)
    yield from pointed(view, "N1,2", "N1,2 = (")
    assert names().count("parents 1,2") == 2 == len(ui_state.ui_state.fed.lines) and chosen() == ("1,2", "")
    assert mean_difference(picture(f"{kind}-function"), plain) > 0.02
    yield from pointed(view, "[2, 3)", "not zero on [2, 3): ")
    assert "wedge 2" in names() and "parents 1,2" not in names() and chosen() == ("", "2")
    assert mean_difference(picture(f"{kind}-span"), plain) > 0.02
    x, y = pixel_of(view, "N1,2")
    view.move(x + 45, y)
    yield from until(lambda: names() == before and not words(), "nothing is pointed out beside the functions")
    yield from pointed(view, "N0,1", "N0,1 = u N0,0 + (2-u) N1,0")
    view.press('ESC')
    yield from until(lambda: not words() and names() == before, "Esc takes it back")
    assert chosen() == ("", "")


def kept(view, kind):
    """Steps: a click keeps a function, another one with Shift a span beside it; Ctrl+Z takes the second back."""
    begin(view)
    yield from pointed(view, "N1,2", "N1,2 = (")
    view.press('LEFTMOUSE')
    yield from until(lambda: not words(), "a click ends it")
    assert chosen() == ("1,2", "")
    begin(view)
    view.move(*(np.array(pixel_of(view, "[1, 2)")) + 2))
    view.window.event_simulate('MOUSEMOVE', 'NOTHING', x=view.x - 1, y=view.y, shift=True)
    yield from until(lambda: chosen() == ("1,2", "1"), "Shift adds a span")
    view.press('LEFTMOUSE', shift=True)
    yield from until(lambda: not words(), "a click ends it, again")
    yield from redrawn()
    assert chosen() == ("1,2", "1") and {"parents 1,2", "wedge 1"} <= set(names())
    picture(f"{kind}-kept")
    view.press('Z', ctrl=True)
    yield from until(lambda: chosen() == ("1,2", "") and "wedge 1" not in names(), "Ctrl+Z takes the span back")


def steps():
    view = View()
    with view.override():
        empty_file()
    yield from made(view, bpy.ops.splinewright.add_triangle, degree=2, knot_values="0 1 2 3 4 5")
    yield from explored(view, "knots")
    yield from kept(view, "knots")
    print("on typed knots", flush=True)
    with view.override():
        empty_file()
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, degree=2, count=4)
    data = bpy.context.object.data
    data.splinewright.value = part('core.base.library').sc.NurbsCurve(2, [0, 1, 2, 3, 4, 5], [(0, 0), (1, 1), (2, 0)])
    yield from redrawn()
    yield from made(view, bpy.ops.splinewright.add_basis_triangle)
    yield from explored(view, "curve")
    yield from kept(view, "curve")
    print("on the knots of a curve", flush=True)


run(steps())
