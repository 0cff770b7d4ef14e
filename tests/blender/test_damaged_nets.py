"""What is stored of a net, damaged: a sentence where it is shown, and nothing else stops or is lost."""

import traceback

import bmesh
import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import VALUES, activate, add, enter, select, shown
from support import part
from test_damaged import VALUES as DAMAGES
from test_damaged import definition_damages, operators, put, require_following, stored, witness      # noqa: F401

editing, file_state, handlers, live, messages, net_object, saving, store = (part(name) for name in (
    'ui.editing', 'bridge.data.file_state', 'ui.handlers', 'bridge.net.live', 'ui.messages', 'bridge.cage.net_object', 'ui.saving',
    'bridge.data.store'))
KINDS = ('nurbs patch', 'hermite patch', 'nurbs', 'hermite')


def group(ob):
    return ob.data[net_object.KEY]


def net_damages(held):
    """Functions that each do one damage to what is stored of a net. They take an object to point to."""
    for name in ('token', 'definition', 'typed', 'selected', 'any_count', 'rests'):
        for value in DAMAGES:
            yield lambda ob, name=name, value=value: put(group(held), name, value, ob)
    for name in ('version', 'form', 'structure', 'pool', 'indices', 'knots'):
        for value in DAMAGES:
            yield lambda ob, name=name, value=value: put(group(held)['definition'], name, value, ob)
    for value in DAMAGES[1:]:
        yield lambda ob, value=value: put(held.data, net_object.KEY, value, ob)
        yield lambda ob, value=value: put(held, net_object.SHAPE, value, ob)
    for value in DAMAGES:
        yield lambda ob, value=value: put(bpy.data.objects["shape"].data, net_object.EDITED_BY, value, ob)


def use(held, step):
    """Everything that looks at a net of its own accord, and a user who moves and reads its points. What is said of it."""
    file_state.forget()
    part('ui.ui_state').forget()
    handlers.loaded()
    said = drawn() + " ".join(sentence for sentence, _ in messages.sentence(bpy.context.view_layer))
    held.data.update_tag()
    bpy.context.view_layer.update()
    held.data.splinewright_points.numbers = list(held.data.splinewright_points.numbers)
    held.data.splinewright_points.weight = held.data.splinewright_points.weight
    for operator in operators():
        operator.poll()
    handlers.undone()
    handlers.frame_changed(bpy.context.scene, bpy.context.evaluated_depsgraph_get())
    editing.sweep()
    editing.finalize()
    editing.hand_over_now()
    live.unread(held)
    if step % 20 == 0:
        saving.before()
        saving.put_back()
    return said


def require_no_traceback(capfd):
    """Counted, since pytest takes minutes to explain what a long text holds."""
    text = capfd.readouterr().err
    count, first = text.count("Traceback"), text.find("Traceback")
    assert count == 0, text[first:first + 3000]


def put_whole(owner, key, whole):
    store.assign(owner, key, whole)


@pytest.mark.parametrize('name', KINDS)
def test_no_damaged_net_stops_anything(name, witness, capfd):      # noqa: F811
    ob = add(VALUES[name]())
    held = enter()
    select(held, 0)
    ours, before = group(held).to_dict(), shown(ob).copy()
    edited_by = ob.data[net_object.EDITED_BY]
    tried = told = 0
    for damage in net_damages(held):
        damage(witness[0])
        said = use(held, tried)
        told += "damaged" in said or "earlier time" in said or "deleted" in said
        tried += 1
        require_following(witness, tried)
        assert held.mode == 'EDIT' and np.array_equal(shown(ob), before)
        put_whole(held.data, net_object.KEY, ours)
        put_whole(held, net_object.SHAPE, ob)
        put_whole(ob.data, net_object.EDITED_BY, edited_by)
    use(held, 1)
    problem = live.problem(held)
    assert problem == ""
    assert tried > 300 and told > tried / 4, (tried, told)
    require_no_traceback(capfd)


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs'))
def test_no_definition_that_is_damaged_while_its_net_is_out_stops_anything(name, witness, capfd):       # noqa: F811
    ob = add(VALUES[name]())
    held = enter()
    select(held, 0)
    whole = ob.data[store.KEY].to_dict()
    for tried, damage in enumerate(definition_damages(ob.data), 1):
        damage(ob)
        use(held, tried)
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 0.001))
        use(held, tried)
        require_following(witness, tried)
        put_whole(ob.data, store.KEY, whole)
    assert tried > 300
    require_no_traceback(capfd)


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs'))
def test_a_net_that_is_damaged_is_said_kept_and_left_only_by_leaving(name):
    ob = add(VALUES[name]())
    value = ob.data.splinewright.value
    held = enter()
    group(held)['token'] = 7
    file_state.forget()
    part('ui.ui_state').forget()
    handlers.loaded()
    assert "damaged" in live.problem(held) and "damaged" in editing.unread([held])
    assert "damaged" in messages.sentence(bpy.context.view_layer)[0][0]
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    assert bpy.data.objects.get(held.name) == held and "damaged" in messages.sentence(bpy.context.view_layer)[0][0]
    bpy.ops.object.mode_set(mode='EDIT')
    assert bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True) == {'FINISHED'}
    assert [one.name for one in bpy.data.objects] == ["shape"] and ob.data.splinewright.value == value
    activate(ob)
    enter()


def attribute_damages():
    """Attributes of a cage that were taken away, or are of another kind or domain."""
    for name in ("weight", "splinewright_vertex", "splinewright_vertex_seal"):
        for kind, domain in ((None, None), ('FLOAT', 'POINT'), ('INT', 'POINT'), ('FLOAT', 'EDGE'), ('FLOAT_VECTOR', 'POINT'),
                             ('BOOLEAN', 'FACE')):
            yield name, kind, domain


@pytest.mark.parametrize('name,kind,domain', attribute_damages())
def test_attributes_of_a_cage_that_are_gone_or_of_another_kind_are_a_sentence(name, kind, domain, capfd):
    ob = add(VALUES['nurbs patch']())
    value = ob.data.splinewright.value
    held = enter()
    bpy.ops.object.mode_set(mode='OBJECT')
    held.data.attributes.remove(held.data.attributes[name])
    if kind:
        held.data.attributes.new(name, kind, domain)
    bpy.ops.object.mode_set(mode='EDIT')
    said = use(held, 0)
    is_own = (name, kind) == ("weight", 'FLOAT') and domain == 'POINT'
    if name != "splinewright_vertex_seal":
        assert ("net" in said or "weight of 0" in said) and live.problem(held) != "", (said, is_own)
    assert ob.data.splinewright.value == value
    require_no_traceback(capfd)


def test_where_the_weights_are_lost_points_still_move_the_shape():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.layers.float.remove(mesh.verts.layers.float['weight'])
    bmesh.update_edit_mesh(held.data)
    bpy.context.view_layer.update()
    before = store.read(ob.data).pool.copy()
    assert "lost the weights" in live.problem(held)
    select(held, 4)
    bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 1))
    changed = store.read(ob.data).pool != before
    assert np.flatnonzero(changed.any(1)).tolist() == [4] and not changed[:, 3].any()
    assert "lost the weights" in live.problem(held)
    numbers = list(held.data.splinewright_points.numbers)
    numbers[0] = 0.25
    held.data.splinewright_points.numbers = numbers
    bpy.context.view_layer.update()
    assert store.read(ob.data).pool[4, 0] == 0.25


def test_a_net_whose_object_became_of_another_kind_is_kept():
    ob = add(VALUES['nurbs']())
    value = ob.data.splinewright.value
    held = enter()
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.ops.object.convert(target='MESH')
    held = bpy.context.object
    assert held.type == 'MESH'
    editing.sweep()
    handlers.undone()
    drawn()
    assert held.name in bpy.data.objects and ob.data.splinewright.value == value


def test_asking_for_a_damaged_net_again_and_again_keeps_nothing():
    add(VALUES['nurbs patch']())
    held = enter()
    group(held)['definition'] = 3
    file_state.forget()
    depths, sentences = set(), set()
    for _ in range(10):
        with pytest.raises(net_object.DamagedNet, match="damaged") as error:
            live.session(held.data)
        depths.add(len(list(traceback.walk_tb(error.value.__traceback__))))
        sentences.add(str(error.value))
    assert len(depths) == len(sentences) == 1, depths
    assert not any(isinstance(kept, BaseException) for kept in file_state.state.sessions.values())
