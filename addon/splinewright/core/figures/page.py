"""From the world to a page, in millimeters from its upper left corner; everything is homogeneous, so that perspective is exact."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal

#: Rows of what lies on a page: x and y times the depth, and the depth.
_FLAT = [0, 1, 3]


class Page(NamedTuple):
    """How the world is seen on a page of a size in mm."""

    matrix: np.ndarray                  # (4, 4): (x, y, z, w) of the world to (x W, y W, depth W, W)
    width: float
    height: float
    near: float = 0.0                   # how far before the eye a view begins, in units of W; 0 where lines of sight are parallel

    @property
    def has_perspective(self):
        return bool(self.matrix[3, :3].any())


def page(clip, width, shape, near):
    """The Page of a view. clip: its matrix, to a square from -1 to 1; shape: its height by its width. Raises Refusal where that is no view."""
    if not np.isfinite(clip).all() or not shape > 0.0 or abs(np.linalg.det(clip)) == 0.0:
        raise Refusal("the view has no size")
    height = width * shape
    to_page = np.array([[width / 2, 0, 0, width / 2], [0, -height / 2, 0, height / 2], [0, 0, 1, 0], [0, 0, 0, 1]])
    seen = Page(to_page @ clip, width, height)
    return seen._replace(near=near) if seen.has_perspective else seen


def around(points, turn, width, height, margin):
    """The Page of a size on which points (n, 3) lie within a margin, seen along parallel lines. turn: (3, 3), its rows point to the right,
    up, and to the eye."""
    seen = points @ turn.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    room = np.array([width, height]) - 2.0 * margin
    extent = np.maximum(high - low, 1e-9 * (float(np.abs(seen).max()) or 1.0))
    scale = float((room / extent[:2]).min())
    middle = (low + high) / 2.0
    matrix = np.eye(4)
    matrix[0, :3], matrix[1, :3], matrix[2, :3] = scale * turn[0], -scale * turn[1], -turn[2]
    matrix[0, 3], matrix[1, 3] = width / 2 - scale * middle[0], height / 2 + scale * middle[1]
    return Page(matrix, width, height)


def flat(points, matrix):
    """(n, 3): homogeneous points (n, 4) on the page of a matrix."""
    return points @ matrix[_FLAT].T


def places(points, seen):
    """(n, 2): where points (n, 3) of the world lie on a Page, nan behind the eye."""
    x, y, depth = flat(np.column_stack([points, np.ones(len(points))]), seen.matrix).T
    depth = np.where(depth > seen.near, depth, np.nan)
    return np.column_stack([x / depth, y / depth])


def eye(seen):
    """(x, y, z, 1) of the eye, or (x, y, z, 0): the unit vector that leads to it."""
    found = np.linalg.svd(seen.matrix[_FLAT])[2][-1]
    if seen.has_perspective:
        return found / found[3]
    found = np.append(found[:3] / np.linalg.norm(found[:3]), 0.0)
    return found if seen.matrix[2] @ found < 0.0 else -found


def unit(seen, point):
    """How many mm a unit of the world across the line of sight is at a point (3,) of it."""
    x, _, depth = flat(np.append(point, 1.0)[None], seen.matrix)[0]
    across = seen.matrix[0, :3] - x / depth * seen.matrix[3, :3]
    return float(np.linalg.norm(across) / depth)
