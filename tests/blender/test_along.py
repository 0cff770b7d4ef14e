"""Radius and tilt of control points changed in the net of a curve, beside Blender's own curve with the same."""

import math

import bpy
import numpy as np
import pytest

from curves import run, value_of
from natives import drawn, exact, native, select as select_objects
from shapes import add, enter, leave, op, require_exact, select
from support import part, splinecore as sc
from test_files import reopen, save
from test_handle_types import bezier, choose

curve_layers, live, store = (part(f'bridge.{name}') for name in ('curve.curve_layers', 'net.live', 'data.store'))
AUTO = [('AUTO', 'AUTO')]


def shape(name="shape"):
    return bpy.data.objects[name]


def values(ob):
    """(n, 2) of each spline: radius and tilt."""
    return [np.array([(point.radius, point.tilt) for point in spline.points]) for spline in ob.data.splines]


def changed(factor=1.0, degrees=0.0):
    if factor != 1.0:
        assert op(bpy.ops.splinewright.radius_here, factor=factor) == {'FINISHED'}
    if degrees:
        assert op(bpy.ops.splinewright.tilt_here, angle=math.radians(degrees)) == {'FINISHED'}


def at_joints(ob, steps):
    """Radius and tilt at the joints of a chain."""
    return values(ob)[0][::steps]


WAYS = (('LINEAR', 'LINEAR'), ('EASE', 'CARDINAL'), ('CARDINAL', 'EASE'), ('BSPLINE', 'LINEAR'))


@pytest.mark.parametrize('closed', (False, True))
@pytest.mark.parametrize('ways', WAYS)
def test_a_bevelled_chain_is_as_thick_and_twisted_as_blenders_own(ways, closed):
    own, ours = bezier(AUTO * 5, closed, name="own"), bezier(AUTO * 5, closed, name="ours")
    for ob in (own, ours):
        for i, point in enumerate(ob.data.splines[0].bezier_points):
            point.radius, point.tilt = 1 + 0.2 * i, 0.1 * i
        ob.data.splines[0].resolution_u = ob.data.resolution_u = 12
        ob.data.splines[0].radius_interpolation, ob.data.splines[0].tilt_interpolation = ways
        ob.data.bevel_depth, ob.data.bevel_resolution, ob.data.twist_mode = 0.1, 2, 'Z_UP'
    exact(ours)
    ours.data.splinewright.resolution_u = 12
    select_objects(own)
    bpy.ops.object.mode_set(mode='EDIT')
    choose(own, 1, 3)
    op(bpy.ops.transform.transform, mode='CURVE_SHRINKFATTEN', value=(2, 0, 0, 0))
    op(bpy.ops.transform.tilt, value=math.radians(90))
    bpy.ops.object.mode_set(mode='OBJECT')
    select_objects(ours)
    choose(enter(), 1, 3)
    changed(2.0, 90)
    leave()
    own, ours = shape("own"), shape("ours")
    theirs = np.array([(point.radius, point.tilt) for point in own.data.splines[0].bezier_points])
    if 'BSPLINE' not in ways:           # that goes past what joints have
        assert np.allclose(at_joints(ours, 12), theirs, atol=1e-4)
    require_exact(ours)
    one, other = (np.array([vertex.co for vertex in drawn(ob).vertices]) for ob in (own, ours))
    assert one.shape == other.shape
    apart = np.linalg.norm(one[:, None] - other, axis=2)        # a closed one begins elsewhere
    assert max(apart.min(0).max(), apart.min(1).max()) < 0.02   # Blender's directions of two samplings of one curve differ
    native(ours)
    spline = shape("ours").data.splines[0]
    assert (spline.radius_interpolation, spline.tilt_interpolation) == ways
    back = np.array([(point.radius, point.tilt) for point in spline.bezier_points])
    assert np.allclose(back, theirs, atol=1e-3)


def test_undo_and_redo_go_through_the_net():
    ob = add(sc.HermiteCurve(value_of('hermite').points, value_of('hermite').tangents))
    held = enter()
    choose(held, 1)
    plain = values(shape())
    changed(2.0)
    thick = values(shape())
    changed(degrees=90)
    turned = values(shape())
    assert thick[0][:, 0].max() == 2.0 and (thick[0][:, 1] == 0).all()
    assert np.isclose(turned[0][:, 1].max(), math.pi / 2)
    for wanted in (thick, plain):
        bpy.ops.ed.undo()
        assert all(map(np.array_equal, values(shape()), wanted))
    for wanted in (thick, turned):
        bpy.ops.ed.redo()
        assert all(map(np.array_equal, values(shape()), wanted))
    op(bpy.ops.transform.translate, value=(0, 0, 1))
    assert all(map(np.array_equal, values(shape()), turned))
    leave()
    assert all(map(np.array_equal, values(shape()), turned))
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert all(map(np.array_equal, values(shape()), thick))


@pytest.mark.parametrize('kind', ('nurbs', 'periodic', 'rational cubic', 'cubic', 'closed hermite', 'uniform', 'circle'))
def test_all_points_together_change_all_of_it(kind):
    ob = add(value_of(kind))
    held = enter()
    bpy.ops.curve.select_all(action='SELECT')
    changed(3.0, 30)
    assert all(np.allclose(each, (3, math.radians(30)), atol=1e-5) for each in values(shape()))
    leave()
    require_exact(shape())


def test_a_nurbs_point_counts_as_in_blenders_own_curve():
    bpy.ops.curve.primitive_nurbs_path_add()
    own = bpy.context.object
    own.name = "own"
    ours = own.copy()
    ours.data = own.data.copy()
    ours.name = "ours"
    bpy.context.scene.collection.objects.link(ours)
    own.data.splines[0].points[2].radius = 3.0
    for ob in (own, ours):
        ob.data.bevel_depth = 0.1
    exact(ours)
    held = enter()
    bpy.ops.curve.select_all(action='DESELECT')
    held.data.splines[0].points[2].select = True
    held.data.update_tag()
    bpy.ops.ed.undo_push(message="choose")
    changed(3.0)
    leave()
    widths = []
    for name in ("own", "ours"):
        found = np.array([vertex.co for vertex in drawn(shape(name)).vertices])
        widths.append(np.abs(found[:, 1:]).max(1))
    assert np.isclose(widths[0].max(), widths[1].max(), atol=0.002) and np.isclose(widths[0].min(), widths[1].min(), atol=1e-4)


@pytest.mark.parametrize('name, settings', (('insert_knot', {'where': 'SPANS'}), ('raise_degree', {})))
def test_a_refinement_leaves_it_where_it_is(name, settings):
    add(value_of('nurbs'))
    shape().data.splinewright.resolution_u = 32
    held = enter()
    select(held, 2)
    changed(4.0, 45)
    before = curve_of_values(shape())
    leave()
    run(name, **settings)
    at, after = curve_of_values(shape())
    assert np.allclose(np.stack([np.interp(at, before[0], column) for column in before[1].T], 1), after, atol=0.02)


def curve_of_values(ob):
    """(parts of the domain, radius and tilt there)."""
    lines = part('bridge.shape.curve_pieces').shown_of(ob.data, store.read(ob.data))
    return lines[0][0].at, values(ob)[0]


@pytest.mark.parametrize('places, count', (((2, 3), 7), ((0, 1), 7)))
def test_a_point_more_in_the_net_leaves_it_at_its_joints(places, count):
    points = np.array([(i, i % 2, 0) for i in range(6)], float)
    add(sc.HermiteCurve(points, np.ones((6, 2, 3))))
    shape().data.splinewright.resolution_u = 8
    held = enter()
    choose(held, 1)
    changed(3.0, 60)
    choose(held, *places)
    op(bpy.ops.curve.subdivide)
    bpy.context.view_layer.update()
    now = at_joints(shape(), 8)
    joint = 1 + (places == (0, 1))
    assert len(now) == count and np.allclose(now[joint], (3, math.radians(60)), atol=1e-5)
    assert np.allclose(np.delete(now, (joint - 1, joint, joint + 1), 0), (1, 0), atol=1e-5)
    if places == (2, 3):
        choose(bpy.context.object, 6)
        op(bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': (1, 0, 2)})
        bpy.context.view_layer.update()
        now = at_joints(shape(), 8)
        assert len(now) == 8 and np.allclose(now[1], (3, math.radians(60)), atol=1e-5) and np.allclose(now[3:], (1, 0), atol=1e-5)
    for _ in range(4 if places == (2, 3) else 2):
        bpy.ops.ed.undo()
    assert np.allclose(at_joints(shape(), 8)[1], (3, math.radians(60)), atol=1e-5) and len(at_joints(shape(), 8)) == 6


def test_it_is_saved_and_known_at_other_resolutions(tmp_path):
    add(value_of('hermite'))
    held = enter()
    choose(held, 1)
    changed(2.0, 20)
    path = str(tmp_path / "along.blend")
    save(path)
    reopen(path)
    select_objects(shape())
    before = values(shape())
    shape().data.splinewright.resolution_u = 5
    shape().data.splinewright.resolution_u = len(before[0]) // (len(value_of('hermite').points) - 1)
    assert all(map(np.allclose, values(shape()), before))
    choose(enter(), 1)
    changed(2.0)
    assert np.isclose(values(shape())[0][:, 0].max(), 4.0)
    bpy.ops.ed.undo()
    assert np.isclose(values(shape())[0][:, 0].max(), 2.0)
    leave()


def test_what_is_called_off_leaves_no_trace():
    add(value_of('nurbs'))
    held = enter()
    select(held, 1)
    changed(2.0)
    before, note = values(shape()), shape().data[curve_layers.KEY].to_dict()
    gesture = live.begin_along(held)
    gesture.show(5.0, 1.0)
    assert not np.array_equal(values(shape())[0], before[0])
    gesture.put_back()
    assert all(map(np.array_equal, values(shape()), before)) and shape().data[curve_layers.KEY].to_dict() == note
    leave()


def test_several_nets_change_together():
    for name in ("one", "other"):
        add(value_of('hermite'), name=name)
    select_objects(shape("one"), shape("other"))
    op(bpy.ops.splinewright.edit_net)
    assert len(bpy.context.objects_in_mode) == 2
    bpy.ops.curve.select_all(action='SELECT')
    changed(2.0, 10)
    assert all(np.allclose(values(shape(name)), (2, math.radians(10)), atol=1e-5) for name in ("one", "other"))
    bpy.ops.ed.undo()
    assert all(np.allclose(values(shape(name)), (2, 0), atol=1e-5) for name in ("one", "other"))
    bpy.ops.ed.undo()
    assert all((np.array(values(shape(name))) == (1, 0)).all() for name in ("one", "other"))
    leave()


def test_it_is_offered_where_it_can_be_done():
    assert not bpy.ops.splinewright.radius_here.poll() and not bpy.ops.splinewright.tilt_here.poll()
    ob = add(value_of('nurbs'))
    assert not bpy.ops.splinewright.radius_here.poll()
    held = enter()
    bpy.ops.curve.select_all(action='DESELECT')
    with pytest.raises(RuntimeError, match="select points of the net"):
        op(bpy.ops.splinewright.tilt_here, angle=1.0)
    leave()
    add(sc.BezierPatch(np.random.default_rng(1).uniform(size=(3, 3, 3))))
    enter()
    assert not bpy.ops.splinewright.radius_here.poll() and not bpy.ops.splinewright.tilt_here.poll()
    leave()
    bpy.ops.splinewright.add_catmull_rom()
    op(bpy.ops.splinewright.edit_net)
    assert not bpy.ops.splinewright.radius_here.poll()
    leave()


@pytest.mark.parametrize('damaged', ("x", -3, 2.5, {}))
def test_a_damaged_number_is_passed_over(damaged):
    add(value_of('hermite'))
    shape().data[part('bridge.curve.curve_layers')._NUMBER] = damaged
    held = enter()
    choose(held, 1)
    changed(2.0)
    bpy.ops.ed.undo()
    assert (values(shape())[0] == (1, 0)).all()
    bpy.ops.ed.redo()
    assert values(shape())[0][:, 0].max() == 2.0
    leave()
