import bpy
import numpy as np
import pytest

from support import corner_normals, part, splinecore as sc, vertices


@pytest.fixture
def teapot():
    bpy.ops.splinewright.add_teapot(faces_mode='COUNT')
    return bpy.context.object


def test_the_teapot_is_one_object_of_32_patches_on_306_points(teapot):
    value = teapot.data.splinewright.value
    assert len(bpy.data.objects) == 1
    assert isinstance(value, sc.PatchSet) and len(value) == 32
    assert all(value[i].degree == (3, 3) for i in range(32))
    assert value.points.shape == (306, 3)


def test_52_edges_are_shared_16_are_free_and_8_are_poles(teapot):
    assert teapot.data.splinewright.value.edge_counts() == {'shared': 52, 'free': 16, 'pole': 8}


def test_vertices_are_shared_along_the_edges(teapot):
    mesh = teapot.data
    resolution = mesh.splinewright.resolution_u
    uses = np.zeros(len(mesh.edges), int)
    for polygon in mesh.polygons:
        for loop in polygon.loop_indices:
            uses[mesh.loops[loop].edge_index] += 1
    assert set(uses) == {1, 2}
    assert np.count_nonzero(uses == 1) == 16 * resolution
    places = {tuple(co) for co in vertices(mesh)}
    # The handle is joined to itself and the lid lies on the body, but no shared vertex is there twice.
    interior = len(mesh.vertices) - len(places)
    assert interior <= 4 * resolution


def test_poles_are_single_vertices_with_triangles_around_them(teapot):
    mesh = teapot.data
    triangles = [p for p in mesh.polygons if len(p.vertices) == 3]
    assert len(triangles) == 8 * mesh.splinewright.resolution_u
    top = {v for p in triangles for v in p.vertices if abs(mesh.vertices[v].co.z - 1.575) < 1e-6}
    assert len(top) == 1


def test_normals_point_outward_and_are_exact(teapot):
    mesh, value = teapot.data, teapot.data.splinewright.value
    normals, co = corner_normals(mesh), vertices(mesh)
    assert np.isfinite(normals).all()
    plan = sc.Tessellation(value, (mesh.splinewright.resolution_u, mesh.splinewright.resolution_v))
    tolerance = 1e-6 if part('bridge.data.versions').keeps_exact_normals else 1e-3
    assert np.abs(normals - plan.evaluate(value)[1]).max() < tolerance
    corners = np.array([loop.vertex_index for loop in mesh.loops])
    starts = np.append(plan.face_starts, len(corners))
    volume = np.zeros(32)
    for patch, begin, end in zip(plan.face_patches, starts, starts[1:]):
        face = co[corners[begin:end]]
        flat = sum(np.cross(face[k] - face[0], face[k + 1] - face[0]) for k in range(1, len(face) - 1))
        assert flat @ normals[begin:end].mean(0) > 0, "a face is wound against its normals"
        volume[patch] += face[0] @ flat / 6
    assert (volume > 0).all()


def test_the_lid_has_its_normal_straight_up_at_the_pole(teapot):
    mesh = teapot.data
    top = max(range(len(mesh.vertices)), key=lambda v: mesh.vertices[v].co.z)
    normals = corner_normals(mesh)
    at_top = [normals[loop.index] for loop in mesh.loops if loop.vertex_index == top]
    assert len(at_top) >= 40
    assert np.allclose(at_top, (0, 0, 1), atol=1e-3)


def test_patches_that_meet_at_an_angle_are_sharp_there():
    roof = np.array([(x, y, 1 - abs(x)) for x in (-1, 0, 1) for y in (0, 1)], float)
    patches = [np.array([[0, 1], [2, 3]]), np.array([[2, 3], [4, 5]])]
    mesh = bpy.data.meshes.new("roof")
    mesh.splinewright.value = sc.PatchSet(roof, patches)
    ridge = [e for e in mesh.edges if e.use_edge_sharp]
    assert len(ridge) == mesh.splinewright.resolution_v
    assert all(abs(mesh.vertices[v].co.x) < 1e-6 for e in ridge for v in e.vertices)
    mesh.splinewright.sharp_angle = 2.0
    # Where normals are kept as angles, Blender itself makes an edge sharp that carries two custom normals.
    assert any(e.use_edge_sharp for e in mesh.edges) == (not part('bridge.data.versions').keeps_exact_normals)
