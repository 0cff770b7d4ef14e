"""Ctrl+J: shapes become one shape; joined with other objects, their definitions end, which is asked first."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ...bridge.analysis import surveys
from ...bridge.data import store
from ...bridge.edit import joining
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.joints.held import why_not
from .. import texts
from . import polls, reports

_WIDTH = 420


class SPLINEWRIGHT_OT_join(bpy.types.Operator):
    bl_idname = "splinewright.join"
    bl_label = "Join Shapes"
    bl_description = "Join the selected shapes into the active one; with other objects among them it asks first"
    bl_options = {'REGISTER', 'UNDO'}

    end_definitions: BoolProperty(
        name="End the Definitions", options={'SKIP_SAVE'},
        description="Join shapes with objects that are none, as Blender does: what they show stays, as plain faces or points")
    question: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        """Ctrl+J passes to Blender's own Join where that meets no shape."""
        if not polls.in_object_mode(cls, context):
            return False
        chosen, active = _joinable(context), context.object
        if active is None or not active.select_get() or not any(map(shape.has_shape, chosen)):
            cls.poll_message_set(say("Select shapes, the one to keep last"))
            return False
        if len(chosen) < 2:
            cls.poll_message_set(say("Select two or more shapes, all of curves or all of patches"))
            return False
        return True

    def invoke(self, context, event):
        chosen = _joinable(context)
        if all(map(shape.has_shape, chosen)):
            return self.execute(context)
        self.question = joining.ending_in_words(chosen) + "."
        self.end_definitions = True
        return context.window_manager.invoke_props_dialog(self, width=_WIDTH)

    def draw(self, context):
        if self.question:
            texts.draw_note(self.layout, self.question, _WIDTH // 7)
        else:
            self.layout.prop(self, "end_definitions")

    def execute(self, context):
        active, chosen = context.object, _joinable(context)
        self.question = ""                          # the redo panel asks nothing
        try:
            if all(map(shape.has_shape, chosen)):
                others = [ob.name for ob in chosen if ob != active]
                joining.join(active, [ob for ob in chosen if ob != active])
                return reports.finished(self, reports.Report(phrase("Joined {names} into {name}",
                                                                    names=reports.listed(others), name=active.name), notes=_seams(active.data)))
            elif not self.end_definitions:
                raise Refusal("{said}. Nothing was joined: set End the Definitions for that",
                              said=joining.ending_in_words(chosen))
            else:
                return reports.finished(self, reports.Report(joining.join_plainly(active, chosen)))
        except FAILURES as error:
            return reports.failed(self, error)
        return reports.finished(self, reports.Report())


def _seams(data):
    """What the seams of a shape that was joined are not yet, in a tuple."""
    if not isinstance(data, bpy.types.Mesh):
        return ()
    definition = store.read(data)
    apart = [joint for joint in surveys.survey_of(data).joints if joint.sides and why_not(definition, *joint.sides)]
    return ("adjacent patches still have separate edges: Join Patches joins them",) if apart else ()


def _joinable(context):
    """The selected objects that Blender's Join would make one with the active one."""
    active = context.object
    return [ob for ob in context.selected_objects if active is not None and ob.type == active.type]


CLASSES = (SPLINEWRIGHT_OT_join,)
