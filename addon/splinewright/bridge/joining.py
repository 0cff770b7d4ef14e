"""Several shapes become one."""

import functools

import bpy
import numpy as np

from ..core import transform
from . import blocks, mesh_looks, recipes, shape, store, write_curve


def join(active, others):
    """The active shape takes the pieces of the others, where they stand; the others are removed.

    Each piece keeps its material, splines their radius and tilt. Raises ValueError, and changes nothing, where one
    cannot be read or changed.
    """
    shape.require_writable(active.data)
    for ob in [active, *others]:
        if ob.library or ob.override_library or ob.data.library:
            raise ValueError(f"{ob.name} is linked from another file")
        recipes.require_free(ob.data)
        shape.require_untouched(ob.data)
    into = np.array(active.matrix_world, dtype=np.float64)
    if np.linalg.det(into[:3, :3]) == 0:
        raise ValueError(f"{active.name} has a scale of 0: nothing can be put into its space")
    into = np.linalg.inv(into)
    parts = [store.read(active.data)]
    for ob in others:
        parts.append(transform.transformed(store.read(ob.data), into @ np.array(ob.matrix_world, dtype=np.float64)))
    looks = _looks([active, *others])
    shape.set_definition(active.data, transform.joined(parts))
    for ob in others:
        data = ob.data
        bpy.data.objects.remove(ob)
        blocks.remove(data)
    looks(active.data)


def _looks(obs):
    """What gives the joined shape the materials, radii and tilts of its parts."""
    materials = list(obs[0].data.materials)
    of_pieces, worn = [], []
    for ob in obs:
        data = ob.data
        materials += [material for material in data.materials if material not in materials]
        slots = [materials.index(material) for material in data.materials] or [0]
        slot = functools.partial(_slot, slots)
        if isinstance(data, bpy.types.Curve):
            worn += [dress._replace(material_index=slot(dress.material_index)) for dress in write_curve.dresses(data)]
        else:
            known = mesh_looks.looks_by_patch(data)
            looks = [known.get(i, mesh_looks.Look()) for i in range(len(store.read(data).pieces))]
            of_pieces += [look._replace(material_index=slot(look.material_index)) for look in looks]
    return functools.partial(_give_looks, materials=materials, of_pieces=of_pieces, worn=worn)


def _slot(slots, index):
    """Of a material index in one part, the index in the whole; Blender takes the last for one too high."""
    return slots[min(index, len(slots) - 1)]


def _give_looks(data, materials, of_pieces, worn):
    for material in materials[len(data.materials):]:
        data.materials.append(material)
    if isinstance(data, bpy.types.Curve):
        if len(worn) == len(data.splines):
            write_curve.put_on(data, worn)
    else:
        mesh_looks.set_looks(data, dict(enumerate(of_pieces)))
