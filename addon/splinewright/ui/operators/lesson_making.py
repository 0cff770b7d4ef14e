"""A lesson made from what a scene shows: its steps, its mistakes, and its file."""

import json
from pathlib import Path

import bpy
import numpy as np
from bpy.props import PointerProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ...bridge.lessons import authoring, shelf, stage, trial
from ...bridge.shape import shape
from ...core.base import whole_files
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.lessons import drafts, reading
from ..ui_state import ui_state
from . import polls, reports
from .lesson_start import overlays

_LESSON = "splinewright_lesson_draft"
_WORDS = "splinewright_step_words"
#: Directions from which a view looks.
_VIEWS = {'TOP': (0, 0, 1), 'FRONT': (0, -1, 0), 'RIGHT': (1, 0, 0)}


def draft_of(context):
    """(the text of the lesson that is made, what it says, its Lesson). Raises Refusal."""
    block = getattr(context.scene, _LESSON)
    if block is None:
        raise Refusal("there is no lesson yet: Make Lesson from Scene begins one")
    text = block.as_string()
    try:
        lesson = shelf.read_text(text)
    except Refusal as error:
        raise Refusal("{name}: {error}", name=block.name, error=error) from None
    return block, json.loads(text), lesson


def write(block, draft):
    """Keep a lesson in its text. Raises Refusal, and nothing has changed then."""
    text = drafts.text_of(draft)
    if len(text) > reading.MOST_BYTES:
        raise Refusal("the lesson would have {count:,} characters: {most_bytes:,} are the most",
                      count=len(text), most_bytes=reading.MOST_BYTES)
    block.from_string(text)
    ui_state.lesson_faults = ()


def _seen(context):
    """(view, overlays that are on) as a step says them."""
    chosen, space = context.scene.splinewright_sights, context.space_data
    on = [name for name in sorted(overlays(context.scene)) if getattr(chosen, name)]
    if space is None or space.type != 'VIEW_3D':
        return "", on
    eye = np.array(space.region_3d.view_rotation.to_matrix(), dtype=np.float64)[:, 2]
    return next((name for name, axis in _VIEWS.items() if np.abs(eye - axis).max() < 1e-3), 'FREE'), on


def _selected(context):
    return [ob for ob in context.selected_objects if shape.has_shape(ob)]


class _Making:
    """Changes the lesson that is made."""

    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if stage.lesson_of(context.scene):
            cls.poll_message_set(say("Leave the lesson of this scene first"))
            return False
        return True

    def execute(self, context):
        try:
            return self.done(context, context.scene)
        except FAILURES as error:
            return reports.failed(self, error)


class _OnDraft(_Making):
    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if getattr(context.scene, _LESSON) is None:
            cls.poll_message_set(say("Make a lesson first"))
            return False
        return True


class _WithWords(_Making):
    """A step, with what it says."""

    words: StringProperty(name="Text", description="What the step says; empty: the text of the Text Editor that is chosen in the panel",
                          options={'SKIP_SAVE'})

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self, width=520)

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        for name in self.asked:
            column.prop(self, name)
        column.prop(context.scene, _WORDS)

    def text(self, scene):
        """Raises Refusal where there is none."""
        block = getattr(scene, _WORDS)
        found = self.words.strip() or (block.as_string().strip() if block is not None else "")
        if not found:
            raise Refusal("the step says nothing: type its text, or choose a text of the Text Editor")
        return found


class SPLINEWRIGHT_OT_new_lesson(_WithWords, bpy.types.Operator):
    bl_idname = "splinewright.new_lesson"
    bl_label = "Make Lesson from Scene"
    bl_description = "Begin a lesson whose first step makes the selected shapes, and keep it in a text of this file"

    asked = ('title', 'words')
    title: StringProperty(name="Title", description="What the lesson is called", default="My Lesson", options={'SKIP_SAVE'})

    def done(self, context, scene):
        graph = authoring.graph()
        obs = authoring.with_inputs(_selected(context))
        if not obs:
            raise Refusal("Select the shapes that the first step is to make")
        names = authoring.new_names(obs, {})
        found = authoring.present(obs, names, graph)
        makes = [drafts.make(name, one) for name, one in found.items()]
        draft = drafts.begun(self.title.strip(), drafts.step(self.text(scene), makes, (), *_seen(context)))
        drafts.text_of(draft)
        authoring.unmark(scene)
        authoring.mark(names)
        block = bpy.data.texts.new(f"{draft['name']}.json")
        write(block, draft)
        setattr(scene, _LESSON, block)
        setattr(scene, _WORDS, None)
        return reports.finished(self, reports.Report(phrase("{name} is in the Text Editor: {count} shapes",
                                                            one="{name} is in the Text Editor: {count} shape", name=block.name, count=len(makes)), notes=kept_as_values(found)))


def kept_as_values(found):
    """Sentences about shapes {name: Present} whose recipes a lesson cannot hold."""
    return tuple(phrase("{name} is kept as it is: {reason}",
                        name=name, reason=one.why_value) for name, one in found.items() if one.why_value)


class SPLINEWRIGHT_OT_add_lesson_step(_WithWords, _OnDraft, bpy.types.Operator):
    bl_idname = "splinewright.add_lesson_step"
    bl_label = "Add Lesson Step"
    bl_description = "Add a step that leads to the present scene: changed numbers and points, and selected shapes that are new"

    asked = ('words',)

    def done(self, context, scene):
        block, draft, lesson = draft_of(context)
        graph, names = authoring.graph(), authoring.known(scene)
        known = drafts.state_of(lesson)
        names = {ob: name for ob, name in names.items() if name in known}
        new = [ob for ob in authoring.with_inputs(_selected(context)) if ob not in names]
        all_names = authoring.new_names(new, {**names, **_gone(names, known)})
        found = authoring.present([*names, *new], {ob: name for ob, name in all_names.items() if isinstance(ob, bpy.types.Object)}, graph)
        makes = [drafts.make(all_names[ob], found[all_names[ob]]) for ob in new]
        step = drafts.step(self.text(scene), makes, drafts.changes(known, found), *_seen(context))
        write(block, {**draft, 'steps': [*draft['steps'], step]})
        authoring.mark({ob: all_names[ob] for ob in new})
        setattr(scene, _WORDS, None)
        made, changed = len(makes), len(step.get('change', ()))
        return reports.finished(self, reports.Report(
            phrase("Step {number}: {count} new shapes, {changed} changed", one="Step {number}: {count} new shape, {changed} changed",
                   number=len(lesson.steps) + 1, count=made, changed=changed), notes=kept_as_values({all_names[ob]: found[all_names[ob]] for ob in new}),
            warnings=tuple(phrase("{name} is gone: in the lesson it stays as it was",
                                  name=name) for name in _gone(names, known).values())))


def _gone(names, known):
    """{what stands for an object: name} of shapes of the lesson that the scene has no more."""
    return {f"gone {name}": name for name in known if name not in names.values()}


class SPLINEWRIGHT_OT_check_lesson(_OnDraft, bpy.types.Operator):
    bl_idname = "splinewright.check_lesson"
    bl_label = "Check Lesson"
    bl_description = "Try the lesson from beginning to end in a separate scene, and report every mistake as a sentence"
    bl_options = {'REGISTER'}

    def done(self, context, scene):
        block, _, lesson = draft_of(context)
        ui_state.lesson_faults = tuple(trial.faults(lesson, scene, overlays(scene)))
        if ui_state.lesson_faults:
            return reports.cancelled(self, *ui_state.lesson_faults)
        return reports.finished(self, reports.Report(phrase("{name}: all {count} steps are in order",
                                                            one="{name}: its only step is in order", name=block.name, count=len(lesson.steps))))


class SPLINEWRIGHT_OT_export_lesson(_OnDraft, ExportHelper, bpy.types.Operator):
    bl_idname = "splinewright.export_lesson"
    bl_label = "Export Lesson"
    bl_description = "Write the lesson into a file, which others start from the panel Lessons"
    bl_options = {'REGISTER'}

    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={'HIDDEN'})
    filepath: StringProperty(name="File Path", subtype='FILE_PATH', options={'HIDDEN', 'SKIP_SAVE'})

    def invoke(self, context, event):
        """Into the user's folder, if no other is chosen."""
        try:
            folder = shelf.own_folder(create=True)
            self.filepath = str((folder or Path.home()) / getattr(context.scene, _LESSON).name)
        except OSError as error:
            return reports.failed(self, error)
        return super().invoke(context, event)

    def done(self, context, scene):
        _, draft, lesson = draft_of(context)
        path = Path(bpy.path.abspath(self.filepath))
        if not self.filepath or path.is_dir():
            raise Refusal("Name a file to write to")
        whole_files.write(path, drafts.text_of(draft))
        ui_state.lesson_faults = tuple(trial.faults(lesson, scene, overlays(scene)))
        return reports.finished(self, reports.Report(phrase("Exported {name}", name=path.name), warnings=ui_state.lesson_faults))


CLASSES = (SPLINEWRIGHT_OT_new_lesson, SPLINEWRIGHT_OT_add_lesson_step, SPLINEWRIGHT_OT_check_lesson, SPLINEWRIGHT_OT_export_lesson)


def register():
    setattr(bpy.types.Scene, _LESSON, PointerProperty(
        name="Lesson", description="The text that holds the lesson which is made", type=bpy.types.Text, options=set()))
    setattr(bpy.types.Scene, _WORDS, PointerProperty(
        name="Words", description="A text of the Text Editor: what the next step says, where no other text is typed", type=bpy.types.Text,
        options=set()))


def unregister():
    delattr(bpy.types.Scene, _LESSON)
    delattr(bpy.types.Scene, _WORDS)
