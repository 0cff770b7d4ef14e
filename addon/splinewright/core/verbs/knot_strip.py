"""The knots of a curve, or of a patch along an axis, as marks on a bar: what stands at each, where it may be moved."""

import math
from bisect import bisect
from decimal import Decimal
from typing import NamedTuple

import numpy as np

from ..base.words import phrase
from ..shape import describe

#: A knot that is moved by the mouse keeps away from its neighbors by this part of what lies between them.
_AWAY = 1e-3
#: What is nearer to 0, as a part of the bar, is written as 0.
_NOTHING = 1e-9
_STEPS = (Decimal(1), Decimal(2), Decimal(5), Decimal(10))
ENDS_STAY = "the ends of the domain stay where they are: Reparameterize gives another domain"
SEAM_STAYS = "a periodic curve begins at this knot, which stays where it is"
NO_KNOTS = "a Bezier piece has no knots to move"
NO_ROOM = "there is no room between the knots beside it"


class Bar(NamedTuple):
    """Distinct knots, growing; of a Hermite piece its parameters, of a Bezier piece its ends."""

    kind: str                           # of the piece
    name: str                           # of the axis of a patch, or ""
    degree: int
    is_periodic: bool
    values: np.ndarray                  # (n,)
    firsts: np.ndarray                  # (n,) where each stands first among the knots
    counts: np.ndarray                  # (n,) how often it stands there; at the seam of a periodic curve on both sides
    domain: tuple                       # numbers of the marks where it starts and ends

    @property
    def span(self):
        """From where to where the bar reaches."""
        return float(self.values[0]), float(self.values[-1])


def bars_of(piece):
    """The Bars of a core.shape.definition.Piece: one of a curve, two of a patch."""
    degrees = describe.degrees(piece)
    names = ("",) if len(degrees) == 1 else ("u", "v")
    knots = piece.knots or (np.array([0.0, 1.0]),) * len(degrees)
    periodic = piece.periodic or (False,) * len(degrees)
    return tuple(Bar(piece.kind, *of_axis[:3], *_marks(piece.kind, *of_axis[1:]))
                 for of_axis in zip(names, degrees, periodic, knots))


def _marks(kind, degree, is_periodic, knots):
    values, firsts, counts = np.unique(knots, return_index=True, return_counts=True)
    if kind != 'nurbs':
        return values, firsts, counts, (0, len(values) - 1)
    if is_periodic:
        counts[[0, -1]] = counts[0] + counts[-1] - 1
        return values, firsts, counts, (0, len(values) - 1)
    ends = np.searchsorted(values, [knots[degree], knots[-1 - degree]])
    return values, firsts, counts, tuple(ends.tolist())


def is_inside(bar, i):
    """Whether a mark lies in the domain, its ends among it."""
    return bar.domain[0] <= i <= bar.domain[1]


def smoothness(bar, i):
    """How often a spline of these knots is differentiable at a mark, at least; -1: a gap; None where that says nothing."""
    is_inner = bar.domain[0] < i < bar.domain[1]
    return bar.degree - int(bar.counts[i]) if bar.kind == 'nurbs' and (is_inner or bar.is_periodic) else None


def words(bar, i):
    """What stands at a mark besides its number."""
    if bar.kind != 'nurbs':
        return ""
    known = smoothness(bar, i)
    how = "" if known is None else f" C{known}" if known >= 0 else " gap"
    return f"×{bar.counts[i]}{how}"


def number(bar, value):
    """A parameter as text, with as many digits as show a thousandth of the bar."""
    start, end = bar.span
    size = max(abs(start), abs(end))
    width = end / size - start / size
    if abs(value) / size < _NOTHING * width:
        return "0"
    digits = math.ceil(math.log10(1.0 / width)) + 4
    return f"{value:.{min(max(digits, 4), 17)}g}"


def fractions(values, span):
    """Where parameters lie, from 0 at the start of a bar to 1 at its end."""
    size = max(map(abs, span))
    start, end = (number / size for number in span)
    return (np.asarray(values) / size - start) / (end - start)


def at_fraction(fraction, span):
    """The parameter at a part of a bar."""
    size = max(map(abs, span))
    start, end = (number / size for number in span)
    return (start + fraction * (end - start)) * size


def nearest(places, x, within):
    """The number of the mark nearest to a pixel among those at these pixels, growing; None where none is so near."""
    distances = np.abs(np.asarray(places) - x)
    i = int(distances.argmin())
    return i if distances[i] <= within else None


def why_fixed(bar, i):
    """Why a knot cannot be moved, as a sentence, or ""."""
    if bar.kind == 'bezier':
        return NO_KNOTS
    is_end, is_outer = i in bar.domain, i in (0, len(bar.values) - 1)
    if is_end and bar.is_periodic:
        return SEAM_STAYS
    if is_end and is_outer:
        return ENDS_STAY
    low, high = reach(bar, i)
    return "" if low < high else NO_ROOM


def neighbors(bar, i):
    """Between which parameters a knot may lie, without them."""
    low = float(bar.values[i - 1]) if i else -math.inf
    high = float(bar.values[i + 1]) if i + 1 < len(bar.values) else math.inf
    return low, high


def where(bar, i):
    """neighbors() in words."""
    low, high = (number(bar, value) if math.isfinite(value) else "" for value in neighbors(bar, i))
    return phrase("between {low} and {high}", low=low, high=high) if low and high else phrase("above {low}",
                                                                   low=low) if low else phrase("below {high}", high=high)


def reach(bar, i):
    """From where to where the mouse moves a knot: on the bar, and not quite to its neighbors."""
    low, high = (min(max(number, bar.span[0]), bar.span[1]) for number in neighbors(bar, i))
    away = _AWAY * high - _AWAY * low
    below, above = low + away, high - away
    if below <= low and i or above >= high and i + 1 < len(bar.values):
        return float(bar.values[i]), float(bar.values[i])
    return (below if i else low), (above if i + 1 < len(bar.values) else high)


def is_between(bar, i, value):
    low, high = neighbors(bar, i)
    return low < value < high


def step(width, pixels):
    """The Decimal 1, 2 or 5 times a power of 10 that is at least this number of pixels on a bar of a width in parameters for
    each pixel."""
    least = Decimal(repr(width)) * Decimal(repr(pixels))
    power = Decimal(1).scaleb(least.adjusted())
    return next(number * power for number in _STEPS if number * power >= least)


def rounded(value, step):
    """The float nearest to the multiple of a Decimal step that is nearest to a parameter."""
    return float(Decimal(round(Decimal(value) / step)) * step)


def within(value, step, low, high):
    """rounded(), or where that lies beyond low or high the parameter itself, no farther than these."""
    near = rounded(value, step)
    return near if low <= near <= high else min(max(value, low), high)


def thinned(lefts, widths):
    """(n,) bool: which of texts that begin at these places, and are so wide, are written where none overlaps. A text that is
    wanted most comes first."""
    shown, taken = np.zeros(len(lefts), bool), []
    for i, (left, width) in enumerate(zip(lefts, widths)):
        at = bisect(taken, (left, left + width))
        is_free = (not at or taken[at - 1][1] <= left) and (at == len(taken) or left + width <= taken[at][0])
        if is_free:
            taken.insert(at, (left, left + width))
            shown[i] = True
    return shown


def by_weight(bar):
    """Numbers of the marks, those first that tell most: the ends of the domain, then knots that are there several times."""
    inner = [i for i in np.argsort(-bar.counts, kind='stable').tolist() if i not in bar.domain]
    outside = [i for i in inner if not is_inside(bar, i)]
    return [*bar.domain, *(i for i in inner if is_inside(bar, i)), *outside]
