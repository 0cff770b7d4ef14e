"""Convert to Splinewright and To Blender's Own: another kind of object in the same place, and all that hangs on it stays."""

import bpy
import numpy as np
import pytest

from geometry import farthest, mesh_points, signed_volume
from natives import CURVES, SURFACES, all_natives, drawn, exact, material, native, native_curve, native_surface
from support import corner_normals, part

animation = part('bridge.data.animation')
make_exact = part('bridge.native.make_exact')
to_native = part('bridge.native.to_native')
read_native = part('bridge.native.read_native')


@pytest.mark.parametrize('name', CURVES)
def test_a_curve_becomes_a_shape_in_its_place_and_is_drawn_as_before(name):
    ob = native_curve(name)
    before, data, value = mesh_points(drawn(ob)), ob.data, read_native.read(ob).value
    exact(ob)
    assert len(bpy.data.curves) == 1, "nothing is left behind"
    assert ob.data == data and ob.type == 'CURVE' and data.splinewright.value == value
    assert all(spline.type == 'POLY' for spline in data.splines)
    after = mesh_points(drawn(ob))
    closed = data.splines[0].use_cyclic_u
    assert farthest(before, np.concatenate([after, after[:1]]) if closed else after) < 0.01
    assert len(before) / 2 <= len(after) <= 2 * len(before)


@pytest.mark.parametrize('name', SURFACES)
def test_a_surface_becomes_a_mesh_shape_and_stays_the_same_object(name):
    ob = native_surface(name)
    before, value, pointer = drawn(ob), read_native.read(ob).value, ob.as_pointer()
    exact(ob)
    assert ob.as_pointer() == pointer and ob.type == 'MESH' and ob.data.splinewright.value == value
    assert bpy.context.object == ob and ob.select_get()
    assert not bpy.data.curves and len(bpy.data.objects) == 1, "nothing is left behind"
    after = drawn(ob)
    assert signed_volume(after) == pytest.approx(signed_volume(before), rel=0.05)
    assert len(before.polygons) / 2 <= len(after.polygons) <= 2 * len(before.polygons)
    assert max(np.linalg.norm(mesh_points(after) - point, axis=1).min() for point in mesh_points(before)) < 0.15


def test_several_objects_are_done_at_once_and_all_have_values():
    objects = all_natives()
    exact(*objects)
    assert all(ob.data.splinewright.value is not None for ob in objects)
    assert not any(part('bridge.shape.shape').is_touched(ob.data) for ob in objects)
    assert {ob.type for ob in objects} == {'CURVE', 'MESH'} and len(bpy.context.selected_objects) == len(objects)
    native(*objects)
    assert {ob.type for ob in objects} == {'CURVE', 'SURFACE'} and not bpy.data.meshes
    assert all('splinewright_definition' not in ob.data.keys() for ob in objects)


def furnish(ob):
    """Give an object a place, a parent, a child, a follower, collections, slots, modifiers and a driver."""
    scene = bpy.context.scene
    parent, child, follower = (bpy.data.objects.new(name, None) for name in ("parent", "child", "follower"))
    for other in (parent, child, follower):
        scene.collection.objects.link(other)
    ob.parent, child.parent = parent, ob
    ob.location, ob.rotation_euler, ob.scale = (1, 2, 3), (0.1, 0.2, 0.3), (1, 2, 0.5)
    follower.constraints.new('COPY_LOCATION').target = ob
    collection = bpy.data.collections.new("extra")
    scene.collection.children.link(collection)
    collection.objects.link(ob)
    for name in "ab":
        ob.data.materials.append(material(name))
    ob.material_slots[1].link = 'OBJECT'
    ob.material_slots[1].material = material("own")
    ob.modifiers.new("Array", 'ARRAY').count = 3
    ob.modifiers.new("Smooth", 'SMOOTH').factor = 0.25
    ob.modifiers["Array"].show_viewport = False
    ob.driver_add('modifiers["Smooth"].iterations').driver.expression = "2 + 2"
    ob.keyframe_insert('location', frame=1)
    ob["mine"] = 7


def furniture(ob):
    bpy.context.view_layer.update()
    return {
        'parent': ob.parent.name, 'children': [child.name for child in ob.children],
        'target': bpy.data.objects["follower"].constraints[0].target == ob,
        'place': [tuple(row) for row in ob.matrix_world], 'collections': sorted(c.name for c in ob.users_collection),
        'slots': [(slot.link, slot.material.name) for slot in ob.material_slots],
        'modifiers': [(m.name, m.type, m.show_viewport) for m in ob.modifiers],
        'settings': (ob.modifiers["Array"].count, ob.modifiers["Smooth"].factor, ob.modifiers["Smooth"].iterations),
        'drivers': [driver.data_path for driver in ob.animation_data.drivers], 'action': ob.animation_data.action.name,
        'mine': ob["mine"], 'name': ob.name, 'pointer': ob.as_pointer()}


@pytest.mark.parametrize('make', (native_curve, native_surface), ids=('curve', 'surface'))
def test_all_that_hangs_on_an_object_stays_there_and_back(make):
    ob = make()
    furnish(ob)
    before = furniture(ob)
    assert before['settings'] == (3, 0.25, 4)
    exact(ob)
    assert furniture(ob) == before
    native(ob)
    assert ob.type in ('CURVE', 'SURFACE') and furniture(ob) == before


def test_hidden_objects_and_those_of_other_scenes_that_share_a_surface_are_changed_with_it():
    ob = native_surface()
    elsewhere, hidden, excluded, loose = (bpy.data.objects.new(name, ob.data) for name in "abcd")
    bpy.data.scenes.new("other").collection.objects.link(elsewhere)
    bpy.context.scene.collection.objects.link(hidden)
    hidden.hide_viewport = True
    collection = bpy.data.collections.new("excluded")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(excluded)
    bpy.context.view_layer.layer_collection.children["excluded"].exclude = True
    users = (ob, elsewhere, hidden, excluded, loose)
    homes = [[collection.name for collection in user.users_collection] for user in users]
    exact(ob)
    assert all(user.type == 'MESH' and user.data == ob.data for user in users) and not bpy.data.curves
    assert [[collection.name for collection in user.users_collection] for user in users] == homes
    assert hidden.hide_viewport and not ob.hide_viewport
    native(ob)
    assert all(user.type == 'SURFACE' and user.data == ob.data for user in users) and not bpy.data.meshes


def test_linked_duplicates_of_a_curve_are_changed_once_and_together():
    ob = native_curve()
    twin = bpy.data.objects.new("twin", ob.data)
    bpy.context.collection.objects.link(twin)
    exact(ob, twin)
    assert twin.data == ob.data and ob.data.splinewright.value is not None


def test_a_curve_keeps_its_bevel_taper_and_extrusion():
    taper = native_curve()
    ob = native_curve('primitive_bezier_circle_add')
    ob.data.bevel_depth, ob.data.extrude, ob.data.taper_object = 0.1, 0.2, taper
    exact(ob)
    assert (round(ob.data.bevel_depth, 6), round(ob.data.extrude, 6), ob.data.taper_object) == (0.1, 0.2, taper)


@pytest.mark.parametrize('fill', ('NONE', 'FRONT', 'BACK', 'BOTH'))
def test_a_flat_curve_stays_filled_and_one_that_is_not_flat_is_told(fill):
    flat = native_curve('primitive_bezier_circle_add')
    flat.data.dimensions, flat.data.fill_mode = '2D', fill
    faces = len(drawn(flat).polygons)
    assert make_exact.make_exact(bpy.context, flat).dropped == []
    assert (flat.data.dimensions, flat.data.fill_mode) == ('2D', fill)
    assert bool(faces) == bool(len(drawn(flat).polygons)) == (fill != 'NONE')
    assert not part('bridge.shape.shape').is_touched(flat.data)
    bent = native_curve('primitive_bezier_circle_add')
    bent.data.dimensions = '2D'
    points = bent.data.splines[0].bezier_points
    points.foreach_set('co', np.array([(p.co.x, p.co.y, 1) for p in points], np.float32).ravel())
    assert make_exact.make_exact(bpy.context, bent).dropped == ["the fill of a curve that is not flat"]
    assert bent.data.dimensions == '3D'


def several_splines():
    data = bpy.data.curves.new("several", 'CURVE')
    data.dimensions = '3D'
    for name in "abc":
        data.materials.append(material(name))
    for i, kind in enumerate(('BEZIER', 'NURBS', 'POLY', 'POLY')):
        spline = data.splines.new(kind)
        points = spline.bezier_points if kind == 'BEZIER' else spline.points
        points.add(0 if i == 2 else 4)
        for j, point in enumerate(points):
            point.co = (j, j % 2, i) if kind == 'BEZIER' else (j, j % 2, i, 1)
        spline.material_index, spline.use_smooth = i % 3, i != 3
    ob = bpy.data.objects.new("several", data)
    bpy.context.collection.objects.link(ob)
    return ob


def test_materials_and_shading_of_splines_are_kept_there_and_back():
    ob = several_splines()
    outcome = make_exact.make_exact(bpy.context, ob)
    assert outcome.dropped == ["spline 3, which is a single point"] and outcome.deviation < 1e-5
    assert [(s.material_index, s.use_smooth) for s in ob.data.splines] == [(0, True), (1, True), (0, False)]
    to_native.to_native(bpy.context, ob)
    assert [(s.material_index, s.use_smooth) for s in ob.data.splines] == [(0, True), (1, True), (0, False)]


def test_faces_have_the_material_of_their_patch_there_and_back():
    ob = native_surface()
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.surface.primitive_nurbs_surface_sphere_add(location=(5, 0, 0))
    bpy.ops.object.mode_set(mode='OBJECT')
    for name in "abc":
        ob.data.materials.append(material(name))
    ob.data.splines[0].material_index, ob.data.splines[1].material_index = 2, 1
    middles = [spline.points[0].co.x for spline in ob.data.splines]
    exact(ob)
    of_first = {polygon.material_index for polygon in ob.data.polygons if (polygon.center.x > 3) == (middles[0] > 3)}
    of_second = {polygon.material_index for polygon in ob.data.polygons if (polygon.center.x > 3) == (middles[1] > 3)}
    assert (of_first, of_second) == ({2}, {1})
    native(ob)
    assert [spline.material_index for spline in ob.data.splines] == [2, 1]
    assert [m.name for m in ob.data.materials] == ["a", "b", "c"]


def test_uniform_radius_and_tilt_are_kept():
    ob = native_curve()
    for point in ob.data.splines[0].points:
        point.radius, point.tilt = 2, 0.5
    assert make_exact.make_exact(bpy.context, ob).dropped == []
    assert {(point.radius, point.tilt) for point in ob.data.splines[0].points} == {(2, 0.5)}


@pytest.mark.parametrize('make', (native_curve, native_surface), ids=('curve', 'surface'))
def test_shape_keys_are_read_as_drawn_then_dropped_with_a_word(make):
    ob = make()
    ob.shape_key_add(name="Basis")
    key = ob.shape_key_add(name="Up")
    for point in key.data:
        point.co.z += 2
    key.value = 0.5
    expected = mesh_points(drawn(ob))[:, 2].mean()
    outcome = make_exact.make_exact(bpy.context, ob)
    assert outcome.dropped == ["the shape keys"] and outcome.deviation < 1e-5
    assert ob.data.shape_keys is None and not bpy.data.shape_keys
    assert mesh_points(drawn(ob))[:, 2].mean() == pytest.approx(expected, abs=0.01) and expected > 0.9


def point_curves(data):
    return sorted(curve.data_path for holder in animation.holders(data.animation_data)
                  for curves in animation.curve_lists(holder) for curve in curves)


def test_animation_of_single_points_is_dropped_with_a_word_and_other_animation_stays():
    ob = native_curve()
    ob.data.splines[0].points[1].keyframe_insert('co', frame=1)
    ob.data.keyframe_insert('bevel_depth', frame=1)
    ob.data.splines[0].points[2].driver_add('co', 0).driver.expression = "3"
    copy = ob.data.copy()
    assert copy.animation_data.action == ob.data.animation_data.action
    outcome = make_exact.make_exact(bpy.context, ob)
    assert outcome.dropped == ["the animation of single points"]
    assert point_curves(ob.data) == ["bevel_depth"] and not ob.data.animation_data.drivers
    assert len(point_curves(copy)) == 5, "the other data-block keeps its own"


def test_strips_that_animate_single_points_lose_that_and_nothing_else():
    ob = native_curve()
    ob.data.splines[0].points[1].keyframe_insert('co', frame=1)
    ob.data.keyframe_insert('bevel_depth', frame=1)
    kept = ob.data.animation_data.action
    strip = ob.data.animation_data.nla_tracks.new().strips.new("strip", 1, kept)
    ob.data.animation_data.action = None
    kept.use_fake_user = True
    assert len(point_curves(ob.data)) == 5
    assert make_exact.make_exact(bpy.context, ob).dropped == ["the animation of single points"]
    assert point_curves(ob.data) == ["bevel_depth"] and strip.action != kept


def test_a_flat_shaded_surface_stays_flat_there_and_back_and_at_any_resolution():
    ob = native_surface()
    ob.data.splines[0].use_smooth = False
    exact(ob)
    for _ in range(2):
        assert not any(polygon.use_smooth for polygon in ob.data.polygons)
        normals, counts = corner_normals(ob.data), [polygon.loop_total for polygon in ob.data.polygons]
        assert np.allclose(normals, np.repeat([polygon.normal for polygon in ob.data.polygons], counts, 0), atol=1e-3)
        ob.data.splinewright.resolution_u = 3
    native(ob)
    assert not ob.data.splines[0].use_smooth


def test_hooks_and_vertex_parents_are_named_because_their_points_are_others_now():
    for ob in (native_curve(), native_surface()):
        ob.modifiers.new("Hook", 'HOOK').vertex_indices_set([0, 1])
        child = bpy.data.objects.new(f"child {ob.type}", None)
        bpy.context.collection.objects.link(child)
        child.parent, child.parent_type, name = ob, 'VERTEX', child.name
        is_curve = ob.type == 'CURVE'
        assert make_exact.make_exact(bpy.context, ob).dropped == [
            f"the points that {name} is parented to", "the points of the modifier Hook" if is_curve else "the modifier Hook"]
        assert ("Hook" in ob.modifiers) == is_curve and child.parent == ob


def test_what_a_surface_cannot_have_is_dropped_with_a_word():
    bpy.ops.splinewright.add_bezier_patch()
    ob = bpy.context.object
    ob.vertex_groups.new(name="group")
    ob.modifiers.new("Mask", 'MASK')
    ob.modifiers.new("Array", 'ARRAY')
    outcome, notes = to_native.to_native(bpy.context, ob)
    assert outcome.dropped == ["the vertex groups", "the modifier Mask"] and notes == []
    assert [modifier.name for modifier in ob.modifiers] == ["Array"] and outcome.deviation < 1e-6


@pytest.mark.parametrize('add', ('add_bezier_curve', 'add_hermite_curve', 'add_nurbs_curve', 'add_bezier_patch',
                                 'add_hermite_patch', 'add_nurbs_patch', 'add_teapot'))
def test_every_kind_of_shape_becomes_blenders_own_and_comes_back_as_the_same_shape(add):
    getattr(bpy.ops.splinewright, add)()
    ob = bpy.context.object
    ob.data.splinewright.mode = 'COUNT'
    before = drawn(ob)
    native(ob)
    assert ob.type in ('CURVE', 'SURFACE') and ob.data.splines[0].type in ('NURBS', 'BEZIER')
    theirs = drawn(ob)
    exact(ob)
    after = drawn(ob)
    for mesh in (theirs, after):
        assert np.allclose(mesh_points(mesh).min(0), mesh_points(before).min(0), atol=0.03)
        assert np.allclose(mesh_points(mesh).max(0), mesh_points(before).max(0), atol=0.03)
        if len(before.polygons):
            assert signed_volume(mesh) == pytest.approx(signed_volume(before), rel=0.02)
            assert len(before.polygons) / 2 <= len(mesh.polygons) <= 2 * len(before.polygons)
        else:
            assert len(before.vertices) / 2 <= len(mesh.vertices) <= 2 * len(before.vertices)


@pytest.mark.parametrize('degree, count, knots', ((3, 6, 'CLAMPED'), (2, 5, 'UNCLAMPED'), (4, 8, 'PERIODIC')))
def test_what_blender_has_comes_back_with_the_same_points_and_knots(degree, count, knots):
    bpy.ops.splinewright.add_nurbs_curve(degree=degree, count=count, knots=knots)
    ob = bpy.context.object
    before = ob.data.splinewright.value
    native(ob)
    exact(ob)
    after = ob.data.splinewright.value
    assert np.array_equal(after.points, before.points.astype(np.float32)) and after.periodic == before.periodic
    ours, theirs = ((value.knots - value.domain[0]) / np.ptp(value.domain) for value in (before, after))
    assert np.allclose(ours, theirs, atol=1e-12)


def text(body):
    bpy.ops.object.text_add()
    ob = bpy.context.object
    ob.data.body = body
    bpy.context.view_layer.update()
    return ob


def test_a_text_becomes_curves_in_its_place():
    ob = text("Oi")
    ob.location.x, pointer = 2.0, ob.as_pointer()
    with pytest.raises(RuntimeError, match="Convert to Splinewright turns a text into curves"):
        bpy.ops.splinewright.add_revolve()
    assert bpy.ops.splinewright.make_exact() == {'FINISHED'}
    assert ob.as_pointer() == pointer and ob.type == 'CURVE' and ob.location.x == 2.0 and ob.select_get()
    assert len(ob.data.splinewright.value) == 4, "O has two outlines, i has two"
    assert ob.data.dimensions == '2D'


def test_a_text_without_letters_stays_a_text():
    ob = text(" ")
    with pytest.raises(RuntimeError, match="no letters"):
        bpy.ops.splinewright.make_exact()
    assert ob.type == 'FONT' and ob.data.body == " "
