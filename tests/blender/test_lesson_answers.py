"""Answers outlive their lesson's scene, and are collected out of other files, of which nothing is left behind."""

import csv

import bpy
import pytest

from shapes import add, op
from support import part, scene_state, splinecore as sc

shelf, stage = part('bridge.lessons.shelf'), part('bridge.lessons.stage')
CUT = shelf.all_lessons()["corner-cutting"]


def started():
    assert op(bpy.ops.splinewright.start_lesson, lesson=CUT.name) == {'FINISHED'}
    bpy.context.window.scene = next(scene for scene in bpy.data.scenes if stage.lesson_of(scene))
    return bpy.context.scene


def answered(*choices):
    scene = started()
    while stage.step_of(scene) < 3:
        op(bpy.ops.splinewright.lesson_step, way='NEXT')
    for choice in choices:
        op(bpy.ops.splinewright.check_answer, choice=choice)
    return scene


def test_answers_outlive_the_scene_and_are_counted_on():
    answered(0)
    op(bpy.ops.splinewright.leave_lesson)
    assert stage.all_answers(bpy.context.scene) == {CUT.name: {"3": {'answer': 0, 'right': False, 'tries': 1}}}
    scene = answered(1)
    assert stage.answers(scene) == {"3": {'answer': 1, 'right': True, 'tries': 2}}
    op(bpy.ops.splinewright.leave_lesson, how='KEEP')
    assert stage.recorded(scene) == {CUT.name: {"3": {'answer': 1, 'right': True, 'tries': 2}}} and not stage.lesson_of(scene)


def test_answers_of_a_lesson_that_was_begun_in_another_outlive_both():
    answered(1)
    assert op(bpy.ops.splinewright.start_lesson, lesson="doubled-points") == {'FINISHED'}
    bpy.context.window.scene = next(scene for scene in bpy.data.scenes if stage.lesson_of(scene) == "doubled-points")
    op(bpy.ops.splinewright.lesson_step, way='NEXT')
    op(bpy.ops.splinewright.check_answer, choice=1)
    op(bpy.ops.splinewright.leave_lesson)
    assert stage.lesson_of(bpy.context.scene) == CUT.name
    op(bpy.ops.splinewright.leave_lesson)
    assert set(stage.all_answers(bpy.context.scene)) == {CUT.name, "doubled-points"}


def test_leaving_without_an_answer_leaves_nothing():
    started()
    op(bpy.ops.splinewright.leave_lesson)
    assert stage.RECORD not in bpy.context.scene.keys()


def saved(path, leave, *choices):
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    if choices:
        answered(*choices)
    if leave:
        op(bpy.ops.splinewright.leave_lesson)
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def census():
    return {name: sorted(block.name for block in getattr(bpy.data, name)) for name in dir(bpy.data)
            if isinstance(getattr(bpy.data, name), type(bpy.data.objects)) and name != 'window_managers'}


def collect(folder, *names, **settings):
    return op(bpy.ops.splinewright.collect_answers, directory=str(folder), files=[{'name': name} for name in names], **settings)


def test_answers_of_many_files_are_one_table_and_nothing_is_left_behind(tmp_path):
    saved(tmp_path / "ann.blend", False, 0, 1)
    saved(tmp_path / "bob.blend", True, 2)
    saved(tmp_path / "eve.blend", False)
    add(sc.BezierCurve([(0, 0, 0), (1, 1, 0)]), "mine")
    before, state, files = census(), scene_state(), {path: path.read_bytes() for path in tmp_path.iterdir()}
    assert collect(tmp_path, "ann.blend", "bob.blend", "eve.blend") == {'FINISHED'}
    with (tmp_path / "answers.csv").open(encoding='utf-8-sig', newline="") as file:
        table = list(csv.reader(file))
    assert table == [["file", "lesson", "step", "answer", "right", "tries"], ["ann.blend", CUT.name, "4", CUT.steps[3].ask.choices[1], "yes", "2"],
                     ["bob.blend", CUT.name, "4", CUT.steps[3].ask.choices[2], "no", "1"]]
    assert census() == before and scene_state() == state and not list(bpy.data.libraries)
    assert {path: path.read_bytes() for path in files} == files and not list(tmp_path.glob("*.part"))


def test_a_table_that_is_there_is_replaced_only_when_asked(tmp_path):
    saved(tmp_path / "ann.blend", False, 1)
    (tmp_path / "marks.csv").write_text("mine")
    with pytest.raises(RuntimeError, match="marks.csv is there already: Overwrite replaces it"):
        collect(tmp_path, "ann.blend", table="marks")
    assert (tmp_path / "marks.csv").read_text() == "mine"
    assert collect(tmp_path, "ann.blend", table="marks", overwrite=True) == {'FINISHED'} and "corner-cutting" in (tmp_path / "marks.csv").read_text()


def test_what_is_no_file_of_blender_is_a_sentence_and_others_are_read(tmp_path):
    saved(tmp_path / "ann.blend", False, 1)
    (tmp_path / "bad.blend").write_bytes(b"BLENDER-v304" + bytes(1000))
    (tmp_path / "text.blend").write_text("hello")
    before = census()
    for names in (("bad.blend",), ("text.blend",), ("nowhere.blend",)):
        with pytest.raises(RuntimeError, match=names[0]):
            collect(tmp_path, *names)
    assert not (tmp_path / "answers.csv").exists()
    assert collect(tmp_path, "bad.blend", "ann.blend", "text.blend") == {'FINISHED'}
    assert len((tmp_path / "answers.csv").read_text().splitlines()) == 2 and census() == before
    with pytest.raises(RuntimeError, match="Choose .blend files"):
        op(bpy.ops.splinewright.collect_answers)


def test_files_without_answers_are_a_sentence(tmp_path):
    saved(tmp_path / "eve.blend", False)
    with pytest.raises(RuntimeError, match="keep no answers"):
        collect(tmp_path, "eve.blend")
    assert not (tmp_path / "answers.csv").exists()


@pytest.mark.parametrize('damage', (3, "{", "[]", '{"corner-cutting": 2}', '{"corner-cutting": {"x": {"tries": "many"}, "2": {}}}'))
def test_damaged_answers_stop_nothing(damage, tmp_path):
    bpy.context.scene[stage.RECORD] = damage
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "odd.blend"))
    saved(tmp_path / "ann.blend", False, 1)
    assert collect(tmp_path, "odd.blend", "ann.blend") == {'FINISHED'}
    assert (tmp_path / "answers.csv").read_text().count("ann.blend") == 1
