"""Points of a net that Blender's snapping puts onto others: the shape has them in exactly one place."""

import bpy
import numpy as np
import pytest
from mathutils import Vector

from shapes import add, enter, leave, numbers_of, require_exact, select
from support import splinecore as sc

POINTS = np.array([(0, 0, 0), (1 / 3, 0.7, 0.1), (1.1, 0.1, 1 / 7), (1.9, 0.9, 0.3), (2.3, 0.2, 0), (3.1, 0.6, 0.2), (4 / 3, 2.2, 0.7)])


def put(held, point, onto):
    """As a user with Snap to Vertex does: the way there in the axes of the world, in Blender's own precision."""
    places = [held.matrix_world @ Vector(numbers_of(held).single[i]) for i in (point, onto)]
    select(held, point)
    assert bpy.ops.transform.translate('EXEC_DEFAULT', True, value=places[1] - places[0]) == {'FINISHED'}


@pytest.mark.parametrize('turn', ((0, 0, 0), (0.3, -0.2, 1.1)), ids=str)
def test_a_tripled_point_is_a_corner_and_continuity_says_so(turn):
    ob = add(sc.NurbsCurve(3, np.arange(11.0), POINTS))
    ob.rotation_euler, ob.location = turn, (5 * turn[0], 3, 1 / 3)
    bpy.context.view_layer.update()
    held = enter()
    for point in (1, 3):
        put(held, point, 2)
    curve = bpy.data.objects["shape"].data.splinewright.value
    assert (curve.points[1:4] == POINTS[2]).all()
    found = curve.continuity(curve.knots[4])
    assert found.g == 0 and found.angle > 0.2
    leave()
    require_exact(bpy.data.objects["shape"])
    assert (bpy.data.objects["shape"].data.splinewright.value.points[1:4] == POINTS[2]).all()


@pytest.mark.parametrize('turn', ((0, 0, 0), (0.3, -0.2, 1.1)), ids=str)
@pytest.mark.parametrize('kind', ('bezier', 'nurbs'))
def test_a_point_of_a_patch_takes_the_digits_of_another(turn, kind):
    """So does one that is put onto it later; one that leaves has its own again."""
    rng = np.random.default_rng(3)
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing='ij')
    grid = np.stack([x, y, np.zeros((4, 4))], -1) + rng.uniform(-0.2, 0.2, (4, 4, 3))
    patch = sc.BezierPatch(grid) if kind == 'bezier' else sc.NurbsPatch((2, 3), (np.arange(7.0), np.arange(8.0)), grid)
    ob = add(patch)
    ob.rotation_euler, ob.location = turn, (5 * turn[0], 3, 1 / 3)
    bpy.context.view_layer.update()
    held = enter()
    for point in (6, 10):
        put(held, point, 5)
    found = bpy.data.objects["shape"].data.splinewright.value.points.reshape(-1, 3)
    assert (found[[6, 10]] == grid.reshape(-1, 3)[5]).all() and len(np.unique(found, axis=0)) == 14
    select(held, 6)
    bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0.5, 0, 0))
    assert len(np.unique(bpy.data.objects["shape"].data.splinewright.value.points.reshape(-1, 3), axis=0)) == 15
    leave()
    require_exact(bpy.data.objects["shape"])
