"""A teacher makes a lesson from a scene without programming: what is right is played again, what is wrong is told in words."""

import json

import bpy
import numpy as np
import pytest

import patches
from curves import value_of
from layouts import drawn_by
from shapes import activate, add, by_hand, op
from support import part, scene_state, splinecore as sc

shelf, stage, trial, shape, recipes, making, maker = (part(name) for name in (
    'bridge.lessons.shelf', 'bridge.lessons.stage', 'bridge.lessons.trial', 'bridge.shape.shape', 'bridge.recipes.recipes', 'ui.operators.lesson_making',
    'ui.lesson_maker_panel'))
CURVE, BENT = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 2.5, 0), (4, 0, 0)]), sc.BezierCurve([(0, 0, 0), (1, 3, 0), (3, 2.5, 0), (4, 0, 0)])


def new(*obs, words="Look.", **settings):
    activate(*obs)
    assert op(bpy.ops.splinewright.new_lesson, words=words, **settings) == {'FINISHED'}
    return lesson()


def lesson():
    return making.draft_of(bpy.context)[2]


def add_step(words="And now."):
    assert op(bpy.ops.splinewright.add_lesson_step, words=words) == {'FINISHED'}
    return lesson().steps[-1]


def ask(**settings):
    assert op(bpy.ops.splinewright.ask_question, **settings) == {'FINISHED'}
    return lesson().steps[-1].ask


def construction():
    """(a curve, the construction of a point of it)"""
    curve = add(CURVE, "curve")
    op(bpy.ops.splinewright.add_construction)
    steps = bpy.context.object
    steps.name = "steps"
    return curve, steps


def set_position(ob, value):
    ob.data.splinewright_parameters.construction_position = value
    bpy.context.view_layer.update()


def bend(ob, value=BENT):
    shape.set_value(ob.data, value)
    bpy.context.view_layer.update()


def faults():
    return trial.faults(lesson(), bpy.context.scene, making.overlays(bpy.context.scene))


def corner_cutting():
    """A whole lesson, made by a teacher."""
    curve, steps = construction()
    bpy.context.scene.splinewright_sights.labels = True
    new(steps, title="Cutting Corners", words="Each leg is divided.")
    add_step("Bring the point to x = 1.5.")
    set_position(steps, 0.38823)
    activate(curve)
    ask(kind='do', measure='x', at_setting="steps\nposition", hint="Drag Position.")
    bend(curve)
    add_step("How high is it in the middle?")
    activate(curve)
    ask(kind='number', measure='y', at=0.5)
    add_step("What is level 2?")
    ask(kind='choose', choices="a point | two points | three", right=2)
    add_step("Which point moved?")
    activate(curve)
    ask(kind='point', points="1")
    return lesson()


def test_a_lesson_is_made_in_ten_steps_and_played():
    made = corner_cutting()
    assert [step.ask.kind if step.ask else "" for step in made.steps] == ["", 'do', 'number', 'choose', 'point']
    assert [(one.shape, one.recipe) for one in made.steps[0].make] == [("curve", ""), ("steps", "construction")] and made.steps[0].overlays == ("labels",)
    assert [(one.shape, one.setting) for one in made.steps[1].move] == [("steps", "position")] and made.steps[2].change[0].value == BENT
    assert faults() == [] and op(bpy.ops.splinewright.check_lesson) == {'FINISHED'}
    name = bpy.context.scene.splinewright_lesson_draft.name
    assert op(bpy.ops.splinewright.start_lesson, text=name) == {'FINISHED'}
    scene = bpy.context.window.scene = bpy.data.scenes["Cutting Corners"]
    op(bpy.ops.splinewright.lesson_step, way='NEXT')
    assert not stage.answer(scene, made)
    op(bpy.ops.splinewright.show_solution)
    assert stage.answer(scene, made)
    op(bpy.ops.splinewright.lesson_step, way='NEXT')
    assert stage.shapes_of(scene)['curve'].value == BENT and stage.answer(scene, made, BENT.evaluate(0.5)[1])
    op(bpy.ops.splinewright.leave_lesson)
    assert "Steps: 5, questions: 4" in drawn_by(maker.SPLINEWRIGHT_PT_lesson_maker, bpy.context).texts


def test_checking_leaves_the_file_as_it_was():
    corner_cutting()
    before, scenes = scene_state(), list(bpy.data.scenes)
    assert faults() == [] and scene_state() == before and list(bpy.data.scenes) == scenes


def test_shapes_are_kept_where_they_lie_in_the_world():
    ob = add(CURVE, "moved")
    ob.location, ob.rotation_euler = (1, 2, 3), (0, 0, np.pi / 2)
    made = new(ob).steps[0].make[0]
    assert np.abs(np.asarray(made.value.points) - [(1, 2, 3), (-1, 3, 3), (-1.5, 5, 3), (1, 6, 3)]).max() < 1e-6


@pytest.mark.parametrize('name', ('add_circle', 'add_torus', 'add_helix', 'add_nurbs_patch', 'add_catmull_rom'))
def test_what_numbers_make_is_made_by_the_same_numbers(name):
    op(getattr(bpy.ops.splinewright, name))
    ob = bpy.context.object
    value, recipe = shape.value_of(ob.data), recipes.kind(ob.data) if recipes.has(ob.data) else ""
    made = new(ob).steps[0].make[0]
    assert made.recipe == recipe and faults() == ["no step asks anything"]
    scene = stage.begin(lesson(), bpy.context.scene)
    assert sc.dumps(next(iter(stage.shapes_of(scene).values())).value) == sc.dumps(value)


def test_a_recipe_that_a_lesson_cannot_hold_is_kept_as_a_value_and_that_is_said():
    op(bpy.ops.splinewright.add_circle)
    ob = bpy.context.object
    ob.rotation_euler.x = 1
    assert new(ob).steps[0].make[0].recipe == ""
    assert making.kept_as_values(part('bridge.lessons.authoring').present([ob], {ob: "it"}, part('bridge.lessons.authoring').graph())) == (
        "it is kept as it is: it was turned or scaled",)


def test_points_faces_and_places_are_kept_and_lead_back():
    op(bpy.ops.splinewright.add_ducks)
    strip = bpy.context.object
    part('bridge.shape.recipe_edit').set_points(strip.data, [(0, 0, 0), (1, 2, 0), (3, 0, 0)])
    strip.location = (1, 2, 3)
    op(bpy.ops.splinewright.add_torus)
    torus = bpy.context.object
    part('bridge.data.settings').set_count(torus.data, 3, 5)
    made = {one.recipe: one for one in new(strip, torus).steps[0].make}
    assert made['ducks'].points == ((0, 0, 0), (1, 2, 0), (3, 0, 0)) and made['ducks'].place == (1, 2, 3) and made['torus'].faces == (3, 5)
    wanted = {name: sc.dumps(shape.value_of(ob.data)) for ob, name in part('bridge.lessons.authoring').known(bpy.context.scene).items()}
    scene = stage.begin(lesson(), bpy.context.scene)
    assert {name: sc.dumps(one.value) for name, one in stage.shapes_of(scene).items()} == wanted
    assert tuple(stage.object_of(scene, made['ducks'].shape).location) == (1, 2, 3)
    stage.remove(scene)
    part('bridge.shape.recipe_edit').set_points(strip.data, [(0, 0, 0), (1, 1, 0), (3, 0, 0)])
    change, = add_step().change
    assert change.points == ((0, 0, 0), (1, 1, 0), (3, 0, 0))


def test_what_is_made_from_strangers_is_kept_as_a_value():
    bpy.ops.curve.primitive_nurbs_path_add()
    op(bpy.ops.splinewright.follow_object)
    assert new(bpy.context.object).steps[0].make[0].recipe == ""


def test_new_shapes_join_in_a_step_and_copies_are_shapes_of_their_own():
    ob = add(CURVE, "curve")
    new(ob)
    activate(ob)
    bpy.ops.object.duplicate()
    bpy.context.object.data = bpy.context.object.data.copy()
    bend(bpy.context.object)
    step = add_step()
    assert [(one.shape, one.value) for one in step.make] == [("curve.001", BENT)] and not step.change
    patch = add(patches.value_of('bicubic'), "patch")
    assert [one.shape for one in add_step().make] == ["patch"] and patch.get(stage.SHAPE) == "patch"


def test_text_comes_from_the_text_editor_where_none_is_typed():
    ob = add(CURVE)
    activate(ob)
    with pytest.raises(RuntimeError, match="the step says nothing"):
        op(bpy.ops.splinewright.new_lesson)
    words = bpy.context.scene.splinewright_step_words = bpy.data.texts.new("words")
    words.from_string("Two\nlines of it.")
    assert new(ob, words="").steps[0].text == "Two\nlines of it." and bpy.context.scene.splinewright_step_words is None


def refused(operator, said, **settings):
    text = bpy.context.scene.splinewright_lesson_draft
    before = text.as_string() if text else "", scene_state(), [block.name for block in bpy.data.texts]
    with pytest.raises(RuntimeError, match=said):
        op(getattr(bpy.ops.splinewright, operator), **settings)
    text = bpy.context.scene.splinewright_lesson_draft
    assert (text.as_string() if text else "", scene_state(), [block.name for block in bpy.data.texts]) == before


def test_what_cannot_be_is_a_sentence_and_changes_nothing():
    refused('new_lesson', "Select the shapes", words="x")
    ob = add(CURVE, "curve")
    refused('new_lesson', "a letter or a digit", words="x", title="!")
    refused('new_lesson', "at most 2,000 characters", words="x" * 2001)
    new(ob)
    refused('ask_question', "bring them to where the question is answered", kind='do')
    refused('ask_question', "two answers or more", kind='choose', choices="one")
    refused('ask_question', "two answers or more", kind='choose', choices="a|b", right=3)
    refused('ask_question', "no numbers of points", kind='point', points="one")
    refused('ask_question', "the number of a point is expected", kind='point', points="")
    refused('ask_question', "there is no control point 9", kind='number', measure='weight', index=9)
    refused('ask_question', "select the curve to which the distance is", kind='number', measure='distance')
    refused('ask_question', "the shape has no", kind='number', measure='setting')
    bend(ob)
    refused('ask_question', "and not above 7: the present state must be a solution", kind='do', measure='y', at=0.5, relation='above', bound=7)
    activate(add(CURVE, "stranger"))
    refused('ask_question', "not a shape of the lesson", kind='do')
    activate(ob)
    by_hand(ob)
    refused('add_lesson_step', "changed by hand", words="x")


def test_a_shape_that_is_made_otherwise_now_is_refused_and_one_that_is_gone_stays():
    curve, steps = construction()
    new(steps)
    activate(steps)
    op(bpy.ops.splinewright.make_editable)
    refused('add_lesson_step', "steps is made otherwise than the lesson says", words="x")
    bpy.data.objects.remove(steps)
    assert add_step().change == ()


def draft(change):
    """The lesson, changed by hand in the Text Editor."""
    block = bpy.context.scene.splinewright_lesson_draft
    found = json.loads(block.as_string())
    change(found)
    block.from_string(json.dumps(found))


@pytest.mark.parametrize('change, said', (
    (lambda found: found['steps'][1]['solution'][0]['set'].update(position=0.9), "step 2: the solution does not answer the question"),
    (lambda found: found['steps'][0]['make'][1]['set'].update(position=0.38823), "step 2: the question is answered already as the step begins"),
    (lambda found: found['steps'][1].update(wrong=[found['steps'][1]['solution']]), "step 2: the wrong answer 1 is taken for right"),
    (lambda found: found['steps'][0].update(overlays=["wings"]), "step 1: there is no overlay 'wings'"),
    (lambda found: found['steps'][4]['ask'].update(point=[1, 4]), "step 5: curve has the points 0 to 3, and none with the number 4"),
    (lambda found: found['steps'][1].update(move=[{'shape': "curve", 'points': [17]}]), "step 2: curve has the points 0 to 3"),
    (lambda found: found['steps'][0]['make'].pop(0), "step 1, make 1, of 1: there is no shape 'curve' yet"),
    (lambda found: found['steps'][1]['ask']['do'][0]['that'].update(at=9.0), "step 2: ")))
def test_what_is_wrong_is_told_in_words(change, said):
    corner_cutting()
    draft(change)
    before = scene_state()
    with pytest.raises(RuntimeError, match=said):
        op(bpy.ops.splinewright.check_lesson)
    assert scene_state() == before and len(bpy.data.scenes) == 1
    assert said.split(":")[0] in " ".join(drawn_by(maker.SPLINEWRIGHT_PT_lesson_maker, bpy.context).texts)


def test_a_broken_text_is_a_sentence_everywhere():
    new(add(CURVE))
    bpy.context.scene.splinewright_lesson_draft.from_string("{")
    for name in ('add_lesson_step', 'ask_question', 'check_lesson', 'export_lesson'):
        with pytest.raises(RuntimeError, match="my-lesson.json: it is not JSON"):
            op(getattr(bpy.ops.splinewright, name))
    assert "it is not JSON" in " ".join(drawn_by(maker.SPLINEWRIGHT_PT_lesson_maker, bpy.context).texts)


def test_a_lesson_is_exported_and_started_from_its_file(tmp_path):
    made = corner_cutting()
    path = tmp_path / "cut.json"
    assert op(bpy.ops.splinewright.export_lesson, filepath=str(path)) == {'FINISHED'} and list(tmp_path.iterdir()) == [path]
    assert shelf.read(path)[0] == made
    with pytest.raises(RuntimeError, match="Name a file"):
        op(bpy.ops.splinewright.export_lesson, filepath=str(tmp_path))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    assert op(bpy.ops.splinewright.start_lesson_file, filepath=str(path)) == {'FINISHED'} and "Cutting Corners" in bpy.data.scenes


def test_steps_and_questions_can_be_undone():
    ob = add(CURVE, "curve")
    new(ob)
    begun = bpy.context.scene.splinewright_lesson_draft.as_string()
    add_step()
    bpy.ops.ed.undo()
    assert bpy.context.scene.splinewright_lesson_draft.as_string() == begun
    bpy.ops.ed.redo()
    assert len(lesson().steps) == 2
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert bpy.context.scene.splinewright_lesson_draft is None and stage.SHAPE not in bpy.data.objects["curve"].keys()


def test_a_lesson_is_not_made_inside_another():
    op(bpy.ops.splinewright.start_lesson)
    bpy.context.window.scene = next(scene for scene in bpy.data.scenes if stage.lesson_of(scene))
    assert not bpy.ops.splinewright.new_lesson.poll() and not maker.SPLINEWRIGHT_PT_lesson_maker.poll(bpy.context)


def test_the_dialogs_show_the_fields_that_count():
    curve, steps = construction()
    new(steps)
    known = part('ui.operators.lesson_questions').SPLINEWRIGHT_OT_ask_question
    for settings, wanted in (({'kind': 'choose'}, {'choices', 'right'}), ({'kind': 'point'}, {'points'}), ({'measure': 'weight'}, {'index', 'within'}),
                             ({'measure': 'x'}, {'at', 'at_setting'}), ({'measure': 'x', 'at_setting': "steps\nposition"}, {'at_setting'}),
                             ({'measure': 'setting', 'relation': 'above'}, {'setting', 'bound'})):
        own = {'kind': 'do', 'measure': 'x', 'at_setting': 'NUMBER', 'relation': 'near', **settings}
        found = known._asked(type('Asked', (), own)(), bpy.context)
        assert wanted <= set(found) and all(name in bpy.ops.splinewright.ask_question.get_rna_type().properties for name in found)
        assert 'at_setting' not in wanted or ('at' in found) == ('at' in wanted)
