"""Points are selected in a net, I is pressed, the frame changes, they are moved, I again: the shape plays; Esc, undo."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, shape, value
from window import (View, in_net, into_net, mean_difference, nets, out_of_net, part, redrawn, run, save_picture,
                    select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Of a picture what is well inside the 3D view.
WITHIN = np.s_[120:700, 60:1000]
FIRST, LAST = 1, 11


def picture(name):
    return save_picture(OUTPUT / f"keyed-points-{name}.png")


def keys():
    """How many keys points have on all channels."""
    return sum(len(curve.keyframe_points) for curve in part('bridge.data.animation').curves(shape().data))


def pool():
    return part('bridge.data.store').read(shape().data).pool


def in_the_net(rows):
    """Heights of points where Blender's net has them."""
    ob = nets()[0]
    session = part('bridge.net.live').session(ob.data)
    present = part('bridge.cage.net_object').present(ob, session.net)
    slots = part('core.net.reading').slots(session.net, present)
    vertices = [int(np.flatnonzero(session.net.rows == row)[0]) for row in rows]
    return present.positions()[slots[vertices], 2]


def are_at(rows, heights):
    """Whether points lie so high in the shape and in its net."""
    return in_net() and np.allclose(pool()[rows, 2], heights, atol=1e-4) and np.allclose(in_the_net(rows), heights, atol=1e-4)


def at_frame(frame):
    bpy.context.scene.frame_set(frame)
    yield from redrawn()


def typed(view, text):
    names = {'2': 'TWO', '3': 'THREE', '.': 'PERIOD'}
    for character in text:
        view.press(names[character], character)


def keyed(view, rows):
    """Steps that key points at two frames, 2 higher at the second."""
    before = pool()[rows, 2]
    select_points(*rows)
    yield from at_frame(FIRST)
    view.move(420, 420)
    view.press('I')
    yield from until(lambda: keys() == 4 * len(rows), "I sets keys of the points in hand")
    yield from at_frame(LAST)
    view.press('G')
    view.press('Z')
    typed(view, "2")
    view.press('RET')
    yield from until(lambda: are_at(rows, before + 2), "G Z 2 lifts them")
    yield from redrawn()
    view.press('I')
    yield from until(lambda: keys() == 8 * len(rows), "I sets keys of what is seen")
    yield from redrawn()
    with view.override():
        bpy.ops.ed.undo_redo()          # what the panel of the last operator does, but for the step
        part('ui.editing').want_whole_step()
        bpy.ops.ed.undo_push(message="Insert Point Keyframes")
    yield from redrawn()
    yield from until(lambda: keys() == 8 * len(rows) and are_at(rows, before + 2), "it is repeated")
    return before


def played(view, rows, before):
    """Steps through frames, by hand and by the space bar."""
    last = picture("last")
    yield from at_frame(FIRST)
    yield from until(lambda: are_at(rows, before), "shape and net are as at the first frame")
    assert mean_difference(picture("first")[WITHIN], last[WITHIN]) > 0.2
    yield from at_frame(6)
    yield from until(lambda: are_at(rows, before + 1), "they are half way between")
    picture("between")
    scene, seen = bpy.context.scene, set()
    scene.frame_start, scene.frame_end = FIRST, LAST
    view.press('SPACE', ' ')
    yield from until(lambda: bpy.context.screen.is_animation_playing, "it plays")

    def notes():
        seen.add((scene.frame_current, round(float(pool()[rows[0], 2]), 4)))
        return len(seen) > 4
    yield from until(notes, "frames go by, and the shape with them")
    view.press('ESC')
    yield from until(lambda: not bpy.context.screen.is_animation_playing, "Esc ends it")
    assert len({height for _, height in seen}) == len({frame for frame, _ in seen}) > 4
    yield from until(lambda: scene.frame_current == 6 and are_at(rows, before + 1), "and goes back to where it began")


def held_in_a_gesture(view, rows, before):
    """A frame that changes while points are in hand leaves these to the hand."""
    view.move(420, 420)
    view.press('G')
    view.press('Z')
    typed(view, "3")
    yield from until(lambda: are_at(rows, before + 4), "they are in hand")
    yield from at_frame(FIRST)
    view.move(425, 421)
    yield from redrawn()
    view.press('ESC')
    yield from redrawn()
    yield from at_frame(LAST)
    yield from until(lambda: are_at(rows, before + 2), "the next frame has them where keys put them")
    yield from at_frame(6)
    yield from until(lambda: are_at(rows, before + 1), "and every other")


def taken_back(view, rows):
    """Ctrl+Z takes the keys back that were set last, and Shift+Ctrl+Z sets them again; the frame stays."""
    count = 8 * len(rows)
    view.press('Z', ctrl=True)
    yield from until(lambda: keys() == count // 2 and in_net(), "Ctrl+Z takes the last keys back")
    assert bpy.context.scene.frame_current == 6
    yield from redrawn()
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: keys() == count and in_net(), "Shift+Ctrl+Z sets them again")
    assert bpy.context.scene.frame_current == 6
    yield from redrawn()


def of_one(view, operator, rows):
    yield from added(view, operator)
    view.area.spaces.active.region_3d.view_distance = 2.2 * max(bpy.context.object.dimensions)
    view.press('TAB')
    yield from into_net()
    before = yield from keyed(view, rows)
    yield from played(view, rows, before)
    yield from held_in_a_gesture(view, rows, before)
    yield from taken_back(view, rows)
    view.press('TAB')
    yield from out_of_net()
    yield from at_frame(LAST)
    yield from until(lambda: np.allclose(pool()[rows, 2], before + 2, atol=1e-4), "it plays without a net, too")
    assert value() is not None
    print(operator.idname_py(), flush=True)


def in_the_sidebar(view):
    """The panel, opened, shows the points in hand; a number typed there moves one, and Ctrl+Z takes that back."""
    panel = part('ui.point_keys_panel').SPLINEWRIGHT_PT_keyed_points
    bpy.utils.unregister_class(panel)
    panel.bl_options = set()
    bpy.utils.register_class(panel)
    view.open_sidebar()
    view.press('TAB')
    yield from into_net()
    select_points(2)
    yield from view.show_tab("NURBS", (1043, 540))
    before = pool()
    picture("sidebar")
    item = shape().data.splinewright_keyed[0]
    item.place[2] = 0.5
    bpy.ops.ed.undo_push(message="place")
    yield from until(lambda: are_at([2], 0.5), "net and shape follow the field")
    view.move(420, 420)
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and np.allclose(pool(), before, atol=1e-6), "Ctrl+Z takes it back")
    view.press('TAB')
    yield from out_of_net()


def steps():
    view = View()
    yield from of_one(view, bpy.ops.splinewright.add_nurbs_patch, [5, 6])
    yield from of_one(view, bpy.ops.splinewright.add_nurbs_curve, [2, 3])
    yield from in_the_sidebar(view)
    print("points were keyed:", bpy.app.version_string, flush=True)


run(steps())
