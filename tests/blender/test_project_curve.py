"""A curve of the nearest points on a surface follows the curve and the surface, in the scene."""

import bpy
import numpy as np
import pytest

import curves
import patches
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

follow, recipes, projecting = (part(name) for name in ('bridge.follow.follow', 'bridge.recipes.recipes', 'core.meets.projecting'))


def sphere(scale=(1, 1, 1)):
    bpy.ops.splinewright.add_sphere()
    ball = bpy.context.object
    ball.scale = scale
    return ball


def helix():
    t = np.linspace(0, 6, 30)
    return sc.fit.interpolate(np.stack([2 * np.cos(t), 2 * np.sin(t), 0.3 * t - 1], -1)).value


def both(surface, curve, surface_first=False):
    activate(curve, surface)
    bpy.context.view_layer.objects.active = surface if surface_first else curve
    bpy.context.view_layer.update()


def run(**settings):
    assert op(bpy.ops.splinewright.add_projected, **settings) == {'FINISHED'}
    return bpy.context.object


def in_world(ob):
    matrix = np.array(ob.matrix_world)
    return ob.data.splinewright.value.to_nurbs().transformed(matrix)


def misses(ob, surface, curve, count=3001):
    """(the largest distance from the surface, and from the nearest point of the curve at the same parameter), in the scene."""
    made, wanted = in_world(ob), in_world(curve)
    at = np.linspace(*wanted.domain, count)
    there = surface.data.splinewright.value.transformed(np.array(surface.matrix_world))
    points = made.evaluate(at)
    return there.nearest(points).distances.max(), np.linalg.norm(points - there.nearest(wanted.evaluate(at)).points, axis=1).max()


@pytest.mark.parametrize('tolerance', (0.0625, 0.001, 1e-5))
@pytest.mark.parametrize('surface_first', (False, True))
def test_it_lies_on_the_surface_within_the_tolerance(tolerance, surface_first):
    ball, curve = sphere(), add(helix(), "helix")
    both(ball, curve, surface_first)
    ob = run(tolerance=tolerance)
    assert max(misses(ob, ball, curve)) <= 1.1 * tolerance + 1e-6
    assert ob.type == 'CURVE' and recipes.kind(ob.data) == 'projected' and follow.problem(ob.data) == ""
    require_exact(ob)


def test_it_has_few_control_points():
    ball, curve = sphere(), add(helix(), "helix")
    both(ball, curve)
    assert len(run().data.splinewright.value.points) < 60


def test_the_distance_in_the_scene_is_said(capfd):
    ball, curve = sphere((40, 40, 40)), add(helix(), "helix")
    curve.scale = (30, 50, 40)
    both(ball, curve)
    ob = run(tolerance=0.03125)
    count, distance = curves.said_near(capfd.readouterr().out)
    assert count == len(ob.data.splinewright.value.points)
    assert 0.9 * distance <= misses(ob, ball, curve)[1] <= 1.1 * distance <= 1.1 * 0.03125


def test_it_follows_both_through_uneven_scales_and_files(tmp_path):
    ball, curve = sphere((1, 2, 0.5)), add(helix(), "helix")
    curve.scale, curve.location = (1, 0.7, 2), (0.2, 0, 0.1)
    both(ball, curve)
    ob = run()
    assert max(misses(ob, ball, curve)) <= 0.0011
    ball.location.x += 0.1
    curve.rotation_euler.z += 0.5
    bpy.context.view_layer.update()
    assert max(misses(ob, ball, curve)) <= 0.0011
    names = ob.name, ball.name, curve.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "on.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "on.blend"))
    ob, ball, curve = map(bpy.data.objects.get, names)
    curve.location.z += 0.2
    bpy.context.view_layer.update()
    assert max(misses(ob, ball, curve)) <= 0.0011 and follow.problem(ob.data) == ""
    ob.data.splinewright_parameters.projected_tolerance = 1e-5
    assert max(misses(ob, ball, curve)) <= 1.2e-5


def test_closed_curves_stay_closed_and_several_stay_several():
    ball = sphere()
    ring = sc.NurbsCurve(3, np.arange(9.0), [(2 * np.cos(t), 2 * np.sin(t), 0.4 * np.sin(2 * t))
                                             for t in np.arange(8) * np.pi / 4], periodic=True)
    curve = add(ring, "ring")
    both(ball, curve)
    assert run().data.splinewright.value.periodic
    two = add([helix(), ring], "two")
    both(ball, two)
    assert len(run().data.splinewright.value) == 2


def test_where_nearest_points_jump_it_is_refused_and_later_stays_as_it_was():
    ball, curve = sphere(), add(sc.BezierCurve([(-1, 0, 0), (1, 0, 0)]), "through the middle")
    both(ball, curve)
    before = len(bpy.data.objects)
    with pytest.raises(RuntimeError, match="nearest points jump"):
        run()
    assert len(bpy.data.objects) == before
    curve.location.z = 0.5
    both(ball, curve)
    ob = run()
    value = ob.data.splinewright.value
    curve.location.z = 0.0
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value == value and "jump" in follow.problem(ob.data)


@pytest.mark.parametrize('kind', ('bicubic', 'rational nurbs'))
def test_it_ends_at_the_border_of_a_patch(kind):
    surface, curve = add(patches.value_of(kind), "surface"), add(curves.value_of('cubic'), "curve")
    curve.location.z = 0.3
    both(surface, curve)
    try:
        ob = run(tolerance=0.01)
    except RuntimeError as error:
        assert "nearest points jump" in str(error)
        return
    assert max(misses(ob, surface, curve)) <= 0.0111


def test_what_is_selected_wrongly_is_told():
    curve, other = add(curves.value_of('nurbs'), "a"), add(curves.value_of('cubic'), "b")
    both(curve, other)
    assert not bpy.ops.splinewright.add_projected.poll()
    activate(sphere())
    assert not bpy.ops.splinewright.add_projected.poll()


def test_undo_takes_it_back_and_redo_does_it_again():
    ball, curve = sphere(), add(helix(), "helix")
    both(ball, curve)
    bpy.ops.ed.undo_push(message="both")
    ob = run()
    name, wanted = ob.name, ob.data.splinewright.value
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects and "helix" in bpy.data.objects
    bpy.ops.ed.redo()
    ob = bpy.data.objects[name]
    assert ob.data.splinewright.value == wanted and follow.problem(ob.data) == ""
