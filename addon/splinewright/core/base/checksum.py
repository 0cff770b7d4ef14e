"""A checksum of float32 numbers that is found again, in every bit, where some of them changed: from these alone."""

import numpy as np

#: Pairs of numbers in a block: more at once would leave the cache.
_BLOCK = 4096
_ALL = 2 ** 64 - 1


def of(numbers):
    """Of float32 numbers in their order, below 2^52."""
    return Kept(np.append(numbers, np.float32(0)) if len(numbers) % 2 else numbers).value()


def room(count):
    """An array for a given number of float32 numbers, and for a 0 behind them where it takes one to make pairs of all."""
    return np.zeros(count + count % 2, np.float32)


class Kept:
    """The checksum of an array, made by room(), that others write to, who tell where before they do and when they have."""

    def __init__(self, numbers):
        self._pairs = numbers.view(np.uint64)
        self._total = _sum(self._pairs, _factors(len(self._pairs)))
        self._last = None               # the Places of which the sum is known

    def value(self):
        """of() the numbers."""
        return self._total >> 12

    def places(self, numbers):
        """The Places of numbers, by their places among all, in order."""
        pairs = np.unique(np.asarray(numbers, np.int64) >> 1)
        if len(pairs) and pairs[-1] - pairs[0] + 1 == len(pairs):
            pairs = slice(pairs[0], pairs[-1] + 1)
        return Places(pairs, _factors(len(self._pairs))[pairs])

    def writes(self, places):
        """Numbers at these places will be others. They are read where that was not said of them the last time, too."""
        if self._last is not places:
            self._last, places.sum = places, _sum(self._pairs[places.pairs], places.factors)

    def wrote(self):
        """They are others now."""
        places = self._last
        before, places.sum = places.sum, _sum(self._pairs[places.pairs], places.factors)
        self._total = self._total - before + places.sum & _ALL


class Places:
    """Some pairs of a Kept."""

    def __init__(self, pairs, factors):
        self.pairs, self.factors, self.sum = pairs, factors, 0


def _sum(pairs, factors):
    """Of pairs, with the factors of their places, modulo 2^64.

    A product with an odd number keeps the highest bit that changed and forgets those it would carry to: so high bits, signs
    for example, are laid over low ones before. By 29, not by 32: two numbers of a pair whose signs flip would meet.
    """
    total = 0
    for start in range(0, len(pairs), _BLOCK):
        block = pairs[start:start + _BLOCK]
        mixed = block >> np.uint64(29)
        mixed ^= block
        total += int(np.dot(mixed, factors[start:start + _BLOCK]))
    return total & _ALL


_known = np.empty(0, np.uint64)


def _factors(count):
    """Odd numbers, one for each place, that have nothing to do with one another: splitmix64 of the place."""
    global _known
    if len(_known) < count:
        mixed = np.arange(1, count + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        mixed = (mixed ^ mixed >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ mixed >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
        _known = (mixed ^ mixed >> np.uint64(31)) | np.uint64(1)
    return _known[:count]
