"""The tips of sharp corners of offsets of polygons, by hand."""

import numpy as np

LONGEST = 4.0


def cross(a, b):
    """Of vectors (..., 2): how much the second is to the left of the first."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def tips(polygon, distance, is_closed=True):
    """Faces (n, 4, 2) from the corners of a polygon (n, 2) to where sides of its offset, to the right, meet in sharp corners."""
    found = []
    corners = slice(None) if is_closed else slice(1, -1)
    for before, here, behind in zip(*(np.roll(polygon, k, 0)[corners] for k in (1, 0, -1))):
        a, b = ((q - p) / np.linalg.norm(q - p) for p, q in ((before, here), (here, behind)))
        turn = np.arctan2(cross(a, b), a @ b)
        if turn * distance > 0 and 1.0 < LONGEST * np.cos(0.5 * turn):
            across = distance * np.array([a[1], -a[0]])
            along = distance * np.array([b[1], -b[0]])
            found.append([here, here + across, here + across + abs(distance * np.tan(0.5 * turn)) * a, here + along])
    return np.array(found).reshape(-1, 4, 2)


def is_in_face(face, points):
    """Whether points (n, 2) are inside of a convex face (4, 2)."""
    turns = [cross(q - p, points - p) for p, q in zip(face, np.roll(face, -1, 0))]
    return np.all(np.array(turns) > 0, axis=0) | np.all(np.array(turns) < 0, axis=0)


def sees(polygon, corner, points, is_closed=True):
    """Whether no side of the polygon, but those at the corner, stands between it and the points."""
    free = np.ones(len(points), bool)
    for p, q in zip(polygon, np.roll(polygon, -1, 0) if is_closed else polygon[1:]):
        if (p == corner).all() or (q == corner).all():
            continue
        sides = cross(q - p, corner - p) * cross(q - p, points - p)
        ends = cross(points - corner, p - corner) * cross(points - corner, q - corner)
        free &= ~((sides < 0) & (ends < 0))
    return free


def are_connected(polygon, face, points):
    """Whether a way inside of a face leads from its corner to each of the points without crossing the polygon: one by its vertices."""
    nodes = [face[0] + 1e-7 * (face[2] - face[0])]
    for before, here, behind in zip(*(np.roll(polygon, k, 0) for k in (1, 0, -1))):
        a, b = ((q - p) / np.linalg.norm(q - p) for p, q in ((before, here), (here, behind)))
        beside = a - b + 1e-3 * np.array([-a[1], a[0]])
        nodes += [here + sign * 1e-7 * np.linalg.norm(face[2] - face[0]) * beside / np.linalg.norm(beside) for sign in (-1, 1)]
    nodes = np.array(nodes)
    nodes = np.concatenate([nodes[:1], nodes[1:][is_in_face(face, nodes[1:])]])
    reached, waiting = {0}, [0]
    while waiting:
        i = waiting.pop()
        for j in np.flatnonzero(sees(polygon, nodes[i], nodes)):
            if j not in reached:
                reached.add(j)
                waiting.append(j)
    return np.any([sees(polygon, nodes[i], points) for i in reached], axis=0)


def are_under(polygon, distance, points, is_closed=True):
    """Whether points (n, 2) are under the tip of a corner, on the side of the polygon where it is."""
    found = np.zeros(len(points), bool)
    for face in tips(polygon, distance, is_closed):
        within = is_in_face(face, points)
        seen = within.copy()
        seen[within] = sees(polygon, face[0], points[within], is_closed)
        hidden = within & ~seen
        if is_closed and hidden.any():
            seen[hidden] = are_connected(polygon, face, points[hidden])
        found |= seen
    return found
