"""What identifies the geometry that Splinewright wrote, to notice what others changed since."""

import functools
import zlib

import bpy
import numpy as np


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


def moved(before, positions):
    """The stamp of a Mesh whose vertices were given other positions (n, 3) float32 since that of `before`."""
    vertices, edges, faces, _, corners = before
    return [vertices, edges, faces, _checksum(positions.ravel()), corners]


def _checksum(numbers):
    """Of float32 numbers in their order, below 2^52; a quarter of the time of a CRC."""
    if len(numbers) % 2:
        numbers = np.append(numbers, np.float32(0))
    return int(np.dot(numbers.view(np.uint64), _factors(len(numbers) // 2)) >> np.uint64(12))


@functools.lru_cache(8)
def _factors(count):
    """Odd factors, so that no change of one number is lost; sums wrap around at 2^64."""
    return np.arange(1, count + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C16) + np.uint64(1)


def _of_mesh(mesh):
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    if 'position' in mesh.attributes:
        mesh.attributes['position'].data.foreach_get('vector', positions)
    else:
        mesh.vertices.foreach_get('co', positions)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get('vertex_index', corners)
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons), _checksum(positions), zlib.crc32(corners)]


def _of_curve(curve):
    kinds = positions = 0
    for spline in curve.splines:
        kinds = zlib.crc32(f"{spline.type} {spline.use_cyclic_u} {len(spline.points)}".encode(), kinds)
        points = np.empty(4 * len(spline.points), np.float32)
        spline.points.foreach_get('co', points)
        positions = zlib.crc32(points, positions)
    return [len(curve.splines), kinds, positions]
