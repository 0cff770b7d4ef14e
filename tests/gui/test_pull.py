"""Alt+G in a net, the mouse pressed on the shape and dragged, keys, Esc: the point goes where it is pulled to."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added, place_seen, shape, value
from window import View, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Of a picture what is well inside the 3D view: the bars around it settle as they like.
WITHIN = np.s_[120:700, 60:1000]


def picture(name):
    return save_picture(OUTPUT / f"pull-{name}.png")


def pulled():
    return part('ui.ui_state').ui_state.pulled


def led():
    """The vector by which the point was led from where it was."""
    return np.array(pulled().end) - pulled().start


def button(view, value):
    view.window.event_simulate('LEFTMOUSE', value, x=view.x, y=view.y)


def pixels_away(view, point, x, y):
    """How far a point of the shape is seen from a pixel."""
    return np.hypot(*np.subtract(view.pixel_of(point), (x, y)))


def grabbed(view, x, y):
    """Steps until the point at a pixel is taken hold of, and the mouse was moved a little with it."""
    view.move(x, y)
    view.press('G', alt=True)
    yield from until(lambda: pulled() and np.array_equal(pulled().start, pulled().end), "what is at the mouse is shown")
    button(view, 'PRESS')
    view.move(x + 12, y + 9)
    yield from until(lambda: pulled() and np.linalg.norm(led()) > 0, "it is pulled")


def dragged_to(view, before, at, x, y):
    """Steps until the shape goes through a pixel at the parameters."""
    view.move(x, y)
    yield from until(lambda: value() != before and pixels_away(view, value().evaluate(*at), x, y) < 3, "the shape follows")


def on_a_patch(view):
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    before = value()
    at = place_seen(view)
    view.press('TAB')
    yield from into_net()
    plain = picture("net")
    x, y = view.pixel_of(before.evaluate(*at))
    yield from grabbed(view, x, y)
    yield from dragged_to(view, before, at, x + 40, y + 70)
    yield from redrawn()
    assert mean_difference(picture("dragging"), plain) > 0.5
    assert 0 < len(pulled().followers) and pulled().parts.max() == 1
    view.press('ESC')
    yield from until(lambda: pulled() is None and value() == before, "Esc puts everything back")
    button(view, 'RELEASE')
    yield from redrawn()
    assert mean_difference(picture("put-back")[WITHIN], plain[WITHIN]) < 0.3
    yield from grabbed(view, x, y)
    yield from dragged_to(view, before, at, x + 40, y + 70)
    button(view, 'RELEASE')
    yield from until(lambda: pulled() is None, "letting go ends it")
    yield from redrawn()
    assert value() != before and pixels_away(view, value().evaluate(*at), x + 40, y + 70) < 3
    after = value()
    picture("pulled")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from into_net()
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: value() == after, "Shift+Ctrl+Z does it again")
    view.press('TAB')
    yield from out_of_net()
    print("on a patch", flush=True)


def by_the_tool(view):
    """A press on the shape pulls at once."""
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    before = value()
    at = place_seen(view)
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.wm.tool_set_by_id(name="splinewright.pull")
    yield from redrawn()
    x, y = view.pixel_of(before.evaluate(*at))
    view.move(x, y)
    yield from redrawn()
    picture("tool")
    button(view, 'PRESS')
    yield from until(lambda: pulled() is not None, "a press takes hold of the shape")
    yield from dragged_to(view, before, at, x - 30, y + 60)
    button(view, 'RELEASE')
    yield from until(lambda: pulled() is None, "letting go ends it")
    yield from redrawn()
    picture("by-the-tool")
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    view.press('TAB')
    yield from out_of_net()
    print("by the tool", flush=True)


def on_a_curve(view):
    """An axis, a number and Enter; the wheel."""
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    before = value()
    start, end = before.domain
    u = start + 0.3 * (end - start)
    view.press('TAB')
    yield from into_net()
    x, y = view.pixel_of(before.evaluate(u))
    yield from grabbed(view, x, y)
    count = pulled().parts.sum()
    for _ in range(6):
        view.wheel_up()
    yield from until(lambda: pulled().parts.sum() < 0.9 * count, "the wheel lets fewer follow")
    view.press('Z')
    yield from until(lambda: led()[2] != 0 and not led()[:2].any(), "Z keeps to the axis")
    for key, text in (('ONE', "1"), ('PERIOD', "."), ('FIVE', "5")):
        view.press(key, text)
    yield from until(lambda: np.array_equal(led(), (0, 0, 1.5)), "the number is the distance")
    yield from redrawn()
    picture("curve")
    view.press('RET')
    yield from until(lambda: pulled() is None and value() != before, "Enter ends it")
    button(view, 'RELEASE')
    yield from redrawn()
    operator = bpy.context.window_manager.operators[-1]
    assert operator.bl_idname == 'SPLINEWRIGHT_OT_pull_here' and tuple(operator.vector) == (0, 0, 1.5)
    u = operator.parameter_u
    assert np.allclose(value().evaluate(u) - before.evaluate(u), (0, 0, 1.5), atol=1e-6)
    view.press('TAB')
    yield from out_of_net()
    print("on a curve", flush=True)


def aimed(view, x, y):
    """Steps until the point of a shape at a pixel is shown, in Object Mode."""
    view.move(x, y)
    with view.override():
        bpy.ops.splinewright.pull_here('INVOKE_DEFAULT')
    view.move(x, y)
    yield from until(lambda: pulled() is not None, "what is at the mouse is shown")


def by_tangent_and_circle(view):
    """D and C on a curve in Object Mode: the point stays where it is, Esc puts back what was pulled."""
    yield from added(view, bpy.ops.splinewright.add_nurbs_curve)
    before, u = value(), float(np.mean(value().domain))
    for key, handle in (('D', 'TANGENT'), ('C', 'CIRCLE')):
        x, y = view.pixel_of(before.evaluate(u))
        yield from aimed(view, x, y)
        view.press(key)
        yield from until(lambda: pulled() is not None and len(pulled().lines) > 0, f"{key} shows the handle")
        button(view, 'PRESS')
        view.move(x + 30, y - 50)
        yield from until(lambda: value() != before and np.linalg.norm(led()) > 0, "the shape follows")
        yield from redrawn()
        picture(handle.lower())
        button(view, 'RELEASE')
        yield from until(lambda: pulled() is None, "letting go ends it")
        operator = bpy.context.window_manager.operators[-1]
        u = part('core.base.decimals').typed(operator.parameter_u)
        assert operator.handle == handle
        size = np.abs(before.points).max()
        assert np.abs(value().evaluate(u) - before.evaluate(u)).max() < 1e-9 * size, "the point stays"
        gained = value().derivatives(u, 2) - before.derivatives(u, 2)
        assert np.abs(gained[1 if handle == 'TANGENT' else 2]).max() > 0.1
        assert handle == 'TANGENT' or np.abs(gained[1]).max() < 1e-9 * size, "the tangent stays, too"
        view.press('Z', ctrl=True)
        yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    print("by tangent and circle", flush=True)


def to_a_vertex(view):
    """With the magnet on, the point goes to a vertex of another object."""
    before, u = value(), float(np.mean(value().domain))
    with view.override():
        bpy.ops.mesh.primitive_cube_add(size=0.4, location=(0.0, 0.7, 0.35))
        cube = bpy.context.object
        cube.select_set(False)
        shape().select_set(True)
        bpy.context.view_layer.objects.active = shape()
    tools = bpy.context.scene.tool_settings
    tools.use_snap, tools.snap_elements = True, {'VERTEX'}
    x, y = view.pixel_of(before.evaluate(u))
    corners = np.array([cube.matrix_world @ vertex.co for vertex in cube.data.vertices])
    eye = np.array(view.region.data.view_matrix.inverted().translation)
    corner = corners[np.linalg.norm(corners - eye, axis=1).argmin()]
    yield from aimed(view, x, y)
    button(view, 'PRESS')
    there_x, there_y = view.pixel_of(corner)
    middle_x, middle_y = view.pixel_of(corners.mean(0))
    view.move(there_x + round(0.1 * (middle_x - there_x)), there_y + round(0.1 * (middle_y - there_y)))
    yield from until(lambda: np.abs(pulled().end - corner).max() < 1e-5, "the point snaps to the corner")
    yield from redrawn()
    picture("snapped")
    button(view, 'RELEASE')
    yield from until(lambda: pulled() is None, "letting go ends it")
    u = bpy.context.window_manager.operators[-1].parameter_u
    assert np.abs(value().evaluate(u) - corner).max() < 1e-5
    tools.use_snap = False
    bpy.data.objects.remove(cube)
    print("to a vertex", flush=True)


def in_object_mode(view):
    """A click holds on until the next one; no net is out."""
    before, u = value(), float(np.mean(value().domain))
    x, y = view.pixel_of(before.evaluate(u))
    yield from aimed(view, x, y)
    button(view, 'PRESS')
    button(view, 'RELEASE')
    view.move(x + 30, y - 50)
    yield from until(lambda: value() != before, "the shape follows")
    view.press('LEFTMOUSE')
    yield from until(lambda: pulled() is None, "the second click ends it")
    assert bpy.context.mode == 'OBJECT'
    after = value()
    view.press('Z', ctrl=True)
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    assert after != before
    print("in Object Mode", flush=True)


def sculpted(view):
    """A deformable surface of revolution has no crease after it."""
    def add(*_):
        sc, deformable = part('core.base.library').sc, part('core.deform.deformable')
        profile = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1.0], [(0.8, 0, -1), (1.2, 0, 0), (0.8, 0, 1)])
        patch, _ = deformable.revolved(profile, (0, 0, 0), (0, 0, 1), 0.0, None, 1e-3)
        data = part('bridge.shape.shape').new_data("shape", patch, (8, 8))
        ob = bpy.data.objects.new("shape", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
    yield from added(view, add)
    before, at = value(), place_seen(view)
    view.press('TAB')
    yield from into_net()
    x, y = view.pixel_of(before.evaluate(*at))
    yield from grabbed(view, x, y)
    yield from dragged_to(view, before, at, x - 60, y + 20)
    button(view, 'RELEASE')
    yield from until(lambda: pulled() is None, "letting go ends it")
    yield from redrawn()
    picture("sculpted")
    assert part('bridge.analysis.surveys').survey_of(shape().data)[1:] == (0, 0)
    view.press('TAB')
    yield from out_of_net()
    print("a deformable one", flush=True)


def steps():
    view = View()
    yield from on_a_patch(view)
    yield from sculpted(view)
    yield from by_the_tool(view)
    yield from on_a_curve(view)
    yield from to_a_vertex(view)        # before Ctrl is pressed: 4.3 says of simulated events that it still is
    yield from in_object_mode(view)
    yield from by_tangent_and_circle(view)
    print("shapes were pulled by the mouse:", bpy.app.version_string, flush=True)


run(steps())
