"""How far shapes lie from another object, worked out when either of them changes: at some places at once, and at all that
are wanted when nothing has changed for a while."""

import bpy
import numpy as np

from ..core import definition as definitions
from ..core.failures import FAILURES, Refusal
from ..core.sights import closest, deviations, faces
from . import deviation_targets, fineness, sights, store

#: Places that are measured at once, and in the end.
_AT_ONCE, _IN_THE_END = 2000, 30_000


def problem(scene, obs):
    """Why there is nothing to measure to, as a sentence, or ""; obs: the shapes that are measured."""
    other = sights.of(scene).deviation_object
    if other is not None and obs and all(ob == other for ob in obs):
        return f"{other.name} is the shape itself: choose another"
    try:
        target(scene)
    except FAILURES as error:
        return str(error)
    return ""


def target(scene):
    """The deviation_targets.Target of a scene. Raises FAILURES where there is none."""
    other = sights.of(scene).deviation_object
    if other is None:
        raise Refusal("Choose the object to which distances are measured")
    scenes = other.users_scene
    if not scenes:
        raise Refusal(f"{other.name} was deleted: choose another")
    if scene not in scenes:
        raise Refusal(f"{other.name} is in another scene: choose one of this")
    return deviation_targets.of(other)


def of(ob, other, is_still):
    """(the core.sights.deviations.Deviation of a shape from a Target, whether it is measured in the end, whether something
    changed since it was asked for last); the first is None where it cannot be.

    is_still: whether nothing has changed for a while.
    """
    numbers = (other, *deviation_targets.flat(ob.matrix_world))
    in_the_end, at_once = ('deviation', ob.name), ('deviation at once', ob.name)
    was_known = sights.is_known(ob.data, at_once, numbers)
    if sights.is_known(ob.data, in_the_end, numbers) or (was_known and is_still):
        return sights.kept(ob.data, in_the_end, numbers, _in_the_end), True, False
    return sights.kept(ob.data, at_once, numbers, _at_once), False, not was_known


def faces_of(data):
    """(the core.sights.faces.Faces of patches, their Places, the patches)."""
    patch_set = definitions.to_patch_set(store.read(data))
    return (*faces.placed(fineness.tessellated(data, patch_set), patch_set), patch_set)


def lines_of(data):
    """(n, 2, 3): the lines of curves."""
    return sights.curves_of(data)


def _in_the_end(data, *numbers):
    return _measured(data, _IN_THE_END, closest.ALL, *numbers)


def _at_once(data, *numbers):
    return _measured(data, _AT_ONCE, closest.FEW, *numbers)


def _measured(data, most, rounds, other, *matrix):
    frame = other.frame(np.reshape(matrix, (4, 4)))

    def distances(points):
        return other.geometry.distances(points @ frame[:, :3].T + frame[:, 3], rounds) * other.unit
    if isinstance(data, bpy.types.Curve):
        pairs = sights.kept(data, 'lines', (), lines_of)
        if pairs is None:
            raise Refusal("its lines cannot be drawn")
        return deviations.over_lines(deviations.along_lines(distances, pairs, most), pairs @ frame[:, :3].T)
    known = sights.kept(data, 'placed', (), faces_of)
    if known is None:
        raise Refusal("its faces cannot be drawn")
    shown, places, patch_set = known
    values = deviations.at_places(patch_set, places, distances, most)
    areas = sights.kept(data, 'areas', tuple(frame[:, :3].ravel().tolist()), _areas)
    return deviations.over_faces(values, shown.triangles, *areas)


def _areas(data, *linear):
    shown, _, _ = sights.kept(data, 'placed', (), faces_of)
    return deviations.areas(shown.positions @ np.reshape(linear, (3, 3)).T, shown.triangles)
