"""Measures of shapes: of the whole, and at a place of one of its curves or patches."""

from contextlib import suppress
from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.library import sc
from ..base.words import phrase
from ..shape import definition as definitions
from ..shape import transform
from ..verbs import verbs

#: Of lengths, areas and volumes, which are shown with fewer digits.
_TOLERANCE = 1e-7
#: Of numbers at the mouse.
_DIGITS = 4
#: A coordinate so far below the largest is none.
_ROUNDING = 1e-12


class Whole(NamedTuple):
    """What a shape measures; None of what it has none, and why that is, where it is to be told."""

    length: float | None = None
    area: float | None = None
    volume: float | None = None
    box: np.ndarray | None = None       # (2, 3)
    problems: tuple = ()                # a sentence for each measure that was refused


class Moved(NamedTuple):
    """A definition in another space, with its curves or patches."""

    definition: definitions.Definition
    pieces: list


def moved(definition, matrix):
    """The Moved of a definition under a (4, 4) affine matrix. Raises Refusal where that is flat."""
    there = definition if np.array_equal(matrix, np.eye(4)) else transform.transformed(definition, matrix)
    return Moved(there, verbs.pieces_of(there))


def whole(shape, cancel=None):
    """The Whole of a Moved. cancel: as the library takes it. Raises Cancelled."""
    found, problems = {}, []
    for name, measure in _measures(shape, cancel).items():
        try:
            found[name] = measure()
        except sc.Cancelled:
            raise
        except sc.Error as error:
            problems.append(str(error))
    return Whole(**found, problems=tuple(dict.fromkeys(problems)))


def _measures(shape, cancel):
    """A function for each field of Whole that there may be."""
    if shape.definition.has_curves:
        return {'length': lambda: sum(curve.length(tolerance=_TOLERANCE, cancel=cancel)
                                      for curve in _heeding(shape.pieces, cancel)),
                'box': lambda: _around([curve.bounding_box() for curve in _heeding(shape.pieces, cancel)])}
    patch_set = definitions.to_patch_set(shape.definition)
    return {'area': lambda: patch_set.area(tolerance=_TOLERANCE, cancel=cancel), 'volume': lambda: _volume(patch_set, cancel),
            'box': lambda: patch_set.bounding_box(tolerance=1e-9, cancel=cancel)}


def _heeding(pieces, cancel):
    """Pieces, one after the other, until it is called off. Raises Cancelled."""
    for piece in pieces:
        if cancel is not None and cancel():
            raise sc.Cancelled("cancelled")
        yield piece


def _volume(patch_set, cancel):
    """None of sets that are open."""
    try:
        return patch_set.volume(tolerance=_TOLERANCE, cancel=cancel)
    except sc.InvalidShape:
        return None


def _around(boxes):
    return np.stack([np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)])


def at_parameter(piece, fractions, cancel=None):
    """[(name, number or (3,) vector)] at parts (u, v) of the domain of a curve or patch. Raises what the library raises
    where it runs to infinity or has no direction. cancel: as the library takes it; what takes too long is left out."""
    return _on_patch(piece, fractions) if _is_patch(piece) else _on_curve(piece, fractions[0], cancel)


def _is_patch(piece):
    return isinstance(piece.domain[0], tuple)


def _place(domain, fraction):
    start, end = domain
    return min(max(start + fraction * (end - start), start), end)


def _on_curve(curve, fraction, cancel):
    u = _place(curve.domain, fraction)
    rows = [("u", u), ("Point", _point(curve, u)), ("Tangent", curve.frames(u)[0]), *_bend_of_curve(curve, u)]
    with suppress(sc.Cancelled):
        rows.append(("Length to here", curve.length(curve.domain[0], u, tolerance=_TOLERANCE, cancel=cancel)))
    return rows


def _bend_of_curve(curve, u):
    curvature = _cleared(curve.curvature(u), 1.0 / _size(curve))
    if not curvature > 0.0:
        return [("Curvature", curvature)]
    torsion = float(curve.torsion(u))
    is_flat = abs(torsion) <= _ROUNDING * curvature
    return [("Curvature", curvature), ("Radius", 1.0 / curvature), ("Torsion", 0.0 if is_flat else torsion)]


def _on_patch(patch, fractions):
    u, v = (_place(domain, fraction) for domain, fraction in zip(patch.domain, fractions))
    _, normals = patch.evaluate_grid_with_normals([u], [v])
    return [("u", u), ("v", v), ("Point", _point(patch, u, v)), ("Normal", normals[0, 0]), *_bend_of_patch(patch, u, v)]


def _bend_of_patch(patch, u, v):
    bend, unit = patch.curvatures(u, v), 1.0 / _size(patch)
    least, most = (_cleared(number, unit) for number in (np.min(bend.principal), np.max(bend.principal)))
    return [("Curvature min", least), ("Curvature max", most), ("Mean", _cleared(bend.mean, unit)),
            ("Gauss", float(bend.gauss) if least and most else 0.0)]


def _point(piece, *parameters):
    """Coordinates that are rounding beside the size of the piece are 0."""
    size = _size(piece)
    return np.array([_cleared(coordinate, size) for coordinate in piece.evaluate(*parameters)])


def _size(piece):
    """How far the control points of a piece that are finite lie apart along an axis; 1 where all are one."""
    points = np.asarray(piece.points).reshape(-1, 3)
    return float(np.ptp(points[np.isfinite(points).all(axis=1)], axis=0).max(initial=0.0)) or 1.0


def _cleared(number, unit):
    """A number, or 0 where it is rounding beside a unit."""
    return 0.0 if abs(number) <= _ROUNDING * unit else float(number)


def fractions_of(piece, parameters):
    """The parts (u, v) of the domain of a curve or patch at which parameters lie; v is 0 on a curve."""
    domains = piece.domain if _is_patch(piece) else (piece.domain,)
    found = [(at - start) / (end - start) for (start, end), at in zip(domains, parameters)]
    return (*found, 0.0)[:2]


class Place(NamedTuple):
    """The values shown at a place of a curve or patch while one points at it."""

    point: np.ndarray                   # (3,)
    arms: tuple                         # unit vectors: tangent and normal of a curve; along u, along v and normal of a patch
    words: tuple                        # lines of text


def place(piece, parameters):
    """The Place at parameters. Raises as at_parameter() does."""
    at = ", ".join(f"{name} {decimals.text_of(number, _DIGITS)}" for name, number in zip("uv", parameters))
    point = _point(piece, *parameters)
    if not _is_patch(piece):
        bend = dict(_bend_of_curve(piece, parameters[0]))
        arms = piece.frames(parameters[0], 'frenet')[:2] if "Radius" in bend else piece.frames(parameters[0])[:1]
        rows = [("Tangent", arms[0]), *((name, (number,)) for name, number in bend.items())]
    else:
        bend = dict(_bend_of_patch(piece, *parameters))
        arms = _arms_of_patch(piece, *parameters)
        principal = bend["Curvature min"], bend["Curvature max"]
        radii = [1.0 / number if number else np.inf for number in principal]
        rows = [("Normal", arms[-1]), ("Curvatures", principal), ("Radii", radii)]
    words = (phrase("{name} {numbers}", name=phrase(name), numbers=", ".join(decimals.text_of(number, _DIGITS) for number in shown(numbers)))
             for name, numbers in (("Point", point), *rows))
    return Place(point, tuple(arms), (at, *words))


def shown(value):
    """(n,) numbers to be shown of a number or a vector: a coordinate far below the largest is none."""
    numbers = np.atleast_1d(value)
    size = np.abs(numbers[np.isfinite(numbers)]).max(initial=0.0)
    return [float(number) for number in np.where(np.abs(numbers) <= _ROUNDING * size, 0.0, numbers)]


def _arms_of_patch(patch, u, v):
    _, normals = patch.evaluate_grid_with_normals([u], [v])
    _, along_u, along_v = patch.first_derivatives(u, v)
    return [*(vector / np.linalg.norm(vector) for vector in (along_u, along_v) if vector.any()), normals[0, 0]]
