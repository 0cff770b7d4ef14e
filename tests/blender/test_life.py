"""What else befalls a shape: hands that change its mesh, joins, copies, scenes and collections."""

import bpy
import numpy as np
import pytest

from shapes import (KINDS, VALUES, activate, add, by_hand, enter, first_point, leave, move, op, require_exact, select,
                    shown, world_points)
from support import part

editing, net_object, shape, store = (part(name) for name in ('ui.editing', 'bridge.cage.net_object', 'bridge.shape.shape', 'bridge.data.store'))


# Changed by hand -----------------------------------------------------------------------------------


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


def test_corners_that_go_from_one_face_to_its_neighbor_are_noticed():
    mesh = add(VALUES['nurbs patch'](), "shape").data
    starts, totals = (np.empty(len(mesh.polygons), np.int32) for _ in range(2))
    mesh.polygons.foreach_get('loop_start', starts)
    mesh.polygons.foreach_get('loop_total', totals)
    assert totals[0] == totals[1] == 4
    starts[1], totals[:2] = 3, (3, 5)
    mesh.polygons.foreach_set('loop_start', starts)
    if bpy.app.version < (4, 1):
        mesh.polygons.foreach_set('loop_total', totals)
    assert shape.is_touched(mesh)


def test_a_stamp_of_an_older_file_that_lacks_where_faces_start_is_of_what_it_counts():
    mesh = add(VALUES['nurbs patch'](), "shape").data
    store.write_stamp(mesh, store.read_stamp(mesh)[:5])
    assert not shape.is_touched(mesh) and shape.faces_of(mesh) is not None
    mesh.vertices[0].co.x += 1.0
    assert shape.is_touched(mesh)


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


@pytest.mark.parametrize('edit', (
    lambda points: points * (1, 1, -1), lambda points: points * (-1, -1, 1), lambda points: points[::-1],
    lambda points: points * 2, lambda points: points[:, [1, 0, 2]]))
@pytest.mark.parametrize('pair', ((5, 7), (20, 22), (33, 34), (0, -1)))
def test_two_vertices_that_are_mirrored_or_change_places_are_a_change_by_hand(pair, edit):
    ob, pair = add(VALUES['nurbs patch']()), list(pair)
    there = shown(ob).copy()
    there[pair] = edit(there[pair])
    ob.data.vertices.foreach_set('co', np.ascontiguousarray(there, np.float32).ravel())
    ob.data.update()
    assert shape.is_touched(ob.data)
    changed = shown(ob).copy()
    ob.data.splinewright.resolution_u = 7
    assert "changed by hand" in ob.data.splinewright.problem and np.array_equal(shown(ob), changed)


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
    assert net_object.shape_of(held) == copy
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
    assert net_object.shape_of(held) is None
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


def colored(name, shape_name, color):
    ob = add(VALUES[shape_name](), name)
    ob.data.materials.append(bpy.data.materials.get(color) or bpy.data.materials.new(color))
    return ob


def test_joined_patches_keep_their_materials_and_joined_curves_their_radius():
    obs = [colored("a", 'nurbs patch', "red"), colored("b", 'teapot', "blue"), colored("c", 'bezier patch', "red")]
    activate(*obs)
    op(bpy.ops.splinewright.join)
    data = bpy.context.object.data
    assert [material.name for material in data.materials] == ["red", "blue"]
    patches, indices = np.empty((2, len(data.polygons)), np.int32)
    data.attributes["patch"].data.foreach_get('value', patches)
    data.polygons.foreach_get('material_index', indices)
    assert np.array_equal(indices, ((patches > 0) & (patches < 33)).astype(int))
    curves = [colored("d", 'nurbs', "red"), colored("e", 'quintic', "blue")]
    for radius, ob in zip((2.0, 3.0), curves):
        for point in ob.data.splines[0].points:
            point.radius = radius
    activate(*curves)
    op(bpy.ops.splinewright.join)
    splines = bpy.context.object.data.splines
    assert [(s.points[0].radius, s.material_index) for s in splines] == [(2.0, 0), (3.0, 1)]


def test_a_users_uvs_and_shading_stay_while_the_faces_do():
    ob = add(VALUES['nurbs patch']())
    layer = ob.data.uv_layers[0].data
    layer[0].uv = (7, 7)
    ob.data.polygons[0].use_smooth = False
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    leave()
    assert tuple(ob.data.uv_layers[0].data[0].uv) == (7, 7) and not ob.data.polygons[0].use_smooth


def test_one_selected_shape_changed_by_hand_keeps_no_other_from_being_edited():
    touched = add(VALUES['nurbs patch'](), "touched")
    by_hand(touched)
    ob = add(VALUES['nurbs patch'](), "whole")
    touched.select_set(True)
    held = enter()
    assert net_object.shape_of(held) == ob and len(bpy.context.objects_in_mode) == 1
    leave()
