"""Join Ends: two curves become one, of a shape or of two, as smoothly as it is asked for."""

import bpy
import numpy as np
import pytest

import shapes
from curves import curves_of, run, said_distance, value_of
from shapes import activate, add, require_exact, world_points
from support import part, scene_state, splinecore as sc

curve_join = part('ui.operators.curve_join')
SMOOTHNESS = ('C0', 'G1', 'C1', 'C2')


@pytest.fixture
def said(monkeypatch):
    texts = []

    def told(outcomes, told=curve_join.told):
        texts.append(told(outcomes))
        return texts[-1]
    monkeypatch.setattr(curve_join, 'told', told)
    return texts


def halves(first_reversed, second_reversed):
    """The curve that was cut, and its two parts."""
    whole = value_of('three knots')
    first, second = whole.split(0.2)
    return whole, [first.reversed() if first_reversed else first, second.reversed() if second_reversed else second]


@pytest.mark.parametrize('first_reversed', (False, True))
@pytest.mark.parametrize('second_reversed', (False, True))
@pytest.mark.parametrize('swapped', (False, True))
def test_ends_that_meet_are_joined_without_an_error_whichever_way_they_run(
        first_reversed, second_reversed, swapped, said):
    whole, parts = halves(first_reversed, second_reversed)
    ob = add(parts[::-1] if swapped else parts)
    assert run('join_ends') == {'FINISHED'}
    joined, = curves_of(ob)
    fractions, (start, end) = np.linspace(0, 1, 201), joined.domain
    points = joined.evaluate(start + fractions * (end - start))
    expected = whole.evaluate(fractions)
    if np.linalg.norm(points[0] - expected[0]) > 1e-9:
        expected = expected[::-1]
    assert said_distance(said[0]) < 1e-14 and np.abs(points - expected).max() < 1e-13
    require_exact(ob)


def test_parts_that_run_on_give_the_curve_itself_over_its_own_domain():
    whole, parts = halves(False, False)
    ob = add(parts)
    run('join_ends', continuity='C2')
    joined, = curves_of(ob)
    at = np.linspace(0, joined.domain[1], 101)
    assert np.allclose(joined.domain, (0, 1), rtol=0, atol=1e-15)
    assert np.abs(joined.evaluate(at) - whole.evaluate(at)).max() < 1e-13


def apart():
    """Two curves whose nearest ends, the end of the first and the start of the second, leave a gap."""
    first = sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0.5), (3, 1, 0)])
    second = sc.NurbsCurve(3, [2, 2, 2, 2, 3, 4, 4, 4, 4], [(3.2, 1.1, 0), (4, 2, 1), (5, 0, 1), (6, 1, 0), (7, 1, 1)])
    return first, second


@pytest.mark.parametrize('smoothness', SMOOTHNESS)
def test_the_joint_is_as_smooth_as_asked_and_the_move_is_as_large_as_said(smoothness, said):
    first, second = apart()
    ob = add([first, second])
    run('join_ends', continuity=smoothness)
    joined, = curves_of(ob)
    measured = joined.continuity(1.0)
    reached = {'C0': measured.c >= 0, 'G1': measured.g >= 1, 'C1': measured.c >= 1, 'C2': measured.c >= 2}
    assert reached[smoothness]
    fractions, end = np.linspace(0, 1, 20001), joined.domain[1]
    differences = [joined.evaluate(fractions, side='left') - first.evaluate(fractions),
                   joined.evaluate(1 + fractions * (end - 1)) - second.evaluate(2 + 2 * fractions)]
    moves = [np.linalg.norm(difference, axis=1).max() for difference in differences]
    assert max(moves) > 0.1 and 0.94 * max(moves) < said_distance(said[0]) < 1.07 * max(moves)
    assert (joined.points[0] == first.points[0]).all() and (joined.points[-1] == second.points[-1]).all()
    require_exact(ob)


def test_the_nearest_ends_of_all_pieces_meet_and_the_others_stay_bit_for_bit():
    first, second = apart()
    others = [value_of('hermite'), sc.BezierCurve([(20, 0), (21, 3)])]
    ob = add([others[0], second, others[1], first])
    run('join_ends')
    after = curves_of(ob)
    assert len(after) == 3 and after[0] == others[0] and after[2] == others[1]
    assert after[1].domain == (0, 3)


def test_chosen_pieces_are_joined_where_they_are():
    curves = [sc.BezierCurve([(x, 0), (x + 1, 0)]) for x in (0, 1, 2.5)]
    ob = add(curves)
    run('join_ends', first=1, second=3)
    after = curves_of(ob)
    assert len(after) == 2 and after[1] == curves[1]
    assert np.allclose(after[0].evaluate([0.0, 2.0]), [(0, 0, 0), (3.5, 0, 0)])


def two_objects():
    """The halves of a curve as two objects, moved so that they meet in the world."""
    whole, (first, second) = halves(False, True)
    one = add(first, "one")
    other = add(second.transformed(np.diag([0.5, 0.25, 1.0])), "other")
    one.location, other.location, other.scale = (1, 2, 3), (1, 2, 3), (2, 4, 1)
    for i, ob in enumerate((one, other)):
        ob.data.materials.append(bpy.data.materials.new(ob.name))
        for point in ob.data.splines[0].points:
            point.radius = 2 + i
    activate(one, other)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="two")
    return whole, one, other


def test_two_shapes_become_one_in_the_place_of_the_active_one_and_undo_brings_both_back(said):
    whole, one, other = two_objects()
    before = [ob.data.splinewright.value for ob in (one, other)]
    run('join_ends')
    assert [ob.name for ob in bpy.data.objects] == ["one"] and [data.name for data in bpy.data.curves] == ["one"]
    assert said_distance(said[0]) < 1e-14 and tuple(one.location) == (1, 2, 3)
    joined, = curves_of(one)
    at = np.linspace(0, 1, 101)
    assert np.abs(joined.evaluate(at) - whole.evaluate(at)).max() < 1e-13
    assert [material.name for material in one.data.materials] == ["one", "other"]
    radii = [point.radius for point in one.data.splines[0].points]
    assert radii[0] == 2.0 and radii[-1] == 3.0 and np.isin(radii, [2.0, 3.0]).all() and (np.diff(radii) >= 0).all()
    assert np.allclose(world_points(one)[0], whole.evaluate(0.0) + (1, 2, 3), atol=1e-6)
    bpy.ops.ed.undo()
    assert [bpy.data.objects[name].data.splinewright.value for name in ("one", "other")] == before
    bpy.ops.ed.redo()
    assert curves_of(bpy.data.objects["one"]) == [joined] and len(bpy.data.objects) == 1


def test_pieces_of_two_shapes_are_counted_in_each_and_the_rest_keeps_its_looks():
    _, one, other = two_objects()
    far = sc.BezierCurve([(50, 0), (51, 0)])
    other.data.splinewright.value = [far, other.data.splinewright.value]
    for number, error in ((3, "2 pieces, there is none of number 3"),):
        with pytest.raises(RuntimeError, match=error):
            run('join_ends', second=number)
    assert len(bpy.data.objects) == 2
    run('join_ends', first=1, second=2)
    after = curves_of(one)
    assert len(after) == 2 and np.allclose(after[1].points, far.points * (2, 4, 1), atol=1e-14)
    assert [spline.material_index for spline in one.data.splines] == [0, 1]


REFUSED = (
    (lambda: [value_of('cubic')], {}, "one piece: Make Periodic closes it"),
    (lambda: [value_of('cubic')] * 2, {'first': 2, 'second': 2}, "not joined to itself"),
    (lambda: [value_of('cubic')] * 2, {'first': 3}, "2 pieces, there is none of number 3"),
    (lambda: [value_of('periodic'), value_of('cubic')], {'first': 1, 'second': 2}, "piece 1 is periodic"),
    (lambda: [value_of('periodic')] * 2, {}, "is periodic"),
    (lambda: [sc.BezierCurve([(1, 0), (0, 1), (2, 3)], [1, 1, 0]), sc.BezierCurve([(0, 1), (3, 1), (3, 3)], [0, 1, 1])],
     {}, None),
    (lambda: [sc.BezierCurve([(1, 0), (0, 1), (2, 2)], [0, 1, 0]), value_of('cubic')], {}, "infinity"))


@pytest.mark.parametrize('make, settings, word', REFUSED)
def test_what_cannot_be_joined_is_refused_with_a_word_or_joined_at_its_finite_ends(make, settings, word):
    ob = add(make())
    before, value = scene_state(), str(ob.data.splinewright.value)
    if word is None:
        assert run('join_ends', **settings) == {'FINISHED'} and len(curves_of(ob)) == 1
        require_exact(ob)
        return
    with pytest.raises(RuntimeError, match=f"shape: .*{word}"):
        run('join_ends', **settings)
    assert scene_state() == before and str(ob.data.splinewright.value) == value


def test_one_or_two_selected_curve_shapes_are_wanted():
    operator = bpy.ops.splinewright.join_ends
    assert not operator.poll()
    one, two, three = (add(value_of('cubic'), name) for name in "abc")
    assert operator.poll()
    activate(one, two)
    assert operator.poll()
    activate(one, two, three)
    with pytest.raises(RuntimeError, match="one or two curve shapes"):
        operator()
    patch = add(sc.BezierPatch(shapes.points(3, 3)), "patch")
    activate(one, patch)
    assert not operator.poll()
    activate(one)
    one.select_set(False)
    assert not operator.poll()
    activate(one)
    bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True)
    with pytest.raises(RuntimeError, match="Leave the present mode"):
        operator()


def test_a_shape_that_is_no_longer_free_is_refused_as_the_other_one_and_both_stay():
    bpy.ops.splinewright.add_conic('EXEC_DEFAULT', True)
    conic = bpy.context.object
    one = add(value_of('cubic'))
    activate(one, conic)
    before = scene_state()
    with pytest.raises(RuntimeError, match="Apply Construction"):
        run('join_ends')
    assert scene_state() == before
    activate(conic)
    bpy.ops.splinewright.make_editable('EXEC_DEFAULT', True)
    activate(one, conic)
    assert run('join_ends') == {'FINISHED'}
