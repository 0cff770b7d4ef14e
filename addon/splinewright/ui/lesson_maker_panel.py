"""How a lesson is made from a scene, in the sidebar."""

import bpy

from ..bridge.lessons import shelf
from ..core.base.failures import FAILURES, sentence
from ..core.base.words import phrase, say
from . import texts
from .lesson_list_panel import BesideLessons
from .ui_state import ui_state

#: Faults that are shown.
_MOST = 6


class SPLINEWRIGHT_PT_lesson_maker(BesideLessons, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_lesson_maker"
    bl_label = "Make a Lesson"
    bl_order = 21

    def draw(self, context):
        layout, scene = self.layout, context.scene
        layout.operator("splinewright.new_lesson", text="Make from Selection", icon='ADD')
        layout.prop(scene, "splinewright_lesson_draft", text="")
        block = scene.splinewright_lesson_draft
        if block is None:
            return
        try:
            lesson, _ = shelf.read_block(block.name)
        except FAILURES as error:
            texts.draw_problem(layout, sentence(error))
            return
        asked = sum(step.ask is not None for step in lesson.steps)
        layout.label(text=say(phrase("Steps: {count}, questions: {asked}", count=len(lesson.steps), asked=asked)))
        column = layout.column(align=True)
        column.label(text="Text of the Next Step")
        column.prop(scene, "splinewright_step_words", text="")
        column = layout.column(align=True)
        column.operator("splinewright.add_lesson_step", text="Add Step")
        column.operator("splinewright.ask_question")
        column.operator("splinewright.check_lesson")
        column.operator("splinewright.start_lesson", text="Try Lesson").text = block.name
        column.operator("splinewright.export_lesson")
        for fault in ui_state.lesson_faults[:_MOST]:
            texts.draw_problem(layout, fault)
        if len(ui_state.lesson_faults) > _MOST:
            layout.label(text=say(phrase("and {count} more", count=len(ui_state.lesson_faults) - _MOST)))


CLASSES = (SPLINEWRIGHT_PT_lesson_maker,)
