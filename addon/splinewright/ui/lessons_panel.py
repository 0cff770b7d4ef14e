"""The lesson of a scene, in the sidebar: the text of a step, numbers to watch, and the question."""

import bpy

from ..bridge.lessons import stage
from ..core.base.failures import FAILURES, sentence
from ..core.base.words import phrase, say
from ..core.lessons import checking
from . import fields, texts
from .operators import lessons
from .sub_panel import SidePanel
from .ui_state import ui_state


#: In pixels of an interface that is not scaled, what a box takes of the width.
_BOX = 10


class SPLINEWRIGHT_PT_lesson(SidePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_lesson"
    bl_label = "Lesson"
    bl_order = -1

    @classmethod
    def poll(cls, context):
        return bool(stage.lesson_of(context.scene))

    def draw(self, context):
        layout = self.layout
        try:
            lesson = lessons.current(context.scene)
        except FAILURES as error:
            texts.draw_problem(layout, sentence(error))
            _draw_end(layout)
            return
        number = stage.step_of(context.scene)
        step = lesson.steps[number]
        texts.draw_note(layout, phrase("{title}: {number} of {count}", title=phrase(lesson.title), number=number + 1, count=len(lesson.steps)),
                        icon='NONE')
        texts.draw_note(layout, step.text, icon='NONE')
        _draw_watched(layout, context.scene, step)
        if step.ask is not None:
            _draw_question(layout, context.scene, step, number)
        row = layout.row(align=True)
        for way, text in (('BACK', "Back"), ('RESET', "Reset"), ('NEXT', "Next")):
            row.operator("splinewright.lesson_step", text=say(text)).way = way
        layout.prop(context.scene, "splinewright_lesson_in_view")
        _draw_end(layout)


def _draw_picked(box, ask):
    """Which points are picked, or how to pick some."""
    held = lessons.net_of(bpy.context, ask.shape)
    if held is None:
        box.operator("splinewright.pick_answer", icon='EDITMODE_HLT')
        return
    try:
        picked = lessons.picked_points(held)
    except FAILURES as error:
        texts.draw_problem(box, sentence(error))
        return
    texts.draw_note(box, phrase("Picked: {picked}",
                                picked=', '.join(map(str, picked))) if picked else "Select points of the net", icon='NONE', beside=_BOX)


def _draw_watched(layout, scene, step):
    if not step.watch:
        return
    column = layout.box().column(align=True)
    for watch in step.watch:
        try:
            texts.draw_note(column, checking.watched(watch, stage.shapes_of(scene)), icon='NONE', beside=_BOX)
        except FAILURES as error:
            texts.draw_note(column, sentence(error), beside=_BOX)


def _draw_choices(box, choices):
    """A button for each; where one of them is too long they stand above buttons with their numbers."""
    is_short = all(texts.fits(choice, _BOX) for choice in choices)
    for i, choice in enumerate([] if is_short else choices, 1):
        texts.draw_note(box, f"{i}. {choice}", icon='NONE', beside=_BOX)
    row = box if is_short else box.row(align=True)
    for i, choice in enumerate(choices):
        row.operator("splinewright.check_answer", text=choice if is_short else str(i + 1)).choice = i


def _draw_question(layout, scene, step, number):
    box, ask = layout.box(), step.ask
    if ask.kind == 'choose':
        _draw_choices(box, list(map(say, ask.choices)))
    else:
        if ask.kind == 'number':
            fields.number(box, scene, "splinewright_answer", beside=_BOX)
        if ask.kind == 'point':
            _draw_picked(box, ask)
        box.operator("splinewright.check_answer", icon='CHECKMARK')
    known = stage.answers(scene).get(str(number))
    if known and ui_state.lesson_word:
        box.label(text=say(ui_state.lesson_word), icon='CHECKMARK' if known.get('right') else 'CANCEL')
        if not known.get('right') and step.hint and not lessons.shown_answer(scene):
            texts.draw_note(box, step.hint, icon='LIGHT', beside=_BOX)
    box.operator("splinewright.show_solution")
    if lessons.shown_answer(scene):
        texts.draw_note(box, lessons.shown_answer(scene), icon='LIGHT', beside=_BOX)


def _draw_end(layout):
    column = layout.column(align=True)
    column.operator("splinewright.leave_lesson", text="Leave").how = 'REMOVE'
    column.operator("splinewright.leave_lesson", text="Keep Scene").how = 'KEEP'


CLASSES = (SPLINEWRIGHT_PT_lesson,)
