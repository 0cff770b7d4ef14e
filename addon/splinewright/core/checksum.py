"""A checksum of float32 numbers that is known anew, in every bit, where some of them changed: from these alone."""

import numpy as np

#: Pairs of numbers in a block, of which the sum is kept.
_BLOCK = 4096


def of(numbers):
    """Of float32 numbers in their order, below 2^52."""
    return Kept(np.append(numbers, np.float32(0)) if len(numbers) % 2 else numbers).value()


def room(count):
    """An array for so many float32 numbers, and for a 0 behind them where it takes one to make pairs of all."""
    return np.zeros(count + count % 2, np.float32)


class Kept:
    """The checksum of an array, made by room(), that others write to, who tell where."""

    def __init__(self, numbers):
        self._pairs = numbers.view(np.uint64)
        self._sums = np.zeros(-(-len(self._pairs) // _BLOCK), np.uint64)
        self._add(0, len(self._sums))

    def value(self):
        """of() the numbers."""
        return int(self._sums.sum(dtype=np.uint64) >> np.uint64(12))

    def wrote(self, first, end):
        """The numbers from `first` to `end` may be others now."""
        self._add(first // (2 * _BLOCK), -(-end // (2 * _BLOCK)))

    def _add(self, first, end):
        for block in range(first, end):
            start = block * _BLOCK
            self._sums[block] = _sum(self._pairs[start:start + _BLOCK], start)


def _sum(pairs, first):
    """Of pairs of which the one at hand is that at `first`, modulo 2^64.

    A product with an odd number keeps the highest bit that changed and forgets those it would carry to: so high bits, signs
    say, are laid over low ones before. By 29, not by 32: two numbers of a pair whose signs flip would meet.
    """
    mixed = pairs >> np.uint64(29)
    mixed ^= pairs
    return np.dot(mixed, _factors(first + len(pairs))[first:])


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
