"""What identifies the geometry that Splinewright wrote, to notice what others changed since."""

import zlib

import bpy
import numpy as np


def of(data):
    """Counts and checksums of a Mesh's or Curve's geometry: whole numbers."""
    return _of_curve(data) if isinstance(data, bpy.types.Curve) else _of_mesh(data)


def _of_mesh(mesh):
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    if 'position' in mesh.attributes:
        mesh.attributes['position'].data.foreach_get('vector', positions)
    else:
        mesh.vertices.foreach_get('co', positions)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get('vertex_index', corners)
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons), zlib.crc32(positions), zlib.crc32(corners)]


def _of_curve(curve):
    checksum = 0
    for spline in curve.splines:
        checksum = zlib.crc32(f"{spline.type} {spline.use_cyclic_u}".encode(), checksum)
        if spline.type == 'BEZIER':
            continue
        points = np.empty(4 * len(spline.points), np.float32)
        spline.points.foreach_get('co', points)
        checksum = zlib.crc32(points, checksum)
    return [len(curve.splines), checksum]
