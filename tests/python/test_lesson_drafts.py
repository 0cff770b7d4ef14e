"""Lessons that are being made: what a scene shows becomes what a file says, and reads back as that."""

import json

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

drafts, reading, lectures, failures = core("lessons.drafts"), core("lessons.reading"), core("lessons.lectures"), core("base.failures")

CURVE, BENT = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 1 / 3, 0)]), sc.BezierCurve([(0, 0, 0), (1, 3, 0.1), (3, 1 / 3, 0)])
PRESENT = {'curve': drafts.Present("", (), {}, CURVE),
           'steps': drafts.Present("construction", ("curve",), {'scheme': "casteljau", 'position': 0.5}, [CURVE])}


def begun(words="Look."):
    makes = [drafts.make(name, one) for name, one in PRESENT.items()]
    return drafts.begun("Größe & Form 2", drafts.step(words, makes, (), "TOP", ["labels"]))


def lesson_of(draft):
    return reading.read(drafts.text_of(draft))


def test_what_is_begun_reads_back_as_it_was_in_every_bit():
    lesson = lesson_of(begun())
    assert (lesson.name, lesson.title) == ("größe-form-2", "Größe & Form 2")
    assert lesson.steps[0].view == "TOP" and lesson.steps[0].overlays == ("labels",)
    known = drafts.state_of(lesson)
    assert known['curve'].value == CURVE and known['steps'].settings == PRESENT['steps'].settings and known['steps'].inputs == ("curve",)
    assert drafts.changes(known, PRESENT) == []


def test_changes_are_found_and_lead_there():
    now = {'curve': PRESENT['curve']._replace(value=BENT), 'steps': PRESENT['steps']._replace(settings={'scheme': "casteljau", 'position': 0.25})}
    draft = begun()
    found = drafts.changes(drafts.state_of(lesson_of(draft)), now)
    assert [one['shape'] for one in found] == ["curve", "steps"] and found[1]['set'] == {'position': 0.25}
    assert drafts.moves(PRESENT, now, found) == [{'shape': "curve", 'points': [1]}, {'shape': "steps", 'setting': "position"}]
    draft['steps'].append(drafts.step("Now this.", (), found))
    after = drafts.state_of(lesson_of(draft))
    assert after['curve'].value == BENT and after['steps'].settings['position'] == 0.25 and drafts.changes(after, now) == []


def test_a_shape_that_is_missing_or_new_is_no_change():
    known = drafts.state_of(lesson_of(begun()))
    assert drafts.changes(known, {'other': PRESENT['curve'], 'steps': PRESENT['steps']}) == []


def test_a_shape_that_is_made_otherwise_is_refused_with_its_reason():
    known = drafts.state_of(lesson_of(begun()))
    with pytest.raises(failures.Refusal, match="steps is made otherwise than the lesson says: it was moved"):
        drafts.changes(known, {'steps': drafts.Present("", (), {}, [CURVE], "it was moved")})


CONDITION = {'that': {'measure': "x", 'of': "curve", 'at': 0.5}, 'above': 1.0}


def test_questions_replace_each_other_and_conditions_add_up():
    draft = drafts.ask(begun(), {'do': [CONDITION]}, "More.", [{'shape': "steps", 'set': {'position': 0.1}}], [{'shape': "steps", 'setting': "position"}])
    last = lesson_of(draft).steps[-1]
    assert last.ask.kind == 'do' and last.hint == "More." and last.solution and last.move
    draft = drafts.ask(draft, {'do': [{**CONDITION, 'above': 2.0}]}, "", [{'shape': "steps", 'set': {'position': 0.2}}])
    last = lesson_of(draft).steps[-1]
    assert [one.value for one in last.ask.conditions] == [1.0, 2.0] and last.solution[0].settings == {'position': 0.2} and not last.move
    last = lesson_of(drafts.ask(draft, {'point': [1], 'of': "curve"})).steps[-1]
    assert last.ask.points == {1} and not last.solution and len(draft['steps']) == 1


STRIP = drafts.Present("ducks", (), {'ends': 0.5}, CURVE, "", ((0.0, 0.0, 0.0), (1.0, 0.25, 0.0), (2.0, 0.0, 0.0)), (), (0.0, 1.5, 0.0))
SHEET = drafts.Present("plane", (), {'width': 2.0}, sc.BezierPatch([[(u, v, 0) for v in (0, 1)] for u in (0, 1)]), "", (), (3, 7), (1.0, 0.0, 0.0))


def test_points_faces_and_places_read_back_and_their_changes_are_found():
    draft = drafts.begun("A", drafts.step("x", [drafts.make("strip", STRIP), drafts.make("sheet", SHEET)]))
    known = drafts.state_of(lesson_of(draft))
    assert [known[name]._replace(value=None) for name in ("strip", "sheet")] == [one._replace(value=None) for one in (STRIP, SHEET)]
    assert drafts.changes(known, {'strip': STRIP, 'sheet': SHEET}) == []
    now = {'strip': STRIP._replace(points=(*STRIP.points[:2], (3.0, 0.0, 0.0))), 'sheet': SHEET._replace(faces=(4, 7))}
    found = drafts.changes(known, now)
    assert found == [{'shape': "strip", 'points': [[0, 0, 0], [1, 0.25, 0], [3, 0, 0]]}, {'shape': "sheet", 'faces': [4, 7]}]
    assert drafts.moves(known, now, found) == [{'shape': "strip", 'points': [2]}]
    draft['steps'].append(drafts.step("y", (), found))
    after = drafts.state_of(lesson_of(draft))
    assert (after['strip'].points, after['sheet'].faces) == (now['strip'].points, (4, 7)) and drafts.changes(after, now) == []


def test_points_that_are_back_at_the_start_are_said_and_a_shape_that_was_moved_is_refused():
    known = {'strip': STRIP}
    said, = drafts.changes(known, {'strip': STRIP._replace(points=())})
    assert said['points'][0] == [-1, 0, 0] and len(said['points']) == 5
    with pytest.raises(failures.Refusal, match="strip was moved: a step can change"):
        drafts.changes(known, {'strip': STRIP._replace(place=(0.0, 2.0, 0.0))})


@pytest.mark.parametrize('title', ("", "???", "- _"))
def test_a_title_without_letters_is_refused(title):
    with pytest.raises(failures.Refusal, match="a letter or a digit"):
        drafts.begun(title, drafts.step("x"))


@pytest.mark.parametrize('words', ("", "x" * 3000))
def test_what_cannot_be_read_back_is_not_written(words):
    with pytest.raises(failures.Refusal, match="text"):
        drafts.text_of(drafts.begun("A", drafts.step(words)))


def test_numbers_stand_in_a_line_and_texts_stay():
    words = "Look at [1,  2] and [ 3.5 ]."
    text = drafts.text_of(begun(words))
    assert "[1.0, 2.0, 0.0, 1.0]" in " ".join(text.split()).replace("[ ", "[").replace(" ]", "]") and len(text.splitlines()) < 50
    assert json.loads(text)['steps'][0]['text'] == words


def test_random_values_survive():
    rng = np.random.default_rng(8)
    for _ in range(50):
        value = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], rng.normal(size=(4, 3)) * 10.0 ** rng.integers(-8, 9), rng.uniform(0.1, 9, 4))
        draft = drafts.begun("A", drafts.step("x", [drafts.make("c", drafts.Present("", (), {}, value))]))
        assert drafts.state_of(lesson_of(draft))['c'].value == value


def named(title, *items):
    return reading.Lesson(title, title, items, ())


def test_lessons_stand_at_their_first_lecture_in_the_order_of_items():
    those = [named("a", "001.5", "000.2"), named("b", "000.101"), named("c", "000.25-31"), named("d"), named("e", "999.1"), named("f", "004.x")]
    found = {label[:3]: [lesson.name for lesson in group] for label, group in lectures.groups(those)}
    assert found == {"000": ["c", "b"], "001": ["a"], "Oth": ["d", "e", "f"]}
    assert [lesson.name for lesson in lectures.of_lecture(those, "000")] == ["a", "c", "b"] and lectures.of_lecture(those, "002") == []
