"""Nearest points on the pieces of a shape."""

import numpy as np

#: Points between two steps of a progress bar.
PART = 20_000


def feet(pieces, points, told=lambda done: None):
    """((n, 3) nearest points on any of the curves or patches, (n,) distances). told: called with how many are done."""
    found, distances = np.empty_like(points), np.full(len(points), np.inf)
    for first in range(0, len(points), PART):
        part = slice(first, first + PART)
        for piece in pieces:
            nearest = piece.nearest(points[part])
            is_nearer = nearest.distances < distances[part]
            found[part][is_nearer] = nearest.points[is_nearer]
            distances[part][is_nearer] = nearest.distances[is_nearer]
        told(min(first + PART, len(points)))
    return found, distances
