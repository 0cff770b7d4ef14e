"""The lesson of a scene: go through its steps, answer, leave."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, IntProperty

from ...bridge.cage import net_object
from ...bridge.lessons import shelf, stage
from ...bridge.net import live, selection
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.lessons import in_words
from .. import editing
from ..ui_state import ui_state
from . import reports
from .lesson_start import show_view


def current(scene):
    """The lesson of a scene; None where it is of none. Raises Refusal where the add-on has it no more."""
    name = stage.lesson_of(scene)
    if not name:
        return None
    text = stage.text_of(scene)
    found = shelf.read_text(text) if text else shelf.all_lessons().get(name)
    if found is None or stage.is_damaged(scene, found):
        raise Refusal("there is no lesson {name!r} here: Leave Lesson removes its scene, Keep Scene makes it an ordinary one",
                      name=name)
    return found


def shown_answer(scene):
    """What Show Me said of this step, or ""."""
    return ui_state.lesson_shown[2] if ui_state.lesson_shown[:2] == (stage.lesson_of(scene), stage.step_of(scene)) else ""


def net_of(context, name):
    """The net in Edit Mode of a shape of the lesson, or None."""
    for held in editing.nets_in_edit_mode(context):
        owner = net_object.shape_of(held)
        if owner is not None and owner.get(stage.SHAPE) == name:
            return held
    return None


def picked_points(held):
    """Numbers of the selected points of a net, from 0. Raises Refusal."""
    net = live.session(held.data).net
    return sorted({int(row) for row in net.rows[selection.selected(held, net)]})


class _OfLesson:
    """Works on the lesson of the scene."""

    bl_options = {'REGISTER', 'UNDO', 'INTERNAL'}

    @classmethod
    def poll(cls, context):
        if not stage.lesson_of(context.scene):
            cls.poll_message_set(say("Start a lesson first"))
            return False
        return True

    def execute(self, context):
        try:
            if context.scene.library is not None:
                raise Refusal("{name} is linked from another file and cannot be changed here", name=context.scene.name)
            lesson = current(context.scene)
            if context.mode != 'OBJECT' and not self.is_about_points(context.scene, lesson):
                editing.end()
            return self.done(context, context.scene, lesson)
        except FAILURES as error:
            return reports.failed(self, error)

    def is_about_points(self, scene, lesson):
        """Whether it works on the points that are picked, and the net stays out."""
        return False


class _OfAnswer(_OfLesson):
    def is_about_points(self, scene, lesson):
        ask = lesson.steps[stage.step_of(scene)].ask
        return ask is not None and ask.kind == 'point'


class SPLINEWRIGHT_OT_lesson_step(_OfLesson, bpy.types.Operator):
    bl_idname = "splinewright.lesson_step"
    bl_label = "Change Step"
    bl_description = "Go to another step of the lesson"

    way: EnumProperty(name="Way", options={'SKIP_SAVE'}, items=(
        ('NEXT', "Next", "Go to the next step with the shapes as they are"), ('BACK', "Back", "Go to the step before, as it begins"),
        ('RESET', "Reset", "Begin this step again")))

    @classmethod
    def description(cls, context, properties):
        return say(cls.bl_rna.properties['way'].enum_items[properties.way].description)

    def done(self, context, scene, lesson):
        number = stage.step_of(scene)
        if self.way == 'NEXT':
            stage.advance(scene, lesson)
        elif self.way == 'BACK' and number == 0:
            return reports.cancelled(self, "This is the first step")
        else:
            stage.rebuild(scene, lesson, number - (self.way == 'BACK'))
        ui_state.lesson_word, ui_state.lesson_shown = "", ()
        if self.way != 'RESET':
            show_view(context, lesson.steps[stage.step_of(scene)])
        return {'FINISHED'}


class SPLINEWRIGHT_OT_check_answer(_OfAnswer, bpy.types.Operator):
    bl_idname = "splinewright.check_answer"
    bl_label = "Check Answer"
    bl_description = "Say whether the question of this step is answered"

    choice: IntProperty(name="Choice", description="The number of the chosen answer, from 0", default=-1, options={'HIDDEN', 'SKIP_SAVE'})

    def done(self, context, scene, lesson):
        ask = lesson.steps[stage.step_of(scene)].ask
        if ask is None:
            return reports.cancelled(self, "This step asks nothing")
        given = {'do': None, 'number': decimals.typed(scene.splinewright_answer), 'choose': self.choice}.get(ask.kind)
        if ask.kind == 'point':
            held = net_of(context, ask.shape)
            given = picked_points(held) if held is not None else []
            if not given:
                return reports.cancelled(self, phrase("Select points of {shape}: Pick Points shows them", shape=ask.shape))
        is_right = stage.answer(scene, lesson, given)
        ui_state.lesson_shown = ()
        ui_state.lesson_word = "Right" if is_right else "Not yet"
        return reports.finished(self, reports.Report("Right." if is_right else "Not yet."))


class SPLINEWRIGHT_OT_pick_answer(_OfAnswer, bpy.types.Operator):
    bl_idname = "splinewright.pick_answer"
    bl_label = "Pick Points"
    bl_description = "Edit the control points that the question is about: select those that you mean, then Check Answer"

    def done(self, context, scene, lesson):
        ask = lesson.steps[stage.step_of(scene)].ask
        if ask is None or ask.kind != 'point':
            return reports.cancelled(self, "This step asks for no points")
        if net_of(context, ask.shape) is not None:
            return reports.cancelled(self, phrase("The points of {shape} can be selected now", shape=ask.shape))
        if context.mode != 'OBJECT':
            editing.end()
        ob = stage.object_of(scene, ask.shape)
        for other in context.selected_objects:
            other.select_set(False)
        ob.select_set(True)
        context.view_layer.objects.active = ob
        editing.enter(context, ob)
        return {'FINISHED'}


class SPLINEWRIGHT_OT_show_solution(_OfAnswer, bpy.types.Operator):
    bl_idname = "splinewright.show_solution"
    bl_label = "Show Me"
    bl_description = "Make the solution, and say the answer with its hint; Ctrl+Z takes it back"

    def done(self, context, scene, lesson):
        step = lesson.steps[stage.step_of(scene)]
        if step.ask is None:
            return reports.cancelled(self, "This step asks nothing")
        stage.change(scene, step.solution)
        held = net_of(context, step.ask.shape) if step.ask.kind == 'point' else None
        if held is not None:
            net = live.session(held.data).net
            selection.select(held, net, np.flatnonzero(np.isin(net.rows, sorted(step.ask.points))))
        said = in_words.answer(step, stage.shapes_of(scene))
        ui_state.lesson_shown = (stage.lesson_of(scene), stage.step_of(scene), said)
        return reports.finished(self, reports.Report(said))


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
        stage.record(scene, other)
        for window in context.window_manager.windows:
            if window.scene == scene:
                window.scene = other
        stage.remove(scene)
        return {'FINISHED'}


CLASSES = (SPLINEWRIGHT_OT_lesson_step, SPLINEWRIGHT_OT_check_answer, SPLINEWRIGHT_OT_pick_answer, SPLINEWRIGHT_OT_show_solution,
           SPLINEWRIGHT_OT_leave_lesson)


def register():
    bpy.types.Scene.splinewright_lesson_in_view = BoolProperty(
        name="Text in View", description="Write the text of the lesson's step into the 3D view, at its upper left", default=True, options=set())
    bpy.types.Scene.splinewright_answer = bpy.props.FloatProperty(
        name="Answer", description="The number that answers the question", precision=4, options=set())


def unregister():
    del bpy.types.Scene.splinewright_answer
    del bpy.types.Scene.splinewright_lesson_in_view
