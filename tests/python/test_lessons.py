"""Lessons as their files say them: what is read, what is measured and checked; whatever else a file says is a sentence with its place."""

import copy
import json

import numpy as np
import pytest

import splinecore as sc
from addon_core import ADDON, core

reading, measures, checking, facets = (core(f"lessons.{name}") for name in ('reading', 'measures', 'checking', 'facets'))
failures, lessons = core("base.failures"), core("lessons.lesson")
FILES = sorted((ADDON / "lessons").glob("*.json"))


def value(shape):
    return json.loads(sc.dumps(shape))


CURVE = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 2.5, 0), (4, 0, 0)])
LESSON = {
    'format': 1, 'name': "corner-cutting", 'title': "Corner Cutting", 'lectures': ["001.65"],
    'steps': [
        {'text': "Four points and a parameter t.",
         'make': [{'shape': "curve", 'value': value(CURVE)},
                  {'shape': "steps", 'recipe': "construction", 'of': ["curve"], 'set': {'scheme': "casteljau", 'position': 0.5}}],
         'view': "TOP", 'overlays': ["labels"], 'move': [{'shape': "steps", 'setting': "position"}, {'shape': "curve", 'points': [1, 2]}],
         'watch': [{'text': "t = {0}, x = {1}", 'values': [{'measure': "setting", 'of': "steps", 'name': "position"},
                                                           {'measure': "x", 'of': "curve", 'at': {'measure': "setting", 'of': "steps",
                                                                                                 'name': "position"}}]}]},
        {'text': "Set t so that the point lies at x = 1.5.",
         'ask': {'do': [{'that': {'measure': "x", 'of': "curve", 'at': {'measure': "setting", 'of': "steps", 'name': "position"}},
                         'near': 1.5, 'within': 0.01}]},
         'hint': "x is 3 t + 3 t² - 2 t³.", 'solution': [{'shape': "steps", 'set': {'position': 0.3896}}],
         'wrong': [[{'shape': "steps", 'set': {'position': 0.5}}]]},
        {'text': "How many points has level 2 for degree n?", 'ask': {'choose': ["n", "n - 1", "n + 1"], 'right': 1}},
        {'text': "x at t = 1/2?", 'ask': {'number': 2.0, 'within': 0.01}}]}


def shown(position=0.5, curve=CURVE):
    return {'curve': measures.Shown(curve, {}), 'steps': measures.Shown([curve], {'position': position, 'scheme': "casteljau"})}


def test_a_lesson_is_read_and_its_answers_are_checked():
    lesson = reading.read(json.dumps(LESSON))
    first, second, third, fourth = lesson.steps
    assert (lesson.name, lesson.title, lesson.lectures) == ("corner-cutting", "Corner Cutting", ("001.65",))
    assert first.make[0].value == CURVE and first.make[1].inputs == ("curve",) and first.make[1].settings['scheme'] == "casteljau"
    assert checking.watched(first.watch[0], shown()) == "t = 0.5, x = 2"
    assert not checking.is_right(second.ask, shown()) and checking.is_right(second.ask, shown(second.solution[0].settings['position']))
    assert not checking.is_right(second.ask, shown(second.wrong[0][0].settings['position']))
    assert checking.is_right(third.ask, shown(), 1) and not checking.is_right(third.ask, shown(), 0)
    assert checking.is_right(fourth.ask, shown(), 2.005) and not checking.is_right(fourth.ask, shown(), 2.1)
    assert not checking.is_right(fourth.ask, shown())
    asked = reading.read(json.dumps(changed('steps', 3, 'ask', to={'point': [2, 1, 2], 'of': "curve"}))).steps[3].ask
    for answer, is_right in (([1, 2], True), ([2, 1], True), ([1], False), ([0, 1, 2], False), ([], False), (None, False)):
        assert checking.is_right(asked, shown(), answer) == is_right


SPLINE = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (2, 0, 0), (3, 1, 0)], [1, 2, 1, 1])
LOOP = sc.BezierCurve([(0, 0, 0), (3, 2, 0), (-2, 2, 0), (1, 0, 0)])


@pytest.mark.parametrize('kind, arguments, wanted', (
    ('x', {'at': 0.5}, 1.25), ('point_y', {'index': 1}, 2.0), ('weight', {'index': 1}, 2.0), ('count', {}, 4), ('degree', {}, 2),
    ('multiplicity', {'at': 1.0}, 1), ('multiplicity', {'at': 2.0}, 3), ('c', {'at': 1.0}, 1), ('basis', {'index': 0, 'at': 0.5}, 0.25)))
def test_measures_of_a_spline(kind, arguments, wanted):
    found = measures.measured(measures.Measure(kind, "curve", arguments), shown(curve=SPLINE))
    assert found == pytest.approx(wanted if kind != 'x' else SPLINE.evaluate(0.5)[0], abs=1e-12)


def test_measures_of_curves_without_weights():
    found = {kind: measures.measured(measures.Measure(kind, "curve", {'index': 1} if kind == 'weight' else {}), shown(curve=CORNER))
             for kind in ('weight', 'arcs')}
    assert found == {'weight': 1.0, 'arcs': 1}
    for curve in (CURVE, CORNER):
        with pytest.raises(failures.Refusal, match="no control point 9"):
            measures.measured(measures.Measure('weight', "curve", {'index': 9}), shown(curve=curve))


def test_other_measures():
    line = sc.BezierCurve([(0, 0, 0), (3, 4, 0)])
    for kind, arguments, curve, wanted in (('length', {}, line, 5.0), ('speed', {'at': 0.3}, line, 5.0), ('self_intersections', {}, LOOP, 1),
                                           ('self_intersections', {}, CURVE, 0), ('curvature', {'at': 0.5}, line, 0.0)):
        assert measures.measured(measures.Measure(kind, "curve", arguments), shown(curve=curve)) == pytest.approx(wanted, abs=1e-9)
    shapes = {**shown(curve=line), 'other': measures.Shown(sc.BezierCurve([(0, 0, 0), (3, 4, 2)]), {})}
    assert measures.measured(measures.Measure('distance', "curve", {'to': "other"}), shapes) == pytest.approx(np.sqrt(100 / 29), rel=1e-3)


CORNER = sc.HermiteCurve([(0, 0), (1, 0), (1, 2)], [[(1, 0), (1, 0)], [(1, 0), (0, 3)], [(0, 1), (0, 1)]])
STOP = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 3, 3, 3, 3], [(0, 0), (0, 2), (3, 3), (3, 3), (3, 3), (7, 1), (8, 0)])


@pytest.mark.parametrize('kind, arguments, curve, wanted', (
    ('jump', {'at': 1.0, 'order': 1}, CORNER, np.sqrt(10)), ('jump', {'at': 0.5, 'order': 1}, CORNER, 0.0), ('angle', {'at': 1.0}, CORNER, np.pi / 2),
    ('jump', {'at': 1.0, 'order': 1}, STOP, 0.0), ('jump', {'at': 1.0, 'order': 0}, CORNER, 0.0),
    ('jump', {'at': 1.0, 'order': 3}, STOP, np.hypot(30.75, 2.25)), ('c', {'at': 1.0}, STOP, 1), ('g', {'at': 1.0}, STOP, 0), ('high_y', {}, LOOP, 1.5),
    ('low_x', {}, LOOP, 0.0), ('high_x', {}, LOOP, 1.0), ('low_y', {}, LOOP, 0.0), ('high_z', {}, LOOP, 0.0)))
def test_measures_of_joints_and_boxes(kind, arguments, curve, wanted):
    found = measures.measured(measures.Measure(kind, "curve", arguments), shown(curve=curve))
    assert found == pytest.approx(wanted, abs=1e-4)


@pytest.mark.parametrize('start, head, wanted', (
    ((3, 4, 0), (6, 8, 0), {'c': 1, 'g': 1, 'gap': 0, 'angle': 0}), ((3, 4, 0), (4.5, 6, 0), {'c': 0, 'g': 1, 'gap': 0, 'angle': 0}),
    ((3, 4, 0), (-1, 7, 0), {'c': 0, 'g': 0, 'gap': 0, 'angle': np.pi / 2}), ((3, 4, 2), (6, 8, 2), {'c': -1, 'g': -1, 'gap': 2, 'angle': 0})))
def test_measures_of_a_joint_with_another_curve(start, head, wanted):
    shapes = {'line': measures.Shown(sc.BezierCurve([(0, 0, 0), (3, 4, 0)]), {}), 'next': measures.Shown(sc.BezierCurve([start, head]), {})}
    for name, number in wanted.items():
        if name in ('c', 'g') and number == 1:
            assert measures.measured(measures.Measure(f"joint_{name}", "line", {'to': "next"}), shapes) >= 1
        else:
            assert measures.measured(measures.Measure(f"joint_{name}", "line", {'to': "next"}), shapes) == pytest.approx(number, abs=1e-7)


def drawn(value, places, faces):
    """A Shown of a surface with a mesh of quadrangles."""
    edges = {tuple(sorted(pair)) for face in faces for pair in zip(face, (*face[1:], face[0]))}
    mesh = facets.Facets(np.array(places, dtype=float), np.array(sorted(edges)), np.concatenate(faces), 4 * np.arange(len(faces)))
    return {'surface': measures.Shown(value, {}, lambda: mesh)}


@pytest.mark.parametrize('count', (3, 8, 40))
@pytest.mark.parametrize('as_set', (False, True))
def test_facets_of_a_cylinder_are_as_far_as_the_middles_of_chords(count, as_set):
    turns = 2 * np.pi * np.arange(count) / count
    places = [(2 * np.cos(t), 2 * np.sin(t), z) for z in (0, 1) for t in turns]
    faces = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    cylinder = sc.build.cylinder((0, 0, 0), (0, 0, 1), 2.0, 1.0)
    shapes = drawn(sc.PatchSet.from_patches([cylinder]) if as_set else cylinder, places, faces)
    assert measures.measured(measures.Measure('faces', "surface", {}), shapes) == count
    found = measures.measured(measures.Measure('facet_distance', "surface", {}), shapes)
    assert found == pytest.approx(2 * (1 - np.cos(np.pi / count)), rel=1e-9)


@pytest.mark.parametrize('top, corner, wanted', ((0.4, 0, 0.1), (0, 0, 0), (0, 1, 0.5)))
def test_edges_and_middles_of_facets_are_measured(top, corner, wanted):
    """A square under a hill that is a quarter as high as its middle control point, and one of which a corner is lifted from the plane."""
    hill = sc.BezierPatch([[(u, v, top * (u == v == 0.5)) for v in (0, 0.5, 1)] for u in (0, 0.5, 1)])
    shapes = drawn(hill, [(0, 0, 0), (1, 0, 0), (1, 1, corner), (0, 1, 0)], [(0, 1, 2, 3)])
    assert measures.measured(measures.Measure('facet_distance', "surface", {}), shapes) == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize('kind, arguments, said', (
    ('faces', {}, "it is not a surface"), ('facet_distance', {}, "it is not a surface"), ('setting', {'name': "radius"}, "no number 'radius'"),
    ('length', {'piece': 2}, "no piece 2"), ('jump', {'at': 0.5, 'order': 4}, "orders 0 to 3"), ('joint_g', {'to': "nobody"}, "no shape 'nobody' now"), ('point_x', {'index': 4}, "no control point 4")))
def test_what_cannot_be_measured_is_a_sentence(kind, arguments, said):
    with pytest.raises(failures.Refusal, match=said):
        measures.measured(measures.Measure(kind, "curve", arguments), shown())
    with pytest.raises(failures.Refusal, match="it is not a curve"):
        measures.measured(measures.Measure('length', "surface", {}), drawn(sc.build.sphere((0, 0, 0), 1.0), np.eye(4, 3), [(0, 1, 2, 3)]))


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
def test_a_lesson_of_the_add_on_asks_and_its_pictures_have_numbers(path):
    lesson = reading.read(path.read_text(encoding="utf-8"))
    asks = [step.ask for step in lesson.steps if step.ask]
    assert asks and lesson.lectures and path.stem[:2].isdigit() and path.stem[3:] == lesson.name
    assert all(step.hint for step in lesson.steps if step.ask)
    for ask in asks:
        assert ask.kind != 'choose' or len(set(ask.choices)) == len(ask.choices)
    assert all(step.wrong for step in lesson.steps if step.ask and step.ask.kind == 'do')


@pytest.mark.parametrize('path', FILES, ids=lambda path: path.stem)
def test_numbers_are_asked_of_shapes_as_the_step_says_them(path):
    """A shape that a learner may have moved before is brought back."""
    moved = set()
    for number, step in enumerate(reading.read(path.read_text(encoding="utf-8")).steps, 1):
        moved -= {one.shape for one in step.change}
        if step.ask is not None and isinstance(step.ask.value, lessons.Measure):
            assert step.ask.value.shape not in moved, f"step {number}"
        moved |= {one.shape for one in step.move}


def changed(*path, to):
    """The lesson with something else at a place; None as `to` takes it away."""
    other = copy.deepcopy(LESSON)
    place = other
    for name in path[:-1]:
        place = place[name]
    if to is None:
        del place[path[-1]]
    else:
        place[path[-1]] = to
    return other


def of_tori(steps, each, faces):
    """A lesson of steps, each of which makes tori, with faces or without."""
    more = {'faces': faces} if faces else {}
    return {'format': 1, 'name': "tori", 'title': "Tori", 'steps': [
        {'text': "More.", 'make': [{'shape': f"torus {i}.{k}", 'recipe': 'torus', **more} for k in range(each)]} for i in range(steps)]}


@pytest.mark.parametrize('steps, each, faces, said', (
    (1, 40, [100, 100], "ask for 400,000 faces of a span in sum: 40,000 are the most"), (5, 1, [100, 100], "50,000 faces"),
    (6, 40, None, "makes 240 shapes: 200 are the most")))
def test_lessons_are_bounded_in_sum(steps, each, faces, said):
    with pytest.raises(failures.Refusal, match=said):
        reading.read(json.dumps(of_tori(steps, each, faces)))


@pytest.mark.parametrize('steps, each, faces', ((4, 1, [100, 100]), (5, 40, None), (5, 40, [12, 12])))
def test_lessons_within_the_bounds_are_read(steps, each, faces):
    assert len(reading.read(json.dumps(of_tori(steps, each, faces))).steps) == steps


STEP = ('steps', 0)
DO = ('steps', 1, 'ask', 'do', 0)


@pytest.mark.parametrize('path, to, said', (
    (('format',), 2, "this version reads 1"), (('format',), True, "this version reads 1"), (('title',), None, "'title' is missing"), (('title',), 3, "title: a text"),
    (('steps',), [], "1 to 60 steps"), (('steps',), "many", "1 to 60 steps"), ((*STEP, 'run'), "import os", "step 1: 'run' is not known"),
    ((*STEP, 'make', 0, 'value'), {'bezier': "no"}, "step 1, make 1, value: it is not a curve or patch"),
    ((*STEP, 'make', 1, 'recipe'), "exec", "there is no recipe 'exec'"), ((*STEP, 'make', 1, 'of'), [], "it is made from one curve, not from 0"),
    ((*STEP, 'make', 1, 'of'), ["nobody"], "no shape 'nobody' yet"), ((*STEP, 'make', 1, 'set'), {'position': "far"}, "it must be a number"),
    ((*STEP, 'make', 1, 'set'), {'position': 7.0}, "from 0 to 1"), ((*STEP, 'make', 1, 'set'), {'wings': 2}, "has no setting 'wings'"),
    ((*STEP, 'make', 1, 'points'), [[0, 0, 0]], "no recipe that is made from points"), ((*STEP, 'make', 1, 'faces'), [3], "two numbers up to 100"),
    ((*STEP, 'make', 1, 'faces'), [3, 101], "two numbers up to 100"), ((*STEP, 'make', 1, 'faces'), [0, 3], "a whole number from 1"),
    ((*STEP, 'make', 1, 'place'), [0, 3], "a point [x, y, z]".replace("[", r"\[")), ((*STEP, 'make', 0, 'place'), [0, 3, 0], "only what a recipe makes"),
    (('steps', 1, 'solution'), [{'shape': "steps", 'points': [[0, 0, 0]]}], "no recipe that is made from points"),
    (('steps', 1, 'solution'), [{'shape': "steps"}], "one of value, set, points, faces"),
    ((*STEP, 'watch', 0, 'values', 0, 'piece'), 1, "'piece' is not known"), ((*STEP, 'make', 1, 'shape'), "curve", "is there already"), ((*STEP, 'view'), "BELOW", "must be one of TOP"),
    ((*STEP, 'move', 0, 'setting'), "wings", "has no setting 'wings'"), ((*STEP, 'move', 1, 'points'), [-1], "a whole number from 0"),
    ((*STEP, 'watch', 0, 'text'), "x = {5}", "stand for its values"), ((*STEP, 'watch', 0, 'values', 0, 'measure'), "eval", "a measure is expected"),
    ((*STEP, 'watch', 0, 'values', 0, 'name'), "wings", "no setting 'wings'"), ((*DO, 'near'), None, "one of near, above, below"),
    ((*DO, 'near'), True, "a number below 1e12"), ((*DO, 'near'), 1e400, "a number below 1e12"), ((*DO, 'within'), 0, "near needs a number above 0"),
    (('steps', 1, 'solution'), None, "needs a solution"), (('steps', 1, 'solution'), [{'shape': "curve", 'set': {}}], "has no recipe"),
    (('steps', 1, 'solution'), [{'shape': "steps", 'value': {}}], "made by a recipe"),
    (('steps', 2, 'ask', 'right'), 3, "two choices or more"), (('steps', 2, 'ask', 'choose'), ["one"], "two choices or more"),
    (('steps', 3, 'ask', 'within'), -1, "a number above 0"), (('steps', 3, 'ask'), {'guess': 1}, "one of do, number, choose, point"),
    (('steps', 3, 'ask'), {'point': [1]}, "'of' is missing"), (('steps', 3, 'ask'), {'point': [], 'of': "curve"}, "the number of a point"),
    (('steps', 3, 'ask'), {'point': [-1], 'of': "curve"}, "a whole number from 0"), (('steps', 3, 'ask'), {'point': 1, 'of': "curve"}, "a list is"),
    (('steps', 3, 'ask'), {'point': [1.5], 'of': "curve"}, "a whole number from 0"),
    (('steps', 3, 'ask'), {'point': [1], 'of': "steps"}, "none can be picked"), (('steps', 3, 'ask'), {'point': [1], 'of': "no"}, "no shape 'no' yet"),
    ((*STEP, 'picture'), "lost.png", "step 1: 'picture' is not known"),
    ((*STEP, 'watch', 0, 'values', 0, 'measure'), [], "a measure is expected"),
    ((*STEP, 'watch', 0, 'values', 0, 'measure'), {}, "a measure is expected"),
    ((*STEP, 'watch', 0, 'text'), "x = {10}", "stand for its values"),
    ((*STEP, 'make', 0, 'value'), {'format': "splinecore", 'version': 1, 'items': []}, "make 1, value: it is not a curve or patch: value is an empty"),
    (('title',), "Corner \ud800", "title: it has characters that cannot be kept"),
    (('title',), "Corner\0Cutting", "title: it has characters that cannot be kept"),
    ((*STEP, 'make', 1, 'set'), {'scheme': "\ud800"}, "set, scheme: it has characters that cannot be kept"),
    ((*STEP, 'hint'), "Look.", "step 1: a hint needs a question"), ((*STEP, 'wrong'), [[]], "step 1: wrong answers need"),
    ((*STEP, 'solution'), [{'shape': "steps", 'set': {'position': 0.1}}], "step 1: a solution needs"),
    (('steps', 2, 'solution'), [{'shape': "steps", 'set': {'position': 0.1}}], "step 3: a solution needs"),
    (('steps', 2, 'wrong'), [[{'shape': "steps", 'set': {'position': 0.1}}]], "step 3: wrong answers need"),
    (('steps', 0, 'text'), "x" * 3000, "at most 2,000 characters"), (('steps', 0, 'overlays'), ["labels"] * 100, "40 are the most")))
def test_what_a_file_must_not_say_is_a_sentence_with_its_place(path, to, said):
    with pytest.raises(failures.Refusal, match=said.replace("(", r"\(")):
        reading.read(json.dumps(changed(*path, to=to)))


@pytest.mark.parametrize('text', ("", "{", "[]", "3", '"lesson"', "[" * 100_000, "null", '{"format": 1' + " " * 3_000_000 + "}"))
def test_what_is_no_lesson_is_refused(text):
    with pytest.raises(failures.Refusal):
        reading.read(text)


@pytest.mark.parametrize('depth, is_read', ((1, True), (8, True), (9, False), (300, False), (900, False)))
def test_measures_of_measures_have_an_end(depth, is_read):
    text = json.dumps(changed('steps', 3, 'ask', 'number', to="HERE")).replace(
        '"HERE"', '{"measure": "x", "of": "curve", "at": ' * depth + "0.5" + "}" * depth)
    if is_read:
        assert reading.read(text).steps[3].ask.value.kind == 'x'
        return
    with pytest.raises(failures.Refusal, match="8 deep|JSON"):
        reading.read(text)


def test_a_name_that_is_there_twice_is_refused():
    with pytest.raises(failures.Refusal, match="'title' is there twice"):
        reading.read(json.dumps(LESSON)[:-1] + ', "title": "Another One"}')


def test_what_is_wrong_is_said_briefly():
    with pytest.raises(failures.Refusal) as found:
        reading.read(json.dumps(changed('format', to=[1] * 500_000)))
    assert len(str(found.value)) < 1100


def test_eleven_values_are_watched_by_two_digits():
    value = LESSON['steps'][0]['watch'][0]['values'][0]
    watch = reading.read(json.dumps(changed('steps', 0, 'watch', 0, to={'text': "{0} {10}", 'values': [value] * 11}))).steps[0].watch[0]
    assert checking.watched(watch, shown(0.25)) == "0.25 0.25"


def test_random_damage_is_refused_or_read_never_anything_else():
    rng = np.random.default_rng(5)
    odd = (None, True, -1, 1e308, "", "x", [], {}, [[]], {"measure": "x"}, "curve", "steps", 0, 3.5)
    refused = 0
    for _ in range(1500):
        other = copy.deepcopy(LESSON)
        place = other
        while isinstance(place, (dict, list)) and place:
            keys = list(place) if isinstance(place, dict) else list(range(len(place)))
            key = keys[rng.integers(len(keys))]
            if not isinstance(place[key], (dict, list)) or rng.random() < 0.2:
                place[key] = copy.deepcopy(odd[rng.integers(len(odd))])
                break
            place = place[key]
        try:
            reading.read(json.dumps(other))
        except failures.Refusal:
            refused += 1
    assert refused > 1000
