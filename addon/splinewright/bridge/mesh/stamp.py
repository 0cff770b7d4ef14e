"""What identifies the geometry that Splinewright wrote, to notice what others changed since."""

import zlib

import bpy
import numpy as np

from ...core.base import checksum
from . import mesh_layers


def of(data):
    """Counts and checksums of a Mesh's or Curve's geometry: whole numbers."""
    return _of_curve(data) if isinstance(data, bpy.types.Curve) else _of_mesh(data)


def agree(a, b):
    """Whether two stamps are of the same geometry."""
    return _comparable(a, b) and all(x == y for x, y in zip(a, b))


def same_topology(a, b):
    """Whether two stamps are of geometry that differs in positions only."""
    positions = 2 if len(a) == 3 else 3
    return _comparable(a, b) and all(x == y for i, (x, y) in enumerate(zip(a, b)) if i != positions)


def _comparable(a, b):
    """Whether they are of one kind of data-block. Where faces start was not counted in older files."""
    return len(a) == len(b) or sorted((len(a), len(b))) == [5, 6]


def is_of_faces(stamp, tessellation):
    """Whether a Mesh's stamp is of the faces of a splinecore Tessellation."""
    known = _of_faces(tessellation)
    return _comparable(stamp, known) and all(x == y for x, y in zip(stamp, known) if y is not None)


def of_faces(mesh, tessellation, positions):
    """of() a Mesh that has the faces of a Tessellation and was given these positions, float32, without reading it."""
    vertices, _, faces, _, *sums = _of_faces(tessellation)
    return [vertices, len(mesh.edges), faces, checksum.of(positions.ravel()), *sums]


def _of_faces(tessellation):
    starts, corners = tessellation.face_starts, tessellation.corner_vertices
    return [tessellation.vertex_count, None, len(starts), None, zlib.crc32(corners), zlib.crc32(starts)]


def moved(before, total):
    """The stamp of a Mesh whose vertices were given other positions since that of `before`.

    total: core.base.checksum.of() the positions.
    """
    return [*before[:3], total, *before[4:]]


def of_turned_over(data):
    """of() with every face of a Mesh turned over, as newer versions of Blender do where a mirroring is applied."""
    if isinstance(data, bpy.types.Curve):
        return of(data)
    corners, starts = mesh_layers.corner_vertices(data), _starts(data)
    counts = np.diff(starts, append=len(corners))
    within = np.arange(len(corners)) - np.repeat(starts, counts)
    turned = np.repeat(starts, counts) + np.where(within > 0, np.repeat(counts, counts) - within, 0)
    found = of(data)
    return [*found[:4], zlib.crc32(np.ascontiguousarray(corners[turned])), *found[5:]]


def _starts(mesh):
    starts = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get('loop_start', starts)
    return starts


def _of_mesh(mesh):
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    if 'position' in mesh.attributes:
        mesh.attributes['position'].data.foreach_get('vector', positions)
    else:
        mesh.vertices.foreach_get('co', positions)
    corners = np.ascontiguousarray(mesh_layers.corner_vertices(mesh))
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons), checksum.of(positions), zlib.crc32(corners),
            zlib.crc32(_starts(mesh))]


def _of_curve(curve):
    kinds = positions = 0
    for spline in curve.splines:
        kinds = zlib.crc32(f"{spline.type} {spline.use_cyclic_u} {len(spline.points)}".encode(), kinds)
        points = np.empty(4 * len(spline.points), np.float32)
        spline.points.foreach_get('co', points)
        positions = zlib.crc32(points, positions)
    return [len(curve.splines), kinds, positions]
