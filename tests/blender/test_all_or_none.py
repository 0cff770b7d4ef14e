"""Work on several shapes: each is done as a whole or not at all, and what was done is an undo step."""

import bpy
import pytest

from curves import value_of
from shapes import activate, add, enter, op, require_exact
from support import part, scene_state

editing, live, net_object, selection = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.net.selection'))


def two_nets(first, second):
    """Two shapes whose nets are in Edit Mode."""
    obs = [add(value_of(kind), name) for kind, name in ((first, "first"), (second, "second"))]
    activate(*obs)
    enter()
    return obs


def select_in_each(row):
    """In every net the points of a row, as an undo step."""
    for held in editing.nets():
        numbers = live.session(held.data).net
        selection.select(held, numbers, [i for i, of in enumerate(numbers.rows) if of == row])
    bpy.ops.ed.undo_push(message="select")


def refuse(*_):
    raise part('core.base.failures').Refusal("there is no room")


def values(obs):
    return [ob.data.splinewright.value for ob in obs]


def test_points_of_two_shapes_go_to_infinity_in_one_step():
    obs = two_nets('cubic', 'nurbs')
    before = values(obs)
    select_in_each(1)
    assert op(bpy.ops.splinewright.point_to_infinity) == {'FINISHED'}
    obs = [bpy.data.objects[name] for name in ("first", "second")]
    assert [value.weights[1] for value in values(obs)] == [0, 0]
    assert len(editing.nets_in_edit_mode(bpy.context)) == 2
    for ob in obs:
        require_exact(ob)
    bpy.ops.ed.undo()
    editing.sweep()
    assert values(bpy.data.objects[name] for name in ("first", "second")) == before


@pytest.mark.parametrize('kinds', (('cubic', 'hermite'), ('hermite', 'cubic')))
def test_where_one_of_two_cannot_go_none_goes(kinds):
    obs = two_nets(*kinds)
    before = values(obs)
    select_in_each(1)
    name = ("first", "second")[kinds.index('hermite')]
    with pytest.raises(RuntimeError, match=f"{name}: points and tangents of Hermite pieces have no weights"):
        op(bpy.ops.splinewright.point_to_infinity)
    assert values(obs) == before and len(editing.nets_in_edit_mode(bpy.context)) == 2


def test_where_the_second_could_not_be_shown_the_first_is_left_alone():
    obs = two_nets('bezier patch', 'bezier patch')
    before = values(obs)
    for held in editing.nets():         # a whole row may go, a corner not
        wanted = (4, 5, 6, 7) if net_object.shape_of(held) == obs[0] else (0,)
        numbers = live.session(held.data).net
        selection.select(held, numbers, [i for i, row in enumerate(numbers.rows) if row in wanted])
    with pytest.raises(RuntimeError, match="second: "):
        op(bpy.ops.splinewright.point_to_infinity)
    assert values(obs) == before


def test_a_net_that_does_not_come_out_again_is_told_and_the_change_is_an_undo_step(monkeypatch, capfd):
    ob = add(value_of('cubic'))
    before = ob.data.splinewright.value
    enter()
    select_in_each(1)
    with monkeypatch.context() as patch:
        patch.setattr(net_object, 'make', refuse)
        assert op(bpy.ops.splinewright.point_to_infinity) == {'FINISHED'}
    assert "Warning: the net did not come out again: there is no room" in capfd.readouterr().out
    assert bpy.context.mode == 'OBJECT' and not editing.nets()
    assert bpy.data.objects["shape"].data.splinewright.value.weights[1] == 0
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before


def test_a_net_that_cannot_be_made_leaves_nothing_behind(monkeypatch):
    op(bpy.ops.splinewright.add_catmull_rom)
    ob, before = bpy.context.object, scene_state()
    monkeypatch.setattr(part('bridge.shape.recipe_edit'), 'is_closed', refuse)
    with pytest.raises(RuntimeError, match="there is no room"):
        op(bpy.ops.splinewright.edit_net)
    assert scene_state() == before and bpy.context.object == ob and bpy.context.mode == 'OBJECT'


def test_of_two_nets_of_which_one_cannot_be_made_neither_comes(monkeypatch):
    good = add(value_of('cubic'), "good")
    op(bpy.ops.splinewright.add_catmull_rom)
    bad = bpy.context.object
    activate(good, bad)
    before = scene_state()
    monkeypatch.setattr(part('bridge.shape.recipe_edit'), 'is_closed', refuse)
    with pytest.raises(RuntimeError, match="there is no room"):
        op(bpy.ops.splinewright.edit_net)
    assert scene_state() == before and bpy.context.mode == 'OBJECT'
    assert set(bpy.context.selected_objects) == {good, bad} and bpy.context.object == good


def test_what_was_done_before_a_mistake_of_ours_can_be_undone(monkeypatch):
    obs = [add(value_of('cubic'), name) for name in ("first", "second")]
    before = values(obs)
    activate(*obs)
    replacing, calls = part('bridge.edit.replace_pieces'), []
    work = replacing.do

    def broken(*given):
        calls.append(given)
        if len(calls) == 2:
            raise KeyError("a mistake of ours")
        return work(*given)
    monkeypatch.setattr(replacing, 'do', broken)
    with pytest.raises(RuntimeError, match="a mistake of ours"):
        op(bpy.ops.splinewright.raise_degree)
    assert sorted(value.degree for value in values(obs)) == [3, 4]
    bpy.ops.ed.undo()
    assert values(bpy.data.objects[name] for name in ("first", "second")) == before

