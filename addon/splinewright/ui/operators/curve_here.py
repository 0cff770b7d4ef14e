"""By clicks on curves: one is trimmed or extended, two get an arc or a segment between them. Where is shown at the mouse."""

from functools import partial

import bpy

from ...bridge.analysis import surveys
from ...bridge.edit import replace_pieces
from ...bridge.follow import neighboring_curves
from ...core.base import decimals
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.meets import meeting
from .. import active_shape, aim_overlay, picking
from ..ui_state import ui_state
from . import curve_corners, curve_meeting, polls, reports
from .gesture import redraw
from .insert_here import ByClick
from .pointing import Pointing, given


def once(known, key, find):
    """What find() gives, which is called for each key once."""
    if key not in known:
        known[key] = find()
    return known[key]


class _OnCurve(ByClick):
    """Only curves are clicked."""

    works_on_nets = False
    dimensions = (1,)

    meet: curve_meeting.with_property(options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT' or not any(map(replace_pieces.is_curve_shape, context.selected_objects)):
            cls.poll_message_set(say("Select a curve shape in Object Mode"))
            return False
        return super().poll(context)

    def operator(self, parameter, domain):
        """The edit of the piece that was clicked, and its settings for a parameter and the domain."""
        raise NotImplementedError

    def invoke(self, context, event):
        self._known = {}
        return super().invoke(context, event)

    def told(self, context, aimed):
        return self.with_line(context, aimed, self.meet, self._known)

    @classmethod
    def meant(cls, context):
        return list(filter(replace_pieces.is_curve_shape, super().meant(context)))

    @classmethod
    def with_line(cls, context, aimed, meet, known):
        """An Aim with what a click would do. known: {}, which keeps results once for each piece and end."""
        if len(aimed.parameters) != 1:
            return aimed
        ob = bpy.data.objects[aimed.name]
        obs = context.selected_objects if meet == 'SELECTED' else context.visible_objects
        try:
            curves = once(known, (ob.name, meet), lambda: [*surveys.pieces_of(ob.data), *neighboring_curves.curves_of(
                ob, obs, context.evaluated_depsgraph_get())])
            line = cls.line_of(curves, aimed, partial(once, known))
        except FAILURES:
            line = None
        return aimed._replace(line=line)

    @staticmethod
    def line_of(curves, aimed, once):
        """(n, 3) of what a click would take or add, or None. curves: the pieces, and all that they may meet; once(key, find)
        calls find() for each key once."""
        raise NotImplementedError

    def clicked(self, aimed):
        if len(aimed.parameters) != 1:
            return {'CANCELLED'}        # a patch is no curve
        ob = bpy.data.objects[aimed.name]
        domain = surveys.pieces_of(ob.data)[aimed.number - 1].domain
        operator, settings = self.operator(aimed.parameters[0], domain)
        return reports.called(self, operator, only=aimed.name, piece=aimed.number, **settings)


class SPLINEWRIGHT_OT_trim_here(_OnCurve, bpy.types.Operator):
    bl_idname = "splinewright.trim_here"
    bl_label = "Trim"
    bl_description = "Click the part of a curve to remove, up to where it meets other visible curves"
    thing, does = "Part at {numbers}", "Click: trim"

    def operator(self, parameter, domain):
        return bpy.ops.splinewright.trim_curve, {'parameter': decimals.single(parameter), 'exact': repr(float(parameter)),
                                                'meet': self.meet}

    @staticmethod
    def line_of(curves, aimed, once):
        curve = curves[aimed.number - 1]
        parts = once((aimed.name, aimed.number), lambda: meeting.parts_where_met(curve, curves))
        return meeting.part_about(parts, curve, aimed.parameters[0])


class SPLINEWRIGHT_OT_extend_here(_OnCurve, bpy.types.Operator):
    bl_idname = "splinewright.extend_here"
    bl_label = "Extend"
    bl_description = "Click a curve near an end to extend it to where it meets another visible curve"
    thing, does = "End nearest to {numbers}", "Click: extend"

    how: curve_meeting.how_property(options={'SKIP_SAVE'})

    def operator(self, parameter, domain):
        return bpy.ops.splinewright.extend_curve, {'to': 'CURVES', 'ends': _end(parameter, domain).upper(), 'how': self.how,
                                                   'meet': self.meet}

    @staticmethod
    def line_of(curves, aimed, once):
        curve = curves[aimed.number - 1]
        end = _end(aimed.parameters[0], curve.domain)
        return once((aimed.name, aimed.number, end), lambda: meeting.extension(curve, curves, end))


def _end(parameter, domain):
    return 'start' if parameter - domain[0] < domain[1] - parameter else 'end'


class _PicksCurves(Pointing):
    """Two curves are clicked on the parts that stay."""

    bl_options = {'REGISTER'}
    #: Settings of the operator that is called, which are kept there.
    passed = ()

    joined: curve_corners.joined_property(options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replace_pieces.is_curve_shape, "Select one or two curve shapes")

    @staticmethod
    def operator():
        """The edit of the two."""
        raise NotImplementedError

    @property
    def hint(self):
        which = "the second curve" if self._picked else "the first of two curves"
        return phrase("Click {which} on the part to keep   |   Esc, Right Mouse: Cancel", which=which)

    def invoke(self, context, event):
        self._picked = []
        return self.begin(context, event)

    def forget(self):
        ui_state.aimed = None

    def look(self, context, event):
        try:
            found = picking.pointed_at(event.mouse_x, event.mouse_y, self.meant(context), context.evaluated_depsgraph_get())
        except FAILURES:
            found = None                # such a shape shows nothing to point at
        self._found = found if found and not self._is_picked(found) else None
        shown = self._found or next(iter(self._picked), None)
        ui_state.aimed = aim_overlay.Aim(shown[0].name, *shown[1:], 'U') if shown else None
        redraw()
        return self._found is not None

    def meant(self, context):
        obs = [ob for ob in context.selected_objects if active_shape.is_free(ob) and ob.visible_get()]
        return [ob for ob in obs if ob != self._picked[0][0]] if self._picked and len(obs) > 1 else obs

    def _is_picked(self, found):
        return any(found[:2] == one[:2] for one in self._picked)

    def clicked(self, context):
        self._picked.append(self._found)
        if len(self._picked) < 2:
            return {'RUNNING_MODAL'}
        first, second = sorted(self._picked, key=lambda one: one[0] != context.object)
        self.cancel(context)
        return reports.called(self, self.operator(), first=first[1], second=second[1], picked=True,
                              first_at=first[2][0], second_at=second[2][0], **given(self, 'joined', *self.passed))


class SPLINEWRIGHT_OT_fillet_here(_PicksCurves, bpy.types.Operator):
    bl_idname = "splinewright.fillet_here"
    bl_label = "Fillet"
    bl_description = "Click two curves on the parts that stay: an arc of a circle goes between them"
    passed = ('radius',)

    radius: curve_corners.length_property("Radius", "Of the arc", options={'SKIP_SAVE'})

    @staticmethod
    def operator():
        return bpy.ops.splinewright.fillet_curves


class SPLINEWRIGHT_OT_chamfer_here(_PicksCurves, bpy.types.Operator):
    bl_idname = "splinewright.chamfer_here"
    bl_label = "Chamfer"
    bl_description = "Click two curves on the parts that stay: a segment goes between them"
    passed = ('first_length', 'second_length')

    first_length: curve_corners.length_property("First Length", "Along the first curve", 0.0, options={'SKIP_SAVE'})
    second_length: curve_corners.length_property("Second Length", "Along the second curve", 0.0, options={'SKIP_SAVE'})

    @staticmethod
    def operator():
        return bpy.ops.splinewright.chamfer_curves


CLASSES = (SPLINEWRIGHT_OT_trim_here, SPLINEWRIGHT_OT_extend_here, SPLINEWRIGHT_OT_fillet_here, SPLINEWRIGHT_OT_chamfer_here)
