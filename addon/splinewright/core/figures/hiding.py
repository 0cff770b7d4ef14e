"""Which stretches of a piece are seen, where a question that costs much answers for single places."""

import numpy as np

from . import bernstein

#: Places of a piece that are looked at, and halvings to find where it is hidden.
_PLACES, _HALVINGS = 12, 6


def stretches(piece, is_seen):
    """[(points of a part of the piece, whether it is seen)]. is_seen: of a place (3,) of the world."""
    def seen(at):
        x, y, z, w = bernstein.value(piece, [at])[0]
        return w == 0.0 or is_seen(np.array([x, y, z]) / w)
    # Not at the ends, where pieces touch others.
    at = np.concatenate([[0.001], np.arange(1, _PLACES) / _PLACES, [0.999]])
    known = [seen(parameter) for parameter in at]
    ends = [0.0]
    for (low, was), (high, now) in zip(zip(at, known), zip(at[1:], known[1:])):
        if was != now:
            ends.append(_change(seen, low, high, was))
    shown = [known[0]]
    for _ in ends[1:]:
        shown.append(not shown[-1])
    return [(bernstein.part(piece, start, end), each) for start, end, each in zip(ends, [*ends[1:], 1.0], shown)]


def _change(seen, low, high, was):
    """Where between two parameters the answer changes."""
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        if seen(middle) == was:
            low = middle
        else:
            high = middle
    return (low + high) / 2.0
