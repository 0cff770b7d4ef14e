"""Several shapes become one."""

from contextlib import contextmanager
from typing import NamedTuple

import bpy
import numpy as np

from ...core.base.failures import AboutInputs, Refusal, blenders_refusals
from ...core.base.words import phrase
from ...core.joints import patch_joints
from ...core.shape import transform
from ..curve import handles
from ..data import blocks, held, store
from ..data.shading import Look
from ..keys import point_keys
from ..mesh import mesh_attributes, mesh_looks, write_mesh
from ..recipes import recipes
from ..shape import curve_pieces, shape
from . import replace_pieces


def join(active, others):
    """The active shape takes the pieces of the others, where they stand; the others are removed.

    What users put on each stays on it. Raises Refusal, and changes nothing, where one cannot be read or changed.
    """
    definition = together(active, others)
    belongings = _belongings([active, *others])
    shape.set_definition(active.data, definition)
    _give(active, definition, belongings)
    held.write(active.data, belongings.seams)
    handles.write(active.data, belongings.types)
    _remove(others)


def join_plainly(active, chosen):
    """Blender's own Join of selected objects, some of which are no shapes: the definitions of the others end.

    Returns a sentence for the user. Raises Refusal, and changes nothing, where Blender refuses.
    """
    said, ended = phrase("Joined into {name}", name=active.name), [ob.data for ob in chosen if shape.has_shape(ob)]
    count = len(set(ended))
    with blenders_refusals():
        outcome = bpy.ops.object.join()
    if outcome != {'FINISHED'}:
        raise Refusal("Blender did not join them")
    for data in set(ended):
        if data == active.data:
            shape.detach(data)
        else:
            blocks.remove(data)
    return phrase("{said}: {count} definitions ended", one="{said}: {count} definition ended", said=said, count=count)


def ending_in_words(chosen):
    """What join_plainly() ends, as a sentence."""
    shapes, others = ([ob.name for ob in chosen if shape.has_shape(ob) == is_shape] for is_shape in (True, False))
    others_are = phrase("{names} are no Splinewright shapes" if len(others) > 1 else "{names} is no Splinewright shape", names=_listed(others))
    end = phrase("the definitions of {names} end: what they show stays, without a net" if len(shapes) > 1 else
                 "the definition of {names} ends: what it shows stays, without a net", names=_listed(shapes))
    return phrase("{others_are}. Joined with them, {end}" if len(others) > 1 else "{others_are}. Joined with it, {end}",
                  others_are=others_are, end=end)


def _listed(names):
    """A few names in words."""
    if len(names) > 4:
        names = [*names[:3], phrase("{count} more", count=len(names) - 3)]
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def join_changed(active, others, change):
    """join() of curve shapes that are changed then; of the active shape alone where there are no others.

    change: gives, of the definition of both and how many pieces of it are the active shape's, the core.verbs.verbs.Changed. Returns
    the definition before, and that. Raises, and changes nothing, as join() and change() do.
    """
    if not others:
        before = replace_pieces.read(active.data)
        changed = change(before, None)
        replace_pieces.put(active.data, before, changed)
        return before, changed
    definition = together(active, others)
    changed = change(definition, len(store.read(active.data).pieces))
    belongings = _belongings([active, *others])
    shape.set_definition(active.data, changed.definition)
    pieces = curve_pieces.carried(belongings.pieces, changed)
    _give(active, changed.definition, belongings._replace(pieces=pieces))
    held.carry(active.data, belongings.seams, definition, changed.parents)
    handles.carry(active.data, belongings.types, definition, changed)
    _remove(others)
    return definition, changed


def join_patches(active, other, first, second, smoothness, moves):
    """join() of two patch shapes in which a side of one continues as a side of the other; of the active shape alone
    where the other is None.

    Returns the core.joints.patch_joints.Joined. Raises, and changes nothing, as join() and core.joints.patch_joints.joined() do.
    """
    if other is None:
        replace_pieces.require_changeable(active.data)
        before = store.read(active.data)
        with _naming(active, active):
            found = patch_joints.joined(before, first, second, smoothness, moves, linear_of(active))
        replace_pieces.put(active.data, before, found.changed)
        return found
    parted = len(store.read(active.data).pieces)
    definition = together(active, [other])
    with _naming(active, other):
        found = patch_joints.joined(definition, first, second, smoothness, moves, linear_of(active), parted)
    belongings = _belongings([active, other])
    shape.set_definition(active.data, found.changed.definition)
    _give(active, found.changed.definition, belongings)
    held.carry(active.data, belongings.seams, definition, found.changed.parents)
    _remove([other])
    return found


@contextmanager
def _naming(active, other):
    """A refusal about the patches of two shapes names these, or the one that both are."""
    try:
        yield
    except AboutInputs as error:
        if active != other:
            raise error.named([active.name, other.name]) from error
        raise Refusal(error.arguments.get('reason') or error.args[0]) from error


def linear_of(ob):
    """(3, 3) float64: what takes lengths of an object to the world."""
    return np.array(ob.matrix_world, dtype=np.float64)[:3, :3]


def together(active, others):
    """The definition of all pieces in the space of the active shape. Raises Refusal as join() does."""
    for ob in [active, *others]:
        if ob.library or ob.override_library or ob.data.library:
            raise Refusal("{name} is linked from another file", name=ob.name)
        recipes.require_free(ob.data)
        shape.require_writable(ob.data)
        shape.require_untouched(ob.data)
    into = np.array(active.matrix_world, dtype=np.float64)
    if np.linalg.det(into[:3, :3]) == 0:
        raise Refusal("{name} has a scale of 0: nothing can be put into its space", name=active.name)
    into = np.linalg.inv(into)
    parts = [store.read(active.data)]
    for ob in others:
        parts.append(transform.transformed(store.read(ob.data), into @ np.array(ob.matrix_world, dtype=np.float64)))
    return transform.joined(parts)


def _remove(obs):
    for ob in obs:
        data = ob.data
        point_keys.tell_lost(data, point_keys.count(data))
        bpy.data.objects.remove(ob)
        blocks.remove(data)


class _Belongings(NamedTuple):
    """What users put on the parts, with material indices of the whole."""

    materials: list
    pieces: list                # for each piece a Look, or of a curve what curve_pieces.of() gives
    seams: tuple                # that hold
    types: tuple                # of the handles of each piece
    painted: list               # (mesh_attributes.Kept, the first of its patches, how many it has) of each mesh with any


def _belongings(obs):
    materials, pieces, painted = list(obs[0].data.materials), [], []
    for ob in obs:
        data, definition = ob.data, store.read(ob.data)
        materials += [material for material in data.materials if material not in materials]
        slots = np.array([materials.index(material) for material in data.materials] or [0])
        if definition.has_curves:
            pieces += [[layers._replace(look=_in_whole(slots, layers.look)) for layers in piece]
                       for piece in curve_pieces.of(data, definition)]
            continue
        known, uneven = mesh_looks.kept(data)
        kept = mesh_attributes.keep(data, write_mesh.owner_of(data), [_layer_in_whole(slots, layer) for layer in uneven])
        if kept is not None:
            painted.append((kept, len(pieces), len(definition.pieces)))
        pieces += [_in_whole(slots, known.get(i, Look())) for i in range(len(definition.pieces))]
    return _Belongings(materials, pieces, held.of_all(obs),
                       handles.of_all([ob.data for ob in obs]), painted)


def _in_whole(slots, look):
    """A Look of one part, whose material is another of the whole; Blender takes the last for an index too high."""
    return look._replace(material_index=int(slots[min(look.material_index, len(slots) - 1)]))


def _layer_in_whole(slots, layer):
    if layer.name != 'material_index':
        return layer
    return layer._replace(values=slots[np.minimum(layer.values, len(slots) - 1)].astype(np.int32))


def _give(active, definition, belongings):
    data = active.data
    for material in belongings.materials[len(data.materials):]:
        data.materials.append(material)
    if definition.has_curves:
        curve_pieces.write(data, definition, belongings.pieces)
        return
    replace_pieces.give_looks(data, belongings.pieces)
    for kept, first, count in belongings.painted:
        mesh_attributes.add(data, active, kept, first, count)
    if belongings.painted:
        shape.rewrite(data)             # sharp edges and normals of flat faces
