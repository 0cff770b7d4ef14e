"""Seams that hold: either side is edited in the net, the other goes along, live, through undo and redo."""

import bpy
import numpy as np
import pytest

from layouts import drawn_by
from shapes import add, enter, leave, move, numbers_of, op, require_exact, select
from support import part, splinecore as sc
from test_files import reopen, save

held, live, net_object, store = (part(name) for name in ('bridge.data.held', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store'))


def neighbors(count=2):
    rng = np.random.default_rng(4)
    u, v = np.meshgrid(np.arange(6.0), np.arange(5.0), indexing='ij')
    knots = [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [0, 0, 0, 0, 1, 2, 2, 2, 2]
    made = []
    for i in range(count):
        points = np.stack([u + 5 * i, v, np.zeros_like(u)], -1) + rng.uniform(-0.2, 0.2, (6, 5, 3))
        if i:
            points[0] = made[-1].points[-1]
        made.append(sc.NurbsPatch((3, 3), knots, points))
    return sc.PatchSet.from_patches(made)


def shape():
    return bpy.data.objects["shape"]


def value():
    return shape().data.splinewright.value


def hold(continuity='G1', moves='second', first=1, second=2):
    assert op(bpy.ops.splinewright.hold_seam, continuity=continuity, moves=moves, first=first, first_side='u_end', second=second,
              second_side='u_start') == {'FINISHED'}


def require_smooth(continuity='G1', first=0, second=1):
    found = sc.seam_continuity(value()[first], 'u_end', value()[second], 'u_start')
    assert (found.c if continuity[0] == 'C' else found.g) >= int(continuity[1]), found
    require_exact(shape())


def row(patch, i):
    """The vertices of a row of a patch across u in the net."""
    net = numbers_of(bpy.context.object)
    vertices = {int(row): vertex for vertex, row in enumerate(net.rows)}
    return [vertices[int(at)] for at in net.definition.pieces[patch].indices[i]]


def followed():
    bpy.context.object.data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(bpy.context.object) == ""
    net, there = numbers_of(bpy.context.object), net_object.present(bpy.context.object, numbers_of(bpy.context.object))
    own = store.read(shape().data).pool[net.rows[net.rows >= 0], :3]
    assert np.allclose(there.positions()[net.rows >= 0], own, atol=1e-5)


@pytest.mark.parametrize('moves', ('second', 'first', 'both'))
@pytest.mark.parametrize('continuity', ('G1', 'C1', 'G2', 'C2'))
def test_a_seam_holds_while_either_side_is_edited(continuity, moves):
    add(neighbors())
    hold(continuity, moves)
    require_smooth(continuity)
    held_net = enter()
    for patch, i, way in ((0, 2, (0, 0, 1)), (1, 2, (0, 0.3, -1)), (0, 5, (0, 0, 0.5)), (0, 4, (0, 0, 0.7)), (1, 1, (0, 0, -0.4))):
        before = value()
        select(held_net, row(patch, i)[1:4])
        move(*way)
        followed()
        require_smooth(continuity)
        assert value() != before or patch == 1 or i == 4
    leave()
    require_smooth(continuity)


def test_undo_and_redo_lead_through_what_went_along():
    add(neighbors())
    hold()
    net = enter()
    seen = [value()]
    for i, height in ((4, 1.0), (5, 0.5), (3, -1.0)):
        select(net, row(0, i))
        move(0, 0, height)
        followed()
        seen.append(value())
    for expected in seen[-2::-1]:
        op(bpy.ops.ed.undo)
        for _ in range(3):
            if np.abs(value()[0].points - expected[0].points).max() < 1e-6:
                break
            bpy.ops.ed.undo()
        assert np.abs(value()[0].points - expected[0].points).max() < 1e-6
        assert np.abs(value()[1].points - expected[1].points).max() < 1e-5
        require_smooth()
    leave()


def test_what_was_released_is_free_again():
    add(neighbors())
    hold()
    op(bpy.ops.splinewright.release_seam, first=2, first_side='u_start', second=1, second_side='u_end')
    net = enter()
    other = value()[1]
    select(net, row(0, 4))
    move(0, 0, 1)
    assert value()[1] == other and sc.seam_continuity(value()[0], 'u_end', value()[1], 'u_start').g == 0
    leave()


def test_it_is_held_and_released_while_the_net_is_out():
    add(neighbors())
    enter()
    hold('G2')
    net = bpy.context.object
    assert net.mode == 'EDIT'
    select(net, row(0, 4))
    move(0, 0, 1)
    followed()
    require_smooth('G2')
    op(bpy.ops.splinewright.release_seam, first=1, first_side='u_end', second=2, second_side='u_start')
    net = bpy.context.object
    select(net, row(0, 4))
    move(0, 0, 1)
    assert sc.seam_continuity(value()[0], 'u_end', value()[1], 'u_start').g == 0
    leave()


def test_three_in_a_row_and_a_file(tmp_path):
    add(neighbors(3))
    hold('G1', first=1, second=2)
    hold('G1', first=2, second=3)
    save(tmp_path / "held.blend")
    reopen(tmp_path / "held.blend")
    bpy.context.view_layer.objects.active = shape()
    shape().select_set(True)
    net = enter()
    select(net, row(0, 4))
    move(0, 0, 1)
    followed()
    require_smooth(first=0, second=1)
    require_smooth(first=1, second=2)
    leave()


def test_verbs_keep_it_or_say_that_they_end_it(capfd):
    add(neighbors())
    hold()
    assert len(held.read(shape().data)) == 1
    op(bpy.ops.splinewright.raise_degree, direction='V')
    assert len(held.read(shape().data)) == 1
    net = enter()
    select(net, row(0, 4))
    move(0, 0, 1)
    followed()
    require_smooth()
    leave()
    op(bpy.ops.splinewright.reverse, direction='U', piece=1)
    assert held.read(shape().data) == () and "a seam holds no more" in capfd.readouterr().out


@pytest.mark.parametrize('damage', ("{", "[1]", "[[0, \"u_end\", 9, \"u_start\", \"G1\", \"second\"]]", "[[0, 1, 2, 3, 4, 5]]", "[" * 100_000, "null", 5, [1, 2], {}))
def test_damage_is_a_sentence_and_can_be_released(damage):
    add(neighbors())
    shape().data[held.KEY] = damage
    with pytest.raises(store.UnreadableDefinition, match="release"):
        held.read(shape().data)
    net = enter()
    select(net, row(0, 4))
    move(0, 0, 1)
    assert "release" in live.problem(net)
    leave()
    assert op(bpy.ops.splinewright.raise_degree, direction='V') == {'FINISHED'}
    assert held.read(shape().data) == ()


def test_damage_is_released_in_the_panel():
    add(neighbors())
    shape().data[held.KEY] = "["
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "splinewright.release_seam" in drawn.operators and any("release it" in text for text in drawn.texts)
    op(bpy.ops.splinewright.release_seam)
    assert held.KEY not in shape().data.keys()


def test_shapes_that_are_joined_keep_what_holds_in_each():
    add(neighbors(), "other").location.y = 9
    hold('C1')
    add(neighbors())
    hold('G2')
    bpy.data.objects["other"].select_set(True)
    op(bpy.ops.splinewright.join)
    assert [(seam.first[0], seam.second[0], seam.smoothness) for seam in held.read(shape().data)] == [(0, 1, 'G2'), (2, 3, 'C1')]


def test_another_value_keeps_what_is_a_seam_in_it_and_a_plain_mesh_holds_nothing():
    add(neighbors(3))
    hold('G1', first=1, second=2)
    hold('G1', first=2, second=3)
    shape().data.splinewright.value = sc.PatchSet.from_patches([value()[0], value()[1]])
    assert len(held.read(shape().data)) == 1
    shape().data.splinewright.value = value()[0]
    assert held.read(shape().data) == () and held.KEY not in shape().data.keys()
    shape().data.splinewright.value = neighbors()
    hold()
    op(bpy.ops.splinewright.detach)
    assert held.KEY not in shape().data.keys()


def test_sides_that_are_no_edge_are_refused():
    add(neighbors())
    with pytest.raises(RuntimeError, match="not one edge"):
        bpy.ops.splinewright.hold_seam(first=1, first_side='u_start', second=2, second_side='u_start')
    with pytest.raises(RuntimeError, match="not one edge"):
        bpy.ops.splinewright.hold_seam(first=1, first_side='u_end', second=3, second_side='u_start')
    assert held.read(shape().data) == ()


def test_mirrored_seams_hold_on_the_sides_that_are_theirs_then():
    ob = add(neighbors())
    hold('G1')
    ob.scale.x = -1
    op(bpy.ops.splinewright.apply_transform)
    seam, = held.read(shape().data)
    assert (seam.first, seam.second) == ((0, 'v_end'), (1, 'v_start'))
    net = enter()
    net_rows = {int(row): vertex for vertex, row in enumerate(numbers_of(bpy.context.object).rows)}
    select(net, [net_rows[int(row)] for row in numbers_of(bpy.context.object).definition.pieces[0].indices[:, 4]])
    move(0, 0, 1)
    followed()
    assert sc.seam_continuity(value()[0], 'v_end', value()[1], 'v_start').g >= 1
    leave()


def test_a_mirrored_shape_that_is_joined_keeps_its_seams():
    other = add(neighbors(), "other")
    hold('C1')
    other.scale.x = -1
    bpy.context.view_layer.update()
    add(neighbors())
    bpy.data.objects["other"].select_set(True)
    op(bpy.ops.splinewright.join)
    seam, = held.read(shape().data)
    assert (seam.first, seam.second) == ((2, 'v_end'), (3, 'v_start'))


def cut_near_a_knot():
    """Two halves cut at 6.2 where 6.14 is a knot."""
    knots = [0, 0, 0, 0, 2, 4, 6.14, 8, 10, 10, 10, 10], [0, 0, 0, 0, 0.3, 0.6, 0.8, 1, 1, 1, 1]
    u, v = np.meshgrid(np.linspace(0, 10, 8), np.linspace(0, 4, 7), indexing='ij')
    return sc.PatchSet.from_patches(sc.NurbsPatch((3, 3), knots, np.stack([u, v, np.sin(u)], -1)).split('u', 6.2))


@pytest.mark.parametrize('continuity', ('G1', 'C1', 'G2', 'C2'))
def test_a_cut_near_a_knot_does_not_throw_the_other_half_away(continuity):
    add(cut_near_a_knot())
    hold(continuity)
    net = enter()
    before = store.read(shape().data).pool
    select(net, [row(0, -2)[3]])
    for _ in range(3):                  # in steps, as a drag comes
        move(0, 0.4, 0)
        followed()
        require_smooth(continuity)
        assert live.note(net) == ""
    change = np.abs(store.read(shape().data).pool - before).max(1)
    assert change.max() < 1.5 * 1.2 and (change > 1e-6).sum() <= 5
    leave()
    require_smooth(continuity)


def test_what_cannot_hold_as_smoothly_as_it_is_to_is_told():
    add(cut_near_a_knot())
    hold('C2')
    net = enter()
    chosen = [row(0, -3)[3], row(0, -2)[3], row(0, -1)[3], row(1, 1)[3], row(1, 2)[3]]
    select(net, chosen)
    op(bpy.ops.transform.vertex_random, offset=0.5, seed=1)
    followed()
    assert "not C2" in live.note(net) and "1 u end · 2 u start holds" in live.note(net)
    bpy.ops.ed.undo()
    followed()
    leave()


def test_a_pull_in_object_mode_tells_it_too(capfd):
    add(cut_near_a_knot())
    hold('C2')
    before = store.read(shape().data).pool
    assert op(bpy.ops.splinewright.pull_here, piece=1, parameter_u=6.17, parameter_v=0.45, vector=(0, 0, 1)) == {'FINISHED'}
    assert np.abs(store.read(shape().data).pool - before).max() < 12
    found = sc.seam_continuity(value()[0], 'u_end', value()[1], 'u_start')
    assert found.c >= 2 or "not C2" in capfd.readouterr().out
