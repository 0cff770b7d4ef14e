"""Numbers of edges or sides that a user lists."""

from .failures import Refusal


def numbers_of(text, noun, count=None):
    """The numbers in a text such as "1, 4-6", each once in their order, of a total number where that is given. Raises Refusal."""
    found = set()
    for word in text.replace(',', ' ').split():
        first, dash, last = word.partition('-')
        if not (first.isdecimal() and (last.isdecimal() if dash else not last)):
            raise Refusal(f"\"{word}\" is not a number of {noun}: numbers such as 1, 4-6 are expected")
        low, high = int(first), int(last or first)
        if count is not None and not 1 <= low <= high <= count:
            of_all = noun.split()[-1]
            are = f"is 1 {of_all}" if count == 1 else f"are {count} {of_all}s"
            raise Refusal(f"there {are}, none of number {word}")
        found |= set(range(low, min(high, _MOST) + 1))
    return sorted(found)


#: No user means more.
_MOST = 100_000
