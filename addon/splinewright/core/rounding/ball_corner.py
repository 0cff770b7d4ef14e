"""A part of a sphere between three great circles, exactly, as a patch that closes to a point in one corner.

Points of a sphere are pairs of complex numbers (spinors) up to a factor; squares of linear ones run along great circles as
arcs of the second degree do, and a bilinear one has all three sides so.
"""

import math
from itertools import product

import numpy as np

from ..base.library import sc

#: Weights below this are raised away, and so high.
_LEAST_WEIGHT, _HIGHEST = 0.02, 8


def net_of(center, radius, a, b, c):
    """(3, 3, 4): homogeneous points in Bernstein form, u from the side a b to the side a c, v from a to the side b c."""
    frame, (north, east) = _frame((a - center) / radius), np.eye(2)
    first = _spinor(frame @ ((b - center) / radius))
    second = _spinor(frame @ ((c - center) / radius))
    second = second * _phase(np.vdot(second, first))
    pole = north * _phase(second[0])
    corners = np.array([[north, first], [pole, second]])
    net = np.zeros((3, 3, 4))
    for (i, j), (k, m) in product(product(range(2), repeat=2), repeat=2):
        net[i + k, j + m] += _between(corners[i, j], corners[k, m]) / (math.comb(2, i + k) * math.comb(2, j + m))
    net[..., :3] = net[..., 3:] * center + radius * (net[..., :3] @ frame)
    return net


def _frame(axis):
    """(3, 3): rows of which the last one is an axis."""
    other = np.eye(3)[np.abs(axis).argmin()]
    first = np.cross(other, axis)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(axis, first), axis])


def _spinor(way):
    angle, turn = math.atan2(math.hypot(way[0], way[1]), way[2]), math.atan2(way[1], way[0])
    return np.array([math.cos(angle / 2), math.sin(angle / 2) * complex(math.cos(turn), math.sin(turn))])


def _phase(number):
    return number / abs(number) if number else 1.0


def _between(p, q):
    """(x, y, z, w) to which two spinors are multiplied."""
    upper, lower = (np.conj(p[i]) * q[i] for i in range(2))
    across, back = np.conj(p[0]) * q[1], np.conj(p[1]) * q[0]
    return np.real([across + back, 1j * (back - across), upper - lower, upper + lower])


def degree_for(net):
    """The least degree with which the weights of a net are above 0; None where they are with none that is taken."""
    return next((degree for degree in range(2, _HIGHEST + 1) if raised(net, degree)[..., 3].min() >= _LEAST_WEIGHT), None)


def raised(net, degree):
    """A net, or a row of 3 points, of a higher degree along each of its axes."""
    for _ in range(degree - 2):
        for axis in range(net.ndim - 1):
            net = np.moveaxis(_raised_once(np.moveaxis(net, axis, 0)), 0, axis)
    return net


def _raised_once(rows):
    count = len(rows)
    shares = (np.arange(1, count) / count).reshape(-1, *[1] * (rows.ndim - 1))
    return np.concatenate([rows[:1], shares * rows[:-1] + (1.0 - shares) * rows[1:], rows[-1:]])


def patch_of(net, a_to_b, b_to_c, a_to_c):
    """The NurbsPatch of a net whose sides have these rows (n, 4) of points with weights, to the last bit."""
    count = len(net)
    points, weights = net[..., :3] / net[..., 3:], net[..., 3].copy()
    for at, row in (((0, slice(None)), a_to_b), ((-1, slice(None)), a_to_c), ((slice(None), -1), b_to_c)):
        points[at], weights[at] = row[:, :3], row[:, 3]
    points[:, 0] = a_to_b[0, :3]
    knots = np.repeat([0.0, 1.0], count)
    return sc.NurbsPatch((count - 1, count - 1), (knots, knots), points, weights)
