"""Offsets, blends, helices, sections and curves on patches follow what they were made from, wherever it stands."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from shapes import activate, add, op, require_exact
from support import part, splinecore as sc
from test_revolve_axis import PLACES, empty
from test_surfaces import add_recipe

follow, recipes = part('bridge.follow.follow'), part('bridge.recipes.recipes')
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)
WAVE = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (2, -1, 0), (3, 1, 0), (4, 0, 0)])
SPHERE = sc.build.sphere((0, 0, 0), 1.0)


def placed(value, name, place=Matrix()):
    ob = add(value, name)
    ob.matrix_world = place
    bpy.context.view_layer.update()
    return ob


def world(ob, points):
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def curves_in_world(ob, count=200):
    """Points of all pieces of a curve shape, in the world."""
    bpy.context.view_layer.update()
    value = ob.data.splinewright.value
    pieces = value if isinstance(value, list) else [value]
    return np.concatenate([world(ob, piece.evaluate(np.linspace(*piece.domain, count))) for piece in pieces])


def distances_to(ob, points):
    """From points of the world to a shape."""
    value = ob.data.splinewright.value
    inverse = np.linalg.inv(np.array(ob.matrix_world, dtype=np.float64))
    there = points @ inverse[:3, :3].T + inverse[:3, 3]
    feet = value.nearest(there).points
    return np.linalg.norm(world(ob, feet) - points, axis=1)


@pytest.mark.parametrize('place', PLACES)
def test_an_offset_is_at_a_distance_in_the_scene_and_follows(place):
    source = placed(CIRCLE, "circle", place)
    activate(source)
    ob = add_recipe('offset', distance=-0.3)
    away = distances_to(source, curves_in_world(ob))
    assert away == pytest.approx(0.3, abs=1e-4)
    source.data.splinewright.value = WAVE
    bpy.context.view_layer.update()
    assert follow.problem(ob.data) == ""
    away = distances_to(source, curves_in_world(ob))
    assert away.min() == pytest.approx(0.3, abs=2e-4) and away.max() == pytest.approx(0.3, abs=2e-4)
    require_exact(ob)


def test_what_is_no_plane_curve_has_no_offset_and_nothing_is_added():
    source = add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0, 0), (1, 2, 0), (2, -1, 3), (3, 1, 0)]))
    activate(source)
    with pytest.raises(RuntimeError, match="not in a plane"):
        op(bpy.ops.splinewright.add_offset)
    assert list(bpy.data.objects) == [source]


def test_an_offset_larger_than_every_radius_says_so():
    activate(add(CIRCLE))
    with pytest.raises(RuntimeError, match="nothing is left"):
        op(bpy.ops.splinewright.add_offset, distance=1.0)


@pytest.mark.parametrize('continuity, found', (('G0', 0), ('G1', 1), ('G2', 2), ('G3', 2)))
def test_a_blend_goes_on_as_both_curves_do_and_follows_them(continuity, found):
    first = placed(WAVE, "first")
    second = placed(WAVE, "second", Matrix.Translation((6, 1, 1)) @ Matrix.Rotation(0.4, 4, 'Z'))
    activate(second, first)
    ob = add_recipe('blend', continuity=continuity)
    for place in (second.matrix_world.copy(), Matrix.Translation((7, -1, 0.5)) @ Matrix.Rotation(-0.7, 4, 'Y')):
        second.matrix_world = place
        bpy.context.view_layer.update()
        assert follow.problem(ob.data) == ""
        a, bridge, b = (curve.data.splinewright.value.to_nurbs().transformed(np.array(curve.matrix_world, dtype=np.float64))
                        for curve in (first, ob, second))
        whole, = sc.build.join_curves([a, bridge, b], 1e-5)
        assert bridge.nearest(a.evaluate(2.0)).distances < 1e-6 and bridge.nearest(b.evaluate(0.0)).distances < 1e-6
        joints = [joint for u, joint in whole.joints(1e-4) if joint.g < 3]
        assert min((joint.g for joint in joints), default=2) >= found


@pytest.mark.parametrize('place', PLACES)
def test_a_section_lies_on_both_surfaces_and_follows_them(place):
    ball = placed(SPHERE, "ball", place)
    tube = placed(sc.build.cylinder((0, 0, -3), (0, 0, 1), 0.5, 6.0), "tube", place @ Matrix.Rotation(0.3, 4, 'X'))
    activate(tube, ball)
    ob = add_recipe('section', tolerance=1e-5)
    assert len(ob.data.splinewright.value) == 2
    for other in (tube.matrix_world.copy(), place @ Matrix.Translation((0.4, 0, 0))):
        tube.matrix_world = other
        points = curves_in_world(ob)
        assert follow.problem(ob.data) == ""
        assert distances_to(ball, points).max() < 1e-4 and distances_to(tube, points).max() < 1e-4
    before = curves_in_world(ob)
    tube.matrix_world = place @ Matrix.Translation((90, 0, 0))
    assert np.array_equal(curves_in_world(ob), before) and "do not meet" in follow.problem(ob.data)


def test_planes_cut_a_surface_and_may_be_those_of_an_object():
    ball = placed(SPHERE, "ball")
    activate(ball)
    ob = add_recipe('planes', axis='z', offset=-0.5, count=3, spacing=0.5)
    value = ob.data.splinewright.value
    assert len(value) == 3
    for curve, height in zip(value, (-0.5, 0.0, 0.5)):
        points = curve.evaluate(np.linspace(*curve.domain, 100))
        assert points[:, 2] == pytest.approx(height, abs=1e-4)
        assert np.linalg.norm(points, axis=1) == pytest.approx(1, abs=1e-4)
    activate(ball)
    frame = empty(matrix=Matrix.Rotation(0.5, 4, 'X') @ Matrix.Translation((0, 0, 0.25)))
    frame.select_set(True)
    tilted = add_recipe('planes', axis='z', offset=0.0, count=1)
    def heights():
        inverse = np.linalg.inv(np.array(frame.matrix_world, dtype=np.float64))
        return curves_in_world(tilted) @ inverse[2, :3] + inverse[2, 3]
    assert heights() == pytest.approx(0, abs=1e-4)
    frame.location.z += 0.2
    bpy.context.view_layer.update()
    assert heights() == pytest.approx(0, abs=1e-4)


def test_a_side_that_two_patches_share_is_a_section_once():
    """The teapot's patches meet in its plane of symmetry."""
    op(bpy.ops.splinewright.add_teapot)
    bpy.context.view_layer.update()
    ob = add_recipe('planes', axis='y', offset=0.0, count=1)
    value = ob.data.splinewright.value
    assert follow.problem(ob.data) == ""
    middles = np.array([curve.evaluate(np.mean(curve.domain)) for curve in value])
    apart = np.linalg.norm(middles[:, None] - middles[None], axis=-1) + np.eye(len(value))
    assert apart.min() > 1e-3
    # None goes there and back.
    for curve in value:
        quarter, three = curve.evaluate(curve.domain[0] + np.ptp(curve.domain) * np.array([0.25, 0.75]))
        assert np.linalg.norm(quarter - three) > 1e-3


def test_a_long_section_is_called_off():
    rng = np.random.default_rng(1)
    knots = np.r_[[0] * 4, np.arange(1, 37), [37] * 4].astype(float)
    x, y = np.meshgrid(np.linspace(0, 1, 40), np.linspace(0, 1, 40), indexing='ij')
    waves = [part('core.shape.definition').from_value(sc.NurbsPatch((3, 3), (knots, knots), np.stack(
        [x, y, 0.2 * rng.uniform(-1, 1, x.shape)], -1))) for _ in range(2)]
    work = part('core.recipes.table').RECIPES['section'].work(waves, {'tolerance': 1e-8})
    with pytest.raises(sc.Cancelled):
        work(lambda: True)


def test_planes_beside_a_surface_say_so():
    activate(placed(SPHERE, "ball"))
    with pytest.raises(RuntimeError, match="meets none of the planes"):
        op(bpy.ops.splinewright.add_planes, offset=7.0)


def test_a_helix_about_a_curve():
    source = placed(WAVE, "axis")
    activate(source)
    ob = add_recipe('about', radius=0.1, end_radius=0.3, turns=5)
    assert distances_to(source, curves_in_world(ob)).max() == pytest.approx(0.3, abs=0.02)
    source.data.splinewright.value = sc.BezierCurve([(0, 0, 0), (0, 0, 5)])
    points = curves_in_world(ob)
    assert np.hypot(points[0, 0], points[0, 1]) == pytest.approx(0.1, abs=1e-4)
    assert np.hypot(points[-1, 0], points[-1, 1]) == pytest.approx(0.3, abs=1e-4)


def test_a_curve_on_a_patch_by_its_image_in_the_unit_square():
    ball = placed(SPHERE, "ball", PLACES[1])
    image = placed(sc.BezierCurve([(0.1, 0.2), (0.5, 0.9), (0.9, 0.4)]), "image", PLACES[2])
    activate(image, ball)
    ob = add_recipe('on_patch')
    assert distances_to(ball, curves_in_world(ob)).max() < 2e-4
    image.location.x += 5
    ball.location.y += 2
    assert distances_to(ball, curves_in_world(ob)).max() < 2e-4
    image.data.splinewright.value = sc.BezierCurve([(0.1, 0.2), (0.5, 1.9), (0.9, 0.4)])
    bpy.context.view_layer.update()
    assert "leaves the patch" in follow.problem(ob.data)


def test_contours_and_arcs_by_points():
    contour = add_recipe('contour')
    value = contour.data.splinewright.value
    assert max(joint.angle for _, joint in value.joints()) < 1e-6 and value.is_rational
    arc = add_recipe('arc_by_points')
    points = arc.data.splinewright.value.evaluate(np.linspace(0, 1, 50))
    assert np.ptp(np.linalg.norm(points - sc.conics.circle((0, 0, 0), 1).evaluate(0), axis=1)) >= 0
    for by in ('tangent', 'centre'):
        made = add_recipe('arc_by_points', by=by)
        assert made.data.splinewright.value.length() > 0


@pytest.mark.parametrize('kind, wanted', (('offset', "one curve"), ('section', "one surface and another surface"),
                                          ('blend', "one curve and another curve"), ('on_patch', "one surface and one curve")))
def test_what_is_to_be_selected_is_said(kind, wanted):
    with pytest.raises(RuntimeError, match=f"Select {wanted}"):
        op(getattr(bpy.ops.splinewright, f"add_{kind}"))


def test_what_a_contour_is_does_not_depend_on_where_memory_lies():
    """numpy's functions of one number round otherwise where its result lies right behind it, which only some allocators do."""
    recipe = part('core.recipes.table').RECIPES['contour']
    kept, points = [], recipe.start_for(recipe.defaults) / 3 + 0.1
    made = [recipe.make(points, **recipe.defaults).value]
    for i in range(500):
        kept = [*kept, np.empty(1 + i % 3)][-50:]
        made.append(recipe.make(points, **recipe.defaults).value)
    assert all(value == made[0] for value in made)
