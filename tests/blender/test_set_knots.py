"""Edit Knots: the text is always that of the piece and axis which are set."""

import bpy
import pytest

from patches import value_of
from shapes import add, enter, op, require_exact
from support import part

knots, store = part('core.verbs.knots'), part('bridge.data.store')


def text_of(ob, piece=0, axis=0):
    return knots.text_of(store.read(ob.data), piece, axis)


def test_a_text_that_was_read_for_another_axis_is_read_anew():
    """What the redo panel does: it undoes, and calls again with the other axis and the old text."""
    ob = add(value_of('nurbs patch'))
    before = ob.data.splinewright.value
    assert op(bpy.ops.splinewright.set_knots, axis='V', knots=text_of(ob), shown="1 U") == {'FINISHED'}
    assert ob.data.splinewright.value == before
    require_exact(ob)


def test_a_text_that_was_read_for_this_axis_is_taken():
    ob = add(value_of('nurbs patch'))
    assert op(bpy.ops.splinewright.set_knots, axis='V', knots="0 1 2 3 9", shown="1 V") == {'FINISHED'}
    assert ob.data.splinewright.value.knots[1].tolist() == [0, 1, 2, 3, 9]


def test_a_text_of_another_piece_is_read_anew_and_a_piece_that_is_not_there_is_refused():
    ob = add(value_of('many curves'))
    before = ob.data.splinewright.value
    assert op(bpy.ops.splinewright.set_knots, piece=2, knots="0 1", shown="4 U") == {'FINISHED'}
    assert ob.data.splinewright.value == before
    for piece, word in ((9, "none of number 9"), (1, "no knots")):
        with pytest.raises(RuntimeError, match=word):
            op(bpy.ops.splinewright.set_knots, piece=piece, knots="0 1", shown="4 U")
    assert ob.data.splinewright.value == before


def test_the_piece_and_axis_of_the_last_call_are_forgotten():
    add(value_of('many curves'), "first")
    op(bpy.ops.splinewright.set_knots, piece=4, knots="0 3")
    ob = add(value_of('nurbs patch'), "second")
    op(bpy.ops.splinewright.set_knots, axis='V', knots="0 1 2 3 9")
    changed = text_of(ob).replace("0.1", "0.2")
    assert op(bpy.ops.splinewright.set_knots, knots=changed) == {'FINISHED'}
    assert text_of(ob) == changed and text_of(ob, axis=1) == "0 1 2 3 9"


def test_where_the_net_does_not_come_out_again_the_knots_are_changed_and_it_is_told(monkeypatch, capfd):
    ob = add(value_of('nurbs patch'))
    enter()

    def refuse(*_):
        raise part('core.base.failures').Refusal("there is no room")
    monkeypatch.setattr(part('bridge.cage.net_object'), 'make', refuse)
    assert op(bpy.ops.splinewright.set_knots, axis='V', knots="0 1 2 3 9") == {'FINISHED'}
    assert "Warning: the net did not come out again: there is no room" in capfd.readouterr().out
    ob = bpy.data.objects["shape"]
    assert bpy.context.mode == 'OBJECT' and text_of(ob, axis=1) == "0 1 2 3 9"
