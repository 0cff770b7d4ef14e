"""Knots as text."""

from dataclasses import replace

import numpy as np

from . import definition as definitions
from .failures import Refusal

#: More numbers than this in one text are refused.
_MOST = 1_000_000


def text_of(definition, piece, axis):
    """The knots of a piece, counted from 0, every digit. Raises Refusal where it has none."""
    return " ".join(repr(float(knot)).removesuffix(".0") for knot in _knots(definition, piece, axis)[axis])


def replaced(definition, piece, axis, text):
    """The definition with other knots for a piece along an axis.

    Raises Refusal, naming the word or the knot, where the text is not a knot vector that fits.
    """
    old = _knots(definition, piece, axis)
    new = _numbers(text)
    if len(new) != len(old[axis]):
        raise Refusal(f"{len(new)} knots were given, {len(old[axis])} are needed for these points and this degree")
    _require_order(new, is_parameters=definition.pieces[piece].kind == 'hermite')
    knots = tuple(new if i == axis else vector for i, vector in enumerate(old))
    pieces = list(definition.pieces)
    pieces[piece] = replace(pieces[piece], knots=knots)
    changed = replace(definition, pieces=tuple(pieces))
    definitions.to_value(changed)       # the library refuses what is not a knot vector
    return changed


def _require_order(numbers, is_parameters):
    """Raises Refusal where a number is smaller than the one before it, or of parameters not larger."""
    steps = np.diff(numbers)
    wrong = np.flatnonzero(steps <= 0 if is_parameters else steps < 0)
    if len(wrong):
        i, noun = int(wrong[0]), "parameter" if is_parameters else "knot"
        how = "not larger" if is_parameters else "smaller"
        raise Refusal(f"{noun} {i + 2}, {numbers[i + 1]:g}, is {how} than the one before it, {numbers[i]:g}")


def _knots(definition, piece, axis):
    if not 0 <= piece < len(definition.pieces):
        count = len(definition.pieces)
        raise Refusal(f"the shape has {count} piece{'s' if count > 1 else ''}, there is none of number {piece + 1}")
    if not definition.pieces[piece].knots:
        raise Refusal("a Bezier piece has no knots")
    knots = definition.pieces[piece].knots
    if axis >= len(knots):
        raise Refusal("a curve has no knots along v")
    return knots


def _numbers(text):
    words = text.replace(",", " ").split()
    if len(words) > _MOST:
        raise Refusal(f"{len(words)} knots are too many")
    numbers = []
    for i, word in enumerate(words, 1):
        try:
            numbers.append(float(word))
        except ValueError:
            raise Refusal(f"'{word[:40]}', word {i} of the knots, is not a number") from None
    return np.array(numbers, dtype=np.float64)
