"""A chain made exact from Blender's own curve: its handles go along in the net as they do there; Alt+S and Ctrl+T on its points.
"""

import math
import os
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, in_net, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
STATE = part('ui.ui_state').ui_state
PLACES = ((-3.0, -1.5, 0.0), (-1.5, 1.0, 0.0), (0.5, -0.5, 0.0), (2.0, 1.5, 0.0), (3.5, -1.0, 0.0))
AUTO = ('AUTO', 'AUTO')


def picture(name):
    return save_picture(OUTPUT / f"handles-{name}.png")


def shape():
    return bpy.data.objects["chain"]


def value():
    return shape().data.splinewright.value


def points():
    return bpy.context.object.data.splines[0].bezier_points


def types():
    return [(point.handle_left_type, point.handle_right_type) for point in points()]


def kept():
    return part('bridge.curve.handles').read(shape().data)


def triples():
    return np.array([[point.handle_left, point.co, point.handle_right] for point in points()])


def made(view):
    """A curve of Blender's own, all of whose handles are automatic, made exact; in its net, seen from above."""
    with view.override():
        empty_file()
        data = bpy.data.curves.new("chain", 'CURVE')
        data.dimensions = '3D'
        spline = data.splines.new('BEZIER')
        spline.bezier_points.add(len(PLACES) - 1)
        for point, place in zip(spline.bezier_points, PLACES):
            point.co = place
            point.handle_left_type = point.handle_right_type = 'AUTO'
        ob = bpy.data.objects.new("chain", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.splinewright.make_exact()
        shape().data.bevel_depth = 0.12
        bpy.ops.ed.undo_push(message="bevel")
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
        view.region.data.view_perspective = 'ORTHO'
    yield from redrawn()
    view.move(420, 420)
    view.press('TAB')
    yield from into_net()
    assert types() == [AUTO] * 5 and kept() == ("A" * 10,)


def chosen(number, *names):
    bpy.ops.curve.select_all(action='DESELECT')
    for name in names:
        setattr(points()[number], f"select_{name}", True)
    bpy.context.object.data.update_tag()
    bpy.ops.ed.undo_push(message="select")


def are_automatic(numbers):
    """Whether handles of points lie where Blender computes them of all points."""
    where = part('core.net.handles').automatic(triples()[:, 1].astype(np.float64), False)
    return np.allclose(triples()[:, ::2][numbers], where[numbers], atol=1e-4)


def agrees():
    """Whether the shape is what its net shows."""
    tangents = (triples()[:, 1:] - triples()[:, :-1]) * 3
    return np.allclose(value().points, triples()[:, 1], atol=1e-5) and np.allclose(value().tangents, tangents, atol=1e-4)


def an_anchor(view):
    before, shown = value(), triples()
    chosen(2, 'left_handle', 'control_point', 'right_handle')
    view.move(*view.pixel_of(PLACES[2]))
    yield from redrawn()
    picture("net")
    view.press('G')
    view.move(view.x + 30, view.y - 60)
    yield from until(lambda: value() != before, "the shape follows")
    view.move(view.x + 30, view.y - 60)
    yield from redrawn()
    picture("anchor")
    assert are_automatic([1, 2, 3]) and agrees() and types() == [AUTO] * 5
    view.press('ESC')
    yield from until(lambda: value() == before, "Esc puts all of it back")
    assert np.allclose(triples(), shown, atol=1e-6) and kept() == ("A" * 10,)
    view.press('G')
    view.move(view.x + 40, view.y + 50)
    yield from until(lambda: value() != before, "the shape follows")
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from redrawn()
    assert are_automatic([0, 1, 2, 3, 4]) and agrees()
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and value() == before, "Ctrl+Z takes it back")
    assert types() == [AUTO] * 5
    print("an anchor", flush=True)


def a_handle(view):
    before = value()
    chosen(1, 'right_handle')
    view.move(*view.pixel_of(triples()[1, 2]))
    yield from redrawn()
    view.press('G')
    view.move(view.x + 20, view.y - 70)
    yield from until(lambda: value() != before and types()[1] == ('ALIGNED', 'ALIGNED'), "automatic handles become aligned")
    yield from redrawn()
    picture("handle")
    view.press('ESC')
    yield from until(lambda: value() == before and types()[1] == AUTO, "Esc brings back what they were")
    assert kept() == ("A" * 10,)
    view.press('G')
    view.move(view.x - 20, view.y - 40)
    yield from until(lambda: value() != before, "the shape follows")
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: kept() == ("AALLAAAAAA",), "the type is kept")
    arms = triples()[1, ::2] - triples()[1, 1]
    assert np.allclose(np.cross(*arms), 0, atol=1e-4) and agrees()
    view.press('TAB')
    yield from out_of_net()
    view.press('TAB')
    yield from into_net()
    assert types()[1] == ('ALIGNED', 'ALIGNED') and types()[0] == types()[2] == AUTO
    view.press('Z', ctrl=True)
    yield from until(lambda: bpy.context.mode == 'OBJECT', "Ctrl+Z out of the net")
    view.press('Z', ctrl=True)
    yield from until(in_net, "Ctrl+Z into the net before")
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and value() == before, "Ctrl+Z takes it back")
    yield from until(lambda: kept() == ("A" * 10,), "and the type")
    print("a handle", flush=True)


def set_by_v(view):
    """Blender's own menu; the type is kept."""
    before = value()
    chosen(3, 'left_handle', 'control_point', 'right_handle')
    yield from redrawn()
    with view.override():
        bpy.ops.curve.handle_type_set('EXEC_DEFAULT', True, type='VECTOR')
    yield from until(lambda: kept()[0][6:8] == "VV" and value() != before, "the type is kept")
    view.open_sidebar()
    yield from view.show_tab("NURBS", (1045, 538))
    yield from redrawn()
    picture("vector")
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and value() == before and kept() == ("A" * 10,), "Ctrl+Z takes it back")
    print("V", flush=True)


def along():
    """(n, 2): radius and tilt of the shape's joints."""
    steps = shape().data.splinewright.resolution_u
    return np.array([(point.radius, point.tilt) for point in shape().data.splines[0].points])[::steps]


def typed(view, keys):
    for key, text in keys:
        view.press(key, text)
    yield from redrawn()


def radius(view):
    chosen(1, 'left_handle', 'control_point', 'right_handle')
    before, shown = along(), value()
    view.move(*view.pixel_of(PLACES[1]))
    yield from redrawn()
    plain = picture("thin")
    view.press('S', alt=True)
    yield from until(lambda: STATE.weighing, "Alt+S is ours")
    view.move(view.x + 60, view.y)
    yield from until(lambda: along()[1, 0] > 1.1, "the mouse makes it thicker")
    yield from typed(view, (('TWO', "2"),))
    yield from until(lambda: along()[1, 0] == 2.0, "the number is the factor")
    yield from redrawn()
    assert STATE.weighing.text == "Radius × 2"
    assert mean_difference(picture("radius"), plain) > 0.2
    view.press('ESC')
    yield from until(lambda: STATE.weighing is None and np.array_equal(along(), before), "Esc puts it back")
    view.press('S', alt=True)
    yield from until(lambda: STATE.weighing, "Alt+S again")
    yield from typed(view, (('TWO', "2"),))
    view.press('RET')
    yield from until(lambda: STATE.weighing is None, "Return ends it")
    assert np.array_equal(along()[:, 0], [1, 2, 1, 1, 1]) and value() == shown
    assert part('bridge.net.live').problem(bpy.context.object) == ""
    view.press('Z', ctrl=True)
    yield from until(lambda: in_net() and np.array_equal(along(), before), "Ctrl+Z takes it back")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: in_net() and along()[1, 0] == 2.0, "Shift+Ctrl+Z does it again")
    print("Alt+S", flush=True)


def tilt(view):
    chosen(2, 'left_handle', 'control_point', 'right_handle')
    with view.override():
        shape().data.bevel_depth, shape().data.extrude = 0.02, 0.25
    view.move(*view.pixel_of(PLACES[2]))
    yield from redrawn()
    plain = picture("flat")
    view.press('T', ctrl=True)
    yield from until(lambda: STATE.weighing, "Ctrl+T is ours")
    yield from typed(view, (('NINE', "9"), ('ZERO', "0")))
    yield from until(lambda: np.isclose(along()[2, 1], math.pi / 2), "the number is degrees")
    yield from redrawn()
    assert mean_difference(picture("tilt"), plain) > 0.2
    view.press('LEFTMOUSE')
    yield from until(lambda: STATE.weighing is None, "a click ends it")
    assert np.allclose(along(), [(1, 0), (2, 0), (1, math.pi / 2), (1, 0), (1, 0)], atol=1e-6)
    view.press('TAB')
    yield from out_of_net()
    assert np.allclose(along()[2], (1, math.pi / 2), atol=1e-6)
    print("Ctrl+T", flush=True)


def left_alone(view):
    """In a curve of Blender's own the keys are Blender's; in meshes we have none."""
    ours = [keymap.name for keymap, _, name in part('ui.keymaps').of_user() if name.endswith(("radius_here", "tilt_here"))]
    assert ours == ['Curve', 'Curve']
    with view.override():
        bpy.ops.curve.primitive_bezier_curve_add()
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.curve.select_all(action='SELECT')
        bpy.ops.ed.undo_push(message="own")
    yield from redrawn()
    view.press('S', alt=True)
    yield from redrawn()
    assert STATE.weighing is None
    yield from typed(view, (('THREE', "3"),))
    view.press('RET')
    yield from until(lambda: bpy.context.window_manager.operators[-1].bl_idname == 'TRANSFORM_OT_transform', "Blender's own")
    assert np.isclose(points()[0].radius, 3.0)
    with view.override():
        bpy.ops.object.mode_set(mode='OBJECT')
        bpy.ops.object.delete()
    print("left alone", flush=True)


def saved_and_opened(view):
    """All of it is there when the file is opened again."""
    path = str(Path(tempfile.mkdtemp()) / "chain.blend")
    before, letters, shown = value(), kept(), along()
    with bpy.context.temp_override(window=view.window):
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
    yield from until(lambda: bpy.data.filepath == path and "chain" in bpy.data.objects, "the file")
    assert value() == before and kept() == letters and np.array_equal(along(), shown)
    yield from redrawn()                # Blender crashes where it is asked to quit before
    print("saved and opened", flush=True)


def steps():
    view = View()
    yield from made(view)
    yield from an_anchor(view)
    yield from a_handle(view)
    yield from set_by_v(view)
    yield from radius(view)
    yield from tilt(view)
    yield from left_alone(view)
    yield from saved_and_opened(view)
    print("handles, radius and tilt in a window:", bpy.app.version_string, flush=True)


run(steps())
