"""Where lessons come from: the add-on's by lecture, the user's folder, files, texts of the open file; bad ones change nothing."""

import json

import bpy
import pytest

from layouts import drawn_by
from shapes import op
from support import part, scene_state

shelf, stage, panel, maker, reading, texts = (part(name) for name in (
    'bridge.lessons.shelf', 'bridge.lessons.stage', 'ui.lesson_list_panel', 'ui.lesson_maker_panel', 'core.lessons.reading', 'ui.texts'))
LESSONS = shelf.all_lessons()
VALUE = {'format': "splinecore", 'version': 1, 'kind': "bezier_curve", 'points': [[0, 0, 0, 1], [1, 2, 0, 1], [3, 0, 0, 1]]}


def lesson(**changes):
    step = {'text': "Look.", 'make': [{'shape': "curve", 'value': VALUE}], 'ask': {'point': [1], 'of': "curve"}}
    return {'format': 1, 'name': "mine", 'title': "My Own", 'steps': [step], **changes}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The folder of the user."""
    monkeypatch.setattr(shelf, 'own_folder', lambda create=False: tmp_path)
    return tmp_path


def put(folder, name, what):
    path = folder / name
    path.write_text(what if isinstance(what, str) else json.dumps(what))
    return path


def everything():
    return scene_state(), sorted(scene.name for scene in bpy.data.scenes), sorted(text.name for text in bpy.data.texts), bpy.context.window.scene.name


def drawn():
    assert panel.SPLINEWRIGHT_PT_lessons.poll(bpy.context)
    return drawn_by(panel.SPLINEWRIGHT_PT_lessons, bpy.context)


def test_every_lesson_of_the_add_on_is_listed_by_its_lecture():
    assert drawn().operators.count('splinewright.start_lesson') == len(LESSONS)
    listed = set()
    for number in ("000", "001", "002", "003", "004"):
        bpy.context.window_manager.splinewright_lecture = f"L{number}"
        wanted = {panel.short(each.title) for each in LESSONS.values() if any(name.startswith(f"{number}.") for name in each.lectures)}
        assert wanted == set(drawn().texts) & {panel.short(each.title) for each in LESSONS.values()}
        listed |= wanted
    bpy.context.window_manager.splinewright_lecture = 'ALL'
    assert listed == {panel.short(each.title) for each in LESSONS.values() if each.lectures}


def test_a_file_of_the_folder_is_listed_and_started(folder):
    path = put(folder, "Mine.json", lesson())
    put(folder, "notes.txt", "no lesson")
    assert "Mine" in drawn().texts and "notes" not in drawn().texts
    assert op(bpy.ops.splinewright.start_lesson_file, filepath=str(path)) == {'FINISHED'}
    scene = bpy.data.scenes["My Own"]
    assert stage.lesson_of(scene) == "mine" and stage.object_of(scene, "curve")
    path.unlink()                       # the scene has the lesson with it
    bpy.context.window.scene = scene
    assert op(bpy.ops.splinewright.lesson_step, way='RESET') == {'FINISHED'} and not panel.SPLINEWRIGHT_PT_lessons.poll(bpy.context)


def test_a_text_of_the_file_is_listed_and_started(tmp_path):
    text = bpy.data.texts.new("mine.json")
    text.from_string(json.dumps(lesson()))
    assert "mine.json" in drawn().texts
    assert op(bpy.ops.splinewright.start_lesson, text="mine.json") == {'FINISHED'}
    bpy.data.texts.remove(text)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "own.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "own.blend"))
    assert part('ui.operators.lessons').current(bpy.data.scenes["My Own"]).title == "My Own"


def huge():
    return json.dumps(lesson()) + " " * 100_000_000


def changed(**step):
    found = lesson()
    found['steps'][0].update(step)
    return json.dumps(found)


BAD = {
    'empty': ("", "it is not JSON"), 'not JSON': ("import os", "it is not JSON"), 'a list': ("[]", "an object is expected"), 'large': (huge, "bytes"),
    'deep': ("[" * 200_000, "it is not JSON"), 'another format': (json.dumps(lesson(format="two")), "this version reads 1"),
    'wrong type': (json.dumps(lesson(title=3)), "a text of at most"), 'endless': (json.dumps(lesson(steps=lesson()['steps'] * 5000)), "1 to 60 steps"),
    'a picture': (changed(picture="lost.png"), "'picture' is not known"),
    'a measure': (changed(watch=[{'text': "{0}", 'values': [{'measure': "eval", 'of': "curve"}]}]), "a measure is expected"),
    'a huge number': (changed(ask={'number': 10 ** 400, 'within': 1}), "a number below 1e12"),
    'infinite': (changed(ask={'number': 1e999, 'within': 1}), "a number below 1e12"),
    'far away': (changed(make=[{'shape': "curve", 'value': {**VALUE, 'points': [[0, 0, 0, 1], [1e39, 0, 0, 1]]}}]), "farther away than Blender can show"),
    'no point': (changed(ask={'point': [0.5], 'of': "curve"}), "a whole number from 0"), 'bytes': (b"\xff\xfe\x00{", "not a text file")}


@pytest.mark.parametrize('what, said', BAD.values(), ids=BAD)
def test_a_bad_file_is_a_sentence_and_changes_nothing(what, said, tmp_path):
    content = what() if callable(what) else what
    path = tmp_path / "bad.json"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    before = everything()
    with pytest.raises(RuntimeError, match=said) as error:
        op(bpy.ops.splinewright.start_lesson_file, filepath=str(path))
    assert "Traceback" not in str(error.value) and len(str(error.value)) < 600 and everything() == before


@pytest.mark.parametrize('name, said', (("nowhere.json", "no such file"), ("", "no such file"), ("a\0b.json", "null|no such file")))
def test_a_file_that_is_none_is_a_sentence(name, said, tmp_path):
    before = everything()
    with pytest.raises(part('core.base.failures').Refusal, match=said):
        shelf.read(tmp_path / name)
    with pytest.raises(RuntimeError, match="Choose a file"):
        op(bpy.ops.splinewright.start_lesson_file)
    assert everything() == before


@pytest.mark.parametrize('text, said', (("{", "bad.json: it is not JSON"), (changed(run="import os"), "'run' is not known")))
def test_a_bad_text_is_a_sentence_and_changes_nothing(text, said):
    bpy.data.texts.new("bad.json").from_string(text)
    before = everything()
    with pytest.raises(RuntimeError, match=said):
        op(bpy.ops.splinewright.start_lesson, text="bad.json")
    with pytest.raises(RuntimeError, match="there is no text 'none.json'"):
        op(bpy.ops.splinewright.start_lesson, text="none.json")
    assert everything() == before


def test_a_lesson_that_was_damaged_in_its_scene_can_be_left(folder):
    op(bpy.ops.splinewright.start_lesson_file, filepath=str(put(folder, "a.json", lesson())))
    scene = bpy.data.scenes["My Own"]
    bpy.context.window.scene = scene
    scene[stage.FILE] = "{"
    with pytest.raises(RuntimeError, match="it is not JSON"):
        op(bpy.ops.splinewright.check_answer)
    assert "it is not JSON" in " ".join(drawn_by(part('ui.lessons_panel').SPLINEWRIGHT_PT_lesson, bpy.context).texts)
    assert op(bpy.ops.splinewright.leave_lesson) == {'FINISHED'} and len(bpy.data.scenes) == 1


def test_the_first_lesson_begins_where_none_is_named():
    assert op(bpy.ops.splinewright.start_lesson) == {'FINISHED'}
    assert [stage.lesson_of(scene) for scene in bpy.data.scenes if stage.lesson_of(scene)] == [next(iter(LESSONS))]


def test_the_folder_is_made_and_shown(folder, monkeypatch):
    asked = []
    monkeypatch.setattr(part('ui.operators.reports'), 'called', lambda operator, other, **settings: asked.append(settings) or {'FINISHED'})
    assert bpy.ops.splinewright.show_lesson_folder() == {'FINISHED'} and asked == [{'filepath': str(folder)}]


def test_the_own_folder_is_where_blender_says(tmp_path, monkeypatch):
    made = []

    def path_for(*_, path="", create=False, **__):
        found = tmp_path / path
        made.append(path)
        if create:
            found.mkdir(parents=True, exist_ok=True)
        return str(found)
    monkeypatch.setattr(bpy.utils, 'user_resource', path_for)
    monkeypatch.setattr(bpy.utils, 'extension_path_user', lambda package, **more: path_for(**more), raising=False)
    assert shelf.own_folder() is None and shelf.own_files() == []
    assert shelf.own_folder(create=True).is_dir() and shelf.own_folder().name == "lessons" and set(made) <= {"lessons", "splinewright/lessons"}


def test_text_in_the_view_is_wrapped_by_its_width():
    lines = texts.wrapped("one two three\nfour incomprehensibilities", 9, len)
    assert lines == ["one two", "three", "four", "incomprehensibilities"] and texts.wrapped("", 9, len) == []


def test_overlays_that_there_are_not_are_left_out(folder):
    named = ["labels", "__class__", "bl_rna", "rna_type", "name", "wings", "comb_scale"]
    path = put(folder, "a.json", lesson(steps=[{**lesson()['steps'][0], 'overlays': named}]))
    assert op(bpy.ops.splinewright.start_lesson_file, filepath=str(path)) == {'FINISHED'}
    sights = bpy.data.scenes["My Own"].splinewright_sights
    assert sights.labels and sights.name == ""


def test_a_lesson_that_is_linked_from_another_file_is_not_changed(folder, tmp_path):
    op(bpy.ops.splinewright.start_lesson_file, filepath=str(put(folder, "a.json", lesson())))
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "own.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "own.blend"), link=True) as (there, wanted):
        wanted.scenes = ["My Own"]
    bpy.context.window.scene = wanted.scenes[0]
    before = everything()
    for name in ('lesson_step', 'check_answer', 'show_solution', 'pick_answer'):
        with pytest.raises(RuntimeError, match="My Own is linked from another file"):
            op(getattr(bpy.ops.splinewright, name))
    assert everything() == before
    assert op(bpy.ops.splinewright.leave_lesson) == {'FINISHED'} and not [one for one in bpy.data.scenes if stage.lesson_of(one)]


def test_a_lesson_can_be_undone(folder):
    path = put(folder, "a.json", lesson())
    bpy.ops.ed.undo_push(message="before")
    op(bpy.ops.splinewright.start_lesson_file, filepath=str(path))
    bpy.ops.ed.undo()
    assert not [scene for scene in bpy.data.scenes if stage.lesson_of(scene)]
    bpy.ops.ed.redo()
    assert [stage.step_of(scene) for scene in bpy.data.scenes if stage.lesson_of(scene)] == [0]
