"""How smoothly a shape continues, curves at their joints and patches at their seams, in the sidebar."""

import math

import bpy

from ..bridge.analysis import surveys
from ..bridge.cage import net_object
from ..bridge.data import held, store
from ..bridge.edit import replace_pieces
from ..bridge.net import live
from ..core.base.words import phrase, say
from ..core.joints import continuity, held_joints
from . import active_shape, colors, texts
from .sub_panel import ClosedPanel

#: Gaps, angles in degrees and differences of curvatures below it are none.
_ROUNDING = 1e-9
#: Characters of a name that leave room beside it.
_SHORT = 14


class SPLINEWRIGHT_PT_continuity(ClosedPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_continuity"
    bl_label = "Continuity"
    bl_order = 5

    @classmethod
    def poll(cls, context):
        return active_shape.shape_of(context.object) is not None

    def draw(self, context):
        try:
            survey = surveys.survey_of(active_shape.shape_of(context.object).data)
        except store.UnreadableDefinition:
            return                      # the panel above says it
        if net_object.is_net(context.object) and live.problem(context.object):
            texts.draw_note(self.layout, "As it was before the last change, which is not shown")
        data = active_shape.shape_of(context.object).data
        is_surface = isinstance(data, bpy.types.Mesh)
        if survey.bendable:
            texts.draw_note(self.layout, phrase("Pulled at {count:,} knots inside it may crease: deformable or rebuilt it "
                                                "stays smooth",
                                                one="Pulled at {count:,} knot inside it may crease: deformable or rebuilt it stays smooth",
                                                count=survey.bendable))
        if not survey.count:
            self.layout.label(text="No seams" if is_surface else "No joints")
            return
        if is_surface:
            self.layout.prop(data.splinewright, "show_seams")
            if data.splinewright.show_seams:
                colors.draw_legend(self.layout)
        if active_shape.count_of(data) > 1:
            self.layout.prop(data.splinewright, "show_numbers")
        _draw_in_columns(self.layout, list(map(say, ("Gap", "Angle", "Curvature"))))
        _draw_joints(self.layout, survey, _Locks(self.layout, data))


def _draw_in_columns(layout, items):
    """One text, or three of which the last has most room."""
    for item, share in zip(items, (0.31, 0.44, 1.0) if len(items) > 1 else (1.0,)):
        layout = layout.split(factor=share)
        layout.label(text=item)


class _Locks:
    """Of the joints or seams of a shape: whether they hold, or may."""

    def __init__(self, layout, data):
        self._ways = surveys.ways_of(data)
        self._of = "joint" if store.read(data).has_curves else "seam"
        try:
            self._known = {frozenset((one.first, one.second)): one for one in held.read(data)}
        except store.UnreadableDefinition as error:
            texts.draw_problem(layout, str(error))
            layout.operator(f"splinewright.release_{self._of}", text="Release All")
            self._known = {}
        self._can_change = replace_pieces.seems_changeable(data)
        self.reasons = []               # why some may not, each once

    def holds(self, joint):
        """What holds there, or None."""
        return self._known.get(frozenset(joint.sides)) if joint.sides else None

    def _draw_way(self, layout, first, second, reason):
        """Keep in words why a joint may not hold, and of two edges that lie on each other draw the button that makes them one."""
        if reason and reason not in self.reasons:
            self.reasons.append(reason)
        if not reason or first[0] == second[0]:
            return
        layout = layout.row()
        layout.enabled = self._can_change
        operator = layout.operator("splinewright.join_patches", text="", icon='UNLINKED')
        operator.continuity = 'C0'
        operator.first, operator.second = first[0] + 1, second[0] + 1
        operator.first_side, operator.second_side = first[1], second[1]

    def draw(self, layout, joint):
        """Its button, if it may hold; else what helps."""
        if not joint.sides:             # a crease inside a patch
            return
        (first, second), holds, way = joint.sides, self.holds(joint), self._ways[joint.sides]
        if not holds and not way.is_open:
            self._draw_way(layout, first, second, way.why_not)
            return
        layout = layout.row()
        layout.enabled = self._can_change
        operator = layout.operator(f"splinewright.{'release' if holds else 'hold'}_{self._of}", text=say(holds.smoothness if holds else ""),
                                   icon='LOCKED' if holds else 'UNLOCKED')
        operator.first, operator.second = first[0] + 1, second[0] + 1
        if self._of == "seam":
            operator.first_side, operator.second_side = first[1], second[1]
        elif first[1] in held_joints.ENDS:
            operator.first_end, operator.second_end = first[1], second[1]
        else:
            operator.knot = way.knot


def _draw_joints(layout, survey, locks):
    for joint in survey.joints:
        box = layout.box().column(align=True)
        name = say(joint.name)
        row = box.split(factor=0.6) if len(name) <= _SHORT and not locks.holds(joint) else box
        row.label(text=name)
        row = row.row(align=True)
        row.label(text=say(kind(joint)))
        locks.draw(row, joint)
        _draw_in_columns(box, numbers(joint))
    for reason in locks.reasons:
        texts.draw_note(layout, reason)
    hidden = survey.count - len(survey.joints)
    if hidden:
        layout.label(text=say(phrase("and {hidden:,} more", hidden=hidden)))


def kind(joint):
    """Parametric and geometric continuity in one word."""
    return "" if joint.continuity is None else continuity.in_words(joint.continuity, joint.degree)


def numbers(joint):
    """Gap, angle in degrees and difference of curvatures as texts; a word for a joint at infinity."""
    measured = joint.continuity
    if measured is None:
        return [say("at infinity: not measured")]
    return [_short(measured.gap), _short(math.degrees(measured.angle)) + "°", _short(measured.curvature_difference)]


def _short(number):
    """At most seven characters; rounding errors count as 0."""
    if abs(number) < _ROUNDING:
        return "0"
    return f"{number:.3g}" if 1e-3 <= number < 999.5 else f"{number:.0e}"


CLASSES = (SPLINEWRIGHT_PT_continuity,)
