"""Tab where a shape has no net of its own leads to what it is made from; out of the result there are three ways."""

import bpy
import numpy as np
import pytest

from curves import value_of
from layouts import drawn
from natives import native_curve
from shapes import VALUES, activate, add, leave, op
from support import part

editing, shape, messages = part('ui.editing'), part('bridge.shape.shape'), part('ui.messages')


def revolved(source):
    activate(source)
    op(bpy.ops.splinewright.add_revolve)
    return bpy.context.object


def edit_source(**settings):
    assert not bpy.ops.splinewright.edit_net.poll()
    return op(bpy.ops.splinewright.edit_source, **settings)


def test_a_revolve_leads_to_the_net_of_its_profile():
    profile = add(value_of('cubic'))
    surface = revolved(profile)
    assert edit_source() == {'FINISHED'} and bpy.context.mode == 'EDIT_CURVE'
    held, = editing.nets_in_edit_mode(bpy.context)
    assert part('bridge.cage.net_object').shape_of(held) == profile
    leave()
    assert bpy.context.object == profile and not shape.is_touched(surface.data)


def test_a_follower_of_a_follower_leads_to_blenders_own_points():
    source = native_curve()
    activate(source)
    op(bpy.ops.splinewright.follow_object)
    revolved(bpy.context.object)
    assert edit_source() == {'FINISHED'} and bpy.context.mode == 'EDIT_CURVE' and bpy.context.object == source
    bpy.ops.object.mode_set(mode='OBJECT')


def test_of_two_one_is_chosen():
    first, second = add(value_of('cubic'), "first"), add(value_of('cubic'), "second")
    second.location.z = 1
    activate(first, second)
    op(bpy.ops.splinewright.add_ruled)
    with pytest.raises(RuntimeError, match="choose one"):
        edit_source()
    with pytest.raises(RuntimeError, match="not made from third"):
        edit_source(source="third")
    assert edit_source(source="first") == {'FINISHED'} and bpy.context.mode == 'EDIT_CURVE'
    leave()
    assert bpy.context.object == first


def test_an_input_that_was_hidden_is_shown_to_be_edited():
    profile = add(value_of('cubic'))
    surface = revolved(profile)
    activate(surface)
    assert op(bpy.ops.splinewright.show_inputs, how='HIDE') == {'FINISHED'} and profile.hide_get()
    assert op(bpy.ops.splinewright.show_inputs, how='SHOW') == {'FINISHED'} and not profile.hide_get()
    profile.hide_set(True)
    edit_source()
    assert not profile.hide_get() and editing.nets_in_edit_mode(bpy.context)
    leave()


def test_inputs_are_hidden_where_that_is_wanted():
    profile = add(value_of('cubic'))
    op(bpy.ops.splinewright.add_revolve, hide_inputs=True)
    assert profile.hide_get() and bpy.context.object.visible_get()


def test_what_is_made_by_numbers_or_hidden_is_refused_in_words():
    op(bpy.ops.splinewright.add_circle)
    with pytest.raises(RuntimeError, match="made by its numbers"):
        edit_source()
    profile = add(value_of('cubic'))
    surface = revolved(profile)
    profile.hide_viewport = True
    with pytest.raises(RuntimeError, match="is hidden"):
        edit_source()
    profile.hide_viewport = False
    bpy.data.objects.remove(profile)
    activate(surface)
    with pytest.raises(RuntimeError):
        edit_source()
    assert bpy.context.mode == 'OBJECT' and bpy.context.object == surface


@pytest.mark.parametrize('make', (lambda: add(value_of('cubic')), native_curve, lambda: None))
def test_others_are_left_to_blender(make):
    ob = make()
    if ob:
        activate(ob)
    assert not bpy.ops.splinewright.edit_source.poll()


def in_result(value='nurbs patch'):
    ob = add(VALUES[value]())
    bpy.ops.object.mode_set(mode='EDIT')
    return ob


def test_in_the_result_the_words_name_the_way_back():
    ob = in_result()
    assert "the generated mesh, not the net" in messages.sentence(bpy.context.view_layer)[0][0]
    said = drawn()
    assert all(word in said for word in ("the generated mesh, not the net", "Back to the Net", "Discard Manual Changes", "Convert to Plain Mesh/Curve"))
    bpy.ops.object.mode_set(mode='OBJECT')
    assert messages.sentence(bpy.context.view_layer) == [] and not shape.is_touched(ob.data)


@pytest.mark.parametrize('value', ('nurbs patch', 'nurbs'))
@pytest.mark.parametrize('how', ('NET', 'RESTORE', 'DETACH'))
def test_the_three_ways_out_of_the_result(how, value):
    ob = in_result(value)
    before = shape.points_of(ob.data).copy()
    if how != 'NET':
        (bpy.ops.mesh if ob.type == 'MESH' else bpy.ops.curve).select_all(action='SELECT')
        bpy.ops.transform.translate(value=(0, 0, 1))
    assert op(bpy.ops.splinewright.leave_result, how=how) == {'FINISHED'}
    if how == 'NET':
        assert editing.nets_in_edit_mode(bpy.context)
        leave()
    assert bpy.context.mode == 'OBJECT' and shape.has_shape(ob) == (how != 'DETACH')
    moved = np.abs(shape.points_of(ob.data) - before).max() if shape.has_shape(ob) else None
    assert moved in (None, 0.0)
    assert not bpy.ops.splinewright.leave_result.poll()


def test_what_was_changed_by_hand_is_not_taken_for_the_net(capfd):
    ob = in_result()
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.transform.translate(value=(0, 0, 1))
    op(bpy.ops.splinewright.leave_result, how='NET')
    assert "changed by hand" in capfd.readouterr().out and bpy.context.mode == 'OBJECT' and shape.is_touched(ob.data)
