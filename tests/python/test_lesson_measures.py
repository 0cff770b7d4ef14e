"""Measures of lessons against closed forms: of conics, outlines, strips, knots and joints of curves, of surfaces and their seams."""

import math

import pytest

import splinecore as sc
from addon_core import core

measures = core("lessons.measures")
HOUSE = sc.build.contour([(-1, -0.7), (1, -0.7), (1, 0.3), (0, 1), (-1, 0.3)], closed=True)
OPEN = sc.build.contour([(0, 0), (3, 0), (3, 4)])
# Two pieces over [0, 1] and [1, 2], along one line, the second one twice as fast.
UNEVEN = sc.NurbsCurve(3, [0] * 4 + [1] * 3 + [2] * 4, [(x, 0) for x in (0, 1, 2, 3, 5, 7, 9)])


def measured(kind, value, other=None, **arguments):
    shapes = {'it': measures.Shown(value, {}), 'other': measures.Shown(other, {})}
    return measures.measured(measures.Measure(kind, "it", {**arguments, **({'to': "other"} if other is not None else {})}), shapes)


PARABOLA = sc.BezierCurve([(-1, 1), (0, -1), (1, 1)])
POINT = sc.BezierCurve([(1, 1), (1, 1)])
TENT = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (4, 0)])


def conic(weight):
    return sc.conics.conic_arc((1, 0), (1, 1), (0, 1), weight)


@pytest.mark.parametrize('kind, value, arguments, wanted', (
    ('start', HOUSE.with_domain((2, 5)), {}, 2.0), ('end', HOUSE.with_domain((2, 5)), {}, 5.0), ('knot', UNEVEN, {'index': 4}, 1.0),
    ('jump', UNEVEN, {'at': 1.0, 'order': 0}, 0.0), ('jump', UNEVEN, {'at': 1.0, 'order': 1}, 3.0), ('jump', UNEVEN, {'at': 0.5, 'order': 1}, 0.0),
    ('closed', HOUSE, {}, 1.0), ('closed', OPEN, {}, 0.0), ('corners', HOUSE, {}, 5), ('corners', OPEN, {}, 1), ('corners', UNEVEN, {}, 0),
    ('area', HOUSE, {}, 2.7), ('area', HOUSE.reversed(), {}, 2.7), ('area', sc.conics.circle((3, 1, 0), 2.0), {}, 4 * math.pi),
    ('eccentricity', conic(math.sqrt(0.5)), {}, 0.0), ('eccentricity', conic(1.0), {}, 1.0),
    ('eccentricity', sc.conics.ellipse((0, 0, 0), (5, 0, 0), (0, 3, 0)), {}, 0.8),
    ('energy', PARABOLA, {}, 88 / (3 * 5 ** 1.5)), ('energy', PARABOLA.scaled((2, 2, 2)), {}, 44 / (3 * 5 ** 1.5)),
    ('energy', sc.BezierCurve([(0, 0), (3, 4)]), {}, 0.0), ('influence', PARABOLA, {'index': 1}, 1.0),
    ('influence', TENT, {'index': 0}, 0.25), ('influence', TENT, {'index': 1}, 1.0), ('influence', TENT, {'index': 2}, 0.75),
    ('arcs', OPEN, {}, 1), ('arcs', conic(0.5), {}, 1), ('arcs', conic(-0.5), {}, 1), ('arcs', conic(-1.0), {}, 2), ('arcs', conic(-2.0), {}, 3)))
def test_measures_of_curves(kind, value, arguments, wanted):
    assert measured(kind, value, **arguments) == pytest.approx(wanted, abs=1e-7)


def test_the_angle_from_the_end_of_one_curve_to_the_start_of_another():
    for angle in (0.0, 0.3, 1.2, 2.5):
        other = sc.BezierCurve([(3, 4), (3 + 2 * math.cos(angle), 4 + 2 * math.sin(angle))])
        assert measured('joint_angle', sc.BezierCurve([(1, 4), (3, 4)]), other) == pytest.approx(angle, abs=1e-12)


def roof(slope, gap=0.0):
    """A flat patch that leaves x = 0 under a slope, curved with z'' = 2."""
    return sc.BezierPatch([[(gap + x, y, z) for y in (0, 1)] for x, z in ((0, 0), (0.5, 0.5 * slope), (1, slope + 1))])


FLAT = sc.BezierPatch([[(x, y, 0) for y in (0, 1)] for x in (-1, 0)])


@pytest.mark.parametrize('slope', (0.0, 0.25, -1.0))
def test_measures_of_seams(slope):
    wanted = {'gap': 0.0, 'angle': abs(math.atan(slope)), 'g': 1 if slope == 0.0 else 0, 'c': 1 if slope == 0.0 else 0}
    for pair in ((FLAT, roof(slope)), (roof(slope), FLAT), (sc.PatchSet.from_patches([FLAT]), roof(slope).to_nurbs())):
        for name, number in wanted.items():
            assert measured(f"seam_{name}", *pair) == pytest.approx(number, abs=1e-9)
    assert measured('seam_gap', FLAT, roof(slope, 0.2)) == pytest.approx(0.2, abs=1e-12)
    assert measured('seam_bend', FLAT, roof(0.0)) == pytest.approx(2.0, abs=1e-9)


@pytest.mark.parametrize('factor', (1e-3, 1.0, 1e4))
def test_the_part_of_a_curve_that_lies_off_another_one(factor):
    curve = OPEN.scaled((factor, factor, factor))
    other = sc.BezierCurve([(0, 0), (3 * factor, 0)])
    assert measured('away', curve, other) == pytest.approx(4 / 7, abs=0.01)
    assert measured('away', curve, curve) == 0.0
    assert measured('away', curve, other.translated((0, 0, factor))) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize('at, at_v', ((0.0, 0.0), (0.5, 0.25), (1.0, 1.0)))
@pytest.mark.parametrize('slope', (0.0, 0.25, -1.0))
def test_places_and_normals_of_a_surface(slope, at, at_v):
    wanted = {'surface_x': at, 'surface_y': at_v, 'surface_z': slope * at + at * at}
    steep = slope + 2 * at
    length = math.hypot(1, steep)
    wanted.update({'normal_x': -steep / length, 'normal_y': 0.0, 'normal_z': 1 / length})
    for surface in (roof(slope), roof(slope).to_nurbs(), sc.PatchSet.from_patches([roof(slope), FLAT])):
        for kind, number in wanted.items():
            assert measured(kind, surface, at=at, at_v=at_v) == pytest.approx(number, abs=1e-12)


@pytest.mark.parametrize('kind, value, other, arguments, said', (
    ('knot', UNEVEN, None, {'index': 99}, "there is no knot 99"), ('jump', UNEVEN, None, {'at': 1.0, 'order': 4}, "the orders 0 to 3"),
    ('energy', conic(0.5), None, {}, "of a curve without weights"), ('influence', UNEVEN, None, {'index': 7}, "the last one is 6"),
    ('energy', sc.BezierCurve([(0, 0), (2, 0), (1, 0)]), None, {}, "stops or turns back"), ('surface_x', OPEN, None, {'at': 0, 'at_v': 0}, "not a surface"),
    ('influence', POINT, None, {'index': 0}, "no length"), ('away', POINT, OPEN, {}, "no length"), ('away', OPEN, FLAT, {}, "it is not a curve"),
    ('normal_z', sc.BezierPatch([[(1, 1, 1)] * 2] * 2), None, {'at': 0.5, 'at_v': 0.5}, "has no normal there"),
    ('surface_x', FLAT, None, {'at': 7.0, 'at_v': 0}, ""), ('normal_x', FLAT, None, {'at': 0.5, 'at_v': -9.0}, ""),
    ('jump', UNEVEN, None, {'at': 1.0, 'order': -1}, "the orders 0 to 3"), ('area', FLAT, None, {}, "it is not a curve"),
    ('seam_g', HOUSE, FLAT, {}, "it is not a surface"), ('seam_g', FLAT, HOUSE, {}, "it is not a surface"),
    ('seam_g', [HOUSE, HOUSE], FLAT, {}, "it is not a surface"), ('area', OPEN, None, {}, ""),
    ('eccentricity', conic(0.0), None, {}, ""), ('joint_angle', UNEVEN, FLAT, {}, "it is not a curve")))
def test_what_cannot_be_measured_is_a_sentence(kind, value, other, arguments, said):
    with pytest.raises(measures.FAILURES, match=said):
        measured(kind, value, other, **arguments)
