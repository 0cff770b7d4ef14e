"""Data-blocks of Blender."""

import bpy


def remove(data):
    """Take a Mesh, Curve or SurfaceCurve out of the file, unless something uses it."""
    if not data.users:
        (bpy.data.curves if isinstance(data, bpy.types.Curve) else bpy.data.meshes).remove(data)
