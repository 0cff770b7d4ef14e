"""Shapes that follow curves, surfaces and other shapes, live."""

import bpy
import numpy as np
import pytest

from animated import coverage, curves_of, in_cycles
from layouts import drawn
from shapes import activate, require_exact
from support import part, vertices

follow, updating, recipes, shape, starters, store = (part(name) for name in (
    'bridge.follow.follow', 'bridge.follow.updating', 'bridge.recipes.recipes', 'bridge.shape.shape', 'core.shape.starters',
    'bridge.data.store'))
FOLLOW, Result = part('core.recipes.table').FOLLOW, part('core.recipes.recipe').Result
key, state = part('bridge.data.file_state').key, part('bridge.data.file_state').state


def native_curve(kind='NURBS'):
    data = bpy.data.curves.new("source", 'CURVE')
    data.dimensions = '3D'
    spline = data.splines.new(kind)
    if kind == 'BEZIER':
        spline.bezier_points.add(2)
        for i, point in enumerate(spline.bezier_points):
            point.co, point.handle_left, point.handle_right = (i, 0, 0), (i - 0.3, 1, 0), (i + 0.3, -1, 0)
    else:
        spline.points.add(4)
        for i, point in enumerate(spline.points):
            point.co = (i, i % 2, 0, 1)
        spline.use_endpoint_u = True
    return linked("source", data)


def native_surface():
    bpy.ops.surface.primitive_nurbs_surface_torus_add()
    return bpy.context.object


def linked(name, data):
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    activate(ob)
    return ob


def follow_object(ob, **settings):
    activate(ob)
    assert bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


def stay_on_inputs(ob):
    activate(ob)
    assert bpy.ops.splinewright.set_moving('EXEC_DEFAULT', True, how='WITH_INPUTS') == {'FINISHED'}


def pool(ob):
    return store.read(ob.data).pool


@pytest.mark.parametrize('make', (native_curve, lambda: native_curve('BEZIER'), native_surface))
def test_a_follower_lies_on_what_it_follows(make):
    source = make()
    ob = follow_object(source)
    assert ob != source and follow.problem(ob.data) == ""
    require_exact(ob)
    source.location.z = 2
    bpy.context.view_layer.update()
    weighted = pool(ob)[:, 3] != 0
    assert np.allclose(pool(ob)[weighted, 2].mean(), 2, atol=0.3)
    require_exact(ob)


def test_both_transforms_count():
    source = native_curve()
    ob = follow_object(source)
    stay_on_inputs(ob)
    before = pool(ob).copy()
    ob.location, ob.rotation_euler, ob.scale = (1, 2, 3), (0.1, 0.2, 0.3), (-1, 2, 0.5)
    bpy.context.view_layer.update()
    world = np.array(ob.matrix_world)
    assert np.allclose(np.c_[pool(ob)[:, :3], np.ones(len(before))] @ world.T[:, :3], before[:, :3], atol=1e-5)
    require_exact(ob)


def test_edits_of_the_source_are_followed_in_its_edit_mode_and_undone():
    source = native_curve()
    ob = follow_object(source)
    bpy.ops.ed.undo_push(message="follow")
    activate(source)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.curve.select_all('EXEC_DEFAULT', True, action='SELECT')
    bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 1))
    assert np.allclose(pool(bpy.data.objects[ob.name])[:, 2], 1)
    bpy.ops.ed.undo()
    assert np.allclose(pool(bpy.data.objects["source Exact"])[:, 2], 0)
    bpy.ops.ed.redo()
    assert np.allclose(pool(bpy.data.objects["source Exact"])[:, 2], 1)
    require_exact(bpy.data.objects["source Exact"])


def animate_keys(source):
    source.shape_key_add(name="Basis")
    key = source.shape_key_add(name="Up")
    for point in key.data:
        point.co.z += 2
    for frame, value in ((1, 0.0), (11, 1.0)):
        key.value = value
        key.keyframe_insert('value', frame=frame)
    for curve in curves_of(source.data.shape_keys.animation_data.action):
        for point in curve.keyframe_points:
            point.interpolation = 'LINEAR'


@pytest.mark.parametrize('make', (native_curve, native_surface))
def test_keyframed_shape_keys_are_followed_at_every_frame(make):
    source = make()
    animate_keys(source)
    bpy.context.scene.frame_set(1)
    ob = follow_object(source)
    start = pool(ob)[0, 2]
    for frame in (1, 6, 11, 3):
        bpy.context.scene.frame_set(frame)
        assert np.isclose(pool(ob)[0, 2], start + (frame - 1) / 5, atol=1e-5), frame
        require_exact(ob)


def test_hooks_on_curves_are_followed():
    source = native_curve()
    handle = bpy.data.objects.new("handle", None)
    bpy.context.scene.collection.objects.link(handle)
    hook = source.modifiers.new("hook", 'HOOK')
    hook.object = handle
    hook.vertex_indices_set([2])
    ob = follow_object(source)
    handle.location.z = 3
    bpy.context.view_layer.update()
    # The source itself is updated by the hook.
    assert np.isclose(pool(ob)[2, 2], 3, atol=1e-5) and np.isclose(pool(ob)[1, 2], 0)


def test_drivers_on_the_source_are_followed():
    source = native_curve()
    ob = follow_object(source)
    driver = source.driver_add('location', 2).driver
    driver.expression = "frame * 0.5"
    bpy.context.scene.frame_set(8)
    assert np.allclose(pool(ob)[:, 2], 4)


@pytest.mark.parametrize('engine', ('CYCLES', 'BLENDER_WORKBENCH'))
@pytest.mark.parametrize('disabled', (False, True), ids=('hidden in renders', 'hidden everywhere'))
def test_every_frame_of_a_render_is_right(engine, disabled, tmp_path):
    bpy.ops.surface.primitive_nurbs_surface_surface_add(radius=8)
    source = bpy.context.object
    animate_keys(source)
    for point in source.data.shape_keys.key_blocks["Up"].data:
        point.co.x += 40                # it is out of the picture at frames 6 and 11
    bpy.context.scene.frame_set(1)
    follow_object(source)
    source.hide_render, source.hide_viewport = True, disabled
    if engine == 'CYCLES':
        in_cycles(bpy.context.scene)
    else:
        bpy.context.scene.render.engine = engine
    assert np.allclose(coverage(tmp_path, (1, 6, 11)), (1, 0, 0), atol=0.05)


def test_a_shape_may_follow_a_shape_and_chains_are_followed_in_order():
    first = linked("first", shape.new_data("first", starters.nurbs_curve(3, 6, 'CLAMPED'), (8, 8)))
    second = follow_object(first)
    third = follow_object(second)
    first.data.splinewright.value = starters.nurbs_curve(2, 5, 'PERIODIC')
    first.data.update_tag()
    bpy.context.view_layer.update()
    assert third.data.splinewright.value == second.data.splinewright.value == first.data.splinewright.value
    require_exact(third)


def test_a_follower_of_a_shape_that_was_detached_says_so():
    first = linked("first", shape.new_data("first", starters.nurbs_curve(3, 6, 'CLAMPED'), (8, 8)))
    second = follow_object(first)
    value = second.data.splinewright.value
    activate(first)
    bpy.ops.splinewright.detach('EXEC_DEFAULT', True)
    first.location.x = 1
    bpy.context.view_layer.update()
    assert "not a Splinewright shape any more" in follow.problem(second.data)
    assert second.data.splinewright.value == value


def test_a_cycle_is_refused_with_a_word():
    first = linked("first", shape.new_data("first", starters.nurbs_curve(3, 6, 'CLAMPED'), (8, 8)))
    second = follow_object(first)
    third = follow_object(second)
    before = first.data.splinewright.value
    for source in (third, second):
        activate(first, source)
        with pytest.raises(RuntimeError, match="would follow itself"):
            bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True)
    assert not recipes.has(first.data) and first.data.splinewright.value == before


def test_a_cycle_made_by_other_means_hangs_nothing_and_is_said():
    first = linked("first", shape.new_data("first", starters.nurbs_curve(3, 6, 'CLAMPED'), (8, 8)))
    second = follow_object(first)
    recipes.write_derived(first.data, FOLLOW, {}, [second], Result(None))
    follow.scan()
    first.location.x = 1
    bpy.context.view_layer.update()
    assert "in a circle" in follow.problem(first.data) and "in a circle" in follow.problem(second.data)


def test_deleting_what_is_followed_leaves_the_last_shape_and_a_word():
    source = native_curve()
    ob = follow_object(source)
    value = ob.data.splinewright.value
    bpy.ops.ed.undo_push(message="follow")
    activate(source)
    bpy.ops.object.delete('EXEC_DEFAULT', True)
    bpy.context.view_layer.update()
    ob = bpy.data.objects[ob.name]
    assert ob.data.splinewright.value == value and "deleted" in follow.problem(ob.data)
    bpy.ops.ed.undo()
    ob = bpy.data.objects["source Exact"]
    assert follow.problem(ob.data) == ""
    bpy.data.objects["source"].location.z = 1
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob)[:, 2], 1)


def test_a_follower_cannot_be_edited_until_it_is_made_editable():
    source = native_curve()
    ob = follow_object(source)
    assert not bpy.ops.splinewright.edit_net.poll()
    assert bpy.ops.splinewright.make_editable('EXEC_DEFAULT', True) == {'FINISHED'}
    assert not recipes.has(ob.data)
    assert bpy.ops.splinewright.edit_net.poll()
    source.location.z = 5
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob)[:, 2], 0)


def test_a_follower_goes_on_after_saving_and_opening(tmp_path):
    source = native_curve()
    ob = follow_object(source)
    name, path = ob.name, str(tmp_path / "follow.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    bpy.data.objects["source"].location.z = 1
    bpy.context.view_layer.update()
    assert np.allclose(pool(bpy.data.objects[name])[:, 2], 1)


def test_a_renamed_follower_and_a_renamed_source_go_on():
    source = native_curve()
    ob = follow_object(source)
    ob.name, ob.data.name, source.name = "other", "other data", "other source"
    source.location.z = 1
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob)[:, 2], 1)


def test_a_duplicate_follows_too():
    source = native_curve()
    ob = follow_object(source)
    activate(ob)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True)
    copy = bpy.context.object
    source.location.z = 1
    bpy.context.view_layer.update()
    assert copy.data != ob.data and np.allclose(pool(ob)[:, 2], 1) and np.allclose(pool(copy)[:, 2], 1)


def test_a_follower_changed_by_hand_is_not_overwritten():
    source = native_surface()
    ob = follow_object(source)
    ob.data.vertices[0].co.z += 1
    before = vertices(ob.data).copy()
    source.location.z = 1
    bpy.context.view_layer.update()
    assert np.array_equal(vertices(ob.data), before) and "changed by hand" in follow.problem(ob.data)


@pytest.mark.parametrize('make', (lambda: linked("cube", bpy.data.meshes.new("cube")), lambda: linked("empty", None)))
def test_what_cannot_be_followed_is_refused(make):
    activate(make())
    assert not bpy.ops.splinewright.follow_object.poll()


def delete(ob):
    activate(ob)
    bpy.ops.object.delete('EXEC_DEFAULT', True)
    bpy.context.view_layer.update()


def test_a_deleted_follower_costs_no_search_of_the_file_and_follows_again_when_it_is_back(monkeypatch):
    source, other = native_curve(), linked("other", None)
    ob = follow_object(source)
    data, name = ob.data, ob.data.name
    data.use_fake_user = True
    delete(ob)
    source.location.z = 1
    bpy.context.view_layer.update()
    searches = []
    monkeypatch.setattr(updating, 'in_use', lambda found=updating.in_use: searches.append(1) or found())
    for moved in (source, other):
        moved.location.z = 2
        bpy.context.view_layer.update()
    assert key(data) in state.followers and not searches
    ob = linked("back", bpy.data.curves[name])
    assert np.allclose(pool(ob)[:, 2], 2)
    source.location.z = 3
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob)[:, 2], 3)


@pytest.mark.parametrize('get', (lambda data: linked("another", data), lambda data: hand_to(data)), ids=('new', 'of other data'))
def test_a_follower_that_lost_its_object_takes_another_in_its_place(get):
    source = native_curve()
    ob = follow_object(source)
    stay_on_inputs(ob)
    data = ob.data
    data.use_fake_user = True
    bpy.data.objects.remove(ob)
    source.location.z = 1
    bpy.context.view_layer.update()
    ob = get(data)
    ob.location.z = -4
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob)[:, 2], 5)


def hand_to(data):
    ob = linked("another", bpy.data.curves.new("another", 'CURVE'))
    ob.data = data
    return ob


def test_undo_brings_a_deleted_follower_back_and_it_follows():
    source = native_curve()
    name = follow_object(source).name
    bpy.ops.ed.undo_push(message="follow")
    delete(bpy.data.objects[name])
    bpy.data.objects["source"].location.z = 1
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="move")
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    bpy.data.objects["source"].location.z = 2
    bpy.context.view_layer.update()
    assert np.allclose(pool(bpy.data.objects[name])[:, 2], 2)


@pytest.mark.parametrize('is_instanced', (False, True))
def test_a_linked_follower_is_said_to_be_as_it_was_saved_and_costs_nothing(is_instanced, tmp_path, monkeypatch):
    asset = bpy.data.collections.new("asset")
    bpy.context.scene.collection.children.link(asset)
    source = native_curve()
    ob = follow_object(source)
    animate_keys(source)
    for each in (source, ob):
        bpy.context.scene.collection.objects.unlink(each)
        asset.objects.link(each)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "asset.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "asset.blend"), link=True) as (_, wanted):
        wanted.collections = ["asset"]
    if is_instanced:
        instance = linked("instance", None)
        instance.instance_type, instance.instance_collection = 'COLLECTION', wanted.collections[0]
    else:
        bpy.context.scene.collection.children.link(wanted.collections[0])
    evaluations = []
    monkeypatch.setattr(part('bridge.follow.recipe_results'), 'result', lambda *_: evaluations.append(1))
    for frame in (1, 6, 11):
        bpy.context.scene.frame_set(frame)
    data = next(data for data in bpy.data.curves if recipes.has(data))
    assert data.library and not evaluations
    assert "linked" in follow.problem(data) and "as that was saved" in follow.problem(data)
    if not is_instanced:
        activate(next(ob for ob in bpy.data.objects if ob.data == data))
        assert "linked from asset.blend" in " ".join(drawn().split())
