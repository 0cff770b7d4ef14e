"""Knots are inserted and removed on the knot strip: by a double click, and by a key with the mouse over a knot."""

import bpy

from ...bridge.data.settings import overlays_of
from ...bridge.recipes import recipes
from ...core.base.failures import FAILURES, blenders_refusals
from .. import knot_strip as strip
from .. import editing
from . import reports
from .on_shapes import at_exactly


class _OnStrip:
    """Does something at the mouse, by the operator whose panel then has the numbers."""

    bl_options = {'INTERNAL'}

    def call(self, context, hit):
        """Returns what an operator does."""
        raise NotImplementedError

    def invoke(self, context, event):
        hit = strip.hit(context, event.mouse_region_x, event.mouse_region_y)
        if hit is None:
            return {'PASS_THROUGH', 'CANCELLED'}
        problem = editing.unread(editing.nets_in_edit_mode(context))
        if problem:
            return reports.cancelled(self, problem)
        try:
            recipes.require_free(hit.shown.ob.data)
            with blenders_refusals():
                return self.call(context, hit)
        except FAILURES as error:
            return reports.failed(self, error)


class SPLINEWRIGHT_OT_insert_on_strip(_OnStrip, bpy.types.Operator):
    bl_idname = "splinewright.insert_on_strip"
    bl_label = "Insert Knot on Strip"
    bl_description = "Insert a knot where the mouse is over the knot strip; the shape stays the same"

    def call(self, context, hit):
        return _called('insert_knot', hit, where='PARAMETER', times=1)


class SPLINEWRIGHT_OT_remove_on_strip(_OnStrip, bpy.types.Operator):
    bl_idname = "splinewright.remove_on_strip"
    bl_label = "Remove Knot on Strip"
    bl_description = "Remove the knot of the knot strip at the mouse, as far as the tolerance lets the shape move"

    def call(self, context, hit):
        if hit.mark is None:
            return reports.stopped(self, "Point at the mark of a knot to remove it")
        return _called('remove_knot', hit, nearest=False, times=1, limited=True,
                       tolerance=overlays_of(context.scene).strip_tolerance)


def _called(name, hit, **settings):
    """The verb of that name for what the strip shows, along its axis."""
    settings.update(at_exactly(hit.value, hit.value), only=hit.shown.ob.name, piece=hit.shown.number,
                    direction=(hit.bar.name or "u").upper())
    return getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True, **settings)


CLASSES = (SPLINEWRIGHT_OT_insert_on_strip, SPLINEWRIGHT_OT_remove_on_strip)
