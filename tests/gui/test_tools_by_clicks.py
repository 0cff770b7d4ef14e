"""Tools that take clicks: the setting of the header changed, what a click would use shown, a click, Ctrl+Z."""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from box_scene import box
from by_tool import choose, click, count, hover, picture, state, undone, value
from flat_shapes import curves, lines, sheet
from window import View, redrawn, run, until

LINE, ACROSS = [(-4, 0, 0), (4, 0, 0)], [(0, -3, 0), (0, 3, 0)]


def at_knots(view):
    """Along the direction of the header, in Object Mode; Ctrl takes the middle."""
    yield from sheet(view)
    for name, more in (("insert_knot", lambda: len(value("sheet").knots[1]) == 9), ("split", lambda: hasattr(value("sheet"), 'patches'))):
        yield from choose(view, name, direction='V')
        yield from hover(view, (0.3, 0.3, 0), name)
        view.press('LEFTMOUSE')
        yield from until(more, f"{name} along v")
        yield from undone(view, lambda: not hasattr(value("sheet"), 'patches') and len(value("sheet").knots[1]) == 8, name)
    view.press('LEFTMOUSE', ctrl=True)
    yield from until(lambda: hasattr(value("sheet"), 'patches'), "split in the middle")
    assert np.allclose(value("sheet")[0].points[:, -1, 1], 0, atol=1e-9)
    yield from undone(view, lambda: not hasattr(value("sheet"), 'patches'), "the cut")
    yield from choose(view, "isocurve", direction='BOTH')
    yield from hover(view, (0.3, 0.3, 0), "isocurve")
    view.press('LEFTMOUSE')
    yield from until(lambda: count() >= 2, "isocurves")
    picture("isocurves")
    assert bpy.context.object == bpy.data.objects["sheet"], "the patch stays selected for the next click"
    yield from undone(view, lambda: count() == 1, "isocurves")
    yield from choose(view, "edge")
    yield from hover(view, (0, -0.95, 0), "edge")
    view.press('LEFTMOUSE')
    yield from until(lambda: count() == 2, "an edge")
    assert np.allclose(curves(next(ob.name for ob in bpy.data.objects if ob.name != "sheet"))[0].points[:, 1], -1)
    yield from undone(view, lambda: count() == 1, "the edge")
    print("at knots", flush=True)


def at_corners(view):
    yield from lines(view, LINE, [(-1, -2, 0), (-1, 2, 0)], [(1, -2, 0), (1, 2, 0)])
    yield from choose(view, "trim", meet='SELECTED')
    yield from hover(view, (0, 0, 0), "trim")
    view.press('LEFTMOUSE')
    yield from until(lambda: len(curves("line 0")) == 2, "the part between two others is removed")
    yield from undone(view, lambda: len(curves("line 0")) == 1, "the trim")
    yield from lines(view, [(-4, 0, 0), (0, 0, 0)], [(2, -2, 0), (2, 2, 0)])
    yield from choose(view, "extend", how='straight')
    yield from hover(view, (-0.5, 0, 0), "extend")
    view.press('LEFTMOUSE')
    yield from until(lambda: abs(curves("line 0")[0].length() - 6) < 1e-4, "it reaches the other")
    yield from undone(view, lambda: abs(curves("line 0")[0].length() - 4) < 1e-4, "that")
    for name, settings, length in (("fillet", {'radius': 0.5, 'joined': True}, 7 - 1 + 0.25 * np.pi),
                                   ("chamfer", {'first_length': 1.0, 'second_length': 0.5, 'joined': True}, 7 - 1.5 + np.hypot(1, 0.5))):
        yield from lines(view, LINE, ACROSS)
        yield from choose(view, name, **settings)
        yield from hover(view, (3, 0, 0), name)
        view.press('LEFTMOUSE')
        yield from redrawn()
        assert count() == 2
        picture(f"{name}-second")
        yield from click(view, (0, 2, 0))
        yield from until(lambda: count() == 1, "two became one")
        assert abs(curves("line 0")[0].length() - length) < 1e-3, (name, "has the settings of the header")
        yield from undone(view, lambda: count() == 2, name)
    print("at corners", flush=True)


def others_are_selected(view):
    """A click on what is not selected, and one beside, select as ever."""
    yield from lines(view, LINE, ACROSS)
    bpy.data.objects["line 1"].select_set(False)
    for name in ("trim", "extend", "fillet", "chamfer", "split", "insert_knot", "pull", "measure", "pick"):
        yield from choose(view, name)
        yield from click(view, (0, 2, 0))
        yield from until(lambda: bpy.data.objects["line 1"].select_get(), f"with {name} a click selects")
        assert not bpy.data.objects["line 0"].select_get(), name
        yield from click(view, (3, 0, 0))
        yield from until(lambda: bpy.data.objects["line 0"].select_get(), f"with {name} a click selects the other")
        assert [len(curves(each)) for each in ("line 0", "line 1")] == [1, 1], name
    print("others are selected", flush=True)


def edges(view):
    yield from box(view)
    with view.override():
        bpy.context.view_layer.objects.active = bpy.data.objects["box"]
        bpy.data.objects["box"].select_set(True)
        bpy.ops.ed.undo_push(message="select")
    yield from choose(view, "round_edges")
    yield from click(view, (1.5, 0, 1))
    yield from until(lambda: state().rounding and len(state().rounding.chosen) == 1, "the first edge")
    yield from redrawn()
    picture("round-edges")
    view.press('RET')
    yield from until(lambda: count() == 2 and state().rounding is None, "the rounded box")
    yield from redrawn()
    picture("rounded")
    print("edges", flush=True)


def steps():
    view = View()
    for part_of_it in (at_knots, at_corners, others_are_selected, edges):
        yield from part_of_it(view)
    print("tools by clicks:", bpy.app.version_string, flush=True)


run(steps())
