"""Surfaces that curves span: lofts, sweeps, pipes, networks and fillings, live (lecture rows S20, S21)."""

import math

from ..base import decimals
from ..base.failures import AboutInputs, Refusal, about_input, about_items
from ..base.library import sc
from ..base.words import phrase
from ..surfaces import holes, lofts, neighbors, overlaps, rails, rims, sections
from ..verbs import verbs
from . import capping, wanted
from .recipe import Parameter, Recipe, Result, of_patches

_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the surface may lie from where it should be, in the scene", 1e-4, 1e-9,
                       unit='LENGTH', of_scene=True)
_PLACED = Parameter("placed", "Sections", "Where the sections are taken from", "upright", choices=(
    ("upright", "Set Upright", "From the plane of each section's own x and y, with its origin on the rail"),
    ("there", "Where They Lie", "From where each section lies at the rail, which it moves along as it is")))
_STYLES = (
    ("normal", "Normal", "Through the sections, paced by their distances"),
    ("tight", "Tight", "Through the sections, paced by the roots of their distances: it swings out less"),
    ("uniform", "Uniform", "Through the sections, paced evenly"),
    ("loose", "Loose", "Near the sections, as a curve is near its control points"),
    ("straight", "Straight", "By segments from section to section"))
_LEAVING = (
    ("free", "Free", "As the sections have it; from a surface at its side alone"),
    ("normal", "Normal", "At right angles to the plane of the section"),
    ("round", "Round", "In a point, with a tangent plane there"),
    ("G1", "Tangent", "With the tangent planes of the surface that comes before the first curve, or after the last one"),
    ("G2", "Curvature", "With the curvatures of that surface, too"))
_CAPS = (("none", "None", "Open ends"), ("flat", "Flat", "Discs"), ("round", "Round", "Half spheres"))
_CAPPED = (("both", "Both", "Both ends"), ("start", "Start", "Where it starts"), ("end", "End", "Where it ends"))
_FRAMES = (("minimal", "Minimal", "It turns about the rail no more than it must"),
           ("upright", "Upright", "Its y stays as near to Z as it can"),
           ("parallel", "Parallel", "It keeps its direction"))
_HEIGHTS = (("scaled", "Scaled", "Sections are as much higher as they are wider"), ("kept", "Kept", "Sections stay as high"))


def _one_curve(definition):
    """The NurbsCurve of an input, joined where it consists of several. Raises Refusal."""
    curves = verbs.curves_of(definition)
    if len(curves) == 1:
        return curves[0].to_nurbs()
    joined = sc.build.join_curves(curves, 1e-6 * sections.size_of(curves))
    if len(joined) > 1:
        raise Refusal("it consists of curves apart from each other: each section is one")
    return joined[0]


def _one_of(inputs, number):
    """_one_curve() of the input of a number, from 0. Raises AboutInputs."""
    with about_input(number):
        return _one_curve(inputs[number])


def _one_of_each(inputs):
    return [_one_of(inputs, number) for number in range(len(inputs))]


def _sections_of(inputs, turned):
    """The lofts.Sections of inputs. Raises AboutInputs."""
    found = []
    for number, (definition, is_turned) in enumerate(zip(inputs, turned)):
        with about_input(number):
            found.append(lofts.section(definition, number, _one_curve, is_turned))
    return found


def _within(approximation):
    return Result(approximation.value, approximation.error)


def _loft(inputs, style, closed, align, match_corners, simple, tolerance, start, start_strength, end, end_strength, caps, turned,
          cancel=None):
    ends = lofts.End(start, start_strength), lofts.End(end, end_strength)
    made, said = lofts.loft(_sections_of(inputs, turned), *ends, align, match_corners, style=style, closed=closed, tolerance=tolerance if simple else None, cancel=cancel)
    return capping.result([made.value], caps, made.error, said, cancel)


def _loft_order(inputs):
    return lofts.order(_sections_of(inputs, [False] * len(inputs)))


def _first_ends(inputs):
    """It continues surfaces that are selected, too."""
    order = _loft_order(inputs)
    return {name: 'G1' for name, at in (('start', 0), ('end', -1)) if getattr(inputs[order[at]], 'has_curves', True) is False}


def _sweep(inputs, placed, frame, end_scale, twist, own_radius, tolerance, caps, spaces, turned, factor=None, cancel=None):
    rail, *profiles = _one_of_each(inputs)
    if turned[0]:
        rail, factor = rail.reversed(), factor.reversed() if own_radius else None
    profiles = [curve.reversed() if is_turned else curve for curve, is_turned in zip(profiles, turned[1:])]
    if placed == 'upright':
        profiles, at = rails.upright(profiles, spaces[1:]), None
        order = range(len(profiles))
    else:
        profiles, at, order = rails.along(rail, profiles, frame)
    with about_items(sections=[1 + i for i in order]):
        made = sc.build.sweep(rail, profiles, at=at, frame=frame, end_scale=end_scale, twist=twist, scale=factor, tolerance=tolerance,
                              cancel=cancel)
    return capping.result([made.value], caps, made.error, cancel=cancel, warning=", ".join(overlaps.of_rail(made.value, rail)))


def _two_rails(inputs, height, tolerance, caps, turned, cancel=None):
    first, second, *profiles = (curve.reversed() if is_turned else curve
                                for curve, is_turned in zip(_one_of_each(inputs), turned))
    second = rails.running_with(first, second)
    profiles, at, order = rails.between(first, second, profiles)
    with about_items(sections=[2 + i for i in order]):
        made = sc.build.sweep_two_rails(first, second, profiles, at=at, height=height, tolerance=tolerance, cancel=cancel)
    return capping.result([made.value], caps, made.error, cancel=cancel)


def _pipe(inputs, radius, end_radius, own_radius, caps, capped, tolerance, factor=None, cancel=None):
    axis = _one_of(inputs, 0)
    start, end = axis.domain
    radii = radius if radius == end_radius else [(start, radius), (end, end_radius)]
    made = sc.build.pipe(axis, radii, caps=caps, tolerance=tolerance, scale=factor, cancel=cancel)
    left_out = {'both': (), 'start': (2,), 'end': (1,)}[capped]
    patches = [patch for i, patch in enumerate(made.value) if i not in left_out]
    return of_patches(patches, made.error, warning=", ".join(overlaps.of_rail(made.value[0], axis)))


def _first_radii(inputs):
    radius = float(f"{0.05 * sections.size_of(verbs.curves_of(inputs[0])):.1g}")
    return {'radius': radius, 'end_radius': radius}


def _network(inputs, tolerance, gap, cancel=None):
    numbers = [number for number, definition in enumerate(inputs) if definition.has_curves]
    curves = [_one_of(inputs, number) for number in numbers]
    others = [number for number in range(len(inputs)) if number not in numbers]
    sides = neighbors.beside([verbs.pieces_of(inputs[number]) for number in others], curves, gap or tolerance, others)
    beside = [side for side, _ in sides]
    families = sections.families(curves, gap or tolerance, numbers)
    along_u, along_v = ([curve for curve, _ in family] for family in families)
    of_u, of_v = ([number for _, number in family] for family in families)
    with about_items(along_u=of_u, along_v=of_v, neighbors=[number for _, number in sides]):
        found = sc.build.network(along_u, along_v, neighbors=beside, tolerance=tolerance, gap=gap or None, cancel=cancel)
    if not beside:
        return _within(found)
    angle = neighbors.angle_to(found.value, beside, gap or tolerance)
    return Result(found.value, found.error, phrase("angle {angle}° to surfaces beside it", angle=_degrees(angle)))


def _filling(inputs, continuity, other, tolerance, cancel=None):
    shapes = [[_one_of(inputs, i)] if definition.has_curves else verbs.pieces_of(definition) for i, definition in enumerate(inputs)]
    curves = [pieces[0] for pieces, definition in zip(shapes, inputs) if definition.has_curves]
    normal = rims.normal_of(curves) if len(curves) == len(shapes) else None
    if normal is None:
        return _of_sides(_sides_around(shapes, continuity, other, tolerance), tolerance, cancel)
    # What few sides give is kept where it is as it should be.
    refused = None
    try:
        found = _of_sides(_sides_around(shapes, continuity, other, tolerance), tolerance, cancel)
        patches = [found.value] if hasattr(found.value, 'domain') else [found.value[i] for i in range(len(found.value))]
        if rims.is_good(patches, found.error, curves, normal):
            return found
    except (Refusal, sc.InvalidShape, sc.ToleranceNotReached) as error:
        refused = error
    try:
        with about_items(side=range(len(curves))):
            patches = list(rims.filled(curves, cancel).value)
    except (AboutInputs, sc.InvalidShape) as error:
        if refused and not (len(curves) > 1 and all(map(sections.is_closed, curves))):
            raise refused
        _require_apart(curves, cancel)
        if isinstance(error, AboutInputs):
            raise
        raise Refusal("{error}: nothing within it would be plane without a fold", error=error) from error
    return of_patches(patches, 0.0, "plane")


def _require_apart(curves, cancel):
    """Raises AboutInputs for a curve that crosses itself, or another one."""
    for i, curve in enumerate(curves):
        if not curve.self_intersections(cancel=cancel).touches.all():
            raise AboutInputs("{} crosses itself: nothing within it would be plane without a fold", i)
        for k, other in enumerate(curves[:i]):
            if len(curve.intersections(other, cancel=cancel).distances):
                raise AboutInputs("{} and {} cross or touch: what lies between them cannot be filled", k, i)


def _sides_around(shapes, continuity, other, tolerance):
    is_one = len(shapes) == 1 and len(shapes[0]) == 1
    return (holes.of_one(shapes[0], continuity, other) if is_one
            else holes.around(holes.sides_of(shapes, continuity), len(shapes), tolerance))


def _of_sides(sides, tolerance, cancel):
    with about_items(sides=[side.owner for side in sides]):
        found = sc.build.fill([side.asked for side in sides], tolerance=tolerance, cancel=cancel)
    patches = list(found.patches)
    said = ", ".join([phrase("{count} sides", one="{count} side",
                             count=len(sides)), *_gone_on(found, {side.asked[2] for side in sides if side.asked is not side.curve})])
    return of_patches(patches, found.gap, said)


def _degrees(angle):
    return decimals.text_of(math.degrees(angle), 2) if angle > 1e-9 else "0"


def _gone_on(filling, continuities):
    """How it continues sides of surfaces with these continuities, and its patches from each other, in words."""
    if {'G1', 'G2'} & continuities:
        yield phrase("angle {angle}° to them", angle=_degrees(filling.angle))
    if len(filling.patches) > 1:
        yield phrase("{inner_angle}° inside", inner_angle=_degrees(filling.inner_angle))
    if 'G2' in continuities:
        bend = filling.curvature_difference
        yield phrase("curvatures differ by {bend}", bend=decimals.text_of(bend, 2) if bend > 1e-9 else "0")


def _along_the_rail(inputs):
    rail, *profiles = _one_of_each(inputs)
    return [0, *(1 + i for i in rails.order_along(rail, profiles))]


def _rails_first(inputs):
    return rails.rails_first(_one_of_each(inputs))


def _ends_of_loft():
    """Parameters: how it starts and how it ends."""
    for name, label, what in (("start", "Start", "begins"), ("end", "End", "ends")):
        yield Parameter(name, label, f"How it {what}", "free", choices=_LEAVING)
        yield Parameter(f"{name}_strength", f"{label} Strength", f"How far it follows that where it {what}", 1.0, 1e-3, 100.0)


FROM_CURVES = (
    Recipe("loft", "Loft",
           "A live surface through sections in any order; it can continue surfaces at both ends and close in points",
           (Parameter("style", "Style", "How it runs from section to section", "normal", choices=_STYLES),
            Parameter("closed", "Closed", "Continue from the last section to the first", False),
            Parameter("align", "Align", "Find out how each section runs, and where a closed one begins", True),
            Parameter("match_corners", "Match Corners", "Where all sections have as many corners, let an edge run from each corner to "
                      "that of the next section", True, before=False),
            Parameter("simple", "Reduce Control Points", "Let sections give way within the tolerance, for as few points as that allows", False),
            _TOLERANCE, *_ends_of_loft(), capping.PARAMETER),
           _loft, is_surface=True, resolution=8, inputs=(wanted.ONE_CURVE, wanted.MORE_SECTIONS), has_more=True,
           takes_points=True, has_turns=True, is_measured=True, takes_cancel=True, arranged=_loft_order, first_values=_first_ends),
    Recipe("sweep", "Sweep", "The surface of sections that move along a rail, the active curve; it follows them",
           (_PLACED, Parameter("frame", "Frame", "How it turns with the rail", "minimal", choices=_FRAMES),
            Parameter("end_scale", "End Scale", "Size at the end of the rail by that at its start", 1.0, 1e-3, 1e3),
            Parameter("twist", "Twist", "Rotation around the rail from its start to its end", 0.0, -200 * math.pi, 200 * math.pi,
                      unit='ROTATION'),
            Parameter("own_radius", "Radius of Curve", "Sections are as much larger as the radius of the rail's points says, which "
                      "Alt+S changes", False), _TOLERANCE, capping.PARAMETER),
           _sweep, is_surface=True, resolution=8, inputs=(wanted.ONE_CURVE, wanted.MORE_CURVES), has_more=True, has_turns=True,
           takes_spaces=True, is_measured=True, takes_cancel=True, arranged=_along_the_rail, fixed=1,
           radius_asked="own_radius"),
    Recipe("two_rails", "Sweep on Two Rails",
           "The surface of sections that run from one rail, the active curve, to a second one; it follows them",
           (Parameter("height", "Height", "Of sections where the rails come nearer or part", "scaled", choices=_HEIGHTS),
            _TOLERANCE, capping.PARAMETER), _two_rails, is_surface=True, resolution=8, inputs=(wanted.ONE_CURVE, wanted.ANOTHER_CURVE, wanted.MORE_CURVES),
           has_more=True, has_turns=True, is_measured=True, takes_cancel=True, arranged=_rails_first, fixed=2),
    Recipe("pipe", "Pipe", "A pipe about a curve, which it follows",
           (Parameter("radius", "Radius", "At the start of the curve", 0.1, 1e-6, unit='LENGTH'),
            Parameter("end_radius", "End Radius", "At its end", 0.1, 1e-6, unit='LENGTH', follows="radius"),
            Parameter("own_radius", "Radius of Curve", "Times the radius of the curve's points, which Alt+S changes", False),
            Parameter("caps", "Caps", "What closes its ends", "none", choices=_CAPS),
            Parameter("capped", "Capped", "Which ends caps close", "both", choices=_CAPPED), _TOLERANCE),
           _pipe, is_surface=True, resolution=8, inputs=(wanted.ONE_CURVE,), is_measured=True, takes_cancel=True,
           first_values=_first_radii, radius_asked="own_radius"),
)
FROM_BOTH = (
    Recipe("network", "Network Surface",
           "A live surface through two families of crossing curves; it can start tangent to surfaces at its borders",
           (_TOLERANCE, Parameter("gap", "Gap", "How far curves may pass one another, in the scene; 0: as far as the tolerance", 0.0,
                                  0.0, unit='LENGTH')),
           _network, is_surface=True, resolution=8, inputs=(wanted.ONE_CURVE, wanted.ANOTHER_CURVE, wanted.MORE), has_more=True,
           is_measured=True, takes_cancel=True),
    Recipe("filling", "Fill",
           "A live surface in a hole: within a closed curve, a tube's end, or three to eight curves and surfaces",
           (Parameter("continuity", "Continuity", "What it shares with surfaces along their sides", "G1", choices=(
               ("G0", "G0", "The points"), ("G1", "G1", "The tangent planes, too"), ("G2", "G2", "The curvatures, too"))),
            Parameter("other", "Other End", "Of a tube that is open at both ends, the other one", False),
            _TOLERANCE), _filling, is_surface=True, resolution=8, inputs=(wanted.CURVE_OR_SURFACE,),
           has_more=True, is_measured=True, takes_cancel=True),
)
RECIPES = (*FROM_CURVES, *FROM_BOTH)
