"""Polynomials in Bernstein form from 0 to 1, as rows of coefficients: parts of them, products, and where they are positive."""

from math import comb

import numpy as np

#: Halvings after which a place where a sign changes is known.
_HALVINGS = 50


def part(rows, start, end):
    """The coefficients (n + 1, k) of a polynomial from one parameter to another."""
    after = _split(rows, start)[1] if start > 0.0 else rows
    return _split(after, (end - start) / (1.0 - start))[0] if end < 1.0 else after


def halves(rows):
    return _split(rows, 0.5)


def _split(rows, at):
    """De Casteljau's algorithm: both parts."""
    before, after, level = [rows[0]], [rows[-1]], rows
    while len(level) > 1:
        level = (1.0 - at) * level[:-1] + at * level[1:]
        before.append(level[0])
        after.append(level[-1])
    return np.array(before), np.array(after[::-1])


def value(rows, at):
    """(m, k): values at parameters (m,)."""
    at = np.asarray(at, float)[:, None, None]
    level = np.broadcast_to(rows, (len(at), *rows.shape))
    while level.shape[1] > 1:
        level = (1.0 - at) * level[:, :-1] + at * level[:, 1:]
    return level[:, 0]


def product(first, second):
    """The coefficients of a product of polynomials (n + 1, k) and (m + 1, k), or (m + 1, 1)."""
    n, m = len(first) - 1, len(second) - 1
    found = np.zeros((n + m + 1, max(first.shape[1], second.shape[1])))
    for i, row in enumerate(first):
        for j, other in enumerate(second):
            found[i + j] += comb(n, i) * comb(m, j) / comb(n + m, i + j) * row * other
    return found


def positive(coefficients):
    """[(start, end)]: where a polynomial of coefficients (n + 1,) is above 0."""
    found = []
    for start, end in _positive(np.asarray(coefficients, float)[:, None], 0.0, 1.0, _HALVINGS):
        if found and found[-1][1] == start:
            found[-1][1] = end
        else:
            found.append([start, end])
    return [tuple(ends) for ends in found]


def _positive(rows, start, end, halvings):
    if (rows > 0.0).all():
        yield start, end
    elif halvings and (rows > 0.0).any():
        middle = (start + end) / 2.0
        before, after = halves(rows)
        yield from _positive(before, start, middle, halvings - 1)
        yield from _positive(after, middle, end, halvings - 1)


def common(first, second):
    """What two lists of intervals have in common."""
    both = [(max(a, c), min(b, d)) for a, b in first for c, d in second]
    return [(a, b) for a, b in both if a < b]
