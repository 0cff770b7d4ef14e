"""Make Exact and To Native: between Blender's own curves and surfaces and shapes."""

import bpy

from ...bridge import shape, store
from ...bridge.native import make_exact, to_native
from .. import progress

_FAILURES = (ValueError, TypeError, ArithmeticError, RuntimeError, MemoryError)


def _is_native(ob):
    return ob.type in ('CURVE', 'SURFACE') and not store.has_definition(ob.data)


class _InPlace:
    """Does its work on every selected object that fits; what cannot be done is reported and the rest is done."""

    bl_options = {'REGISTER', 'UNDO'}
    #: poll_message where nothing fits, and what was done, for the report.
    needs, done = "", ""

    @staticmethod
    def fits(ob):
        raise NotImplementedError

    def work(self, context, ob):
        """Pairs of an Outcome and sentences. Raises, and has changed nothing, if it cannot be done."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT':
            cls.poll_message_set("Leave the present mode first")
            return False
        if not any(map(cls.fits, context.selected_objects)):
            cls.poll_message_set(cls.needs)
            return False
        return True

    def execute(self, context):
        # One for each data-block: objects that share one are changed together.
        chosen = list({(ob.type, ob.data.name_full): ob for ob in context.selected_objects if self.fits(ob)}.values())
        names, outcomes, failed = [ob.name for ob in chosen], {}, {}
        with progress.shown(context, len(chosen)) as step:
            for i, ob in enumerate(chosen):
                try:
                    outcomes[names[i]] = self.work(context, ob)
                except _FAILURES as error:
                    failed[names[i]] = str(error) or "there is not enough memory"
                step(i + 1)
        for name, reason in failed.items():
            self.report({'WARNING' if outcomes else 'ERROR'}, f"{name}: {reason}")
        if not outcomes:
            return {'CANCELLED'}
        self._report(outcomes)
        return {'FINISHED'}

    def _report(self, outcomes):
        for name, (outcome, notes) in outcomes.items():
            if outcome.dropped:
                self.report({'WARNING'}, f"{name}: without {', '.join(outcome.dropped)}")
            for note in notes:
                self.report({'INFO'}, f"{name}: {note}")
        names = list(outcomes)[0] if len(outcomes) == 1 else f"{len(outcomes)} objects"
        measured = [outcome.deviation for outcome, _ in outcomes.values() if outcome.deviation is not None]
        distance = f": Blender's points lie within {max(measured):.1e} of the exact ones" if measured else ""
        self.report({'INFO'}, f"{self.done.format(names)}{distance}")


class SPLINEWRIGHT_OT_make_exact(_InPlace, bpy.types.Operator):
    bl_idname = "splinewright.make_exact"
    bl_label = "Make Exact"
    bl_description = ("Turn selected curves and surfaces of Blender into Splinewright shapes of the same geometry, "
                      "in their place; surfaces become meshes")
    needs = "Select a curve or surface that is no Splinewright shape"
    done = "Made {} exact"
    fits = staticmethod(_is_native)

    def work(self, context, ob):
        return make_exact.make_exact(context, ob), []


class SPLINEWRIGHT_OT_to_native(_InPlace, bpy.types.Operator):
    bl_idname = "splinewright.to_native"
    bl_label = "To Blender's Own"
    bl_description = ("Turn selected Splinewright shapes into Blender's own curves and surfaces of the same geometry, "
                      "in their place; meshes of patches become surfaces")
    needs = "Select a Splinewright shape"
    done = "Made {} Blender's own"
    fits = staticmethod(shape.has_shape)

    def work(self, context, ob):
        return to_native.to_native(context, ob)


CLASSES = (SPLINEWRIGHT_OT_make_exact, SPLINEWRIGHT_OT_to_native)
