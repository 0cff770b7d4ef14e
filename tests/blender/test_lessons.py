"""Lessons: every step of each is made, what is asked is wrong before and right after its solution, and leaving leaves nothing."""

import json
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

from layouts import Layout, drawn_by
from shapes import add
from support import part, scene_state, splinecore as sc

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples/lessons"))
import motion                                               # noqa: E402

shelf, stage, failures, lessons, panel, start = (part(name) for name in (
    'bridge.lessons.shelf', 'bridge.lessons.stage', 'core.base.failures', 'ui.operators.lessons', 'ui.lessons_panel', 'ui.start_panel'))
LESSONS = shelf.all_lessons()


@pytest.fixture(params=LESSONS)
def lesson(request):
    return LESSONS[request.param]


def started(lesson):
    assert bpy.ops.splinewright.start_lesson('EXEC_DEFAULT', True, lesson=lesson.name) == {'FINISHED'}
    scene = bpy.data.scenes[lesson.title]
    bpy.context.window.scene = scene
    return scene


def step(way):
    return bpy.ops.splinewright.lesson_step('EXEC_DEFAULT', True, way=way)


def definitions(scene):
    return {name: sc.dumps(shown.value) for name, shown in stage.shapes_of(scene).items()}


def test_every_step_is_made_and_every_question_has_its_answer(lesson):
    scene = started(lesson)
    for number, each in enumerate(lesson.steps):
        assert stage.step_of(scene) == number
        assert all(getattr(scene.splinewright_sights, name, False) for name in each.overlays)
        for watch in each.watch:
            assert part('core.lessons.checking').watched(watch, stage.shapes_of(scene))
        if each.ask is not None and each.ask.kind == 'do':
            assert not stage.answer(scene, lesson)
            for wrong in each.wrong:
                stage.change(scene, wrong)
                assert not stage.answer(scene, lesson)
            assert bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True) == {'FINISHED'}
            assert bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True) == {'FINISHED'}
            assert stage.answers(scene)[str(number)]['right']
        elif each.ask is not None and each.ask.kind == 'number':
            assert bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True) == {'FINISHED'}
            said = float(lessons.shown_answer(scene).removeprefix("The answer is ").split(" ")[0].rstrip("."))
            assert stage.answer(scene, lesson, said) and not stage.answer(scene, lesson, said + 3 * each.ask.within)
        elif each.ask is not None and each.ask.kind == 'point':
            bpy.ops.splinewright.pick_answer('EXEC_DEFAULT', True)
            assert bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True) == {'FINISHED'}
            assert bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True) == {'FINISHED'}
            assert stage.answers(scene)[str(number)]['right']
        elif each.ask is not None and each.ask.kind == 'choose':
            for choice in range(len(each.ask.choices)):
                bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True, choice=choice)
                assert stage.answers(scene)[str(number)]['right'] == (choice == each.ask.right)
        if number + 1 < len(lesson.steps):
            assert step('NEXT') == {'FINISHED'}
    with pytest.raises(RuntimeError, match="this is the last step"):
        step('NEXT')


def test_a_teacher_would_be_told_of_nothing_wrong(lesson, monkeypatch):
    trial = part('bridge.lessons.trial')
    known = {name.identifier for name in bpy.context.scene.splinewright_sights.bl_rna.properties if name.type == 'BOOLEAN'}
    before = scene_state()
    monkeypatch.setattr(trial, 'LONGEST', np.inf)             # a busy machine takes longer
    assert trial.faults(lesson, bpy.context.scene, known) == []
    assert scene_state() == before and len(bpy.data.scenes) == 1


def test_back_and_reset_give_a_step_as_it_begins(lesson):
    scene = started(lesson)
    begun = [definitions(scene)]
    for _ in lesson.steps[1:]:
        step('NEXT')
        begun.append(definitions(scene))
    for ob in scene.objects:
        ob.location.x += 3.0
    step('RESET')
    assert definitions(scene) == begun[-1]
    for wanted in begun[-2::-1]:
        assert step('BACK') == {'FINISHED'} and definitions(scene) == wanted
    with pytest.raises(RuntimeError, match="This is the first step"):
        step('BACK')


def test_leaving_leaves_the_file_as_it_was(lesson):
    add(sc.BezierCurve(np.eye(3)), "mine")
    before, own = scene_state(), bpy.context.scene
    scene = started(lesson)
    step('NEXT')
    assert bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True) == {'FINISHED'}
    assert bpy.context.scene == own and scene_state() == before and len(bpy.data.scenes) == 1


def test_a_kept_scene_is_an_ordinary_one(lesson):
    scene = started(lesson)
    bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True, how='KEEP')
    assert bpy.context.scene == scene and not stage.lesson_of(scene) and stage.SHAPE not in scene.objects[0].keys()
    assert not bpy.ops.splinewright.check_answer.poll() and not panel.SPLINEWRIGHT_PT_lesson.poll(bpy.context)


def test_a_step_selects_what_it_speaks_of():
    scene = started(LESSONS["local-control"])
    layer = scene.view_layers[0]

    def selected():
        return {ob[stage.SHAPE] for ob in scene.objects if ob.select_get(view_layer=layer)}
    assert selected() == {"whole", "moved", "vase"} and layer.objects.active[stage.SHAPE] == "whole"
    assert bpy.ops.splinewright.edit_net.poll() and start.SPLINEWRIGHT_PT_start.poll(bpy.context)
    step('NEXT')
    step('NEXT')
    assert layer.objects.active[stage.SHAPE] == "upper" and "lower" in selected() and "whole" not in selected()
    step('BACK')
    assert selected() == {"whole"} and layer.objects.active[stage.SHAPE] == "whole"
    assert bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True) == {'FINISHED'} and bpy.context.mode.startswith('EDIT')


def test_the_panel_for_nothing_selected_stays_away_from_lessons():
    assert start.SPLINEWRIGHT_PT_start.poll(bpy.context)
    started(LESSONS["draftsman"])
    bpy.ops.object.select_all(action='DESELECT')
    assert not start.SPLINEWRIGHT_PT_start.poll(bpy.context)
    bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True)
    assert start.SPLINEWRIGHT_PT_start.poll(bpy.context)


@pytest.mark.parametrize('name, number, said', (
    ("draftsman", 1, "The solution is made: bending energy of strip is 0.2447"), ("draftsman", 2, "The answer is 0. A straight line has the curvature 0"),
    ("draftsman", 3, "The answer is: the place, the tangent and the curvature. C2 means"), ("patches", 1, "The point is 6, counted from 0. B")))
def test_show_me_says_the_answer_with_its_hint(name, number, said):
    scene = started(LESSONS[name])
    for _ in range(number):
        step('NEXT')
    assert lessons.shown_answer(scene) == ""
    assert bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True) == {'FINISHED'}
    texts = drawn_by(panel.SPLINEWRIGHT_PT_lesson, bpy.context).texts
    assert lessons.shown_answer(scene).startswith(said) and said[:20] in " ".join(texts)
    assert lessons.shown_answer(scene).endswith(LESSONS[name].steps[number].hint)
    step('BACK')
    assert lessons.shown_answer(scene) == ""


def test_a_step_that_asks_nothing_has_nothing_to_show():
    started(LESSONS["draftsman"])
    with pytest.raises(RuntimeError, match="This step asks nothing"):
        bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True)


def test_answers_are_kept_in_the_file(tmp_path):
    lesson = LESSONS["corner-cutting"]
    scene = started(lesson)
    for _ in range(3):
        step('NEXT')
    bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True, choice=0)
    bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True, choice=1)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "lesson.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "lesson.blend"))
    scene = bpy.data.scenes[lesson.title]
    assert stage.step_of(scene) == 3 and stage.answers(scene) == {"3": {'answer': 1, 'right': True, 'tries': 2}}


def test_a_number_is_kept_as_it_was_typed():
    scene = started(LESSONS["bernstein"])
    for _ in range(2):
        step('NEXT')
    scene.splinewright_answer = 0.1
    bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True)
    assert stage.answers(scene) == {"2": {'answer': 0.1, 'right': False, 'tries': 1}}


def test_damaged_tries_count_as_none():
    scene = started(LESSONS["corner-cutting"])
    for _ in range(3):
        step('NEXT')
    scene[stage.ANSWERS] = '{"3": {"tries": "many"}}'
    assert bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True, choice=1) == {'FINISHED'}
    assert stage.answers(scene) == {"3": {'answer': 1, 'right': True, 'tries': 1}}


def test_a_shape_that_is_gone_is_a_sentence_and_reset_brings_it_back():
    lesson = LESSONS["corner-cutting"]
    scene = started(lesson)
    step('NEXT')
    step('NEXT')
    bpy.data.objects.remove(stage.object_of(scene, "steps"))
    with pytest.raises(RuntimeError, match="there is no shape 'steps' now"):
        bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True)
    with pytest.raises(RuntimeError, match="steps is gone: Reset brings it back"):
        bpy.ops.splinewright.show_solution('EXEC_DEFAULT', True)
    step('RESET')
    assert bpy.ops.splinewright.check_answer('EXEC_DEFAULT', True) == {'FINISHED'}


def test_a_lesson_that_the_add_on_has_no_more_can_be_left():
    scene = started(LESSONS["corner-cutting"])
    scene[stage.LESSON] = "lost"
    with pytest.raises(RuntimeError, match="there is no lesson 'lost' here"):
        step('NEXT')
    assert bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True) == {'FINISHED'} and len(bpy.data.scenes) == 1


@pytest.mark.parametrize('damage', (3, "{", "[]", '{"1": 2}'))
def test_damaged_answers_are_none(damage):
    scene = started(LESSONS["corner-cutting"])
    scene[stage.ANSWERS] = damage
    assert stage.answers(scene) == {}


def test_a_step_that_cannot_be_made_leaves_none_of_its_shapes():
    value = {'format': 'splinecore', 'version': 1, 'kind': 'bezier_curve', 'points': [[0, 0, 0, 1], [1, 1, 0, 1]]}
    refused = {'shape': "levels", 'recipe': 'construction', 'of': ["curve"], 'set': {'first_level': 5}}
    steps = [{'text': "One.", 'make': [{'shape': "curve", 'value': value}]},
             {'text': "Two.", 'make': [{'shape': "other", 'value': value}, refused]}]
    made = shelf.read_text(json.dumps({'format': 1, 'name': "refused", 'title': "Refused", 'steps': steps}))
    scene = stage.begin(made, bpy.context.scene)
    before = scene_state()
    for _ in range(2):
        with pytest.raises(failures.Refusal, match="^Refused, step 2: levels cannot be made: .*levels are 0 to 1"):
            stage.advance(scene, made)
        assert stage.step_of(scene) == 0 and list(stage.shapes_of(scene)) == ["curve"] and scene_state() == before


def test_faces_of_several_shapes_are_bounded_before_they_are_made():
    """Spans of what a recipe makes are known when it is there."""
    tori = [{'shape': name, 'recipe': 'torus', 'faces': [100, 100]} for name in ("first", "second")]
    steps = [{'text': "One.", 'make': tori[:1]}, {'text': "Two.", 'make': tori[1:]}]
    made = shelf.read_text(json.dumps({'format': 1, 'name': "large", 'title': "Large", 'steps': steps}))
    scene = stage.begin(made, bpy.context.scene)
    assert [len(ob.data.polygons) for ob in scene.objects] == [160_000]
    with pytest.raises(failures.Refusal, match="^Large, step 2: second cannot be made: the lesson would show 320,000 faces: 300,000 are the most$"):
        stage.advance(scene, made)
    assert list(stage.shapes_of(scene)) == ["first"]


def test_a_long_reason_is_not_told_whole(monkeypatch):
    lesson = LESSONS["corner-cutting"]

    def refuse(*_):
        raise failures.Refusal("so " * 2000)
    monkeypatch.setattr(stage, '_make', refuse)
    with pytest.raises(failures.Refusal) as refused:
        stage.begin(lesson, bpy.context.scene)
    assert str(refused.value).startswith(f"{lesson.title}, step 1: curve cannot be made: so so ") and len(str(refused.value)) < 500
    assert len(bpy.data.scenes) == 1


def test_answers_that_are_too_long_for_buttons_stand_above_their_numbers(monkeypatch):
    monkeypatch.setattr(part('ui.texts'), 'fits', lambda words, beside=0: len(words) < 12)
    short, long = Layout(), Layout()
    panel._draw_choices(short, ["a circle", "a line"])
    panel._draw_choices(long, ["a circle", "a line through both"])
    assert short.texts == ["a circle", "a line"] and short.operators == ["splinewright.check_answer"] * 2
    assert long.texts == ["1. a circle", "2. a line through both", "1", "2"] and long.operators == short.operators


def test_films_take_5_to_20_seconds(lesson):
    motions = sum(bool(step.solution) for step in lesson.steps)
    assert 5.0 <= motion.hold(lesson) * (len(lesson.steps) + motions) + motion.SECONDS * motions <= 20.0


def test_a_film_shows_every_step_and_moves_what_is_solved():
    lesson, before = LESSONS['coefficients'], scene_state()
    frames = list(motion.frames_of(lesson))
    assert scene_state() == before
    assert [frame.number for frame in frames] == [0, 1, 2, 3, *[4] * (motion.FRAMES + 1), 5]
    assert all(frame.figure.groups for frame in frames)
    speeds = [float(frame.lines[0].split(": ")[1].split(", ")[1]) for frame in frames[4:-1]]
    assert speeds[0] == 0.75 and speeds[-1] == 0.0 and speeds == sorted(speeds, reverse=True) and len(set(speeds)) == len(speeds)


def test_a_film_goes_over_a_moment_without_a_shape():
    lesson = LESSONS['seven-ways']
    number = next(i for i, step in enumerate(lesson.steps) if any('distance' in one.settings for one in step.solution))
    frames = [frame for frame in motion.frames_of(lesson) if frame.number == number]
    assert len(frames) == motion.FRAMES + 1 and all(frame.figure.groups for frame in frames)
