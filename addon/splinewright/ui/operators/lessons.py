"""Lessons: begin one, go through its steps, answer, leave."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ...bridge.lessons import shelf, stage
from ...core.base.failures import FAILURES, Refusal
from .. import editing
from ..ui_state import ui_state
from . import polls, reports

_VIEWS = ('TOP', 'FRONT', 'RIGHT')


def current(scene):
    """The lesson of a scene; None where it is of none. Raises Refusal where the add-on has it no more."""
    name = stage.lesson_of(scene)
    if not name:
        return None
    found = shelf.all_lessons().get(name)
    if found is None or stage.is_damaged(scene, found):
        raise Refusal(f"there is no lesson {name!r} here: Leave Lesson removes its scene, Keep Scene makes it an ordinary one")
    return found


def _lessons(_self, _context):
    """Blender needs the texts to live on."""
    global _items
    _items = [(name, lesson.title, " ".join(lesson.lectures)) for name, lesson in shelf.all_lessons().items()]
    return _items


_items = []


def show_view(context, step):
    """Look from where a step is seen best, at all that it shows."""
    chosen = context.scene.splinewright_sights
    for name in step.overlays:
        if hasattr(chosen, name):
            setattr(chosen, name, True)
    area = context.area
    if area is None or area.type != 'VIEW_3D':
        return
    region = next(region for region in area.regions if region.type == 'WINDOW')
    with context.temp_override(area=area, region=region):
        if step.view in _VIEWS:
            bpy.ops.view3d.view_axis(type=step.view)
        bpy.ops.view3d.view_all()


class _OfLesson:
    """Works on the lesson of the scene."""

    bl_options = {'REGISTER', 'UNDO', 'INTERNAL'}

    @classmethod
    def poll(cls, context):
        if not stage.lesson_of(context.scene):
            cls.poll_message_set("Start a lesson first")
            return False
        return True

    def execute(self, context):
        if context.mode != 'OBJECT':
            editing.end()
        try:
            return self.done(context, context.scene, current(context.scene))
        except FAILURES as error:
            return reports.failed(self, error)


class SPLINEWRIGHT_OT_start_lesson(bpy.types.Operator):
    bl_idname = "splinewright.start_lesson"
    bl_label = "Start Lesson"
    bl_description = "Open a lesson in a scene of its own; your scene stays as it is"
    bl_options = {'REGISTER', 'UNDO'}

    lesson: EnumProperty(name="Lesson", description="Which lesson is opened", items=_lessons, options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.in_object_mode(cls, context)

    def execute(self, context):
        try:
            lesson = shelf.all_lessons()[self.lesson]
            scene = stage.begin(lesson, context.scene)
        except FAILURES as error:
            return reports.failed(self, error)
        if context.window is not None:
            context.window.scene = scene
            show_view(context, lesson.steps[0])
        return reports.finished(self, reports.Report(f"{lesson.title}: the sidebar has its steps"))


class SPLINEWRIGHT_OT_lesson_step(_OfLesson, bpy.types.Operator):
    bl_idname = "splinewright.lesson_step"
    bl_label = "Change Step"
    bl_description = "Go to another step of the lesson"

    way: EnumProperty(name="Way", options={'SKIP_SAVE'}, items=(
        ('NEXT', "Next", "Go to the next step with the shapes as they are"), ('BACK', "Back", "Go to the step before, as it begins"),
        ('RESET', "Reset", "Begin this step again")))

    @classmethod
    def description(cls, context, properties):
        return cls.bl_rna.properties['way'].enum_items[properties.way].description

    def done(self, context, scene, lesson):
        number = stage.step_of(scene)
        if self.way == 'NEXT':
            stage.advance(scene, lesson)
        elif self.way == 'BACK' and number == 0:
            return reports.cancelled(self, "This is the first step")
        else:
            stage.rebuild(scene, lesson, number - (self.way == 'BACK'))
        ui_state.lesson_word = ""
        if self.way != 'RESET':
            show_view(context, lesson.steps[stage.step_of(scene)])
        return {'FINISHED'}


class SPLINEWRIGHT_OT_check_answer(_OfLesson, bpy.types.Operator):
    bl_idname = "splinewright.check_answer"
    bl_label = "Check Answer"
    bl_description = "Say whether the question of this step is answered"

    choice: IntProperty(name="Choice", description="The number of the chosen answer, from 0", default=-1, options={'HIDDEN', 'SKIP_SAVE'})

    def done(self, context, scene, lesson):
        ask = lesson.steps[stage.step_of(scene)].ask
        if ask is None:
            return reports.cancelled(self, "This step asks nothing")
        given = {'do': None, 'number': scene.splinewright_answer, 'choose': self.choice}[ask.kind]
        is_right = stage.answer(scene, lesson, given)
        ui_state.lesson_word = "Right" if is_right else "Not yet"
        return reports.finished(self, reports.Report(f"{ui_state.lesson_word}."))


class SPLINEWRIGHT_OT_show_solution(_OfLesson, bpy.types.Operator):
    bl_idname = "splinewright.show_solution"
    bl_label = "Show Me"
    bl_description = "Make what is asked for; Ctrl+Z takes it back"

    def done(self, context, scene, lesson):
        step = lesson.steps[stage.step_of(scene)]
        if step.ask is not None and step.ask.kind == 'choose':
            return reports.finished(self, reports.Report(f"The answer is: {step.ask.choices[step.ask.right]}"))
        if not step.solution:
            return reports.cancelled(self, "This step has nothing to show")
        stage.change(scene, step.solution)
        return {'FINISHED'}


class SPLINEWRIGHT_OT_leave_lesson(_OfLesson, bpy.types.Operator):
    bl_idname = "splinewright.leave_lesson"
    bl_label = "Leave Lesson"
    bl_description = "Go back to your scene, and remove the lesson's"

    how: EnumProperty(name="Scene", options={'SKIP_SAVE'}, items=(
        ('REMOVE', "Remove Scene", "Remove the lesson's scene with its shapes"),
        ('KEEP', "Keep Scene", "Make the lesson's scene an ordinary one, and stay in it")))

    def execute(self, context):
        scene = context.scene
        if context.mode != 'OBJECT':
            editing.end()
        if self.how == 'KEEP':
            stage.keep(scene)
            return {'FINISHED'}
        other = stage.before(scene) or bpy.data.scenes.new("Scene")
        for window in context.window_manager.windows:
            if window.scene == scene:
                window.scene = other
        stage.remove(scene)
        return {'FINISHED'}


CLASSES = (SPLINEWRIGHT_OT_start_lesson, SPLINEWRIGHT_OT_lesson_step, SPLINEWRIGHT_OT_check_answer, SPLINEWRIGHT_OT_show_solution,
           SPLINEWRIGHT_OT_leave_lesson)


def register():
    bpy.types.Scene.splinewright_answer = bpy.props.FloatProperty(
        name="Answer", description="The number that answers the question", precision=4, options=set())


def unregister():
    del bpy.types.Scene.splinewright_answer
