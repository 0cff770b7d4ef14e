"""The net: Blender's own Edit Mode moves it, the shape follows, no digit is lost."""

import bmesh
import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, first_point, leave, move, numbers_of, op, require_exact, select, shown
from support import part, splinecore as sc, vertices

definitions, editing, live, net_object, selection, shape, store = (part(name) for name in (
    'core.shape.definition', 'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.net.selection',
    'bridge.shape.shape', 'bridge.data.store'))


@pytest.mark.parametrize('make', VALUES.values(), ids=VALUES)
def test_entering_and_leaving_changes_no_digit(make):
    value = make()
    ob = add(value)
    before = shown(ob).copy()
    assert net_object.is_net(enter()) and bpy.context.mode.startswith('EDIT')
    assert leave() == ob and bpy.context.mode == 'OBJECT'
    assert ob.data.splinewright.value == value and np.array_equal(shown(ob), before)
    assert not [ob for ob in bpy.data.objects if net_object.is_net(ob)]


POINTS_ONLY = [name for name in VALUES if 'hermite' not in name and name not in ('cubic', 'many curves', 'ferguson', 'mixed set')]


@pytest.mark.parametrize('name', POINTS_ONLY)
def test_a_moved_point_is_one_row_of_the_pool_and_all_others_keep_their_digits(name):
    ob = add(VALUES[name]())
    before = store.read(ob.data)
    held = enter()
    vertex = first_point(held)
    row = numbers_of(held).rows[vertex]
    select(held, vertex)
    move(0, 0, 1.5)
    leave()
    ob = bpy.data.objects["shape"]
    after = store.read(ob.data)
    assert np.flatnonzero((before.pool != after.pool).any(1)).tolist() == [row]
    assert np.isclose(after.pool[row, 2], before.pool[row, 2] + 1.5, atol=1e-6)
    require_exact(ob)


@pytest.mark.parametrize('name', VALUES)
def test_moving_the_whole_net_moves_points_and_leaves_directions(name):
    ob = add(VALUES[name]())
    before = store.read(ob.data)
    held = enter()
    select(held, *range(len(numbers_of(held).rows)))
    move(0.5, 0.25, -2)
    leave()
    ob = bpy.data.objects["shape"]
    after = part('core.shape.transform').transformed(before, [[1, 0, 0, 0.5], [0, 1, 0, 0.25], [0, 0, 1, -2], [0, 0, 0, 1]])
    ours, expected = store.read(ob.data), shape.evaluated(ob.data, after).points
    assert np.allclose(shown(ob), expected, atol=2e-5)
    assert len(ours.pieces) == len(before.pieces)
    require_exact(ob)


def test_a_drag_is_followed_while_it_lasts_and_undone_step_by_step():
    value = VALUES['nurbs patch']()
    ob = add(value)
    held = enter()
    vertex = first_point(held)
    select(held, vertex)
    heights = [store.read(ob.data).pool[0, 2]]
    for _ in range(3):
        move(0, 0, 0.5)
        heights.append(store.read(bpy.data.objects["shape"].data).pool[0, 2])
    assert np.allclose(np.diff(heights), 0.5, atol=1e-6)
    for expected in heights[-2::-1]:
        bpy.ops.ed.undo()
        ob = bpy.data.objects["shape"]
        assert store.read(ob.data).pool[0, 2] == expected and bpy.context.mode == 'EDIT_MESH'
        assert np.array_equal(vertices(ob.data), shape.evaluated(ob.data, store.read(ob.data)).points)
    assert ob.data.splinewright.value == value
    for expected in heights[1:]:
        bpy.ops.ed.redo()
        assert store.read(bpy.data.objects["shape"].data).pool[0, 2] == expected
    leave()
    require_exact(bpy.data.objects["shape"])
    assert not shape.is_touched(bpy.data.objects["shape"].data)


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs', 'hermite', 'cubic', 'teapot'))
def test_undo_and_redo_cross_the_border_of_edit_mode(name):
    value = VALUES[name]()
    add(value)
    held = enter()
    select(held, first_point(held))
    move(1, 0, 0)
    leave()
    moved = bpy.data.objects["shape"].data.splinewright.value
    assert moved != value

    def state():
        editing.sweep()
        nets = [ob for ob in bpy.data.objects if net_object.is_net(ob)]
        ob = bpy.data.objects["shape"]
        require_exact(ob)
        return bool(nets), ob.data.splinewright.value == moved, ob.data.splinewright.value == value

    ladder = [(True, True, False), (True, False, True), (True, False, True), (False, False, True)]
    assert state() == (False, True, False)
    for expected in ladder:
        bpy.ops.ed.undo()
        assert state() == expected
    for expected in [*ladder[-2::-1], (False, True, False)]:
        bpy.ops.ed.redo()
        assert state() == expected


def test_leaving_by_blenders_own_tab_is_swept():
    value = VALUES['bezier patch']()
    add(value)
    held = enter()
    select(held, first_point(held))
    move(1, 0, 0)
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    ob = bpy.data.objects["shape"]
    assert bpy.context.object == ob and len(bpy.data.objects) == 1 and len(bpy.data.meshes) == 1
    assert ob.data.splinewright.value != value
    require_exact(ob)


def test_weights_are_an_attribute_of_the_cage_and_the_w_of_a_curve():
    for name in ('nurbs patch', 'nurbs'):
        value = VALUES[name]()
        ob = add(value)
        held = enter()
        if held.type == 'CURVE':
            point = held.data.splines[0].points[2]
            point.co = (*point.co[:3], 3.0)
        else:
            mesh = bmesh.from_edit_mesh(held.data)
            mesh.verts.ensure_lookup_table()
            mesh.verts[2][mesh.verts.layers.float['weight']] = 3.0
            bmesh.update_edit_mesh(held.data)
        held.data.update_tag()
        bpy.context.view_layer.update()
        ob = bpy.data.objects[ob.name]
        pool = store.read(ob.data).pool
        assert pool[2, 3] == 3.0 and np.array_equal(np.delete(pool, 2, 0), np.delete(
            definitions.from_value(value).pool, 2, 0))
        leave()
        require_exact(bpy.data.objects[ob.name])
        bpy.data.objects.remove(bpy.data.objects[ob.name])


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs', 'hermite', 'hermite patch', 'cubic'))
def test_typed_numbers_are_kept_in_double_precision(name):
    add(VALUES[name]())
    held = enter()
    vertex = first_point(held)
    select(held, vertex)
    numbers = list(held.data.splinewright_points.numbers)
    numbers[0], numbers[1] = 0.1, 1.7
    held.data.splinewright_points.numbers = numbers
    bpy.context.view_layer.update()
    leave()
    ob = bpy.data.objects["shape"]
    row = store.read(ob.data).pool[0]
    assert row[0] == 0.1 and row[1] == 1.7
    require_exact(ob)


def test_the_weight_of_all_selected_points_is_one_number():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 0, 1, 5)
    assert held.data.splinewright_points.weight == 1.0
    held.data.splinewright_points.weight = 0.3
    bpy.context.view_layer.update()
    leave()
    assert (store.read(bpy.data.objects["shape"].data).pool[[0, 1, 5], 3] == 0.3).all()


def test_a_weight_of_zero_is_refused_with_a_word_and_the_shape_waits():
    value = VALUES['nurbs patch']()
    add(value)
    held = enter()
    select(held, 3)
    held.data.splinewright_points.weight = 0.0
    bpy.context.view_layer.update()
    assert "weight of 0" in live.problem(held)
    assert bpy.data.objects["shape"].data.splinewright.value == value


def test_points_are_told_by_their_number_not_by_their_order():
    value = VALUES['nurbs patch']()
    add(value)
    held = enter()
    select(held, *range(len(numbers_of(held).rows)))
    bpy.ops.mesh.sort_elements('EXEC_DEFAULT', True, type='REVERSE', elements={'VERT'})
    bpy.context.view_layer.update()
    assert live.problem(held) == "" and bpy.data.objects["shape"].data.splinewright.value == value


def test_several_shapes_are_edited_at_once():
    obs = [add(VALUES['nurbs patch'](), "a"), add(VALUES['teapot'](), "b"), add(VALUES['nurbs'](), "c")]
    for ob in obs:
        ob.select_set(True)
    bpy.context.view_layer.objects.active = obs[0]
    before = [ob.data.splinewright.value for ob in obs]
    enter()
    held = bpy.context.objects_in_mode
    assert sorted(net_object.shape_of(ob).name for ob in held) == ["a", "b"], "only shapes of one kind"
    for ob in held:
        select(ob, 0)
    move(0, 0, 1)
    bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    assert bpy.context.object.name == "a" and {ob.name for ob in bpy.context.selected_objects} == {"a", "b", "c"}
    after = [bpy.data.objects[name].data.splinewright.value for name in "abc"]
    assert after[0] != before[0] and after[1] != before[1] and after[2] == before[2]
    for name in "ab":
        require_exact(bpy.data.objects[name])


def test_tab_lets_other_objects_alone():
    cube = bpy.data.objects.new("cube", bpy.data.meshes.new("cube"))
    bpy.context.scene.collection.objects.link(cube)
    bpy.context.view_layer.objects.active = cube
    assert not bpy.ops.splinewright.edit_net.poll() and not bpy.ops.splinewright.leave_net.poll()


KNOTS = "0 0 0 0 0.125 0.75 1 1 1 1"


def test_knots_are_edited_as_text_in_the_net_and_undone():
    value = VALUES['nurbs']()
    add(value)
    held = enter()
    select(held, 2)
    move(0, 0, 1)
    assert bpy.ops.splinewright.set_knots('EXEC_DEFAULT', True, knots=KNOTS) == {'FINISHED'}
    assert bpy.context.mode == 'EDIT_CURVE' and net_object.is_net(bpy.context.object)
    assert selection.selected(bpy.context.object, numbers_of(bpy.context.object)) == [2]
    changed = bpy.data.objects["shape"].data.splinewright.value
    assert " ".join(f"{knot:g}" for knot in changed.knots) == KNOTS
    require_exact(bpy.data.objects["shape"])
    bpy.ops.ed.undo()
    editing.sweep()
    ob = bpy.data.objects["shape"]
    assert np.array_equal(ob.data.splinewright.value.knots, value.knots)
    assert np.array_equal(ob.data.splinewright.value.points, changed.points)
    assert bpy.context.mode == 'EDIT_CURVE'
    bpy.ops.ed.redo()
    assert bpy.data.objects["shape"].data.splinewright.value == changed


@pytest.mark.parametrize('text,word', (
    ("0 0 0 0 1 2 2 2 2", "9 knots were given, 10 are needed"), ("0 0 0 0 x 1 2 2 2 2", "'x', word 5"),
    ("0 0 0 0 3 2 4 4 4 4", "knot 6, 2, is smaller than the one before it, 3"), ("0 0 0 0 nan 2 4 4 4 4", "nan"), ("", "0 knots")))
def test_wrong_knots_are_refused_with_a_word_and_nothing_changes(text, word):
    value = VALUES['nurbs']()
    add(value)
    enter()
    with pytest.raises(RuntimeError, match=word):
        bpy.ops.splinewright.set_knots('EXEC_DEFAULT', True, knots=text)
    assert bpy.data.objects["shape"].data.splinewright.value == value and bpy.context.mode == 'EDIT_CURVE'


def test_the_knots_of_any_piece_and_axis_are_set_and_pieces_are_counted_from_one():
    ob = add(VALUES['mixed set']())
    assert op(bpy.ops.splinewright.set_knots, piece=1, axis='V', knots="0 2 4") == {'FINISHED'}
    assert ob.data.splinewright.value[0].parameters[1].tolist() == [0, 2, 4]
    for piece, word in ((2, "a Bezier piece has no knots"), (3, "the shape has 2 pieces, there is none of number 3")):
        with pytest.raises(RuntimeError, match=word):
            op(bpy.ops.splinewright.set_knots, piece=piece, knots="0 1")
    add(VALUES['nurbs'](), "one")
    with pytest.raises(RuntimeError, match="the shape has 1 piece, there is none of number 2"):
        op(bpy.ops.splinewright.set_knots, piece=2, knots="0 1")


def test_what_else_was_selected_is_selected_again():
    cube = bpy.data.objects.new("cube", bpy.data.meshes.new("cube"))
    bpy.context.scene.collection.objects.link(cube)
    ob = add(VALUES['nurbs patch']())
    cube.select_set(True)
    enter()
    assert not cube.select_get()
    assert leave() == ob and {one.name for one in bpy.context.selected_objects} == {"cube", "shape"}


def test_a_net_that_blender_cannot_hold_is_refused_and_nothing_changes():
    far = sc.BezierCurve([(0, 0), (1e39, 0), (1, 0)], [1, 1e-39, 1])
    ob = add(far)
    with pytest.raises(RuntimeError, match="farther away than Blender's Edit Mode reaches"):
        op(bpy.ops.splinewright.edit_net)
    assert ob.data.splinewright.value == far and [one.name for one in bpy.data.objects] == ["shape"]


def test_a_direction_at_infinity_is_the_head_of_an_arrow():
    ob = add(VALUES['semicircle']())
    held = enter()
    numbers = numbers_of(held)
    (foot, head), = numbers.arrows
    assert np.array_equal(numbers.positions[foot], (0, 0, 0)) and np.array_equal(numbers.positions[head], (0, 1, 0))
    select(held, head)
    move(0, 1, 0)
    assert store.read(ob.data).pool.tolist() == [[1, 0, 0, 1], [0, 2, 0, 0], [-1, 0, 0, 1]]
    half_ellipse = bpy.data.objects["shape"].data.splinewright.value
    assert np.allclose(half_ellipse.evaluate(0.5), (0, 2, 0), atol=1e-12)
    select(held, foot, head)
    move(5, 5, 5)
    assert bpy.data.objects["shape"].data.splinewright.value == half_ellipse, "an arrow may stand anywhere"
    require_exact(leave())


def test_symmetry_moves_the_other_half_too():
    x, y = np.meshgrid([-1, -0.5, 0.5, 1], [-1, 0, 1], indexing='ij')
    ob = add(part('core.base.library').sc.BezierPatch(np.stack([x, y, 0 * x], -1)))
    held = enter()
    held.data.use_mirror_x = True
    select(held, 0)
    bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0.25, 0, 1), mirror=True)
    pool = store.read(ob.data).pool
    assert np.allclose(pool[0], (-0.75, -1, 1, 1)) and np.allclose(pool[9], (0.75, -1, 1, 1))
    assert np.array_equal(np.delete(pool, (0, 9), 0)[:, 2], np.zeros(10))
    require_exact(leave())


def test_smooth_joints_of_a_chain_stay_smooth_when_a_handle_is_turned():
    ob = add(VALUES['hermite']())
    held = enter()
    point = held.data.splines[0].bezier_points[1]
    assert point.handle_left_type == 'ALIGNED'
    right = int(np.flatnonzero(numbers_of(held).rows == store.read(ob.data).pieces[0].indices[2][1])[0])
    select(held, right)
    move(0.1, 0.2, 0.3)
    leave()
    incoming, outgoing = bpy.data.objects["shape"].data.splinewright.value.tangents[1]
    directions = incoming / np.linalg.norm(incoming), outgoing / np.linalg.norm(outgoing)
    assert np.allclose(*directions, atol=1e-5)


@pytest.mark.parametrize('name', ('nurbs', 'quintic', 'hermite', 'cubic', 'many curves'))
def test_switching_the_direction_of_a_net_changes_no_digit(name):
    value = VALUES[name]()
    ob = add(value)
    enter()
    bpy.ops.curve.select_all(action='SELECT')
    bpy.ops.curve.switch_direction('EXEC_DEFAULT', True)
    bpy.context.view_layer.update()
    assert live.problem(bpy.context.object) == "" and ob.data.splinewright.value == value
    leave()
    require_exact(ob)


@pytest.mark.parametrize('kind', ('nurbs', 'hermite', 'cubic'))
def test_after_switching_the_direction_a_typed_number_goes_to_the_point_that_is_selected(kind):
    value = VALUES[kind]()
    ob = add(value)
    held = enter()
    bpy.ops.curve.select_all(action='SELECT')
    bpy.ops.curve.switch_direction('EXEC_DEFAULT', True)
    bpy.context.view_layer.update()
    are_points = np.flatnonzero(numbers_of(held).are_points)
    bpy.ops.curve.select_all(action='DESELECT')
    select(held, int(are_points[-1]))
    numbers = list(held.data.splinewright_points.numbers)
    numbers[2] = 4.25
    held.data.splinewright_points.numbers = numbers
    bpy.context.view_layer.update()
    points, before = (d.pool[numbers_of(held).rows[are_points]] for d in (store.read(ob.data), definitions.from_value(value)))
    assert (points[:, 2] == 4.25).sum() == 1 and np.array_equal(points[0], before[0]) and live.problem(held) == ""


def test_points_of_a_curve_that_were_deleted_and_others_added_are_not_taken_for_them():
    value = VALUES['nurbs']()
    ob = add(value)
    held = enter()
    select(held, 1)
    bpy.ops.curve.delete('EXEC_DEFAULT', True, type='VERT')
    bpy.ops.curve.select_all(action='DESELECT')
    held.data.splines[0].points[-1].select = True
    bpy.ops.curve.extrude('EXEC_DEFAULT', True)
    bpy.context.view_layer.update()
    assert live.problem(held) == "" and "not of this net" in live.note(held)
    assert len(ob.data.splinewright.value.points) == len(value.points) - 1


def test_a_point_of_a_chain_is_moved_and_its_tangents_keep_their_digits():
    value = VALUES['hermite']()
    ob = add(value)
    held = enter()
    point = int(np.flatnonzero(numbers_of(held).rows == store.read(ob.data).pieces[0].indices[0][1])[0])
    select(held, point - 1, point, point + 1)
    move(0.1, 0.2, 0.3)
    leave()
    after = bpy.data.objects["shape"].data.splinewright.value
    assert not np.array_equal(after.points[1], value.points[1]) and np.array_equal(after.tangents, value.tangents)


def test_a_joint_that_is_broken_stays_broken():
    points, tangents = [(0, 0, 0), (.01, 0, 0), (5, 1, 0), (10, 0, 0)], [(1, 0, 0), (1, 0, 0), (1, 0, 0), (1, -.5, 0)]
    ob = add(part('core.base.library').sc.HermiteCurve(points, tangents, [0, .01, 5, 10]))
    held = enter()
    joint = held.data.splines[0].bezier_points[2]
    joint.handle_left_type = joint.handle_right_type = 'FREE'
    joint.handle_right.y += 0.004
    held.data.update_tag()
    bpy.context.view_layer.update()
    incoming, outgoing = ob.data.splinewright.value.tangents[2]
    assert incoming.tolist() == [1, 0, 0] and abs(outgoing[1]) > 1e-4
    leave()


def test_knots_of_a_net_that_lost_points_are_refused():
    value = VALUES['nurbs patch']()
    ob = add(value)
    held = enter()
    select(held, 0)
    bpy.ops.mesh.delete('EXEC_DEFAULT', True, type='VERT')
    with pytest.raises(RuntimeError, match="lost points"):
        bpy.ops.splinewright.set_knots('EXEC_DEFAULT', True, knots=KNOTS)
    assert net_object.is_net(bpy.context.object) and ob.data.splinewright.value == value
