"""Two surfaces that are matched by moving both half way."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import hollow

_AXES = "uv"
#: Knots that lie so near, as a part of the domain, are one.
_SAME = 1e-9
_PLACES = 65


class Both(NamedTuple):
    """Two patches that continue each other, and how far their points moved, at equal parameters."""

    first: object
    second: object
    moved: tuple


def half_way(first, first_side, second, second_side, continuity, rows, strength, cancel=None):
    """The Both of two patches: the first one goes half of the way that it would go to the second one, which goes to that. Raises
    Refusal or an error of the library."""
    reached = sc.build.match_patch(first, first_side, second, second_side, continuity, rows=rows, strength=strength, cancel=cancel)
    middle = _between(first.to_nurbs(), reached.value)
    other = sc.build.match_patch(second, second_side, middle, first_side, continuity, rows=rows, strength=strength, cancel=cancel)
    return Both(middle, other.value, (_moved(first.to_nurbs(), middle), other.error))


def _moved(patch, other):
    """How far points move at equal parameters, as far as a number of samples shows."""
    at = [np.linspace(*domain, _PLACES) for domain in patch.domain]
    return float(np.linalg.norm(patch.evaluate_grid(*at) - other.evaluate_grid(*at), axis=-1).max())


def _between(patch, other):
    """Half way from a patch to one over the same domain, whose knots include its knots."""
    for number, axis in enumerate(_AXES):
        more = other.degree[number] - patch.degree[number]
        patch = patch.elevate(axis, more) if more else patch
        if patch.periodic[number] and not other.periodic[number]:
            patch = patch.clamped(axis)
        start, end = patch.domain[number]
        theirs = [_snapped(knot, patch.knots[number], _SAME * (end - start)) for knot in other.knots[number]]
        missing = hollow.missing(theirs, patch.knots[number])
        patch = patch.refine(axis, missing) if missing else patch
    if patch.points.shape != other.points.shape or patch.periodic != other.periodic:
        raise Refusal("the two surfaces have no common knots half way: let one alone move")
    rows = 0.5 * (patch.homogeneous_points + other.homogeneous_points)
    return sc.NurbsPatch.from_homogeneous(other.degree, other.knots, rows, other.periodic)


def _snapped(knot, known, within):
    nearest = float(known[np.abs(known - knot).argmin()])
    return nearest if abs(nearest - knot) <= within else float(knot)
