"""Tools that take drags, and those of whole shapes and points; the header, the status bar and Ctrl+Z."""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from by_tool import choose, click, count, hover, picture, state, stroke, undone, value
from flat_shapes import begun, curves, lines, sheet
from window import View, into_net, mean_difference, nets, out_of_net, part, redrawn, run, select_points, until

STATUS = np.s_[-22:, :700]
LINE = [(-4, 0, 0), (4, 0, 0)]


def drawing(view):
    """With nothing selected, and on a patch; a contour with rounded corners."""
    yield from begun(view)
    yield from choose(view, "draw_curve", pixels=2.0, degree=4)
    picture("draw-header")
    yield from stroke(view, *((x, 2 * np.sin(x), 0) for x in np.linspace(-3, 3, 30)))
    yield from until(lambda: count() == 1, "a curve is drawn")
    assert curves()[0].degree == 4, "the degree of the header"
    picture("drawn")
    yield from undone(view, lambda: count() == 0, "the curve")
    yield from choose(view, "draw_contour", radius=0.5)
    for corner_of_it in ((-2, -1, 0), (2, -1, 0), (2, 2, 0)):
        yield from click(view, corner_of_it)
    picture("contour")
    view.press('RET')
    yield from until(lambda: count() == 1, "a contour is drawn")
    assert abs(curves()[0].length() - (4 + 3 - 1 + 0.25 * np.pi)) < 0.05, "with the radius of the header"
    yield from undone(view, lambda: count() == 0, "the contour")
    yield from sheet(view)
    yield from choose(view, "draw_on_surface")
    bpy.context.scene.cursor.location.z = 5
    yield from stroke(view, *((x, 0.3 * x, 0) for x in np.linspace(-0.7, 0.7, 20)))
    yield from until(lambda: count() == 2, "a curve on the patch")
    assert np.abs(np.concatenate([curve.points for curve in curves()])[:, 2]).max() < 0.02
    bpy.context.scene.cursor.location.z = 0
    print("drawing", flush=True)


def whole_shapes(view):
    yield from lines(view, LINE)
    yield from choose(view, "pull", locality=0.5)
    yield from stroke(view, (1, 0, 0), (1, 0.5, 0), (1, 1, 0), (1, 1.5, 0))
    yield from until(lambda: value("line 0").points[:, 1].max() > 0.5, "it goes with the mouse")
    picture("pulled")
    yield from undone(view, lambda: value("line 0").points[:, 1].max() == 0, "the pull")
    yield from sheet(view, 2)
    yield from choose(view, "join", continuity='C0', moves='first')
    yield from hover(view, (0.9, 0, 0), "join")
    view.press('LEFTMOUSE')
    view.move(*view.pixel_of((2.1, 0, 0)))
    yield from until(lambda: len(state().sides) == 2, "both edges")
    yield from redrawn()
    picture("join-second")
    view.press('LEFTMOUSE')
    yield from until(lambda: np.allclose(value("sheet")[0].points[-1, :, 0], 2), "the first moves, as the header says")
    yield from undone(view, lambda: np.allclose(value("sheet")[0].points[-1, :, 0], 1), "the join")
    yield from choose(view, "pick", other=False)
    yield from click(view, (3, 0, 0))
    yield from until(lambda: bpy.data.objects["sheet"].data.splinewright.piece == 2, "the piece that was clicked")
    yield from choose(view, "measure")
    before = bpy.data.objects["sheet"].data.splinewright.measure_u
    yield from hover(view, (-0.6, 0.2, 0), "measure")
    view.press('LEFTMOUSE')
    yield from until(lambda: bpy.data.objects["sheet"].data.splinewright.measure_u != before, "the place that was clicked")
    picture("measured")
    print("whole shapes", flush=True)


def at_points(view):
    """In the net of a curve: the point at the mouse is changed; a click elsewhere changes nothing."""
    yield from lines(view, [(-3, 0, 0), (0, 3, 0), (3, 0, 0)])
    view.press('TAB')
    yield from into_net()
    before = value("line 0")

    def points(name):
        return [round(getattr(point, name), 3) for point in bpy.data.objects["line 0"].data.splines[0].points]
    for name, found in (("weight", lambda: value("line 0")), ("radius", lambda: points("radius")), ("tilt", lambda: points("tilt"))):
        yield from choose(view, name)
        was = found()
        x, y = view.pixel_of(nets()[0].matrix_world @ nets()[0].data.splines[0].points[1].co.to_3d())
        select_points()
        yield from view.drag([(x + step, y) for step in range(0, 120, 20)])
        yield from until(lambda: state().weighing, f"{name} is shown at the mouse")
        yield from redrawn()
        picture(f"{name}-drag")
        view.release()
        yield from until(lambda: state().weighing is None and found() != was, f"{name} has changed")
        yield from redrawn()
        yield from undone(view, lambda: found() == was, name)
        yield from into_net()
    assert value("line 0") == before
    view.press('TAB')
    yield from out_of_net()
    print("at points", flush=True)


def in_the_toolbar(view):
    """Pictures of the buttons with names, of the header and the status bar with each tool; these differ."""
    yield from sheet(view)
    shown = {}
    for tool in part('ui.tool_table').TOOLS.values():
        if 'OBJECT' in tool.modes:
            yield from choose(view, tool.name)
            shown[tool.name] = picture(f"chosen-{tool.name}")
    names = list(shown)
    for one, other in zip(names, names[1:]):
        assert mean_difference(shown[one][STATUS], shown[other][STATUS]) > 0.1, (one, other, "say other keys")
    print("in the toolbar", flush=True)


def steps():
    view = View()
    for part_of_it in (at_points, drawing, whole_shapes, in_the_toolbar):
        yield from part_of_it(view)
    print("tools by drags:", bpy.app.version_string, flush=True)


run(steps())
