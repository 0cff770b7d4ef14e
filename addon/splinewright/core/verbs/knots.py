"""Knots as text."""

from dataclasses import replace

import numpy as np

from ..base.failures import Refusal
from ..shape import definition as definitions
from ..shape import shared_knots
from . import knot_strip

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
        raise Refusal("{count} knots were given, {needed} are needed for these points and this degree",
                      "{count} knot was given, {needed} are needed for these points and this degree",
                      count=len(new), needed=len(old[axis]))
    _require_order(new, is_parameters=definition.pieces[piece].kind == 'hermite')
    changed = _with_knots(definition, piece, axis, new)
    definitions.to_value(changed)       # the library refuses what is not a knot vector
    return changed


def moved(definition, alongs, number, to):
    """The definition with a knot, counted from 0, moved between its neighbors; its copies go along, and the same ones
    of the other patches.

    alongs: as of core.shape.shared_knots.together(). Raises Refusal where there is none, or it may not lie there.
    """
    piece, axis, _ = alongs[0]
    old = _knots(definition, piece, axis)[axis]
    bar = knot_strip.bars_of(definition.pieces[piece])[axis]
    if not 0 <= number < len(old):
        raise Refusal("there are {count} knots, and none of number {number}", count=len(old), number=number + 1)
    found = int(np.searchsorted(bar.firsts, number, 'right')) - 1
    if knot_strip.why_fixed(bar, found):
        raise Refusal(knot_strip.why_fixed(bar, found))
    if not knot_strip.is_between(bar, found, to):
        raise Refusal("this knot lies {where}", where=knot_strip.where(bar, found))
    for along in alongs:
        known = definition.pieces[along.piece].knots[along.axis]
        is_meant = old[::-1] == old[number] if along.is_turned else old == old[number]
        there = to if along is alongs[0] else shared_knots.carried(to, old, known, along.is_turned)
        definition = _with_knots(definition, along.piece, along.axis, np.where(is_meant, there, known))
    definitions.to_value(definition)    # the library refuses what is not a knot vector
    return definition


def _with_knots(definition, piece, axis, new):
    pieces = list(definition.pieces)
    knots = tuple(new if i == axis else vector for i, vector in enumerate(pieces[piece].knots))
    pieces[piece] = replace(pieces[piece], knots=knots)
    return replace(definition, pieces=tuple(pieces))


def _require_order(numbers, is_parameters):
    """Raises Refusal where a number is smaller than the one before it, or of parameters not larger."""
    steps = np.diff(numbers)
    wrong = np.flatnonzero(steps <= 0 if is_parameters else steps < 0)
    if len(wrong):
        i = int(wrong[0])
        raise Refusal("parameter {i}, {number:g}, is not larger than the one before it, {before:g}" if is_parameters else
                      "knot {i}, {number:g}, is smaller than the one before it, {before:g}",
                      i=i + 2, number=numbers[i + 1], before=numbers[i])


def _knots(definition, piece, axis):
    if not 0 <= piece < len(definition.pieces):
        count = len(definition.pieces)
        raise Refusal("the shape has {count} pieces, there is none of number {number}",
                      "the shape has {count} piece, there is none of number {number}", count=count, number=piece + 1)
    if not definition.pieces[piece].knots:
        raise Refusal("a Bezier piece has no knots")
    knots = definition.pieces[piece].knots
    if axis >= len(knots):
        raise Refusal("a curve has no knots along v")
    return knots


def _numbers(text):
    words = text.replace(",", " ").split()
    if len(words) > _MOST:
        raise Refusal("{count} knots are too many", count=len(words))
    numbers = []
    for i, word in enumerate(words, 1):
        try:
            numbers.append(float(word))
        except ValueError:
            raise Refusal("'{word}', word {i} of the knots, is not a number", word=word[:40], i=i) from None
    return np.array(numbers, dtype=np.float64)
