"""The README's first five minutes by mouse and keys: a profile is drawn, revolved, refined, pulled, held and looked at; the
pictures are the README's."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import place_seen_on
from window import View, empty_file, into_net, nets, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Where the profile goes on by E and a click, from its foot: (radius, height).
CLICKS = ((0.5, 0.55), (0.42, 1.1), (0.75, 1.75), (1.05, 2.1))


def picture(name):
    return save_picture(OUTPUT / f"five-{name}.png")


def button(view, value):
    view.window.event_simulate('LEFTMOUSE', value, x=view.x, y=view.y)


def last_operator():
    operators = bpy.context.window_manager.operators
    return operators[-1].bl_idname if len(operators) else ""


def profile(view):
    """A curve of four points, and E and a click for each one more."""
    with view.override():
        empty_file()
        bpy.context.preferences.view.smooth_view = 0
        bpy.ops.view3d.view_axis(type='FRONT')
        bpy.context.space_data.overlay.show_cursor = False
    yield from redrawn()                # Blender turns the view when it draws it
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, count=4, align='VIEW')
        ob = bpy.context.object
        ob.name = "Profile"
        ob.data.splinewright.value = ob.data.splinewright.value.with_points([(0, 0, 0), (0.5, 0, 0), (1.1, 0.02, 0), (1.15, 0.4, 0)])
        bpy.context.space_data.region_3d.view_location = (0.4, 0, 1.0)
        bpy.context.space_data.region_3d.view_distance = 5.0
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.curve.select_all(action='DESELECT')
        nets()[0].data.splines[0].points[-1].select = True
        nets()[0].data.update_tag()
        bpy.ops.ed.undo_push(message="choose")
    count = 4
    for radius, height in CLICKS:
        tip = nets()[0].matrix_world @ nets()[0].data.splines[0].points[-1].co.to_3d()
        view.move(*view.pixel_of(tip))
        yield from redrawn()
        view.press('E')
        yield from until(lambda: len(nets()[0].data.splines[0].points) == count + 1, "E makes a copy")
        view.move(*view.pixel_of((radius, 0, height)))
        yield from until(lambda: len(value("Profile").points) == count + 1, "the curve has a point more")
        yield from redrawn()
        if count == 6:
            picture("profile")
        view.press('LEFTMOUSE')
        yield from until(lambda: last_operator().startswith('CURVE_OT_extrude'), "the click ends it")
        yield from redrawn()
        count += 1
    view.press('TAB')
    yield from out_of_net()
    assert len(value("Profile").points) == 8


def value(name):
    return bpy.data.objects[name].data.splinewright.value


def vase():
    return next(ob for ob in bpy.data.objects if ob.type == 'MESH' and part('bridge.shape').has_shape(ob))


def seen_at(view, at):
    """The pixel at which the vase has a parameter."""
    return view.pixel_of(vase().matrix_world @ Vector(vase().data.splinewright.value.evaluate(*at)))


def revolved(view):
    with view.override():
        bpy.ops.splinewright.add_revolve('INVOKE_DEFAULT', True)
        assert bpy.context.object == vase()
        region = bpy.context.space_data.region_3d
        region.view_perspective = 'PERSP'
        region.view_rotation = (0.83, 0.46, 0.13, 0.28)
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    picture("revolved")
    points = part('bridge.shape').points_of(vase().data)
    assert np.abs(np.hypot(points[:, 0], points[:, 2]).max() - 1.1) < 0.2
    with view.override():
        bpy.ops.splinewright.make_editable('EXEC_DEFAULT', True)
        bpy.data.objects["Profile"].hide_set(True)
    yield from redrawn()


def refined(view):
    """Ctrl+R in the net shows the knot at the mouse, a click inserts it."""
    view.press('TAB')
    yield from into_net()
    before = vase().data.splinewright.value
    at = place_seen_on(view, vase())
    view.move(*seen_at(view, at))
    view.press('R', ctrl=True)
    yield from until(lambda: part('bridge.file_state').state.aimed is not None, "what is at the mouse is shown")
    view.wheel_up()
    yield from redrawn()
    picture("insert")
    view.press('LEFTMOUSE')
    yield from until(lambda: vase().data.splinewright.value != before, "a click inserts")
    yield from into_net()
    assert sum(map(len, vase().data.splinewright.value.knots)) > sum(map(len, before.knots))


def pulled(view):
    before = vase().data.splinewright.value
    at = place_seen_on(view, vase())
    x, y = seen_at(view, at)
    view.move(x, y)
    view.press('G', alt=True)
    state = part('bridge.file_state').state
    yield from until(lambda: state.pulled is not None, "what is at the mouse is shown")
    button(view, 'PRESS')
    view.move(x - 70, y + 20)
    yield from until(lambda: vase().data.splinewright.value != before and np.linalg.norm(
        np.subtract(seen_at(view, at), (view.x, view.y))) < 4, "the shape follows")
    yield from redrawn()
    picture("pull")
    button(view, 'RELEASE')
    yield from until(lambda: state.pulled is None, "letting go ends it")
    view.move(420, 420)
    view.press('TAB')
    yield from out_of_net()


def held(view):
    """The surface is split, and the seam holds G2 while a row beside it is scaled; stripes do not break there."""
    with view.override():
        bpy.ops.splinewright.patch_split('EXEC_DEFAULT', True, direction='V', parameter_v=2.5)
        assert len(vase().data.splinewright.value) == 2
        bpy.ops.splinewright.hold_seam('EXEC_DEFAULT', True, continuity='G2', moves='second', first=1, first_side='v_end', second=2,
                                       second_side='v_start')
    view.press('TAB')
    yield from into_net()
    before = vase().data.splinewright.value
    net = part('bridge.net.live').session(nets()[0].data).net
    vertices = {int(row): vertex for vertex, row in enumerate(net.rows)}
    with view.override():
        select_points(*(vertices[int(row)] for row in net.definition.pieces[0].indices[:, -2]))
    yield from redrawn()
    view.press('S')
    for key, text in (('ONE', "1"), ('PERIOD', "."), ('ONE', "1")):
        view.press(key, text)
    view.press('RET')
    yield from until(lambda: all(one != other for one, other in zip(vase().data.splinewright.value, before)), "both sides move")
    yield from redrawn()
    now = vase().data.splinewright.value
    assert part('core.library').sc.seam_continuity(now[0], 'v_end', now[1], 'v_start').g >= 2
    view.press('TAB')
    yield from out_of_net()
    bpy.context.scene.splinewright_sights.stripes = True
    yield from redrawn()
    picture("zebra")


def steps():
    view = View()
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("Splinewright", (1045, 538))
    for stop in (profile, revolved, refined, pulled, held):
        yield from stop(view)
        print(stop.__name__, flush=True)
    print("the first five minutes are as the README says:", bpy.app.version_string, flush=True)


run(steps())
