"""Control points at infinity are made, edited and brought back."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, numbers_of, op, require_exact, select
from support import part, splinecore as sc

net_object, store = part('bridge.cage.net_object'), part('bridge.data.store')


def arrow_heads(ob):
    return [head for _, head in numbers_of(ob).arrows]


def test_the_middle_of_a_quarter_circle_goes_to_infinity_and_it_is_a_half_circle():
    ob = add(sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0.5, 1]))
    select(enter(), 1)
    assert op(bpy.ops.splinewright.point_to_infinity) == {'FINISHED'}
    curve = bpy.data.objects["shape"].data.splinewright.value
    assert curve.weights.tolist() == [1, 0, 1] and curve.points[1].tolist() == [0, 1, 0]
    points = curve.evaluate(np.linspace(0, 1, 33))
    assert np.allclose(np.linalg.norm(points, axis=1), 1, atol=1e-15)
    held = bpy.context.object
    assert net_object.is_net(held) and len(arrow_heads(held)) == 1
    select(held, *arrow_heads(held))
    move(0, 1, 0)
    assert bpy.data.objects["shape"].data.splinewright.value.points[1].tolist() == [0, 2, 0]
    assert op(bpy.ops.splinewright.point_from_infinity) == {'FINISHED'}
    curve = bpy.data.objects["shape"].data.splinewright.value
    assert curve.weights.tolist() == [1, 1, 1] and curve.points[1].tolist() == [0, 2, 0]
    assert leave() == bpy.data.objects["shape"]
    require_exact(bpy.data.objects["shape"])


@pytest.mark.parametrize('name', ('nurbs', 'periodic', 'cubic', 'nurbs patch', 'teapot'))
def test_a_point_goes_to_infinity_and_undo_brings_it_back(name):
    value = VALUES[name]()
    add(value)
    held = enter()
    numbers = numbers_of(held)
    vertex = int(np.flatnonzero(numbers.rows >= 0)[1])
    row = int(numbers.rows[vertex])
    select(held, vertex)
    try:
        assert op(bpy.ops.splinewright.point_to_infinity) == {'FINISHED'}
    except RuntimeError as error:
        # A patch that then passes through infinity cannot be shown, and says so.
        assert "patch" in name or name == 'teapot', error
        assert bpy.data.objects["shape"].data.splinewright.value == value
        return
    pool = store.read(bpy.data.objects["shape"].data).pool
    assert pool[row, 3] == 0 and (pool[:, 3] == 0).sum() == 1
    require_exact(bpy.data.objects["shape"])
    bpy.ops.ed.undo()
    part('ui.editing').sweep()
    assert bpy.data.objects["shape"].data.splinewright.value == value


@pytest.mark.parametrize('name, operator, word', (
    ('hermite', 'point_to_infinity', "Hermite pieces have no weights"), ('nurbs', 'point_from_infinity', "does not lie at infinity")))
def test_what_cannot_go_is_refused_with_a_word_and_nothing_changes(name, operator, word):
    value = VALUES[name]()
    add(value)
    select(enter(), 1)
    with pytest.raises(RuntimeError, match=word):
        op(getattr(bpy.ops.splinewright, operator))
    assert bpy.data.objects["shape"].data.splinewright.value == value and bpy.context.mode == 'EDIT_CURVE'


def test_nothing_selected_is_said():
    add(VALUES['nurbs']())
    select(enter())
    with pytest.raises(RuntimeError, match="select points"):
        op(bpy.ops.splinewright.point_to_infinity)
    leave()
    assert not bpy.ops.splinewright.point_to_infinity.poll()


def test_the_points_of_a_recipe_stay():
    op(bpy.ops.splinewright.add_conic)
    select(enter(), 1)
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.point_to_infinity)
