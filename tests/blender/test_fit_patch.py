"""Patches through grids of faces and near selected vertices."""

import bpy
import numpy as np
import pytest
from mathutils import Euler, Matrix

from curves import said_near
from shapes import op, require_exact
from support import splinecore as sc
from test_curve_through import value


def mesh_in_edit_mode(points, faces=()):
    mesh = bpy.data.meshes.new("Points")
    mesh.from_pydata(np.array(points).tolist(), [], [list(map(int, face)) for face in faces])
    ob = bpy.data.objects.new("Points", mesh)
    bpy.context.collection.objects.link(ob)
    for other in bpy.context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    return ob


def quads(nu, nv, closed=(False, False)):
    at = np.arange(nu * nv).reshape(nu, nv)
    return [(at[i, j], at[(i + 1) % nu, j], at[(i + 1) % nu, (j + 1) % nv], at[i, (j + 1) % nv])
            for i in range(nu - (not closed[0])) for j in range(nv - (not closed[1]))]


def grid(nu, nv, closed=(False, False)):
    if closed[0]:
        a, z = np.meshgrid(2 * np.pi * np.arange(nu) / nu, 2 * np.pi * np.arange(nv) / nv, indexing='ij')
        radius = 2 + (np.cos(z) if closed[1] else 0.3 * np.sin(2 * z))
        return np.stack([radius * np.cos(a), radius * np.sin(a), np.sin(z) if closed[1] else z], -1)
    u, v = np.meshgrid(np.linspace(0, 3, nu), np.linspace(0, 2, nv), indexing='ij')
    return np.stack([u, v, 0.4 * np.sin(2 * u) * np.cos(v)], -1)


@pytest.mark.parametrize('counts', [(2, 2), (2, 7), (6, 5)])
@pytest.mark.parametrize('closed', [(False, False), (True, False), (True, True)])
def test_a_patch_goes_through_a_grid(counts, closed):
    counts = tuple(max(count, 5) if each else count for count, each in zip(counts, closed))
    points = grid(*counts, closed).astype(np.float32).astype(np.float64)
    order = np.random.default_rng(2).permutation(len(points.reshape(-1, 3)))
    faces = np.argsort(order)[np.array(quads(*counts, closed))]
    source = mesh_in_edit_mode(points.reshape(-1, 3)[order], np.random.default_rng(3).permutation(faces))
    source.location = 1, 2, 3
    assert op(bpy.ops.splinewright.patch_through_grid) == {'FINISHED'}
    made = bpy.context.object
    require_exact(made)
    assert made.location[:] == (1, 2, 3) and sorted(value(made).periodic) == sorted(closed)
    assert value(made).nearest(points.reshape(-1, 3)).distances.max() < 1e-6


@pytest.mark.parametrize('faces, message', (
    ([(0, 1, 2)], "four corners"), ([], "select faces"), (quads(3, 3)[:3], "some are missing"),
    ([(0, 1, 4, 3), (4, 5, 8, 7)], "hang together")))
def test_what_is_no_grid_is_refused(faces, message):
    source = mesh_in_edit_mode(grid(3, 3).reshape(-1, 3), faces)
    before = len(bpy.data.objects), len(bpy.data.meshes)
    with pytest.raises(RuntimeError, match=message):
        op(bpy.ops.splinewright.patch_through_grid)
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == before and source.mode == 'EDIT'
    bpy.ops.object.mode_set(mode='OBJECT')


def scan():
    u, v = np.random.default_rng(4).uniform(0, 1, (2, 900))
    return np.stack([4 * u, 3 * v, 0.5 * np.sin(4 * u) * np.cos(3 * v)], -1)


@pytest.mark.parametrize('wanted', (dict(count_u=9, count_v=7), dict(by='TOLERANCE', tolerance=0.015625, smoothing=0.0)))
def test_a_patch_near_a_scan(wanted):
    source = mesh_in_edit_mode(scan())
    points = np.array([vertex.co for vertex in source.data.vertices])
    assert op(bpy.ops.splinewright.fit_patch, **wanted) == {'FINISHED'}
    made = bpy.context.object
    require_exact(made)
    assert value(made).nearest(points).distances.max() < 0.02
    if 'count_u' in wanted:
        assert value(made).points.shape[:2] == (9, 7)


@pytest.mark.parametrize('scale', ((2, 2, 2), (3, 3, 1), (-3, 2, 4)))
def test_the_tolerance_holds_in_the_scene_whatever_the_scale(scale, capfd):
    source = mesh_in_edit_mode(scan())
    source.matrix_world = Matrix.LocRotScale((1, 2, 3), Euler((0.3, -1.1, 2.0)).to_quaternion(), scale)
    bpy.context.view_layer.update()
    points = np.array([source.matrix_world @ vertex.co for vertex in source.data.vertices])
    assert op(bpy.ops.splinewright.fit_patch, by='TOLERANCE', tolerance=0.0625, smoothing=1e-9) == {'FINISHED'}
    made = bpy.context.object
    missed = value(made).transformed(np.array(made.matrix_world)).nearest(points).distances.max()
    assert said_near(capfd.readouterr().out) == (value(made).points[..., 0].size, pytest.approx(missed, rel=1e-3))
    assert 1e-3 < missed <= 0.0625 * (1 + 1e-6) and np.allclose(made.matrix_world.to_scale(), 1)


def test_through_a_grid_of_a_scaled_mesh(capfd):
    points = grid(6, 5)
    source = mesh_in_edit_mode(points.reshape(-1, 3), quads(6, 5))
    source.scale = (-2, 3, 1)
    bpy.context.view_layer.update()
    there = np.array([source.matrix_world @ vertex.co for vertex in source.data.vertices])
    assert op(bpy.ops.splinewright.patch_through_grid) == {'FINISHED'}
    made = bpy.context.object
    count, distance = said_near(capfd.readouterr().out)
    assert count == 30 and distance < 1e-13
    assert value(made).transformed(np.array(made.matrix_world)).nearest(there).distances.max() < 2e-6
    require_exact(made)


@pytest.mark.parametrize('scale', ((1, 1, 1), (2, 3, 1), (-2, 3, 1), (-1, -1, -1), (1, -2, -3)))
def test_normals_are_on_the_side_of_the_faces(scale):
    source = mesh_in_edit_mode(grid(6, 5).reshape(-1, 3), quads(6, 5))
    source.scale = scale
    bpy.context.view_layer.update()
    outside = source.matrix_world.to_3x3().inverted().transposed() @ source.data.polygons[7].normal
    assert op(bpy.ops.splinewright.patch_through_grid, degree_u=2, degree_v=1) == {'FINISHED'}
    made = bpy.context.object
    normals = np.array([made.matrix_world.to_3x3() @ face.normal for face in made.data.polygons])
    assert (normals @ np.array(outside) > 0).all()


def test_few_vertices_and_lines_are_refused():
    for points, message in (([[0, 0, 0], [1, 0, 0]], "three vertices"), (np.outer(np.arange(9), [1, 2, 3]), "on a line")):
        mesh_in_edit_mode(points)
        with pytest.raises(RuntimeError, match=message):
            op(bpy.ops.splinewright.fit_patch)
        bpy.ops.object.mode_set(mode='OBJECT')
    mesh_in_edit_mode(scan()[:40])
    with pytest.raises(RuntimeError, match="do not determine control point"):
        op(bpy.ops.splinewright.fit_patch, count_u=20, count_v=20, smoothing=0.0)
    with pytest.raises(RuntimeError, match="along v: count = 4 control points are fewer than the 5 that degree 4 needs"):
        op(bpy.ops.splinewright.fit_patch, count_u=5, count_v=4, degree_u=4, degree_v=4)
    bpy.ops.object.mode_set(mode='OBJECT')


@pytest.mark.parametrize('name', ('fit_patch', 'patch_through_grid'))
def test_undo_takes_it_back_and_redo_does_it_again(name):
    source = mesh_in_edit_mode(grid(9, 8).reshape(-1, 3), quads(9, 8)).name
    bpy.ops.ed.undo_push(message="mesh")
    assert op(getattr(bpy.ops.splinewright, name)) == {'FINISHED'}
    made, wanted = bpy.context.object.name, value(bpy.context.object)
    bpy.ops.ed.undo()
    assert made not in bpy.data.objects and bpy.data.objects[source].mode == 'EDIT'
    bpy.ops.ed.redo()
    assert value(bpy.data.objects[made]) == wanted and bpy.context.mode == 'OBJECT'
