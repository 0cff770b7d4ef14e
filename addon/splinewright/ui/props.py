"""Settings of a shape, on its Mesh or Curve, and the door for scripts: data.splinewright.value."""

import math

import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from ..bridge import shape, store
from ..core.failures import FAILURES, sentence
from . import progress

#: Types of data-blocks that can hold a shape.
OWNERS = (bpy.types.Mesh, bpy.types.Curve)


def _resolution_changed(self, context):
    if self.quiet or not store.has_definition(self.id_data):
        return
    try:
        with progress.shown(context, shape.STEPS) as step:
            shape.rewrite(self.id_data, step)
        self.problem = ""
    except FAILURES as error:
        self.problem = sentence(error)


class SplinewrightShape(bpy.types.PropertyGroup):
    """How finely a shape is shown. The definition itself lies in float64 beside it."""

    resolution_u: IntProperty(
        name="Resolution U", description="Steps in every span along u",
        default=12, min=1, max=4096, soft_max=64, update=_resolution_changed)
    resolution_v: IntProperty(
        name="Resolution V", description="Steps in every span along v",
        default=12, min=1, max=4096, soft_max=64, update=_resolution_changed)
    sharp_angle: FloatProperty(
        name="Sharp Angle", description="Edges across which the exact normals differ by more are marked sharp",
        default=math.radians(1.0), min=0.0, max=math.pi, subtype='ANGLE', update=_resolution_changed)
    reach: FloatProperty(
        name="Reach", description="How far beyond its points a curve that runs to infinity is shown",
        default=10.0, min=0.001, max=1e6, soft_max=1000.0, unit='LENGTH', update=_resolution_changed)
    problem: StringProperty(
        name="Problem", description="Why the last change of a setting shows nothing new",
        options={'HIDDEN', 'SKIP_SAVE'})
    quiet: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})

    def set_resolution(self, resolution_u, resolution_v):
        """Both at once, with one evaluation at most."""
        self.quiet = True
        self.resolution_u = resolution_u
        self.quiet = False
        self.resolution_v = resolution_v

    @property
    def value(self):
        """The exact shape: a splinecore curve, list of curves, patch or PatchSet; None without one.

        Assigning one rewrites the mesh or curve; TypeError or ValueError, and no change, if it does not fit.
        """
        return shape.value_of(self.id_data)

    @value.setter
    def value(self, value):
        shape.set_value(self.id_data, value)


CLASSES = (SplinewrightShape,)


def register():
    for owner in OWNERS:
        owner.splinewright = PointerProperty(type=SplinewrightShape)


def unregister():
    for owner in OWNERS:
        del owner.splinewright
