"""Numbers of edges or sides that a user lists."""

from .failures import Refusal
from .words import phrase


def numbers_of(text, noun, count=None):
    """The numbers in a text such as "1, 4-6", each once in their order, of a total number where that is given. Raises Refusal."""
    found = set()
    for word in text.replace(',', ' ').split():
        first, dash, last = word.partition('-')
        if not (first.isdecimal() and (last.isdecimal() if dash else not last)):
            raise Refusal("\"{word}\" is not a number of {noun}: numbers such as 1, 4-6 are expected", word=word, noun=phrase(noun))
        low, high = int(first), int(last or first)
        if count is not None and not 1 <= low <= high <= count:
            raise Refusal(*_NONE[noun], count=count, word=word)
        found |= set(range(low, min(high, _MOST) + 1))
    return sorted(found)


_NONE = {
    "an edge": ("there are {count} edges, none of number {word}", "there is {count} edge, none of number {word}"),
    "a side": ("there are {count} sides, none of number {word}", "there is {count} side, none of number {word}"),
}
#: No user means more.
_MOST = 100_000
