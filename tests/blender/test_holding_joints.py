"""Joints of curves that hold: either side is edited in the net, the other goes along, live, through undo and redo."""

import bpy
import numpy as np
import pytest

from layouts import drawn_by
from shapes import add, enter, leave, move, numbers_of, op, require_exact, select
from support import part, splinecore as sc
from test_files import reopen, save

held, live, net_object, store = (part(name) for name in ('bridge.data.held', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store'))
continuity = part('core.joints.continuity')

FIRST = np.array([[0, 0, 0], [1, 1.5, 0], [2, -0.5, 0.5], [3, 1, 0], [4, 0, 0.0]])
SECOND = np.array([[4, 0, 0], [5, 1, 0.5], [6, 0.5, -0.5], [7, 0, 0], [8, 1, 0.0]])


def curves():
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2.0]
    return [sc.NurbsCurve(3, knots, FIRST), sc.NurbsCurve(3, knots, SECOND, [1, 0.8, 1.2, 1, 1])]


def shape():
    return bpy.data.objects["shape"]


def hold(smoothness='G1', moves='second', **more):
    assert op(bpy.ops.splinewright.hold_joint, continuity=smoothness, moves=moves,
              **{'first': 1, 'first_end': 'end', 'second': 2, 'second_end': 'start', **more}) == {'FINISHED'}


def require_smooth(smoothness='G1'):
    one, other = shape().data.splinewright.value
    found = one.to_nurbs().continuity_to(other.to_nurbs())
    assert (found.c if smoothness[0] == 'C' else found.g) >= int(smoothness[1]), found
    require_exact(shape())


def vertex(piece, i):
    net = numbers_of(bpy.context.object)
    return {int(row): vertex for vertex, row in enumerate(net.rows)}[int(net.definition.pieces[piece].indices[i])]


def drag(net, piece, i, *way):
    select(net, vertex(piece, i))
    move(*way)
    net.data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(net) == ""
    there = net_object.present(net, numbers_of(net)).positions()
    rows = numbers_of(net).rows
    assert np.allclose(there[rows >= 0], store.read(shape().data).pool[rows[rows >= 0], :3], atol=1e-5)


@pytest.mark.parametrize('moves', ('second', 'first', 'both'))
@pytest.mark.parametrize('smoothness', ('C0', 'G1', 'C1', 'G2', 'C2'))
def test_a_joint_holds_while_either_side_is_edited(smoothness, moves):
    add(curves())
    hold(smoothness, moves)
    require_smooth(smoothness)
    net = enter()
    for piece, i, way in ((0, -2, (0, 0, 1)), (1, 1, (0, 0.3, -1)), (0, -1, (0, 0.4, 0.5)), (1, 0, (-0.5, 0, 0.2)), (0, -3, (0, 1, 0))):
        before = store.read(shape().data).pool
        drag(net, piece, i, *way)
        require_smooth(smoothness)
        if i in (0, -1):                # the end under the hand goes where the hand goes
            row = store.read(shape().data).pieces[piece].indices[i]
            assert np.allclose(store.read(shape().data).pool[row, :3], before[row, :3] + way, atol=1e-5)
    leave()
    require_smooth(smoothness)


def test_undo_and_redo_lead_through_what_went_along():
    add(curves())
    hold()
    net = enter()
    seen = [store.read(shape().data).pool]
    for i, height in ((-2, 1.0), (-1, 0.5), (-1, -1.5)):
        drag(net, 0, i, 0, 0, height)
        seen.append(store.read(shape().data).pool)
    for expected in seen[-2::-1]:
        op(bpy.ops.ed.undo)
        for _ in range(3):
            if np.allclose(store.read(shape().data).pool, expected, atol=1e-5):
                break
            bpy.ops.ed.undo()
        assert np.allclose(store.read(shape().data).pool, expected, atol=1e-5)
        require_smooth()
    leave()


def test_a_knot_of_one_curve_and_its_closed_end_hold():
    points = np.array([[0, 0, 0], [1, 1, 0], [2, 1, 0], [3, 0, 0], [3, -2, 1], [1, -2, 0], [0, 0, 0.0]])
    add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2.0], points))
    hold('C1', second=1, knot=1)
    hold('G1', second=1)
    net = enter()
    for i in (1, 2, 3, 4, 5):
        drag(net, 0, i, 0.1, -0.2, 0.4)
        value = shape().data.splinewright.value
        assert value.continuity(1.0).c >= 1 and value.continuity_to(value).g >= 1
    leave()
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert drawn.operators.count("splinewright.release_joint") == 2


def test_the_panel_offers_what_can_hold():
    add([*curves(), sc.NurbsCurve(3, [0, 1, 2, 3, 4, 5.0], np.random.default_rng(1).random((5, 3)), periodic=True)])
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "splinewright.hold_joint" in drawn.operators
    hold('G2')
    assert "splinewright.release_joint" in drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context).operators
    op(bpy.ops.splinewright.release_joint, first=2, first_end='start', second=1, second_end='end')
    assert held.read(shape().data) == ()


def test_released_in_the_net_and_a_file(tmp_path):
    add(curves())
    hold('C2', 'both')
    save(tmp_path / "held.blend")
    reopen(tmp_path / "held.blend")
    bpy.context.view_layer.objects.active = shape()
    shape().select_set(True)
    net = enter()
    drag(net, 1, 1, 0, 1, 0)
    require_smooth('C2')
    op(bpy.ops.splinewright.release_joint, first=1, first_end='end', second=2, second_end='start')
    net = bpy.context.object
    before = store.read(shape().data).pool
    drag(net, 1, 1, 0, 1, 0)
    assert (store.read(shape().data).pool != before).any(1).sum() == 1
    leave()


def test_growing_keeps_it_and_what_takes_it_away_is_told():
    add(curves())
    hold('C0')
    net = enter()
    for spline in net.data.splines:
        for point in spline.points:
            point.select = False
    net.data.splines[1].points[-1].select = True
    bpy.ops.curve.extrude_move(CURVE_OT_extrude={}, TRANSFORM_OT_translate={'value': (1, 1, 0)})
    net.data.update_tag()
    bpy.context.view_layer.update()
    assert len(held.read(shape().data)) == 1 and live.note(net) == ""
    drag(net, 0, -1, 0, 1, 0)
    require_smooth('C0')
    for point in net.data.splines[1].points:
        point.select = True
    for point in net.data.splines[0].points:
        point.select = False
    bpy.ops.curve.delete(type='VERT')
    net.data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(net) == "" and held.read(shape().data) == () and "released" in live.note(net)
    leave()


def test_verbs_carry_it(capfd):
    add(curves())
    hold('G1')
    op(bpy.ops.splinewright.raise_degree)
    assert len(held.read(shape().data)) == 1
    op(bpy.ops.splinewright.split, piece=1, parameter_u=0.5)
    assert [(one.first, one.second) for one in held.read(shape().data)] == [((1, 'end'), (2, 'start'))]
    op(bpy.ops.splinewright.reverse, piece=3)
    assert held.read(shape().data) == () and "a joint holds no more" in capfd.readouterr().out


def test_shapes_that_are_joined_keep_what_holds_in_each():
    add(curves(), "other").location.y = 9
    hold('C1')
    add(curves())
    hold('G2')
    bpy.data.objects["other"].select_set(True)
    op(bpy.ops.splinewright.join)
    assert [(one.first[0], one.second[0], one.smoothness) for one in held.read(shape().data)] == [(0, 1, 'G2'), (2, 3, 'C1')]


@pytest.mark.parametrize('damage', ("{", "[1]", "[[0, \"u_end\", 1, \"start\", \"G1\", \"second\"]]", "[[0, NaN, 0, NaN, \"G1\", \"second\"]]",
                                    "[[0, {}, 1, [], \"G1\", \"second\"]]", 5))
def test_damage_is_a_sentence_and_can_be_released(damage):
    add(curves())
    shape().data[held.KEY] = damage
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert any("release it" in text for text in drawn.texts)
    net = enter()
    select(net, vertex(0, 1))
    move(0, 0, 1)
    assert "release" in live.problem(net)
    leave()
    op(bpy.ops.splinewright.release_joint)
    assert held.KEY not in shape().data.keys()


def test_what_cannot_hold_is_refused_and_nothing_changes():
    add([sc.NurbsCurve(1, [0, 0, 1, 1.0], FIRST[:2]), sc.NurbsCurve(1, [0, 0, 1, 1.0], FIRST[1:3])])
    before = store.read(shape().data).pool
    for settings, words in (({'continuity': 'C2'}, "degree"), ({'second': 3}, "pieces"), ({'knot': 1, 'second': 1}, "knots inside")):
        with pytest.raises(RuntimeError, match=words):
            bpy.ops.splinewright.hold_joint(**{'first': 1, 'first_end': 'end', 'second': 2, 'second_end': 'start', **settings})
    assert np.array_equal(store.read(shape().data).pool, before) and held.read(shape().data) == ()


def corner():
    """A curve that is only continuous at its knot 1."""
    points = np.array([[0, 0, 0], [1, 1, 0], [2, 1, 0], [3, 0, 0], [4, 2, 1], [5, 2, 0], [6, 0, 0.0]])
    return sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2.0], points)


def at():
    return [(one.first, one.second) for one in held.read(shape().data)]


def test_a_knot_that_is_moved_or_typed_elsewhere_takes_along_what_holds_there():
    add(corner())
    hold('C1', second=1, knot=1)
    op(bpy.ops.splinewright.move_knot, knot=5, parameter=1.25)
    assert at() == [((0, 1.25), (0, 1.25))] and shape().data.splinewright.value.continuity(1.25).c >= 1
    op(bpy.ops.splinewright.set_knots, axis='U', knots="0 0 0 0 0.5 0.5 0.5 2 2 2 2")
    assert at() == [((0, 0.5), (0, 0.5))]
    net = enter()
    drag(net, 0, 4, 0, 0, 1)
    assert shape().data.splinewright.value.continuity(0.5).c >= 1
    leave()


def test_reversed_or_with_another_domain_a_knot_is_never_another_one():
    add(corner())
    hold('C1', second=1, knot=1)
    op(bpy.ops.splinewright.reparameterize, how='AFFINE', start=0.0, end=4.0)
    assert at() == [((0, 2.0), (0, 2.0))]
    op(bpy.ops.splinewright.reverse)
    assert at() == []


def test_in_object_mode_the_end_that_is_pulled_leads():
    add(curves())
    hold('G1')
    before = [one.to_nurbs().evaluate(0.0) for one in shape().data.splinewright.value]
    assert op(bpy.ops.splinewright.pull_here, piece=2, parameter_u=0.0, vector=(0, 0, 1)) == {'FINISHED'}
    assert np.allclose(shape().data.splinewright.value[1].evaluate(0.0) - before[1], (0, 0, 1), atol=1e-6)
    require_smooth()


def test_what_follows_another_holds_nothing():
    add(curves(), "other").location.y = 5
    source = bpy.context.object
    add(curves())
    hold()
    part('bridge.follow.follow').attach(shape(), source, bpy.context.evaluated_depsgraph_get())
    assert held.read(shape().data) == ()


def test_what_goes_with_blenders_own_curve_is_told(capfd):
    add(curves())
    hold()
    op(bpy.ops.splinewright.to_native)
    assert "that hold" in capfd.readouterr().out and held.KEY not in shape().data.keys()


def test_the_very_end_that_is_extruded_is_no_joint_any_more():
    add(curves())
    hold('C0')
    net = enter()
    second = store.read(shape().data).pieces[1].indices
    before = store.read(shape().data).pool[second]
    for spline in net.data.splines:
        for point in spline.points:
            point.select = False
    net.data.splines[0].points[-1].select = True
    bpy.ops.curve.extrude_move(CURVE_OT_extrude={}, TRANSFORM_OT_translate={'value': (1, 1, 0)})
    net.data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(net) == "" and held.read(shape().data) == () and "released" in live.note(net)
    definition = store.read(shape().data)
    assert np.allclose(definition.pool[definition.pieces[1].indices], before)
    leave()
