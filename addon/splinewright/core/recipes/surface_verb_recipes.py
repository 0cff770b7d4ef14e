"""Surfaces that are made of other surfaces: beside them, between them, rounded and made longer, live (lecture rows S20, S21)."""

import math

from ..base import decimals
from ..base.failures import Refusal, about_input
from ..base.library import sc
from ..base.words import phrase
from ..joints import patch_joints
from ..rounding import edges as rounding
from ..rounding import crossing
from ..surfaces import matching, overlaps
from ..verbs import verbs
from ..verbs.patch_curves import SIDE_CHOICES
from . import wanted
from .meeting_recipes import patches_of
from .recipe import Parameter, Recipe, Result, of_patches, share_of_size

_TOLERANCE = Parameter("tolerance", "Tolerance", "How far the surface may lie from where it should be, in the scene", 1e-4, 1e-9,
                       unit='LENGTH', of_scene=True)
_PIECE = Parameter("piece", "Piece", "Which patch of the surface, counted from 1", 1, 1)
_CONTINUITIES = (("G0", "G0", "The points"), ("G1", "G1", "The tangent planes, too"), ("G2", "G2", "The curvatures, too"),
                 ("G3", "G3", "How these change, too"))
_SIDES = (("nearest", "Nearest", "The side that lies nearest to the other surface"), *SIDE_CHOICES)


def _side(name, label, whose):
    return Parameter(name, label, f"Which side of the {whose} surface", "nearest", choices=_SIDES)


def _continuity(text):
    return Parameter("continuity", "Continuity", text, "G2", choices=_CONTINUITIES)


def _sides(inputs, first_side, second_side):
    """(patch, side, patch, side): of two surfaces."""
    both = []
    for number, definition in enumerate(inputs):
        with about_input(number):
            both.append(patches_of(definition))
    first, second = both
    choices = [patch_joints.Choice(0, None if side == 'nearest' else side) for side in (first_side, second_side)]
    (a, side_a), (b, side_b) = patch_joints.nearest_sides(first, second, *choices)
    return first[a], side_a, second[b], side_b


def _measured(first, first_side, second, second_side):
    """What two patches achieve along an edge, in words."""
    found = sc.seam_continuity(first, first_side, second, second_side)
    short = map(_short, (found.gap, math.degrees(found.angle), found.curvature_difference))
    return "gap {}, angle {}°, curvatures differ by {}".format(*short)


def _short(number):
    """Rounding is nothing to tell."""
    return decimals.text_of(number, 2) if number > 1e-9 else "0"


def _blend(inputs, continuity, first_side, second_side, first_strength, second_strength):
    a, side_a, b, side_b = _sides(inputs, first_side, second_side)
    asked = a, side_a, b, side_b, continuity, (first_strength, second_strength)
    calmed = ""
    try:
        made = sc.build.blend_patches(*asked, calm=False)
    except sc.InvalidShape:
        made = sc.build.blend_patches(*asked)
        calmed = "; it follows them with less strength: with more it would shoot out"
    said = " and ".join(_measured(*edge) for edge in ((a, side_a, made, 'v_start'), (b, side_b, made, 'v_end')))
    return Result(made, 0.0, said + calmed)


def _matched(inputs, continuity, first_side, second_side, rows, strength, both, cancel=None):
    a, side_a, b, side_b = _sides(inputs, first_side, second_side)
    if both:
        found = matching.half_way(a, side_a, b, side_b, continuity, rows or None, strength, cancel)
        moved = " and ".join(decimals.text_of(one, 2) for one in found.moved)
        said = phrase("{measured}; points moved by up to {moved}",
                      measured=_measured(found.first, side_a, found.second, side_b), moved=moved)
        return of_patches([found.first, found.second], 0.0, said)
    found = sc.build.match_patch(a, side_a, b, side_b, continuity, rows=rows or None, strength=strength, cancel=cancel)
    moved = phrase("points moved by up to {error}", error=decimals.text_of(found.error, 2))
    return Result(found.value, 0.0, f"{_measured(found.value, side_a, b, side_b)}; {moved}")


def _rounded(inputs, radius, end_radius, first_side, second_side, edges, tolerance, cancel=None):
    shapes = list(map(patches_of, inputs))
    if len(shapes) == 2 and not edges.strip() and len(shapes[0]) == len(shapes[1]) == 1:
        try:
            return _rounded_sides(inputs, radius, end_radius, first_side, second_side, tolerance, cancel)
        except (Refusal, sc.InvalidShape, sc.ToleranceNotReached):
            if not rounding.meet(shapes):
                if not _are_apart(inputs, first_side, second_side):
                    raise
                return _rounded_crossing(shapes, radius, end_radius, first_side, second_side, tolerance, cancel)
            if radius != end_radius or (first_side, second_side) != ('nearest', 'nearest'):
                raise
    if (first_side, second_side) != ('nearest', 'nearest'):
        raise Refusal("First Side and Second Side are for two surfaces of one patch each: here Edges says which are rounded")
    if radius != end_radius:
        raise Refusal("a radius that changes is for the edge of two surfaces of one patch each: here Radius and End Radius are one")
    found = rounding.rounded(shapes, edges, radius, tolerance, cancel)
    return of_patches(found.patches, found.error, "1 edge rounded" if found.count == 1 else phrase("{count} edges rounded",
                                                                                                   count=found.count))


def _radii(patch, side, radius, end_radius):
    start, end = patch.domain[1 if side.startswith('u') else 0]
    return radius if radius == end_radius else [(start, radius), (end, end_radius)]


def _rounded_sides(inputs, radius, end_radius, first_side, second_side, tolerance, cancel):
    a, side_a, b, side_b = _sides(inputs, first_side, second_side)
    radii = _radii(a, side_a, radius, end_radius)
    found = sc.build.fillet_patches(a, side_a, b, side_b, radii, tolerance=tolerance, cancel=cancel)
    return of_patches([found.first, found.fillet, found.second], found.error)


def _rounded_crossing(shapes, radius, end_radius, first_side, second_side, tolerance, cancel):
    cut = crossing.cut_back(*shapes[0], *shapes[1], first_side, second_side, cancel)
    radii = _radii(cut.first, cut.first_side, radius, end_radius)
    found = sc.build.fillet_patches(*cut, radii, tolerance=tolerance, cancel=cancel)
    return of_patches([found.first, found.fillet, found.second], found.error, "cut back to where they cross")


def _are_apart(inputs, first_side, second_side):
    """Whether the sides that are meant are not one edge."""
    try:
        a, side_a, b, side_b = _sides(inputs, first_side, second_side)
    except Refusal:
        return True                     # one has no side at all
    return not sc.seam_continuity(a, side_a, b, side_b).gap <= 1e-6 * max(definition.size for definition in inputs)


def _offset(inputs, distance, tolerance, cancel=None):
    patches = patches_of(inputs[0])
    made = [sc.build.offset_patch(patch, distance, tolerance=tolerance, cancel=cancel) for patch in patches]
    warning = (words for patch, one in zip(patches, made) for words in overlaps.of_thick(patch, one.value, distance))
    return of_patches([one.value for one in made], max(one.error for one in made), warning=", ".join(warning))


def _first_distance(inputs):
    return {'distance': share_of_size(inputs[0], 0.02)}


def _thickened(inputs, distance, middle, piece, tolerance, cancel=None):
    patches = patches_of(inputs[0])
    verbs.require_piece(patches, piece)
    start = -0.5 * distance if middle else 0.0
    found = sc.build.thicken(patches[piece - 1], start, start + distance, tolerance=tolerance, cancel=cancel)
    sides = zip(sorted((start, start + distance), reverse=True), found.value)
    warning = (words for away, side in sides if away for words in overlaps.of_thick(patches[piece - 1], side, away))
    return of_patches(list(found.value), found.error, warning=", ".join(warning))


def _extended(inputs, side, length, how, piece):
    patches = patches_of(inputs[0])
    verbs.require_piece(patches, piece)
    patches[piece - 1] = sc.build.extend_patch(patches[piece - 1], side, length, how)
    return of_patches(patches)


def _of_mesh(inputs, cancel=None):
    polygons, = inputs
    found = sc.build.catmull_clark(polygons.points, polygons.faces, cancel=cancel)
    irregular = found.irregular
    said = phrase("{count} patches", one="{count} patch", count=len(found.patches))
    if irregular:
        said += phrase(", {irregular} of them about extraordinary points, angle {degrees}° between them",
                       irregular=irregular, degrees=_short(math.degrees(found.angle)))
    if polygons.has_creases:
        said += "; creases count as smooth"
    return of_patches(list(found.patches), 0.0, said)


def _distance(label, text):
    return Parameter("distance", label, text, 0.1, unit='LENGTH')


def _radius(name, label, text, follows=""):
    return Parameter(name, label, text, 0.1, 1e-6, unit='LENGTH', follows=follows)


def _covered_by_matched(values):
    """The surface that it is matched to stays visible beside it."""
    return 2 if values['both'] else 1


RECIPES = (
    Recipe("surface_blend", "Blend Surfaces",
           "A live surface between sides of two surfaces that continues both smoothly",
           (_continuity("What it shares with the surfaces along their sides"), _side("first_side", "First Side", "first"),
            _side("second_side", "Second Side", "second"),
            Parameter("first_strength", "First Strength", "How far it follows the first surface", 1.0, 1e-3, 100.0),
            Parameter("second_strength", "Second Strength", "How far it follows the second surface", 1.0, 1e-3, 100.0)),
           _blend, is_surface=True, resolution=12, inputs=(wanted.ONE_SURFACE, wanted.ANOTHER_SURFACE)),
    Recipe("matched", "Match Surface",
           "A live copy of the active surface with a side moved onto that of another, continuing it smoothly",
           (_continuity("What it shares with the other surface"), _side("first_side", "Its Side", "active"),
            _side("second_side", "Other Side", "other"),
            Parameter("rows", "Rows", "Of its control points that may move, from the side on; 0 for as few as it takes", 0, 0, 1000),
            Parameter("strength", "Strength", "How far it follows the other surface; at 1 its points move least", 1.0, 1e-3, 100.0),
            Parameter("both", "Move Both", "Both surfaces move half way, and are one shape", False)),
           _matched, is_surface=True, covers_inputs=True, covered=_covered_by_matched, resolution=12, inputs=(wanted.ONE_SURFACE, wanted.ANOTHER_SURFACE), takes_cancel=True),
    Recipe("rounded_edge", "Round Edge",
           "Live surfaces with rounded edges, as a rolling ball makes them: where two surfaces meet, or edges of one",
           (_radius("radius", "Radius", "Of the ball, where the edge starts"), _radius("end_radius", "End Radius", "Where it ends", "radius"),
            _side("first_side", "First Side", "first"), _side("second_side", "Second Side", "second"),
            Parameter("edges", "Edges", "Numbers of edges to round, such as 1, 4-6; none: where two surfaces meet, or all "
                                        "edges", ""), _TOLERANCE),
           _rounded, is_surface=True, covers_inputs=True, resolution=8, inputs=(wanted.SURFACES,), has_more=True, is_measured=True,
           takes_cancel=True),
    Recipe("offset_surface", "Offset Surface", "The surface at a distance from another one, along its normals; it is live",
           (_distance("Distance", "Along the normals; below 0 to the other side"), _TOLERANCE), _offset, is_surface=True,
           resolution=8, inputs=(wanted.ONE_SURFACE,), is_measured=True, takes_cancel=True, first_values=_first_distance),
    Recipe("thickened", "Thicken", "The closed body between a surface and one at a distance from it; it is live",
           (_distance("Thickness", "Along the normals; below 0 to the other side"),
            Parameter("middle", "Both Sides", "Half of it to each side", False), _PIECE, _TOLERANCE),
           _thickened, is_surface=True, covers_inputs=True, resolution=8, inputs=(wanted.ONE_SURFACE,), is_measured=True, takes_cancel=True,
           first_values=_first_distance),
    Recipe("extended_surface", "Extend Surface", "The surface made longer at a side; it is live",
           (Parameter("side", "Side", "Where it is made longer", "u_end", choices=_SIDES[1:]),
            Parameter("length", "Length", "On average along the side", 0.5, 1e-6, unit='LENGTH'),
            Parameter("how", "How", "How it is extended", "natural", choices=(
                ("natural", "Natural", "By the polynomials of its last span"), ("straight", "Straight", "Along its tangents"))), _PIECE),
           _extended, is_surface=True, covers_inputs=True, resolution=8, inputs=(wanted.ONE_SURFACE,)),
    Recipe("of_mesh", "Make NURBS from Mesh",
           "The surface to which a mesh converges that is subdivided (Catmull and Clark), as exact patches; it follows the mesh",
           (), _of_mesh, is_surface=True, covers_inputs=True, resolution=3, inputs=(wanted.ONE_MESH,), is_from_mesh=True, takes_cancel=True),
)
