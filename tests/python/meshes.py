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
    """(n, 3) corner numbers: triangles, and quads cut both ways."""
    sizes = sizes_of(mesh)
    assert set(sizes) <= {3, 4}
    quads = mesh.face_starts[sizes == 4][:, None]
    return np.concatenate([mesh.face_starts[sizes == 3][:, None] + (0, 1, 2), quads + (0, 1, 2), quads + (0, 2, 3),
                           quads + (1, 2, 3), quads + (1, 3, 0)])


def patch_of_corner(mesh):
    return np.repeat(mesh.face_patches, sizes_of(mesh))


def largest_distance(mesh, patch_set, positions, steps=5):
    """How far points of the surface, sampled densely, lie from the triangle of their parameters, at most."""
    triangles, patches = triangles_of(mesh), patch_of_corner(mesh)
    weights = np.array([(i, j, steps - i - j) for i in range(steps + 1) for j in range(steps + 1 - i)]) / steps
    flat = np.einsum('sk,nkx->nsx', weights, positions[mesh.corner_vertices[triangles]])
    uvs = np.einsum('sk,nkx->nsx', weights, mesh.corner_uvs[triangles].astype(float))
    largest = 0.0
    for i in range(len(patch_set)):
        rows = patches[triangles[:, 0]] == i
        if rows.any():
            patch = patch_set[i]
            (a, b), (c, d) = patch.domain
            u, v = np.clip(a + uvs[rows, :, 0] * (b - a), a, b), np.clip(c + uvs[rows, :, 1] * (d - c), c, d)
            largest = max(largest, np.linalg.norm(patch.evaluate(u, v) - flat[rows], axis=-1).max())
    return largest


def smallest_angle(mesh, positions):
    """Radians, of all triangles."""
    p = positions[mesh.corner_vertices[triangles_of(mesh)]].astype(float)
    least = np.pi
    for k in range(3):
        a, b = p[:, (k + 1) % 3] - p[:, k], p[:, (k + 2) % 3] - p[:, k]
        least = min(least, np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1)).min())
    return least
