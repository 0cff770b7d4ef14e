"""How finely a shape is shown: the settings of its Mesh or Curve. Blender's properties are made of them in ui/props."""

import math
from contextlib import contextmanager

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from .file_state import key, state

#: The ways to choose faces.
AUTOMATIC, COUNT, TOLERANCE, ANGLE, BOTH = 'AUTOMATIC', 'COUNT', 'TOLERANCE', 'ANGLE', 'BOTH'
#: Of what is drawn over a shape: an override of a linked one has its own. What the geometry depends on it has from its library, as
#: Blender reads that from there.
_OF_OVERRIDES = {'LIBRARY_OVERRIDABLE'}
#: When a shape is made again whose inputs change.
ALWAYS, ON_RELEASE, MANUAL = 'ALWAYS', 'ON_RELEASE', 'MANUAL'
#: Settings of which the geometry depends.
_SHOWING = ('mode', 'tolerance', 'angle', 'resolution_u', 'resolution_v', 'sharp_angle', 'reach')


def of(data):
    """The Settings of a data-block."""
    return data.splinewright


def overlays_of(scene):
    """The switches of what a scene shows over shapes."""
    return scene.splinewright_sights


@contextmanager
def quiet(data):
    """While the settings of a data-block change, nothing is evaluated."""
    name = key(data)
    was_quiet = name in state.quiet
    state.quiet.add(name)
    try:
        yield
    finally:
        if not was_quiet:
            state.quiet.discard(name)


def set_resolution(data, resolution_u, resolution_v):
    """Both at once, with one evaluation at most. Raises TypeError, and changes nothing, for anything but whole numbers."""
    settings = of(data)
    was = settings.resolution_u
    with quiet(data):
        settings.resolution_u = resolution_u
    try:
        settings.resolution_v = resolution_v
    except TypeError:
        with quiet(data):
            settings.resolution_u = was
        raise


def set_count(data, resolution_u, resolution_v):
    """Show a surface by a number of faces in every span, with one evaluation at most. Raises as set_resolution()."""
    was = of(data).mode
    with quiet(data):
        of(data).mode = COUNT
    try:
        set_resolution(data, resolution_u, resolution_v)
    except TypeError:
        with quiet(data):
            of(data).mode = was
        raise


def start(data, resolution_u, resolution_v, mode=COUNT, tolerance=None, angle=None):
    """Give a new data-block, which shows nothing yet, its first settings."""
    set_resolution(data, resolution_u, resolution_v)
    wanted = {'mode': mode, 'tolerance': tolerance, 'angle': angle}
    with quiet(data):
        for name, value in wanted.items():
            if value is not None:
                setattr(of(data), name, value)


def set_tolerance(data, tolerance):
    """Show the surface by tolerance, with one evaluation at most."""
    with quiet(data):
        of(data).mode = TOLERANCE
    of(data).tolerance = tolerance


def put_back(data, mode, tolerance):
    """Have these again, without an evaluation, after others showed nothing new."""
    with quiet(data):
        of(data).mode, of(data).tolerance = mode, tolerance


def values(data):
    """What of the settings tells how a data-block is shown, by name."""
    settings = of(data)
    return {name: getattr(settings, name) for name in _SHOWING}


def take(data, values):
    """Have these values() without an evaluation."""
    settings = of(data)
    with quiet(data):
        for name, value in values.items():
            if getattr(settings, name) != value:
                setattr(settings, name, value)


def exchange_resolutions(data):
    """u and v of the patches were exchanged; nothing is evaluated."""
    settings = of(data)
    with quiet(data):
        settings.resolution_u, settings.resolution_v = settings.resolution_v, settings.resolution_u


def is_quiet(data):
    """Whether the settings of a data-block change without an evaluation now."""
    return key(data) in state.quiet


def _changed(self, context):
    if not is_quiet(self.id_data):
        self.changed(context)


def _counted(self, context):
    """A number that is given counts from then on."""
    if self.mode == AUTOMATIC and not is_quiet(self.id_data):
        with quiet(self.id_data):
            self.mode = COUNT
    _changed(self, context)


def mode_property(default=COUNT, **more):
    return EnumProperty(
        name="Faces", description="How many faces show the surface, or straight pieces the curve",
        items=((COUNT, "By Count", "A fixed number in every span"),
               (TOLERANCE, "By Tolerance", "As many as it takes to come this near to the surface or curve: few where it is flat"),
               (ANGLE, "By Angle", "As many as it takes to turn by no more than an angle on a face or piece"),
               (BOTH, "By Both", "As many as tolerance and angle take together"),
               (AUTOMATIC, "Automatic", "As many as a smooth look needs: by angle, and by a tolerance that suits the size")),
        default=default, **more)


def tolerance_property(**more):
    return FloatProperty(
        name="Tolerance", description="No point of the surface lies farther from the mesh, in units of the object",
        default=0.01, min=1e-9, soft_min=1e-5, soft_max=10.0, precision=4, step=0.1, unit='LENGTH', **more)


def angle_property(**more):
    return FloatProperty(
        name="Angle", description="Normals turn by no more on a face",
        default=math.radians(15.0), min=math.radians(0.25), soft_min=math.radians(1.0), max=math.pi, subtype='ANGLE',
        **more)


def _when_changed(self, context):
    if not is_quiet(self.id_data):
        self.when_changed(context)


class Settings:
    """Numbers of a PropertyGroup whose changed() is called when a user changes one, and when_changed() when it is update_mode."""

    mode: mode_property(update=_changed)
    tolerance: tolerance_property(update=_changed)
    angle: angle_property(update=_changed)
    resolution_u: IntProperty(
        name="Resolution U", description="Steps in every span along u",
        default=12, min=1, max=4096, soft_max=64, update=_counted)
    resolution_v: IntProperty(
        name="Resolution V", description="Steps in every span along v",
        default=12, min=1, max=4096, soft_max=64, update=_counted)
    sharp_angle: FloatProperty(
        name="Sharp Angle", description="Edges across which the exact normals differ by more are marked sharp",
        default=math.radians(1.0), min=0.0, max=math.pi, subtype='ANGLE', update=_changed)
    reach: FloatProperty(
        name="Display Length", description="How far beyond its points a curve that runs to infinity is shown",
        default=10.0, min=0.001, max=1e6, soft_max=1000.0, unit='LENGTH', update=_changed)
    update_mode: EnumProperty(
        name="Update", description="When the shape is updated while its inputs change; saved files and rendered frames are always exact",
        items=((ALWAYS, "Always", "At every mouse step that leaves time for it, otherwise as soon as the mouse rests"),
               (ON_RELEASE, "On Release", "When the mouse button is released"),
               (MANUAL, "Manual", "By Update Now, and before the file is saved or another frame is shown or rendered")),
        default=ALWAYS, options=set(), update=_when_changed)
    show_seams: BoolProperty(
        name="Color Seams by Continuity", description="Color the seams of the patches by continuity",
        default=False, options=set(), override=_OF_OVERRIDES)
    show_numbers: BoolProperty(
        name="Show Numbers", description="Show the numbers of the pieces in the 3D view, which operators ask for",
        default=False, options=set(), override=_OF_OVERRIDES)
    measure_u: FloatProperty(
        name="Parameter U", description="Where the shape is measured, as a part of the domain along u", default=0.5, min=0.0,
        max=1.0, subtype='FACTOR', precision=4, options=set(), override=_OF_OVERRIDES)
    measure_v: FloatProperty(
        name="Parameter V", description="Where the shape is measured, as a part of the domain along v", default=0.5, min=0.0,
        max=1.0, subtype='FACTOR', precision=4, options=set(), override=_OF_OVERRIDES)
    piece: IntProperty(
        name="Active Piece", description="The piece, counted from 1, with which operators begin that ask for one; "
        "0 for none", default=0, min=0, options=set())
    other_piece: IntProperty(
        name="Other Piece", description="The piece, counted from 1, with which operators begin that ask for a second one; "
        "0 for none", default=0, min=0, options=set())
    faces_before: IntProperty(
        name="Faces Before", description="How many there were before a setting was changed last",
        options={'HIDDEN', 'SKIP_SAVE'})
