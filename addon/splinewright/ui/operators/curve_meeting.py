"""Curves are extended to where they meet others, end there, or part there."""

from functools import partial

import bpy
from bpy.props import EnumProperty, FloatProperty, StringProperty

from ...bridge.edit import replace_pieces
from ...bridge.follow import neighboring_curves
from ...core.base import decimals
from ...core.meets import meeting
from ...core.verbs import verbs
from . import pieces
from .on_shapes import OnCurves
from .pieces import parameter_property

_WITH = (('VISIBLE', "All Visible", "All curves that are shown, and its own other pieces"),
         ('SELECTED', "Selected", "Other selected curves, and its own other pieces"))
_HOW = (('natural', "Natural", "As its last span does"), ('arc', "Arc", "Round its circle of curvature"),
        ('straight', "Straight", "Along its tangent"))


def with_property(**settings):
    return EnumProperty(name="With", description="What it may meet", items=_WITH, **settings)


def how_property(**settings):
    return EnumProperty(name="How", description="How it is continued", items=_HOW, **settings)


class _Meeting(pieces.LongOnPieces, OnCurves):
    """Does meeting_verb() with the curves that each shape may meet."""

    meet: with_property()

    def meeting_verb(self, others):
        """A function that gives a verb for a `cancel` as the library takes it."""
        raise NotImplementedError

    def tasks(self, context):
        return {ob.name: self._task_with(replace_pieces.read(ob.data), self._others(context, ob))
                for ob in self.chosen(context) if replace_pieces.can_change(ob.data)}

    def work(self, context, ob):
        before = replace_pieces.read(ob.data)
        changed = self.result_of(ob.name, self._task_with(before, self._others(context, ob)))
        replace_pieces.put(ob.data, before, changed)
        self._note(ob, changed)
        return before, changed

    def _task_with(self, before, others):
        number, already = self.piece, self.already
        verb_with = self.meeting_verb([*verbs.curves_of(before), *others])
        return lambda cancel: verbs.changed(before, number, verb_with(cancel), already)

    def _others(self, context, ob):
        obs = context.selected_objects if self.meet == 'SELECTED' else context.visible_objects
        return neighboring_curves.curves_of(ob, obs, context.evaluated_depsgraph_get())


class SPLINEWRIGHT_OT_extend_curve(_Meeting, bpy.types.Operator):
    bl_idname = "splinewright.extend_curve"
    bl_label = "Extend"
    bl_description = "Extend curves at their ends: by a length, or up to where they meet another curve; the curve itself stays"
    done = "Extended {what}"

    to: EnumProperty(name="Up To", items=(
        ('LENGTH', "Length", "So much longer"), ('CURVES', "Curves", "To where it first meets another curve")))
    ends: EnumProperty(name="At", items=(
        ('END', "End", "Where it ends"), ('START', "Start", "Where it starts"), ('BOTH', "Both", "At both ends")))
    how: how_property()
    by: FloatProperty(name="Length", description="By how much it is longer at each of these ends, in units of the object",
                      default=0.5, min=1e-9, precision=4, step=1, unit='LENGTH')

    expanded = ('to', 'ends', 'how')

    def settings(self):
        return ['to', *(['by'] if self.to == 'LENGTH' else ['meet']), 'ends', 'how']

    def meeting_verb(self, others):
        ends = {'END': ('end',), 'START': ('start',), 'BOTH': ('start', 'end')}[self.ends]
        if self.to == 'LENGTH':
            length, how = decimals.typed(self.by), self.how
            return lambda cancel: meeting.extend(ends, length, how)
        return partial(meeting.extend_to, ends, others, self.how)


class SPLINEWRIGHT_OT_trim_curve(pieces.FromActive, _Meeting, bpy.types.Operator):
    bl_idname = "splinewright.trim_curve"
    bl_label = "Trim"
    bl_description = "Remove the part of a curve around a parameter, up to where it meets other curves"
    done = "Trimmed {what}"
    asked = ('parameter',)

    parameter: parameter_property("Parameter", "Parameter u on the part that goes")
    exact: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})      # with every digit, where a click gave it

    def first_values(self, curve):
        return (float(curve.domain[1]),)

    def settings(self):
        return ['parameter', 'meet']

    def meeting_verb(self, others):
        return partial(meeting.trim, decimals.meant(self.parameter, self.exact), others)


class SPLINEWRIGHT_OT_split_where_met(_Meeting, bpy.types.Operator):
    bl_idname = "splinewright.split_where_met"
    bl_label = "Split at Intersections"
    bl_description = "Cut curves into pieces where they meet each other, themselves or other curves; the shape stays"
    done, already = "Split {what}", "it meets nothing"

    def meeting_verb(self, others):
        return partial(meeting.split_where_met, others)


CLASSES = (SPLINEWRIGHT_OT_extend_curve, SPLINEWRIGHT_OT_trim_curve, SPLINEWRIGHT_OT_split_where_met)
