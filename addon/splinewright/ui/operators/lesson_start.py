"""Lessons are started: those of the add-on, those of files, and those of texts in the open file."""

from functools import lru_cache
from pathlib import Path

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ...bridge.lessons import shelf, stage
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase, say
from ..ui_state import ui_state
from . import polls, reports

_VIEWS = ('TOP', 'FRONT', 'RIGHT')
#: Of a view that is free, in radians: from the front to the side, and up.
_TURN, _RISE = -0.6, 0.5


@lru_cache(None)
def _items():
    """Blender needs the texts to live on."""
    try:
        return [(name, lesson.title, " ".join(lesson.lectures)) for name, lesson in shelf.all_lessons().items()]
    except FAILURES as error:
        return [("", "None", sentence(error))]


def _lessons(_self, _context):
    return _items()


def overlays(scene):
    """Names of the switches of overlays."""
    return {known.identifier for known in scene.splinewright_sights.bl_rna.properties if known.type == 'BOOLEAN'}


def show_view(context, step):
    """Look from where a step is seen best, at all that it shows."""
    for name in overlays(context.scene).intersection(step.overlays):
        setattr(context.scene.splinewright_sights, name, True)
    area = context.area
    if area is None or area.type != 'VIEW_3D':
        return
    region = next(region for region in area.regions if region.type == 'WINDOW')
    with context.temp_override(area=area, region=region):
        if step.view in _VIEWS:
            bpy.ops.view3d.view_axis(type=step.view)
        elif step.view == 'FREE' and region.data.is_orthographic_side_view:
            _leave_axis()
        bpy.ops.view3d.view_all()


def _leave_axis():
    """Look from above at an angle: along an axis heights are not seen."""
    bpy.ops.view3d.view_axis(type='FRONT')
    bpy.ops.view3d.view_orbit(angle=_TURN, type='ORBITLEFT')
    bpy.ops.view3d.view_orbit(angle=_RISE, type='ORBITUP')


def begin(operator, context, lesson, text=""):
    """Show a lesson in a separate scene; text: as of stage.begin(). Returns what the operator's execute() returns."""
    try:
        scene = stage.begin(lesson, context.scene, text)
    except FAILURES as error:
        return reports.failed(operator, error)
    ui_state.lesson_word, ui_state.lesson_shown = "", ()
    if context.window is not None:
        context.window.scene = scene
        show_view(context, lesson.steps[0])
    return reports.finished(operator, reports.Report(phrase("{title}: the sidebar has its steps", title=phrase(lesson.title))))


class SPLINEWRIGHT_OT_start_lesson(bpy.types.Operator):
    bl_idname = "splinewright.start_lesson"
    bl_label = "Start Lesson"
    bl_description = "Open a lesson in a separate scene; your scene stays as it is"
    bl_options = {'REGISTER', 'UNDO'}

    lesson: EnumProperty(name="Lesson", description="Which lesson is opened", items=_lessons, options={'SKIP_SAVE'})
    text: StringProperty(name="Text", description="The name of a text of this file that holds the lesson", options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.in_object_mode(cls, context)

    @classmethod
    def description(cls, context, properties):
        if properties.text:
            return say(phrase("Open the lesson that the text {text} holds", text=properties.text))
        title, about = next(((title, about) for name, title, about in _items() if name == properties.lesson), ("", ""))
        return say(phrase("{title} ({about}) in a separate scene; your scene stays as it is",
                      title=title, about=about) if about else cls.bl_description)

    def execute(self, context):
        try:
            lesson, text = shelf.read_block(self.text) if self.text else (shelf.all_lessons()[self.lesson], "")
        except FAILURES as error:
            return reports.failed(self, error)
        return begin(self, context, lesson, text)


class SPLINEWRIGHT_OT_start_lesson_file(ImportHelper, bpy.types.Operator):
    bl_idname = "splinewright.start_lesson_file"
    bl_label = "Start Lesson from File"
    bl_description = "Open a lesson of a file, which is read and never run"
    bl_options = {'REGISTER', 'UNDO'}

    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={'HIDDEN'})
    filepath: StringProperty(name="File Path", subtype='FILE_PATH', options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.in_object_mode(cls, context)

    def invoke(self, context, event):
        """A button that names a file needs no file browser."""
        return self.execute(context) if self.filepath else super().invoke(context, event)

    def execute(self, context):
        if not self.filepath:
            return reports.cancelled(self, "Choose a file that holds a lesson")
        try:
            lesson, text = shelf.read(Path(bpy.path.abspath(self.filepath)))
        except FAILURES as error:
            return reports.failed(self, error)
        return begin(self, context, lesson, text)


class SPLINEWRIGHT_OT_show_lesson_folder(bpy.types.Operator):
    bl_idname = "splinewright.show_lesson_folder"
    bl_label = "Show Lesson Folder"
    bl_description = "Open the folder for your lessons: files that lie there stand in the panel Lessons"
    bl_options = {'INTERNAL'}

    def execute(self, context):
        try:
            folder = shelf.own_folder(create=True)
        except FAILURES as error:
            return reports.failed(self, error)
        if folder is None:
            return reports.cancelled(self, "There is no folder for lessons, and it cannot be made")
        return reports.called(self, bpy.ops.wm.path_open, filepath=str(folder))


CLASSES = (SPLINEWRIGHT_OT_start_lesson, SPLINEWRIGHT_OT_start_lesson_file, SPLINEWRIGHT_OT_show_lesson_folder)
