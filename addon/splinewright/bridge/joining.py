"""Several shapes become one."""

import bpy
import numpy as np

from ..core import transform
from . import recipes, shape, store


def join(active, others):
    """The active shape takes the pieces of the others, where they stand; the others are removed.

    Materials the active one has not are added to it. Raises ValueError, and changes nothing, where one
    cannot be read or changed.
    """
    shape.require_writable(active.data)
    for ob in [active, *others]:
        if ob.library or ob.override_library or ob.data.library:
            raise ValueError(f"{ob.name} is linked from another file")
        if recipes.has(ob.data):
            raise ValueError(f"{ob.name} follows another object: use Make Editable first")
        shape.require_untouched(ob.data)
    into = np.array(active.matrix_world, dtype=np.float64)
    if np.linalg.det(into[:3, :3]) == 0:
        raise ValueError(f"{active.name} has a scale of 0: nothing can be put into its space")
    into = np.linalg.inv(into)
    parts = [store.read(active.data)]
    for ob in others:
        parts.append(transform.transformed(store.read(ob.data), into @ np.array(ob.matrix_world, dtype=np.float64)))
    shape.set_definition(active.data, transform.joined(parts))
    for ob in others:
        _add_materials(active.data, ob.data)
        data = ob.data
        bpy.data.objects.remove(ob)
        if not data.users:
            shape.remove_data(data)


def _add_materials(data, other):
    for material in other.materials:
        if material is not None and material.name not in data.materials:
            data.materials.append(material)
