"""What a step of a lesson speaks of, and its answer in words, of every kind of question."""

import json

import pytest

import splinecore as sc
from addon_core import ADDON, core

in_words, reading, measures, lessons, measure_words = (core(f"lessons.{name}") for name in ('in_words', 'reading', 'measures', 'lesson', 'measure_words'))
FILES = sorted((ADDON / "lessons").glob("*.json"))
LINE = sc.BezierCurve([(0, 0, 0), (2, 4, 0)])
SHAPES = {'line': measures.Shown(LINE, {'first_weight': 3.0}), 'other': measures.Shown(LINE.translated((0, 0, 2)), {}), 'half': measures.Shown(LINE, {'position': 0.5}),
          'point': measures.Shown(LINE, core('recipes.table').RECIPES['construction'].defaults)}


def of(kind, shape="line", **arguments):
    return lessons.Measure(kind, shape, arguments)


def answer(ask, hint="Look again."):
    return in_words.answer(lessons.Step("?", ask=ask, hint=hint), SHAPES)


@pytest.mark.parametrize('measure, said', (
    (of('x', at=0.25), "coordinate x of line at 0.25 is 0.5"), (of('point_y', index=1), "coordinate y of point 1 of line is 4"),
    (of('weight', index=0), "weight of point 0 of line is 1"), (of('basis', index=1, at=0.25), "basis function 1 of line at 0.25 is 0.25"),
    (of('knot', index=2), "knot 2 of line is 1"), (of('setting', name="first_weight"), "first weight of line is 3"),
    (of('distance', to="other"), "distance of line to other is 2"), (of('x', at=of('setting', "half", name="position")), "coordinate x of line at 0.5 is 1"),
    (of('high_y', piece=1), "highest y of line, piece 1, is 4"), (of('setting', "point", name="position"), "Position of point is 0.5")))
def test_a_deed_is_said_by_its_numbers(measure, said):
    found = answer(lessons.Ask('do', (lessons.Condition(measure, 'above', 0.0),)))
    assert found == f"The solution is made: {said}. Look again."


@pytest.mark.parametrize('ask, said', (
    (lessons.Ask('number', value=0.375), "The answer is 0.375"), (lessons.Ask('number', value=of('x', at=0.25)), "The answer is 0.5"),
    (lessons.Ask('choose', choices=("one", "two."), right=1), "The answer is: two"),
    (lessons.Ask('point', shape="line", points=frozenset({2, 0})), "The points are 0, 2, counted from 0"),
    (lessons.Ask('point', shape="line", points=frozenset({1})), "The point is 1, counted from 0")))
def test_other_answers_are_said_with_their_hints(ask, said):
    assert answer(ask) == f"{said}. Look again." and answer(ask, "") == f"{said}."


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
def test_every_step_of_the_add_on_speaks_of_shapes_that_are_there(path):
    lesson, known = reading.read(path.read_text(encoding="utf-8")), set()
    for number, step in enumerate(lesson.steps, 1):
        known |= {one.shape for one in step.make}
        spoken = in_words.spoken_of(lesson.steps[:number])
        assert spoken and set(spoken) <= known and len(set(spoken)) == len(spoken)
        assert not step.move or spoken[0] == step.move[0].shape


def test_what_is_moved_is_first_and_other_shapes_are_found_wherever_they_are_named():
    line = json.loads(sc.dumps(LINE))
    steps = [{'text': "One.", 'make': [{'shape': name, 'value': line} for name in "abcd"]},
             {'text': "Two.", 'move': [{'shape': "c", 'points': [0]}],
              'watch': [{'text': "{0}", 'values': [{'measure': "distance", 'of': "a", 'to': "d"}]}]},
             {'text': "Three.", 'ask': {'point': [0], 'of': "b"}}, {'text': "Four.", 'ask': {'choose': ["x", "y"], 'right': 0}}]
    read = reading.read(json.dumps({'format': 1, 'name': "n", 'title': "t", 'steps': steps})).steps
    assert [in_words.spoken_of(read[:count]) for count in range(5)] == [(), ("a", "b", "c", "d"), ("c", "a", "d"), ("b",), ("b",)]


def given(kind):
    """Something for all that a measure takes."""
    samples = {'at': 0.5, 'at_v': 0.25, 'index': 1, 'order': 2, 'to': "other", 'name': "first_weight"}
    return lessons.Measure(kind, "line", {name: samples[name] for name in measures.KINDS[kind].takes})


@pytest.mark.parametrize('language', ("it", "pl", "ru"))
@pytest.mark.parametrize('kind', measures.KINDS)
def test_every_measure_is_named_in_every_language(kind, language):
    words = core('base.words')
    catalog = core('base.catalog').read((ADDON / "languages" / f"{language}.po").read_text(encoding='utf-8'))
    named = measure_words.named(given(kind), SHAPES)
    values = [str(value) for value in given(kind).arguments.values() if value != "first_weight"]
    words.use(lambda: catalog)
    try:
        said = words.say(named)
        assert all(value in said for value in ("line", *values)) and " of " not in said and " at " not in said
        assert said != named
    finally:
        words.use(None)
