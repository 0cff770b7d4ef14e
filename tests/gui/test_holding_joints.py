"""A joint that holds: G on an end and on a handle of one curve, the other goes along; Esc, a click, Ctrl+Z, the lock in the panel."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"holding-joints-{name}.png")


def pool():
    return part('bridge.data.store').pool(bpy.data.objects["shape"].data)


def smooth():
    one, other = bpy.data.objects["shape"].data.splinewright.value
    return one.to_nurbs().continuity_to(other.to_nurbs()).g


def two_arches():
    sc = part('core.base.library').sc
    points = np.array([[-3, 0, 0], [-2.5, 1.5, 0], [-0.8, 1.2, 0], [0, 0, 0.0]])
    return [sc.BezierCurve(points), sc.BezierCurve(-points[::-1])]


def scene(view):
    with view.override():
        empty_file()
        ob = bpy.data.objects.new("shape", part('bridge.shape.shape').new_data("shape", two_arches(), (8, 8)))
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
        bpy.ops.splinewright.hold_joint('EXEC_DEFAULT', True, continuity='G2', moves='second', first=1, first_end='end', second=2,
                                        second_end='start')
    assert smooth() >= 2
    view.move(420, 420)
    view.press('TAB')
    yield from into_net()


def dragged(view, row, follower):
    """A point of the net is chosen and dragged by the mouse: the follower, a row of the pool, goes along."""
    live, selection = part('bridge.net.live'), part('bridge.net.selection')
    net = live.session(nets()[0].data).net
    with view.override():
        selection.select(nets()[0], net, [net.rows.tolist().index(row)])
        bpy.ops.ed.undo_push(message="select")
    yield from redrawn()
    before, plain = pool(), picture("net")
    for ends in ('ESC', 'LEFTMOUSE'):
        view.press('G')
        view.move(view.x + 40, view.y + 60)
        yield from until(lambda: np.abs(pool()[row] - before[row]).max() > 0.1, "the point is dragged")
        yield from until(lambda: smooth() >= 2 and np.abs(pool()[follower] - before[follower]).max() > 0.05, "the other goes along")
        yield from redrawn()
        assert mean_difference(picture(f"dragged-{row}"), plain) > 0.1
        view.press(ends)
        if ends == 'ESC':
            yield from until(lambda: np.array_equal(pool(), before), "Esc puts both back")
            view.move(view.x - 40, view.y - 60)
            yield from redrawn()
    yield from redrawn()
    after = pool()
    assert smooth() >= 2 and not np.array_equal(after, before)
    view.press('Z', ctrl=True)
    yield from until(lambda: np.abs(pool() - before).max() < 1e-5, "Ctrl+Z takes it back, and what went along")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: np.abs(pool() - after).max() < 1e-5 and smooth() >= 2, "redo")


def steps():
    view = View()
    yield from scene(view)
    first, second = (piece.indices.tolist() for piece in part('bridge.data.store').read(bpy.data.objects["shape"].data).pieces)
    yield from dragged(view, first[2], second[1])
    yield from dragged(view, first[3], second[0])
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1045, 538))
    picture("panel")
    view.move(420, 420)
    view.press('TAB')
    yield from out_of_net()
    assert smooth() >= 2


run(steps())
