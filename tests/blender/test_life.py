"""What else befalls a shape: copies, files, transforms, joins, hands that change its mesh."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, enter, first_point, leave, move, require_exact, select, shown
from support import part, vertices

editing, net, shape, store = (part(name) for name in ('ui.editing', 'bridge.net.net', 'bridge.shape', 'bridge.store'))

KINDS = ('nurbs patch', 'teapot', 'mixed set', 'nurbs', 'hermite', 'many curves')


def op(operator, **settings):
    return operator('EXEC_DEFAULT', True, **settings)


def world_points(ob):
    bpy.context.view_layer.update()
    matrix = np.array(ob.matrix_world)
    return shown(ob) @ matrix[:3, :3].T + matrix[:3, 3]


# Changed by hand -----------------------------------------------------------------------------------


def by_hand(ob):
    """Edit the result in its own Edit Mode."""
    bpy.ops.object.mode_set(mode='EDIT')
    if ob.type == 'MESH':
        bpy.ops.mesh.select_all(action='SELECT')
        bpy.ops.transform.resize(value=(1, 1, 3), orient_type='GLOBAL')
        bpy.ops.mesh.subdivide()
    else:
        bpy.ops.curve.select_all(action='SELECT')
        bpy.ops.curve.subdivide()
    bpy.ops.object.mode_set(mode='OBJECT')


@pytest.mark.parametrize('name', KINDS)
def test_a_result_changed_by_hand_is_noticed_and_never_overwritten(name):
    value = VALUES[name]()
    ob = add(value)
    assert not shape.is_touched(ob.data)
    by_hand(ob)
    assert shape.is_touched(ob.data) and ob.data.splinewright.value == value
    changed = shown(ob).copy()
    ob.data.splinewright.resolution_u = 7
    assert "changed by hand" in ob.data.splinewright.problem and np.array_equal(shown(ob), changed)
    with pytest.raises(RuntimeError, match="changed by hand"):
        bpy.ops.splinewright.edit_net()
    with pytest.raises(ValueError, match="changed by hand"):
        ob.data.splinewright.value = value
    assert np.array_equal(shown(ob), changed) and not list(editing.nets())


@pytest.mark.parametrize('name', KINDS)
def test_restore_brings_the_definition_back_and_undo_the_changes(name):
    value = VALUES[name]()
    ob = add(value)
    by_hand(ob)
    bpy.ops.ed.undo_push(message="by hand")
    changed = shown(ob).copy()
    assert op(bpy.ops.splinewright.restore) == {'FINISHED'}
    require_exact(ob)
    assert not shape.is_touched(ob.data) and ob.data.splinewright.value == value
    bpy.ops.ed.undo()
    ob = bpy.data.objects["shape"]
    assert np.array_equal(shown(ob), changed) and shape.is_touched(ob.data)


@pytest.mark.parametrize('name', KINDS)
def test_detach_leaves_what_is_shown_and_no_definition(name):
    ob = add(VALUES[name]())
    before = shown(ob).copy()
    assert op(bpy.ops.splinewright.detach) == {'FINISHED'}
    assert np.array_equal(shown(ob), before) and ob.data.splinewright.value is None
    assert not bpy.ops.splinewright.edit_net.poll()
    bpy.ops.ed.undo()
    require_exact(bpy.data.objects["shape"])


def applied_modifier(ob):
    ob.modifiers.new("wave", 'DISPLACE')
    bpy.ops.object.modifier_apply(modifier="wave")


def remeshed(ob):
    ob.data.remesh_voxel_size = 0.1
    bpy.ops.object.voxel_remesh()


def sculpted(ob):
    bpy.ops.object.mode_set(mode='SCULPT')
    bpy.ops.object.mode_set(mode='OBJECT')
    ob.data.vertices[3].co.z += 0.1


@pytest.mark.parametrize('harm', (applied_modifier, remeshed, sculpted))
def test_meshes_that_others_remade_are_noticed(harm):
    value = VALUES['nurbs patch']()
    ob = add(value)
    harm(ob)
    assert shape.is_touched(ob.data) and ob.data.splinewright.value == value
    op(bpy.ops.splinewright.restore)
    require_exact(ob)


def test_separating_in_edit_mode_leaves_two_meshes_that_are_noticed():
    value = VALUES['teapot']()
    add(value)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.separate(type='LOOSE')
    bpy.ops.object.mode_set(mode='OBJECT')
    parts = [ob for ob in bpy.data.objects if shape.has_shape(ob)]
    assert len(parts) > 1 and all(shape.is_touched(ob.data) for ob in parts)


def test_changes_that_are_not_of_the_geometry_are_no_changes():
    ob = add(VALUES['nurbs patch']())
    ob.name, ob.data.name = "renamed", "renamed data"
    ob.data.materials.append(bpy.data.materials.new("red"))
    ob.vertex_groups.new(name="group")
    ob.location, ob.scale = (1, 2, 3), (1, -1, 2)
    ob.modifiers.new("subsurf", 'SUBSURF')
    bpy.context.view_layer.update()
    assert not shape.is_touched(ob.data)
    ob.data.splinewright.resolution_u = 3
    assert ob.data.splinewright.problem == "" and ob.data.materials[0].name == "red"
    require_exact(ob)


def test_a_shape_with_shape_keys_is_left_alone_with_a_word():
    value = VALUES['nurbs patch']()
    ob = add(value)
    ob.shape_key_add(name="Basis")
    ob.data.splinewright.resolution_u = 3
    assert "shape keys" in ob.data.splinewright.problem and ob.data.splinewright.value == value
    ob.shape_key_clear()
    ob.data.splinewright.resolution_u = 5
    require_exact(ob)


# Transforms ----------------------------------------------------------------------------------------


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
    centre = vertices(ob.data).mean(0)
    body = [polygon for polygon in ob.data.polygons if abs(polygon.center.z - 0.4) < 0.2
            and np.hypot(*polygon.center.xy) > 0.9 and abs(polygon.center.x) < 0.5]
    assert body and all(np.dot(np.array(polygon.center) - centre, polygon.normal) > 0 for polygon in body)


@pytest.mark.parametrize('name', KINDS)
def test_blenders_own_apply_is_noticed_and_can_be_adopted(name):
    ob = add(VALUES[name]())
    for key, setting in TURNED.items():
        setattr(ob, key, setting)
    before = world_points(ob)
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    assert shape.is_touched(ob.data) and np.allclose(world_points(ob), before, atol=1e-4)
    assert op(bpy.ops.splinewright.adopt_transform) == {'FINISHED'}
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


# Joining -------------------------------------------------------------------------------------------


@pytest.mark.parametrize('names', (('nurbs patch', 'teapot', 'hermite patch'), ('nurbs', 'hermite', 'many curves')))
def test_joined_shapes_are_one_shape_of_all_pieces_where_they_stood(names):
    obs = [add(VALUES[name](), name) for name in names]
    for i, ob in enumerate(obs):
        ob.location.x, ob.rotation_euler.z, ob.scale.z = 3 * i, i, 1 - 3 * (i == 1)
    pieces = sum(len(store.read(ob.data).pieces) for ob in obs)
    points = np.concatenate([world_points(ob) for ob in obs])
    activate(*obs)
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    assert bpy.context.object == obs[0] and len(bpy.data.objects) == 1
    ob = obs[0]
    assert len(store.read(ob.data).pieces) == pieces
    assert np.allclose(np.sort(world_points(ob), 0), np.sort(points, 0), atol=1e-4)
    require_exact(ob)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def test_joining_is_undone():
    for name in ('nurbs patch', 'teapot'):
        add(VALUES[name](), name)
    activate(*bpy.data.objects)
    op(bpy.ops.splinewright.join)
    bpy.ops.ed.undo()
    assert {ob.name for ob in bpy.data.objects} == {'nurbs patch', 'teapot'}
    for ob in bpy.data.objects:
        require_exact(ob)


def test_blenders_own_join_is_noticed():
    first, second = add(VALUES['nurbs patch'](), "a"), add(VALUES['teapot'](), "b")
    value = first.data.splinewright.value
    activate(first, second)
    bpy.ops.object.join()
    assert shape.is_touched(first.data) and first.data.splinewright.value == value


def test_join_refuses_what_is_no_shape_or_of_another_kind():
    first, second = add(VALUES['nurbs patch'](), "a"), add(VALUES['nurbs'](), "b")
    activate(first, second)
    assert not bpy.ops.splinewright.join.poll()
    activate(first)
    assert not bpy.ops.splinewright.join.poll()


# Copies --------------------------------------------------------------------------------------------


@pytest.mark.parametrize('name', KINDS)
def test_a_duplicate_is_a_shape_of_its_own_and_a_linked_one_the_same(name):
    value = VALUES[name]()
    ob = add(value)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True)
    copy = bpy.context.object
    assert copy.data != ob.data and copy.data.splinewright.value == value
    held = enter()
    assert net.shape_of(held) == copy
    select(held, first_point(held))
    move(0, 0, 1)
    leave()
    assert ob.data.splinewright.value == value != copy.data.splinewright.value
    require_exact(ob), require_exact(copy)
    activate(ob)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True, linked=True)
    twin = bpy.context.object
    assert twin.data == ob.data
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    leave()
    assert ob.data.splinewright.value == twin.data.splinewright.value != value
    activate(twin)
    bpy.ops.object.make_single_user('EXEC_DEFAULT', True, object=True, obdata=True)
    assert twin.data != ob.data and twin.data.splinewright.value == ob.data.splinewright.value
    require_exact(ob), require_exact(twin)


def test_two_linked_duplicates_in_edit_have_one_net():
    ob = add(VALUES['nurbs patch']())
    bpy.ops.object.duplicate('EXEC_DEFAULT', True, linked=True)
    ob.select_set(True)
    enter()
    assert len(list(editing.nets())) == 1
    leave()


def test_convert_to_mesh_of_a_mesh_stays_a_shape_and_of_a_curve_is_a_plain_mesh():
    ob = add(VALUES['nurbs patch']())
    bpy.ops.object.convert(target='MESH')
    require_exact(bpy.context.object)
    add(VALUES['nurbs'](), "curve")
    bpy.ops.object.convert(target='MESH')
    ob = bpy.context.object
    assert ob.type == 'MESH' and not shape.has_shape(ob)


def test_deleting_the_shape_while_its_net_is_edited():
    add(VALUES['nurbs patch']())
    held = enter()
    bpy.data.objects.remove(bpy.data.objects["shape"])
    bpy.context.view_layer.update()
    assert net.shape_of(held) is None
    assert op(bpy.ops.splinewright.leave_net) == {'FINISHED'}
    assert not bpy.data.objects and bpy.context.mode == 'OBJECT'


def test_deleting_the_net_while_it_is_edited_loses_nothing():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    value = bpy.data.objects["shape"].data.splinewright.value
    bpy.data.objects.remove(bpy.context.object)
    bpy.context.view_layer.update()
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.value == value and not list(editing.nets())
    activate(ob)
    enter()
    require_exact(leave())


# Scenes, view layers, collections ------------------------------------------------------------------


def test_a_shape_in_two_scenes_is_edited_in_either():
    ob = add(VALUES['nurbs patch']())
    first, other = bpy.context.scene, bpy.data.scenes.new("other")
    other.collection.objects.link(ob)
    bpy.context.window.scene = other
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    held = enter()
    assert held.name in other.objects and held.name not in first.objects
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def test_the_net_is_put_out_where_the_active_collection_is_excluded_or_hidden():
    ob = add(VALUES['nurbs patch']())
    collection = bpy.data.collections.new("hidden")
    bpy.context.scene.collection.children.link(collection)
    layer = bpy.context.view_layer.layer_collection.children["hidden"]
    bpy.context.view_layer.active_layer_collection = layer
    for name in ('exclude', 'hide_viewport'):
        setattr(layer, name, True)
        activate(ob)
        enter()
        require_exact(leave())
        setattr(layer, name, False)


def test_a_shape_whose_collection_is_excluded_while_its_net_is_edited():
    ob = add(VALUES['nurbs patch']())
    collection = bpy.data.collections.new("own")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(ob)
    bpy.context.scene.collection.objects.unlink(ob)
    activate(ob)
    held = enter()
    bpy.context.view_layer.layer_collection.children["own"].exclude = True
    select(held, first_point(held))
    move(0, 0, 1)
    bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    assert not list(editing.nets())
    require_exact(bpy.data.objects["shape"])


def test_a_shape_is_edited_in_a_view_layer_that_has_it_and_left_alone_in_one_that_has_not():
    ob = add(VALUES['nurbs patch']())
    collection = bpy.data.collections.new("own")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(ob)
    bpy.context.scene.collection.objects.unlink(ob)
    first = bpy.context.view_layer
    other = bpy.context.scene.view_layers.new("other")
    other.layer_collection.children["own"].exclude = True
    bpy.context.window.view_layer = other
    bpy.context.view_layer.update()
    assert not bpy.ops.splinewright.edit_net.poll()
    bpy.context.window.view_layer = first
    activate(ob)
    held = enter()
    bpy.context.window.view_layer = other
    bpy.context.view_layer.update()
    bpy.context.window.view_layer = first
    assert held.mode == 'EDIT'
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def test_a_shape_that_moves_while_its_net_is_edited_takes_the_net_along():
    ob = add(VALUES['nurbs patch']())
    for frame, place in ((1, 0.0), (11, 5.0)):
        ob.location.x = place
        ob.keyframe_insert('location', frame=frame)
    bpy.context.scene.frame_set(1)
    held = enter()
    bpy.context.scene.frame_set(11)
    assert np.allclose(held.matrix_world.translation.x, 5)
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


# What others do while a net is out -------------------------------------------------------------------


def test_a_follower_of_a_shape_follows_its_net_at_every_move():
    ob = add(VALUES['nurbs patch'](), "a")
    bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True)
    follower = bpy.context.object
    activate(ob)
    held = enter()
    select(held, first_point(held))
    for _ in range(2):
        move(0, 0, 1)
        assert follower.data.splinewright.value == ob.data.splinewright.value
        require_exact(follower)
    leave()


def test_a_mesh_changed_by_hand_while_its_net_is_out_is_not_overwritten():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    ob.data.vertices[7].co.z += 5
    changed = vertices(ob.data).copy()
    move(0, 0, 0.5)
    assert "changed by hand" in part('bridge.net.live').problem(held) and np.array_equal(vertices(ob.data), changed)
    leave()
    assert shape.is_touched(ob.data) and np.array_equal(vertices(ob.data), changed)


def test_a_value_given_while_the_net_is_out_is_not_lost():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 0.5)
    value = VALUES['bezier patch']()
    ob.data.splinewright.value = value
    move(0, 0, 0.5)
    assert "another definition" in part('bridge.net.live').problem(held)
    leave()
    assert ob.data.splinewright.value == value
    require_exact(ob)


@pytest.mark.parametrize('everything', (False, True))
def test_parts_separated_from_a_net_are_no_nets_and_revert_nothing(everything):
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, *(range(24) if everything else (0, 1)))
    bpy.ops.mesh.separate('EXEC_DEFAULT', True, type='SELECTED')
    leave()
    assert [ob.name for ob in bpy.data.objects] == ["shape"]
    held = enter()
    select(held, 3)
    move(0, 0, 1)
    leave()
    value = bpy.data.objects["shape"].data.splinewright.value
    editing.sweep()
    assert bpy.data.objects["shape"].data.splinewright.value == value


@pytest.mark.parametrize('mode', ('SCULPT', 'VERTEX_PAINT', 'WEIGHT_PAINT'))
def test_a_net_taken_into_another_mode_is_swept_and_undo_survives(mode):
    add(VALUES['bezier patch']())
    held = enter()
    select(held, 0)
    move(0, 0, 0.5)
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode=mode)
    editing.sweep()
    assert bpy.context.mode == 'OBJECT' and not list(editing.nets())
    for _ in range(3):
        bpy.ops.ed.undo()
        editing.sweep()
        require_exact(bpy.data.objects["shape"])


def test_a_material_stays_on_its_patch_when_the_resolution_changes():
    ob = add(VALUES['mixed set']())
    for name in ("red", "blue"):
        ob.data.materials.append(bpy.data.materials.new(name))
    patches = np.empty(len(ob.data.polygons), np.int32)
    ob.data.attributes["patch"].data.foreach_get('value', patches)
    ob.data.polygons.foreach_set('material_index', (patches == 1).astype(np.int32))
    ob.data.splinewright.resolution_u = 7
    patches = np.empty(len(ob.data.polygons), np.int32)
    ob.data.attributes["patch"].data.foreach_get('value', patches)
    indices = np.empty(len(ob.data.polygons), np.int32)
    ob.data.polygons.foreach_get('material_index', indices)
    assert set(patches) == {0, 1} and np.array_equal(indices, patches == 1)
