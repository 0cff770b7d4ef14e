"""The settings of a shape as Blender's properties, and the door for scripts: data.splinewright.value."""

import bpy
from bpy.props import PointerProperty

from ..bridge.data import problems, settings, store
from ..bridge.data.file_state import state
from ..bridge.follow import follow
from ..bridge.net import live
from ..bridge.recipes import late
from ..bridge.shape import shape
from ..core.base.failures import FAILURES, sentence
from . import progress

#: Types of data-blocks that can hold a shape.
OWNERS = (bpy.types.Mesh, bpy.types.Curve)


def face_count(data):
    return len(data.polygons) if isinstance(data, bpy.types.Mesh) else 0


class SplinewrightShape(settings.Settings, bpy.types.PropertyGroup):
    """How finely a shape is shown. The definition itself lies in float64 beside it."""

    def changed(self, context):
        """Show the shape by the new settings."""
        data = self.id_data
        if not store.has_definition(data):
            return
        before = face_count(data)
        try:
            with progress.shown(context, shape.STEPS) as step:
                shape.rewrite(data, step)
            if face_count(data) != before:
                self.faces_before = before
        except FAILURES as error:
            problems.set_problem(data, problems.SETTING, sentence(error))
        live.note_settings(data)

    def when_changed(self, context):
        """A shape that is late need not wait any longer, but by Manual."""
        data = self.id_data
        if late.is_late(data) and self.update_mode != settings.MANUAL:
            follow.finish([data], bpy.context.evaluated_depsgraph_get())

    def set_resolution(self, resolution_u, resolution_v):
        """Both at once, and faces by count, with one evaluation at most. TypeError, and no change, for no whole number."""
        settings.set_count(self.id_data, resolution_u, resolution_v)

    @property
    def problem(self):
        """Why the last change of a setting shows nothing new, or what else went wrong, or ""."""
        return problems.of(self.id_data, problems.SETTING)

    @property
    def value(self):
        """The exact shape: a splinecore curve, list of curves, patch or PatchSet; None without one.

        Assigning one rewrites the mesh or curve; TypeError or ValueError, and no change, if it does not fit. Where keys of
        points went `problem` says so.
        """
        return shape.value_of(self.id_data)

    @value.setter
    def value(self, value):
        shape.set_value(self.id_data, value)
        problems.set_problem(self.id_data, problems.SETTING, "; ".join(state.lost_keys))
        state.lost_keys.clear()


CLASSES = (SplinewrightShape,)


def register():
    for owner in OWNERS:
        owner.splinewright = PointerProperty(type=SplinewrightShape, override={'LIBRARY_OVERRIDABLE'})


def unregister():
    for owner in OWNERS:
        del owner.splinewright
