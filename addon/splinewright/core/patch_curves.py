"""Curves on patches: at one parameter, and around."""

from . import parameters, verbs
from .patch_verbs import Along

#: Sides as splinecore names them, and in words.
SIDES = {'u_start': "u start", 'u_end': "u end", 'v_start': "v start", 'v_end': "v end"}
#: A curve whose points lie so near to each other, as a part of the size of the patch, is a point.
_POINT = 1e-12


def isocurves(patches, number, at):
    """The curves on patches at pairs of an axis and a parameter, of one patch, or of all where the number is 0.

    Raises ValueError, naming the piece where there are several, if a parameter lies outside a patch or one is a point.
    """
    verbs.require_piece(patches, number, least=0)
    curves = []
    for i, patch in _chosen(patches, number):
        for axis, parameter in at:
            parameter = parameters.snapped(parameter, parameters.knots_of(Along(patch, axis)))
            try:
                curves.append(patch.isocurve(axis, parameter))
            except ValueError as error:
                raise type(error)(_named(patches, i, str(error))) from error
            if _is_point(curves[-1], patch):
                raise ValueError(_named(patches, i, f"at {axis} = {parameter:.6g} it is a point"))
    return curves


def boundaries(patches, number, sides):
    """(the curves around patches, why the sides that are none were left out), of one patch or of all.

    Raises ValueError if no curve is left.
    """
    verbs.require_piece(patches, number, least=0)
    curves, left_out = [], []
    for i, patch in _chosen(patches, number):
        for side in sides:
            curve, reason = _side(patch, side)
            if reason:
                left_out.append(_named(patches, i, f"{SIDES[side]} {reason}"))
            else:
                curves.append(curve)
    if not curves:
        raise ValueError(", ".join(left_out))
    return curves, left_out


def _side(patch, side):
    """(a curve, "") or (None, why there is none)."""
    if getattr(patch, 'periodic', (False, False))['uv'.index(side[0])]:
        return None, "is no side, the patch is periodic"
    try:
        curve = patch.boundary(side)
    except ValueError:
        return None, "lies at infinity"
    return (None, "is a point") if _is_point(curve, patch) else (curve, "")


def _chosen(patches, number):
    return [(i, patch) for i, patch in enumerate(patches) if number in (0, i + 1)]


def _named(patches, i, text):
    return f"piece {i + 1}: {text}" if len(patches) > 1 else text


def _is_point(curve, patch):
    if (curve.weights == 0).any():
        return False
    size = (patch.points.max(axis=(0, 1)) - patch.points.min(axis=(0, 1))).max()
    return bool((curve.points.max(axis=0) - curve.points.min(axis=0)).max() <= _POINT * size)
