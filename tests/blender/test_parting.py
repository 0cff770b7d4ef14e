"""Pieces are deleted and separated, and shapes are exploded, with all that lies on them."""

import bpy
import numpy as np
import pytest

from curves import run
from patches import meetings, value_of
from shapes import VALUES, activate, add, enter, leave, op, require_exact
from support import part, splinecore as sc

Look, replacing = part('bridge.data.shading').Look, part('bridge.edit.replace_pieces')
hand, recipes, selection, shape, store, live = (part(name) for name in (
    'ui.active_shape', 'bridge.recipes.recipes', 'bridge.net.selection', 'bridge.shape.shape', 'bridge.data.store', 'bridge.net.live'))


def pieces(ob):
    value = ob.data.splinewright.value
    return list(value) if hasattr(value, '__len__') else [value]


def others(ob):
    return [each for each in bpy.data.objects if each != ob and shape.has_shape(each)]


def painted(ob):
    """A material of its own for each piece."""
    for i in range(len(pieces(ob))):
        ob.data.materials.append(bpy.data.materials.new(f"m{i}"))
    replacing.give_looks(ob.data, [Look(material_index=i) for i in range(len(pieces(ob)))])


def materials_of(ob):
    return {ob.data.materials[face.material_index].name for face in ob.data.polygons}


@pytest.mark.parametrize('number', (1, 3, 4))
def test_a_patch_is_separated_with_its_material_and_the_others_go_on_sharing(number):
    before = value_of('four around a corner')
    ob = add(before)
    painted(ob)
    ob.modifiers.new("wall", 'SOLIDIFY')
    assert run('separate_pieces', piece=number) == {'FINISHED'}
    new, = others(ob)
    kept = [i for i in range(4) if i != number - 1]
    assert [patch == before[i] for patch, i in zip(ob.data.splinewright.value, kept)] == [True] * 3
    assert pieces(new) == [before[number - 1]]
    assert materials_of(new) == {f"m{number - 1}"} and materials_of(ob) == {f"m{i}" for i in kept}
    assert [modifier.type for modifier in new.modifiers] == ['SOLIDIFY']
    assert np.array_equal(new.matrix_world, ob.matrix_world) and new.users_collection == ob.users_collection
    full = before.edge_counts()['shared']
    assert ob.data.splinewright.value.edge_counts()['shared'] < full
    require_exact(ob)
    require_exact(new)
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before and len(bpy.data.objects) == 1


def test_a_patch_is_deleted_and_the_last_one_is_not():
    ob = add(value_of('four around a corner'))
    before = ob.data.splinewright.value
    for left in (3, 2, 1):
        assert run('delete_pieces', piece=1) == {'FINISHED'}
        assert len(pieces(ob)) == left
        require_exact(ob)
    assert pieces(ob) == [before[3]]
    with pytest.raises(RuntimeError, match="delete the object"):
        run('delete_pieces', piece=1)
    with pytest.raises(RuntimeError, match="nothing to separate"):
        run('separate_pieces', piece=1)
    assert pieces(ob) == [before[3]]


@pytest.mark.parametrize('operator', ('delete_pieces', 'separate_pieces'))
def test_a_piece_that_is_not_there_is_refused(operator):
    ob = add(value_of('four around a corner'))
    before = ob.data.splinewright.value
    with pytest.raises(RuntimeError, match="none of number 7"):
        run(operator, piece=7)
    assert ob.data.splinewright.value == before


@pytest.mark.parametrize('kind', ('teapot', 'four around a corner', 'many curves', 'mixed set'))
def test_exploded_shapes_are_its_pieces_to_the_last_digit_and_joined_again_they_are_as_before(kind):
    ob = add(VALUES[kind]() if kind in VALUES else value_of(kind))
    before = pieces(ob)
    assert op(bpy.ops.splinewright.explode) == {'FINISHED'}
    found = [pieces(each) for each in [ob, *others(ob)]]
    assert all(len(each) == 1 for each in found) and len(found) == len(before)
    assert all(any(one == each for each, in found) for one in before)
    for each in [ob, *others(ob)]:
        require_exact(each)
        each.select_set(True)
    activate(ob)
    for each in others(ob):
        each.select_set(True)
    assert bpy.ops.splinewright.join('EXEC_DEFAULT', True) == {'FINISHED'}
    assert len(pieces(ob)) == len(before)


def test_a_curve_keeps_its_radii_and_materials():
    ob = add(VALUES['many curves']())
    before = pieces(ob)
    for i, spline in enumerate(ob.data.splines):
        for point in spline.points:
            point.radius = 1.0 + i
    op(bpy.ops.splinewright.separate_pieces, piece=2)
    new, = others(ob)
    assert pieces(new) == [before[1]]
    assert {round(point.radius, 5) for spline in new.data.splines for point in spline.points} == {2.0}
    require_exact(new)


def select_rows(net, rows):
    session = live.known_session(net.data)
    vertices = np.flatnonzero(np.isin(session.net.rows, rows))
    selection.select(net, session.net, vertices)
    part('bridge.data.file_state').state.selected.clear()


def test_in_a_net_the_patches_whose_points_are_all_selected():
    ob = add(value_of('four around a corner'))
    before = ob.data.splinewright.value
    net = enter()
    definition = live.known_session(net.data).net.definition
    select_rows(net, definition.pieces[2].indices.ravel())
    assert hand.whole_pieces(net) == [2]
    assert bpy.ops.splinewright.separate_pieces('EXEC_DEFAULT', True) == {'FINISHED'}
    assert bpy.context.mode.startswith('EDIT')
    leave()
    new, = others(ob)
    assert pieces(new) == [before[2]] and pieces(ob) == [before[0], before[1], before[3]]
    require_exact(ob)


def test_in_a_net_a_point_of_one_patch_alone_is_enough():
    ob = add(value_of('four around a corner'))
    before = ob.data.splinewright.value
    net = enter()
    select_rows(net, [live.known_session(net.data).net.definition.pieces[1].indices[1, 1]])
    assert bpy.ops.splinewright.delete_pieces('EXEC_DEFAULT', True) == {'FINISHED'}
    leave()
    assert pieces(ob) == [before[0], before[2], before[3]]


def test_in_a_net_with_a_point_that_patches_share_it_says_what_to_select():
    ob = add(value_of('four around a corner'))
    net = enter()
    definition = live.known_session(net.data).net.definition
    select_rows(net, np.intersect1d(definition.pieces[0].indices, definition.pieces[1].indices)[:1])
    with pytest.raises(RuntimeError, match="select a point that no other piece has"):
        bpy.ops.splinewright.delete_pieces('EXEC_DEFAULT', True)


def test_what_follows_is_not_taken_apart():
    curve = add(VALUES['nurbs']())
    assert op(bpy.ops.splinewright.follow_object) == {'FINISHED'}
    with pytest.raises(RuntimeError, match="follows another object"):
        op(bpy.ops.splinewright.delete_pieces, piece=1)
    assert curve.data.splinewright.value is not None
