"""The tool Measure: what is said and shown of a place, and how it comes into the panel."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

import curves
import patches
from layouts import drawn_by
from shapes import activate, add, enter, op
from support import part, splinecore as sc

measured, measure_here = part('core.analysis.measured'), part('ui.operators.measure_here')
measure_panel = part('ui.measure_panel')
panel = measure_panel.SPLINEWRIGHT_PT_measure_place


@pytest.fixture(autouse=True)
def patience(monkeypatch):
    """A busy machine takes its time."""
    monkeypatch.setattr(measure_panel, '_SOON', 60)


def words(place):
    """{name: numbers} of a point."""
    named = (line.split(" ", 1) for line in place.words[1:])
    return {name: list(map(float, numbers.split(", "))) for name, numbers in named}


def test_of_a_circle_the_radius_is_said_and_the_arms_are_tangent_and_normal():
    circle = curves.value_of('circle')
    u = circle.domain[0] + 0.3 * (circle.domain[1] - circle.domain[0])
    found = measured.place(circle, (u,))
    radius = 1 / float(circle.curvature(u))
    tangent, normal = found.arms
    said = words(found)
    assert said["Radius"] == pytest.approx([radius], rel=1e-3) and said["Torsion"] == [0]
    assert said["Point"] == pytest.approx(list(circle.evaluate(u)), abs=1e-3)
    assert said["Tangent"] == pytest.approx(list(tangent), abs=1e-3)
    assert tangent == pytest.approx(circle.frames(u)[0]) and abs(np.dot(tangent, normal)) < 1e-12
    assert found.point + radius * normal == pytest.approx(np.mean(circle.bounding_box(), axis=0), abs=1e-9)


def test_what_is_straight_has_a_tangent_alone():
    found = measured.place(sc.BezierCurve([(0, 0, 0), (2, 0, 0)]), (0.5,))
    assert len(found.arms) == 1 and found.words == ("u 0.5", "Point 1, 0, 0", "Tangent 1, 0, 0", "Curvature 0")


def test_torsion_is_said_of_a_curve_in_space():
    """Of (t, t^2, t^3): 3 at t = 0, and 2 is the curvature."""
    said = words(measured.place(sc.BezierCurve([(0, 0, 0), (1 / 3, 0, 0), (2 / 3, 1 / 3, 0), (1, 1, 1)]), (0.0,)))
    assert said["Torsion"] == pytest.approx([3], rel=1e-3) and said["Curvature"] == pytest.approx([2], rel=1e-3)
    assert said["Point"] == [0, 0, 0] and said["Tangent"] == [1, 0, 0]


def test_of_a_patch_the_directions_of_u_and_v_the_normal_and_both_curvatures():
    patch = patches.value_of('bicubic')
    found = measured.place(patch, (0.4, 0.7))
    along_u, along_v, normal = found.arms
    assert np.cross(along_u, along_v) @ normal > 0 and abs(along_u @ normal) < 1e-12 > abs(along_v @ normal)
    assert found.words[0] == "u 0.4, v 0.7"
    said = words(found)
    assert said["Curvatures"] == pytest.approx(sorted(patch.curvatures(0.4, 0.7).principal), rel=1e-3)
    assert [1 / number for number in said["Radii"]] == pytest.approx(said["Curvatures"], rel=1e-3)
    assert said["Point"] == pytest.approx(list(patch.evaluate(0.4, 0.7)), abs=1e-3)
    assert said["Normal"] == pytest.approx(list(normal), abs=1e-3)


def test_a_plane_has_endless_radii():
    plane = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    assert measured.place(plane, (0.5, 0.5)).words[1:] == (
        "Point 0.5, 0.5, 0", "Normal 0, 0, 1", "Curvatures 0, 0", "Radii inf, inf")


@pytest.mark.parametrize('value, parameters', ((curves.value_of('nurbs'), (0.3,)), (patches.value_of('bicubic'), (0.25, 0.75))))
def test_the_panel_shows_the_place_that_was_clicked(value, parameters):
    ob = add(value)
    fractions = measured.fractions_of(value, parameters)
    other = add(curves.value_of('cubic'), "other")
    activate(other, ob)
    measure_here.take(bpy.context, ob, 1, fractions)
    assert bpy.context.object == ob
    texts = [text for text in drawn_by(panel, bpy.context).texts if text]
    said = dict(zip(texts, texts[1:]))
    assert [float(said[name]) for name, _ in zip("uv", parameters)] == pytest.approx(parameters, rel=1e-6)


def test_of_several_pieces_the_one_that_was_clicked_is_in_hand():
    ob = add(curves.value_of('many curves'))
    measure_here.take(bpy.context, ob, 2, (0.25, 0.0))
    assert ob.data.splinewright.piece == 2 and ob.data.splinewright.measure_u == 0.25


def test_while_a_net_is_edited_its_shape_is_meant():
    ob = add(curves.value_of('nurbs'))
    enter()
    net = bpy.context.object
    assert measure_here._shapes(bpy.context) == [ob] and bpy.ops.splinewright.measure_here.poll()
    measure_here.take(bpy.context, ob, 1, (0.125, 0.0))
    assert bpy.context.object == net and ob.data.splinewright.measure_u == 0.125


def test_recipes_are_measured_too_and_what_is_no_shape_is_not():
    assert not bpy.ops.splinewright.measure_here.poll()
    op(bpy.ops.splinewright.add_circle)
    assert bpy.ops.splinewright.measure_here.poll()
    bpy.ops.mesh.primitive_cube_add()
    activate(bpy.context.object)
    assert not bpy.ops.splinewright.measure_here.poll()


def test_a_pixel_is_as_large_as_the_view_shows_it():
    class Region:
        width, height = 200, 100

    class View:
        view_matrix = Matrix()
        perspective_matrix = Matrix.Diagonal((1, 2, 1, 1))
        is_perspective, view_perspective = False, 'ORTHO'
    assert part('ui.picking').size_of_pixel(Region, View, (0.2, 0.1, 5.0)) == pytest.approx(0.01, rel=1e-5)
