"""Points that were put onto others: they take their digits, which single precision does not hold."""

import numpy as np

_EPSILON = float(np.finfo(np.float32).eps)
#: Of the largest coordinate: Blender puts a point onto another by adding the way there, in single precision.
_NEAR = 4 * _EPSILON
#: A point that comes from nearer than this many times that was only moved a little.
_FROM = 1000
#: Along it points of grids are apart.
_SLANT = np.array([0.269, 0.535, 0.801])
#: Of many points in one place each is compared with this number of others.
_MOST_NEIGHBORS = 8


class Order:
    """Places, sorted along an axis."""

    def __init__(self, places):
        along = places @ _SLANT
        self.sorted = np.argsort(along, kind='stable')
        self.along = along[self.sorted]


def targets(before, now, moved, order):
    """Pairs (point, onto) of numbers: each moved point that was put onto another, and the first of those that stayed, or else of
    those that moved. before, now: the places of all points; order: the Order of `before`."""
    with np.errstate(invalid='ignore', over='ignore'):
        own = Order(now[moved])
        points = moved[own.sorted]
        radii = _NEAR * np.maximum(np.abs(now[points]), np.abs(before[points])).max(1)
        on_moved = _put(before, now, radii, points, *_pairs_among(own.along, 2 * radii), points)
        on_others = {}
        if len(moved) < len(now):
            i, j = _pairs(own.along, 2 * radii, order.along)
            stays = ~np.isin(order.sorted[j], moved)
            on_others = _put(before, now, radii, points, i[stays], j[stays], order.sorted, True)
    found = {**on_moved, **on_others}
    return sorted(found.items(), key=lambda pair: (pair[1] in found, pair[0]))


def _pairs(along, reach, others):
    """(i, j): the numbers of those that are within reach[i] of each other along the axis."""
    first = np.searchsorted(others, along - reach, 'left')
    counts = np.minimum(np.searchsorted(others, along + reach, 'right') - first, _MOST_NEIGHBORS)
    i = np.repeat(np.arange(len(along)), counts)
    return i, np.arange(len(i)) + np.repeat(first - np.cumsum(counts) + counts, counts)


def _pairs_among(along, reach):
    """_pairs() of some with themselves, each pair in both orders."""
    found = [np.empty((2, 0), np.int64)]
    for step in range(1, min(_MOST_NEIGHBORS, len(along))):
        i = np.flatnonzero(along[step:] - along[:-step] <= np.maximum(reach[step:], reach[:-step]))
        if not len(i):
            break
        found += [(i, i + step), (i + step, i)]
    return np.concatenate(found, axis=1)


def _put(before, now, radii, points, i, j, others, are_equal=False):
    """{point: the first one onto which it was put}, of points[i] and others[j]. are_equal: those in the same place, too."""
    one, other = points[i], others[j]
    ways, far = np.abs(now[one] - now[other]).max(1, initial=0.0), np.abs(before[one] - before[other]).max(1, initial=0.0)
    are_put = (ways <= radii[i]) & (far > _FROM * radii[i]) & (ways > 0.0)
    are_put = are_put | (ways == 0.0) if are_equal else are_put & (other < one)
    found = {}
    for point, onto in zip(one[are_put].tolist(), other[are_put].tolist()):
        found[point] = min(onto, found.get(point, onto))
    return found
