"""Transforms of objects into definitions."""

import numpy as np
from mathutils import Matrix

from ..core import transform
from . import shape, store


def apply(ob, location, rotation, scale):
    """Move parts of an object's own transform into its definition; its children stay where they are.

    Raises ValueError, and changes nothing, where several objects show the data or the scale is 0.
    """
    data = ob.data
    if ob.library or ob.override_library:
        raise ValueError("it is linked from another file")
    if data.users - data.use_fake_user > 1:
        raise ValueError(f"{data.users} users show the same data: make it single-user first")
    shape.require_writable(data)
    shape.require_untouched(data)
    before = ob.matrix_basis.copy()
    after = _rest(before, location, rotation, scale)
    definition = store.read(data)
    moved = transform.transformed(definition, np.linalg.inv(_exact(after)) @ _exact(before))
    shape.set_definition(data, moved)
    ob.matrix_basis = after
    into = after.inverted_safe() @ before
    for child in ob.children:
        child.matrix_parent_inverse = into @ child.matrix_parent_inverse


def _rest(matrix, location, rotation, scale):
    """What is left of a transform when parts of it are taken out. Raises ValueError for a scale of 0."""
    place, turn, size = matrix.decompose()
    if min(map(abs, size)) == 0.0:
        raise ValueError("it has a scale of 0, which would flatten the shape for ever")
    return Matrix.LocRotScale(None if location else place, None if rotation else turn, None if scale else size)


def _exact(matrix):
    return np.array(matrix, dtype=np.float64)


def adopt(data):
    """Take an affine map of the whole mesh or curve, made by others, into the definition.

    Raises ValueError where the geometry is not an affine image of what the definition shows.
    """
    shape.require_writable(data)
    if not shape.is_touched(data):
        raise ValueError("it is as Splinewright wrote it: there is nothing to adopt")
    definition = store.read(data)
    before, after = shape.evaluated(data, definition).points.astype(np.float64), shape.points_of(data)
    matrix = transform.affine_between(before, after) if len(before) == len(after) else None
    if matrix is None:
        raise ValueError("it was not moved as a whole: Restore throws the changes away, Detach keeps them")
    store.write(data, transform.transformed(definition, matrix))
    shape.restore(data)
