"""Measures of shapes: of the whole, and at a place of one of its curves or patches."""

from typing import NamedTuple

import numpy as np

from . import definition as definitions
from . import transform, verbs
from .library import sc

#: Of lengths, areas and volumes, which are shown with fewer digits.
_TOLERANCE = 1e-7


class Whole(NamedTuple):
    """What a shape measures; None of what it has none, and why that is, where it is to be told."""

    length: float | None
    area: float | None
    volume: float | None
    box: np.ndarray | None              # (2, 3)
    problem: str = ""


class Moved(NamedTuple):
    """A definition in another space, with its curves or patches."""

    definition: definitions.Definition
    pieces: list


def moved(definition, matrix):
    """The Moved of a definition under a (4, 4) affine matrix. Raises Refusal where that is flat."""
    there = definition if np.array_equal(matrix, np.eye(4)) else transform.transformed(definition, matrix)
    return Moved(there, verbs.pieces_of(there))


def whole(shape):
    """The Whole of a Moved."""
    try:
        if shape.definition.has_curves:
            return Whole(sum(curve.length(tolerance=_TOLERANCE) for curve in shape.pieces), None, None,
                         _around([curve.bounding_box() for curve in shape.pieces]))
        patch_set = definitions.to_patch_set(shape.definition)
        return Whole(None, patch_set.area(tolerance=_TOLERANCE), _volume(patch_set), patch_set.bounding_box(tolerance=1e-9))
    except sc.Error as error:
        return Whole(None, None, None, None, str(error))


def _volume(patch_set):
    """None of sets that are open."""
    try:
        return patch_set.volume(tolerance=_TOLERANCE)
    except sc.Error:
        return None


def _around(boxes):
    return np.stack([np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)])


def at_parameter(piece, fractions):
    """[(name, number or (3,) vector)] at parts (u, v) of the domain of a curve or patch. Raises what the library raises
    where it runs to infinity or has no direction."""
    return _on_patch(piece, fractions) if _is_patch(piece) else _on_curve(piece, fractions[0])


def _is_patch(piece):
    return isinstance(piece.domain[0], tuple)


def _place(domain, fraction):
    start, end = domain
    return min(max(start + fraction * (end - start), start), end)


def _on_curve(curve, fraction):
    u = _place(curve.domain, fraction)
    curvature = float(curve.curvature(u))
    frame = curve.frames(u)
    rows = [("u", u), ("Point", curve.evaluate(u)), ("Tangent", frame[0]), ("Curvature", curvature)]
    if curvature > 0.0:
        rows += [("Radius", 1.0 / curvature), ("Torsion", float(curve.torsion(u)))]
    return [*rows, ("Length to here", curve.length(curve.domain[0], u, tolerance=_TOLERANCE))]


def _on_patch(patch, fractions):
    u, v = (_place(domain, fraction) for domain, fraction in zip(patch.domain, fractions))
    _, normals = patch.evaluate_grid_with_normals([u], [v])
    bend = patch.curvatures(u, v)
    return [("u", u), ("v", v), ("Point", patch.evaluate(u, v)), ("Normal", normals[0, 0]),
            ("Curvature min", float(np.min(bend.principal))), ("Curvature max", float(np.max(bend.principal))),
            ("Mean", float(bend.mean)), ("Gauss", float(bend.gauss))]
