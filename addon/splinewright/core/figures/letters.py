"""Texts as the outlines of their letters."""

from typing import NamedTuple

from ..base.words import say
from .figure import Area
from .paths import Path

#: How large what stands below the line is, and how far below it: as parts of the size.
_SMALL, _DROP = 0.72, 0.25
#: To the right of and above what is named, as parts of the size.
_OFFSET = 0.43, 0.36


class Letter(NamedTuple):
    """Of size 1, from its origin on the line; y goes up."""

    advance: float
    outlines: tuple                     # of closed Path


def written(text, x, y, size, letters):
    """(the Paths of a text that begins at a place on the page, in mm, where the next would begin). letters: the Letter of a character."""
    found = []
    for character in text:
        letter = letters(character)
        found += [_placed(outline, x, y, size) for outline in letter.outlines]
        x += size * letter.advance
    return found, x


def width(text, size, letters):
    """In mm."""
    return size * sum(letters(character).advance for character in text)


def label(named, place, size, color, letters):
    """The Area of a core.formulas.labels.Label beside a place on the page."""
    x, y = place[0] + _OFFSET[0] * size, place[1] - _OFFSET[1] * size
    found = []
    for text, is_below in named.runs:
        paths, x = written(say(text), x, y + (_DROP * size if is_below else 0.0), (_SMALL if is_below else 1.0) * size, letters)
        found += paths
    return Area(tuple(found), color, "".join(say(text) for text, _ in named.runs))


def _placed(outline, x, y, size):
    def put(points):
        return points * (size, -size) + (x, y)
    return Path(put(outline.start), tuple(map(put, outline.steps)), outline.closed)
