"""A tessellation into a Mesh: faces, UVs, exact normals, sharp edges."""

import gc
from contextlib import contextmanager

import bmesh
import bpy
import numpy as np

from ..data import versions
from . import mesh_attributes, mesh_edges, mesh_layers, mesh_looks, mesh_sharp


def write(mesh, tessellation, positions, normals, sharp, has_faces=False):
    """Make the mesh the tessellation at these positions (v, 3), corner normals (c, 3), float32, and
    sharp edges (k, 2). Where the faces are the same as before only positions and normals change, which is the answer.
    What a user put on them stays, or is carried over to the new ones. has_faces: whether it is known to have these."""
    active = mesh_layers.active_attribute(mesh)
    stays = ((has_faces or _has_faces(mesh, tessellation)) and len(mesh.uv_layers) > 0
             and mesh_attributes.lies_as(mesh, tessellation))
    if stays:
        _write_positions(mesh, positions)
        mesh_looks.name_patches(mesh, tessellation.face_patches)
        flags = mesh_sharp.marked(mesh)
        users = mesh_sharp.of_users(mesh, flags)
    else:
        has_marks = _replace_faces(mesh, tessellation, positions)
        users = flags = mesh_sharp.marked(mesh) if has_marks else None
    flags = mesh_sharp.mark(mesh, sharp, users, flags)
    # Normals that are not exact are stored relative to those of the faces, which must be up to date.
    mesh.update()
    _write_normals(mesh, mesh_looks.shaded_normals(mesh, normals), tessellation.corner_vertices)
    # Before 4.5, too, Blender marks edges sharp where normals differ.
    mesh_sharp.note(mesh, users, flags if versions.keeps_exact_normals else mesh_sharp.marked(mesh))
    mesh_layers.have_normals_back(mesh)
    mesh_layers.set_active_attribute(mesh, active)
    mesh.update()
    return stays


def move(mesh, positions):
    """Give the vertices other positions, float32. Normals are Blender's own, turned as they were or not, until the next
    write(): exact ones would be most of a drag's work."""
    _write_positions(mesh, positions)
    if versions.has_auto_smooth:
        mesh.use_auto_smooth = False    # Blender 3.4 would spend most of a drag on it
    if versions.keeps_exact_normals and mesh_layers.NORMALS in mesh.attributes:
        mesh_layers.put_away_normals(mesh)      # they are of another shape
    mesh.update()


def let_normals_turn(mesh):
    """Keep the normals relative to those that Blender finds, for points that are moved by others."""
    flat = np.empty(3 * len(mesh.loops), np.float32)
    if versions.has_auto_smooth:
        mesh.calc_normals_split()
        mesh.loops.foreach_get('normal', flat)
    else:
        mesh.corner_normals.foreach_get('vector', flat)
    active = mesh_layers.active_attribute(mesh)
    if versions.keeps_exact_normals and mesh_layers.NORMALS in mesh.attributes:
        mesh_layers.remove(mesh, mesh_layers.NORMALS)
    _set_split_normals(mesh, flat.reshape(-1, 3), mesh_layers.corner_vertices(mesh))
    mesh_layers.have_normals_back(mesh)
    mesh_layers.set_active_attribute(mesh, active)


def _has_faces(mesh, tessellation):
    """Whether the mesh has these very faces; a user may have changed them."""
    corners = tessellation.corner_vertices
    if (len(mesh.vertices), len(mesh.loops), len(mesh.polygons)) != (
            tessellation.vertex_count, len(corners), len(tessellation.face_starts)):
        return False
    if not np.array_equal(mesh_layers.corner_vertices(mesh), corners):
        return False
    return np.array_equal(mesh_layers.read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0], tessellation.face_starts)


def _write_positions(mesh, positions):
    flat = np.ascontiguousarray(positions, np.float32).ravel()
    if 'position' in mesh.attributes:
        mesh.attributes['position'].data.foreach_set('vector', flat)
    else:
        mesh.vertices.foreach_set('co', flat)


def _replace_faces(mesh, tessellation, positions):
    """Whether edges of the new faces have marks."""
    owner, (looks, uneven) = owner_of(mesh), mesh_looks.kept(mesh)
    kept = mesh_attributes.keep(mesh, owner, uneven)
    _clear(mesh)
    _write_faces(mesh, tessellation, positions)
    mesh_looks.name_patches(mesh, tessellation.face_patches)
    mesh_looks.set_looks(mesh, looks)
    mesh_attributes.write_parameters(mesh, tessellation)
    if mesh_attributes.has_room_for_ours(kept):
        _write_uvs(mesh, tessellation)
    if kept is not None:
        mesh_attributes.restore(mesh, owner, kept)
    return kept is not None and len(kept.marks) > 0


def _clear(mesh):
    """Take all geometry away. Blender's clear_geometry() takes keys and drivers along."""
    empty = bmesh.new()
    empty.to_mesh(mesh)
    empty.free()


def owner_of(mesh):
    """An object of the mesh that has vertex groups, or None."""
    if not mesh.users:
        return None
    return next((ob for ob in bpy.data.objects if ob.data == mesh and ob.vertex_groups), None)


def _write_faces(mesh, tessellation, positions):
    starts, corners = tessellation.face_starts, tessellation.corner_vertices
    mesh.vertices.add(tessellation.vertex_count)
    mesh.loops.add(len(corners))
    mesh.polygons.add(len(starts))
    _write_positions(mesh, positions)
    mesh.loops.foreach_set('vertex_index', corners)
    mesh.polygons.foreach_set('loop_start', starts)
    if versions.wants_face_totals:
        mesh.polygons.foreach_set('loop_total', np.diff(np.append(starts, len(corners))).astype(np.int32))
    mesh_edges.calculate(mesh)


def _write_uvs(mesh, tessellation):
    data, field = mesh_layers.uv_of(mesh.uv_layers.new(name=mesh_layers.UV_NAME, do_init=False))
    data.foreach_set(field, tessellation.corner_uvs.ravel())


def _write_normals(mesh, normals, vertices):
    flat = np.ascontiguousarray(normals, np.float32)
    if versions.keeps_exact_normals:
        attribute = mesh.attributes.get(mesh_layers.NORMALS)
        if attribute is not None and (attribute.data_type, attribute.domain) != ('FLOAT_VECTOR', 'CORNER'):
            mesh_layers.remove(mesh, mesh_layers.NORMALS)
            attribute = None
        if attribute is None:
            attribute = mesh.attributes.new(mesh_layers.NORMALS, 'FLOAT_VECTOR', 'CORNER')
        attribute.data.foreach_set('vector', flat.ravel())
        return
    if versions.has_auto_smooth:
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = np.pi
    _set_split_normals(mesh, flat, vertices)


def _set_split_normals(mesh, normals, vertices):
    """Blender's own way to take normals of corners (c, 3), by lists: those of vertices, a quarter as many, where all corners
    of each agree, with the same result. vertices: (c,) of the corners."""
    of_vertices = np.zeros((len(mesh.vertices), 3), np.float32)
    of_vertices[vertices] = normals
    with _uncollected():
        if np.array_equal(of_vertices[vertices], normals):
            mesh.normals_split_custom_set_from_vertices(of_vertices.tolist())
        else:
            mesh.normals_split_custom_set(normals.tolist())


@contextmanager
def _uncollected():
    """While millions of lists are made: to look for garbage among them would be most of the work."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()
