"""How smoothly patches continue as one another where their sides are one edge (lecture rows S16, S21)."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..verbs import patch_curves
from .continuity import in_words as continuity_in_words
from .continuity import Joint, Survey
from .creases import creases_of
from .joints import SMOOTH

#: More derivatives than are compared: none is ever all of a seam's.
_MORE = 3
#: Below these a place has the next class: gap as a part of the shape's size, angle in radians, and difference of
#: curvatures times the size.
_TOLERANCES = (1e-8, 1e-6, 1e-4)


class Seam(NamedTuple):
    """Two sides that are one edge; patches are counted from 0."""

    first: tuple                        # (patch, side)
    second: tuple
    measured: object                    # a splinecore SeamContinuity; None where there is nothing to measure


def seams_of(definition, limit):
    """(the first Seams of a definition of patches, how many there are)."""
    patch_set = definitions.to_patch_set(definition)
    pairs = [pair for pair in patch_set.seams() if not _is_periodic(definition, *pair)]
    return [Seam(first, second, _measured(patch_set, first, second)) for first, second in pairs[:limit]], len(pairs)


def opened(before, after, parents):
    """Pairs of patches of a definition, counted from 0, that shared a side and share none any more. parents: of core.verbs.verbs.Changed."""
    if before.has_curves or len(before.pieces) == 1:
        return []
    return sorted(_pairs(before, range(len(before.pieces))) - _pairs(after, parents))


def _pairs(definition, numbers):
    pairs = ((numbers[first], numbers[second]) for (first, _), (second, _) in definitions.to_patch_set(definition).seams())
    return {(min(pair), max(pair)) for pair in pairs if pair[0] != pair[1]}


def surveyed(definition, limit):
    """The core.joints.continuity.Survey of a definition of patches."""
    creases, bendable = creases_of(definition)
    seams, count = seams_of(definition, max(limit - len(creases), 0))
    is_one = len(definition.pieces) == 1
    inside = [Joint(_name_of(crease, is_one), crease.measured, _MORE) for crease in creases[:limit]]
    between = [Joint(_name(seam, is_one), seam.measured, _MORE, (seam.first, seam.second)) for seam in seams]
    return Survey((*inside, *between), count + len(creases), bendable)


def lines_of(definition, limit):
    """The measures along the first seams of a definition, and along the creases inside its patches."""
    seams, _ = seams_of(definition, limit)
    return [one.measured for one in (*seams, *creases_of(definition)[0]) if one.measured is not None]


def classes(measured, size):
    """(n,) int of the places of a SeamContinuity: -1 a gap, 0 an angle, 1 another curvature, 2 none; -2 unknown."""
    tolerances = _TOLERANCES[0] * size, _TOLERANCES[1], _TOLERANCES[2] / size
    found = np.full(len(measured.parameters), 2)
    for number, (values, tolerance) in enumerate(
            zip((measured.gaps, measured.angles, measured.curvature_differences), tolerances)):
        found[(values > tolerance) & (found == 2)] = number - 1
    found[np.isnan(measured.gaps)] = -2
    return found


def _is_periodic(definition, first, second):
    """Whether both sides are one place inside a periodic direction."""
    periodic = definition.pieces[first[0]].periodic
    return first[0] == second[0] and first[1][0] == second[1][0] and any(periodic) and periodic['uv'.index(first[1][0])]


def measured(first, first_side, second, second_side):
    """The splinecore SeamContinuity that is shown of two patches, in every place."""
    return sc.seam_continuity(first, first_side, second, second_side, tolerance=SMOOTH)


def in_words(found):
    """Parametric and geometric continuity of a SeamContinuity in one word."""
    return continuity_in_words(found, _MORE)


def _measured(patch_set, first, second):
    try:
        return measured(patch_set[first[0]], first[1], patch_set[second[0]], second[1])
    except (sc.InvalidShape, sc.PointAtInfinity):
        return None


def _name_of(crease, is_one):
    words = phrase("crease {axis} {knot:.4g}", axis=crease.axis, knot=crease.knot)
    return words if is_one else phrase("{number} {words}", number=crease.patch + 1, words=words)


def _name(seam, is_one):
    first, second = (patch_curves.named_side(side, None if is_one else patch + 1) for patch, side in (seam.first, seam.second))
    return phrase("{first} · {second}", first=first, second=second)
