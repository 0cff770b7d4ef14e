"""The net of a recipe through points gains and loses points by Blender's own tools; no digit is lost."""

import bpy
import numpy as np
import pytest

from shapes import enter, leave, move, numbers_of, op, require_exact, select
from support import part

editing, live, net_object, selection, net_props, recipes, table, definitions = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.net.selection', 'ui.net_props', 'bridge.recipes.recipes',
    'core.recipes.table', 'core.shape.definition'))
ANY_COUNT = [recipe.kind for recipe in table.STARTING if recipe.has_any_count]
CLOSING = [kind for kind in ANY_COUNT if table.RECIPES[kind].can_close]
FIXED_COUNT = [recipe.kind for recipe in table.STARTING if recipe.points and not recipe.can_gain_points]
#: Numbers that float32 does not hold.
THIRD = 1 / 3


def add_recipe(kind='catmull_rom', **settings):
    """A shape of 5 points, or more, that have digits of float64, in its net."""
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings) == {'FINISHED'}
    ob = bpy.context.object
    ob.name = ob.data.name = "shape"
    points = recipes.points(ob.data)
    part('bridge.shape.recipe_edit').set_points(ob.data, points * THIRD + 0.1)
    bpy.ops.ed.undo_push(message="add")
    assert (recipes.points(ob.data) != recipes.points(ob.data).astype(np.float32)).any()
    return ob, recipes.points(ob.data), enter()


def shape_now():
    return bpy.data.objects["shape"]


def points_now():
    return recipes.points(shape_now().data)


def curve_op(name, **settings):
    """One of Blender's own operators, and what follows it."""
    assert op(getattr(bpy.ops.curve, name), **settings) == {'FINISHED'}
    bpy.context.view_layer.update()


def extrude(x, y, z):
    curve_op('extrude_move', CURVE_OT_extrude={'mode': 'TRANSLATION'}, TRANSFORM_OT_translate={'value': (x, y, z)})


def select_all():
    bpy.ops.curve.select_all(action='SELECT')


def problem():
    return live.problem(bpy.context.object)


def require_sound(count):
    """The shape has so many points, those of the net, and is exact; the panel counts them, too."""
    ob, held = shape_now(), bpy.context.object
    assert problem() == "" and len(points_now()) == count
    recipe = recipes.of(ob.data)
    made = recipe.make(points_now(), **recipes.parameters(ob.data)).value
    assert ob.data.splinewright.value == (definitions.to_value(made) if isinstance(made, definitions.Definition) else made)
    require_exact(ob)
    in_blender = np.array([point.co[:3] for point in held.data.splines[0].points])
    assert np.array_equal(in_blender.astype(np.float32), points_now().astype(np.float32))
    assert len(numbers_of(held).rows) == count == len(live.session(held.data).state.positions)


@pytest.mark.parametrize('kind', ANY_COUNT)
def test_a_point_is_extruded_at_either_end_and_the_others_keep_their_digits(kind):
    _, before, held = add_recipe(kind)
    select(held, 4)
    extrude(0.5, 0.25, 0)
    require_sound(6)
    assert np.array_equal(points_now()[:5], before)
    assert np.allclose(points_now()[5], before[4] + (0.5, 0.25, 0), atol=1e-6)
    assert net_props.chosen(bpy.context.object.data)[1] == [5]
    select(bpy.context.object, 0)
    extrude(-0.5, 0, 0)
    require_sound(7)
    assert np.array_equal(points_now()[1:6], before)
    leave()
    require_exact(shape_now())
    assert np.array_equal(points_now()[1:6], before) and recipes.kind(shape_now().data) == kind


@pytest.mark.parametrize('kind', ANY_COUNT)
def test_subdividing_puts_points_between_and_deleting_takes_any_away(kind):
    _, before, held = add_recipe(kind)
    select_all()
    curve_op('subdivide')
    require_sound(9)
    assert np.array_equal(points_now()[::2], before)
    assert np.allclose(points_now()[1::2], (before[1:] + before[:-1]) / 2, atol=1e-6)
    select(held, 1, 2, 3, 8)
    curve_op('delete', type='VERT')
    require_sound(5)
    assert np.array_equal(points_now()[[0, 1, 3]], before[[0, 2, 3]])
    select(held, 1)
    curve_op('dissolve_verts')
    require_sound(4)
    assert np.array_equal(points_now()[[0, 2]], before[[0, 3]])


def test_points_drawn_in_a_new_spline_of_ones_own():
    """Seven points that are set, one after the other."""
    _, before, held = add_recipe()
    wanted = [(x, y, 0) for x, y in ((0, 0), (1, 2), (2, 1), (3, 3), (4, 0), (5, 1), (6, 2))]
    select(held, 1, 2, 3, 4)
    op(bpy.ops.curve.delete, type='VERT')
    assert problem() and len(points_now()) == 5
    select(bpy.context.object, 0)
    move(*(wanted[0] - before[0]))
    for point in wanted[1:]:
        curve_op('vertex_add', location=point)
    require_sound(7)
    assert np.allclose(points_now(), wanted, atol=1e-6)
    leave()
    assert np.allclose(points_now(), wanted, atol=1e-6)


@pytest.mark.parametrize('kind', ANY_COUNT)
def test_too_few_points_leave_the_last_good_shape_and_say_why(kind):
    _, before, held = add_recipe(kind)
    least, value = None, None
    for count in (4, 3, 2, 1):
        select(held, count)
        op(bpy.ops.curve.delete, type='VERT')
        if problem():
            assert "a curve needs two points" in problem() and shape_now().data.splinewright.value == value
            assert len(numbers_of(held).rows) == count
        else:
            require_sound(count)
            least, value = count, shape_now().data.splinewright.value
    assert least == 2 and np.array_equal(points_now(), before[:least])
    select(held, 0)
    op(bpy.ops.curve.delete, type='VERT')
    assert "no points left" in problem() and shape_now().data.splinewright.value == value
    leave()
    assert shape_now().data.splinewright.value == value and len(bpy.data.objects) == 1
    require_exact(shape_now())


@pytest.mark.parametrize('kind', CLOSING)
def test_toggle_cyclic_closes_the_recipe_and_the_panel_closes_the_net(kind):
    ob, before, held = add_recipe(kind)
    opened = ob.data.splinewright.value
    select_all()
    curve_op('cyclic_toggle')
    require_sound(5)
    assert recipes.parameters(ob.data)['closed'] is True and np.array_equal(points_now(), before)
    closed = ob.data.splinewright.value
    assert closed != opened
    setattr(ob.data.splinewright_parameters, f"{kind}_closed", False)
    bpy.context.view_layer.update()
    assert not held.data.splines[0].use_cyclic_u and ob.data.splinewright.value == opened and problem() == ""
    setattr(ob.data.splinewright_parameters, f"{kind}_closed", True)
    bpy.context.view_layer.update()
    select(held, 4)
    move(0.25, 0, 0)
    assert recipes.parameters(shape_now().data)['closed'] is True and shape_now().data.splinewright.value != closed
    leave()
    assert enter().data.splines[0].use_cyclic_u
    require_sound(5)
    select(bpy.context.object, 0, 1, 2)
    curve_op('delete', type='VERT')
    assert "3" in problem() and len(points_now()) == 5


def test_closing_in_the_panel_is_undone_and_redone_in_the_net():
    ob, before, held = add_recipe()
    ob.data.splinewright_parameters.catmull_rom_closed = True
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="Closed")
    for step, closed in ((bpy.ops.ed.undo, False), (bpy.ops.ed.redo, True)):
        step()
        assert recipes.parameters(shape_now().data)['closed'] is closed
        require_sound(5)


def test_points_that_were_refused_are_taken_when_a_number_lets_them_fit():
    _, _, held = add_recipe('osculating')
    select(held, 0, 1, 2, 3)
    curve_op('subdivide')
    assert "9 points are not" in problem() and len(points_now()) == 6
    shape_now().data.splinewright_parameters.osculating_derivatives = 2
    bpy.context.view_layer.update()
    require_sound(9)


def test_a_recipe_that_cannot_close_says_so_and_goes_on_when_its_net_is_open_again():
    ob, before, held = add_recipe('polynomial')
    value = ob.data.splinewright.value
    select_all()
    curve_op('cyclic_toggle')
    assert "Polynomial Through Points cannot be closed" in problem() and ob.data.splinewright.value == value
    curve_op('cyclic_toggle')
    require_sound(5)


@pytest.mark.parametrize('kind', ANY_COUNT)
def test_switching_the_direction_turns_the_points_over_with_all_digits(kind):
    _, before, held = add_recipe(kind)
    select_all()
    curve_op('switch_direction')
    require_sound(5)
    assert np.array_equal(points_now(), before[::-1])
    select(held, 0)
    assert np.allclose(held.data.splinewright_points.numbers[:3], before[4], atol=1e-6)
    extrude(0, 0, 0.5)
    require_sound(6)
    assert np.array_equal(points_now()[1:], before[::-1])
    select_all()
    curve_op('switch_direction')
    require_sound(6)
    assert np.array_equal(points_now()[:5], before)


def test_several_splines_wait_until_they_are_one_again():
    ob, before, held = add_recipe()
    value = ob.data.splinewright.value
    select(held, 1, 2)
    curve_op('duplicate_move', TRANSFORM_OT_translate={'value': (0, 0, 1)})
    assert "2 splines" in problem() and ob.data.splinewright.value == value
    assert len(numbers_of(held).rows) == 7 and net_props.chosen(held.data)[1] == [5, 6]
    bpy.ops.ed.undo()
    assert problem() == "" and shape_now().data.splinewright.value == value
    select(bpy.context.object, 2, 3)
    curve_op('delete', type='SEGMENT')
    assert "2 splines" in problem()
    curve_op('make_segment')
    require_sound(5)
    assert np.array_equal(points_now(), before) or np.array_equal(points_now(), before[::-1])


def test_copies_in_one_place_have_the_digits_of_what_they_copy():
    """Uniform, since equal points have no other parameters."""
    _, before, held = add_recipe(parametrisation='uniform')
    select(held, 2)
    curve_op('extrude', mode='INIT')
    assert problem() == "" and np.array_equal(points_now(), before[[0, 1, 2, 2, 2, 3, 4]])


def test_a_spline_of_another_type_and_weights_are_refused_with_a_word():
    ob, before, held = add_recipe()
    value = ob.data.splinewright.value
    for kind in ('BEZIER', 'NURBS'):
        select_all()
        curve_op('spline_type_set', type=kind)
        assert "another type" in problem() and ob.data.splinewright.value == value
        net_props.chosen(held.data)
        bpy.ops.ed.undo()
        ob, held = shape_now(), bpy.context.object
        assert problem() == ""
    select(held, 1)
    held.data.splinewright_points.weight = 2.0
    bpy.context.view_layer.update()
    assert "no weights" in problem() and ob.data.splinewright.value == value


def test_points_keep_their_digits_where_their_tilts_were_cleared():
    _, before, held = add_recipe()
    select_all()
    curve_op('tilt_clear')
    require_sound(5)
    assert np.array_equal(points_now(), before)


def test_typed_numbers_of_new_points_are_kept_in_double_precision():
    _, before, held = add_recipe()
    select(held, 4)
    extrude(1, 0, 0)
    extrude(1, 0, 0)
    numbers = list(held.data.splinewright_points.numbers)
    numbers[:2] = 0.1, 1.7
    held.data.splinewright_points.numbers = numbers
    bpy.context.view_layer.update()
    require_sound(7)
    assert points_now()[6, :2].tolist() == [0.1, 1.7] and np.array_equal(points_now()[:5], before)
    select(held, 5)
    held.data.splinewright_points.numbers = [0.3, *held.data.splinewright_points.numbers[1:]]
    bpy.context.view_layer.update()
    assert points_now()[5, 0] == 0.3 and points_now()[6, :2].tolist() == [0.1, 1.7]
    select(held, 0)
    op(bpy.ops.curve.delete, type='VERT')
    require_sound(6)
    assert points_now()[4, 0] == 0.3 and points_now()[5, :2].tolist() == [0.1, 1.7]


def test_undo_and_redo_cross_changes_of_the_count_and_the_border_of_edit_mode():
    _, _, held = add_recipe()
    states = [points_now()]
    select(held, 4)
    extrude(0.5, 0.5, 0)
    states.append(points_now())
    select_all()
    curve_op('subdivide')
    states.append(points_now())
    curve_op('cyclic_toggle')
    states.append(points_now())
    bpy.ops.ed.undo_push(message="closed")
    select(held, 1, 3)
    curve_op('delete', type='VERT')
    states.append(points_now())
    leave()
    assert [len(points) for points in states] == [5, 6, 11, 11, 9]

    def found():
        editing.sweep()
        ob = shape_now()
        require_exact(ob)
        if net_object.is_net(bpy.context.object):
            require_sound(len(points_now()))
        return next(i for i, points in enumerate(states) if np.array_equal(points, points_now()))

    seen = [found()]
    for _ in range(30):
        if bpy.ops.ed.undo.poll():
            bpy.ops.ed.undo()
            seen.append(found())
            if seen[-1] == 0 and not net_object.is_net(bpy.context.object):
                break
    assert seen == sorted(seen, reverse=True) and set(seen) >= {0, 1, 2, 4}
    assert not recipes.parameters(shape_now().data)['closed']
    back = [found()]
    for _ in range(len(seen) - 1):
        bpy.ops.ed.redo()
        back.append(found())
    assert back == seen[::-1] and recipes.parameters(shape_now().data)['closed'] is True


@pytest.mark.parametrize('kind', ANY_COUNT)
def test_saved_in_the_middle_and_reopened_nothing_is_lost(kind, tmp_path):
    path = str(tmp_path / "middle.blend")
    _, before, held = add_recipe(kind)
    select(held, 4)
    extrude(0.5, 0.25, 0)
    points = points_now()
    bpy.ops.wm.save_as_mainfile(filepath=path)
    assert bpy.context.mode == 'EDIT_CURVE'
    require_sound(6)
    select(bpy.context.object, 5)
    extrude(0.5, 0, 0)
    require_sound(7)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert np.array_equal(points_now(), points) and bpy.context.mode == 'OBJECT'
    require_exact(shape_now())
    bpy.context.view_layer.objects.active = shape_now()
    shape_now().select_set(True)
    select(enter(), 5)
    require_sound(6)
    extrude(0.5, 0, 0)
    require_sound(7)
    assert np.array_equal(points_now()[:5], before)


def test_a_shape_saved_while_its_net_is_refused_is_the_last_good_one(tmp_path):
    path = str(tmp_path / "refused.blend")
    ob, before, held = add_recipe()
    select(held, 1, 2)
    curve_op('duplicate_move', TRANSFORM_OT_translate={'value': (0, 0, 1)})
    bpy.ops.wm.save_as_mainfile(filepath=path)
    assert "2 splines" in problem()
    bpy.ops.wm.open_mainfile(filepath=path)
    assert np.array_equal(points_now(), before)
    require_exact(shape_now())


def test_left_by_blenders_own_tab_the_points_are_taken():
    _, before, held = add_recipe()
    select(held, 4)
    extrude(1, 0, 0)
    select(held, 5)
    op(bpy.ops.curve.subdivide)
    extrude(1, 0, 0)
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    assert bpy.context.object == shape_now() and len(points_now()) == 7 and len(bpy.data.curves) == 1
    assert np.array_equal(points_now()[:5], before)
    require_exact(shape_now())


def test_an_osculating_polynomial_gains_whole_groups():
    ob, before, held = add_recipe('osculating')
    value = ob.data.splinewright.value
    select(held, 5)
    extrude(0.5, 0, 0)
    assert "groups of 2" in problem() and shape_now().data.splinewright.value == value
    assert len(numbers_of(held).rows) == 7
    extrude(0.5, 1, 0)
    require_sound(8)
    assert np.array_equal(points_now()[:6], before) and shape_now().data.splinewright.value.degree == 7
    select_all()
    curve_op('switch_direction')
    assert problem() == "" and np.array_equal(points_now()[:6], before), "groups are not turned over"
    select(held, 0, 1)
    curve_op('delete', type='VERT')
    assert problem() == "" and np.array_equal(points_now(), before)


@pytest.mark.parametrize('kind', FIXED_COUNT)
def test_nets_of_a_fixed_count_gain_and_lose_nothing(kind):
    ob, before, held = add_recipe(kind)
    value = ob.data.splinewright.value
    select(held, len(before) - 1)
    op(bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': (1, 0, 0)})
    bpy.context.view_layer.update()
    assert problem() == "" and "not of this net" in live.note(held) and shape_now().data.splinewright.value == value


def test_two_nets_at_once_gain_points_of_their_own():
    ob, _, _ = add_recipe()
    leave()
    ob.name = "first"
    other, _, _ = add_recipe('polynomial')
    leave()
    bpy.data.objects["first"].select_set(True)
    enter()
    select_all()
    curve_op('subdivide')
    assert [len(recipes.points(bpy.data.objects[name].data)) for name in ("first", "shape")] == [9, 9]
    leave()
    for name in ("first", "shape"):
        require_exact(bpy.data.objects[name])


def test_the_count_changes_a_hundred_times_and_every_state_is_sound():
    _, before, held = add_recipe()
    random = np.random.default_rng(3)
    for _ in range(100):
        count = len(points_now())
        select(held, *random.choice(count, 2, replace=False))
        step = random.integers(4)
        if step == 0 and count > 6:
            op(bpy.ops.curve.delete, type='VERT')
        elif step == 1 and count < 40:
            op(bpy.ops.curve.subdivide)
        elif step == 2 and count < 40:
            select(held, int(random.choice([0, count - 1])))
            extrude(*random.uniform(-1, 1, 3))
        else:
            move(*random.uniform(-1, 1, 3))
        bpy.context.view_layer.update()
        require_sound(len(held.data.splines[0].points))
    leave()
    require_exact(shape_now())
