"""Bake Animation, and its way back."""

import bpy
from bpy.props import IntProperty

from ...bridge.edit import baking
from ...bridge.shape import shape
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from .. import progress
from . import polls, reports
from .long_work import AtWork
from .selected import OnSelected


class SPLINEWRIGHT_OT_bake_animation(AtWork, bpy.types.Operator):
    bl_idname = "splinewright.bake_animation"
    bl_label = "Bake Animation"
    bl_description = ("Bake the motion of the selected shapes to shape keys, so that they move without Splinewright; Remove "
                      "Bake reverts it")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    cursor, look = None, 0.001

    frame_start: IntProperty(name="First Frame", description="Where it begins; of the scene if it is not given",
                             options={'SKIP_SAVE'})
    frame_end: IntProperty(name="Last Frame", description="Where it ends; of the scene if it is not given",
                           options={'SKIP_SAVE'})
    frame_step: IntProperty(name="Step", description="Frames between keys, with linear interpolation", default=1,
                            min=1)

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not any(map(shape.has_shape, context.selected_objects)):
            cls.poll_message_set(say("Select Splinewright shapes that move"))
            return False
        return True

    def execute(self, context):
        """All at once: for scripts, and when a number was changed afterwards."""
        try:
            steps, count = self._begin(context)
            with progress.shown(context, count) as step:
                takes = _gone_through(steps, step)
            return self._finish(takes)
        except FAILURES as error:
            return reports.failed(self, error)

    def invoke(self, context, event):
        """A frame at a time, while Esc is listened to."""
        try:
            self._steps, count = self._begin(context)
        except FAILURES as error:
            return reports.failed(self, error)
        self._done = 0
        context.window_manager.progress_begin(0, count)
        context.workspace.status_text_set(say(phrase("Baking {count} frames: Esc stops it",
                                                     one="Baking {count} frame: Esc stops it", count=count)))
        return self.begin_modal(context)

    def work_on(self, context):
        try:
            next(self._steps)
        except StopIteration as end:
            self.end_modal(context)
            return self._finish(end.value)
        except FAILURES as error:
            self.end_modal(context)
            return reports.failed(self, error)
        self._done += 1
        context.window_manager.progress_update(self._done)
        return {'RUNNING_MODAL'}

    def put_back(self):
        self._steps.close()             # the frame is what it was

    def called_off(self):
        return reports.stopped(self, "Baking was stopped: nothing has changed")

    def end_modal(self, context):
        context.window_manager.progress_end()
        super().end_modal(context)

    def _begin(self, context):
        """(steps of baking.record(), how many)."""
        scene, given = context.scene, self.properties.is_property_set
        is_preview = scene.use_preview_range
        if not given("frame_start"):
            self.frame_start = scene.frame_preview_start if is_preview else scene.frame_start
        if not given("frame_end"):
            self.frame_end = scene.frame_preview_end if is_preview else scene.frame_end
        frames = range(self.frame_start, self.frame_end + 1, self.frame_step)
        shapes = {ob.data: ob for ob in context.selected_objects if shape.has_shape(ob)}
        return baking.record(scene, list(shapes), frames), len(frames)

    def _finish(self, takes):
        """Bake what moves."""
        baked = [data.name for data, take in takes.items() if take.moves]
        for data, take in takes.items():
            if take.moves:
                baking.bake(data, take)
        still = [data.name for data, take in takes.items() if not take.moves]
        words = (phrase("{names} do not change" if len(still) > 1 else "{names} does not change", names=_listed(still)),) if still else ()
        if not baked:
            return reports.cancelled(self, *words)
        done = phrase("Baked {baked} from frame {frame_start} to {frame_end}",
                      baked=_listed(baked), frame_start=self.frame_start, frame_end=self.frame_end)
        return reports.finished(self, reports.Report(done, words))


def _listed(names):
    return names[0] if len(names) == 1 else phrase("{count} shapes", count=len(names))


def _gone_through(steps, step):
    """What steps end with; step() reports each."""
    done = 0
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value
        done += 1
        step(done)


class SPLINEWRIGHT_OT_unbake(OnSelected, bpy.types.Operator):
    bl_idname = "splinewright.unbake"
    bl_label = "Remove Baked Animation"
    bl_description = "Restore the shapes that were baked: they follow again, and can be edited"
    needs = "Select a shape that was baked"
    done = "{what} is live again"

    @staticmethod
    def fits(ob):
        return baking.is_baked(ob.data)

    def work(self, context, ob):
        baking.unbake(ob.data)


CLASSES = (SPLINEWRIGHT_OT_bake_animation, SPLINEWRIGHT_OT_unbake)
