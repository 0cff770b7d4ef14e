"""Operators that do their work on every selected object that fits."""

from bpy.props import BoolProperty, StringProperty

from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase, say
from .. import progress, texts
from . import polls, reports

_NOTHING = "Nothing changed"
#: Characters of a line in the panel of the last operator.
_WIDTH = 40


class OnSelected:
    """Works in Object Mode; what cannot be done is reported and the rest is done."""

    bl_options = {'REGISTER', 'UNDO'}
    #: poll_message where nothing fits, and what was done: {} stands for the names.
    needs, done = "", ""
    #: Whether another setting may do what was refused.
    has_settings = False

    #: Whether a user called it, who then sees the panel of the last operator.
    by_hand: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})
    #: What came of the last call, for that panel: Blender's status bar need not say it again.
    result: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    #: Whether that is why nothing changed.
    is_refused: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @staticmethod
    def fits(ob):
        raise NotImplementedError

    def work(self, context, ob):
        """Do it with one object. Raises, and has changed nothing, if it cannot be done."""
        raise NotImplementedError

    def invoke(self, context, event):
        self.by_hand = True
        return self.called(context)

    def called(self, context):
        """What invoke() returns."""
        return self.execute(context)

    def can_work(self, ob):
        """Whether what was refused for an object may be done with other settings. has_settings says that it is asked."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not any(map(cls.fits, context.selected_objects)):
            cls.poll_message_set(say(cls.needs))
            return False
        return True

    def execute(self, context):
        outcomes, failed = self._work_on_all(context)
        reasons = reports.by_name(failed)
        if not outcomes:
            return self._refused(context, reasons)
        said = self.said(outcomes)
        return self._finished(said._replace(warnings=(*said.warnings, *self.after(context), *reasons)))

    def after(self, context):
        """Called when all are done. Returns warnings."""
        return ()

    def _finished(self, said, is_refused=False):
        self.result, self.is_refused = reports.in_words(said), is_refused
        return reports.finished(self, said)

    def draw_result(self):
        """In the panel of the last operator."""
        draw = texts.draw_problem if self.is_refused else texts.draw_note
        draw(self.layout, self.result, _WIDTH)

    def _refused(self, context, reasons):
        """Where another setting may do it, the panel of the last operator stays: Blender shows none of what was cancelled."""
        if self.by_hand and self.has_settings and any(map(self.can_work, self.chosen(context))):
            return self._finished(reports.Report(_NOTHING, warnings=reasons), is_refused=True)
        return reports.cancelled(self, *reasons)

    def _work_on_all(self, context):
        """What work() gave, and why it failed, by name. Should it break, Blender makes an undo step of what was done."""
        chosen = self.chosen(context)
        names, outcomes, failed = [ob.name for ob in chosen], {}, {}
        with progress.shown(context, len(chosen)) as step:
            for i, ob in enumerate(chosen):
                try:
                    outcomes[names[i]] = self.work(context, ob)
                except FAILURES as error:
                    failed[names[i]] = sentence(error)
                step(i + 1)
        return outcomes, failed

    def said(self, outcomes):
        """The reports.Report of what was done. outcomes: what work() gave for each name."""
        return reports.Report(self.summary(outcomes))

    def summary(self, outcomes):
        return phrase(self.done, what=list(outcomes)[0] if len(outcomes) == 1 else phrase("{count} objects", count=len(outcomes)))

    def chosen(self, context):
        """The objects it is done with, one for each data-block: those that share one are changed together."""
        return list({(ob.type, ob.data.name_full): ob for ob in self._in_order(context) if self.fits(ob)}.values())

    @staticmethod
    def _in_order(context):
        """The selected objects, the active one last: of those that share data it stands for all."""
        return sorted(context.selected_objects, key=lambda ob: ob == context.object)


class OnFollowers(OnSelected):
    """Works on shapes that are made from other objects."""

    needs = "Select a shape that is made from other objects"

    @staticmethod
    def fits(ob):
        return shape.has_shape(ob) and recipes.follows(ob.data)
