"""What a shape does not take of its net is never dropped unasked: not by leaving, saving, sweeping or opening a file."""

import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import VALUES, activate, add, enter, first_point, leave, move, numbers_of, op, require_exact, select
from support import part
from test_files import reopen, save

editing, handlers, live, messages, net_object, problems, saving, store = (part(name) for name in (
    'ui.editing', 'ui.handlers', 'bridge.net.live', 'ui.messages', 'bridge.cage.net_object', 'bridge.data.problems', 'ui.saving',
    'bridge.data.store'))
KINDS = ('nurbs patch', 'nurbs', 'hermite')


def the_shape():
    return bpy.data.objects["shape"]


def nets():
    return [ob for ob in bpy.data.objects if net_object.is_net(ob)]


def said():
    return " ".join(sentence for sentence, _ in messages.sentence(bpy.context.view_layer))


def with_unread_moves(name):
    """(value, where the points are in its net) of a shape whose net holds moves that the shape does not take."""
    ob = add(VALUES[name]())
    held = enter()
    select(held, first_point(held))
    ob.data.update_tag()
    move_by_hand(ob)
    bpy.ops.ed.undo_push(message="by hand")
    move(0, 0, 1)
    assert "changed by hand" in live.problem(held)
    return ob.data.splinewright.value, coordinates(held)


def move_by_hand(ob):
    if ob.type == 'MESH':
        ob.data.vertices[0].co.z += 5
    else:
        ob.data.splines[0].points[0].co.z += 5


def coordinates(held):
    numbers = numbers_of(held)
    return net_object.present(held, numbers).positions()[part('core.net.reading').slots(
        numbers, net_object.present(held, numbers))]


def require_taken(before, points):
    """The shape is restored, and has taken what its net held."""
    activate(the_shape())
    assert op(bpy.ops.splinewright.restore) == {'FINISHED'}
    editing.sweep()
    assert not nets() and the_shape().data.splinewright.value != before
    require_exact(the_shape())
    taken = net_object.net_of(store.read(the_shape().data))
    assert np.allclose(taken.positions[taken.rows >= 0], points[taken.rows >= 0], atol=1e-6)


@pytest.mark.parametrize('name', KINDS)
def test_a_net_that_is_left_by_another_way_stays_while_it_holds_what_the_shape_does_not_take(name):
    value, points = with_unread_moves(name)
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    for _ in range(3):
        editing.sweep()
        held, = nets()
        assert held.mode == 'OBJECT' and held.users_scene and the_shape().data.splinewright.value == value
    assert "holds changes that shape has not taken" in said() and "changed by hand" in drawn()
    require_taken(value, points)
    assert said() == ""


def test_a_kept_net_is_gone_on_with_from_itself_and_from_its_shape():
    value, points = with_unread_moves('nurbs patch')
    for chosen in ("shape", "shape Net"):
        bpy.ops.object.mode_set(mode='OBJECT')
        editing.sweep()
        activate(bpy.data.objects[chosen])
        assert bpy.ops.splinewright.edit_net.poll()
        held = enter()
        assert held.name == "shape Net" and len(nets()) == 1 and np.array_equal(coordinates(held), points)
        assert "changed by hand" in live.problem(held)
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    require_taken(value, points)


def test_a_kept_net_that_is_deleted_is_gone_and_the_shape_has_another():
    value, _ = with_unread_moves('nurbs patch')
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    activate(*nets())
    bpy.ops.object.delete()
    editing.sweep()
    activate(the_shape())
    op(bpy.ops.splinewright.restore)
    held = enter()
    assert the_shape().data.splinewright.value == value and live.problem(held) == ""
    leave()


@pytest.mark.parametrize('name', KINDS)
def test_a_file_saved_with_an_unread_net_has_it_and_nothing_is_lost_when_it_is_opened(name, tmp_path):
    value, points = with_unread_moves(name)
    path = tmp_path / "unread.blend"
    save(path)
    held = bpy.context.object
    assert net_object.is_net(held) and held.mode == 'EDIT' and "changed by hand" in live.problem(held)
    assert "Saved: the file has that in shape Net" in said()
    move(0, 0, 1)
    reopen(path)
    editing.sweep()
    held, = nets()
    assert held.mode == 'OBJECT' and np.array_equal(coordinates(held), points)
    assert the_shape().data.splinewright.value == value and "holds changes" in said()
    require_taken(value, points)


def test_a_file_saved_with_lost_points_has_them_in_the_shape_and_the_net(tmp_path):
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 2)
    move(0, 0, 1)
    select(held, 0)
    op(bpy.ops.mesh.delete, type='VERT')
    bpy.context.view_layer.update()
    select(held, 7)
    move(0, 0, 1)
    value = the_shape().data.splinewright.value
    save(tmp_path / "lost.blend")
    reopen(tmp_path / "lost.blend")
    editing.sweep()
    assert the_shape().data.splinewright.value == value and "lost points" in said()
    activate(*nets())
    held = enter()
    select(held, 7)
    move(0, 0, 1)
    assert the_shape().data.splinewright.value != value
    assert op(bpy.ops.splinewright.renew_net) == {'FINISHED'}
    assert said() == "" and len(bpy.context.object.data.vertices) == 24
    leave()
    require_exact(the_shape())


def test_what_is_saved_while_all_is_well_has_no_net_and_nothing_is_said(tmp_path):
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 0)
    op(bpy.ops.mesh.extrude_region)
    save(tmp_path / "well.blend")
    assert "Saved" not in said()
    reopen(tmp_path / "well.blend")
    assert not nets()


def test_leaving_tells_what_would_be_lost_and_scripts_leave():
    value, _ = with_unread_moves('nurbs patch')
    assert "changed by hand" in editing.unread(editing.nets_in_edit_mode(bpy.context))
    leave()
    assert not nets() and the_shape().data.splinewright.value == value and said() == ""


def test_disabling_the_add_on_keeps_a_net_that_holds_what_its_shape_does_not_take():
    value, points = with_unread_moves('nurbs patch')
    part('ui').unregister()
    try:
        held, = nets()
        assert bpy.context.mode == 'OBJECT' and held.mode == 'OBJECT'
    finally:
        part('ui').register()
    handlers.loaded()
    editing.sweep()
    require_taken(value, points)


def test_a_kept_net_survives_undo_and_redo():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 2)
    op(bpy.ops.mesh.delete, type='VERT')
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    editing.sweep()
    assert "holds changes" in said()
    bpy.ops.ed.undo()
    editing.sweep()
    held, = nets()
    assert held.mode == 'EDIT' and "lost points" in said() and "holds changes" not in said()
    bpy.ops.ed.redo()
    editing.sweep()
    held, = nets()
    assert held.mode == 'OBJECT' and "holds changes" in said()
    for _ in range(2):
        bpy.ops.ed.undo()
        editing.sweep()
    assert said() == "" and nets()[0].mode == 'EDIT'
    leave()


# Saves that fail -----------------------------------------------------------------------------------


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs'))
def test_a_save_that_fails_puts_the_net_back(name, tmp_path):
    add(VALUES[name]())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    value = the_shape().data.splinewright.value
    with pytest.raises(RuntimeError):
        save(tmp_path / "no such folder" / "x.blend")
    bpy.context.view_layer.update()
    the_shape().update_tag()
    bpy.context.view_layer.update()     # a handler is called
    held, = nets()
    assert held.mode == 'EDIT' and bpy.context.object == held and held.users_scene
    move(0, 0, 1)
    assert the_shape().data.splinewright.value != value and "Saved" not in said()
    bpy.ops.ed.undo()
    assert the_shape().data.splinewright.value == value
    leave()
    save(tmp_path / "x.blend")
    reopen(tmp_path / "x.blend")
    assert the_shape().data.splinewright.value == value and not nets()


def test_a_mistake_in_one_scene_keeps_no_net_of_another_out(tmp_path, monkeypatch, capfd):
    other, here = bpy.data.scenes.new("other"), bpy.context.scene
    bpy.context.window.scene = other
    add(VALUES['nurbs patch'](), "b")
    enter()
    bpy.context.window.scene = here
    add(VALUES['nurbs patch']())
    enter()
    put_back = saving._put_back

    def failing(suspended):
        if suspended.scene == here:
            raise KeyError("a mistake")
        put_back(suspended)

    monkeypatch.setattr(saving, '_put_back', failing)
    save(tmp_path / "x.blend")
    assert sorted(ob.mode for ob in nets()) == ['EDIT', 'OBJECT']
    assert "a mistake" in capfd.readouterr().err


# One shape's mistake is not another's ----------------------------------------------------------------


def test_a_mistake_with_one_shape_keeps_no_other_from_getting_its_normals_and_its_net_away(monkeypatch, capfd):
    for name in "ab":
        add(VALUES['nurbs patch'](), name)
    activate(*bpy.data.objects)
    enter()
    for held in bpy.context.objects_in_mode:
        select(held, 3)
    move(0, 0, 1)
    settle = live.finalize

    def failing(data, *more):
        if data == bpy.data.objects["a"].data:
            raise KeyError("a mistake")
        settle(data, *more)

    monkeypatch.setattr(live, 'finalize', failing)
    editing.finalize()
    assert not store.is_draft(bpy.data.objects["b"].data) and "a mistake" in bpy.data.objects["a"].data.splinewright.problem
    put_away = editing.put_away

    def failing_too(context, ob):
        if net_object.shape_of(ob).name == "a":
            raise KeyError("another")
        put_away(context, ob)

    monkeypatch.setattr(editing, 'put_away', failing_too)
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    assert [net_object.shape_of(ob).name for ob in nets()] == ["a"]
    assert "another" in capfd.readouterr().err
