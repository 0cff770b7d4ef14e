"""Curves on patches: at one parameter, and around."""

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..shape import parameters
from . import verbs
from .patch_verbs import Along

#: Sides as splinecore names them, and in words.
SIDES = {'u_start': "u start", 'u_end': "u end", 'v_start': "v start", 'v_end': "v end"}
#: Those of curves, too, as whatever holds names them.
PLACES = {**SIDES, 'start': "start", 'end': "end"}
#: (name, label, description) of each, to choose from.
SIDE_CHOICES = (("u_start", "u Start", "Where u starts"), ("u_end", "u End", "Where u ends"),
                ("v_start", "v Start", "Where v starts"), ("v_end", "v End", "Where v ends"))
#: A curve whose points lie so near to each other, as a part of the size of the patch, is a point.
_POINT = 1e-12


def named_side(side, number=None):
    """A side of a patch, or an end of a curve, in words; number: which of several pieces, counted from 1."""
    words = phrase(PLACES[side])
    return words if number is None else phrase("{number} {side}", number=number, side=words)


def isocurves(patches, number, at):
    """(the curves on patches at pairs of an axis and a parameter, why those that are none were left out), of one patch
    or of all where the number is 0. Raises Refusal if no curve is left.
    """
    return _found(patches, number, at, _isocurve)


def boundaries(patches, number, sides):
    """isocurves(), of the sides of patches."""
    return _found(patches, number, sides, side_of)


def _found(patches, number, wanted, find):
    verbs.require_piece(patches, number, least=0)
    curves, left_out = [], []
    for i, patch in enumerate(patches):
        for one in wanted if number in (0, i + 1) else ():
            curve, reason = find(patch, one)
            if not reason:
                curves.append(curve)
            else:
                left_out.append(phrase("piece {i}: {reason}", i=i + 1, reason=reason) if len(patches) > 1 else reason)
    if not curves:
        raise Refusal(", ".join(left_out))
    return curves, left_out


def _isocurve(patch, wanted):
    """(a curve, "") or (None, why there is none)."""
    axis, parameter = wanted
    parameter = parameters.snapped(parameter, parameters.knots_of(Along(patch, axis)))
    try:
        curve = patch.isocurve(axis, parameter)
    except sc.InvalidShape:
        return None, _why_none(patch, axis, parameter)
    return (None, phrase("at {axis} = {parameter:.6g} it is a point",
                         axis=axis, parameter=parameter)) if _is_point(curve, patch) else (curve, "")


def _why_none(patch, axis, parameter):
    start, end = patch.domain['uv'.index(axis)]
    if start <= parameter <= end:
        return phrase("at {axis} = {parameter:.6g} it lies at infinity", axis=axis, parameter=parameter)
    return phrase("{axis} = {parameter:.6g} is outside the domain [{start:.6g}, {end:.6g}]", axis=axis, parameter=parameter, start=start, end=end)


def side_of(patch, side):
    """(the curve of a side, "") or (None, why there is none)."""
    if getattr(patch, 'periodic', (False, False))['uv'.index(side[0])]:
        return None, phrase("{side} is no side, the patch is periodic", side=SIDES[side])
    try:
        curve = patch.boundary(side)
    except sc.InvalidShape:
        return None, phrase("{side} lies at infinity", side=SIDES[side])
    return (None, phrase("{side} is a point", side=SIDES[side])) if _is_point(curve, patch) else (curve, "")


def _is_point(curve, patch):
    if (curve.weights == 0).any():
        return False
    size = (patch.points.max(axis=(0, 1)) - patch.points.min(axis=(0, 1))).max()
    return bool((curve.points.max(axis=0) - curve.points.min(axis=0)).max() <= _POINT * size)
