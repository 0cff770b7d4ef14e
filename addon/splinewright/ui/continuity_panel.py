"""How smoothly a curve shape goes on at its joints, in the sidebar."""

import math

import bpy

from ..bridge import replacing, store, surveys
from ..bridge.net import live, net
from . import texts

#: Titles of the columns, and their shares of the width.
_COLUMNS = (("Joint", 0.28), ("Class", 0.18), ("Gap", 0.18), ("Angle", 0.18), ("Curvature", 0.18))


class SPLINEWRIGHT_PT_continuity(bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_continuity"
    bl_label = "Continuity"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "Splinewright"
    bl_parent_id = "SPLINEWRIGHT_PT_shape"
    bl_options = {'DEFAULT_CLOSED'}

    @classmethod
    def poll(cls, context):
        return _shape_in_hand(context.object) is not None

    def draw(self, context):
        try:
            survey = surveys.survey_of(_shape_in_hand(context.object).data)
        except store.UnreadableDefinition:
            return                      # the panel above says it
        if net.is_net(context.object) and live.problem(context.object):
            texts.draw_note(self.layout, "As it was before the last change, which is not shown")
        if not survey.count:
            self.layout.label(text="No joints: every piece is one span")
            return
        _draw_rows(self.layout, survey)


def _shape_in_hand(ob):
    """The curve shape that is active, or whose net is; None where there is none."""
    owner = net.shape_of(ob) if ob is not None and net.is_net(ob) else ob
    return owner if replacing.is_curve_shape(owner) else None


def _draw_rows(layout, survey):
    columns = _columns(layout)
    for column, (title, _) in zip(columns, _COLUMNS):
        column.label(text=title)
    for joint in survey.joints:
        for column, text in zip(columns, cells(joint)):
            column.label(text=text)
    hidden = survey.count - len(survey.joints)
    if hidden:
        layout.label(text=f"and {hidden:,} more")
    if any(joint.continuity is None for joint in survey.joints):
        texts.draw_note(layout, "A joint at infinity cannot be measured")


def _columns(layout):
    """Columns side by side with the shares of _COLUMNS."""
    found, rest, left = [], layout, 1.0
    for _, share in _COLUMNS[:-1]:
        split = rest.split(factor=share / left)
        found.append(split.column(align=True))
        rest, left = split.row(), left - share
    return [*found, rest.column(align=True)]


def cells(joint):
    """The texts of a row: place, class, gap, angle in degrees, difference of curvatures."""
    measured = joint.continuity
    if measured is None:
        return [joint.place, "at infinity", "", "", ""]
    angle = f"{math.degrees(measured.angle):.2g}°"
    return [joint.place, _class(measured, joint.degree), f"{measured.gap:.2g}", angle,
            f"{measured.curvature_difference:.2g}"]


def _class(measured, degree):
    """Parametric and geometric continuity in one word."""
    if measured.c < 0:
        return "gap"
    if measured.c >= degree:
        return "C∞"
    return f"C{measured.c} G{measured.g}"


CLASSES = (SPLINEWRIGHT_PT_continuity,)
