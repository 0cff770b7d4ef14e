"""Keys and drivers on control points: played, rendered, baked, saved, undone, and what cannot be."""

import bpy
import numpy as np
import pytest

from animated import animate, curves_of, evaluated, follow_object, rendered
from keyed_points import (animate_row, at, clear, drive, key, key_at, keyed_shape, keys, point_keys, pool, put, straight)
from layouts import drawn
from shapes import VALUES, activate, add, op, require_exact
from support import part, splinecore as sc

animation, problems = part('bridge.data.animation'), part('bridge.data.problems')
FRAMES = (1, 4, 7)


MAKERS = pytest.mark.parametrize('name', (
    'rational cubic', 'semicircle', 'hermite', 'closed hermite', 'nurbs', 'periodic', 'many curves', 'bezier patch',
    'hermite patch', 'nurbs patch', 'patch with a point at infinity', 'teapot', 'mixed set'))


@MAKERS
def test_points_are_where_keys_put_them_in_views_and_renders(name):
    ob = add(VALUES[name]())
    home = pool(ob)
    is_point = home[:, 3] != 0
    key_at(1)
    key_at(7, (is_point, (0, 0, 6)))
    straight(ob.data)
    for frame in (*FRAMES, 4):
        at(frame)
        expected = home[:, 2] + np.where(is_point, frame - 1, 0)
        assert np.allclose(pool(ob)[:, 2], expected, atol=1e-5) and np.allclose(pool(ob)[:, :2], home[:, :2], atol=1e-6)
        require_exact(ob)
        assert problems.of(ob.data, problems.KEYED) == ""
    views = {frame: (at(frame), evaluated(ob))[1] for frame in FRAMES}
    for frame, looks in rendered(lambda depsgraph: evaluated(ob, depsgraph), FRAMES).items():
        assert np.array_equal(looks[0], views[frame])
    require_exact(ob)


def test_points_without_keys_and_numbers_that_keys_repeat_keep_every_digit():
    ob = add(VALUES['nurbs']())
    home = pool(ob)
    animate_row(ob, 2, 'place', {1: 0.1, 7: 0.7}, index=1)
    for frame in (1, 4, 7, 1):
        at(frame)
        now = pool(ob)
        assert now[2, 1] == pytest.approx(0.1 * frame) and float(str(np.float32(now[2, 1]))) == now[2, 1]
        assert np.array_equal(np.delete(now.ravel(), 9), np.delete(home.ravel(), 9))
    other = add(VALUES['nurbs']())
    home = pool(other)
    key_at(1)
    for frame in (5, 9, 1):
        at(frame)
        assert np.array_equal(pool(other), home)


def test_a_key_that_goes_on_the_same_writes_nothing(monkeypatch):
    ob = keyed_shape(VALUES['nurbs patch']())
    at(7)
    shape, writes = part('bridge.shape.shape'), []
    finish = shape._finish
    monkeypatch.setattr(shape, '_finish', lambda *arguments: writes.append(1) or finish(*arguments))
    for frame in (8, 20, 9):
        at(frame)
    assert not writes
    at(4)
    assert len(writes) == 1


@pytest.mark.parametrize('name, axis', (('place', 1), ('weight', 3)))
@pytest.mark.parametrize('kind', ('nurbs', 'nurbs patch'))
def test_a_driver_moves_a_point_when_what_drives_it_moves_in_views_and_renders(kind, name, axis):
    ob = add(VALUES[kind]())
    home, seen = pool(ob), []
    lever = drive(ob, 3, name, axis)
    for x in (2.0, 3.0, 0.1):
        lever.location.x = x
        bpy.context.view_layer.update()
        require_exact(ob)
        assert pool(ob)[3, axis] == x and np.array_equal(np.delete(pool(ob), 3, 0), np.delete(home, 3, 0))
        seen.append(evaluated(ob))
    animate(lever, 'location', {1: 2.0, 4: 3.0, 7: 0.1}, index=0)
    for looks, expected in zip(rendered(lambda depsgraph: evaluated(ob, depsgraph), FRAMES).values(), seen):
        assert np.array_equal(looks[0], expected)


def test_weights_are_keyed_and_none_goes_through_0_in_silence():
    ob = add(VALUES['nurbs']())
    animate_row(ob, 1, 'weight', {1: 2.0, 5: -2.0})
    for frame, weight in ((1, 2.0), (2, 1.0), (4, -1.0), (5, -2.0), (2, 1.0)):
        at(frame)
        require_exact(ob)
        assert pool(ob)[1, 3] == weight and problems.of(ob.data, problems.KEYED) == ""
    at(3)
    assert pool(ob)[1, 3] == 1.0 and "the weight 0" in problems.of(ob.data, problems.KEYED)
    assert all(word in drawn() for word in problems.of(ob.data, problems.KEYED).split())


def test_the_vector_of_a_direction_at_infinity_is_keyed_and_its_weight_stays_0():
    ob = add(VALUES['semicircle']())
    animate_row(ob, 1, 'place', {1: 1.0, 7: 7.0}, index=1)
    animate_row(ob, 1, 'weight', {1: 0.0, 7: 0.0})
    curves_of(ob.data.animation_data.action)[-1].keyframe_points[1].co.y = 6.0
    at(4)
    assert np.array_equal(pool(ob)[1], (0, 4, 0, 0)) and "infinity" in problems.of(ob.data, problems.KEYED)
    require_exact(ob)


@pytest.mark.parametrize('scale', (1e-30, 1e30))
def test_very_small_and_very_large_shapes_are_keyed(scale):
    home = np.array([(0, 0, 0), (1, 2, 0), (2, -1, 0), (3, 0, 0)]) * scale
    ob = keyed_shape(sc.BezierCurve(home), (0, 0, 6 * scale))
    at(4)
    assert np.allclose(pool(ob)[:, 2] / scale, 3) and problems.of(ob.data, problems.KEYED) == ""


@pytest.mark.parametrize('scale, word', ((1e-40, "smaller"), (1e39, "farther")))
def test_what_keys_do_not_hold_is_refused(scale, word):
    definition = part('core.shape.definition').from_value(sc.BezierCurve(np.array([(0, 0, 0), (1, 2, 0), (3, 0, 0)]) * scale))
    with pytest.raises(ValueError, match=word):
        part('core.shape.keyed_rows').require_single(definition.pool, np.arange(3))


def test_what_followers_are_made_of_moves_them_and_both_are_baked():
    ob = keyed_shape(VALUES['nurbs']())
    follower = follow_object(ob)
    follower.data.splinewright.resolution_u = ob.data.splinewright.resolution_u
    for frame in FRAMES:
        at(frame)
        assert np.array_equal(evaluated(ob), evaluated(follower)), frame
    live = {frame: (at(frame), evaluated(ob))[1] for frame in FRAMES}
    activate(ob, follower)
    assert op(bpy.ops.splinewright.bake_animation, frame_start=1, frame_end=7) == {'FINISHED'}
    assert ob.data.shape_keys and not point_keys.has(ob.data) and not animation.paths(ob.data)
    for frame in FRAMES:
        at(frame)
        assert np.allclose(evaluated(ob), live[frame], atol=1e-5) and np.allclose(evaluated(follower), live[frame], atol=1e-5)
    activate(ob, follower)
    assert op(bpy.ops.splinewright.unbake) == {'FINISHED'}
    at(4)
    assert np.array_equal(evaluated(ob), live[4]) and point_keys.has(ob.data)
    require_exact(ob)


@pytest.mark.parametrize('name', ('hermite', 'nurbs patch'))
def test_keys_go_on_in_a_file_that_is_opened(name, tmp_path):
    ob = keyed_shape(VALUES[name]())
    looks = {frame: (at(frame), evaluated(ob))[1] for frame in FRAMES}
    called, path = ob.name, str(tmp_path / "keyed.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = bpy.data.objects[called]
    for frame in FRAMES:
        at(frame)
        assert np.array_equal(evaluated(ob), looks[frame])
        require_exact(ob)


def test_undo_and_redo_of_keys_and_of_clearing_them():
    ob = add(VALUES['nurbs']())
    name = ob.name
    key_at(1)
    at(5)
    put(ob, 2, (0, 0, 4))
    op(key)
    op(clear)
    for step, count in ((bpy.ops.ed.undo, 12), (bpy.ops.ed.undo, 6), (bpy.ops.ed.redo, 12), (bpy.ops.ed.redo, 0)):
        step()
        ob = bpy.data.objects[name]
        assert keys(ob) == 4 * count
        require_exact(ob)


def test_clearing_leaves_points_where_they_are_and_other_animation_alone():
    ob = keyed_shape(VALUES['nurbs']())
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 7: 8})
    lever = drive(ob, 1, 'place', 0)
    activate(ob)
    at(4)
    here = pool(ob)
    with pytest.raises(RuntimeError, match="none of these points"):
        op(clear, when='FRAME')
    assert op(clear) == {'FINISHED'}
    for frame in (7, 2):
        at(frame)
        assert np.array_equal(pool(ob)[:, 2], here[:, 2]) and ob.data.splinewright.resolution_u == frame + 1
    lever.location.x = 5
    bpy.context.view_layer.update()
    assert pool(ob)[1, 0] == 5, "drivers stay"


def test_keys_of_one_frame_are_cleared():
    ob = keyed_shape(VALUES['nurbs']())
    at(7)
    assert op(clear, when='FRAME') == {'FINISHED'}
    assert keys(ob) == 6 * 4
    at(4)
    assert (np.abs(pool(ob)[:, 2]) < 1).all()


def test_what_is_typed_over_a_key_holds_until_the_frame_changes():
    ob = keyed_shape(VALUES['nurbs']())
    at(4)
    item = ob.data.splinewright_keyed[2]
    for _ in range(2):
        item.place[2] = 0.3
        bpy.context.view_layer.update()
        require_exact(ob)
        assert pool(ob)[2, 2] == 0.3
        at(4)
        assert pool(ob)[2, 2] != 0.3
    item.weight = 0.0
    assert item.weight == np.float32(pool(ob)[2, 3]) != 0 and "weight 0" in ob.data.splinewright.problem


@pytest.mark.parametrize('damage, words', (
    (lambda item: setattr(item, 'row', 99), "points that the shape has not"),
    (lambda item: setattr(item, 'row', -7), "points that the shape has not")))
def test_damaged_items_are_a_sentence_and_the_other_points_move(damage, words):
    ob = keyed_shape(VALUES['nurbs']())
    home = pool(ob)
    damage(ob.data.splinewright_keyed[1])
    at(4)
    assert words in problems.of(ob.data, problems.KEYED).replace("1 point that", "points that")
    assert pool(ob)[1, 2] == home[1, 2] and np.allclose(np.delete(pool(ob)[:, 2] - home[:, 2], 1), 3, atol=1e-5)
    drawn()
    require_exact(ob)
    assert op(clear) == {'FINISHED'}
    at(5)
    assert problems.of(ob.data, problems.KEYED) == "" and not point_keys.has(ob.data)


def test_keys_beyond_the_items_change_nothing():
    ob = keyed_shape(VALUES['nurbs']())
    at(4)
    ob.data.splinewright_keyed.clear()
    here = pool(ob)
    at(7)
    assert np.array_equal(pool(ob), here)
    drawn()
    require_exact(ob)


def test_recipes_refuse_and_say_what_is_keyed_instead():
    assert op(bpy.ops.splinewright.add_circle) == {'FINISHED'}
    ob = bpy.context.object
    assert not key.poll()
    with pytest.raises(ValueError, match="key its numbers"):
        part('bridge.net.point_keying').insert(ob.data, [0], 1)
    animate_row(ob, 0, 'place', {1: 0.0, 7: 6.0}, index=2)
    before = pool(ob)
    at(4)
    assert np.array_equal(pool(ob), before) and "made by a recipe" in problems.of(ob.data, problems.KEYED)
    require_exact(ob)


def test_what_is_linked_stands_still_without_a_word_too_many(tmp_path):
    ob = keyed_shape(VALUES['nurbs']())
    name, path = ob.name, str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = [name]
    ob = wanted.objects[0]
    bpy.context.scene.collection.objects.link(ob)
    before = pool(ob)
    for frame in FRAMES:
        at(frame)
        assert np.array_equal(pool(ob), before)
    activate(ob)
    assert not key.poll()
    assert "Its keys do nothing here" in drawn()
    local = ob.override_create() if hasattr(ob, 'override_create') else None
    if local is not None:
        local.data.override_create()
        bpy.context.scene.collection.objects.link(local)
        at(4)
        activate(local)
        drawn()
        assert np.array_equal(pool(local), before)
