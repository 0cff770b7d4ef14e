"""Surfaces: exact primitives, from formulas (lecture rows S1, S20), and what curves make by moving, live."""

import math

import numpy as np

from ..base.failures import AboutInputs, Refusal, about_input
from ..base.library import sc
from ..base.words import phrase
from ..deform import deforming
from ..deform.deformable import revolved
from ..shape import definition as definitions
from ..surfaces import overlaps
from . import capping, wanted
from .conic_recipes import DEVIATION
from .curve_recipes import constants_of, formula_of
from .recipe import Parameter, Recipe, Result, of_patches, share_of_size

_RADIUS = Parameter("radius", "Radius", "Distance from the axis or the middle", 1.0, 1e-6, unit='LENGTH')
_HEIGHT = Parameter("height", "Height", "Along the axis", 2.0, 1e-6, unit='LENGTH')
_START = Parameter("start", "Start", "Angle where it begins", 0.0, unit='ROTATION')
_SWEEP = Parameter("sweep", "Sweep", "Angle about the axis; 360° closes it", 2 * math.pi, -2 * math.pi, 2 * math.pi,
                   unit='ROTATION')
_DEFORMABLE = Parameter("deformable", "Deformable", "No exact one: cubic, without weights and smooth everywhere, to be sculpted; within "
                        "the tolerance", False)
_CAPS = Parameter("caps", "Caps", "Close it by discs", True)
_AXES = {'x': np.array([1.0, 0.0, 0.0]), 'y': np.array([0.0, 1.0, 0.0]), 'z': np.array([0.0, 0.0, 1.0])}
AXIS = Parameter("axis", "Axis", "Axis of the axis object, or of this object through the origin and the offset", "z", choices=tuple(
    (name, name.upper(), phrase("The {name} axis of the axis object, or of this object if there is none",
                                name=name)) for name in _AXES))
_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the surface may lie from the formulas", 1e-4, 1e-9,
                       unit='LENGTH', of_scene=True)
#: A profile whose points lie nearer to a plane than this part of its width lies in it.
_FLAT = 1e-6
_ORIGIN = (0.0, 0.0, 0.0)
_UP = (0.0, 0.0, 1.0)


def _turn(sweep):
    """None for a whole one."""
    return None if sweep == 2 * math.pi else sweep


def _plane(points, width, depth):
    return Result(sc.build.plane((-width / 2, -depth / 2, 0.0), (width, 0.0, 0.0), (0.0, depth, 0.0)))


def _round(patches, deformable, tolerance):
    """The Result of exact patches, or of deformable ones."""
    return of_patches(*deforming.patches(patches, tolerance)) if deformable else of_patches(patches)


def _cylinder(points, radius, height, start, sweep, caps, deformable, tolerance):
    return _cone(points, radius, radius, height, start, sweep, caps, deformable, tolerance)


def _cone(points, radius, top_radius, height, start, sweep, caps, deformable, tolerance):
    around = start, _turn(sweep)
    low, high = (0.0, 0.0, -height / 2), (0.0, 0.0, height / 2)
    if radius == top_radius:
        patches = [sc.build.cylinder(low, _UP, radius, height, *around)]
    else:
        patches = [sc.build.cone(low, _UP, radius, height, top_radius, *around)]
    if caps:
        # The lower cap runs from its middle out, so that its normal points down.
        patches += [sc.build.disc(low, _UP, radius, *around).reversed('v')] if radius else []
        patches += [sc.build.disc(high, _UP, top_radius, *around)] if top_radius else []
    return _round(patches, deformable, tolerance)


def _sphere(points, radius, start, sweep, deformable, tolerance):
    return _round([sc.build.sphere(_ORIGIN, radius, _UP, start, _turn(sweep))], deformable, tolerance)


def _torus(points, radius, tube_radius, start, sweep, deformable, tolerance):
    return _round([sc.build.torus(_ORIGIN, _UP, radius, tube_radius, start, _turn(sweep))], deformable, tolerance)


def _formula(points, x, y, z, start_u, end_u, start_v, end_v, constants, tolerance):
    if not (start_u < end_u and start_v < end_v):
        raise Refusal("the last u or v is not above the first")
    known = constants_of(constants)
    formulas = [formula_of(name, text, ("u", "v"), known) for name, text in (("x", x), ("y", y), ("z", z))]
    return Result(*sc.build.patch_from_formulas(formulas, (start_u, end_u), (start_v, end_v), tolerance=tolerance))


def _curves(inputs, number=0):
    definition = inputs[number]
    with about_input(number):
        if not definition.has_curves:
            raise Refusal("it is made of patches: a curve is needed")
    value = definitions.to_value(definition)
    return value if isinstance(value, list) else [value]


def _revolve(inputs, axis, start, sweep, offset_x, offset_y, offset_z, deformable, tolerance, caps, frame=None):
    through, direction = axis_of(axis, (offset_x, offset_y, offset_z), frame)
    curves = _curves(inputs)
    warning = ", ".join(overlaps.of_turned(curves, through, direction, sweep))
    if not deformable:
        return capping.result([sc.build.revolve(curve, through, direction, start, _turn(sweep)) for curve in curves], caps, warning=warning)
    made = [revolved(curve, through, direction, start, _turn(sweep), tolerance) for curve in curves]
    return capping.result([patch for patch, _ in made], caps, max(error for _, error in made), warning=warning)


def axis_of(axis, offset, frame=None):
    """(a point of an axis, its direction) in the space of the shape. frame: (4, 4) of the axis object there, or None."""
    frame = np.eye(4) if frame is None else frame
    direction = frame[:3, :3] @ _AXES[axis]
    if not np.abs(direction).max() > 0.0:
        raise Refusal("the axis object has a scale of 0: it shows no direction")
    return frame[:3, :3] @ np.array(offset) + frame[:3, 3], direction


def _suggested_axis(inputs):
    """A profile in the plane of x and y is turned about y, any other one about z."""
    definition, = inputs
    places = definition.pool[definition.pool[:, 3] != 0.0, :3]
    width, height = np.ptp(places[:, :2], axis=0).max(), np.abs(places[:, 2]).max()
    return {'axis': 'y' if height <= _FLAT * width else 'z', 'tolerance': share_of_size(definition, 1e-3) or DEVIATION.default}


def _extrude(inputs, x, y, z, caps):
    curves = _curves(inputs)
    warning = ", ".join(overlaps.of_profile(curves, (x, y, z)))
    return capping.result([sc.build.extrude(curve, (x, y, z)) for curve in curves], caps, warning=warning)


def _ruled(inputs, turned):
    first, second = (_curves(inputs, number) for number in range(2))
    if len(first) != len(second):
        raise AboutInputs("{} has {first} pieces, {} has {second}: each is ruled to one", 0, 1, first=len(first), second=len(second))
    return of_patches([sc.build.ruled(a, b.reversed() if turned else b) for a, b in zip(first, second)])


PRIMITIVES = (
    Recipe("plane", "Plane", "An exact flat patch",
           (Parameter("width", "Width", "Along x", 2.0, 1e-6, unit='LENGTH'),
            Parameter("depth", "Depth", "Along y", 2.0, 1e-6, unit='LENGTH')), _plane, is_surface=True, resolution=1),
    Recipe("cylinder", "Cylinder", "An exact cylinder, open or with caps, or a deformable one",
           (_RADIUS, _HEIGHT, _START, _SWEEP, _CAPS, _DEFORMABLE, DEVIATION), _cylinder, is_surface=True, resolution=12),
    Recipe("cone", "Cone", "An exact cone, with a tip or truncated, or a deformable one",
           (_RADIUS, Parameter("top_radius", "Top Radius", "0 for a tip", 0.0, 0.0, unit='LENGTH'), _HEIGHT, _START,
            _SWEEP, _CAPS, _DEFORMABLE, DEVIATION), _cone, is_surface=True, resolution=12),
    Recipe("sphere", "Sphere", "An exact sphere, or a deformable one", (_RADIUS, _START, _SWEEP, _DEFORMABLE, DEVIATION), _sphere,
           is_surface=True, resolution=12),
    Recipe("torus", "Torus", "An exact torus, or a deformable one",
           (_RADIUS, Parameter("tube_radius", "Tube Radius", "Of the tube", 0.25, 1e-6, unit='LENGTH'), _START,
            _SWEEP, _DEFORMABLE, DEVIATION), _torus, is_surface=True, resolution=12),
    Recipe("surface_formula", "Surface from Formula",
           "A surface from formulas in u and v: exact for polynomials, otherwise within a tolerance",
           (Parameter("x", "x(u, v)", "Numbers, u, v, pi, e, + - * / ^ and functions such as sin, exp, sqrt", "u"),
            Parameter("y", "y(u, v)", "As x", "v"), Parameter("z", "z(u, v)", "As x", "0.3*sin(pi*u)*cos(pi*v)"),
            Parameter("start_u", "First u", "Where u begins", -1.0), Parameter("end_u", "Last u", "Where u ends", 1.0),
            Parameter("start_v", "First v", "Where v begins", -1.0), Parameter("end_v", "Last v", "Where v ends", 1.0),
            Parameter("constants", "Constants", "Numbers that you name: a = 2, b = pi/3", ""), _TOLERANCE),
           _formula, is_surface=True, resolution=4),
)

FROM_CURVES = (
    Recipe("revolve", "Revolve", "The surface of a curve that turns about an axis; it follows when the curve is edited",
           (AXIS, _START, _SWEEP, *(
               Parameter(f"offset_{name}", f"Offset {name.upper()}", f"The axis lies so far along {name} from the origin", 0.0,
                         unit='LENGTH') for name in _AXES),
             Parameter("deformable", "Deformable", "Cubic around, without weights there and smooth everywhere, to be sculpted: it lies "
                       "within the tolerance of the exact surface", False), DEVIATION, capping.PARAMETER),
           _revolve, is_surface=True, resolution=12, inputs=(wanted.ONE_CURVE,),
           frame="About", first_values=_suggested_axis),
    Recipe("extrude", "Extrude",
           "The surface of a curve that moves along a vector; it follows when the curve is edited",
           (*(Parameter(name, name.upper(), f"Along {name} of the object", default, unit='LENGTH')
              for name, default in (("x", 0.0), ("y", 0.0), ("z", 1.0))), capping.PARAMETER),
           _extrude, is_surface=True, resolution=12, inputs=(wanted.ONE_CURVE,)),
    Recipe("ruled", "Ruled Surface", "The segments between two curves; it follows when they are edited",
           (Parameter("turned", "Turn One", "Let the second curve run the other way", False),), _ruled, is_surface=True,
           resolution=12, inputs=(wanted.ONE_CURVE, wanted.ANOTHER_CURVE)),
)
