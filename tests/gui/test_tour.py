"""The README's tour in a real window; its pictures are those of the README."""

import math
import os
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Euler

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def frame(view):
    with view.override():
        bpy.ops.view3d.view_selected()
    yield from redrawn()


def look_from_above(view):
    """From the side and above, in perspective."""
    with view.override():
        region = bpy.context.space_data.region_3d
        region.view_rotation = Euler((math.radians(64), 0, math.radians(28))).to_quaternion()
        region.view_perspective = 'PERSP'


def teapot(view):
    """Points of the lid are lifted; the panel shows their numbers."""
    with view.override():
        bpy.ops.splinewright.add_teapot('EXEC_DEFAULT', True)
        bpy.context.space_data.overlay.show_cursor = False
    yield from frame(view)
    yield from view.show_tab("NURBS", (1045, 538))
    view.move(420, 420)
    view.press('TAB')
    yield from into_net()
    held = bpy.context.object
    points = part('bridge.net.live').session(held.data).net.positions
    held.show_in_front = False
    with view.override():
        select_points(*np.flatnonzero(points[:, 2] > points[:, 2].max() - 0.05).tolist())
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 0.25))
    yield from redrawn()
    save_picture(OUTPUT / "tour-net.png")
    view.press('TAB')
    yield from out_of_net()
    ob = bpy.data.objects["Teapot"]
    assert bpy.context.object == ob and ob.data.vertices and not part('bridge.shape.shape').is_touched(ob.data)
    ob.hide_set(True)


def knots(view):
    """The knots of a patch as text, along u or v; a wrong entry is refused."""
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True, count_v=5)
    yield from frame(view)
    ob = bpy.context.object
    value = ob.data.splinewright.value
    with view.override():
        bpy.ops.splinewright.set_knots('INVOKE_DEFAULT')
    yield from redrawn()
    save_picture(OUTPUT / "tour-knots.png")
    # The button V; newer dialogs have a line more.
    view.move(view.x + 150, view.y - (9 if bpy.app.version >= (4, 1) else 35))
    view.press('LEFTMOUSE')
    yield from redrawn()
    view.press('RET')
    operators = bpy.context.window_manager.operators
    yield from until(lambda: operators and operators[-1].bl_idname == 'SPLINEWRIGHT_OT_set_knots', "the dialog is confirmed")
    said = operators[-1]
    assert (said.axis, said.knots) == ('V', "0 0 0 0 1 2 2 2 2"), (said.axis, said.knots)
    assert ob.data.splinewright.value == value
    with view.override():
        knots_u = "0 0 0 0 0.5 2.5 3 3 3 3"
        assert bpy.ops.splinewright.set_knots('EXEC_DEFAULT', True, axis='U', knots=knots_u) == {'FINISHED'}
        try:
            bpy.ops.splinewright.set_knots('EXEC_DEFAULT', True, axis='U', knots="0 0 0 0 3 2 3 3 3 3")
            raise AssertionError("decreasing knots were taken")
        except RuntimeError as error:
            assert "knot 6, 2, is smaller than the one before it, 3" in str(error)
    assert ob.data.splinewright.value != value
    ob.hide_set(True)


def following(view):
    """A bevelled shape follows Blender's own curve, made exact."""
    with view.override():
        bpy.ops.curve.primitive_bezier_circle_add('EXEC_DEFAULT', True)
        source = bpy.context.object
        bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True, resolution_u=32)
    ob = bpy.context.object
    ob.data.bevel_depth = 0.04
    yield from frame(view)
    before = part('bridge.shape.shape').points_of(ob.data)
    source.data.splines[0].bezier_points[1].co.z += 0.8
    source.data.update_tag()
    points_of = part('bridge.shape.shape').points_of
    yield from until(lambda: np.abs(points_of(ob.data) - before).max() > 0.7, "the follower follows")
    yield from redrawn()
    save_picture(OUTPUT / "tour-follow.png")
    for other in (source, ob):
        other.hide_set(True)


def native(view):
    """Blender's own torus becomes a shape, whose net is edited."""
    with view.override():
        bpy.ops.surface.primitive_nurbs_surface_torus_add('EXEC_DEFAULT', True)
        bpy.ops.splinewright.make_exact('EXEC_DEFAULT', True)
    ob = bpy.context.object
    assert ob.type == 'MESH' and ob.data.splinewright.value.is_rational
    yield from frame(view)
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(*range(8))
    yield from redrawn()
    save_picture(OUTPUT / "tour-exact.png")
    view.press('TAB')
    yield from out_of_net()
    assert bpy.context.object == ob
    ob.hide_set(True)


def teaching(view):
    """Basis functions and the construction of a point beside a curve; both follow while a point is dragged."""
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, count=7)
        curve = bpy.context.object
        curve.data.bevel_depth = 0.012
        made = []
        for operator in (bpy.ops.splinewright.add_basis, bpy.ops.splinewright.add_construction):
            bpy.ops.object.select_all(action='DESELECT')
            curve.select_set(True)
            bpy.context.view_layer.objects.active = curve
            operator('EXEC_DEFAULT', True)
            made.append(bpy.context.object)
            made[-1].data.bevel_depth = 0.006
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.view3d.view_axis(type='TOP')
    yield from frame(view)
    with view.override():
        bpy.ops.object.select_all(action='DESELECT')
        curve.select_set(True)
        bpy.context.view_layer.objects.active = curve
    before = [ob.data.splinewright.value for ob in made]
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(3)
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0.4, 0))
    yield from redrawn()
    assert made[0].data.splinewright.value == before[0] and made[1].data.splinewright.value != before[1]
    view.press('TAB')
    yield from out_of_net()
    with view.override():
        curve.select_set(False)
        made[1].select_set(True)
        bpy.context.view_layer.objects.active = made[1]
    yield from redrawn()
    save_picture(OUTPUT / "tour-teaching.png")
    for ob in (curve, *made):
        ob.hide_set(True)


def conics(view):
    """The weight of a conic is a number in the panel, also a week later; beyond -1 no line is drawn across infinity."""
    with view.override():
        bpy.ops.splinewright.add_conic('EXEC_DEFAULT', True, size=2.0)
        ob = bpy.context.object
        ob.data.bevel_depth = 0.02
        bpy.ops.view3d.view_axis(type='TOP')
    for weight in (1.0, 3.0, -0.7, -2.0):
        ob.data.splinewright_parameters.conic_weight = weight
        ob.data.splinewright.reach = 3.0
        yield from redrawn()
    assert len(ob.data.splines) == 3
    yield from frame(view)
    save_picture(OUTPUT / "tour-conic.png")
    ob.hide_set(True)


def surfaces(view):
    """A vase follows the net of its profile; by tolerance its flat parts have few faces."""
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
        profile = bpy.context.object
        radii, heights = (0.0, 0.75, 1.25, 0.4, 0.35, 0.75), (0.0, 0.0, 0.9, 1.6, 2.1, 2.4)
        profile.data.splinewright.value = library().NurbsCurve(
            3, [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [(r, 0, z) for r, z in zip(radii, heights)])
        bpy.ops.splinewright.add_revolve('EXEC_DEFAULT', True)
        vase = bpy.context.object
        part('bridge.data.settings').set_tolerance(vase.data, 0.01)
        bpy.context.space_data.overlay.show_wireframes = True
        vase.select_set(False)
        profile.select_set(True)
        bpy.context.view_layer.objects.active = profile
    before = len(vase.data.polygons)
    look_from_above(view)
    yield from frame(view)
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(2)
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0.5, 0, 0))
    yield from redrawn()
    assert np.abs(part('bridge.shape.shape').points_of(vase.data)[:, 0]).max() > 1.1 and len(vase.data.polygons) != before
    view.press('TAB')
    yield from out_of_net()
    with view.override():
        profile.select_set(False)
        vase.select_set(True)
        bpy.context.view_layer.objects.active = vase
    yield from redrawn()
    save_picture(OUTPUT / "tour-revolve.png")
    with view.override():
        bpy.context.space_data.overlay.show_wireframes = False
    for ob in (profile, vase):
        ob.hide_set(True)


def seams(view):
    """The edge between two patches is violet, and green once they are joined."""
    sc = library()
    nets = np.array([[[(i, j, 0.4 * np.cos(1.3 * i) * np.sin(j)) for j in range(4)] for i in range(4)] for _ in range(2)])
    nets[1] = nets[1] * (-1, 1, -1.5)
    with view.override():
        bpy.ops.splinewright.add_bezier_patch('EXEC_DEFAULT', True)
    ob = bpy.context.object
    flat = nets.copy()
    flat[:, 0, :, 2] = 0.0
    ob.data.splinewright.value = sc.PatchSet.from_patches([sc.BezierPatch(net) for net in flat])
    ob.data.splinewright.show_seams = True
    yield from frame(view)
    before = save_picture(OUTPUT / "seam-before.png").astype(int)
    with view.override():
        assert bpy.ops.splinewright.join_patches('EXEC_DEFAULT', True, continuity='G2', moves='both') == {'FINISHED'}
        bpy.ops.object.select_all(action='DESELECT')
    bpy.context.view_layer.objects.active = ob
    yield from redrawn()
    after = save_picture(OUTPUT / "seam-after.png").astype(int)
    assert green(after) > green(before) + 200, (green(before), green(after))
    ob.hide_set(True)
    with view.override():
        bpy.ops.splinewright.add_teapot('EXEC_DEFAULT', True)
    pot = bpy.context.object
    pot.data.splinewright.show_seams = True
    look_from_above(view)
    yield from frame(view)
    save_picture(OUTPUT / "tour-seams.png")
    pot.hide_set(True)


def green(picture):
    """How many pixels have that color."""
    red, own, blue = np.moveaxis(picture, -1, 0)
    return int(((own > 150) & (red < 110) & (blue < 130)).sum())


def library():
    """splinecore, as the add-on carries it."""
    return part('core.base.library').sc


def steps():
    view = View()
    empty_file()
    view.open_sidebar()
    view.move(420, 420)
    yield from redrawn()
    for stop in (teapot, knots, following, native, teaching, conics, surfaces, seams):
        yield from stop(view)
    print("the tour is as the README says:", bpy.app.version_string, flush=True)


run(steps())
