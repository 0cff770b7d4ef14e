"""Instances of collections that hold constructions: they show them as they are now, and overlays know where they are."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from shapes import activate, add, enter, leave, op
from support import part, splinecore as sc
from test_files import reopen, save

follow, images, overlay = (part(name) for name in ('bridge.follow.follow', 'bridge.shape.images', 'ui.analysis_overlay'))
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def loft_in_a_collection(name="Parts"):
    rings = []
    for i in range(3):
        rings.append(add(CIRCLE, f"{name} ring {i}"))
        rings[-1].location.z = i
    activate(*rings)
    assert op(bpy.ops.splinewright.add_loft) == {'FINISHED'}
    ob = bpy.context.object
    collection = bpy.data.collections.new(name)
    bpy.context.scene.collection.children.link(collection)
    for each in (ob, *rings):
        for old in each.users_collection:
            old.objects.unlink(each)
        collection.objects.link(each)
    bpy.context.view_layer.update()
    return collection, ob, rings


def instance(collection, place=(10, 0, 0)):
    bpy.ops.object.select_all(action='DESELECT')
    assert op(bpy.ops.object.collection_instance_add, collection=collection.name, location=place) == {'FINISHED'}
    return bpy.context.object


def seen(holder, ob):
    """Of each instance of an object by a holder: (where it is, its vertices in the world)."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    found = []
    for one in depsgraph.object_instances:
        if one.is_instance and one.object.original == ob and one.parent.original == holder:
            matrix = np.array(one.matrix_world)
            mesh = one.object.data
            flat = np.empty(3 * len(mesh.vertices), np.float32)
            mesh.vertices.foreach_get('co', flat)
            found.append((matrix, flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]))
    return found


def own(ob):
    flat = np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.vertices.foreach_get('co', flat)
    matrix = np.array(ob.matrix_world)
    return flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


@pytest.mark.parametrize('is_excluded', (False, True))
def test_edits_of_inputs_and_moves_are_seen(is_excluded):
    collection, ob, rings = loft_in_a_collection()
    holder = instance(collection)
    bpy.context.view_layer.layer_collection.children[collection.name].exclude = is_excluded
    bpy.context.view_layer.update()
    (_, before), = seen(holder, ob)
    assert np.abs(before - own(ob) - (10, 0, 0)).max() < 1e-5
    rings[1].scale = (2, 2, 2)
    rings[2].location.z = 5
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert follow.problem(ob.data) == ""
    (_, after), = seen(holder, ob)
    assert np.ptp(after[:, 2]) == pytest.approx(5.0) and np.ptp(after[:, 0]) > 3.5
    holder.location, holder.rotation_euler = (0, -3, 1), (0, 0, 1.0)
    bpy.context.view_layer.update()
    (_, moved), = seen(holder, ob)
    turn = np.array(Matrix.Rotation(1.0, 3, 'Z'))
    assert np.abs(moved - (own(ob) @ turn.T + (0, -3, 1))).max() < 1e-5


def test_a_net_is_edited_and_instances_take_it_up():
    collection, ob, rings = loft_in_a_collection()
    holder = instance(collection)
    activate(rings[1])
    enter()
    held = bpy.context.object
    for point in held.data.splines[0].points:
        point.co.x *= 3
    held.data.update_tag()
    bpy.context.view_layer.update()
    leave()
    bpy.context.view_layer.update()
    (_, after), = seen(holder, ob)
    assert np.ptp(after[:, 0]) > 4.0


def test_a_file_with_instances_alone_in_the_scene_follows(tmp_path):
    collection, ob, rings = loft_in_a_collection()
    name, ring = ob.name, rings[1].name
    holder = instance(collection).name
    bpy.context.scene.collection.children.unlink(collection)
    save(tmp_path / "instances.blend")
    reopen(tmp_path / "instances.blend")
    bpy.data.objects[ring].location.x = 4.0
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    (_, after), = seen(bpy.data.objects[holder], bpy.data.objects[name])
    assert np.ptp(after[:, 0]) > 4.0 and follow.problem(bpy.data.objects[name].data) == ""


def test_overlays_know_where_instances_are():
    collection, ob, rings = loft_in_a_collection()
    collection.instance_offset = (0, 0, 1)
    first, second = instance(collection), instance(collection, (0, 7, 0))
    outer = bpy.data.collections.new("Outer")
    bpy.context.scene.collection.children.link(outer)
    bpy.context.scene.collection.objects.unlink(second)
    outer.objects.link(second)
    third = instance(outer, (0, 0, -20))
    bpy.context.view_layer.update()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    wanted = [np.array(one.matrix_world) for one in depsgraph.object_instances if one.object.original == ob]
    found = [np.array(matrix) for matrix in images.of(ob, bpy.context.view_layer)]
    assert len(found) == len(wanted) == 4
    for matrix in wanted:
        assert min(np.abs(matrix - other).max() for other in found) < 1e-5
    activate(third)
    assert overlay.active_shapes(bpy.context) == [] and set(overlay.shapes_seen(bpy.context)) == {ob, *rings}
    bpy.context.view_layer.layer_collection.children[collection.name].exclude = True
    first.hide_set(True)
    bpy.context.view_layer.update()
    assert len(images.of(ob, bpy.context.view_layer)) == 2

