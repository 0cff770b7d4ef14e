"""The scene of a lesson: steps build its shapes, and answers are kept with it."""

import json
from functools import partial

import bpy
import numpy as np

from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase
from ...core.lessons import answers as kept_answers
from ...core.lessons import checking, in_words, sizes
from ...core.lessons.facets import Facets
from ...core.lessons.measures import Shown
from ...core.recipes.table import RECIPES
from ..data import blocks, settings, store
from ..follow import follow, making
from ..recipes import recipes
from ..shape import recipe_edit, shape

#: On a scene: the name of its lesson, the number of the step from 0, the answers as JSON, the name of the scene before, and the text of
#: a lesson that is not the add-on's.
LESSON, STEP, ANSWERS, BEFORE, FILE = (f"splinewright_lesson{suffix}" for suffix in ("", "_step", "_answers", "_before", "_file"))
#: On a scene that was no lesson's, or is none any more: the answers of lessons that were left.
RECORD = "splinewright_lesson_record"
#: On an object: the name by which a lesson knows it.
SHAPE = "splinewright_lesson_shape"
#: Of the reason why a shape cannot be made, most characters that are told.
_MOST_SAID = 300


def lesson_of(scene):
    """The name of the lesson that a scene is for, or ""."""
    return str(scene.get(LESSON, ""))


def step_of(scene):
    """The number of its step, from 0."""
    found = scene.get(STEP, 0)
    return found if isinstance(found, int) and found >= 0 else 0


def text_of(scene):
    """The text of its lesson, or "" where that is one of the add-on's."""
    return str(scene.get(FILE, ""))


def begin(lesson, before, text=""):
    """A new scene with the first step of a lesson; before: the scene that is shown now; text: as of text_of(). Raises Refusal or an error
    of the library."""
    scene = bpy.data.scenes.new(lesson.title)
    scene[LESSON], scene[STEP], scene[BEFORE], scene[FILE] = lesson.name, 0, before.name, text
    scene[ANSWERS] = json.dumps(recorded(before).get(lesson.name, {}))
    try:
        rebuild(scene, lesson, 0)
    except Exception:
        remove(scene)
        raise
    return scene


def rebuild(scene, lesson, number):
    """Make the shapes of a step again, as they are when a learner comes to it: of all steps up to it, with their changes. Raises as
    begin()."""
    _clear(scene)
    for i in range(number + 1):
        _play(scene, lesson, i)
    scene[STEP] = number
    _select(scene, lesson)


def advance(scene, lesson):
    """Go to the next step with the shapes as they are. Raises as begin(), and stays then, without the shapes of that step."""
    number = step_of(scene) + 1
    if number >= len(lesson.steps):
        raise Refusal("this is the last step")
    known = set(scene.objects)
    try:
        _play(scene, lesson, number)
    except Exception:
        _remove(scene, set(scene.objects) - known)
        raise
    scene[STEP] = number
    _select(scene, lesson)


def _select(scene, lesson):
    """Let what the step speaks of be selected, and the shape to be moved be active. Shapes that a learner removed are left out."""
    names = in_words.spoken_of(lesson.steps[:step_of(scene) + 1])
    shown = {str(ob[SHAPE]): ob for ob in scene.view_layers[0].objects if SHAPE in ob.keys()}
    for ob in scene.view_layers[0].objects:
        ob.select_set(ob in (shown.get(name) for name in names), view_layer=scene.view_layers[0])
    scene.view_layers[0].objects.active = next((shown[name] for name in names if name in shown), None)


def _play(scene, lesson, number):
    """Make and change the shapes of a step. Raises Refusal that names the lesson, the step and the shape."""
    step = lesson.steps[number]
    for one, done, pattern in (*((make, _make, "{lesson}, step {number}: {shape} cannot be made: {reason}") for make in step.make),
                               *((each, _change, "{lesson}, step {number}: {shape} cannot be changed: {reason}") for each in step.change)):
        try:
            done(scene, one)
        except FAILURES as error:
            raise Refusal(pattern, lesson=phrase(lesson.title), number=number + 1, shape=one.shape, reason=_short(sentence(error))) from error


def _short(reason):
    return reason if len(reason) <= _MOST_SAID else reason[:_MOST_SAID] + "…"


def _make(scene, make):
    if make.recipe:
        recipe = RECIPES[make.recipe]
        current = graph(scene)
        if make.inputs:
            ob = making.from_objects(recipe, [object_of(scene, name) for name in make.inputs], make.settings, None, scene, current)
        else:
            data = making.from_points(recipe, make.points or None, make.settings, scene)
            ob = bpy.data.objects.new(data.name, data)
    else:
        data = shape.new_data(make.shape, make.value, (12, 12, settings.AUTOMATIC))
        ob = bpy.data.objects.new(make.shape, data)
    ob[SHAPE] = make.shape
    if any(make.place):
        ob.location = make.place
    scene.collection.objects.link(ob)
    if make.faces:
        _set_faces(scene, ob.data, make.faces)
    graph(scene)


def change(scene, changes):
    """Give shapes other values or settings. Raises as begin()."""
    for one in changes:
        _change(scene, one)


def _change(scene, one):
    data = object_of(scene, one.shape).data
    if one.faces:
        _set_faces(scene, data, one.faces)
        return
    if one.value is not None:
        shape.set_value(data, one.value)
    elif one.points:
        recipe_edit.set_points(data, one.points)
    elif recipes.follows(data):
        follow.set_parameters(data, one.settings, graph(scene))
    else:
        recipe_edit.set_parameters(data, one.settings)
    follow.refresh({data}, graph(scene))


def _set_faces(scene, data, faces):
    """Show a surface by a number of faces in each span. Raises Refusal where the scene would have too many."""
    others = {ob.data for ob in scene.objects if isinstance(ob.data, bpy.types.Mesh)} - {data}
    if isinstance(data, bpy.types.Mesh):
        sizes.require_room(store.read(data), faces, sum(len(other.polygons) for other in others))
    settings.set_count(data, *faces)


def graph(scene):
    """The depsgraph of a lesson's scene, up to date."""
    layer = scene.view_layers[0]
    layer.update()
    return layer.depsgraph


def object_of(scene, name):
    """The object of a shape of the lesson. Raises Refusal where a learner removed it."""
    found = next((ob for ob in scene.objects if ob.get(SHAPE) == name), None)
    if found is None or not shape.has_shape(found):
        raise Refusal("{name} is gone: Reset brings it back", name=name)
    return found


def shapes_of(scene):
    """{name: core.lessons.measures.Shown} of the shapes that are there. Raises UnreadableDefinition."""
    return {str(ob[SHAPE]): _shown(ob.data) for ob in scene.objects if SHAPE in ob.keys() and shape.has_shape(ob)}


def _shown(data):
    drawn = partial(_facets, data) if isinstance(data, bpy.types.Mesh) else None
    return Shown(shape.value_of(data), recipes.parameters(data) if recipes.has(data) else {}, drawn)


def _facets(mesh):
    places, edges = np.empty(3 * len(mesh.vertices), np.float32), np.empty(2 * len(mesh.edges), np.int32)
    corners, starts = np.empty(len(mesh.loops), np.int32), np.empty(len(mesh.polygons), np.int32)
    mesh.vertices.foreach_get('co', places)
    mesh.edges.foreach_get('vertices', edges)
    mesh.loops.foreach_get('vertex_index', corners)
    mesh.polygons.foreach_get('loop_start', starts)
    return Facets(places.reshape(-1, 3).astype(np.float64), edges.reshape(-1, 2), corners, starts)


def answer(scene, lesson, given=None):
    """Whether the question of the step is answered, by the shapes or by a given answer; it is kept. Raises what measures raise."""
    number = step_of(scene)
    is_right = checking.is_right(lesson.steps[number].ask, shapes_of(scene), given)
    known = answers(scene)
    tries = kept_answers.tries(known.get(str(number), {}))
    known[str(number)] = {'answer': given, 'right': is_right, 'tries': tries + 1}
    scene[ANSWERS] = json.dumps(known)
    return is_right


def answers(scene):
    """{number of a step as text: {'answer', 'right', 'tries'}}; none where they are damaged."""
    return kept_answers.read(scene.get(ANSWERS, "{}"))


def recorded(scene):
    """{name of a lesson: answers()} of lessons that were left; none where they are damaged."""
    return kept_answers.read_record(scene.get(RECORD, "{}"))


def record(scene, other):
    """Keep the answers of a lesson's scene, and those of lessons that were begun in it and left, with another one, which stays, or with
    itself."""
    given = {name: found for name, found in all_answers(scene).items() if found}
    if given:
        other[RECORD] = json.dumps(kept_answers.merged([recorded(other), given]))


def all_answers(scene):
    """{name of a lesson: answers()} of a scene: of the lesson that it shows, and of those that were left."""
    own = {lesson_of(scene): answers(scene)} if lesson_of(scene) else {}
    return kept_answers.merged([recorded(scene), own])


def keep(scene):
    """Make it an ordinary scene, which keeps the answers."""
    record(scene, scene)
    for owner, names in ((scene, (LESSON, STEP, ANSWERS, BEFORE, FILE)), *((ob, (SHAPE,)) for ob in scene.objects)):
        for name in names:
            if name in owner.keys():
                del owner[name]


def before(scene):
    """The scene that was shown before the lesson, or another one; None where there is none."""
    others = [other for other in bpy.data.scenes if other != scene]
    return next((other for other in others if other.name == scene.get(BEFORE)), others[0] if others else None)


def remove(scene):
    """Take the scene of a lesson out of the file, with all that is in it alone."""
    _clear(scene)
    bpy.data.scenes.remove(scene)


def _clear(scene):
    _remove(scene, list(scene.collection.all_objects))


def _remove(scene, obs):
    for ob in obs:
        if ob.users_scene == (scene,):
            data = ob.data
            bpy.data.objects.remove(ob)
            if isinstance(data, (bpy.types.Mesh, bpy.types.Curve)):
                _remove_with_materials(data)


def _remove_with_materials(data):
    materials = set(data.materials) - {None}
    blocks.remove(data)
    for material in materials:
        if not material.users:
            bpy.data.materials.remove(material)


def is_damaged(scene, lesson):
    """Whether the scene says a step that the lesson has not."""
    return step_of(scene) >= len(lesson.steps)
