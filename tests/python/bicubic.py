"""Bicubic Bezier patches by their control points alone, in extended precision and without the library.

A patch is a (4, 4, 3) array of longdouble, rows along u.
"""

import collections

import numpy as np

Real = np.longdouble
HALVES = np.array([[(8, 0, 0, 0), (4, 4, 0, 0), (2, 4, 2, 0), (1, 3, 3, 1)],
                   [(1, 3, 3, 1), (0, 2, 4, 2), (0, 0, 4, 4), (0, 0, 0, 8)]], Real) / 8


def gauss_legendre(count):
    """Nodes and weights on [0, 1], by Newton's method on Legendre's polynomial."""
    x = np.cos(Real(np.pi) * (np.arange(1, count + 1, dtype=Real) - Real(0.25)) / (count + Real(0.5)))
    for _ in range(8):
        before, value = np.ones_like(x), x
        for n in range(2, count + 1):
            before, value = value, ((2 * n - 1) * x * value - (n - 1) * before) / n
        slope = count * (x * value - before) / (x * x - 1)
        x = x - value / slope
    return (1 + x) / 2, 1 / ((1 - x * x) * slope * slope)


def bernstein(t):
    """(n, 4) values and (n, 4) derivatives of the four cubics."""
    s, zero = 1 - t, 0 * t
    squares = np.stack([zero, s * s, 2 * s * t, t * t, zero], axis=1)
    return np.stack([s**3, 3 * s * s * t, 3 * s * t * t, t**3], axis=1), 3 * (squares[:, :-1] - squares[:, 1:])


def area(patch, parts, count):
    """By `count` nodes on each of parts x parts squares."""
    nodes, weights = gauss_legendre(count)
    at = ((np.arange(parts, dtype=Real)[:, None] + nodes) / parts).ravel()
    weights = np.tile(weights / parts, parts)
    value, slope = bernstein(at)
    along_u = np.einsum('pi,qj,ijx->pqx', slope, value, patch, optimize=True)
    along_v = np.einsum('pi,qj,ijx->pqx', value, slope, patch, optimize=True)
    density = np.sqrt((np.cross(along_u, along_v)**2).sum(axis=-1))
    return weights @ density @ weights


def largest(patches, axis, slack):
    """The largest coordinate, at most `slack` too small, and its (patch, u, v).

    A patch lies in the hull of its control points and passes through its corners: halves that
    cannot hold a larger value are dropped.
    """
    best, place = -np.inf, None
    waiting = [(k, Real(0), Real(0), Real(1), patch[..., axis]) for k, patch in enumerate(patches)]
    while waiting:
        for k, u, v, width, net in waiting:
            for i, j in ((0, 0), (0, 3), (3, 0), (3, 3)):
                if net[i, j] > best:
                    best, place = net[i, j], (k, u + width * (i // 3), v + width * (j // 3))
        waiting = [(k, u + a * width / 2, v + b * width / 2, width / 2, HALVES[a] @ net @ HALVES[b].T)
                   for k, u, v, width, net in waiting if net.max() > best + slack for a in (0, 1) for b in (0, 1)]
    return best, place


def box(patches, slack=Real(1e-17)):
    """[(value, place)] of the least x, y, z and the largest ones."""
    found = [largest([-patch for patch in patches], axis, slack) for axis in range(3)]
    return [(-value, place) for value, place in found], [largest(patches, axis, slack) for axis in range(3)]


def sides(patches):
    """{control points of a side, whichever way: how many patches have it}, and how many sides are one point."""
    counts, poles = collections.Counter(), 0
    for patch in patches:
        for side in (patch[0], patch[-1], patch[:, 0], patch[:, -1]):
            row = tuple(map(tuple, side.astype(float)))
            if len(set(row)) == 1:
                poles += 1
            else:
                counts[min(row, row[::-1])] += 1
    return counts, poles


def loops(edges):
    """How many closed chains edges make, each a row of points that is joined by its ends; None if one is open."""
    left, count = list(edges), 0
    while left:
        chain = left.pop()
        first, end = chain[0], chain[-1]
        while end != first:
            following = [edge for edge in left if end in (edge[0], edge[-1])]
            if len(following) != 1:
                return None
            left.remove(following[0])
            end = following[0][-1] if following[0][0] == end else following[0][0]
        count += 1
    return count
