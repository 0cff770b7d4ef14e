import math

import bpy
import numpy as np
import pytest

from support import corner_normals, curve_points, part, scene_state, splinecore as sc, vertices

CURVES = {
    'add_line': sc.NurbsCurve,
    'add_bezier_chain': sc.HermiteCurve,
    'add_bezier_curve': sc.BezierCurve,
    'add_hermite_curve': sc.HermiteCurve,
    'add_nurbs_curve': sc.NurbsCurve,
}
PATCHES = {
    'add_bezier_patch': sc.BezierPatch,
    'add_hermite_patch': sc.HermitePatch,
    'add_nurbs_patch': sc.NurbsPatch,
    'add_teapot': sc.PatchSet,
}


def add(name, **settings):
    assert getattr(bpy.ops.splinewright, name)(**settings) == {'FINISHED'}
    return bpy.context.object


@pytest.mark.parametrize('name, kind', CURVES.items())
def test_a_curve_operator_makes_a_curve_object_of_exact_points(name, kind):
    ob = add(name)
    value = ob.data.splinewright.value
    assert ob.type == 'CURVE' and ob.select_get() and isinstance(value, kind)
    assert ob.data.splinewright.mode == 'AUTOMATIC'
    (points, closed), = value.polylines(part('bridge.data.tessellate').steps_of(ob.data, value))
    spline, = ob.data.splines
    assert spline.type == 'POLY' and spline.use_cyclic_u == closed
    assert np.array_equal(curve_points(spline), points.astype(np.float32))


@pytest.mark.parametrize('name, kind', PATCHES.items())
def test_a_patch_operator_makes_a_smooth_mesh_with_uvs_and_exact_normals(name, kind):
    ob = add(name, resolution_u=6)
    mesh, value = ob.data, ob.data.splinewright.value
    assert ob.type == 'MESH' and isinstance(value, kind)
    patch_set = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value], merge=False)
    settings = mesh.splinewright
    plan = sc.Tessellation(patch_set, (settings.resolution_u, settings.resolution_v))
    positions, normals = plan.evaluate(patch_set)
    assert np.array_equal(vertices(mesh), positions)
    assert all(polygon.use_smooth for polygon in mesh.polygons)
    uvs = np.array([item.uv for item in mesh.uv_layers.active.data])
    assert np.array_equal(uvs.astype(np.float32), plan.corner_uvs)
    tolerance = 1e-6 if part('bridge.data.versions').keeps_exact_normals else 1e-3
    assert np.abs(corner_normals(mesh) - normals).max() < tolerance
    assert not mesh.validate()


def test_degrees_counts_and_knots_reach_the_definition():
    curve = add('add_nurbs_curve', degree=5, count=9, knots='UNCLAMPED').data.splinewright.value
    assert (curve.degree, len(curve.points), curve.periodic) == (5, 9, False)
    assert np.array_equal(curve.knots, np.arange(15.0))
    patch = add('add_nurbs_patch', degree_u=2, degree_v=4, count_u=5, count_v=7, knots_u='PERIODIC').data.splinewright.value
    assert patch.degree == (2, 4) and patch.points.shape == (5, 7, 3) and patch.periodic == (True, False)
    assert add('add_bezier_curve', degree=11).data.splinewright.value.degree == 11
    for name in ('add_hermite_curve', 'add_bezier_chain'):
        chain = add(name, count=7, closed=True)
        assert chain.data.splines[0].use_cyclic_u and len(chain.data.splinewright.value.points) == 8
    line = add('add_line', count=4).data.splinewright.value
    assert line.degree == 1 and np.array_equal(line.points[:, 0], np.linspace(-1, 1, 4)) and not line.points[:, 1:].any()


def test_the_handles_of_a_bezier_chain_are_a_third_of_the_way_between_the_neighbors():
    value = add('add_bezier_chain', count=5).data.splinewright.value
    first, second = value.to_bezier()[:2]
    assert np.allclose(first.points[3] - first.points[2], second.points[1] - second.points[0])
    assert np.allclose(second.points[1] - second.points[0], (0.25, 0, 0))


def test_too_few_points_are_raised_to_what_the_degree_needs():
    curve = add('add_nurbs_curve', degree=7, count=3).data.splinewright.value
    assert len(curve.points) == 8


def test_size_scales_the_shape_and_keeps_its_knots():
    small = add('add_nurbs_curve', size=1.0).data.splinewright.value
    large = add('add_nurbs_curve', size=2.5).data.splinewright.value
    assert np.array_equal(large.knots, small.knots)
    np.testing.assert_allclose(large.points, 2.5 * small.points, rtol=1e-15)
    one = add('add_hermite_patch', size=1.0).data.splinewright.value
    three = add('add_hermite_patch', size=3.0).data.splinewright.value
    assert np.array_equal(three.tangents_u, 3.0 * one.tangents_u)


def test_a_shape_is_added_at_the_cursor_and_at_a_given_place():
    bpy.context.scene.cursor.location = (1, 2, 3)
    assert tuple(add('add_bezier_patch').location) == (1, 2, 3)
    ob = add('add_bezier_patch', location=(4, 5, 6), rotation=(0, 0, math.pi / 2))
    assert tuple(ob.location) == (4, 5, 6) and ob.rotation_euler.z == pytest.approx(math.pi / 2)


def test_a_shape_is_aligned_to_the_cursor_when_asked_or_preferred():
    bpy.context.scene.cursor.rotation_euler = (0.1, 0.2, 0.3)
    assert tuple(add('add_bezier_patch').rotation_euler) == (0, 0, 0)
    assert np.allclose(add('add_bezier_patch', align='CURSOR').rotation_euler, (0.1, 0.2, 0.3), atol=1e-6)
    edit = bpy.context.preferences.edit
    try:
        edit.object_align = 'CURSOR'
        assert np.allclose(add('add_bezier_curve').rotation_euler, (0.1, 0.2, 0.3), atol=1e-6)
        edit.object_align = 'VIEW'
        assert tuple(add('add_bezier_curve').rotation_euler) == (0, 0, 0), "there is no view in background"
    finally:
        edit.object_align = 'WORLD'


def test_the_enter_edit_mode_preference_is_followed():
    edit = bpy.context.preferences.edit
    before = edit.use_enter_edit_mode
    try:
        edit.use_enter_edit_mode = True
        assert add('add_bezier_curve').mode == 'EDIT'
    finally:
        edit.use_enter_edit_mode = before


def test_nothing_is_added_in_edit_mode_and_the_reason_is_told():
    add('add_bezier_patch')
    bpy.ops.object.mode_set(mode='EDIT')
    before = scene_state()
    with pytest.raises(RuntimeError, match="Leave Edit Mode first"):
        bpy.ops.splinewright.add_teapot()
    bpy.ops.object.mode_set(mode='OBJECT')
    assert scene_state() == before


def test_an_impossible_mesh_is_refused_and_the_scene_is_unchanged():
    before = scene_state()
    with pytest.raises(RuntimeError, match="lower the resolution"):
        bpy.ops.splinewright.add_nurbs_patch(count_u=100, count_v=100, resolution_u=4096, resolution_v=4096)
    assert scene_state() == before


@pytest.mark.parametrize('name', [*CURVES, *PATCHES])
def test_undo_takes_a_shape_away_and_redo_brings_it_back_exactly(name):
    bpy.ops.ed.undo_push(message="start")
    getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True)
    value = bpy.context.object.data.splinewright.value
    bpy.ops.ed.undo()
    assert not bpy.data.objects
    bpy.ops.ed.redo()
    assert bpy.data.objects[0].data.splinewright.value == value


@pytest.mark.parametrize('name', [*CURVES, *PATCHES])
def test_every_operator_property_has_a_name_and_a_description(name):
    operator = getattr(bpy.ops.splinewright, name)
    own = [p for p in operator.get_rna_type().properties
           if p.identifier not in ('rna_type', 'align', 'location', 'rotation')]
    assert own and all(p.name and p.description for p in own)
    assert operator.get_rna_type().description


def test_bevel_and_follow_path_work_on_a_curve_shape():
    ob = add('add_nurbs_curve')
    ob.data.bevel_depth = 0.1
    depsgraph = bpy.context.evaluated_depsgraph_get()
    tube = ob.evaluated_get(depsgraph).to_mesh()
    assert len(tube.polygons) > 100
    ob.evaluated_get(depsgraph).to_mesh_clear()
    follower = bpy.data.objects.new("follower", None)
    bpy.context.collection.objects.link(follower)
    constraint = follower.constraints.new('FOLLOW_PATH')
    constraint.target, constraint.use_fixed_location, constraint.offset_factor = ob, True, 1.0
    bpy.context.view_layer.update()
    place = follower.matrix_world.translation
    assert np.allclose(place, ob.data.splinewright.value.points[-1], atol=1e-5)
