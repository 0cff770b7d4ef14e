"""How far shapes lie from another object, worked out when either of them changes: at some places at once, where that is
quick, and at all that are wanted when nothing has changed for a while, a part of them at every look."""

import bpy
import numpy as np

from ...core.analysis import deviations, faces
from ...core.analysis.measuring import Measuring
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase
from ...core.shape import definition as definitions
from ..data import store, tessellate
from ..data.settings import overlays_of
from . import deviation_targets, overlays

#: Places that are measured at once, and in the end.
_AT_ONCE, _IN_THE_END = 2000, 30_000
#: Seconds after which places are no longer measured at once, and that one look takes of those in the end.
_QUICK, _LOOK = 0.1, 0.05


def problem(scene, obs):
    """Why there is nothing to measure to, as a sentence, or ""; obs: the shapes that are measured."""
    other = overlays_of(scene).deviation_object
    if other is not None and obs and all(ob == other for ob in obs):
        return phrase("{name} is the shape itself: choose another", name=other.name)
    try:
        target(scene)
    except FAILURES as error:
        return str(error)
    return ""


def target(scene):
    """The deviation_targets.Target of a scene. Raises FAILURES where there is none."""
    other = overlays_of(scene).deviation_object
    if other is None:
        raise Refusal("Choose the object to which distances are measured")
    scenes = other.users_scene
    if not scenes:
        raise Refusal("{name} was deleted: choose another", name=other.name)
    if scene not in scenes:
        raise Refusal("{name} is in another scene: choose one of this", name=other.name)
    return deviation_targets.of(other)


def of(ob, other, is_still):
    """(the core.analysis.deviations.Deviation of a shape from a Target, what share of it is measured in the end, whether
    something changed since it was asked for last); the first is None where it cannot be, or takes long.

    is_still: whether nothing has changed for a while.
    """
    numbers = (other, *deviation_targets.flat(ob.matrix_world))
    in_the_end, at_once = ('deviation', ob.name), ('deviation at once', ob.name)
    was_known = overlays.is_known(ob.data, at_once, numbers)
    quick = overlays.kept(ob.data, at_once, numbers, _at_once)
    is_over = overlays.is_known(ob.data, in_the_end, numbers)
    if not (is_over or (was_known and is_still)):
        return quick, 0.0, not was_known
    measuring = overlays.kept(ob.data, ('measuring', ob.name), numbers, _measuring)
    if is_over or _has_ended(measuring):
        deviation = overlays.kept(ob.data, in_the_end, numbers, lambda *_: _summed(ob.data, other, numbers[1:], measuring))
        return deviation, 1.0, False
    return quick, measuring.share, False


def faces_of(data):
    """(the core.analysis.faces.Faces of patches, their Places, the patches)."""
    patch_set = definitions.to_patch_set(store.read(data))
    return (*faces.placed(tessellate.tessellated(data, patch_set), patch_set), patch_set)


def lines_of(data):
    """(n, 2, 3): the lines of curves."""
    return overlays.curves_of(data)


def _measuring(data, other, *matrix, most=_IN_THE_END):
    frame = other.frame(np.reshape(matrix, (4, 4)))

    def distances(points):
        return other.geometry.distances(points @ frame[:, :3].T + frame[:, 3]) * other.unit
    if isinstance(data, bpy.types.Curve):
        return Measuring(deviations.along_lines(_lines_known(data), most), distances)
    _, places, patch_set = _faces_known(data)
    return Measuring(deviations.at_places(patch_set, places, most), distances)


def _has_ended(measuring):
    """Whether there is nothing more to measure, after another look."""
    try:
        return measuring is None or measuring.go_on(_LOOK)
    except FAILURES:
        return True


def _at_once(data, other, *matrix):
    measuring = _measuring(data, other, *matrix, most=_AT_ONCE)
    return _summed(data, other, matrix, measuring) if measuring.go_on(_QUICK) else None


def _summed(data, other, matrix, measuring):
    if measuring is None or measuring.share < 1.0:
        return None
    linear = other.frame(np.reshape(matrix, (4, 4)))[:, :3]
    values = measuring.values()
    if isinstance(data, bpy.types.Curve):
        return deviations.over_lines(values, _lines_known(data) @ linear.T)
    areas = overlays.kept(data, 'areas', tuple(linear.ravel().tolist()), _areas)
    return deviations.over_faces(values, _faces_known(data)[0].triangles, *areas)


def _lines_known(data):
    pairs = overlays.kept(data, 'lines', (), lines_of)
    if pairs is None:
        raise Refusal("its lines cannot be drawn")
    return pairs


def _faces_known(data):
    known = overlays.kept(data, 'placed', (), faces_of)
    if known is None:
        raise Refusal("its faces cannot be drawn")
    return known


def _areas(data, *linear):
    shown, _, _ = overlays.kept(data, 'placed', (), faces_of)
    return deviations.areas(shown.positions @ np.reshape(linear, (3, 3)).T, shown.triangles)
