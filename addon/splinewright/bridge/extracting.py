"""Curves of a patch shape as shapes of their own."""

import bpy

from ..core import patch_curves, verbs
from . import shape, store


def isocurves(data, number, at):
    """core.patch_curves.isocurves() of a Mesh."""
    return patch_curves.isocurves(verbs.pieces_of(store.read(data)), number, at)


def boundaries(data, number, sides):
    """core.patch_curves.boundaries() of a Mesh."""
    return patch_curves.boundaries(verbs.pieces_of(store.read(data)), number, sides)


def new_object(source, name, curves, axes):
    """A new object, not linked to a scene, of curves across these axes of a shape; it lies where that lies."""
    settings = source.data.splinewright
    resolution = max(settings.resolution_v if axis == 'u' else settings.resolution_u for axis in axes)
    data = shape.new_data(f"{source.name} {name}", curves[0] if len(curves) == 1 else curves, (resolution, resolution))
    ob = bpy.data.objects.new(data.name, data)
    ob.matrix_world = source.matrix_world
    return ob
