"""Vertices go to the nearest places of a shape, in the scene, against closed forms and dense samples."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

import curves
from shapes import activate, add, op
from support import part

projecting = part('core.meets.projecting')
RNG = np.random.default_rng(5)


def mesh_of(points, faces=(), name="cloud"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def world_points(ob):
    found = np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.vertices.foreach_get('co', found)
    return found.reshape(-1, 3) @ np.array(ob.matrix_world.to_3x3()).T + np.array(ob.matrix_world.translation)


def onto(shape, *sources):
    activate(*sources, shape)
    bpy.context.view_layer.objects.active = shape
    bpy.context.view_layer.update()


def run(**settings):
    assert op(bpy.ops.splinewright.project_points, **settings) == {'FINISHED'}
    return bpy.context.object


def sphere():
    bpy.ops.splinewright.add_sphere()
    return bpy.context.object


def test_points_go_to_the_sphere_along_its_radii_through_both_transforms(capfd):
    ball = sphere()
    ball.location, ball.scale = (1, 2, 3), (2, 2, 2)
    bpy.context.view_layer.update()
    radius = ball.dimensions.x / 2
    cloud = mesh_of(RNG.uniform(-3, 3, (200, 3)), [(0, 1, 2)])
    cloud.matrix_world = Matrix.LocRotScale((0, 1, 0), Matrix.Rotation(0.5, 3, 'Z').to_quaternion(), (1, 3, 0.5))
    onto(ball, cloud)
    before = world_points(cloud)
    made = run()
    ways = before - (1, 2, 3)
    lengths = np.linalg.norm(ways, axis=1)
    wanted = (1, 2, 3) + radius * ways / lengths[:, None]
    np.testing.assert_allclose(world_points(made), wanted, atol=1e-5)
    assert made != cloud and len(made.data.polygons) == 1 and np.array_equal(world_points(cloud), before)
    largest = float(capfd.readouterr().out.split("largest distance ")[1].split(",")[0])
    assert largest == pytest.approx(np.abs(lengths - radius).max(), rel=1e-3)


def test_in_place_and_of_selected_ones():
    ball = sphere()
    cloud = mesh_of(RNG.uniform(-3, 3, (40, 3)))
    for vertex in cloud.data.vertices:
        vertex.select = vertex.index < 10
    before = world_points(cloud)
    onto(ball, cloud)
    run(in_place=True, selected_only=True)
    after = world_points(cloud)
    assert np.array_equal(after[10:], before[10:]) and len(bpy.data.objects) == 2
    np.testing.assert_allclose(np.linalg.norm(after[:10], axis=1), ball.dimensions.x / 2, atol=1e-5)


def test_of_several_curves_the_nearest_one_counts():
    shape = add(curves.value_of('many curves'))
    cloud = mesh_of(RNG.uniform(-2, 2, (60, 3)))
    onto(shape, cloud)
    made = world_points(run())
    samples = np.concatenate([curve.evaluate(np.linspace(*curve.domain, 4001)) for curve in curves.value_of('many curves')])
    least = np.array([np.linalg.norm(samples - point, axis=1).min() for point in world_points(cloud)])
    distances = np.linalg.norm(made - world_points(cloud), axis=1)
    assert (distances <= least + 1e-5).all() and (distances >= least - 5e-3).all()


def test_in_parts_and_at_once_are_the_same(monkeypatch):
    pieces, points, told = curves.value_of('many curves'), RNG.uniform(-2, 2, (50, 3)), []
    whole = projecting.feet(pieces, points)
    monkeypatch.setattr(projecting, 'PART', 7)
    parts = projecting.feet(pieces, points, told.append)
    assert all(map(np.array_equal, whole, parts)) and told == [7, 14, 21, 28, 35, 42, 49, 50]


def test_a_mesh_with_shape_keys_is_copied_without_them_and_stays_as_it_is():
    ball, cloud = sphere(), mesh_of(RNG.uniform(-3, 3, (10, 3)))
    cloud.shape_key_add(name="Basis")
    onto(ball, cloud)
    with pytest.raises(RuntimeError, match="shape keys"):
        run(in_place=True)
    made = run(in_place=False)
    assert made.data.shape_keys is None and cloud.data.shape_keys is not None
    np.testing.assert_allclose(np.linalg.norm(world_points(made), axis=1), ball.dimensions.x / 2, atol=1e-5)


def test_what_cannot_be_is_said_and_nothing_is_lost():
    ball, empty = sphere(), mesh_of([])
    onto(ball, empty)
    for settings, word in (({}, "no vertices"), ({'selected_only': True}, "no vertices are selected")):
        with pytest.raises(RuntimeError, match=word):
            run(**settings)
    flat = mesh_of([(0, 0, 0)])
    flat.scale = (0, 1, 1)
    onto(ball, flat)
    with pytest.raises(RuntimeError, match="scale of 0"):
        run(selected_only=False)
    activate(ball)
    assert not bpy.ops.splinewright.project_points.poll() and len(bpy.data.objects) == 3


def test_undo_takes_it_back():
    ball, cloud = sphere(), mesh_of(RNG.uniform(-3, 3, (10, 3)))
    onto(ball, cloud)
    bpy.ops.ed.undo_push(message="both")
    name = run().name
    wanted = world_points(bpy.data.objects[name])
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects and "cloud" in bpy.data.objects
    bpy.ops.ed.redo()
    assert np.array_equal(world_points(bpy.data.objects[name]), wanted)


def test_a_mesh_of_any_scale_is_projected():
    """Products of three scales are below the least number of single precision."""
    ball = sphere()
    cloud = mesh_of(RNG.uniform(-3e16, 3e16, (20, 3)))
    cloud.scale = (1e-16, 1e-16, 1e-16)
    onto(ball, cloud)
    before = world_points(cloud)
    radius = ball.dimensions.x / 2
    np.testing.assert_allclose(world_points(run()), radius * before / np.linalg.norm(before, axis=1)[:, None], atol=1e-5)
