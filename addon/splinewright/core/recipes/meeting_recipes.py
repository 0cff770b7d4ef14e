"""Curves beside curves and where surfaces meet, live (lecture row S18)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..base.numbers_in_words import numbers_of
from ..drawing import contours
from ..joints import joints
from ..meets import meets, plane_fit
from ..verbs import verbs
from . import wanted
from .recipe import Parameter, Recipe, Result, share_of_size
from .surface_recipes import AXIS, axis_of

_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the curve may lie from where it should be, in the scene", 1e-4, 1e-9,
                       unit='LENGTH', of_scene=True)
_OWN_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the curve may lie from where it should be", 1e-4, 1e-9,
                           unit='LENGTH', of_scene=True)
_PIECE = Parameter("piece", "Piece", "Which curve of the object, counted from 1", 1, 1)
_ENDS = (("nearest", "Nearest", "The end that is nearest to the other curve"), ("start", "Start", "Where the curve starts"),
         ("end", "End", "Where the curve ends"))


def _as_result(curves, error=0.0):
    return Result(curves[0] if len(curves) == 1 else curves, error)


def _first_distance(inputs):
    return {'distance': share_of_size(inputs[0], 0.1)}


def _offset(inputs, distance, corner, trimmed, tolerance, cancel=None):
    curves = verbs.curves_of(inputs[0])
    normal = plane_fit.normal_of(curves)
    made = [part for curve in curves
            for part in curve.offset(distance, normal, corner=corner, trimmed=trimmed, tolerance=tolerance, cancel=cancel)]
    return _as_result(made, tolerance)


def _section(inputs, tolerance, cancel=None):
    first, second = (patches_of(definition) for definition in inputs)
    found = [one.sections(other, tolerance=tolerance, cancel=cancel) for one in first for other in second]
    return _as_result(_joined_sections(found, tolerance), tolerance)


def _planes(inputs, axis, offset, count, spacing, tolerance, frame=None, cancel=None):
    through, direction = axis_of(axis, (0.0, 0.0, 0.0), frame)
    direction = direction / np.linalg.norm(direction)
    patches, made = patches_of(inputs[0]), []
    for i in range(count):
        origin = through + (offset + i * spacing) * direction
        found = [patch.plane_sections(origin, direction, tolerance=tolerance, cancel=cancel) for patch in patches]
        made += _joined_sections(found, tolerance, is_needed=False)
    if not made:
        raise Refusal("the surface meets none of the planes")
    return _as_result(made, tolerance)


def _first_planes(inputs):
    """One through the middle of the surface."""
    low, high = np.array([patch.bounding_box() for patch in patches_of(inputs[0])]).transpose(1, 0, 2)
    middle = 0.5 * (low.min(axis=0) + high.max(axis=0))
    return {'axis': 'z', 'offset': float(middle[2]), 'spacing': share_of_size(inputs[0], 0.1)}


def patches_of(definition):
    if definition.has_curves:
        raise Refusal("it is made of curves: a surface is needed")
    return verbs.pieces_of(definition)


def _joined_sections(found, tolerance, is_needed=True):
    """The curves of Sections, on over the seams of patches. Raises Refusal where there are none that are needed."""
    curves = [curve for sections in found for curve in sections.curves]
    if not curves and is_needed:
        if any(sections.are_one for sections in found):
            raise Refusal("the surfaces are one, and no border of either lies inside the other")
        touches = sum(len(sections.points) for sections in found)
        raise Refusal("the surfaces touch in points alone: Mark Intersections shows them" if touches
                      else "the surfaces do not meet")
    if len(found) == 1 or not curves:
        return curves
    return sc.build.join_curves(meets.each_once(curves, meets.TOGETHER * tolerance), meets.TOGETHER * tolerance)


def _blend(inputs, continuity, first_end, second_end, first_strength, second_strength):
    first, second = map(verbs.curves_of, inputs)
    a, end_a, b, end_b = _ends_to_blend(first, first_end, second, second_end)
    return Result(sc.build.blend(a, b, int(continuity[1]), end_a=end_a, end_b=end_b,
                                 strengths=(first_strength, second_strength)))


def _ends_to_blend(first, first_end, second, second_end):
    """(curve, 'start' or 'end') of each: those that are nearest to each other of the ends that are meant."""
    pairs = []
    for a in first:
        for b in second:
            ends_a, ends_b = joints.ends_of(a), joints.ends_of(b)
            pairs += [(np.linalg.norm(ends_a[i] - ends_b[j]), a, end_a, b, end_b)
                      for i, end_a in enumerate(('start', 'end')) if first_end in ('nearest', end_a)
                      for j, end_b in enumerate(('start', 'end')) if second_end in ('nearest', end_b)]
    pairs = [pair for pair in pairs if np.isfinite(pair[0])]
    if not pairs:
        raise Refusal("a curve is closed, or its ends lie at infinity: it has no end to continue")
    return min(pairs, key=lambda pair: pair[0])[1:]


def _first_radii(inputs):
    radius = share_of_size(inputs[0], 0.05)
    return {'radius': radius, 'end_radius': radius}


def _about(inputs, radius, end_radius, turns, phase, piece, tolerance, cancel=None):
    curves = verbs.curves_of(inputs[0])
    verbs.require_piece(curves, piece)
    return Result(sc.build.helix(curves[piece - 1], radius, turns, end_radius=end_radius, phase=phase, tolerance=tolerance,
                                 cancel=cancel), tolerance)


def _on_patch(inputs, distance, unit, piece, tolerance, cancel=None):
    patches, images = patches_of(inputs[0]), verbs.curves_of(inputs[1])
    verbs.require_piece(patches, piece)
    patch = patches[piece - 1]
    if unit:
        domain = np.array(patch.domain)
        to_domain = np.diag([*(domain[:, 1] - domain[:, 0]), 1.0, 1.0])
        to_domain[:2, 3] = domain[:, 0]
        images = [image.to_nurbs().transformed(to_domain) for image in images]
    return _as_result([sc.build.curve_on_patch(patch, image, distance, tolerance=tolerance, cancel=cancel) for image in images],
                      tolerance)


def _contour(points, corners, corner_size, closed, arcs):
    if len(points) < 2:
        raise Refusal("a contour needs two points")
    if closed and len(points) < 3:
        raise Refusal("a closed contour needs 3 points or more")
    whole = _sides(points, closed, arcs)
    if corners == 'sharp':
        return Result(whole)
    return Result(whole.rounded(corner_size, shrink=True) if corners == 'round' else whole.chamfered(corner_size, shrink=True))


def _sides(points, closed, arcs):
    if not arcs.strip():
        return sc.build.contour(points, closed=closed)
    return contours.curve_of(contours.through(points, numbers_of(arcs, "a side"), closed))


STARTING = (
    Recipe("contour", "Contour", "Segments through points, with corners that are sharp, round or cut off",
           (Parameter("corners", "Corners", "How corners are made", "round", choices=(
               ("sharp", "Sharp", "Nothing"), ("round", "Round", "Arcs of circles"), ("cut", "Cut Off", "Segments"))),
            Parameter("corner_size", "Corner Size", "Radius of the arcs, or how far from the corner it is cut", 0.2, 1e-6, unit='LENGTH',
                      where=("corners", ("round", "cut"))),
            Parameter("closed", "Closed", "Go back to the first point", False),
            Parameter("arcs", "Arcs", "Numbers of sides that are arcs tangent to the side before, such as 2, 4-6", "")),
           _contour, ((-1, -0.7, 0), (1, -0.7, 0), (1, 0.3, 0), (0, 1, 0), (-1, 0.3, 0)), True, 12),
)
BESIDE_CURVES = (
    Recipe("offset", "Offset", "The curve at a distance from a plane curve; it follows when that is edited",
           (Parameter("distance", "Distance", "To the left of the curve, seen from above; below 0 to its right", 0.2,
                      unit='LENGTH'),
            Parameter("corner", "Corners", "What fills the gap at an outer corner", "round", choices=(
                ("round", "Round", "An arc about the corner"),
                ("sharp", "Sharp", "The corner of both sides, up to four times the distance away"))),
            Parameter("trimmed", "Trimmed", "Remove parts nearer to the curve than the distance: cusps and loops", True),
            _TOLERANCE), _offset, resolution=24, inputs=(wanted.ONE_CURVE,), is_measured=True, takes_cancel=True,
           first_values=_first_distance),
    Recipe("about", "Helix Around Curve",
           "A helix, or where the radii differ a spiral, about a curve; it follows when that is edited",
           (Parameter("radius", "Radius", "At the start of the curve", 0.2, 0.0, unit='LENGTH'),
            Parameter("end_radius", "End Radius", "At its end", 0.2, 0.0, unit='LENGTH', follows="radius"),
            Parameter("turns", "Turns", "How often around; below 0 the other way", 8.0, -1000.0, 1000.0),
            Parameter("phase", "Phase", "Angle at which it starts", 0.0, unit='ROTATION'), _PIECE, _OWN_TOLERANCE),
           _about, resolution=8, inputs=(wanted.ONE_CURVE,), takes_cancel=True, first_values=_first_radii),
    Recipe("blend", "Blend", "A live curve between ends of two curves that continues both smoothly",
           (Parameter("continuity", "Continuity", "What it shares with the curves at their ends", "G2", choices=(
               ("G0", "G0", "The point: a segment"), ("G1", "G1", "The direction, too"), ("G2", "G2", "The curvature, too"),
               ("G3", "G3", "How that changes, too"))),
            Parameter("first_end", "First End", "Where the first curve is left", "nearest", choices=_ENDS),
            Parameter("second_end", "Second End", "Where the second curve is met", "nearest", choices=_ENDS),
            Parameter("first_strength", "First Strength", "How far it follows the first curve", 1.0, 1e-3, 100.0),
            Parameter("second_strength", "Second Strength", "How far it follows the second curve", 1.0, 1e-3, 100.0)),
           _blend, resolution=24, inputs=(wanted.ONE_CURVE, wanted.ANOTHER_CURVE)),
)
WHERE_SURFACES_MEET = (
    Recipe("section", "Section", "The curves that two surfaces have in common; they follow both",
           (_TOLERANCE,), _section, resolution=12, inputs=(wanted.ONE_SURFACE, wanted.ANOTHER_SURFACE), is_measured=True,
           takes_cancel=True),
    Recipe("planes", "Section by Planes", "The curves in which planes cut a surface; they follow it",
           (AXIS, Parameter("offset", "Offset", "From the origin along the axis to the first plane", 0.0, unit='LENGTH'),
            Parameter("count", "Planes", "How many, side by side", 1, 1, 1000),
            Parameter("spacing", "Spacing", "From one plane to the next", 0.25, unit='LENGTH'), _OWN_TOLERANCE),
           _planes, resolution=12, inputs=(wanted.ONE_SURFACE,), frame="Along", takes_cancel=True,
           first_values=_first_planes),
    Recipe("on_patch", "Curve on Patch",
           "A live curve on a patch, whose u and v are x and y of a plane curve",
           (Parameter("distance", "Distance", "From the patch along its normals", 0.0, unit='LENGTH'),
            Parameter("unit", "Unit Square", "Map 0 to 1 of the plane to the whole domain; otherwise x and y are u and v", True),
            Parameter("piece", "Piece", "Which patch of the surface, counted from 1", 1, 1), _OWN_TOLERANCE),
           _on_patch, resolution=12, inputs=(wanted.ONE_SURFACE, wanted.ONE_CURVE), own_spaces=(1,), takes_cancel=True),
)
RECIPES = (*STARTING, *BESIDE_CURVES, *WHERE_SURFACES_MEET)
