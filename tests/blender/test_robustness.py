"""What once went wrong, or nearly: coarse meshes, second assignments, absurd sizes, odd files."""

import json

import bpy
import numpy as np
import pytest

from shapes import VALUES, add
from support import corner_normals, part, scene_state, splinecore as sc

store = part('bridge.data.store')
SQUARE = np.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]], float)


def mesh_of(value, resolution=(12, 12)):
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.set_resolution(*resolution)
    mesh.splinewright.value = value
    return mesh


def ring(count):
    return sc.NurbsPatch((2, 1), (np.arange(count + 1.0), [0, 0, 1, 1]),
                         [[(np.cos(a), np.sin(a), z) for z in (0, 1)] for a in np.arange(count) * 2 * np.pi / count],
                         periodic=(True, False))


COARSE = {
    'teapot 1 x 1': (lambda: part('core.shape.starters').teapot(), (1, 1)),
    'teapot 1 x 2': (lambda: part('core.shape.starters').teapot(), (1, 2)),
    'two points around': (lambda: ring(2), (1, 1)),
    'three points around': (lambda: ring(3), (1, 1)),
    'the same patch twice': (lambda: sc.PatchSet.from_patches([sc.BezierPatch(SQUARE)] * 2), (1, 1)),
    'seen from both sides': (lambda: sc.PatchSet.from_patches([sc.BezierPatch(SQUARE), sc.BezierPatch(SQUARE).swapped()]), (1, 1)),
    'u meets v at other counts': (lambda: sc.PatchSet.from_patches(
        [sc.BezierPatch(SQUARE), sc.BezierPatch((SQUARE + (1, 0, 0)).swapaxes(0, 1))]), (40, 1)),
    'opposite corners are one': (lambda: sc.BezierPatch([[(0, 0), (0, 1)], [(1, 0), (0, 0)]]), (2, 2)),
}


@pytest.mark.parametrize('make, resolution', COARSE.values(), ids=COARSE)
def test_the_coarsest_mesh_is_valid(make, resolution):
    mesh = mesh_of(make(), resolution)
    assert len(mesh.polygons) > 0 and not mesh.validate()
    used = {v for polygon in mesh.polygons for v in polygon.vertices}
    assert used == set(range(len(mesh.vertices))), "a vertex belongs to no face"


def test_a_patch_shrunk_to_a_point_is_refused():
    with pytest.raises(ValueError, match="no face"):
        mesh_of(sc.BezierPatch(np.zeros((2, 2, 3))), (1, 1))


def test_a_pole_of_points_with_other_weights_is_one_vertex():
    fan = sc.BezierPatch([[(0, 0), (0, 0)], [(1, 0), (0, 1)]], [[1, 2], [1, 1]])
    mesh = mesh_of(fan, (3, 3))
    assert len(mesh.vertices) == 1 + 3 * 4 and not mesh.validate()


def test_normals_uvs_and_winding_are_right_after_a_second_assignment():
    flat = np.stack([*np.meshgrid([0.0, 1, 2], [0.0, 1, 2], indexing='ij'), np.zeros((3, 3))], -1)
    angle = 1.5
    turn = np.array([[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]])
    mesh = mesh_of(sc.BezierPatch(flat))
    mesh.splinewright.value = sc.BezierPatch(flat @ turn.T)
    assert np.allclose(corner_normals(mesh), turn @ (0, 0, 1), atol=1e-3)
    for polygon in mesh.polygons:
        assert np.allclose(polygon.normal, turn @ (0, 0, 1), atol=1e-5)


def test_what_a_user_did_to_the_faces_is_put_right_by_restoring():
    bpy.ops.splinewright.add_bezier_patch()
    ob = bpy.context.object
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.mesh.flip_normals()
    bpy.ops.object.mode_set(mode='OBJECT')
    mesh = ob.data
    mesh.uv_layers.remove(mesh.uv_layers[0])
    mesh.polygons[1].use_smooth = False
    with pytest.raises(ValueError, match="changed by hand"):
        mesh.splinewright.value = mesh.splinewright.value
    bpy.ops.splinewright.restore()
    assert all(polygon.normal.z > 0 for polygon in mesh.polygons)
    assert len(mesh.uv_layers) == 1
    assert not mesh.polygons[1].use_smooth, "how a face looks is its user's"


@pytest.mark.parametrize('call', (
    lambda: bpy.ops.splinewright.add_teapot(size=3e38),
    lambda: bpy.ops.splinewright.add_hermite_patch(count_u=100_000, count_v=100_000),
    lambda: bpy.ops.splinewright.add_nurbs_patch(count_u=100_000, count_v=100_000),
    lambda: bpy.ops.splinewright.add_nurbs_curve(degree=255, count=20_000),
    lambda: bpy.ops.splinewright.add_bezier_patch(resolution_u=4096, resolution_v=4096),
), ids=('size', 'hermite counts', 'nurbs counts', 'degree and count', 'resolution'))
def test_absurd_sizes_are_reported_and_the_scene_is_unchanged(call):
    before = scene_state()
    with pytest.raises(RuntimeError, match="farther away|too many|lower the resolution"):
        call()
    assert scene_state() == before


def test_points_beyond_float32_are_refused_for_curves_too():
    with pytest.raises(ValueError, match="farther away"):
        bpy.data.curves.new("curve", 'CURVE').splinewright.value = sc.BezierCurve([(0, 0), (1e39, 0)])


@pytest.mark.parametrize('weights, pieces', (([0, 1, 1], 1), ([1, -1, 1], 2), ([1, -2, 1], 3)))
def test_a_curve_through_infinity_is_shown_at_the_lowest_resolution(weights, pieces):
    data = bpy.data.curves.new("curve", 'CURVE')
    data.splinewright.set_resolution(1, 1)
    data.splinewright.value = sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights)
    assert len(data.splines) == pieces


def test_texts_and_surfaces_take_no_curve():
    for kind, noun in (('FONT', "a text"), ('SURFACE', "a surface of Blender's own")):
        with pytest.raises(TypeError, match=f"is {noun}: curves are shown by a curve object"):
            bpy.data.curves.new("data", kind).splinewright.value = sc.BezierCurve([(0, 0), (1, 1)])


DAMAGE = (('"degree": [1, 2]', '"degree": ["a", "b"]'), ('"degree": [1, 2]', '"degree": [1.5, 2]'),
          ('"degree": [1, 2]', '"degree": [-1, 2]'), ('"knots": [4, 4]', '"knots": [0, 8]'),
          ('"periodic": [false, true]', '"periodic": ["x", null]'), ('[{', '[' * 100_000 + '{'))


@pytest.mark.parametrize('old, new', DAMAGE)
def test_no_damage_breaks_the_panel_or_the_settings(old, new):
    mesh = mesh_of(sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 1, 2, 3]), np.random.default_rng(1).uniform(size=(2, 3, 3)),
                                 periodic=(False, True)))
    text = mesh[store.KEY]['structure']
    assert old in text
    mesh[store.KEY]['structure'] = text.replace(old, new)
    with pytest.raises(store.UnreadableDefinition, match="damaged"):
        store.read(mesh)
    mesh.splinewright.resolution_u = 3
    assert "damaged" in mesh.splinewright.problem


@pytest.mark.parametrize('make', VALUES.values(), ids=VALUES)
def test_what_is_stored_of_pieces_is_json_of_all_of_them_at_once(make):
    data = add(make()).data
    assert data[store.KEY]['structure'] == json.dumps([
        {'kind': piece.kind, 'shape': list(piece.indices.shape), 'degree': list(piece.degree),
         'periodic': [bool(axis) for axis in piece.periodic], 'knots': [len(knots) for knots in piece.knots]}
        for piece in store.read(data).pieces])


@pytest.mark.parametrize('version', ("2", 2.5, 0))
def test_a_version_that_is_none_is_damage(version):
    mesh = mesh_of(sc.BezierPatch(SQUARE))
    mesh[store.KEY]['version'] = version
    with pytest.raises(store.UnreadableDefinition, match="damaged"):
        store.read(mesh)


def test_a_problem_is_forgotten_when_a_value_is_assigned():
    mesh = mesh_of(sc.BezierPatch(SQUARE))
    mesh[store.KEY]['structure'] = "["
    mesh.splinewright.resolution_u = 3
    assert mesh.splinewright.problem
    mesh.splinewright.value = sc.BezierPatch(SQUARE)
    assert mesh.splinewright.problem == ""


def test_imported_shapes_stay_apart_where_edit_mode_is_preferred(tmp_path):
    path = tmp_path / "two.json"
    path.write_text(sc.dumps([sc.BezierPatch(SQUARE), sc.BezierPatch(SQUARE + 2.0)]))
    edit = bpy.context.preferences.edit
    before = edit.use_enter_edit_mode
    try:
        edit.use_enter_edit_mode = True
        bpy.ops.splinewright.import_json(filepath=str(path))
    finally:
        edit.use_enter_edit_mode = before
    assert len(bpy.data.objects) == 2 and len(bpy.context.selected_objects) == 2
    bpy.context.scene.cursor.location = (1, 2, 3)
    bpy.ops.splinewright.import_json(filepath=str(path))
    assert all(tuple(ob.location) == (0, 0, 0) for ob in bpy.data.objects), "coordinates of a file are those of the world"


def test_a_path_relative_to_the_blend_file_is_understood(tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    bpy.ops.splinewright.add_bezier_patch()
    bpy.ops.splinewright.export_bpt(filepath="//patch.bpt")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["patch.bpt", "scene.blend"]
    assert bpy.ops.splinewright.import_bpt(filepath="//patch.bpt") == {'FINISHED'}


def test_a_byte_order_mark_and_windows_lines_are_read_and_foreign_digits_are_not(tmp_path):
    text = "1\n1 1\n0 0 0\n0 1 1\n1 0 1\n1 1 0\n"
    path = tmp_path / "patch.bpt"
    path.write_bytes(text.replace('\n', '\r\n').encode('utf-8-sig'))
    assert bpy.ops.splinewright.import_bpt(filepath=str(path)) == {'FINISHED'}
    for wrong in ("1_0", "١"):
        path.write_text(text.replace("1 1 0", f"{wrong} 1 0"), encoding='utf-8')
        with pytest.raises(RuntimeError, match="is not a coordinate"):
            bpy.ops.splinewright.import_bpt(filepath=str(path))


def test_the_panel_text_of_every_kind_tells_degree_counts_and_knots():
    lines, definition = part('core.shape.describe').lines, part('core.shape.definition').from_value
    patch = sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 1, 2, 3]), np.ones((2, 3, 3)), periodic=(False, True))
    assert lines(definition(patch)) == [
        ("Kind", "NURBS patch"), ("Degree", "1 × 2"), ("Points", "2 × 3"), ("Knots U", "4, clamped"), ("", "0 0 1 1"),
        ("Knots V", "4, periodic"), ("", "0 1 2 3")]
    nearly = sc.NurbsCurve(1, [4.1e-17, 4.1e-17, 1e-9, 1, 1], np.ones((3, 3)))
    assert ("", "0 0 1e-09 1 1") in lines(definition(nearly)), "rounding is nothing"
    assert lines(definition(sc.BezierCurve(np.eye(3), [1, 0, 1]))) == [
        ("Kind", "Bezier curve"), ("Degree", "2"), ("Points", "3"), ("Weights", "rational")]
    assert lines(definition(sc.HermiteCurve(np.eye(3), np.eye(3))))[:2] == [("Kind", "Hermite curve"), ("Degree", "3")]
    assert lines(definition([sc.BezierCurve(np.eye(3))] * 2)) == [
        ("Kind", "2 Bezier curves"), ("Degrees", "2"), ("Points", "6 in the pool")]
