"""Several shapes become one."""

import functools
from typing import NamedTuple

import bpy
import numpy as np

from ..core import joints, patch_joints, transform
from ..core.failures import Refusal
from . import blocks, mesh_looks, recipes, replacing, shape, store, write_curve


def join(active, others):
    """The active shape takes the pieces of the others, where they stand; the others are removed.

    Each piece keeps its material, splines their radius and tilt. Raises Refusal, and changes nothing, where one
    cannot be read or changed.
    """
    definition = together(active, others)
    looks = _looks([active, *others])
    shape.set_definition(active.data, definition)
    _give_looks(active.data, looks)
    _remove(others)


def join_ends(active, other, first, second, smoothness):
    """join() of two curve shapes in which a piece of one and a piece of the other are then one curve.

    Returns the definition before the two pieces are one, and the core.verbs.Changed. Raises, and changes nothing,
    as join() and core.joints.joined() do.
    """
    definition = together(active, [other])
    parted = len(store.read(active.data).pieces)
    changed = joints.joined(definition, first, second, smoothness, linear_of(active), parted)
    looks = _looks([active, other])
    worn = replacing.carried(looks.worn, definition, changed, active.data)
    shape.set_definition(active.data, changed.definition)
    _give_looks(active.data, looks._replace(worn=worn))
    _remove([other])
    return definition, changed


def join_patches(active, other, first, second, smoothness, moves):
    """join() of two patch shapes in which a side of one goes on as a side of the other; of the active shape alone
    where the other is None.

    Returns the core.patch_joints.Joined. Raises, and changes nothing, as join() and core.patch_joints.joined() do.
    """
    if other is None:
        replacing.require_changeable(active.data)
        before = store.read(active.data)
        found = patch_joints.joined(before, first, second, smoothness, moves, linear_of(active))
        replacing.put(active.data, before, found.changed)
        return found
    parted = len(store.read(active.data).pieces)
    found = patch_joints.joined(together(active, [other]), first, second, smoothness, moves, linear_of(active), parted)
    looks = _looks([active, other])
    shape.set_definition(active.data, found.changed.definition)
    _give_looks(active.data, looks)
    _remove([other])
    return found


def linear_of(ob):
    """(3, 3) float64: what takes lengths of an object to the world."""
    return np.array(ob.matrix_world, dtype=np.float64)[:3, :3]


def together(active, others):
    """The definition of all pieces in the space of the active shape. Raises Refusal as join() does."""
    for ob in [active, *others]:
        if ob.library or ob.override_library or ob.data.library:
            raise Refusal(f"{ob.name} is linked from another file")
        recipes.require_free(ob.data)
        shape.require_writable(ob.data)
        shape.require_untouched(ob.data)
    into = np.array(active.matrix_world, dtype=np.float64)
    if np.linalg.det(into[:3, :3]) == 0:
        raise Refusal(f"{active.name} has a scale of 0: nothing can be put into its space")
    into = np.linalg.inv(into)
    parts = [store.read(active.data)]
    for ob in others:
        parts.append(transform.transformed(store.read(ob.data), into @ np.array(ob.matrix_world, dtype=np.float64)))
    return transform.joined(parts)


def _remove(obs):
    for ob in obs:
        data = ob.data
        bpy.data.objects.remove(ob)
        blocks.remove(data)


class _Looks(NamedTuple):
    materials: list
    of_pieces: list             # a mesh_looks.Look for each piece of a mesh
    worn: list                  # a write_curve.Dress for each spline of a curve


def _looks(obs):
    """The materials of all parts, and which of them each wears."""
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
    return _Looks(materials, of_pieces, worn)


def _slot(slots, index):
    """Of a material index in one part, the index in the whole; Blender takes the last for one too high."""
    return slots[min(index, len(slots) - 1)]


def _give_looks(data, looks):
    for material in looks.materials[len(data.materials):]:
        data.materials.append(material)
    if isinstance(data, bpy.types.Curve):
        if len(looks.worn) == len(data.splines):
            write_curve.put_on(data, looks.worn)
    else:
        replacing.give_looks(data, looks.of_pieces)
