"""Lines that show a patch: its sides, and isocurves."""

import numpy as np

from ..analysis.lines import ends_of
from ..base.failures import Refusal
from ..shape import parameters
from ..verbs import patch_curves
from ..verbs.patch_verbs import Along
from .paths import pieces_of

#: Digits in which points of equal pieces agree, as parts of the size of a shape.
_DIGITS = 9


def sides(patches):
    """The pieces of the sides of patches, each once where patches share it; those that are points are left out."""
    found = [patch_curves.side_of(patch, side)[0] for patch in patches for side in patch_curves.SIDES]
    return _once(pieces_of([curve for curve in found if curve is not None]))


def isocurves(patches, count):
    """The pieces of isocurves at the knots of patches, and of a given number of others in every span each way."""
    found = []
    for patch in patches:
        wanted = [(axis, parameters.Exact(at)) for axis in 'uv' for at in _parameters(Along(patch, axis), count)]
        try:
            found += patch_curves.isocurves([patch], 1, wanted)[0] if wanted else []
        except Refusal:                 # all of them are points
            continue
    return _once(pieces_of(found))


def _parameters(along, count):
    ends = ends_of(along)
    fractions = np.arange(1, count + 1) / (count + 1)
    inner = (ends[:-1, None] + fractions * np.diff(ends)[:, None]).ravel()
    knots = ends[:-1] if getattr(along.patch, 'periodic', (False, False))['uv'.index(along.axis)] else ends[1:-1]
    return np.concatenate([knots, inner]).tolist()


def _once(pieces):
    """Without those that are the same as one before, forward or backward."""
    size = max((float(np.abs(piece).max()) for piece in pieces), default=1.0) or 1.0
    known = {}
    for piece in pieces:
        rounded = np.round(piece / size, _DIGITS) + 0.0
        known.setdefault(min(rounded.tobytes(), rounded[::-1].tobytes()), piece)
    return list(known.values())
