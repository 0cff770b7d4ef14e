"""A definition in words, for the panel."""

import numpy as np

from ..base.words import phrase

#: Knots below this part of the largest one are shown as 0.
_ROUNDING = 1e-12
KINDS = {'bezier': "Bezier", 'hermite': "Hermite", 'nurbs': "NURBS"}
_ONE = {('bezier', "curve"): "Bezier curve", ('hermite', "curve"): "Hermite curve", ('nurbs', "curve"): "NURBS curve",
        ('bezier', "patch"): "Bezier patch", ('hermite', "patch"): "Hermite patch", ('nurbs', "patch"): "NURBS patch"}
_KNOTS = {'periodic': "{number}, periodic", 'clamped': "{number}, clamped", 'unclamped': "{number}, unclamped"}


def lines(definition):
    """Pairs of a label and a text."""
    pieces = definition.pieces
    noun = "curve" if definition.has_curves else "patch"
    if len(pieces) > 1:
        return _summary(definition, noun)
    piece = pieces[0]
    found = [("Kind", _ONE[piece.kind, noun]),
             ("Degree", _times(degrees(piece))),
             ("Points", _times(_counts(piece, noun)))]
    if piece.kind == 'nurbs':
        names = [""] if noun == "curve" else [" U", " V"]
        for name, knots, degree, periodic in zip(names, piece.knots, piece.degree, piece.periodic):
            found.append((phrase("Knots{name}", name=name), phrase(_KNOTS[knot_type(knots, degree, periodic)], number=len(knots))))
            found.append(("", knots_text(knots)))
    if is_rational(definition):
        found.append(("Weights", "rational"))
    return found


def _summary(definition, noun):
    kinds = sorted({KINDS[piece.kind] for piece in definition.pieces})
    of_all = sorted({degrees(piece) for piece in definition.pieces})
    pattern = "{count} {kinds} curves" if noun == "curve" else "{count} {kinds} patches"
    found = [("Kind", phrase(pattern, count=len(definition.pieces), kinds=", ".join(kinds))),
             ("Degrees", ", ".join(_times(d) for d in of_all)),
             ("Points", phrase("{count} in the pool", count=len(definition.pool)))]
    if is_rational(definition):
        found.append(("Weights", "rational"))
    return found


def knot_type(knots, degree, periodic):
    """'periodic', 'clamped' or 'unclamped'."""
    if periodic:
        return "periodic"
    start, end = knots[:degree + 1], knots[-degree - 1:]
    return "clamped" if start[0] == start[-1] and end[0] == end[-1] else "unclamped"


def knots_text(knots, limit=12):
    """The knots as short numbers, the middle left out where there are many."""
    rounding = _ROUNDING * max(map(abs, knots), default=0.0)
    texts = ["0" if abs(knot) <= rounding else f"{knot:.4g}" for knot in knots]
    if len(texts) > limit:
        texts = texts[:limit // 2] + ["…"] + texts[-limit // 2:]
    return " ".join(texts)


def degrees(piece):
    """Of each axis of a piece."""
    if piece.kind == 'hermite':
        return (3,) * (piece.indices.ndim - 1)
    if piece.kind == 'bezier':
        return tuple(count - 1 for count in piece.indices.shape)
    return tuple(piece.degree)


def _counts(piece, noun):
    return piece.indices.shape[-1:] if noun == "curve" else piece.indices.shape[-2:]


def _times(numbers):
    return " × ".join(str(number) for number in numbers)


def is_rational(definition):
    used = [piece.indices.ravel() for piece in definition.pieces if piece.kind != 'hermite']
    return bool(used) and bool((definition.pool[np.concatenate(used), 3] != 1.0).any())
