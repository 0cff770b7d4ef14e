"""Surfaces as recipes: exact primitives, formulas, and what curves make by moving, live."""

import math

import bpy
import numpy as np
import pytest

from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

definitions, follow, recipes, shape, table = (part(name) for name in (
    'core.shape.definition', 'bridge.follow.follow', 'bridge.recipes.recipes', 'bridge.shape.shape', 'core.recipes.table'))
PRIMITIVES = [recipe.kind for recipe in table.STARTING if recipe.is_surface]
PROFILE = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(1, 0, 0), (1.5, 0, 0.5), (0.5, 0, 1), (1, 0, 1.5), (1.2, 0, 2)])


def add_recipe(kind, **numbers):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **numbers) == {'FINISHED'}
    bpy.ops.ed.undo_push(message="add")
    return bpy.context.object


def edge_counts(ob):
    counts = np.zeros(len(ob.data.edges), int)
    for loop in ob.data.loops:
        counts[loop.edge_index] += 1
    return counts


@pytest.mark.parametrize('kind', PRIMITIVES)
def test_a_surface_is_what_its_numbers_say_and_stays_so_in_a_file(kind, tmp_path):
    ob = add_recipe(kind)
    recipe, value, name = table.RECIPES[kind], ob.data.splinewright.value, ob.name
    made = recipe.make(recipe.start, **recipe.defaults).value
    wanted = definitions.to_value(made) if isinstance(made, definitions.Definition) else made
    assert ob.type == 'MESH' and value == wanted
    require_exact(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "surface.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "surface.blend"))
    again = bpy.data.objects[name]
    assert again.data.splinewright.value == value and recipes.parameters(again.data) == recipe.defaults


@pytest.mark.parametrize('kind, settings', (('sphere', {}), ('torus', {}), ('cylinder', {'caps': True}), ('cone', {'caps': True}),
                                            ('cone', {'caps': True, 'top_radius': 0.5})))
def test_bodies_are_closed_and_their_normals_point_outwards(kind, settings):
    ob = add_recipe(kind, **settings)
    assert (edge_counts(ob) == 2).all()
    value = ob.data.splinewright.value
    patches = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value])
    assert patches.volume() > 0


def test_a_number_changed_in_the_panel_changes_the_mesh_and_undo_brings_it_back():
    ob = add_recipe('sphere')
    name, before = ob.name, ob.data.splinewright.value
    ob.data.splinewright_parameters.sphere_radius = 2.5
    assert np.allclose(np.linalg.norm(shape.points_of(ob.data), axis=1), 2.5, atol=1e-6)
    bpy.ops.ed.undo_push(message="radius")
    bpy.ops.ed.undo()
    assert bpy.data.objects[name].data.splinewright.value == before


@pytest.mark.parametrize('sweep', (2 * math.pi, math.pi / 2, -1.0))
def test_a_curve_is_revolved_about_the_axis_of_its_object(sweep):
    source = add(PROFILE)
    ob = add_recipe('revolve', sweep=sweep)
    patch = ob.data.splinewright.value
    assert patch.periodic[0] == (sweep == 2 * math.pi)
    points = patch.evaluate_grid(np.linspace(*patch.domain[0], 9), np.linspace(*patch.domain[1], 9))
    radii = np.linalg.norm(PROFILE.evaluate(np.linspace(*PROFILE.domain, 9), side='left')[:, :2], axis=1)
    assert np.allclose(np.linalg.norm(points[..., :2], axis=-1), radii, atol=1e-12)
    require_exact(ob)
    source.data.splinewright.value = PROFILE.with_points(PROFILE.points * (2, 1, 1))
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != patch and follow.problem(ob.data) == ""


@pytest.mark.parametrize('place', ((-5.65, 0, 0), (1 / 3, -0.1, 7.7)))
def test_where_a_profile_was_placed_changes_no_digit_and_its_end_on_the_axis_stays_a_pole(place):
    profile = sc.BezierCurve([(0, 0, 0), (1.1, 0, 0.3), (0.7, 0, 1.9)])
    source = add(profile)
    source.location, source.rotation_euler, source.scale = place, (0.4, -0.3, -1.1), (1, 1, 1)
    bpy.context.view_layer.update()
    value = add_recipe('revolve').data.splinewright.value
    assert value == sc.build.revolve(profile, (0, 0, 0), (0, 0, 1))
    assert sc.PatchSet.from_patches([value]).edge_counts()['pole'] == 1


def test_a_surface_of_two_curves_follows_both_and_stays_when_one_goes():
    first, second = add(PROFILE, "first"), add(PROFILE.elevate(), "second")
    second.location.y = 3.0
    bpy.context.view_layer.update()
    activate(second, first)
    ob = add_recipe('ruled')
    patch = ob.data.splinewright.value
    assert patch.degree == (4, 1)
    for other in (first, second):
        before = ob.data.splinewright.value
        other.data.splinewright.value = other.data.splinewright.value.with_points(other.data.splinewright.value.points + (0, 0, 1))
        bpy.context.view_layer.update()
        assert ob.data.splinewright.value != before
    before = ob.data.splinewright.value
    bpy.data.objects.remove(first)
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value == before and "deleted" in follow.problem(ob.data)


def test_extruded_curves_of_several_pieces_are_one_object():
    add([PROFILE, PROFILE.with_points(PROFILE.points + (5, 0, 0))])
    ob = add_recipe('extrude', y=2.0, z=0.0)
    assert len(ob.data.splinewright.value) == 2
    require_exact(ob)


def test_what_cannot_be_made_is_refused_with_a_word():
    add(PROFILE)
    with pytest.raises(RuntimeError, match="."):
        add_recipe('extrude', x=0.0, y=0.0, z=0.0)
    activate(add(PROFILE), bpy.data.objects[0])
    assert not bpy.ops.splinewright.add_revolve.poll()
    with pytest.raises(RuntimeError, match=r"z\(u, v\)"):
        add_recipe('surface_formula', z="sin(t)")


def test_a_surface_cannot_follow_itself_by_a_curve_of_its_own():
    add(PROFILE)
    ob = add_recipe('revolve')
    activate(ob)
    assert not bpy.ops.splinewright.add_extrude.poll()


XY = np.array([(1, 0, 0), (2, 1, 0), (1, 2, 0)], float)


@pytest.mark.parametrize('points, axis', ((XY, 'y'), (XY[:, [0, 2, 1]], 'z'), (XY[:, [2, 0, 1]], 'z'),
                                          (XY + ((0, 0, 0), (0, 0, 0.5), (0, 0, 0)), 'z')))
def test_the_axis_is_the_one_that_the_profile_suggests(points, axis):
    add(sc.BezierCurve(points))
    ob = add_recipe('revolve')
    assert recipes.parameters(ob.data)['axis'] == axis
    bpy.data.objects.remove(ob)
    activate(bpy.data.objects[0])
    assert recipes.parameters(add_recipe('revolve', axis='x').data)['axis'] == 'x'


def test_the_axis_of_blenders_own_profile():
    bpy.ops.curve.primitive_bezier_curve_add()
    assert recipes.parameters(add_recipe('revolve').data)['axis'] == 'y'


def test_the_axis_may_lie_beside_the_origin_and_is_shown():
    ob = add(sc.BezierCurve([(1, 0, 0), (1, 0, 2)]))
    ob.location = (0, 0, 5)
    bpy.context.view_layer.update()
    made = add_recipe('revolve', axis='z', offset_x=3.0, offset_y=0.5)
    value = made.data.splinewright.value
    points = value.evaluate_grid(*(np.linspace(*domain, 9) for domain in value.domain))
    assert np.allclose(np.linalg.norm(points[..., :2] - (3, 0.5), axis=-1), np.hypot(2, 0.5), rtol=1e-12)
    bpy.context.view_layer.update()
    line = part('ui.axis_overlay').line_of(made)
    assert np.allclose(line[:, :2], (3, 0.5)) and line[0, 2] < 5 and line[1, 2] > 7
    assert part('ui.axis_overlay').line_of(ob) is None and part('ui.axis_overlay').line_of(None) is None


@pytest.mark.parametrize('kind, count', (('cylinder', 3), ('cone', 2)))
def test_solids_are_closed_unless_one_says_otherwise(kind, count):
    ob = add_recipe(kind)
    edges = {}
    for polygon in ob.data.polygons:
        for edge in polygon.edge_keys:
            edges[edge] = edges.get(edge, 0) + 1
    assert len(ob.data.splinewright.value) == count and set(edges.values()) == {2}
    assert isinstance(add_recipe(kind, caps=False).data.splinewright.value, sc.NurbsPatch)
