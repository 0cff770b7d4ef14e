"""Keys of control points stay with their points: in nets, through verbs, joins and copies; or it is told that they went."""

import bpy
import numpy as np
import pytest

from animated import evaluated
from keyed_points import (at, clear, edited, key, key_at, keyed_shape, keys, moving, net_places, point_keys, pool, ramp,
                          straight)
from layouts import drawn
from shapes import VALUES, activate, add, enter, leave, move, numbers_of, op, require_exact, select
from support import part, splinecore as sc
from test_holding import hold, neighbors, require_smooth, row

animation = part('bridge.data.animation')


def test_copies_have_keys_of_their_own_where_their_data_is_and_share_them_where_it_is_shared():
    ob = keyed_shape(VALUES['nurbs']())
    twin, single = ob.copy(), ob.copy()
    single.data = ob.data.copy()
    for other in (twin, single):
        bpy.context.scene.collection.objects.link(other)
    at(4)
    for other in (twin, single):
        assert np.array_equal(evaluated(other), evaluated(ob))
        require_exact(other)
    activate(single)
    assert op(bpy.ops.splinewright.clear_point_keys) == {'FINISHED'}
    assert point_keys.has(ob.data) and not point_keys.has(single.data)
    at(7)
    assert pool(ob)[0, 2] - pool(single)[0, 2] == pytest.approx(3)
    activate(twin)
    bpy.ops.object.delete()
    at(1)
    require_exact(ob)
    activate(ob)
    bpy.ops.object.delete()
    at(3)


def test_points_at_infinity_and_back_lose_their_keys_and_it_is_told(capfd):
    ob = keyed_shape(VALUES['nurbs']())
    held = enter()
    select(held, 2)
    assert op(bpy.ops.splinewright.point_to_infinity) == {'FINISHED'}
    leave()
    assert "1 point went" in capfd.readouterr().out
    kept = set(point_keys.rows(ob.data)[point_keys.animated(ob.data).any(1)].tolist())
    assert 2 not in kept and len(kept) == 5
    before = pool(ob)[2]
    at(4)
    assert np.array_equal(pool(ob)[2], before)


def test_verbs_carry_keys_of_points_that_they_leave_and_tell_of_the_others(capfd):
    ob = ramp(sc.NurbsCurve(2, [0, 0, 0, 1, 2, 3, 4, 4, 4], np.column_stack([range(6), [0, 1, 0, 1, 0, 2], [0] * 6])))
    assert op(bpy.ops.splinewright.insert_knot, parameter_u=0.5) == {'FINISHED'}
    assert "the keys of 1 point went" in capfd.readouterr().out
    assert [round(far, 4) for far in moving(ob).values()] == [1, 0, 0, 3, 4, 5, 6]
    require_exact(ob)
    at(1)
    assert op(bpy.ops.splinewright.reverse) == {'FINISHED'}
    assert [round(far, 4) for far in moving(ob).values()] == [6, 5, 4, 3, 0, 0, 1]
    at(1)
    assert op(bpy.ops.splinewright.split, parameter_u=2.0) == {'FINISHED'}
    far = moving(ob)
    assert far[0] == pytest.approx(6) and far[max(far)] == pytest.approx(1)
    require_exact(ob)


def test_patch_verbs_carry_keys_too():
    ob = ramp(sc.BezierPatch(np.dstack([*np.meshgrid(range(3), range(4), indexing='ij'), np.zeros((3, 4))])))
    before = sorted(moving(ob).values())
    at(1)
    assert op(bpy.ops.splinewright.to_nurbs) == {'FINISHED'}
    assert sorted(moving(ob).values()) == before
    at(1)
    assert op(bpy.ops.splinewright.swap_uv) == {'FINISHED'}
    assert np.allclose(sorted(moving(ob).values()), before)
    require_exact(ob)


def test_a_join_keeps_the_keys_of_the_active_shape_and_tells_of_the_others(capfd):
    other, ob = ramp(VALUES['cubic']()), ramp(VALUES['nurbs']())
    activate(ob, other)
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    assert "the keys of 4 points went" in capfd.readouterr().out
    assert sorted(round(far, 3) for far in moving(ob).values()) == [0, 0, 0, 0, 1, 2, 3, 4, 5, 6]
    require_exact(ob)


def test_undo_of_a_verb_brings_keys_back():
    ob = ramp(VALUES['nurbs']())
    name = ob.name
    bpy.ops.ed.undo_push(message="keyed")
    assert op(bpy.ops.splinewright.raise_degree) == {'FINISHED'}
    assert len(point_keys.rows(ob.data)) < 7
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    assert [round(far, 4) for far in moving(ob).values()] == [1, 2, 3, 4, 5, 6]
    require_exact(ob)


def test_what_follows_another_object_from_now_on_has_no_keys_of_points():
    source, ob = add(VALUES['cubic']()), keyed_shape(VALUES['nurbs']())
    part('bridge.follow.follow').attach(ob, source, bpy.context.evaluated_depsgraph_get())
    assert not len(ob.data.splinewright_keyed) and not point_keys.has(ob.data)
    at(4)
    require_exact(ob)
    assert ob.data.splinewright.value == source.data.splinewright.value


def test_detach_ends_the_keys_and_transforms_wait_for_that():
    ob = keyed_shape(VALUES['nurbs']())
    ob.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="Clear Point Keyframes"):
        op(bpy.ops.splinewright.apply_transform)
    assert op(bpy.ops.splinewright.detach) == {'FINISHED'}
    assert not len(ob.data.splinewright_keyed) and not animation.paths(ob.data)


NETS = pytest.mark.parametrize('name', ('rational cubic', 'cubic', 'semicircle', 'hermite', 'closed hermite', 'nurbs',
                                        'many curves', 'bezier patch', 'hermite patch', 'nurbs patch',
                                        'patch with a point at infinity', 'teapot'))


@NETS
def test_a_net_goes_where_keys_put_its_points_and_every_digit_stays(name):
    ob = add(VALUES[name]())
    home = pool(ob)
    key_at(1)
    key_at(7, (home[:, 3] != 0, (0, 0, 6)))
    straight(ob.data)
    without = {frame: (at(frame), pool(ob))[1] for frame in (4, 7, 1)}
    held = edited(ob)
    before = net_places(held)
    for frame in (4, 7, 4, 1):
        at(frame)
        bpy.context.view_layer.update()
        assert np.array_equal(pool(ob), without[frame])
        assert np.allclose(net_places(held)[:, 2] - before[:, 2], frame - 1, atol=1e-5)
        assert part('bridge.net.live').problem(held) == ""
        require_exact(ob)
    leave()
    assert np.array_equal(pool(ob), without[1])


def test_points_moved_in_the_net_are_keyed_as_they_are_seen_and_undone():
    ob = add(VALUES['nurbs patch']())
    name, home = ob.name, pool(ob)
    held = edited(ob)
    select(held, 3, 4)
    at(1)
    assert op(key) == {'FINISHED'}
    at(11)
    move(0, 0, 10)
    assert np.allclose(pool(ob)[3:5, 2] - home[3:5, 2], 10)
    assert op(key) == {'FINISHED'}
    lifted = pool(ob)
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    bpy.context.view_layer.update()
    assert keys(ob) == 8 and bpy.context.scene.frame_current == 11 and np.array_equal(pool(ob), lifted)
    require_exact(ob)
    assert op(key) == {'FINISHED'} and keys(ob) == 16
    straight(ob.data)
    for frame, height in ((6, 5), (11, 10), (1, 0)):
        at(frame)
        bpy.context.view_layer.update()
        assert np.allclose(pool(ob)[3:5, 2] - home[3:5, 2], height, atol=1e-6)
        assert np.array_equal(np.delete(pool(ob), (3, 4), 0), np.delete(home, (3, 4), 0))
    assert sorted(point_keys.rows(ob.data).tolist()) == [3, 4] and keys(ob) == 2 * 8
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    assert keys(ob) == 8 and bpy.context.mode == 'EDIT_MESH'
    bpy.ops.ed.redo()
    ob = bpy.data.objects[name]
    assert keys(ob) == 16
    for _ in range(3):
        bpy.ops.ed.undo()
    assert not keys(bpy.data.objects[name])


def test_what_is_moved_by_hand_stays_until_the_frame_changes():
    ob = keyed_shape(VALUES['nurbs']())
    at(4)
    here = pool(ob)
    held = edited(ob)
    select(held, 2)
    move(0, 3, 0)
    for _ in range(3):
        bpy.context.view_layer.update()
        assert pool(ob)[2, 1] == pytest.approx(here[2, 1] + 3)
    require_exact(ob)
    at(4)
    bpy.context.view_layer.update()
    assert np.allclose(pool(ob), here, rtol=1e-6)
    assert np.allclose(net_places(held)[2], here[2, :3], atol=1e-6)


@pytest.mark.parametrize('is_left', (False, True), ids=('undone', 'left'))
def test_keys_of_a_point_that_is_deleted_in_the_net_come_back_with_it_or_go_when_it_is_left(is_left, capfd):
    ob = ramp(VALUES['nurbs']())
    name = ob.name
    held = edited(ob)
    select(held, 2)
    assert bpy.ops.curve.delete('EXEC_DEFAULT', True, type='VERT') == {'FINISHED'}
    bpy.context.view_layer.update()
    assert len(pool(ob)) == 5
    far = [round(each, 4) for each in moving(ob).values()]
    assert len(far) == 5 and set(far) <= {0, 1, 2, 4, 5, 6} and far[0] == 1 and far[-1] == 6
    at(1)
    if not is_left:
        bpy.ops.ed.undo()
        bpy.context.view_layer.update()
        ob = bpy.data.objects[name]
        assert [round(each, 4) for each in moving(ob).values()] == [1, 2, 3, 4, 5, 6]
    leave()
    ob = bpy.data.objects[name]
    assert ("went, which became" in capfd.readouterr().out) == is_left
    assert point_keys.GONE not in point_keys.rows(ob.data)[point_keys.animated(ob.data).any(1)]
    require_exact(ob)


def test_a_point_that_is_appended_leaves_the_keys_of_the_others():
    ob = ramp(VALUES['nurbs']())
    held = edited(ob)
    select(held, 5)
    bpy.ops.curve.extrude_move('EXEC_DEFAULT', True, TRANSFORM_OT_translate={'value': (1, 0, 0)})
    bpy.context.view_layer.update()
    assert len(pool(ob)) == 7
    assert [round(each, 4) for each in moving(ob).values()] == [1, 2, 3, 4, 5, 6, 0]
    leave()
    assert [round(each, 4) for each in moving(ob).values()] == [1, 2, 3, 4, 5, 6, 0]


def test_the_panel_shows_points_in_hand():
    ob = keyed_shape(VALUES['nurbs']())
    assert "Point 0" in drawn() and "Point 5" in drawn()
    held = edited(ob)
    select(held, 2)
    text = drawn()
    assert "Clear Point Keyframes Point 2 X Y Z Weight" in text
    leave()
    assert op(clear) == {'FINISHED'}
    drawn()
    chain = keyed_shape(VALUES['hermite']())
    net = numbers_of(edited(chain))
    select(bpy.context.object, 0)
    assert "Clear Point Keyframes Handle 0 X Y Z" in drawn() and "X Y Z Weight" not in drawn()
    assert len(net.rows) == 12


def test_a_file_that_is_saved_while_the_net_is_out_goes_on(tmp_path):
    ob = keyed_shape(VALUES['nurbs patch']())
    name, path = ob.name, str(tmp_path / "net.blend")
    home = pool(ob)
    edited(ob)
    bpy.ops.wm.save_as_mainfile(filepath=path)
    at(4)
    assert np.allclose(pool(ob)[:, 2] - home[:, 2], 3, atol=1e-5)
    bpy.ops.wm.open_mainfile(filepath=path)
    at(4)
    ob = bpy.data.objects[name]
    assert np.allclose(pool(ob)[:, 2] - home[:, 2], 3, atol=1e-5)
    require_exact(ob)


@pytest.mark.parametrize('is_out', (False, True), ids=('without a net', 'in the net'))
def test_a_seam_that_holds_does_so_in_every_frame(is_out):
    ob = add(neighbors())
    hold('G1', moves='second')
    held = enter()
    at(1)
    select(held, *row(0, 4))
    op(key)
    at(7)
    move(0, 0, 3)
    op(key)
    if not is_out:
        leave()
    flat = None
    for frame in (1, 4, 7, 4, 1):
        at(frame)
        bpy.context.view_layer.update()
        require_smooth('G1')
        flat = pool(ob)[:, 2] if flat is None else flat
    assert np.allclose(pool(ob)[:, 2], flat, atol=1e-5), "back at the first frame it is as it was"
    for damage in (1.0, {'rows': [99], 'placed': [0.0] * 4, 'origins': [0.0] * 4}, {'rows': "none"}):
        ob.data['splinewright_keyed_rest'] = damage
        at(7)
        require_smooth('G1')
        at(1)


def test_a_script_that_gives_another_value_finds_what_went():
    ob = ramp(VALUES['nurbs']())
    ob.data.splinewright.value = ob.data.splinewright.value.insert_knot(0.5)
    assert "keys of" in ob.data.splinewright.problem
    ob.data.splinewright.value = sc.BezierCurve([(0, 0), (1, 1), (2, 5)])
    assert not point_keys.has(ob.data)
    ob.data.splinewright.value = sc.BezierCurve([(0, 0), (1, 1), (2, 3)])
    assert ob.data.splinewright.problem == ""


def test_strips_of_the_nonlinear_animation_move_points_too():
    ob = keyed_shape(VALUES['nurbs']())
    home, animated = pool(ob), ob.data.animation_data
    action = animated.action
    strip = animated.nla_tracks.new().strips.new("strip", 11, action)
    animated.action = None
    if hasattr(strip, 'action_slot') and strip.action_slot is None:
        strip.action_slot = action.slots[0]
    at(14)
    assert np.allclose(pool(ob)[:, 2] - home[:, 2], 3, atol=1e-5)
    require_exact(ob)


def test_handles_that_blender_computes_are_where_keys_put_them_with_and_without_a_net():
    bpy.ops.curve.primitive_bezier_circle_add()
    ob = bpy.context.object
    assert op(bpy.ops.splinewright.make_exact) == {'FINISHED'}
    home = pool(ob)
    key_at(1)
    key_at(7, (np.arange(len(home)) == ob.data.splinewright.value.points.shape[0] - 3, (0, 0, 6)))
    straight(ob.data)
    without = {frame: (at(frame), pool(ob))[1] for frame in (4, 7, 1)}
    assert not np.allclose(without[7], home)
    held = edited(ob)
    for frame in (4, 7, 4, 1):
        at(frame)
        bpy.context.view_layer.update()
        assert part('bridge.net.live').problem(held) == ""
        assert np.allclose(pool(ob), without[frame], rtol=0, atol=1e-6), frame
    leave()
    assert np.allclose(pool(ob), without[1], rtol=0, atol=1e-6)
