"""What is at the mouse is shown and taken by a click: the sides of patches that are joined or extracted, where a shape is split,
which isocurve is extracted."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from flat_shapes import sheet
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"at-sides-{name}.png")


def state():
    return part('ui.ui_state').ui_state


def value(name="sheet"):
    return bpy.data.objects[name].data.splinewright.value


def over(view, point, operator):
    """Steps until an operator is at work with the mouse over a point of the world."""
    view.move(*view.pixel_of(point))
    with view.override():
        operator('INVOKE_DEFAULT')
    view.move(*view.pixel_of(point))
    yield from redrawn()


def two_are_joined(view):
    yield from sheet(view, 2)
    plain = picture("two")
    yield from over(view, (0.9, 0, 0), bpy.ops.splinewright.join_here)
    yield from until(lambda: state().sides == (("sheet", 1, 'u_end'),), "the side at the mouse")
    yield from redrawn()
    assert mean_difference(picture("one-side"), plain) > 0.02
    view.press('LEFTMOUSE')
    view.move(*view.pixel_of((3, 0.9, 0)))
    yield from until(lambda: state().sides == (("sheet", 1, 'u_end'), ("sheet", 2, 'v_end')), "a side of the other patch")
    view.move(*view.pixel_of((0, 0.9, 0)))
    yield from until(lambda: len(state().sides) == 1, "no second side of the first patch")
    view.move(*view.pixel_of((2.1, 0, 0)))
    yield from until(lambda: state().sides[1:] == (("sheet", 2, 'u_start'),), "the side that faces it")
    yield from redrawn()
    picture("both-sides")
    view.press('LEFTMOUSE')
    yield from until(lambda: np.abs(value()[1].points[0, :, 0] - 1).max() < 1e-9, "they are joined")
    found = part('core.base.library').sc.seam_continuity(value()[0], 'u_end', value()[1], 'u_start')
    assert found.g >= 1 and state().sides == ()
    view.press('Z', ctrl=True)
    yield from until(lambda: np.abs(value()[1].points[0, :, 0] - 2).max() < 1e-9, "Ctrl+Z takes it back")
    print("joined", flush=True)


def a_side_is_extracted(view):
    yield from sheet(view)
    yield from over(view, (0, -0.9, 0), bpy.ops.splinewright.extract_side_here)
    yield from until(lambda: state().sides == (("sheet", 1, 'v_start'),), "the side at the mouse")
    view.press('ESC')
    yield from until(lambda: state().sides == (), "Esc ends it")
    assert len(bpy.data.objects) == 1
    yield from over(view, (0, -0.9, 0), bpy.ops.splinewright.extract_side_here)
    yield from until(lambda: state().sides, "the side again")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(bpy.data.objects) == 2, "a curve is there")
    curve = bpy.context.object.data.splinewright.value
    assert np.allclose(curve.points[:, 1], -1)
    print("a side", flush=True)


def an_isocurve_is_extracted(view):
    yield from sheet(view)
    yield from over(view, (0.5, 0.2, 0), bpy.ops.splinewright.extract_here)
    yield from until(lambda: state().aimed is not None, "what is at the mouse")
    yield from redrawn()
    picture("isocurve")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(bpy.data.objects) == 2, "a curve is there")
    assert np.allclose(bpy.context.object.data.splinewright.value.points[:, 0], 0.5, atol=0.03)
    print("an isocurve", flush=True)


def a_shape_is_split(view):
    yield from sheet(view)
    yield from over(view, (0.5, 0.2, 0), bpy.ops.splinewright.split_here)
    yield from until(lambda: state().aimed is not None, "what is at the mouse")
    view.press('LEFTMOUSE')
    yield from until(lambda: hasattr(value(), 'patches'), "it is split")
    assert len(value()) == 2 and np.allclose(value()[0].points[-1, :, 0], 0.5, atol=0.03)
    view.press('Z', ctrl=True)
    yield from until(lambda: not hasattr(value(), 'patches'), "Ctrl+Z takes it back")
    with view.override():
        empty_file()
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
        bpy.context.object.name = "curve"
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    u = value("curve").domain[0] + 0.3 * np.ptp(value("curve").domain)
    yield from over(view, value("curve").evaluate(u), bpy.ops.splinewright.split_here)
    yield from until(lambda: state().aimed is not None, "what is at the mouse")
    view.press('LEFTMOUSE')
    yield from until(lambda: isinstance(value("curve"), list), "the curve is split")
    assert len(value("curve")) == 2 and abs(value("curve")[0].domain[1] - u) < 0.1
    print("split", flush=True)


def steps():
    view = View()
    for part_of_it in (two_are_joined, a_side_is_extracted, an_isocurve_is_extracted, a_shape_is_split):
        yield from part_of_it(view)
    print("what is at the mouse is taken:", bpy.app.version_string, flush=True)


run(steps())
