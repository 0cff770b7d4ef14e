"""What the add-on's recipes of lofts, caps and fillings make, without Blender."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build

caps, definitions, failures, lofts, rims, sections = (core(name) for name in (
    'surfaces.caps', 'shape.definition', 'base.failures', 'surfaces.lofts', 'surfaces.rims', 'surfaces.sections'))
RECIPES = core('recipes.table').RECIPES
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def moved(curve, x=0.0, y=0.0, z=0.0, size=1.0):
    return curve.transformed(np.array([[size, 0, 0, x], [0, size, 0, y], [0, 0, size, z]]))


def polygon(*points, z=0.0):
    rows = [(*p, z) for p in (*points, points[0])]
    at = np.arange(len(rows), dtype=float)
    return sc.NurbsCurve(1, np.r_[at[0], at, at[-1]], rows)


SQUARE = polygon((0, 0), (1, 0), (1, 1), (0, 1))


def make(kind, *inputs, **values):
    recipe = RECIPES[kind]
    given = [one if isinstance(one, sections.Point) else definitions.from_value(one) for one in inputs]
    more = {'turned': [False] * len(given)} if recipe.has_turns else {}
    if recipe.takes_spaces:
        more['spaces'] = [np.eye(4)] * len(given)
    return recipe.make(given, **{**recipe.defaults, **values, **more})


def patches_of(result):
    value = definitions.to_patch_set(result.definition)
    return [value[i] for i in range(len(value))]


def volume(result):
    return definitions.to_patch_set(result.definition).volume()


@pytest.mark.parametrize('profile, area', ((CIRCLE, math.pi), (CIRCLE.reversed(), math.pi), (SQUARE, 1.0)))
def test_what_is_extruded_and_lofted_is_closed(profile, area):
    assert volume(make('extrude', profile, z=3.0, caps='both')) == pytest.approx(3 * area, rel=1e-9)
    found = make('loft', *(moved(profile, z=z) for z in (0.0, 1.0, 2.0)), caps='both')
    assert volume(found) == pytest.approx(2 * area, rel=1e-9) and found.said == ""


def test_a_profile_of_several_curves_is_capped_each_alone_and_no_hole_is_covered():
    apart = [CIRCLE, moved(SQUARE, x=3.0)]
    assert volume(make('extrude', apart, caps='both')) == pytest.approx(math.pi + 1, rel=1e-9)
    assert volume(make('extrude', [moved(CIRCLE, size=3.0), SQUARE], caps='both')) == pytest.approx(9 * math.pi - 1, rel=1e-9)
    logo = [moved(CIRCLE, size=9.0), moved(CIRCLE, x=4.0), SQUARE, moved(SQUARE, x=-2.0).reversed(), moved(CIRCLE, x=4.0, size=0.3)]
    assert volume(make('extrude', logo, caps='both')) == pytest.approx(80.09 * math.pi - 2, rel=1e-9)
    tall = make('extrude', logo, caps='start')
    assert len(caps.sc.build.open_ends(patches_of(tall))) > 0


def test_open_ends_of_what_is_editable_have_holes_too():
    plate = [moved(polygon((0, 0), (8, 0), (8, 4), (0, 4)), x=-4.0), moved(CIRCLE, x=-2.0, y=2.0), moved(CIRCLE, x=2.0, y=2.0).reversed()]
    for walls in (make('extrude', plate, z=2.0), make('extrude', plate[::-1], z=-2.0)):
        found = caps.capped(walls.definition, 'ALL')
        assert definitions.to_patch_set(found.changed.definition).volume() == pytest.approx(2 * (32 - 2 * math.pi), rel=1e-9)
        assert found.count == 2
        again = caps.capped(caps.capped(walls.definition, 'SHORTEST').changed.definition, 'ALL')
        assert definitions.to_patch_set(again.changed.definition).volume() == pytest.approx(2 * (32 - 2 * math.pi), rel=1e-9)


def test_closed_curves_within_one_are_holes_of_what_is_filled():
    found = make('filling', moved(CIRCLE, size=5.0), moved(CIRCLE, x=2.0), moved(CIRCLE, x=-2.0).reversed())
    assert definitions.to_patch_set(found.definition).area() == pytest.approx(23 * math.pi, rel=1e-9) and found.said == "plane"


def test_rims_that_cross_are_refused():
    with pytest.raises(failures.Refusal, match="cross or touch"):
        make('extrude', [CIRCLE, SQUARE], caps='both')
    with pytest.raises(failures.Refusal, match="one of its curves is open"):
        make('extrude', [CIRCLE, sc.BezierCurve([(5, 0, 0), (6, 0, 0)]).to_nurbs()], caps='start')


def test_what_is_closed_already_is_said():
    profile = sc.BezierCurve([(0, 0, 0), (1, 0, 0), (1, 0, 2)]).to_nurbs()
    found = make('revolve', profile, axis='z', caps='both')
    assert found.said == "the start is closed already" and volume(found) > 0
    ring = moved(CIRCLE, x=3.0).transformed(np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0.0]]))
    whole = make('revolve', ring, axis='z', caps='both')
    assert "the start is closed already" in whole.said and len(patches_of(whole)) == 1


def test_the_pipe_has_the_caps_that_are_wanted():
    axis = sc.BezierCurve([(0, 0, 0), (2, 0, 0.3), (4, 0, 0)]).to_nurbs()
    counts = {capped: len(patches_of(make('pipe', axis, caps='round', capped=capped))) for capped in ('both', 'start', 'end')}
    assert counts == {'both': 3, 'start': 2, 'end': 2}
    at_start = patches_of(make('pipe', axis, caps='flat', capped='start'))[1]
    assert np.abs(at_start.points[..., 0]).max() < 1.0


def test_a_loft_may_close_in_points_and_be_round_there():
    rings = [moved(CIRCLE, z=z) for z in (1.0, 2.0)]
    found = make('loft', sections.Point((0.0, 0.0, 0.0)), *rings, start='round', caps='both')
    assert "the start is closed already" in found.said and volume(found) > 0
    first = patches_of(found)[0]
    near = first.evaluate_grid(np.linspace(*first.domain[0], 8), [first.domain[1][0] + 1e-4 * (first.domain[1][1] - first.domain[1][0])])
    assert np.abs(near[..., 2]).max() < 1e-2 * np.hypot(near[..., 0], near[..., 1]).min()
    needle = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 3), (0, 0, 3)])
    assert volume(make('loft', *rings, needle, caps='both')) > 0
    with pytest.raises(failures.Refusal, match="is a point between other sections"):
        make('loft', rings[0], sections.Point((0.0, 0.0, 0.0)), rings[1])
    with pytest.raises(failures.Refusal, match="only a start in a point can be round"):
        make('loft', *rings, start='round')


@pytest.mark.parametrize('how, angle', (('G1', 1e-6), ('G2', 1e-6)))
@pytest.mark.parametrize('with_side', [False, True])
def test_a_loft_goes_on_from_a_surface(how, angle, with_side):
    tube = build.extrude(CIRCLE, (0, 0, -2))
    rings = [moved(CIRCLE, z=1.5, size=1.4), moved(CIRCLE, z=3.0)]
    inner = [CIRCLE, *rings] if with_side else rings
    found = make('loft', tube, *inner, start=how)
    made = patches_of(found)[0]
    seam = sc.seam_continuity(tube, 'v_start', made, 'v_start')
    assert seam.gap <= 1e-12 and seam.angle <= angle
    if how == 'G2':
        assert seam.curvature_difference <= 1e-6
    order = RECIPES['loft'].arranged([definitions.from_value(one) for one in (*rings, tube)])
    assert 2 in (order[0], order[-1])


def test_ends_at_right_angles_to_their_planes():
    rings = [CIRCLE, moved(CIRCLE, x=2.0, z=3.0)]
    made = patches_of(make('loft', *rings, start='normal', end='normal', end_strength=2.0))[0]
    for at in made.domain[1]:
        along = made.derivatives(0.3, at, 1)
        step = along[0][1] if not isinstance(along, np.ndarray) else along[0, 1]
        assert np.abs(step[:2]).max() <= 1e-9 and step[2] > 0.1
    line = sc.BezierCurve([(0, 0, 0), (1, 0, 0)]).to_nurbs()
    with pytest.raises(failures.Refusal, match="is straight"):
        make('loft', line, moved(line, z=1.0), start='normal')
    with pytest.raises(failures.Refusal, match="continue a surface"):
        make('loft', *rings, start='G1')


def test_numbers_of_corners_that_differ_are_said():
    found = make('loft', SQUARE, moved(SQUARE, z=1.0), moved(polygon((0, 0), (1, 0), (0, 1)), z=2.0))
    assert found.said == "corners are not matched: sections 1,\u00a02 have 4 corners, section 3 has 3 corners"
    assert make('loft', SQUARE, moved(SQUARE, z=1.0)).said == ""


OUTLINES = {
    'circle': (CIRCLE, 'any'), 'teardrop': (None, 'any'), 'square': (SQUARE, 1), 'lens': (None, 'any'),
    'dart': (polygon((0, 0), (2, 1), (0, 2), (0.5, 1)), 'any'),
    'star': (polygon(*((r * math.cos(a), r * math.sin(a)) for r, a in zip([1, 0.4] * 5, np.linspace(0, 2 * np.pi, 11)))), 'any'),
    'E': (polygon((0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (1, 3), (1, 4), (3, 4), (3, 5), (0, 5)), 'any'),
}


def outline(name):
    if name == 'teardrop':
        return sc.BezierCurve([(0, 0, 0), (3, 2, 0), (-3, 2, 0), (0, 0, 0)]).to_nurbs()
    if name == 'lens':
        halves = [sc.BezierCurve([(-1, 0, 0), (0, -1, 0), (1, 0, 0)]).to_nurbs(), sc.BezierCurve([(1, 0, 0), (0, 1, 0), (-1, 0, 0)]).to_nurbs()]
        return build.join_curves(halves, 1e-9)[0]
    return OUTLINES[name][0]


@pytest.mark.parametrize('name', OUTLINES)
@pytest.mark.parametrize('tilt', [0.0, 0.7])
def test_plane_outlines_of_any_corners_are_filled_exactly(name, tilt):
    c, s = math.cos(tilt), math.sin(tilt)
    curve = outline(name).transformed(np.array([[1, 0, 0, 5], [0, c, -s, 2], [0, s, c, -3.0]]))
    found = make('filling', curve)
    normal = np.array([0, -s, c])
    patches = patches_of(found)
    assert sum(one.area() for one in patches) == pytest.approx(abs(curve.signed_area(normal)), rel=1e-9)
    assert rims.is_good(patches, 0.0, [curve], normal)
    assert sc.PatchSet.from_patches(patches).area() > 0


def test_an_arc_with_its_chord_and_a_chain_of_ten():
    arc = sc.conics.circle((0, 0, 0), 1.0).split(1.0)[0] if not CIRCLE.periodic else CIRCLE.clamped().split(1.0)[0]
    start, end = arc.evaluate(np.array(arc.domain))
    found = make('filling', arc, sc.NurbsCurve(1, [0, 0, 1, 1], [end, start]))
    assert rims.is_good(patches_of(found), 0.0, [arc], np.array([0, 0, 1.0]))
    corners = [(math.cos(a), math.sin(a), 0) for a in np.linspace(0, 2 * np.pi, 11)[:-1]]
    sides = [sc.NurbsCurve(1, [0, 0, 1, 1], [a, b]) for a, b in zip(corners, corners[1:] + corners[:1])]
    assert sum(one.area() for one in patches_of(make('filling', *sides))) == pytest.approx(5 * math.sin(math.pi / 5), rel=1e-12)


def test_an_outline_that_crosses_itself_is_refused():
    with pytest.raises((failures.Refusal, sc.InvalidShape)):
        make('filling', polygon((0, 0), (3, 3), (3, 0), (0, 2)))


@pytest.mark.parametrize('parts', (1, 2, 4))
def test_shapes_of_patches_are_capped_on_their_points(parts):
    tube = build.extrude(CIRCLE.reversed(), (0, 0, 1))
    patches = [tube]
    for _ in range(parts // 2):
        patches = [part for patch in patches for part in (patch.clamped('u') if patch.periodic[0] else patch).split(
            'u', sum((patch.clamped('u') if patch.periodic[0] else patch).domain[0]) / 2)]
    definition = definitions.from_value(patches[0] if len(patches) == 1 else sc.PatchSet.from_patches(patches))
    found = caps.capped(definition, 'ALL')
    assert found.count == 2 and found.bend == 0.0 and found.is_turned
    assert definitions.to_patch_set(found.changed.definition).volume() == pytest.approx(math.pi, rel=1e-9)
    assert len(found.changed.parents) == len(found.changed.places) == len(found.changed.definition.pieces)
    with pytest.raises(failures.Refusal, match="no open end"):
        caps.capped(found.changed.definition, 'ALL')


def test_a_letter_of_patches_is_cut_with_its_caps():
    letter = outline('E')
    definition = definitions.from_value(build.extrude(letter, (0, 0, 2)))
    found = caps.capped(definition, 'ALL')
    assert definitions.to_patch_set(found.changed.definition).volume() == pytest.approx(22.0, rel=1e-9)
    own = [place for place in found.changed.places if place.u]
    assert len(own) == 12 and own[0].u[0].start == 0.0 and own[-1].u[0].end == 1.0


def test_a_flat_sheet_is_not_covered_by_a_cap():
    with pytest.raises(failures.Refusal, match="lies in one plane"):
        caps.capped(definitions.from_value(build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))), 'ALL')
