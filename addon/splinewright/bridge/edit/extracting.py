"""Curves of a patch shape as separate shapes."""

import bpy
import numpy as np
from mathutils import Matrix

from ...core.shape import definition as definitions
from ...core.shape import transform
from ...core.verbs import patch_curves, verbs
from ..data import settings, store
from ..shape import shape


def isocurves(data, number, at):
    """core.verbs.patch_curves.isocurves() of a Mesh."""
    return patch_curves.isocurves(verbs.pieces_of(store.read(data)), number, at)


def boundaries(data, number, sides):
    """core.verbs.patch_curves.boundaries() of a Mesh."""
    return patch_curves.boundaries(verbs.pieces_of(store.read(data)), number, sides)


def new_object(source, name, curves, axes):
    """A new object, not linked to a scene, of curves across these axes of a shape; it lies where that lies."""
    chosen = settings.of(source.data)
    resolution = max(chosen.resolution_v if axis == 'u' else chosen.resolution_u for axis in axes)
    value = _without_shear(curves[0] if len(curves) == 1 else curves, source.matrix_world)
    data = shape.new_data(f"{source.name} {name}", value, (resolution, resolution))
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = source.matrix_world
    return ob


def _without_shear(value, matrix):
    """Curves as they lie in the place that an object without a parent can have instead of that matrix."""
    world, plain = (np.array(one, dtype=np.float64) for one in (matrix, Matrix.LocRotScale(*matrix.decompose())))
    size = np.abs(world).max()
    if np.abs(world - plain).max() <= 1e-6 * size or np.linalg.det(plain[:3, :3]) == 0:
        return value
    return definitions.to_value(transform.transformed(definitions.from_value(value), np.linalg.inv(plain) @ world))
