"""A lesson of each lecture in the lecture's language, as a learner does it: points are dragged and picked, answers typed and chosen, first a
wrong one; then the learner's scene is as it was."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from by_keys import KEYS
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
stage, shelf, lectures, words = (part(name) for name in ('bridge.lessons.stage', 'bridge.lessons.shelf', 'core.lessons.lectures', 'core.base.words'))
ui_state = part('ui.ui_state').ui_state
#: Of each lecture the language in which it is given.
LANGUAGES = {'000': 'pl_PL', '001': 'ru_RU', '002': 'it_IT', '003': 'pl_PL', '004': 'pl_PL'}


class Learner:
    """One who does a lesson."""

    def __init__(self, view, name):
        self.view, self.name, self.known = view, name, {}
        self.scene = view.window.scene

    def reach(self, name, **modifiers):
        """Steps that bring the mouse over a button or field that a key tells by its name. Its place is looked for near the one it had."""
        sidebar, manager = self.view._region('UI'), bpy.context.window_manager
        manager.clipboard = ""
        top, bottom = sidebar.y + sidebar.height - 30, sidebar.y + 10
        near = self.known.get(name, (top + bottom) // 2)
        # The right third of a row: Next stands at the end of one.
        places = [(sidebar.x + sidebar.width * 3 // 4, y) for y in sorted(range(bottom, top, 17), key=lambda y: abs(y - near))]
        yield from self.view.search(places, lambda: name in manager.clipboard, f"a button or field {name}", 'C', scrolls=True, ctrl=True, **modifiers)
        self.known[name] = self.view.y

    def press(self, command):
        """Steps that click the button of a command of ours, which Ctrl+C over it copies."""
        yield from self.reach(command)
        self.view.press('LEFTMOUSE')
        yield

    def go_on(self):
        """Steps to the next step of the lesson."""
        before = stage.step_of(self.scene)
        yield from self.press("lesson_step(way='NEXT')")
        yield from until(lambda: stage.step_of(self.scene) == before + 1, "the next step")
        yield from redrawn()

    def check(self, told, command="check_answer("):
        """Steps that give an answer, which is said to be "Right" or "Not yet"."""
        tries = self._answer().get('tries', 0)
        yield from self.press(command)
        yield from until(lambda: self._answer().get('tries', 0) == tries + 1, "the answer is checked")
        assert self._answer()['right'] == (told == "Right"), (self.name, self._answer())
        assert ui_state.lesson_word == told and words.say(told) != told, "it is not told in the language"
        self.picture(told)

    def choose(self, wrong, right):
        yield from self.check("Not yet", f"check_answer(choice={wrong})")
        yield from self.check("Right", f"check_answer(choice={right})")

    def type(self, wrong, right):
        for number, told in ((wrong, "Not yet"), (right, "Right")):
            yield from self.reach("splinewright_answer", shift=True)
            self.view.press('RET')
            yield from redrawn()
            for letter in number:
                self.view.press(KEYS[letter], letter)
            self.view.press('RET')
            yield from until(lambda: abs(self.scene.splinewright_answer - float(number)) < 1e-6, "the number that was typed")
            yield from self.check(told)

    def _answer(self):
        return stage.answers(self.scene).get(str(stage.step_of(self.scene)), {})

    def value(self, shape):
        return part('bridge.shape.shape').value_of(stage.object_of(self.scene, shape).data)

    def place(self, shape, number):
        """A control point of a shape in the world."""
        return self.value(shape).points.reshape(-1, 3)[number]

    def enter(self, shape):
        """Steps that click the shape's curve, or surface, and press Tab."""
        self.view.move(*self.view.pixel_of(self.place(shape, 0)))
        assert bpy.context.object == stage.object_of(self.scene, shape), "the shape that is to be moved is not active"
        self.view.press('TAB')
        yield from into_net()

    def drag(self, shape, place, to, *keys):
        """Steps that click what lies at a place and pull it to another one with G."""
        before = self.value(shape)
        self.view.move(*self.view.pixel_of(place))
        self.view.press('LEFTMOUSE')
        yield from redrawn()
        for key in ('G', *keys):
            self.view.press(key)
        yield from redrawn()
        self.view.move(*self.view.pixel_of(to))
        yield from until(lambda: self.value(shape) != before, "the shape follows the mouse")
        self.view.press('LEFTMOUSE')
        yield from redrawn()

    def pick(self, shape, *numbers, more=False):
        """Steps that click control points."""
        for i, number in enumerate(numbers):
            self.view.move(*self.view.pixel_of(self.place(shape, number)))
            self.view.press('LEFTMOUSE', shift=more or i > 0)
            yield from redrawn()

    def picture(self, what):
        return save_picture(OUTPUT / f"worked-{self.name}-{stage.step_of(self.scene) + 1}-{what.lower().replace(' ', '-')}.png")


def local_control(learner):
    yield from learner.enter("whole")
    neck = learner.place("whole", 8)
    yield from learner.drag("whole", neck, neck + (0.6, 0, 0))
    yield from learner.go_on()
    yield from out_of_net()
    yield from learner.choose(0, 2)


def hermite(learner):
    yield from learner.enter("segment")
    yield from learner.pick("segment", 0)
    yield from learner.drag("segment", (0.5, 0.5, 0), (0.4, 0.9, 0))
    yield from learner.go_on()
    yield from learner.type("0.5", "0.375")
    yield from learner.go_on()
    yield from learner.go_on()
    yield from learner.check("Not yet")
    yield from learner.enter("segment")
    yield from learner.pick("segment", 0)
    yield from learner.drag("segment", (0.5, 0.5, 0), (1.5, 1.5, 0))
    yield from learner.check("Right")


def who_feeds_whom(learner):
    yield from learner.go_on()
    yield from learner.choose(0, 1)
    for _ in range(3):
        yield from learner.go_on()
    yield from learner.press("pick_answer(")
    yield from into_net()
    yield from learner.pick("curve", 4)
    yield from learner.check("Not yet")
    yield from learner.pick("curve", 1, 2, 3, more=True)
    yield from learner.check("Right")
    for _ in range(2):
        yield from learner.go_on()
    yield from learner.check("Not yet")
    yield from learner.enter("curve")
    point = learner.place("curve", 4)
    yield from learner.drag("curve", point, (0.5, 1.065, 0), 'Y')
    yield from learner.check("Right")


def c2_chain(learner):
    yield from learner.enter("spline")
    yield from learner.drag("spline", (3, 4, 0), (3, 6, 0))
    yield from learner.go_on()
    yield from learner.type("5", "4")


def patches(learner):
    yield from learner.enter("patch")
    yield from learner.drag("patch", (1, 1, 1), (1, 1, 2), 'Z')
    yield from learner.go_on()
    yield from learner.press("pick_answer(")
    yield from into_net()
    yield from learner.pick("patch", 9)
    yield from learner.check("Not yet")
    yield from learner.pick("patch", 6)
    yield from learner.check("Right")
    yield from learner.go_on()
    yield from learner.type("0.25", "0.140625")


#: Of each lecture a lesson, what is done in it, and how many answers are right in the end.
WORKED = {'000': ("local-control", local_control, 1), '001': ("hermite", hermite, 2), '002': ("who-feeds-whom", who_feeds_whom, 3),
          '003': ("c2-chain", c2_chain, 1), '004': ("patches", patches, 2)}


def users_scene():
    """What a learner has made, and what he sees of it."""
    scene = bpy.data.scenes["Scene"]
    sights = scene.splinewright_sights
    return {
        'objects': [(ob.name, tuple(map(tuple, ob.matrix_world)), ob.select_get(view_layer=scene.view_layers[0]), ob.data.name)
                    for ob in scene.objects],
        'active': scene.view_layers[0].objects.active.name,
        'value': part('bridge.shape.shape').value_of(scene.objects["Mine"].data).dumps(),
        'sights': [(name, getattr(sights, name)) for name, known in sights.bl_rna.properties.items() if known.type == 'BOOLEAN'],
        'there': [sorted(found.keys()) for found in (bpy.data.scenes, bpy.data.objects, bpy.data.meshes, bpy.data.curves, bpy.data.materials)]}


def work(view, lecture, known):
    name, done, count = WORKED[lecture]
    assert name in [lesson.name for lesson in lectures.of_lecture(shelf.all_lessons().values(), lecture)], "a lesson of another lecture"
    preferences = bpy.context.preferences.view
    preferences.language = LANGUAGES[lecture]
    preferences.use_translate_interface = preferences.use_translate_tooltips = True
    with view.override():
        assert bpy.ops.splinewright.start_lesson('INVOKE_DEFAULT', True, lesson=name) == {'FINISHED'}
    yield from until(lambda: stage.lesson_of(view.window.scene) == name, "the lesson")
    yield from redrawn()
    learner = Learner(view, name)
    learner.known.update(known)
    yield from done(learner)
    yield from learner.press("leave_lesson(how='REMOVE')")
    yield from until(lambda: len(bpy.data.scenes) == 1, "one scene")
    yield from out_of_net()
    kept = stage.recorded(bpy.data.scenes["Scene"])[name]
    assert sum(answer['right'] for answer in kept.values()) == count == len(kept), kept
    known.update(learner.known)


def steps():
    view = View()
    empty_file()
    with view.override():
        assert bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True) == {'FINISHED'}
    bpy.context.object.name = "Mine"
    yield from view.in_sidebar()
    before, known = users_scene(), {}
    for lecture in WORKED:
        yield from work(view, lecture, known)
        assert users_scene() == before, lecture
        print("done:", lecture, WORKED[lecture][0], flush=True)
    bpy.context.preferences.view.language = 'en_US'


run(steps())
