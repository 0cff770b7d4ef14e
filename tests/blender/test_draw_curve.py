"""A drawn stroke becomes a clean curve; one that is too short is refused."""

import bpy
import numpy as np
import pytest

from curves import said_near
from shapes import enter, leave, op, require_exact
from support import part, splinecore as sc
from test_curve_through import value
from test_menus import drawn

T = np.linspace(0, 1, 60)
DRAWN = np.stack([4 * T, np.sin(6 * T), 0.2 * T], -1)
LOOP = np.stack([np.cos(6 * T), np.sin(6 * T), 0 * T], -1)


def text_of(points):
    return " ".join(map(repr, np.ravel(points).tolist()))


@pytest.mark.parametrize('points, closed', ((DRAWN, False), (LOOP, True)))
def test_a_stroke_becomes_a_clean_curve_within_the_tolerance(points, closed, capfd):
    assert op(bpy.ops.splinewright.draw_curve, stroke=text_of(points), tolerance=0.0625, closed=closed) == {'FINISHED'}
    made, error = sc.fit.approximate(points, tolerance=0.0625, parameters='centripetal', corrections=3, closed=closed)
    assert value(bpy.context.object) == made
    require_exact(bpy.context.object)
    assert error <= 0.0625 and len(made.points) < len(points) / 2
    assert said_near(capfd.readouterr().out) == (len(made.points), pytest.approx(error, rel=1e-3))


@pytest.mark.parametrize('stroke', ("", "0 0 0", "0 0 0 0 0 0", "1 2", "1 2 x"))
def test_what_is_no_stroke_is_refused(stroke):
    before = len(bpy.data.objects), len(bpy.data.curves)
    with pytest.raises(RuntimeError, match="stroke"):
        op(bpy.ops.splinewright.draw_curve, stroke=stroke)
    assert (len(bpy.data.objects), len(bpy.data.curves)) == before


def test_there_are_two_pens_in_the_menu():
    def begins(name):
        return getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}").begins_on_surface
    assert [begins('draw_curve'), begins('draw_on_surface')] == [False, True]
    assert {'draw_curve', 'draw_on_surface'} <= set(drawn("VIEW3D_MT_curve_add"))
    op(bpy.ops.splinewright.draw_on_surface, stroke=text_of(DRAWN), tolerance=0.0625)
    first = value(bpy.context.object)
    op(bpy.ops.splinewright.draw_curve, stroke=text_of(DRAWN), tolerance=0.0625)
    assert value(bpy.context.object) == first


def test_one_undo_takes_it_back():
    bpy.ops.ed.undo_push(message="before")
    count = len(bpy.data.objects)
    op(bpy.ops.splinewright.draw_curve, stroke=text_of(DRAWN))
    bpy.ops.ed.undo()
    assert len(bpy.data.objects) == count


# Contours -------------------------------------------------------------------------------------------------------------

contours, guides, marks = part('core.drawing.contours'), part('core.drawing.guides'), part('core.drawing.snap_marks')


def polar(length, degrees):
    return length * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


@pytest.mark.parametrize('kinds, closing', ((('segment', 'segment', 'segment'), 'segment'), (('segment', 'arc', 'segment'), 'segment'),
                                            (('segment', 'segment', 'arc'), 'arc')))
def test_the_corner_radius_of_a_drawn_contour_stays_in_its_panel(kinds, closing):
    drawn = contours.Contour(((0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)), kinds, True, closing)
    assert op(bpy.ops.splinewright.draw_contour, contour=contours.text_of(drawn), radius=0.2) == {'FINISHED'}
    ob = bpy.context.object
    for radius in (0.2, 0.3):
        ob.data.splinewright_parameters.contour_corner_size = radius
        made, wanted = value(ob), contours.curve_of(drawn, radius)
        assert made.length() == pytest.approx(wanted.length(), rel=1e-9)
        assert part('bridge.recipes.recipes').parameters(ob.data)['arcs'] == ", ".join(map(str, drawn.sides()))
    assert editing_points(ob) == 4
    op(bpy.ops.splinewright.draw_contour, contour=contours.text_of(drawn))
    assert not part('bridge.recipes.recipes').has(bpy.context.object.data), "sharp corners can be trimmed at once"


def editing_points(ob):
    held = enter()
    count = len(held.data.splines[0].points)
    leave()
    return count


def test_arcs_of_a_contour_that_are_no_numbers_are_refused():
    with pytest.raises(RuntimeError, match="is not a number of a side"):
        op(bpy.ops.splinewright.add_contour, arcs="two")
    assert op(bpy.ops.splinewright.add_contour, arcs="2-3, 99", corners='cut') == {'FINISHED'}


def test_points_that_lie_on_one_another_are_one():
    twice = contours.Contour(((0, 0, 0), (4, 0, 0), (4, 0, 0), (4, 2, 0), (0, 0, 0)), ('segment', 'arc', 'arc', 'segment'), True)
    found = twice.without_repeats()
    assert found.points == ((0, 0, 0), (4, 0, 0), (4, 2, 0)) and found.kinds == ('segment', 'arc') and found.closing == 'segment'


def test_a_contour_closes_by_an_arc():
    drawn = contours.Contour().after((0, 0, 0), 'segment').after((4, 0, 0), 'segment').after((4, 2, 0), 'arc')
    drawn = drawn._replace(closed=True, closing='arc')
    assert contours.from_text(contours.text_of(drawn)) == drawn
    plain = drawn._replace(closing='segment')
    assert contours.text_of(plain).endswith("; closed") and contours.from_text(contours.text_of(plain)) == plain
    *_, last = contours.parts_of(drawn)
    assert np.allclose(last.evaluate(np.array(last.domain)), [(4, 2, 0), (0, 0, 0)]) and last.degree == 2
    way = contours.way_of(drawn)
    assert np.allclose(way / np.linalg.norm(way), (-1, 0, 0)), "it goes on from the arc before"
    assert op(bpy.ops.splinewright.draw_contour, contour=contours.text_of(drawn)) == {'FINISHED'}
    made = value(bpy.context.object)
    assert np.allclose(*made.evaluate(np.array(made.domain))) and made.length() > 4 + np.pi + 4.2


@pytest.mark.parametrize('degrees, way, wanted', (
    (31, None, 30), (-8, None, -15), (3, None, 0), (100, None, 105), (52, polar(1, 7), 52), (64, polar(3, 20), 65), (179, None, 180)))
def test_a_way_is_held_to_steps_from_the_axes_and_from_the_way_before(degrees, way, wanted):
    found = guides.next_point(polar(2.0, degrees), way, is_held=True)
    assert np.allclose(found, polar(2.0 * np.cos(np.radians(degrees - wanted)), wanted))


def test_typed_lengths_and_angles_are_those_of_the_next_part():
    way = polar(1, 30)
    assert np.allclose(guides.next_point(polar(2, 77), way, length=5.0), polar(5, 77))
    assert np.allclose(guides.next_point(polar(2, 77), way, length=5.0, angle=np.radians(-45)), polar(5, -15))
    assert np.allclose(guides.next_point(polar(2, 77), None, angle=np.radians(77)), polar(2, 77))
    assert np.degrees(guides.turn(polar(2, -170), polar(1, 170))) == pytest.approx(20)


def test_curves_are_marked_at_ends_middles_and_feet():
    sides = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0, 0), (4, 0, 0), (4, 2, 0)])
    found = marks.segments([sides, sc.conics.circle((10, 0, 0), 1.0)])
    known = marks.of_segments(found)
    places = {name: {tuple(np.round(mark.place, 6) + 0.0) for mark in known if mark.name == name} for name in ("End", "Midpoint")}
    assert {(0, 0, 0), (4, 0, 0), (4, 2, 0)} <= places["End"]
    assert {(2, 0, 0), (4, 1, 0)} <= places["Midpoint"]
    feet = [tuple(np.round(mark.place, 6) + 0.0) for mark in marks.feet(found, (1, 0.5, 0))]
    assert {(1, 0, 0), (4, 0.5, 0)} <= set(feet)
    away = np.array(sorted(place for place in feet if place[0] > 5)) - (10, 0, 0)
    wanted = np.array((9, -0.5, 0)) / np.hypot(9, 0.5)
    assert np.allclose(away, [-wanted, wanted], atol=1e-5), "of a circle the nearest and the farthest"


@pytest.mark.parametrize('seed', range(20))
def test_ways_to_feet_are_at_right_angles(seed):
    rng = np.random.default_rng([17, seed])
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1], rng.normal(size=(6, 3)) * 10 ** rng.uniform(-5, 5))
    point = curve.points.mean(0) + rng.normal(size=3) * np.ptp(curve.points)
    size = np.ptp(curve.points)
    for mark in marks.feet([curve], point):
        u = curve.nearest(mark.place).parameters
        way, tangent = mark.place - point, curve.derivatives(float(np.ravel(u)[0]), 1)[1]
        assert abs(way @ tangent) <= 1e-6 * np.linalg.norm(way) * np.linalg.norm(tangent) + 1e-9 * size * size
