"""A shape as a whole: its definition, and the mesh or curve that is written from it."""

import bpy
import numpy as np

from ..core import definition as definitions
from ..core.library import sc
from . import store, write_curve, write_mesh


def has_shape(ob):
    """Whether the object is a shape of ours."""
    return ob is not None and ob.type in ('MESH', 'CURVE') and store.has_definition(ob.data)


#: Steps that set_definition() and rewrite() report to `progress`.
STEPS = 2


def no_progress(step):
    """For callers that show none."""


def new_data(name, value, resolution, progress=no_progress):
    """A new Mesh or Curve that shows the value. resolution is a pair; a curve uses the first."""
    definition = definitions.from_value(value)
    collection = bpy.data.curves if definition.has_curves else bpy.data.meshes
    data = collection.new(name, 'CURVE') if definition.has_curves else collection.new(name)
    if definition.has_curves:
        data.use_path = True        # Follow Path finds no path otherwise
    try:
        data.splinewright.set_resolution(*resolution)
        set_definition(data, definition, progress)
    except Exception:
        collection.remove(data)
        raise
    return data


def remove_data(data):
    """Take a Mesh or Curve that no object uses out of the file."""
    (bpy.data.curves if isinstance(data, bpy.types.Curve) else bpy.data.meshes).remove(data)


def value_of(data):
    """The splinecore value of a data-block, or None where it has no definition."""
    definition = store.read(data)
    return None if definition is None else definitions.to_value(definition)


def set_value(data, value):
    """Give the data-block another definition and write what it shows.

    Raises TypeError or ValueError, and changes nothing, if the value does not fit.
    """
    set_definition(data, definitions.from_value(value))


def set_definition(data, definition, progress=no_progress):
    """set_value() with a definition."""
    require_writable(data)
    store.require_fitting(data, definition)
    show = evaluated(data, definition)
    progress(1)
    store.write(data, definition)
    show()
    progress(2)
    data.splinewright.problem = ""


def rewrite(data, progress=no_progress):
    """Evaluate the stored definition again, after its settings changed. Raises as set_value() does."""
    definition = store.read(data)
    if definition is not None:
        require_writable(data)
        show = evaluated(data, definition)
        progress(1)
        show()
        progress(2)


def evaluated(data, definition):
    """Evaluate now, write later: what is returned writes the result.

    Raises ValueError or ArithmeticError where there is nothing finite to show.
    """
    settings = data.splinewright
    if definition.has_curves:
        value = definitions.to_value(definition)
        curves = value if isinstance(value, list) else [value]
        lines = [line for curve in curves for line in curve.polylines(settings.resolution_u)]
        if not lines:
            raise sc.InvalidShape("no piece of the curve is finite")
        lines = [(_single(points), closed) for points, closed in lines]
        return lambda: write_curve.write(data, lines)
    patch_set = definitions.to_patch_set(definition)
    tessellation = sc.Tessellation(patch_set, (settings.resolution_u, settings.resolution_v))
    positions, normals = tessellation.evaluate(patch_set)
    _single(positions)
    sharp = tessellation.sharp_edges(normals, settings.sharp_angle)
    return lambda: write_mesh.write(data, tessellation, positions, normals, sharp)


def _single(points):
    """The points as Blender holds them, in float32. Raises InvalidShape if one is too far away."""
    with np.errstate(over='ignore'):
        points = points.astype(np.float32)
    if not np.isfinite(points).all():
        raise sc.InvalidShape("a point is farther away than Blender can show (3.4e38)")
    return points


def require_writable(data):
    """Raises ValueError where writing would be lost, or would lose something."""
    store.require_known_version(data)
    if data.library:
        raise ValueError(f"{data.name} is linked from another file and cannot be changed here")
    if data.override_library or data.is_evaluated:
        raise ValueError(f"{data.name} is a copy that Blender makes anew: change the original")
    if data.is_editmode:
        raise ValueError(f"{data.name} is in Edit Mode: leave it first")
