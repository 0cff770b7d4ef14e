"""Transforms of objects, into definitions and under nets."""

import bpy
import numpy as np
import pytest

from shapes import KINDS, VALUES, add, by_hand, enter, first_point, leave, move, op, require_exact, select, world_points
from support import part, vertices

recipes, shape = part('bridge.recipes.recipes'), part('bridge.shape.shape')


TURNED = dict(location=(1, -2, 3), rotation_euler=(0.3, -0.8, 1.1), scale=(2, 0.5, 1.5))


@pytest.mark.parametrize('mirrored', (False, True))
@pytest.mark.parametrize('name', KINDS)
def test_apply_transform_goes_into_the_definition_and_nothing_moves(name, mirrored):
    ob = add(VALUES[name]())
    for key, setting in TURNED.items():
        setattr(ob, key, setting)
    if mirrored:
        ob.scale.z *= -1
    bpy.context.view_layer.update()
    child = bpy.data.objects.new("child", None)
    bpy.context.scene.collection.objects.link(child)
    child.parent, child.location = ob, (1, 1, 1)
    bpy.context.view_layer.update()
    before, of_child = world_points(ob), child.matrix_world.copy()
    assert op(bpy.ops.splinewright.apply_transform) == {'FINISHED'}
    bpy.context.view_layer.update()
    assert np.allclose(ob.matrix_world, np.eye(4), atol=1e-6)
    after = world_points(ob)
    if mirrored and ob.type == 'MESH':
        # u and v are exchanged: the same points in another order.
        assert after.shape == before.shape
        assert np.allclose(np.sort(after, 0), np.sort(before, 0), atol=1e-4)
    else:
        assert np.allclose(after, before, atol=1e-5)
    if ob.parent is None and ob.type == 'MESH':
        assert np.allclose(child.matrix_world, of_child, atol=1e-5)
    require_exact(ob)
    assert not shape.is_touched(ob.data)


def test_a_transform_that_is_animated_is_not_applied_for_its_keys_would_put_it_back():
    ob = add(VALUES['nurbs patch']())
    ob.location = 1, 2, 3
    ob.keyframe_insert('location', frame=1)
    ob.driver_add('rotation_euler', 2).driver.expression = "0.5"
    value = ob.data.splinewright.value
    for word, parts in (("location", {}), ("rotation", {'location': False})):
        with pytest.raises(RuntimeError, match=f"its {word} is animated"):
            op(bpy.ops.splinewright.apply_transform, **parts)
    assert ob.data.splinewright.value == value and tuple(ob.location) == (1, 2, 3)
    ob.scale = 2, 2, 2
    assert op(bpy.ops.splinewright.apply_transform, location=False, rotation=False) == {'FINISHED'}


@pytest.mark.parametrize('parts', [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)])
def test_any_part_of_a_transform_may_be_applied(parts):
    ob = add(VALUES['nurbs patch']())
    for key, setting in TURNED.items():
        setattr(ob, key, setting)
    before = world_points(ob)
    location, rotation, scale = map(bool, parts)
    op(bpy.ops.splinewright.apply_transform, location=location, rotation=rotation, scale=scale)
    assert np.allclose(world_points(ob), before, atol=1e-5)
    assert not location or np.allclose(ob.location, 0)
    assert not rotation or np.allclose(ob.rotation_euler, 0, atol=1e-6)
    assert not scale or np.allclose(ob.scale, 1, atol=1e-6)
    assert location or np.allclose(ob.location, (1, -2, 3))
    require_exact(ob)


def test_a_transform_is_not_applied_to_shared_data_or_a_flat_scale():
    ob = add(VALUES['nurbs patch']())
    value = ob.data.splinewright.value
    ob.scale.x = 0
    with pytest.raises(RuntimeError, match="scale of 0"):
        bpy.ops.splinewright.apply_transform()
    ob.scale.x = 2
    twin = ob.copy()
    bpy.context.scene.collection.objects.link(twin)
    with pytest.raises(RuntimeError, match="single-user"):
        bpy.ops.splinewright.apply_transform()
    assert ob.data.splinewright.value == value


def test_mirrored_patches_keep_their_normals_outside():
    ob = add(VALUES['teapot']())
    ob.scale.x = -1
    op(bpy.ops.splinewright.apply_transform)
    center = vertices(ob.data).mean(0)
    body = [polygon for polygon in ob.data.polygons if abs(polygon.center.z - 0.4) < 0.2
            and np.hypot(*polygon.center.xy) > 0.9 and abs(polygon.center.x) < 0.5]
    assert body and all(np.dot(np.array(polygon.center) - center, polygon.normal) > 0 for polygon in body)


@pytest.mark.parametrize('name', KINDS)
def test_what_a_script_moved_as_a_whole_is_noticed_and_can_be_adopted(name):
    ob = add(VALUES[name]())
    for key, setting in TURNED.items():
        setattr(ob, key, setting)
    bpy.context.view_layer.update()
    before, matrix = world_points(ob), ob.matrix_world.copy()
    ob.data.transform(matrix)                   # by a script, whose object stays where it was
    assert shape.is_touched(ob.data)
    bpy.context.view_layer.update()
    assert op(bpy.ops.splinewright.adopt_transform) == {'FINISHED'}
    ob.matrix_world.identity()
    bpy.context.view_layer.update()
    assert not shape.is_touched(ob.data) and np.allclose(world_points(ob), before, atol=2e-4)
    require_exact(ob)


def test_what_was_not_moved_as_a_whole_is_not_adopted():
    ob = add(VALUES['nurbs patch']())
    with pytest.raises(RuntimeError, match="nothing to adopt"):
        bpy.ops.splinewright.adopt_transform()
    by_hand(ob)
    with pytest.raises(RuntimeError, match="not moved as a whole|were changed, too"):
        bpy.ops.splinewright.adopt_transform()


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs', 'hermite'))
@pytest.mark.parametrize('scale', ((2, 2, 2), (1, -3, 0.5)))
def test_nets_of_parented_scaled_and_mirrored_shapes_lie_on_them(name, scale):
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.rotation_euler, parent.scale = (0.1, 0.5, 0.2), (1, 2, 3)
    ob = add(VALUES[name]())
    ob.parent, ob.scale, ob.location = parent, scale, (1, 2, 3)
    bpy.context.view_layer.update()
    held = enter()
    bpy.context.view_layer.update()
    assert np.allclose(held.matrix_world, ob.matrix_world, atol=1e-5)
    select(held, first_point(held))
    move(0, 0, 1)
    ob = leave()
    require_exact(ob)


def only(ob):
    for other in bpy.context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob


def applied(ob, **parts):
    """Blender's own Apply, and its own notice of it."""
    only(ob)
    bpy.ops.object.transform_apply(**{'location': True, 'rotation': True, 'scale': True, **parts})
    bpy.context.view_layer.update()


@pytest.mark.parametrize('name', KINDS)
def test_blenders_own_apply_takes_the_definition_along(name):
    ob = add(VALUES[name]())
    for key, setting in TURNED.items():
        setattr(ob, key, setting)
    bpy.context.view_layer.update()
    before = world_points(ob)
    applied(ob)
    assert np.allclose(ob.matrix_world, np.eye(4), atol=1e-6)
    assert not shape.is_touched(ob.data) and np.allclose(world_points(ob), before, atol=2e-4)
    require_exact(ob)


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs', 'teapot'))
def test_blenders_own_apply_takes_a_mirroring_along(name):
    """Newer versions of Blender turn the faces over then."""
    ob = add(VALUES[name]())
    ob.scale, ob.rotation_euler = (-1.5, 1.0, 0.5), (0.2, 0.0, 0.4)
    bpy.context.view_layer.update()
    before = world_points(ob)
    applied(ob)
    after = world_points(ob)
    assert np.allclose(ob.matrix_world, np.eye(4), atol=1e-6) and not shape.is_touched(ob.data)
    assert after.shape == before.shape and np.allclose(np.sort(after, 0), np.sort(before, 0), atol=1e-4)
    require_exact(ob)


def test_faces_that_were_turned_over_where_they_lie_are_no_map():
    ob = add(VALUES['nurbs patch']())
    ob.data.flip_normals()
    bpy.context.view_layer.update()
    assert shape.is_touched(ob.data)
    with pytest.raises(RuntimeError, match="not moved as a whole|faces or splines were changed"):
        op(bpy.ops.splinewright.adopt_transform)


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs', 'teapot'))
def test_set_origin_takes_the_definition_along(name):
    ob = add(VALUES[name]())
    ob.location = 5.0, 3.0, 1.0
    bpy.context.view_layer.update()
    before = world_points(ob)
    only(ob)
    bpy.ops.object.origin_set(type='ORIGIN_CURSOR')
    bpy.context.view_layer.update()
    assert not shape.is_touched(ob.data) and np.allclose(world_points(ob), before, atol=2e-5)
    require_exact(ob)


def test_apply_on_a_recipe_keeps_the_numbers_that_can_say_it():
    assert op(bpy.ops.splinewright.add_circle, radius=2.0, resolution_u=24) == {'FINISHED'}
    ob = bpy.context.object
    ob.scale = 3.0, 3.0, 3.0
    bpy.context.view_layer.update()
    applied(ob)
    assert recipes.of(ob.data).kind == 'circle' and abs(recipes.parameters(ob.data)['radius'] - 6.0) < 1e-5
    ob.scale = 1.0, 2.0, 1.0
    bpy.context.view_layer.update()
    before = world_points(ob)
    applied(ob)
    assert not recipes.has(ob.data) and not shape.is_touched(ob.data)
    assert np.allclose(world_points(ob), before, atol=1e-5)
    require_exact(ob)


def test_apply_on_an_interpolating_spline_moves_its_points():
    assert op(bpy.ops.splinewright.add_interpolating) == {'FINISHED'}
    ob = bpy.context.object
    ob.location, ob.rotation_euler = (1, 2, 3), (0.1, 0.2, 0.3)
    bpy.context.view_layer.update()
    before, points, matrix = world_points(ob), recipes.points(ob.data), np.array(ob.matrix_world)
    applied(ob)
    assert np.allclose(recipes.points(ob.data), points @ matrix[:3, :3].T + matrix[:3, 3], atol=1e-5)
    assert np.allclose(world_points(ob), before, atol=1e-5)
