"""What identifies the geometry that Splinewright wrote, to notice what others changed since."""

import zlib

import bpy
import numpy as np

from ..core import checksum


def of(data):
    """Counts and checksums of a Mesh's or Curve's geometry: whole numbers."""
    return _of_curve(data) if isinstance(data, bpy.types.Curve) else _of_mesh(data)


def same_topology(a, b):
    """Whether two stamps are of geometry that differs in positions only."""
    positions = 2 if len(a) == 3 else 3
    return len(a) == len(b) and all(x == y for i, (x, y) in enumerate(zip(a, b)) if i != positions)


def is_of_faces(stamp, tessellation):
    """Whether a Mesh's stamp is of the faces of a splinecore Tessellation."""
    corners = tessellation.corner_vertices
    return len(stamp) == 5 and (stamp[0], stamp[2], stamp[4]) == (
        tessellation.vertex_count, len(tessellation.face_starts), zlib.crc32(corners))


def moved(before, total):
    """The stamp of a Mesh whose vertices were given other positions since that of `before`.

    total: core.checksum.of() the positions.
    """
    vertices, edges, faces, _, corners = before
    return [vertices, edges, faces, total, corners]


def _of_mesh(mesh):
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    if 'position' in mesh.attributes:
        mesh.attributes['position'].data.foreach_get('vector', positions)
    else:
        mesh.vertices.foreach_get('co', positions)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get('vertex_index', corners)
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons), checksum.of(positions), zlib.crc32(corners)]


def _of_curve(curve):
    kinds = positions = 0
    for spline in curve.splines:
        kinds = zlib.crc32(f"{spline.type} {spline.use_cyclic_u} {len(spline.points)}".encode(), kinds)
        points = np.empty(4 * len(spline.points), np.float32)
        spline.points.foreach_get('co', points)
        positions = zlib.crc32(points, positions)
    return [len(curve.splines), kinds, positions]
