"""Questions that are answered by picking control points, of curves and patches, in their nets."""

import json

import bpy
import numpy as np
import pytest

import patches
from curves import value_of
from layouts import drawn_by
from shapes import op, select
from support import part, splinecore as sc

stage, live, lessons, panel, store = (part(name) for name in (
    'bridge.lessons.stage', 'bridge.net.live', 'ui.operators.lessons', 'ui.lessons_panel', 'bridge.data.store'))


def started(value, *points):
    steps = [{'text': "Which?", 'make': [{'shape': "it", 'value': json.loads(sc.dumps(value))}], 'ask': {'point': list(points), 'of': "it"},
              'hint': "Look again."}, {'text': "Well."}]
    text = bpy.data.texts.new("points.json")
    text.from_string(json.dumps({'format': 1, 'name': "points", 'title': "Points", 'steps': steps}))
    assert op(bpy.ops.splinewright.start_lesson, text=text.name) == {'FINISHED'}
    scene = bpy.data.scenes["Points"]
    bpy.context.window.scene = scene
    return scene


def picked():
    assert op(bpy.ops.splinewright.pick_answer) == {'FINISHED'} and bpy.context.mode.startswith('EDIT')
    return bpy.context.object


def choose(held, *rows):
    net = live.session(held.data).net
    select(held, *np.flatnonzero(np.isin(net.rows, rows)))


VALUES = {'Bezier': lambda: value_of('cubic'), 'NURBS': lambda: value_of('nurbs'), 'patch': lambda: patches.value_of('bicubic'),
          'NURBS patch': lambda: patches.value_of('plain nurbs'), 'curves': lambda: [value_of('cubic'), value_of('nurbs')]}


@pytest.mark.parametrize('value', VALUES.values(), ids=VALUES)
def test_exactly_the_right_points_are_right(value):
    scene = started(value(), 1, 3)
    held = picked()
    for rows, is_right in (((1,), False), ((0, 1, 3), False), ((1, 3), True)):
        choose(held, *rows)
        assert op(bpy.ops.splinewright.check_answer) == {'FINISHED'} and bpy.context.object == held and held.mode == 'EDIT'
        assert stage.answers(scene)["0"]['answer'] == list(rows) and stage.answers(scene)["0"]['right'] == is_right
        assert ("Right" if is_right else "Not yet") in drawn_by(panel.SPLINEWRIGHT_PT_lesson, bpy.context).texts
    assert stage.answers(scene)["0"]['tries'] == 3
    assert op(bpy.ops.splinewright.lesson_step, way='NEXT') == {'FINISHED'} and bpy.context.mode == 'OBJECT' and stage.step_of(scene) == 1


def test_points_are_numbered_as_the_value_has_them():
    curve = value_of('cubic')
    started(curve, 2)
    held = picked()
    choose(held, 2)
    session = live.session(held.data)
    chosen = part('bridge.net.selection').selected(held, session.net)
    assert np.array_equal(session.points[chosen], np.asarray(curve.points)[[2]].astype(np.float32))


def test_nothing_picked_is_a_sentence_and_no_try():
    scene = started(value_of('cubic'), 1)
    with pytest.raises(RuntimeError, match="Select points of it: Pick Points shows them"):
        op(bpy.ops.splinewright.check_answer)
    held = picked()
    choose(held)
    with pytest.raises(RuntimeError, match="Select points of it"):
        op(bpy.ops.splinewright.check_answer)
    with pytest.raises(RuntimeError, match="can be selected now"):
        op(bpy.ops.splinewright.pick_answer)
    assert stage.answers(scene) == {}


def test_the_solution_is_said_and_selected():
    started(value_of('nurbs'), 2, 0)
    held = picked()
    assert op(bpy.ops.splinewright.show_solution) == {'FINISHED'}
    assert lessons.picked_points(held) == [0, 2]
    assert "Picked: 0, 2" in drawn_by(panel.SPLINEWRIGHT_PT_lesson, bpy.context).texts
    assert op(bpy.ops.splinewright.check_answer) == {'FINISHED'}


def test_other_steps_ask_for_no_points_and_a_shape_that_is_gone_is_a_sentence():
    scene = started(value_of('cubic'), 1)
    bpy.data.objects.remove(stage.object_of(scene, "it"))
    with pytest.raises(RuntimeError, match="it is gone: Reset brings it back"):
        op(bpy.ops.splinewright.pick_answer)
    op(bpy.ops.splinewright.lesson_step, way='NEXT')
    with pytest.raises(RuntimeError, match="asks for no points"):
        op(bpy.ops.splinewright.pick_answer)


def test_undo_goes_back_through_answers_and_the_net():
    scene = started(value_of('cubic'), 1)
    bpy.ops.ed.undo_push(message="started")
    held = picked()
    choose(held, 1)
    op(bpy.ops.splinewright.check_answer)
    assert op(bpy.ops.splinewright.lesson_step, way='NEXT') == {'FINISHED'}
    for _ in range(12):
        if stage.step_of(bpy.data.scenes["Points"]) == 0 and bpy.context.mode == 'OBJECT':
            break
        bpy.ops.ed.undo()
    scene = bpy.data.scenes["Points"]
    assert stage.step_of(scene) == 0 and stage.object_of(scene, "it")
    for _ in range(12):
        if stage.step_of(bpy.data.scenes["Points"]) == 1:
            break
        bpy.ops.ed.redo()
    assert stage.step_of(bpy.data.scenes["Points"]) == 1
