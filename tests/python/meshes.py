"""Measures of tessellations: what holds them together and how far the surface lies from them."""

import numpy as np


def faces_of(mesh):
    """A list of (corner numbers) of each face."""
    starts = [*mesh.face_starts, len(mesh.corner_vertices)]
    return [np.arange(a, b) for a, b in zip(starts, starts[1:])]


def edges_of(mesh):
    """{(low vertex, high vertex): [does a face run from low to high, …]}."""
    found = {}
    for corners in faces_of(mesh):
        around = mesh.corner_vertices[corners]
        for a, b in zip(around, np.roll(around, -1)):
            found.setdefault((min(a, b), max(a, b)), []).append(bool(a < b))
    return found


def counts_of(mesh):
    """(edges with one face, with more than two, of two faces wound against each other)."""
    edges = edges_of(mesh).values()
    return (sum(len(e) == 1 for e in edges), sum(len(e) > 2 for e in edges),
            sum(len(e) == 2 and e[0] == e[1] for e in edges))


def triangles_of(mesh):
    """(n, 3) corner numbers: each face cut from its first corner, quads from the second, too."""
    found = []
    for corners in faces_of(mesh):
        for turn in range(2 if len(corners) == 4 else 1):
            around = np.roll(corners, -turn)
            found += [(around[0], around[k], around[k + 1]) for k in range(1, len(around) - 1)]
    return np.array(found)


def patch_of_corner(mesh):
    return np.repeat(mesh.face_patches, np.diff([*mesh.face_starts, len(mesh.corner_vertices)]))


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
