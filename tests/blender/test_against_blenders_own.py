"""What Blender does itself, beside what we do: lengths, Bezier points, reversing, subdividing, extruding, spinning, Catmull-Rom splines."""

import bpy
import mathutils
import numpy as np
import pytest

import blender_objects
from natives import select
from support import part, splinecore as sc

native = part('core.native.native')
read_native = part('bridge.native.read_native')
Direction, Flags = native.Direction, native.Flags
#: Blender's rounding, of the size.
NEAR = 1e-6
#: The same where Blender adds differences up.
ADDED_UP = 1e-5
#: Blender measures lengths on its steps, of which there are so many for a point, and so cuts corners.
STEPS, LENGTHS = 200, 2e-3
KINDS = [(degree, Flags(cyclic, endpoint)) for degree in (1, 2, 3, 5) for cyclic in (False, True) for endpoint in (False, True)]


def random_points(seed, count, weights=True):
    rng = np.random.default_rng(seed)
    net = rng.uniform(-1, 1, (count, 4))
    net[:, 3] = rng.uniform(0.5, 2, count) if weights else 1
    return net.astype(np.float32).astype(float)


def nurbs(seed, degree, flags, count=7):
    ob = blender_objects.curve_object()
    blender_objects.set_nurbs_spline(ob, random_points(seed, count), Direction(count, degree, flags), 12)
    return ob


def bezier(seed, count=4, cyclic=False):
    ob = blender_objects.curve_object()
    points = np.random.default_rng(seed).uniform(-1, 1, (count, 3, 3))
    blender_objects.set_bezier_spline(ob, points, [('FREE', 'FREE')] * count, cyclic=cyclic, resolution=12)
    return ob


def value_of(ob):
    return read_native.read(ob).value


def in_edit_mode(ob, operator, **settings):
    """An operator of Blender's on all points of an object."""
    select(ob)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.curve.select_all(action='SELECT')
    assert operator('EXEC_DEFAULT', **settings) == {'FINISHED'}
    bpy.ops.object.mode_set(mode='OBJECT')
    return value_of(ob)


def places(value, fractions=np.linspace(0, 1, 40)):
    start, end = value.domain
    return value.evaluate(start + fractions * (end - start))


def far(one, other):
    return np.abs(one - other).max()


@pytest.mark.parametrize('seed', range(3))
@pytest.mark.parametrize('degree, flags', KINDS, ids=str)
def test_lengths_of_nurbs_curves(degree, flags, seed):
    ob = nurbs(seed, degree, flags)
    assert ob.data.splines[0].calc_length(resolution=STEPS) == pytest.approx(value_of(ob).length(tolerance=1e-9), rel=LENGTHS)


@pytest.mark.parametrize('seed', range(6))
@pytest.mark.parametrize('cyclic', (False, True))
def test_lengths_of_bezier_curves(cyclic, seed):
    ob = bezier(seed, cyclic=cyclic)
    assert ob.data.splines[0].calc_length(resolution=STEPS) == pytest.approx(value_of(ob).length(tolerance=1e-9), rel=LENGTHS)


@pytest.mark.parametrize('seed', range(10))
def test_points_of_a_bezier_curve(seed):
    points = np.random.default_rng(seed).uniform(-1, 1, (4, 3))
    found = mathutils.geometry.interpolate_bezier(*map(mathutils.Vector, points), 33)
    assert far(np.array(found), sc.BezierCurve(points).evaluate(np.linspace(0, 1, 33))) < ADDED_UP


@pytest.mark.parametrize('degree, flags', [(degree, flags) for degree, flags in KINDS if degree == 1 or not all(flags[:2])], ids=str)
def test_switch_direction_is_reverse(degree, flags):
    ob = nurbs(5, degree, flags)
    before = value_of(ob).reversed()
    after = in_edit_mode(ob, bpy.ops.curve.switch_direction)
    if not flags.cyclic:
        assert far(places(before), places(after)) < NEAR
    else:                               # Blender lets the curve begin elsewhere
        assert np.abs(before.nearest(places(after)).distances).max() < NEAR


@pytest.mark.parametrize('degree', (2, 3, 5))
def test_switch_direction_makes_another_curve_of_a_cyclic_one_with_end_points(degree):
    """Blender's knots of these are other ones backwards; ours are reversed with the curve."""
    ob = nurbs(5, degree, Flags(cyclic=True, endpoint=True))
    before = value_of(ob)
    after = in_edit_mode(ob, bpy.ops.curve.switch_direction)
    assert np.abs(before.reversed().nearest(places(after)).distances).max() > 0.1
    assert np.abs(before.reversed().nearest(places(before)).distances).max() < NEAR


def test_switch_direction_of_a_chain_is_reverse():
    ob = bezier(6)
    before = value_of(ob).reversed()
    assert far(places(before), places(in_edit_mode(ob, bpy.ops.curve.switch_direction))) < NEAR


@pytest.mark.parametrize('cyclic', (False, True))
@pytest.mark.parametrize('cuts', (1, 2, 5))
def test_subdivide_of_a_chain_splits_it_evenly(cuts, cyclic):
    ob = bezier(7, cyclic=cyclic)
    before = value_of(ob)
    after = in_edit_mode(ob, bpy.ops.curve.subdivide, number_cuts=cuts)
    spans = len(before.points) - 1
    at = np.linspace(0, spans, spans * (cuts + 1) + 1)
    assert len(after.points) == len(at) and far(after.points, before.evaluate(at)) < NEAR
    assert far(places(before), places(after)) < NEAR


@pytest.mark.parametrize('flags', (Flags(), Flags(endpoint=True)), ids=str)
@pytest.mark.parametrize('degree', (1, 2, 3))
def test_subdivide_of_nurbs_points_halves_the_legs_of_the_polygon(degree, flags):
    """Which keeps the shape of polygons alone; to insert knots keeps each."""
    ob = nurbs(8, degree, flags)
    before, points = value_of(ob), np.array([point.co for point in ob.data.splines[0].points])
    after = in_edit_mode(ob, bpy.ops.curve.subdivide)
    halves = (points[1:] + points[:-1]) / 2
    expected = np.stack([points[:-1], halves], 1).reshape(-1, 4)
    assert far(np.array([point.co for point in ob.data.splines[0].points]), [*expected, points[-1]]) < NEAR
    assert (np.abs(before.nearest(places(after)).distances).max() < NEAR) == (degree == 1)


def surface_row(points, degree):
    """A surface object of one row."""
    bpy.ops.surface.primitive_nurbs_surface_curve_add()
    ob = bpy.context.object
    ob.data.splines.clear()
    spline = ob.data.splines.new('NURBS')
    spline.points.add(len(points) - 1)
    spline.points.foreach_set('co', np.ravel(points))
    spline.use_endpoint_u, spline.order_u = True, degree + 1
    return ob


def of_row(points, degree):
    direction = Direction(len(points), degree, Flags(endpoint=True))
    return sc.NurbsCurve(degree, native.plain_knots(direction), points[:, :3], points[:, 3])


@pytest.mark.parametrize('degree', (1, 2, 3))
def test_extrude(degree):
    points = random_points(9, 6)
    ob, way = surface_row(points, degree), (0.5, -0.25, 2)
    found = in_edit_mode(ob, bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': way})
    expected = sc.build.extrude(of_row(points, degree), way)
    grid = [np.linspace(start, end, 15) for start, end in found.domain]
    assert np.abs(expected.nearest(found.evaluate_grid(*grid).reshape(-1, 3)).distances).max() < 4 * NEAR
    grid = [np.linspace(start, end, 15) for start, end in expected.domain]
    assert np.abs(found.nearest(expected.evaluate_grid(*grid).reshape(-1, 3)).distances).max() < 4 * NEAR


@pytest.mark.parametrize('degree', (1, 2, 3))
def test_spin(degree):
    points = random_points(10, 5, weights=False)
    points[:, 0] += 3
    found = in_edit_mode(surface_row(points, degree), bpy.ops.curve.spin, center=(0, 0, 0), axis=(0, 0, 1))
    expected = sc.build.revolve(of_row(points, degree), (0, 0, 0), (0, 0, 1))
    grid = [np.linspace(start, end, 15) for start, end in found.domain]
    assert np.abs(expected.nearest(found.evaluate_grid(*grid).reshape(-1, 3)).distances).max() < 4 * NEAR


def catmull_rom_tree():
    tree = bpy.data.node_groups.new("Catmull-Rom", 'GeometryNodeTree')
    if hasattr(tree, 'interface'):
        for way in ('INPUT', 'OUTPUT'):
            tree.interface.new_socket("Geometry", in_out=way, socket_type='NodeSocketGeometry')
    else:
        tree.inputs.new('NodeSocketGeometry', "Geometry")
        tree.outputs.new('NodeSocketGeometry', "Geometry")
    names = ('NodeGroupInput', 'GeometryNodeCurveSplineType', 'GeometryNodeCurveToMesh', 'NodeGroupOutput')
    nodes = [tree.nodes.new(name) for name in names]
    nodes[1].spline_type = 'CATMULL_ROM'
    for before, after in zip(nodes, nodes[1:]):
        tree.links.new(before.outputs[0], after.inputs[0])
    return tree


@pytest.mark.parametrize('closed', (False, True))
@pytest.mark.parametrize('count', (3, 4, 9))
def test_catmull_rom_splines(count, closed):
    """Blender's open ones run out with the end points doubled."""
    ob = blender_objects.curve_object()
    points = random_points(count, count)
    spline = ob.data.splines.new('POLY')
    spline.points.add(count - 1)
    spline.points.foreach_set('co', np.float32(points).ravel())
    spline.use_cyclic_u = closed
    ob.modifiers.new("Nodes", 'NODES').node_group = catmull_rom_tree()
    bpy.context.view_layer.update()
    found = blender_objects.evaluated_vertices(ob)
    points = points[:, :3]
    if closed:
        expected = sc.build.catmull_rom(points, closed=True).evaluate(np.arange(12 * count) / 12)
    else:
        expected = sc.build.catmull_rom([points[0], *points, points[-1]]).evaluate(1 + np.arange(12 * count - 11) / 12)
    assert far(found, expected) < NEAR
