"""obj.data.splinewright.value: the definition for scripts."""

import math

import bpy
import numpy as np
import pytest

from support import curve_points, part, splinecore as sc, vertices

store = part('bridge.data.store')

BIG = np.random.default_rng(4).uniform(-1, 1, (7, 3))
VALUES = {
    'bezier curve': lambda: sc.BezierCurve(BIG[:4], [1, 1 / 3, 0.1, 2]),
    'point at infinity': lambda: sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]),
    'hermite chain': lambda: sc.HermiteCurve(BIG[:3], BIG[3:6], [0, 0.1, 1 / 3]),
    'hermite with a corner': lambda: sc.HermiteCurve(BIG[:3], np.stack([BIG[3:6], BIG[1:4]], 1)),
    'nurbs curve': lambda: sc.NurbsCurve(3, [0, 0, 0, 0, 0.1, 1 / 3, 0.5, 1, 1, 1, 1], BIG, np.linspace(0.5, 2, 7)),
    'periodic': lambda: sc.NurbsCurve(3, np.cumsum(np.full(8, 1 / 3)), BIG, periodic=True),
    'bezier patch': lambda: sc.BezierPatch(BIG[:6].reshape(2, 3, 3), [[1, 2, 1], [1, 1 / 3, 1]]),
    'hermite patch': lambda: sc.HermitePatch(*[BIG[:4].reshape(2, 2, 3) + i for i in range(4)], parameters=([0, 0.1], [0, 3])),
    'nurbs patch': lambda: sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 1, 2, 3]), BIG[:6].reshape(2, 3, 3),
                                         periodic=(False, True)),
}


def data_for(value):
    if isinstance(value, (sc.BezierCurve, sc.HermiteCurve, sc.NurbsCurve, list)):
        return bpy.data.curves.new("curve", 'CURVE')
    return bpy.data.meshes.new("mesh")


def shown(data):
    if isinstance(data, bpy.types.Curve):
        return np.concatenate([curve_points(spline) for spline in data.splines])
    return vertices(data)


@pytest.mark.parametrize('make', VALUES.values(), ids=VALUES)
def test_what_is_assigned_comes_back_equal_in_every_bit(make):
    value = make()
    data = data_for(value)
    assert data.splinewright.value is None
    data.splinewright.value = value
    assert data.splinewright.value == value and data.splinewright.value.dumps() == value.dumps()
    assert len(shown(data)) > 0 and np.isfinite(shown(data)).all()


def test_a_list_of_curves_is_one_curve_object():
    curves = [VALUES['bezier curve'](), VALUES['hermite with a corner'](), VALUES['periodic']()]
    data = data_for(curves)
    data.splinewright.value = curves
    assert data.splinewright.value == curves and len(data.splines) == 3


def test_a_patch_set_keeps_its_pool_and_its_patches():
    hermite = VALUES['hermite patch']()
    value = sc.PatchSet.from_patches([hermite, VALUES['nurbs patch'](), VALUES['bezier patch']()])
    data = data_for(value)
    data.splinewright.value = value
    assert data.splinewright.value == value


@pytest.mark.parametrize('make', VALUES.values(), ids=VALUES)
def test_the_definition_survives_saving_and_opening(make, tmp_path):
    value = make()
    data = data_for(value)
    data.splinewright.value = value
    data.use_fake_user = True
    before, name, kind = shown(data).copy(), data.name, type(data)
    path = str(tmp_path / "shape.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    data = (bpy.data.curves if kind is bpy.types.Curve else bpy.data.meshes)[name]
    assert data.splinewright.value == value
    assert np.array_equal(shown(data), before)


def test_assigning_again_shows_the_new_shape_and_leaves_materials():
    mesh = bpy.data.meshes.new("mesh")
    mesh.materials.append(bpy.data.materials.new("paint"))
    mesh.splinewright.value = VALUES['bezier patch']()
    first = vertices(mesh).copy()
    mesh.splinewright.value = sc.BezierPatch(BIG[:6].reshape(2, 3, 3) + 1.0, [[1, 2, 1], [1, 1 / 3, 1]])
    assert np.allclose(vertices(mesh), first + 1.0, atol=1e-6)
    assert mesh.materials[0].name == "paint"
    mesh.splinewright.value = VALUES['nurbs patch']()
    assert mesh.materials[0].name == "paint" and not mesh.validate()


@pytest.mark.parametrize('longer', (True, False))
def test_a_definition_of_another_length_replaces_the_one_before(longer):
    lengths = (4, 4000) if longer else (4000, 4)
    data = bpy.data.curves.new("curve", 'CURVE')
    for length in lengths:
        value = sc.NurbsCurve(1, np.r_[0.0, np.arange(length), length - 1.0], np.random.default_rng(1).uniform(size=(length, 3)))
        data.splinewright.value = value
        assert data.splinewright.value == value


def test_resolution_evaluates_again_and_keeps_the_definition():
    bpy.ops.splinewright.add_nurbs_patch(faces_mode='COUNT')
    mesh = bpy.context.object.data
    value = mesh.splinewright.value
    mesh.splinewright.resolution_u = 3
    mesh.splinewright.resolution_v = 5
    assert len(mesh.polygons) == (3 * 3) * (3 * 5)
    assert mesh.splinewright.value == value and not mesh.validate()
    bpy.ops.splinewright.add_bezier_curve()
    curve = bpy.context.object.data
    curve.splinewright.resolution_u = 7
    assert len(curve.splines[0].points) == 8


def test_progress_is_told_after_evaluating_and_after_writing():
    shape, told = part('bridge.shape.shape'), []
    data = shape.new_data("mesh", VALUES['bezier patch'](), (4, 4), told.append)
    shape.rewrite(data, told.append)
    assert told == [1, 2, 1, 2] and shape.STEPS == 2


WRONG = {
    'a number': (3.5, TypeError, "float"),
    'text': ("curve", TypeError, "str"),
    'nothing': (None, TypeError, "NoneType"),
    'an empty list': ([], ValueError, "empty list"),
    'a list of numbers': ([1, 2], TypeError, r"value\[0\]"),
}


@pytest.mark.parametrize('value, error, text', WRONG.values(), ids=WRONG)
def test_anything_else_is_refused_and_nothing_changes(value, error, text):
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['bezier patch']()
    before = vertices(mesh).copy(), mesh.splinewright.value
    with pytest.raises(error, match=text):
        mesh.splinewright.value = value
    assert np.array_equal(vertices(mesh), before[0]) and mesh.splinewright.value == before[1]


def test_a_mesh_takes_no_curve_and_a_curve_no_patch():
    with pytest.raises(TypeError, match="is a mesh: curves are shown by a curve object"):
        bpy.data.meshes.new("mesh").splinewright.value = VALUES['bezier curve']()
    with pytest.raises(TypeError, match="is a curve: patches are shown by a mesh"):
        bpy.data.curves.new("curve", 'CURVE').splinewright.value = VALUES['bezier patch']()


def test_a_patch_through_infinity_is_refused_and_the_last_shape_stays():
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['bezier patch']()
    before = vertices(mesh).copy(), mesh.splinewright.value
    broken = sc.BezierPatch([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], [[1, 1], [-1, -1]])
    with pytest.raises(ArithmeticError, match="infinity"):
        mesh.splinewright.value = broken
    assert np.array_equal(vertices(mesh), before[0]) and mesh.splinewright.value == before[1]


def test_a_curve_through_infinity_is_shown_as_its_finite_pieces():
    data = bpy.data.curves.new("curve", 'CURVE')
    data.splinewright.value = sc.BezierCurve([(-1, 0), (0, 1), (1, 0)], [1, -2, 1])
    assert len(data.splines) == 3
    assert np.isfinite(shown(data)).all() and np.abs(shown(data)).max() < 1e6


def test_a_newer_definition_is_left_alone_and_said():
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['bezier patch']()
    before = vertices(mesh).copy()
    mesh[store.KEY]['version'] = store.VERSION + 1
    with pytest.raises(store.UnreadableDefinition, match="newer Splinewright"):
        mesh.splinewright.value
    mesh.splinewright.resolution_u = 3
    assert np.array_equal(vertices(mesh), before)
    assert "newer Splinewright" in mesh.splinewright.problem
    with pytest.raises(store.UnreadableDefinition, match="newer Splinewright"):
        mesh.splinewright.value = VALUES['nurbs patch']()
    assert mesh[store.KEY]['version'] == store.VERSION + 1 and np.array_equal(vertices(mesh), before)


def test_a_resolution_that_cannot_be_shown_is_said_and_the_mesh_stays():
    bpy.ops.splinewright.add_nurbs_patch(count_u=100, count_v=100, resolution_u=1, resolution_v=1)
    mesh = bpy.context.object.data
    count = len(mesh.vertices)
    mesh.splinewright.set_resolution(4096, 4096)
    assert "lower the resolution" in mesh.splinewright.problem and len(mesh.vertices) == count
    mesh.splinewright.set_resolution(1, 1)
    assert mesh.splinewright.problem == ""


@pytest.mark.parametrize('key', ('pool', 'indices', 'structure', 'knots', 'form'))
def test_a_damaged_definition_is_left_alone_and_said(key):
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['nurbs patch']()
    before = vertices(mesh).copy()
    del mesh[store.KEY][key]
    with pytest.raises(store.UnreadableDefinition, match="damaged"):
        mesh.splinewright.value
    mesh.splinewright.resolution_u = 3
    assert np.array_equal(vertices(mesh), before)


@pytest.mark.parametrize('old, new', (('"nurbs"', '"cube"'), ('"shape": [2, 3]', '"shape": [6]'), ('"degree": [1, 2]', '"degree": [1]'),
                                      ('"shape": [2, 3]', '"shape": [200000, 300000]'), ('[{', '')))
def test_a_damaged_structure_is_left_alone_and_said(old, new):
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['nurbs patch']()
    text = mesh[store.KEY]['structure']
    assert old in text
    mesh[store.KEY]['structure'] = text.replace(old, new)
    with pytest.raises(store.UnreadableDefinition, match="damaged"):
        mesh.splinewright.value


def test_a_copy_of_the_data_has_a_definition_of_its_own():
    mesh = bpy.data.meshes.new("mesh")
    mesh.splinewright.value = VALUES['bezier patch']()
    copy = mesh.copy()
    copy.splinewright.value = VALUES['nurbs patch']()
    assert mesh.splinewright.value == VALUES['bezier patch']() and copy.splinewright.value == VALUES['nurbs patch']()


def test_sphere_of_one_nurbs_patch_is_welded_at_its_seam_and_poles():
    half = math.sqrt(0.5)
    circle = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], float)
    arc = np.array([(0, -1), (1, -1), (1, 0), (1, 1), (0, 1)], float)
    points = np.array([[(x * r, y * r, z) for r, z in arc] for x, y in circle])
    weights = np.outer([1, half] * 4 + [1], [1, half, 1, half, 1])
    patch = sc.NurbsPatch((2, 2), ([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], [0, 0, 0, 1, 1, 2, 2, 2]), points, weights)
    mesh = bpy.data.meshes.new("sphere")
    mesh.splinewright.value = patch
    resolution = mesh.splinewright.resolution_u
    assert len(mesh.vertices) == 4 * resolution * (2 * resolution - 1) + 2
    assert np.allclose(np.linalg.norm(vertices(mesh), axis=1), 1.0, atol=1e-6)
    assert not any(edge.use_edge_sharp for edge in mesh.edges)
