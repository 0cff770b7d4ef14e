"""Convert to Splinewright and To Native: between Blender's own curves and surfaces and shapes."""

import bpy

from ...bridge.data import store
from ...bridge.native import make_exact, to_native
from ...bridge.shape import shape
from ...core.base.words import phrase
from . import reports
from .selected import OnSelected


def _is_native(ob):
    return ob.type in make_exact.TYPES and not store.has_definition(ob.data)


class _Conversion(OnSelected):
    """work() gives an Outcome and sentences."""

    def said(self, outcomes):
        measured = [outcome.deviation for outcome, _ in outcomes.values() if outcome.deviation is not None]
        distance = phrase(": Blender's points lie within {measured:.1e} of the exact ones",
                          measured=max(measured)) if measured else ""
        notes = {name: "; ".join(notes) for name, (_, notes) in outcomes.items() if notes}
        dropped = {name: phrase("without {dropped}", dropped=', '.join(outcome.dropped)) for name, (outcome, _) in outcomes.items()
                   if outcome.dropped}
        return reports.Report(self.summary(outcomes) + distance, reports.by_name(notes), reports.by_name(dropped))


class SPLINEWRIGHT_OT_make_exact(_Conversion, bpy.types.Operator):
    bl_idname = "splinewright.make_exact"
    bl_label = "Convert to Splinewright"
    bl_description = "Convert selected curves, surfaces and texts of Blender to Splinewright shapes of the same geometry"
    needs = "Select a curve or surface that is no Splinewright shape, or a text"
    done = "Made {what} exact"
    fits = staticmethod(_is_native)

    def work(self, context, ob):
        return make_exact.make_exact(context, ob), []


class SPLINEWRIGHT_OT_to_native(_Conversion, bpy.types.Operator):
    bl_idname = "splinewright.to_native"
    bl_label = "Convert to Blender Curve/Surface"
    bl_description = "Convert selected Splinewright shapes to Blender curves and surfaces of the same geometry"
    needs = "Select a Splinewright shape"
    done = "Made {what} Blender's own"
    fits = staticmethod(shape.has_shape)

    def work(self, context, ob):
        return to_native.to_native(context, ob)


CLASSES = (SPLINEWRIGHT_OT_make_exact, SPLINEWRIGHT_OT_to_native)
