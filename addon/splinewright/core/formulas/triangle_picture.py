"""The triangular scheme of basis functions (S14): spans, functions of degree 0, 1, … beside each other, each fed by the two to its left.

A chosen function shows the two that feed it with both coefficients of Cox and de Boor, or all that it depends on; a chosen span
all functions that are not zero there.
"""

import re
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.words import phrase
from . import functions, signs
from .functions import TICK, Part

LINK, PARENTS, SUPPORT, WEDGE = "link", "parents", "support", "wedge"
#: Most functions of a picture.
MOST = 150
#: The parts of the way between two functions that their arrow leaves free.
_FREE = 0.22
#: How far the border of a wedge lies around it, as a part of the distance of functions.
_AROUND = 0.35


_FUNCTION = re.compile(signs.MARK + r' N_\{(\d+),(\d+)\}( = 0)?')


class Item(NamedTuple):
    """A function or a span of a picture."""

    is_span: bool
    i: int
    degree: int                         # of a function
    is_zero: bool                       # whether a function is, everywhere
    name: str                           # as it is written
    point: tuple                        # (3,): where it stands


class Scheme(NamedTuple):
    """Functions of a degree and lower ones on knots, and where they stand."""

    degree: int
    knots: np.ndarray
    across: float
    down: float

    def count(self, degree):
        return len(self.knots) - degree - 1

    def is_zero(self, i, degree):
        return self.knots[i] == self.knots[i + degree + 1]

    def place(self, i, degree):
        return np.array([degree * self.across, -(i + degree / 2.0) * self.down, 0.0])

    def has(self, i, degree):
        return 0 <= degree <= self.degree and 0 <= i < self.count(degree)


def scheme(degree, knots, across, down):
    """The Scheme. Raises Refusal for knots that have none."""
    functions.of_knots(degree, knots)
    made = Scheme(degree, np.asarray(knots, dtype=np.float64), across, down)
    number = sum(made.count(level) for level in range(degree + 1))
    if number > MOST:
        raise Refusal("these are {count} functions with those of lower degrees: {most} are the most", count=number, most=MOST)
    return made


def picture(of, chosen, is_support, spans, marker):
    """The Parts of a Scheme. chosen: functions (i, degree); is_support: whether all that they depend on is shown, not their two parents
    with coefficients; spans: numbers of spans. Raises Refusal for one that is not there."""
    for i, degree in chosen:
        if not of.has(i, degree):
            raise Refusal("there is no function N_{i},{degree}: the highest are N_0,{of_degree} to N_{count},{of_degree}",
                          i=i, degree=degree, of_degree=of.degree, count=of.count(of.degree) - 1)
    for span in spans:
        if not of.has(span, 0):
            raise Refusal("there is no span {span}: they are 0 to {count}", span=span, count=of.count(0) - 1)
    names, texts = {}, []
    for i, degree in chosen:
        if is_support:
            _name(names, _support(of, i, degree), f"{SUPPORT} {i},{degree}")
        else:
            _name(names, _feeding(of, i, degree), f"{PARENTS} {i},{degree}")
            texts += _coefficients(of, i, degree, marker)
    for span in spans:
        _name(names, _wedge(of, span), f"{WEDGE} {span}")
    links = [(link, names.get(link, LINK)) for link in _links(of)]
    return _functions(of, marker) + [_arrow(of, link, name) for link, name in links] + texts + [_border(of, span) for span in spans]


def items(definition):
    """The Items of a picture()."""
    found, spans = [], 0
    for piece in definition.pieces:
        function = _FUNCTION.fullmatch(piece.name)
        if not function and not piece.name.startswith(f"{TICK} "):
            continue
        rows = definition.pool[piece.indices, :3]
        place = tuple(((rows.min(axis=0) + rows.max(axis=0)) / 2.0).tolist())
        if function:
            i, degree = map(int, function.groups()[:2])
            found.append(Item(False, i, degree, function[3] is not None, f'N{i},{degree}', place))
        else:
            found.append(Item(True, spans, 0, False, piece.name.partition(" ")[2], place))
            spans += 1
    return found


def in_words(definition, item):
    """What a picture() points out, where it was given this Item last."""
    known = {(each.i, each.degree): each for each in items(definition) if not each.is_span}
    if item.is_span:
        on = [each.name for (i, degree), each in known.items() if item.i - degree <= i <= item.i]
        is_empty = known[item.i, 0].is_zero
        return phrase("the span {span} is empty", span=item.name) if is_empty else phrase(
            "not zero on {span}: {names}", span=item.name, names=", ".join(on))
    if item.is_zero:
        return phrase("{name} is zero: its knots coincide", name=item.name)
    if item.degree == 0:
        return phrase("{name} is 1 on its span, and 0 elsewhere", name=item.name)
    texts = [piece.name.partition(" ")[2] for piece in definition.pieces
             if piece.name.startswith(f"{signs.MARK} ") and not _FUNCTION.fullmatch(piece.name)]
    if not any(piece.name == f"{PARENTS} {item.i},{item.degree}" for piece in definition.pieces) or len(texts) < 2:
        return phrase("{name} and all that it depends on", name=item.name)
    one, other = (known[i, item.degree - 1].name for i in (item.i, item.i + 1))
    return f'{item.name} = {_factor(texts[-2])} {one} + {_factor(texts[-1])} {other}'


def _factor(text):
    """A coefficient as it stands before a function."""
    return f'({text})' if text[0] == "-" or "/" not in text and not text.isalnum() else text


def lines_of(definition, item):
    """The polylines (n, 3) that point out an Item of a picture()."""
    names = {f"{WEDGE} {item.i}"} if item.is_span else {f"{name} {item.i},{item.degree}" for name in (PARENTS, SUPPORT)}
    return [definition.pool[piece.indices, :3] for piece in definition.pieces if piece.name in names]


def _name(names, links, name):
    for link in links:
        names.setdefault(link, name)


def _links(of):
    """[((i, degree), (i, degree))]: from each function that is not zero to those that it feeds."""
    return [(below, (i, degree)) for degree in range(1, of.degree + 1) for i in range(of.count(degree))
            for below, _ in _feeding(of, i, degree)]


def _feeding(of, i, degree):
    return [((j, degree - 1), (i, degree)) for j in (i, i + 1) if degree > 0 and not of.is_zero(j, degree - 1)]


def _support(of, i, degree):
    return [link for level in range(degree, 0, -1) for j in range(i, i + degree - level + 1) for link in _feeding(of, j, level)]


def _on_span(of, span):
    """{(i, degree)}: all functions that are not zero on a span."""
    if of.is_zero(span, 0):
        return set()
    return {(i, degree) for degree in range(of.degree + 1) for i in range(span - degree, span + 1) if of.has(i, degree)}


def _wedge(of, span):
    on = _on_span(of, span)
    return [(below, above) for below, above in _links(of) if below in on and above in on]


def _functions(of, marker):
    shown = []
    for i in range(of.count(0)):
        place = of.place(i, 0) - (0.8 * of.across, 0.0, 0.0)
        text = f"[{of.knots[i]:.6g}, {of.knots[i + 1]:.6g})"
        shown.append(Part(f"{TICK} {text}", functions.line(tuple(place - (marker, 0, 0)), tuple(place + (marker, 0, 0)))))
    for degree in range(of.degree + 1):
        for i in range(of.count(degree)):
            zero = " = 0" if of.is_zero(i, degree) else ""
            shown += signs.cross(f"N_{{{i},{degree}}}{zero}", of.place(i, degree), marker)
    return shown


def _arrow(of, link, name):
    start, end = (of.place(*each) for each in link)
    arrow, = signs.arrow("", start + _FREE * (end - start), (1.0 - 2.0 * _FREE) * (end - start))
    return Part(name, arrow.curve)


def _coefficients(of, i, degree, marker):
    if degree == 0:
        return []
    u, middle = of.knots, of.place(i, degree)
    texts = (_ahead(u[i], u[i + degree] - u[i]), _behind(u[i + degree + 1], u[i + degree + 1] - u[i + 1]))
    places = ((of.place(j, degree - 1) + middle) / 2.0 for j in (i, i + 1))
    return [part for text, place in zip(texts, places) for part in signs.cross(text, place, marker / 2.0)]


def _ahead(first, width):
    """(u - first) / width, as a text without spaces; 0 where that is 0/0."""
    if width == 0.0:
        return "0"
    text = "u" if first == 0.0 else f"u{-first:+.6g}"
    return text if width == 1.0 else f"{text if first == 0.0 else f'({text})'}/{width:.6g}"


def _behind(last, width):
    """(last - u) / width."""
    if width == 0.0:
        return "0"
    text = "-u" if last == 0.0 else f"{last:.6g}-u"
    return text if width == 1.0 else f"{text if last == 0.0 else f'({text})'}/{width:.6g}"


def _border(of, span):
    """Around the span and its functions."""
    on = _on_span(of, span) or {(span, 0)}
    rows = [sorted(i for i, level in on if level == degree) for degree in range(max(level for _, level in on) + 1)]
    away, before = np.array([0.0, _AROUND * of.down, 0.0]), np.array([of.across, 0.0, 0.0])
    upper = [of.place(span, 0) - before + away, *(of.place(row[0], degree) + away for degree, row in enumerate(rows))]
    lower = [of.place(span, 0) - before - away, *(of.place(row[-1], degree) - away for degree, row in enumerate(rows))]
    end = _AROUND * before
    corners = [*upper, upper[-1] + end, lower[-1] + end, *lower[::-1], upper[0]]
    return Part(f"{WEDGE} {span}", signs.polyline(np.array(corners)))
