"""Where the selected shapes meet: points of a mesh, and curves."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty

from ...bridge.follow import recipe_results
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.meets import meets
from ...core.shape import transform
from ...core.verbs import verbs
from .. import progress, scene_tolerance
from . import new_shapes, reports
from .adding import Repeatable, can_add, resolution_property
from .long_work import LongWork


class SPLINEWRIGHT_OT_intersections(LongWork, Repeatable, bpy.types.Operator):
    bl_idname = "splinewright.intersections"
    bl_label = "Mark Intersections"
    bl_description = ("Add the intersection points of selected curves and surfaces as a mesh, and common curves of surfaces "
                      "as a shape")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    themselves: BoolProperty(name="With Themselves", description="Also where a curve meets itself, or other pieces of its shape",
                             default=True)
    tolerance: FloatProperty(name="Tolerance", description="How far curves that surfaces have in common may lie from them, in the "
                             "scene", default=1e-4, min=1e-9, precision=6, unit='LENGTH', options={'SKIP_SAVE'})
    resolution_u: resolution_property()

    @classmethod
    def poll(cls, context):
        if not can_add(cls, context):
            return False
        if cls.has_made(context) or any(map(recipe_results.is_possible, context.selected_objects)):
            return True
        cls.poll_message_set(say("Select curves and surfaces"))
        return False

    def tasks(self, context):
        scene_tolerance.settle_in_object(self, context, None)
        return {'found': self._task(context)}

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        scene_tolerance.settle_in_object(self, context, None)
        sources = self._sources(context)
        try:
            with progress.shown(context, len(sources) * (len(sources) - 1) // 2) as told:
                found = self.result_of('found', self._task(context, told))
        except FAILURES as error:
            return reports.failed(self, error)
        new = [*_points(found.points), *self._curves(found.curves)]
        for ob in sources:
            ob.select_set(False)
        for ob in new:
            context.collection.objects.link(ob)
            ob.select_set(True)
        context.view_layer.objects.active = new[0]
        return self.finished(context, reports.Report(", ".join(_counted(len(found.points), len(found.curves)))))

    def _sources(self, context):
        return [ob for ob in context.selected_objects if recipe_results.is_possible(ob)]

    def _task(self, context, told=lambda done: None):
        """A function that gives the meets.Found in the world, for a `cancel` as the library takes it. Raises Refusal."""
        sources = self._sources(context)
        if not sources:
            raise Refusal("select curves and surfaces")
        depsgraph = context.evaluated_depsgraph_get()
        shapes = []
        for ob in sources:
            matrix = recipe_results.matrix_in(ob, None, depsgraph)
            shapes.append(verbs.pieces_of(transform.transformed(recipe_results.definition_of(ob, depsgraph), matrix)))
        tolerance, themselves = decimals.typed(self.tolerance), self.themselves
        return lambda cancel: meets.among(shapes, tolerance, themselves, told if cancel is None else lambda done: None, cancel)

    def _curves(self, curves):
        if not curves:
            return []
        data = shape.new_data("Intersection Curves", curves if len(curves) > 1 else curves[0], new_shapes.start(self))
        return [bpy.data.objects.new(data.name, data)]

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "themselves")
        layout.prop(self, "tolerance")
        new_shapes.draw(self, layout)


def _points(points):
    if not len(points):
        return []
    mesh = bpy.data.meshes.new("Intersections")
    mesh.from_pydata(np.asarray(points, dtype=np.float64).tolist(), [], [])
    return [bpy.data.objects.new(mesh.name, mesh)]


def _counted(points, curves):
    if points:
        yield phrase("{count} points", one="{count} point", count=points)
    if curves:
        yield phrase("{count} curves", one="{count} curve", count=curves)


CLASSES = (SPLINEWRIGHT_OT_intersections,)
