"""All lessons in the sidebar: those of the add-on by lecture, those in the user's folder, and those in texts of the open file."""

import bpy
from bpy.props import EnumProperty

from ..bridge.lessons import shelf, stage
from ..core.base.failures import FAILURES, sentence
from ..core.base.words import phrase, say
from ..core.lessons import lectures
from . import texts
from .sub_panel import ClosedPanel

#: Characters of a title in a button, and files of the user's folder that are shown.
_TITLE, _MOST = 27, 60
_ALL = 'ALL'
_LECTURES = ((_ALL, "All Lectures", "Show all lessons, each at the first lecture that it is about"),
             *((f"L{number}", lectures.label_of(number), "Show the lessons that are about this lecture") for number in lectures.LECTURES))


class BesideLessons(ClosedPanel):
    """In scenes that are not a lesson's."""

    @classmethod
    def poll(cls, context):
        return context.mode == 'OBJECT' and not stage.lesson_of(context.scene)


class SPLINEWRIGHT_PT_lessons(BesideLessons, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_lessons"
    bl_label = "Lessons"
    bl_order = 20

    def draw(self, context):
        layout = self.layout
        try:
            _draw_shelf(layout, context.window_manager)
        except FAILURES as error:
            texts.draw_problem(layout, sentence(error))
        _draw_own(layout)
        layout.operator("splinewright.start_lesson_file", text="Start from File", icon='FILE_FOLDER')
        layout.operator("splinewright.collect_answers", icon='EXPORT')


def _draw_shelf(layout, manager):
    layout.prop(manager, "splinewright_lecture", text="")
    lessons, chosen = shelf.all_lessons().values(), manager.splinewright_lecture
    if chosen != _ALL:
        of_lecture = lectures.of_lecture(lessons, chosen[1:])
        _draw_lessons(layout, of_lecture)
        if not of_lecture:
            layout.label(text="No lesson yet")
        return
    for label, those in lectures.groups(lessons):
        texts.draw_note(layout, label, icon='NONE')
        _draw_lessons(layout, those)


def _draw_lessons(layout, lessons):
    column = layout.column(align=True)
    for lesson in lessons:
        column.operator("splinewright.start_lesson", text=short(say(lesson.title))).lesson = lesson.name


def _draw_own(layout):
    """Files are read when they are started, for there may be many, and large ones."""
    box = layout.box()
    row = box.row()
    row.label(text="Your Own")
    row.operator("splinewright.show_lesson_folder", text="", icon='FILE_FOLDER')
    column = box.column(align=True)
    try:
        files = shelf.own_files()
    except OSError as error:
        texts.draw_problem(box, sentence(error))
        files = []
    for path in files[:_MOST]:
        name = path.stem.encode('utf-8', 'replace').decode('utf-8')
        column.operator("splinewright.start_lesson_file", text=short(name), icon='FILE').filepath = str(path)
    if len(files) > _MOST:
        column.label(text=say(phrase("and {count} more files", one="and {count} more file", count=len(files) - _MOST)))
    for name in shelf.blocks():
        column.operator("splinewright.start_lesson", text=short(name), icon='TEXT').text = name
    if not files and not shelf.blocks():
        column.label(text="None yet")


def short(title):
    """A title that fits a button; the tooltip has it whole."""
    return title if len(title) <= _TITLE or texts.is_drawn() and texts.fits(title) else f"{title[:_TITLE - 1]}…"


CLASSES = (SPLINEWRIGHT_PT_lessons,)


def register():
    bpy.types.WindowManager.splinewright_lecture = EnumProperty(
        name="Lecture", description="Which lessons are listed", items=_LECTURES, options=set())


def unregister():
    del bpy.types.WindowManager.splinewright_lecture
