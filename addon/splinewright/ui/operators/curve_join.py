"""Curves become one where their ends meet."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ...bridge.data import store
from ...bridge.edit import joining, replace_pieces
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.joints import joints
from .. import active_shape, scene_tolerance
from . import polls, reports
from .pick_piece import draw_number
from .pieces import UpToTolerance, scene_tolerance_property, told

_WORDS = {'C0': "They share the point", 'G1': "They share the direction, too",
          'C1': "They share the first derivative", 'C2': "They share the first two derivatives"}


class SPLINEWRIGHT_OT_join_ends(bpy.types.Operator):
    bl_idname = "splinewright.join_ends"
    bl_label = "Join Ends"
    bl_description = "Join two curves at their nearest ends: pieces of the active shape, or of two selected shapes"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    continuity: EnumProperty(name="Continuity", description="What the curves share where they meet",
                             items=[(name, name, _WORDS[name]) for name in joints.SMOOTHNESS])
    first: IntProperty(name="Piece", description="Which curve of the active shape, counted from 1; 0 for the nearest",
                       default=0, min=0, options={'SKIP_SAVE'})
    second: IntProperty(name="Other Piece", description="Which other curve of it, or of the other shape, counted "
                        "from 1; 0 for the nearest", default=0, min=0, options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replace_pieces.is_curve_shape, "Select one or two curve shapes")

    def invoke(self, context, event):
        active_shape.begin_pair(self, context)
        return self.execute(context)

    def execute(self, context):
        ob, others = context.object, [ob for ob in context.selected_objects if ob != context.object]
        parted = active_shape.count_of(ob.data) if others else None
        try:
            outcome = self._joined(ob, others)
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        active_shape.keep(ob.data, outcome[1].parents)
        active_shape.note_pair(self, ob, outcome[1].parents, parted)
        return reports.finished(self, reports.Report(phrase("Joined ends of {name}", name=ob.name) + told([outcome])))

    def _joined(self, ob, others):
        """(the definition before, the verbs.Changed)."""
        return joining.join_changed(ob, others, lambda definition, parted: joints.joined(
            definition, self.first, self.second, self.continuity, joining.linear_of(ob), parted))

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "continuity", expand=True)
        draw_number(layout, self, "first")
        draw_number(layout, self, "second")


class SPLINEWRIGHT_OT_join_pieces(UpToTolerance, bpy.types.Operator):
    bl_idname = "splinewright.join_pieces"
    bl_label = "Join Pieces"
    bl_description = "Join pieces of a curve shape where their ends meet, and remove unnecessary knots"
    bl_options = {'REGISTER', 'UNDO'}
    needs, done = "Select a curve shape", "Joined pieces of {what}"
    fits = staticmethod(replace_pieces.is_curve_shape)

    tolerance: scene_tolerance_property("How far apart ends may lie, and how far the curve may move")

    def work(self, context, ob):
        replace_pieces.require_changeable(ob.data)
        before = store.read(ob.data)
        changed = joints.chained(before, self.tolerance)
        replace_pieces.put(ob.data, before, changed)
        active_shape.keep(ob.data, changed.parents)
        return before, changed

    def said(self, outcomes):
        return reports.Report(self.summary(outcomes) + told(outcomes.values()))


class SPLINEWRIGHT_OT_join_curves(bpy.types.Operator):
    bl_idname = "splinewright.join_curves"
    bl_label = "Join Curves"
    bl_description = "Join the selected curve shapes into the active one, and their curves where ends meet"
    bl_options = {'REGISTER', 'UNDO'}

    tolerance: scene_tolerance_property("How far apart ends may lie, and how far the curves may move")

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        chosen = context.selected_objects
        if context.object not in chosen or len(chosen) < 2 or not all(map(replace_pieces.is_curve_shape, chosen)):
            cls.poll_message_set(say("Select two curve shapes or more, the one to keep last"))
            return False
        return True

    def execute(self, context):
        ob = context.object
        others = [other for other in context.selected_objects if other != ob]
        scene_tolerance.settle_in_object(self, context, ob)
        try:
            outcome = joining.join_changed(ob, others, lambda definition, parted: joints.chained(definition, self.tolerance))
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        active_shape.keep(ob.data, outcome[1].parents)
        return reports.finished(self, reports.Report(phrase("Joined curves into {name}", name=ob.name) + told([outcome])))

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(self, "tolerance")


CLASSES = (SPLINEWRIGHT_OT_join_ends, SPLINEWRIGHT_OT_join_pieces, SPLINEWRIGHT_OT_join_curves)
