"""Convex hulls of few points in space, of any rank: polyhedra, plane polygons, segments and points; and what two have in common.

Points within a millionth of the size of a plane are flat, as Blender moves points in single precision.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal

#: As a part of the size.
FLAT = 1e-6
#: So often a supporting plane is mended until no point is outside.
_MENDINGS = 8


class Hull(NamedTuple):
    """rank: 3 for a polyhedron, 2 for a plane polygon, 1 for a segment, 0 for a point. It is where normals @ x <= offsets."""

    rank: int
    corners: np.ndarray                 # (n, 3)
    faces: tuple                        # of rank 2 and 3: numbers of corners in a turn
    normals: np.ndarray                 # (m, 3)
    offsets: np.ndarray                 # (m,)

    @property
    def edges(self):
        """Pairs of numbers of corners, each once, the smaller one first."""
        if self.rank < 2:
            return [(0, 1)] if self.rank == 1 else []
        return sorted({(min(pair), max(pair)) for face in self.faces for pair in zip(face, face[1:] + face[:1])})


def hull(points, near=0.0):
    """The Hull of points (n, 3), one at least, that are exact within `near`."""
    points = np.asarray(points, dtype=np.float64)
    near = max(near, FLAT * np.ptp(points, axis=0).max())
    points = _apart(points, near)
    rank, axes = _frame(points, near)
    if rank == 3:
        return _polyhedron(points, axes, near)
    flat = [side * axis for axis in axes[rank:] for side in (1.0, -1.0)]
    if rank == 2:
        turn = _polygon(points @ axes[:2].T, near)
        corners = points[turn]
        along = np.roll(corners, -1, axis=0) - corners
        outward = np.cross(along, axes[2])
        flat = [*flat, *(outward / np.linalg.norm(outward, axis=1)[:, None])]
        return _hull(2, corners, (tuple(range(len(turn))),), flat, points)
    if rank == 1:
        along = points @ axes[0]
        return _hull(1, points[[along.argmin(), along.argmax()]], (), [*flat, axes[0], -axes[0]], points)
    return _hull(0, points[:1], (), flat, points)


def intersection(one, other):
    """The Hull of what two Hulls have in common; None where that is nothing."""
    if one.rank > other.rank:
        one, other = other, one
    near = FLAT * max(np.ptp(one.corners, axis=0).max(), np.ptp(other.corners, axis=0).max())
    polygons = [one.corners[list(face)] for face in one.faces] or [one.corners]
    for normal, offset in zip(other.normals, other.offsets):
        polygons = _cut(polygons, normal, offset, near, one.rank == 3)
        if not polygons:
            return None
    return hull(np.concatenate(polygons), 2.0 * near)


def _hull(rank, corners, faces, normals, points):
    normals = np.array(normals)
    return Hull(rank, corners, faces, normals, (points @ normals.T).max(axis=0))


def _cut(polygons, normal, offset, near, is_solid):
    """The parts of the polygons of a hull on one side of a plane, with the polygon in that where the hull is solid."""
    outside = [polygon @ normal - offset for polygon in polygons]
    if all((each <= near).all() for each in outside):
        return polygons
    left = [found for polygon, each in zip(polygons, outside) if len(found := _clipped(polygon, each, near))]
    if is_solid and left:
        points = np.concatenate(left)
        on_plane = points[points @ normal - offset >= -near]
        if len(on_plane):
            left.append(_around(_apart(on_plane, near), normal))
    return left


def _clipped(polygon, outside, near):
    """The part of a convex polygon, a segment or a point that is not outside."""
    found = []
    for i, here in enumerate(outside):
        if here <= near:
            found.append(polygon[i])
        following = (i + 1) % len(outside)
        low, high = sorted((here, outside[following]))
        if low < 0.0 and high > near:
            found.append(polygon[i] + here / (here - outside[following]) * (polygon[following] - polygon[i]))
    return np.array(found).reshape(-1, 3)


def _around(points, normal):
    """Points of a plane in the order in which they lie around their middle."""
    away = points - points.mean(axis=0)
    first = away[np.linalg.norm(away, axis=1).argmax()]
    return points[np.argsort(np.arctan2(away @ np.cross(normal, first), away @ first), kind='stable')]


def _apart(points, near):
    """Points of which none lies near to one before."""
    kept = np.empty((0, 3))
    for point in np.unique(points, axis=0):
        if not (np.abs(kept - point).max(axis=1) <= near).any():
            kept = np.vstack([kept, point])
    return kept


def _frame(points, near):
    """(rank, (3, 3) axes at right angles): points differ along the first `rank` of them."""
    if len(points) == 1:
        return 0, np.eye(3)
    start = points[np.linalg.norm(points - points.mean(axis=0), axis=1).argmax()]
    away, axes = points - start, []
    while len(axes) < 3:
        lengths = np.linalg.norm(away, axis=1)
        if lengths.max() <= near:
            break
        axis = away[lengths.argmax()] / lengths.max()
        for known in axes:
            axis = axis - (axis @ known) * known
        axes.append(axis / np.linalg.norm(axis))
        away = away - np.outer(away @ axes[-1], axes[-1])
    return len(axes), _completed(axes)


def _completed(axes):
    axes = list(axes)
    if len(axes) == 1:
        other = np.cross(axes[0], np.eye(3)[np.abs(axes[0]).argmin()])
        axes.append(other / np.linalg.norm(other))
    if len(axes) == 2:
        axes.append(np.cross(*axes))
    return np.array(axes)


def _polygon(flat, near):
    """Numbers of the corners of the hull of plane points that are no line, counterclockwise (Andrew 1979)."""
    order = np.lexsort((flat[:, 1], flat[:, 0])).tolist()

    def chain(numbers):
        found = []
        for number in numbers:
            while len(found) > 1 and _turn(flat[found[-2]], flat[found[-1]], flat[number]) <= 0.0:
                found.pop()
            found.append(number)
        return found[:-1]
    return _straightened(flat, chain(order) + chain(order[::-1]), near)


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _straightened(flat, turn, near):
    """Without corners that lie near to a side of those that are left; three are left at least."""
    first = np.linalg.norm(flat[turn] - flat[turn].mean(axis=0), axis=1).argmax()
    turn = [*turn[first:], *turn[:first]]
    kept, dropped = [turn[0]], []
    for number, following in zip(turn[1:], [*turn[2:], turn[0]]):
        start, end = flat[kept[-1]], flat[following]
        away = flat[[*dropped, number]] - start
        along = (end - start) / max(np.linalg.norm(end - start), np.finfo(float).tiny)
        if (np.abs(along[0] * away[:, 1] - along[1] * away[:, 0]) <= near).all():
            dropped.append(number)
        else:
            kept.append(number)
            dropped = []
    return kept if len(kept) > 2 else turn


# Polyhedra ----------------------------------------------------------------------------------------


def _polyhedron(points, axes, near):
    """Face by face, each by turning the plane of its neighbor around their edge until it meets points (Chand and Kapur 1970)."""
    normal, members = _first_plane(points, axes, near)
    faces, edges, waiting = {}, set(), [(normal, members)]
    while waiting:
        normal, members = waiting.pop()
        turn = _face(points, normal, members, near)
        if frozenset(turn) in faces:
            continue
        faces[frozenset(turn)] = (turn, normal)
        if len(faces) > 4 * len(points):
            raise _hidden(points)
        edges |= set(zip(turn, turn[1:] + turn[:1]))
        for start, end in zip(turn, turn[1:] + turn[:1]):
            if (end, start) not in edges:
                edges.add((end, start))
                waiting.append(_next_plane(points, start, end, normal, near))
    used = sorted({number for turn, _ in faces.values() for number in turn})
    renumbered = {number: i for i, number in enumerate(used)}
    turns = tuple(tuple(renumbered[number] for number in turn) for turn, _ in faces.values())
    return _hull(3, points[used], turns, [normal for _, normal in faces.values()], points)


def _hidden(points):
    return Refusal("the hull of {count} points was given up: rounding hides which of them are its corners", count=len(points))


def _first_plane(points, axes, near):
    """(normal, members) of a face: the plane through the longest side of the hull's shadow, or its neighbor where that has an edge alone."""
    turn = _polygon(points @ axes[:2].T, near)
    shadow = (points @ axes[:2].T)[turn]
    sides = np.roll(shadow, -1, axis=0) - shadow
    longest = np.linalg.norm(sides, axis=1).argmax()
    side = sides[longest] / np.linalg.norm(sides[longest])
    normal = side[1] * axes[0] - side[0] * axes[1]
    start, end = turn[longest], turn[(longest + 1) % len(turn)]
    members = np.flatnonzero(np.abs((points - points[start]) @ normal) <= near)
    rank, within = _frame(points[members], near)
    if rank == 2:
        return normal, members
    along = points[members] @ within[0]
    return _next_plane(points, members[along.argmin()], members[along.argmax()], normal, near)


def _next_plane(points, start, end, normal, near):
    """(normal, members) of the face beyond an edge of one that lies to the left of it, seen against that one's normal."""
    along = points[end] - points[start]
    along /= np.linalg.norm(along)
    away = points - points[start]
    inward = np.cross(normal, along)
    inward /= np.linalg.norm(inward)
    across, depth = away @ inward, -(away @ normal)
    below = np.flatnonzero(depth > near)
    chosen = below[(across[below] / depth[below]).argmin()] if len(below) else int(depth.argmax())
    if not np.hypot(across[chosen], depth[chosen]) > 0.0:
        raise _hidden(points)
    for _ in range(_MENDINGS):
        toward = np.array([across[chosen], depth[chosen]]) / np.hypot(across[chosen], depth[chosen])
        outside = toward[0] * depth - toward[1] * across
        members = np.flatnonzero(np.abs(outside) <= 2.0 * near)
        worst = int(outside.argmax())
        if outside[worst] > 2.0 * near:
            chosen = worst
            continue
        farthest = members[np.hypot(across[members], depth[members]).argmax()]
        if farthest == chosen or np.hypot(across[farthest], depth[farthest]) <= np.hypot(across[chosen], depth[chosen]):
            break
        chosen = farthest
    return -toward[1] * inward - toward[0] * normal, members


def _face(points, normal, members, near):
    """Numbers of the corners of a face, counterclockwise about its normal."""
    axis = np.eye(3)[np.abs(normal).argmin()]
    one = np.cross(axis, normal)
    one /= np.linalg.norm(one)
    flat = points[members] @ np.stack([one, np.cross(normal, one)]).T
    return [int(members[i]) for i in _polygon(flat, near)]
