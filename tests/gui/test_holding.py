"""A seam that holds: G in the net of one patch, the other goes along; Esc, a click, Ctrl+Z; released in the panel."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"holding-{name}.png")


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def smooth():
    sc = part('core.base.library').sc
    return sc.seam_continuity(value()[0], 'u_end', value()[1], 'u_start').g


def neighbors():
    sc = part('core.base.library').sc
    u, v = np.meshgrid(np.linspace(-2, 0, 5), np.linspace(-1, 1, 5), indexing='ij')
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2]
    grids = [np.stack([u + shift, v, 0.3 * np.cos(2 * u + shift)], -1) for shift in (0, 2)]
    grids[1][0] = grids[0][-1]
    return sc.PatchSet.from_patches([sc.NurbsPatch((3, 3), (knots, knots), points) for points in grids])


def cut_near_a_knot():
    sc = part('core.base.library').sc
    knots = [0, 0, 0, 0, 0.6, 1.02, 1.5, 2, 2, 2, 2]
    u, v = np.meshgrid(np.linspace(-2, 2, 7), np.linspace(-1, 1, 7), indexing='ij')
    return sc.PatchSet.from_patches(sc.NurbsPatch((3, 3), (knots, knots), np.stack([u, v, 0.3 * np.cos(u)], -1)).split('u', 1.03))


def scene(view, shown=neighbors, continuity='G1', columns=slice(1, 4)):
    with view.override():
        empty_file()
        data = part('bridge.shape.shape').new_data("shape", shown(), (8, 8))
        ob = bpy.data.objects.new("shape", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.view3d.view_selected()
        bpy.ops.splinewright.hold_seam('EXEC_DEFAULT', True, continuity=continuity, moves='second', first=1, first_side='u_end',
                                       second=2, second_side='u_start')
    assert smooth() >= 1
    view.move(420, 420)
    view.press('TAB')
    yield from into_net()
    live, selection = part('bridge.net.live'), part('bridge.net.selection')
    net = live.session(nets()[0].data).net
    vertices = {int(row): vertex for vertex, row in enumerate(net.rows)}
    with view.override():
        selection.select(nets()[0], net, [vertices[int(row)] for row in net.definition.pieces[0].indices[-2, columns]])
        bpy.ops.ed.undo_push(message="select")
    yield from redrawn()


def drag_near_a_knot(view):
    """The other half is not thrown out of the view, and the seam holds."""
    before = value()
    view.press('G')
    view.move(view.x, view.y + 60)
    yield from until(lambda: np.abs(value()[0].points - before[0].points).max() > 0.1, "the net is dragged")
    yield from until(lambda: smooth() >= 2, "the seam holds")
    yield from redrawn()
    picture("near-a-knot")
    moved = [np.abs(value()[i].points - before[i].points).max() for i in (0, 1)]
    assert moved[1] < 1.5 * moved[0]
    view.press('ESC')
    yield from until(lambda: value() == before, "Esc puts both back")
    view.press('TAB')
    yield from out_of_net()


def drag(view):
    before, plain = value(), picture("net")
    for ends in ('ESC', 'LEFTMOUSE'):
        view.press('G')
        view.move(view.x, view.y + 60)
        yield from until(lambda: np.abs(value()[0].points - before[0].points).max() > 0.1, "the net is dragged")
        yield from until(lambda: smooth() >= 1 and value()[1] != before[1], "the other patch goes along")
        yield from redrawn()
        assert mean_difference(picture("dragged"), plain) > 0.3
        view.press(ends)
        if ends == 'ESC':
            yield from until(lambda: value() == before, "Esc puts both back")
            view.move(view.x, view.y - 60)
            yield from redrawn()
    yield from redrawn()
    after = value()
    assert smooth() >= 1 and after != before
    view.press('Z', ctrl=True)
    yield from until(lambda: np.abs(value()[0].points - before[0].points).max() < 1e-6, "Ctrl+Z takes it back")
    yield from until(lambda: np.abs(value()[1].points - before[1].points).max() < 1e-5, "and what went along")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: np.abs(value()[0].points - after[0].points).max() < 1e-6 and smooth() >= 1, "redo")
    view.press('TAB')
    yield from out_of_net()
    assert smooth() >= 1


def steps():
    view = View()
    yield from scene(view, cut_near_a_knot, 'G2', slice(3, 4))
    yield from drag_near_a_knot(view)
    yield from scene(view)
    yield from drag(view)
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1045, 538))
    picture("panel")


run(steps())
