"""Clean curves near strokes and vertices: what the library makes of them, and what is no stroke is told."""

import types

import bpy
import numpy as np
import pytest
from mathutils import Euler, Matrix

from blender_objects import grease_pencil
from curves import said_near
from shapes import op, require_exact
from support import part, splinecore as sc
from test_curve_through import mesh_object, select_vertices, value

recipes, strokes, store = (part(f'bridge.{name}') for name in ('recipes.recipes', 'edit.grease_pencil', 'data.store'))

T = np.linspace(0, 1, 60)
DRAWN = np.stack([4 * T, np.sin(6 * T) + 0.01 * np.sin(200 * T), 0.2 * T], -1).astype(np.float32).astype(np.float64)


def run(**settings):
    assert op(bpy.ops.splinewright.fit_curve, **settings) == {'FINISHED'}
    return bpy.context.object


def wanted(points, tolerance, **more):
    return sc.fit.approximate(points, tolerance=tolerance, parameters='centripetal', corrections=3, **more)


@pytest.mark.parametrize('tolerance', (0.5, 0.0625, 0.015625))
def test_a_stroke_becomes_a_clean_curve_within_the_tolerance(tolerance):
    source = grease_pencil(DRAWN)
    source.location = (1, 2, 3)
    bpy.context.view_layer.update()
    ob = run(tolerance=tolerance)
    made, error = wanted(DRAWN, tolerance)
    assert value(ob) == made and error <= tolerance and len(made.points) < 40
    assert tuple(ob.location) == (1, 2, 3) and np.array_equal(recipes.points(ob.data), DRAWN)
    assert source.name in bpy.data.objects
    require_exact(ob)


def turned(scale):
    return Matrix.LocRotScale((1, 2, 3), Euler((0.3, -1.1, 2.0)).to_quaternion(), scale)


@pytest.mark.parametrize('matrix', (turned((2, 2, 2)), turned((3, 0.5, 8)), turned((-2, 3, 1)), turned((1, 1, 0)),
                                    turned((4, 4, 4)) @ turned((1, 3, 1))))
def test_the_tolerance_holds_in_the_scene_whatever_the_scale(matrix):
    source = grease_pencil(DRAWN)
    source.matrix_world = matrix
    bpy.context.view_layer.update()
    there = np.array(source.matrix_world, dtype=np.float64)
    drawn = DRAWN @ there[:3, :3].T + there[:3, 3]
    ob = run(tolerance=0.0625)
    missed = value(ob).transformed(np.array(ob.matrix_world)).nearest(drawn).distances.max()
    assert 0.02 < missed <= 0.0625 * (1 + 1e-6) and np.allclose(ob.matrix_world.to_scale(), 1)
    assert len(value(ob).points) == pytest.approx(len(wanted(drawn, 0.0625).value.points), abs=2)
    require_exact(ob)


def test_of_an_object_that_is_scaled_alone_the_points_are_scaled_exactly():
    source = grease_pencil(DRAWN)
    source.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    ob = run(tolerance=0.0625)
    assert value(ob) == wanted(2 * DRAWN, 0.0625).value
    ob.data.splinewright_parameters.approximating_tolerance = 0.0078125
    assert value(ob) == wanted(2 * DRAWN, 0.0078125).value


def test_the_control_points_and_the_distance_in_the_scene_are_said(capfd):
    source = grease_pencil(DRAWN, DRAWN[:30] + 5)
    source.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    run(tolerance=0.0625)
    made = [wanted(2 * points, 0.0625) for points in (DRAWN, DRAWN[:30] + 5)]
    count, distance = said_near(capfd.readouterr().out)
    assert count == sum(len(each.value.points) for each in made)
    assert distance == pytest.approx(max(each.error for each in made), rel=1e-3)


def test_each_stroke_is_a_curve_and_a_closed_one_closes():
    around = np.array([(np.cos(t), np.sin(t), 0) for t in np.linspace(0, 2 * np.pi, 40, endpoint=False)])
    grease_pencil(around, around + 5, closed=True)
    before = set(bpy.data.objects)
    run(tolerance=0.0625)
    new = set(bpy.data.objects) - before
    assert len(new) == 2 == len(bpy.context.selected_objects) and all(value(ob).periodic for ob in new)


def test_points_where_the_hand_rests_count_once():
    grease_pencil(np.repeat(DRAWN, 3, axis=0))
    assert value(run(tolerance=0.0625)) == wanted(DRAWN, 0.0625).value


def test_by_count():
    grease_pencil(DRAWN)
    ob = run(by='count', control_points=9, degree=4)
    assert len(value(ob).points) == 9 and value(ob).degree == 4
    grease_pencil(DRAWN[:3])
    assert len(value(run(by='count', control_points=50)).points) == 3


def test_the_selected_vertices_of_a_mesh_are_fitted():
    ob = mesh_object(DRAWN, [(i, i + 1) for i in range(len(DRAWN) - 1)])
    select_vertices(ob, range(len(DRAWN)), in_history=False)
    assert value(run(tolerance=0.0625)) == wanted(DRAWN, 0.0625).value


def test_its_net_is_the_points_and_the_tolerance_stays_in_the_panel():
    grease_pencil(DRAWN)
    ob = run(tolerance=0.0625)
    few = len(value(ob).points)
    ob.data.splinewright_parameters.approximating_tolerance = 0.0078125
    assert len(value(ob).points) > few and value(ob) == wanted(DRAWN, 0.0078125).value


@pytest.mark.parametrize('lines, hidden', (((), False), ((DRAWN[:1],), False), ((DRAWN,), True), ((DRAWN[[0, 0, 0]],), False)))
def test_what_is_no_stroke_is_refused_and_nothing_is_lost(lines, hidden):
    grease_pencil(*lines, hidden=hidden)
    before = len(bpy.data.objects), len(bpy.data.curves)
    with pytest.raises(RuntimeError, match="no strokes"):
        run()
    assert (len(bpy.data.objects), len(bpy.data.curves)) == before


def test_nothing_selected_and_nothing_drawn_is_said():
    assert not bpy.ops.splinewright.fit_curve.poll()
    with pytest.raises(RuntimeError, match="Draw with Grease Pencil or Annotate"):
        bpy.ops.splinewright.fit_curve()


def stroke(points, mode='3DSPACE'):
    return types.SimpleNamespace(display_mode=mode, points=[types.SimpleNamespace(co=place) for place in points])


def context_with(*made, hide=False, number=1):
    frame = types.SimpleNamespace(frame_number=number, strokes=made)
    layer = types.SimpleNamespace(annotation_hide=hide, frames=[frame])
    return types.SimpleNamespace(annotation_data=types.SimpleNamespace(layers=[layer]),
                                 scene=types.SimpleNamespace(frame_current=1))


def test_annotations_in_space_are_taken_and_those_on_the_screen_are_not():
    (points, closed), = strokes.of_annotations(context_with(stroke(DRAWN), stroke(DRAWN, 'SCREEN')))
    assert np.array_equal(points, DRAWN) and not closed
    untold = stroke(DRAWN)
    del untold.display_mode
    assert len(strokes.of_annotations(context_with(untold))) == 1
    assert strokes.has_annotations(context_with(stroke(DRAWN)))
    assert not strokes.has_annotations(context_with(stroke(DRAWN), hide=True))
    assert strokes.of_annotations(context_with(stroke(DRAWN), hide=True)) == []
    assert strokes.of_annotations(context_with(stroke(DRAWN), number=2)) == []
    with pytest.raises(Exception, match="lie on the screen"):
        strokes.of_annotations(context_with(stroke(DRAWN, 'SCREEN')))


def test_undo_takes_it_back():
    grease_pencil(DRAWN)
    bpy.ops.ed.undo_push(message="drawn")
    name = run().name
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects and "drawn" in bpy.data.objects
