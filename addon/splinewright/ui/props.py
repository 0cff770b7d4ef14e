"""Settings of a shape, on its Mesh or Curve, and the door for scripts: data.splinewright.value."""

import math

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from ..bridge import fineness, shape, store
from ..bridge.net import live
from ..core.failures import FAILURES, sentence
from . import progress

#: Types of data-blocks that can hold a shape.
OWNERS = (bpy.types.Mesh, bpy.types.Curve)


def _resolution_changed(self, context):
    if self.quiet or not store.has_definition(self.id_data):
        return
    before = face_count(self.id_data)
    try:
        with progress.shown(context, shape.STEPS) as step:
            shape.rewrite(self.id_data, step)
        self.problem = ""
        if face_count(self.id_data) != before:
            self.faces_before = before
    except FAILURES as error:
        self.problem = sentence(error)
    live.mark(self.id_data)


def face_count(data):
    return len(data.polygons) if isinstance(data, bpy.types.Mesh) else 0


class SplinewrightShape(bpy.types.PropertyGroup):
    """How finely a shape is shown. The definition itself lies in float64 beside it."""

    mode: EnumProperty(
        name="Faces", description="How many faces show the surface",
        items=((fineness.COUNT, "By Count", "So many in every span"),
               (fineness.TOLERANCE, "By Tolerance",
                "As many as it takes to come this near to the surface: few where it is flat"),
               (fineness.ANGLE, "By Angle",
                "As many as it takes for normals to turn by no more than an angle on a face"),
               (fineness.BOTH, "By Both", "As many as tolerance and angle take together")),
        default=fineness.COUNT, update=_resolution_changed)
    tolerance: FloatProperty(
        name="Tolerance", description="No point of the surface lies farther from the mesh, in units of the object",
        default=0.01, min=1e-9, soft_min=1e-5, soft_max=10.0, precision=4, step=0.1, unit='LENGTH',
        update=_resolution_changed)
    angle: FloatProperty(
        name="Angle", description="Normals turn by no more on a face",
        default=math.radians(15.0), min=math.radians(0.25), soft_min=math.radians(1.0), max=math.pi, subtype='ANGLE',
        update=_resolution_changed)
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
    show_seams: BoolProperty(
        name="Show on the Surface", description="Colour the seams of the patches along them by how smoothly they go on",
        default=False)
    problem: StringProperty(
        name="Problem", description="Why the last change of a setting shows nothing new",
        options={'HIDDEN', 'SKIP_SAVE'})
    faces_before: IntProperty(
        name="Faces Before", description="How many there were before a setting was changed last",
        options={'HIDDEN', 'SKIP_SAVE'})
    quiet: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})

    def set_resolution(self, resolution_u, resolution_v):
        """Both at once, with one evaluation at most."""
        self.quiet = True
        self.resolution_u = resolution_u
        self.quiet = False
        self.resolution_v = resolution_v

    def set_tolerance(self, tolerance):
        """Show the surface by tolerance, with one evaluation at most."""
        self.quiet = True
        self.mode = fineness.TOLERANCE
        self.quiet = False
        self.tolerance = tolerance

    def take_back(self, mode, tolerance):
        """Have these again after others showed nothing new."""
        self.quiet = True
        self.mode, self.tolerance = mode, tolerance
        self.quiet = False
        self.problem = ""

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
