"""Measures of tessellations: what holds them together and how far the surface lies from them."""

import numpy as np


def sizes_of(mesh):
    """The number of corners of each face."""
    return np.diff([*mesh.face_starts, len(mesh.corner_vertices)])


def faces_of(mesh):
    """A list of (corner numbers) of each face."""
    return np.split(np.arange(len(mesh.corner_vertices)), mesh.face_starts[1:])


def edge_rows(mesh):
    """(low vertex, high vertex, does the face run from low to high) of the edge that begins at each corner."""
    following = np.arange(1, len(mesh.corner_vertices) + 1)
    following[np.cumsum(sizes_of(mesh)) - 1] = mesh.face_starts
    a, b = mesh.corner_vertices, mesh.corner_vertices[following]
    return np.minimum(a, b), np.maximum(a, b), a < b


def edges_of(mesh):
    """{(low vertex, high vertex): [does a face run from low to high, …]}."""
    found = {}
    for low, high, way in zip(*(row.tolist() for row in edge_rows(mesh))):
        found.setdefault((low, high), []).append(way)
    return found


def counts_of(mesh):
    """(edges with one face, with more than two, of two faces wound against each other)."""
    low, high, way = edge_rows(mesh)
    _, edge, uses = np.unique(low.astype(np.int64) << 32 | high, return_inverse=True, return_counts=True)
    upwards = np.bincount(edge, way)
    return (uses == 1).sum(), (uses > 2).sum(), ((uses == 2) & (upwards != 1)).sum()


def triangles_of(mesh):
    """triangles() of a Tessellation."""
    return triangles(mesh.face_starts, len(mesh.corner_vertices))


def triangles(starts, count):
    """(n, 3) corner numbers, of `count` corners in faces that begin at starts: triangles, and quads cut both ways."""
    sizes = np.diff([*starts, count])
    assert set(sizes) <= {3, 4}
    quads = starts[sizes == 4][:, None]
    return np.concatenate([starts[sizes == 3][:, None] + (0, 1, 2), quads + (0, 1, 2), quads + (0, 2, 3),
                           quads + (1, 2, 3), quads + (1, 3, 0)])


def patch_of_corner(mesh):
    return np.repeat(mesh.face_patches, sizes_of(mesh))


def largest_distance(mesh, patch_set, positions, steps=5):
    """How far points of the surface, sampled densely, lie from the mesh, at most, whichever way its quads are cut."""
    every = triangles_of(mesh)
    quads = int((sizes_of(mesh) == 4).sum())
    whole = len(every) - 4 * quads
    cuts = [every[:whole + 2 * quads], np.concatenate([every[:whole], every[whole + 2 * quads:]])]
    return max(_largest_distance(mesh, triangles, patch_set, positions.astype(float), steps) for triangles in cuts)


def _largest_distance(mesh, triangles, patch_set, positions, steps):
    patches = patch_of_corner(mesh)[triangles[:, 0]]
    weights = np.array([(i, j, steps - i - j) for i in range(steps + 1) for j in range(steps + 1 - i)]) / steps
    uvs = np.einsum('sk,nkx->nsx', weights, mesh.corner_uvs[triangles].astype(float))
    points = np.empty((*uvs.shape[:2], 3))
    for i in np.unique(patches):
        rows, patch = patches == i, patch_set[int(i)]
        (a, b), (c, d) = patch.domain
        u, v = np.clip(a + uvs[rows, :, 0] * (b - a), a, b), np.clip(c + uvs[rows, :, 1] * (d - c), c, d)
        points[rows] = patch.evaluate(u, v)
    corners = positions[mesh.corner_vertices[triangles]]
    own = np.repeat(np.arange(len(triangles)), len(weights))
    points = points.reshape(-1, 3)
    distances = distances_to_triangles(points, corners[own])
    assert np.isfinite(distances).all(), "points or vertices are no numbers"
    # The nearest face may be one beside its own: that is looked for from the farthest point on, until it stays ahead.
    neighbors = _neighbors(mesh.corner_vertices[triangles], len(positions))
    order, largest = np.argsort(-distances), 0.0
    for point in order:
        if distances[point] <= largest:
            break
        others = neighbors(own[point])
        found = distances_to_triangles(np.broadcast_to(points[point], (len(others), 3)), corners[others]).min()
        largest = max(largest, min(found, distances[point]))
    return largest


def _neighbors(vertices, count):
    """A function that gives the triangles in two rings around one."""
    order = np.argsort(vertices.ravel(), kind='stable')
    starts = np.searchsorted(vertices.ravel()[order], np.arange(count + 1))

    def around(corners):
        return np.unique(np.concatenate([order[starts[v]:starts[v + 1]] // 3 for v in np.unique(corners).tolist()]))

    return lambda triangle: around(vertices[around(vertices[triangle])])


def distances_to_triangles(points, corners):
    """(n,): of each point from its triangle (Ericson, Real-Time Collision Detection, 5.1.5)."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    area = np.maximum((normal * normal).sum(1), 1e-300)
    second = (np.cross(points - a, c - a) * normal).sum(1) / area
    third = (np.cross(b - a, points - a) * normal).sum(1) / area
    inside = (second >= 0) & (third >= 0) & (second + third <= 1)
    over = np.abs(((points - a) * normal).sum(1)) / np.sqrt(area)
    beside = np.minimum.reduce([_distances_to_edges(points, *edge) for edge in ((a, b), (b, c), (c, a))])
    return np.where(inside, over, beside)


def _distances_to_edges(points, a, b):
    along = b - a
    share = np.clip(((points - a) * along).sum(1) / np.maximum((along * along).sum(1), 1e-300), 0, 1)
    return np.linalg.norm(points - a - share[:, None] * along, axis=1)


def smallest_angle(mesh, positions):
    """Radians, of all triangles."""
    p = positions[mesh.corner_vertices[triangles_of(mesh)]].astype(float)
    least = np.pi
    for k in range(3):
        a, b = p[:, (k + 1) % 3] - p[:, k], p[:, (k + 2) % 3] - p[:, k]
        least = min(least, np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1)).min())
    return least
