"""By clicks on curves: one is trimmed or goes on, two get an arc or a segment between them. Where is shown at the mouse."""

import bpy

from ...bridge import beside, replacing, surveys
from ...bridge.file_state import state
from ...core import meeting
from ...core.failures import FAILURES
from .. import aim_overlay, hand, picking
from . import polls, reports
from .insert_here import ByClick
from .pointing import Pointing, redraw


class _OnCurve(ByClick):
    """Only curves are clicked."""

    works_on_nets = False

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT' or not any(map(replacing.is_curve_shape, context.selected_objects)):
            cls.poll_message_set("Select a curve shape in Object Mode")
            return False
        return super().poll(context)

    @staticmethod
    def operator():
        """What is done with the piece that was clicked, and its settings for a parameter and the domain."""
        raise NotImplementedError

    def invoke(self, context, event):
        self._known = {}
        return super().invoke(context, event)

    @classmethod
    def meant(cls, context):
        return list(filter(replacing.is_curve_shape, super().meant(context)))

    def once(self, key, find):
        """What find() gives, which is called for each key once."""
        if key not in self._known:
            self._known[key] = find()
        return self._known[key]

    def told(self, context, aimed):
        """What a click would do is found once for each piece and end."""
        if len(aimed.parameters) != 1:
            return aimed
        ob = bpy.data.objects[aimed.name]
        try:
            curves = self.once(ob.name, lambda: [*surveys.pieces_of(ob.data), *beside.curves_of(
                ob, context.visible_objects, context.evaluated_depsgraph_get())])
            line = self.line_of(curves, aimed)
        except FAILURES:
            line = None
        return aimed._replace(line=line)

    def line_of(self, curves, aimed):
        """(n, 3) of what a click would take or add, or None. curves: the pieces, and all that they may meet."""
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
    bl_label = "Trim by Click"
    bl_description = "Click the part of a curve to remove, up to where it meets other visible curves"
    thing, does = "Part", "trim"

    @staticmethod
    def operator(parameter, domain):
        return bpy.ops.splinewright.trim_curve, {'parameter': parameter, 'meet': 'VISIBLE'}

    def line_of(self, curves, aimed):
        curve = curves[aimed.number - 1]
        parts = self.once((aimed.name, aimed.number), lambda: meeting.parts_where_met(curve, curves))
        return meeting.part_about(parts, curve, aimed.parameters[0])


class SPLINEWRIGHT_OT_extend_here(_OnCurve, bpy.types.Operator):
    bl_idname = "splinewright.extend_here"
    bl_label = "Extend by Click"
    bl_description = "Click a curve near an end to extend it to where it meets another visible curve"
    thing, does = "End nearest", "extend"

    @staticmethod
    def operator(parameter, domain):
        return bpy.ops.splinewright.extend_curve, {'to': 'CURVES', 'ends': _end(parameter, domain).upper(), 'how': 'natural',
                                                   'meet': 'VISIBLE'}

    def line_of(self, curves, aimed):
        curve = curves[aimed.number - 1]
        end = _end(aimed.parameters[0], curve.domain)
        return self.once((aimed.name, aimed.number, end), lambda: meeting.extension(curve, curves, end))


def _end(parameter, domain):
    return 'start' if parameter - domain[0] < domain[1] - parameter else 'end'


class _PicksCurves(Pointing):
    """Two curves are clicked on the parts that stay."""

    bl_options = {'REGISTER'}

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replacing.is_curve_shape, "curve")

    @staticmethod
    def operator():
        """What is done with the two."""
        raise NotImplementedError

    def invoke(self, context, event):
        self._picked = []
        return self.begin(context, event)

    def forget(self):
        state.aimed = None

    def look(self, context, event):
        try:
            found = picking.pointed_at(event.mouse_x, event.mouse_y, self.meant(context), context.evaluated_depsgraph_get())
        except FAILURES:
            found = None                # such a shape shows nothing to point at
        self._found = found if found and not self._is_picked(found) else None
        state.aimed = aim_overlay.Aim(self._found[0].name, *self._found[1:], 'U') if self._found else None
        redraw()
        return self._found is not None

    def meant(self, context):
        obs = [ob for ob in context.selected_objects if hand.is_free(ob) and ob.visible_get()]
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
                              first_at=first[2][0], second_at=second[2][0])


class SPLINEWRIGHT_OT_fillet_here(_PicksCurves, bpy.types.Operator):
    bl_idname = "splinewright.fillet_here"
    bl_label = "Fillet by Click"
    bl_description = "Click two curves on the parts that stay: an arc of a circle goes between them"
    hint = "Click two curves on the parts that stay   |   Esc, Right Mouse: Cancel"

    @staticmethod
    def operator():
        return bpy.ops.splinewright.fillet_curves


class SPLINEWRIGHT_OT_chamfer_here(_PicksCurves, bpy.types.Operator):
    bl_idname = "splinewright.chamfer_here"
    bl_label = "Chamfer by Click"
    bl_description = "Click two curves on the parts that stay: a segment goes between them"
    hint = SPLINEWRIGHT_OT_fillet_here.hint

    @staticmethod
    def operator():
        return bpy.ops.splinewright.chamfer_curves


CLASSES = (SPLINEWRIGHT_OT_trim_here, SPLINEWRIGHT_OT_extend_here, SPLINEWRIGHT_OT_fillet_here, SPLINEWRIGHT_OT_chamfer_here)
